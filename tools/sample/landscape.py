"""A made-up piece of Central Europe, drawn from a seed."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import shapely
from shapely.affinity import translate
from shapely.geometry import MultiPolygon, Polygon, box
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union
from shapely.prepared import prep

from . import fields, houses, roads, shapes, water
from .classes import BARE_LAND, BUILDING, CULTIVATED, FOREST, GRASS, WATER
from .scatter import Ground

SIZE_XY = (4000.0, 3000.0)  # meters
ORIGIN_XY = (548_000.0, 5_420_000.0)  # south-west corner, in hills east of the Neckar
EPSG = 25832  # ETRS89 / UTM 32N
PRECISION_M = 0.01  # of written coordinates: what a GNSS survey gives
ZORDER = {"parcel": 10, GRASS: 20, FOREST: 30, BARE_LAND: 40, WATER: 50, BUILDING: 60}  # higher is on top

FILL_WINDOW_M, FILL_STEP_M, FILL_OBJECTS = 640.0, 160.0, 13  # so many objects in every window, where there is room
FILL_ROUNDS = 70
MULTIPART_FARMS, MULTIPART_FIELDS = 4, 3
BOW_TIES = 3
_Draw = Callable[..., np.random.Generator]


@dataclass(frozen=True)
class Feature:
    """One drawn polygon.

    Attributes:
        class_value: Its class.
        zorder: Drawing order; higher values are on top.
        geometry: Shapely geometry in map coordinates; None for a feature without one.
    """

    class_value: int
    zorder: int
    geometry: Any


@dataclass(frozen=True)
class Landscape:
    """A drawn area.

    Attributes:
        features: Polygons as an annotator drew them.
        road_surface: The ground that roads cover.
        extent: (x0, y0, x1, y1), map coordinates in meters.
        epsg: Of the map's CRS.
        seed: It was drawn from.
    """

    features: tuple[Feature, ...]
    road_surface: BaseGeometry
    extent: tuple[float, float, float, float]
    epsg: int
    seed: int

    @property
    def frame(self) -> tuple[float, float, int, int]:
        """West and north edge in map units, width and height in pixels of 1 m: the grid of label map and photo."""
        west, south, east, north = self.extent
        return west, north, round(east - west), round(north - south)


# Old versions of GEOS compute with heights that are not there, and numpy would warn of it.
@np.errstate(invalid="ignore")
def make_landscape(seed: int) -> Landscape:
    """The landscape of a seed: the same seed gives the same features in the same order."""

    def draw(*step: int) -> np.random.Generator:
        """Each step has a generator of its own, so that a change in one step leaves the others as they are."""
        return np.random.default_rng([seed, *step])

    rivers = water.make_rivers(draw(0), SIZE_XY)
    places = roads.settle(draw(1), SIZE_XY, rivers.river_line)
    network = roads.connect(draw(2), places, SIZE_XY, rivers.river_line)
    streets = [roads.streets_of(draw(3, k), p, network, rivers.surface.buffer(12)) for k, p in enumerate(places)]
    surface = roads.surface_of(network + [street for local in streets for street in local])
    ground = Ground(SIZE_XY, unary_union([surface.buffer(1.2), rivers.surface.buffer(11)]))

    buildings = _buildings(draw, places, streets, ground)
    woods = fields.forest(draw(5), SIZE_XY, places, rivers.river_line)
    still = water.still_waters(draw(6), ground)
    bare = fields.bare_ground(draw(7), ground, woods, places)
    bare += fields.gravel_banks(rivers.river_line, rivers.river, draw(8))
    _fill(draw(9), ground, buildings, still, bare, unary_union(woods))

    drawn = _land(draw, rivers, buildings, woods, surface)
    drawn += [(BARE_LAND, ZORDER[BARE_LAND], g) for g in bare]
    drawn += [(WATER, ZORDER[WATER], g) for g in [rivers.river, rivers.stream, *still]]
    drawn += [(BUILDING, ZORDER[BUILDING], g) for g in buildings]
    features = with_quirks(draw(12), _finished(drawn))
    order = draw(13).permutation(len(features))  # as in a file drawn over years: order says nothing
    extent = (*ORIGIN_XY, ORIGIN_XY[0] + SIZE_XY[0], ORIGIN_XY[1] + SIZE_XY[1])
    return Landscape(tuple(features[i] for i in order), translate(surface, *ORIGIN_XY), extent, EPSG, seed)


def _buildings(
    draw: _Draw, places: Sequence[roads.Settlement], streets: Sequence[list[roads.Road]], ground: Ground
) -> list[Polygon]:
    """All buildings of the settlements, added to `ground`."""
    built: list[Polygon] = []
    for k, (place, local) in enumerate(zip(places, streets)):
        rng = draw(4, k)
        if place.kind == "farm":
            near = (np.array([-60, -60, 60, 60]) + np.tile(place.center_xy, 2)).tolist()
            heading = rng.uniform(0, np.pi)
            built += ground.place(rng, lambda at: houses.farmyard(rng, at, heading), houses.CLEARANCE_M, near)
            continue
        if place.kind != "hamlet":
            near = (np.array([-50, -50, 50, 50]) + np.tile(place.center_xy, 2)).tolist()
            built += ground.place(rng, lambda at: [houses.church(rng.normal(0, 0.2), at)], 8, near)
        for street in local:
            built += houses.along_street(rng, street, place, ground)
    return built


def _fill(
    rng: np.random.Generator, ground: Ground, buildings: list, still: list, bare: list, woods: BaseGeometry
) -> None:
    """Add farms, ponds and gravel where a window would hold too few objects to be recognized."""
    cleared = prep(box(0, 0, *SIZE_XY).difference(woods.buffer(25)))
    for turn in range(FILL_ROUNDS):
        (x, y), count = _emptiest_window([*buildings, *still, *bare])
        if count >= FILL_OBJECTS:
            return
        within = (x + 80, y + 80, x + FILL_WINDOW_M - 80, y + FILL_WINDOW_M - 80)
        if turn % 3 == 0:
            heading = rng.uniform(0, np.pi)
            yards = ground.place(rng, lambda at: houses.farmyard(rng, at, heading), houses.CLEARANCE_M, within, cleared)
            buildings += yards
            if yards:
                continue
        radius = rng.uniform(9, 20)
        (still if turn % 2 else bare).extend(
            ground.place(rng, lambda at: [shapes.blob(rng, at, radius, 0.16, rng.uniform(1, 2))], 12, within)
        )


def _emptiest_window(objects: list[Polygon]) -> tuple[tuple[float, float], int]:
    """South-west corner of the window that holds the fewest objects, and how many it holds."""
    points = np.array([shapes.point_xy(p.representative_point()) for p in objects])
    across, up = (np.arange(0, side - FILL_WINDOW_M + 1, FILL_STEP_M) for side in SIZE_XY)
    corners = np.array([(x, y) for x in across for y in up])
    held = np.all((points >= corners[:, None]) & (points < corners[:, None] + FILL_WINDOW_M), axis=2).sum(axis=1)
    emptiest = int(held.argmin())
    return tuple(corners[emptiest].tolist()), int(held[emptiest])


def _land(
    draw: _Draw, rivers: water.Rivers, buildings: list[Polygon], woods: list[Polygon], surface: BaseGeometry
) -> list[tuple[int, int, BaseGeometry]]:
    """Background: parcels below, gardens and forest above them, roads left free."""
    gardens = fields.gardens(buildings, surface.buffer(0.5))
    kept_free = unary_union([*gardens, surface.buffer(1.5)])
    forest = [part for wood in woods for part in shapes.polygons_of(wood.difference(kept_free), 250)]
    open_land = box(0, 0, *SIZE_XY).difference(unary_union([surface.buffer(1.0), rivers.river.buffer(5)]))
    taken = unary_union([*gardens, *forest])
    meadow = draw(11)
    drawn = []
    for parcel in fields.parcels(draw(10), open_land):
        if parcel.intersection(taken).area > 0.985 * parcel.area:
            continue
        wet = parcel.distance(rivers.river_line) < 90
        grass = meadow.uniform() < (0.6 if wet else 0.2)
        drawn.append((GRASS if grass else CULTIVATED, ZORDER["parcel"], parcel))
    drawn += [(GRASS, ZORDER[GRASS], g) for g in gardens]
    return drawn + [(FOREST, ZORDER[FOREST], g) for g in forest]


def _finished(drawn: Sequence[tuple[int, int, BaseGeometry]]) -> list[Feature]:
    """Clip to the map, round, move to map coordinates; what is left of a feature stays one feature."""
    edge = box(0, 0, *SIZE_XY)
    features = []
    for value, zorder, geometry in drawn:
        parts = shapes.polygons_of(geometry.intersection(edge), 8.0)
        if parts:
            whole = parts[0] if len(parts) == 1 else MultiPolygon(parts)
            placed = shapely.set_precision(shapely.force_2d(translate(whole, *ORIGIN_XY)), PRECISION_M)
            features.append(Feature(value, zorder, shapely.normalize(placed)))
    return features


def with_quirks(rng: np.random.Generator, features: list[Feature]) -> list[Feature]:
    """What every hand-drawn file has: some multipart polygons, bow-ties, and one feature without geometry."""
    features = joined(rng, features, BUILDING, MULTIPART_FARMS)
    features = joined(rng, features, CULTIVATED, MULTIPART_FIELDS)
    meadows = [f for f in features if f.class_value == GRASS and f.geometry.area > 8000]
    for index in rng.choice(len(meadows), BOW_TIES, replace=False):
        at = shapes.point_xy(meadows[index].geometry.representative_point())
        ring = np.round(at + shapes.rotated(np.array([[-14, -9], [14, 9], [14, -9], [-14, 9]]), rng.uniform(0, 3)), 2)
        features.append(Feature(GRASS, ZORDER[GRASS], Polygon(ring)))
    return [*features, Feature(GRASS, ZORDER[GRASS], None)]


def joined(rng: np.random.Generator, features: list[Feature], value: int, count: int) -> list[Feature]:
    """Make `count` pairs of neighboring polygons of a class one multipart feature each."""
    features = list(features)
    for _ in range(count):
        single = [i for i, f in enumerate(features) if f.class_value == value and f.geometry.geom_type == "Polygon"]
        first = single[rng.integers(len(single))]
        others = [i for i in single if i != first and features[i].geometry.distance(features[first].geometry) > 0]
        nearest = min(others, key=lambda i: features[i].geometry.distance(features[first].geometry))
        both = MultiPolygon([features[first].geometry, features[nearest].geometry])
        features[first] = replace(features[first], geometry=both)
        del features[nearest]
    return features
