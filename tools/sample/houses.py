"""Buildings: footprints, and their places along streets and around farmyards."""

import numpy as np
import numpy.typing as npt
from shapely.affinity import translate
from shapely.geometry import LineString, Polygon
from shapely.ops import unary_union

from . import shapes
from .roads import Road, Settlement
from .scatter import Ground

CLEARANCE_M = 3.2  # keeps neighbors apart on a label map of 1 m pixels
CORE = 0.42  # share of the town's radius with closed rows of houses
# kind of settlement: shares of (house, L-shaped house, row, barn, hall)
MIX = {
    "core": (0.15, 0.15, 0.60, 0.0, 0.10),
    "town": (0.55, 0.20, 0.12, 0.03, 0.10),
    "village": (0.52, 0.26, 0.04, 0.18, 0.0),
    "hamlet": (0.40, 0.28, 0.0, 0.32, 0.0),
    "farm": (0.30, 0.30, 0.0, 0.40, 0.0),
}
SHED_SHARE = 0.22  # of houses have a garage or shed behind


def footprint(rng: np.random.Generator, mix: str) -> Polygon:
    """A building at the origin, its length along +x, its street side towards −y."""
    kind = rng.choice(5, p=MIX[mix])
    if kind == 2:
        return row(rng)
    if kind == 3:
        return shapes.rectangle((0, 0), 0, rng.uniform(17, 30), rng.uniform(10, 14))
    if kind == 4:
        return shapes.rectangle((0, 0), 0, rng.uniform(26, 60), rng.uniform(18, 32))
    length, width = rng.uniform(10.5, 15.5), rng.uniform(8.5, 11.5)
    main = shapes.rectangle((0, 0), 0, length, width)
    if kind == 0:
        return main
    wing_width, wing_length = rng.uniform(5.5, 7.5), rng.uniform(6, 12)
    side = rng.choice([-1, 1]) * (length - wing_width) / 2
    return main.union(shapes.rectangle((side, width / 2 + wing_length / 2 - 0.5), 0, wing_width, wing_length + 1))


def row(rng: np.random.Generator) -> Polygon:
    """Three to six houses wall to wall, their fronts not quite in line."""
    x, parts = 0.0, []
    for _ in range(rng.integers(3, 7)):
        width, depth = rng.uniform(7, 11), rng.uniform(10, 14)
        parts.append(shapes.rectangle((x + width / 2, depth / 2 + rng.uniform(-0.8, 0.8)), 0, width + 0.2, depth))
        x += width
    return translate(unary_union(parts), -x / 2, -6.0)


def put(shape: Polygon, at_xy: npt.ArrayLike, heading: float) -> Polygon:
    """A footprint turned so that its +x runs along `heading`, its origin at `at_xy`."""
    return Polygon(shapes.rotated(shapes.corners_xy(shape.exterior), heading) + np.asarray(at_xy))


def along_street(rng: np.random.Generator, street: Road, place: Settlement, ground: Ground) -> list[Polygon]:
    """Buildings on both sides of a street, added to `ground`."""
    built: list[Polygon] = []
    for side in (-1, 1):
        at = rng.uniform(6, 18)
        while at < street.line.length - 4:
            here, heading = on_line(street.line, at)
            mix = mix_at(place, here)
            shape = footprint(rng, mix)
            x0, y0, x1, y1 = shape.bounds
            setback = rng.uniform(4.6, 5.6) if mix == "core" else rng.uniform(4.6, 10.0)
            facing = heading if side > 0 else heading + np.pi
            normal = np.array([-np.sin(facing), np.cos(facing)])
            center = here + normal * (street.width / 2 + setback - y0)
            whole = put(shape, center, facing + rng.normal(0, 0.03))
            if ground.is_free(whole, CLEARANCE_M):
                built.append(whole)
                ground.add(whole)
                built += behind(rng, center, facing, y1, place, ground)
                at += (x1 - x0) + rng.uniform(*((3.5, 9) if mix == "core" else (6, 15)))
            else:
                at += 5.0
    return built


def behind(
    rng: np.random.Generator, center_xy: npt.ArrayLike, heading: float, depth: float, place: Settlement, ground: Ground
) -> list[Polygon]:
    """Now and then a shed, or in a village a barn, in the garden behind a house."""
    chance = rng.uniform()
    barn = place.kind in ("village", "hamlet") and chance < 0.22
    if not barn and chance > SHED_SHARE:
        return []
    shape = shapes.rectangle(
        (0, 0), 0, *((rng.uniform(15, 24), rng.uniform(9, 12)) if barn else (rng.uniform(6, 9), rng.uniform(4.5, 6.5)))
    )
    local = shapes.rotated(np.array([[rng.uniform(-8, 8), depth + rng.uniform(9, 20)]]), heading)[0]
    whole = put(shape, center_xy + local, heading + rng.choice([0, np.pi / 2]) + rng.normal(0, 0.05))
    if not ground.is_free(whole, CLEARANCE_M):
        return []
    ground.add(whole)
    return [whole]


def farmyard(rng: np.random.Generator, center_xy: npt.ArrayLike, heading: float) -> list[Polygon]:
    """Four to eight buildings around a yard: house, barns, sheds."""
    yard = rng.uniform(20, 27)
    built: list[Polygon] = []
    for k in range(rng.integers(4, 9)):
        angle = heading + (k % 4) * np.pi / 2
        out = yard if k < 4 else yard + rng.uniform(22, 30)
        aside = rng.uniform(-4, 4) if k < 4 else rng.uniform(-12, 12)
        at = np.add(center_xy, shapes.rotated(np.array([[aside, out]]), angle)[0])
        whole = put(footprint(rng, "farm"), at, angle + rng.normal(0, 0.04))
        if all(whole.distance(other) > CLEARANCE_M for other in built):
            built.append(whole)
    return built


def church(heading: float, center_xy: npt.ArrayLike) -> Polygon:
    """Nave, transept and tower."""
    nave, transept = shapes.rectangle((0, 0), 0, 34, 12), shapes.rectangle((6, 0), 0, 9, 24)
    tower = shapes.rectangle((-18, 0), 0, 8, 8)
    return put(unary_union([nave, transept, tower]), center_xy, heading)


def mix_at(place: Settlement, at_xy: npt.ArrayLike) -> str:
    """Kind of the settlement at a place, for MIX: the middle of a town has its own."""
    near = np.hypot(*np.subtract(at_xy, place.center_xy)) < CORE * place.radius
    return "core" if place.kind == "town" and near else place.kind


def on_line(line: LineString, at: float) -> tuple[np.ndarray, float]:
    """Point (2,) and direction of a line at a distance from its start."""
    here = shapes.point_xy(line.interpolate(at))
    ahead = shapes.point_xy(line.interpolate(min(at + 4, line.length)))
    back = shapes.point_xy(line.interpolate(max(at - 4, 0)))
    return here, float(np.arctan2(*(ahead - back)[::-1]))
