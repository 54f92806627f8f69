"""Where people settle, the roads between the settlements and the streets inside them."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from shapely.geometry import LineString, Point
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from . import shapes

# kind: how many, radius (m), nearest distance to other settlements' rims (m), width of its roads (m)
SETTLEMENT_KINDS = {
    "town": (1, 400.0, 0.0, 9.0),
    "village": (4, 230.0, 170.0, 7.5),
    "hamlet": (11, 105.0, 130.0, 5.5),
    "farm": (20, 50.0, 130.0, 4.5),
}
EXITS = 9  # roads that leave the map
KEPT_BRIDGES = 5
STREET_WIDTH_M = 5.5
STREET_SPACING_M = {"town": (55.0, 85.0), "village": (60.0, 105.0), "hamlet": (60.0, 110.0)}
STREET_DEPTH = {"town": 5, "village": 3, "hamlet": 1}
BETWEEN_STREETS_M = 46.0  # two rows of houses with their gardens fit between


@dataclass(frozen=True)
class Settlement:
    """A place people live in: kind as in SETTLEMENT_KINDS, center (x, y) and radius in meters."""

    kind: str
    center_xy: tuple[float, float]
    radius: float


@dataclass(frozen=True)
class Road:
    """A center line and the width of the surface, in meters."""

    line: LineString
    width: float

    @property
    def surface(self) -> BaseGeometry:
        """The ground that it covers."""
        return self.line.buffer(self.width / 2, 3)


def settle(rng: np.random.Generator, size_xy: tuple[float, float], river_line: LineString) -> list[Settlement]:
    """Settlements, largest first, that keep their distance from each other and from the river."""
    found: list[Settlement] = []
    for kind, (count, radius, gap, _) in SETTLEMENT_KINDS.items():
        for _ in range(count * 400):
            if sum(s.kind == kind for s in found) == count:
                break
            size = radius * rng.uniform(0.85, 1.15)
            margin = 0.5 * size + 40
            if kind == "town":
                spot = rng.uniform(np.multiply(size_xy, (0.33, 0.4)), np.multiply(size_xy, (0.67, 0.75)))
            else:
                spot = rng.uniform((margin, margin), np.subtract(size_xy, margin))
            if not 0.55 * size + 20 < Point(spot).distance(river_line) < (0.8 * size if kind == "town" else 1e9):
                continue
            if all(np.hypot(*np.subtract(spot, s.center_xy)) > size + s.radius + gap for s in found):
                found.append(Settlement(kind, tuple(spot), size))
    return found


def connect(
    rng: np.random.Generator, settlements: list[Settlement], size_xy: tuple[float, float], river_line: LineString
) -> list[Road]:
    """Roads between neighboring settlements (their Gabriel graph, with few bridges) and out of the map."""
    width, height = size_xy
    ghosts = []
    for k in range(EXITS):  # neighbors beyond the rim give the roads somewhere to go
        angle = 2 * np.pi * (k + rng.uniform(0.2, 0.8)) / EXITS
        ghosts.append((width / 2 + 0.78 * width * np.cos(angle), height / 2 + 0.78 * height * np.sin(angle)))
    nodes = np.array([s.center_xy for s in settlements] + ghosts)
    widths = [SETTLEMENT_KINDS[s.kind][3] for s in settlements] + [9.0] * len(ghosts)
    roads, bridges = [], 0
    for a, b in gabriel_edges(nodes):
        if a >= len(settlements):  # both beyond the rim
            continue
        line = shapes.wobbly_line(rng, nodes[a], nodes[b], 0.035)
        crosses = line.intersects(river_line)
        if crosses and (bridges >= KEPT_BRIDGES or line.intersection(river_line).geom_type != "Point"):
            continue
        bridges += crosses
        roads.append(Road(line, min(widths[a], widths[b])))
    return roads


def gabriel_edges(nodes_xy: np.ndarray) -> list[tuple[int, int]]:
    """Pairs (a < b) of nodes (n, 2) with no other node in the circle over them."""
    squared = ((nodes_xy[:, None] - nodes_xy[None]) ** 2).sum(axis=2)
    pairs = []
    for a in range(len(nodes_xy)):
        for b in range(a + 1, len(nodes_xy)):
            others = squared[a] + squared[b]
            others[[a, b]] = np.inf
            if others.min() >= squared[a, b]:
                pairs.append((a, b))
    return pairs


def streets_of(rng: np.random.Generator, place: Settlement, roads: list[Road], blocked: BaseGeometry) -> list[Road]:
    """Through roads inside a settlement first, then side streets that branch from streets already there."""
    rim = Point(place.center_xy).buffer(place.radius)
    streets = [Road(part, road.width) for road in roads for part in _lines(road.line.intersection(rim))]
    if place.kind not in STREET_DEPTH:
        return streets
    generation = streets
    for _ in range(STREET_DEPTH[place.kind]):
        grown: list[Road] = []
        for street in generation:
            for branch in branches(rng, street.line, STREET_SPACING_M[place.kind], place.radius):
                part = branch.intersection(rim)
                if part.geom_type != "LineString" or part.length < 65 or part.intersects(blocked):
                    continue
                first, *others = shapes.corners_xy(part)
                beyond = LineString(others).difference(Point(first).buffer(BETWEEN_STREETS_M + 8))
                if not beyond.is_empty and all(beyond.distance(s.line) > BETWEEN_STREETS_M for s in streets + grown):
                    grown.append(Road(part, STREET_WIDTH_M))
        streets, generation = streets + grown, grown
    return streets


def branches(
    rng: np.random.Generator, line: LineString, spacing: tuple[float, float], radius: float
) -> Iterator[LineString]:
    """Side streets of a street: at random intervals, to either side, roughly at right angles."""
    at = rng.uniform(25, spacing[1])
    while at < line.length - 15:
        here, ahead = shapes.point_xy(line.interpolate(at)), shapes.point_xy(line.interpolate(at + 5))
        for side in (-1, 1):
            heading = np.arctan2(*(ahead - here)[::-1]) + side * np.pi / 2 + rng.normal(0, 0.13)
            length = rng.uniform(0.3, 0.85) * radius
            yield shapes.wobbly_line(rng, here, here + length * np.array([np.cos(heading), np.sin(heading)]), 0.03)
        at += rng.uniform(*spacing)


def surface_of(roads: list[Road]) -> BaseGeometry:
    """All road surfaces as one geometry."""
    return unary_union([road.surface for road in roads])


def _lines(geometry: BaseGeometry) -> list[LineString]:
    return [g for g in getattr(geometry, "geoms", [geometry]) if g.geom_type == "LineString" and g.length > 10]
