"""Parcels of open land, forest, and bare ground."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from shapely.affinity import rotate
from shapely.geometry import LineString, MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union
from shapely.prepared import prep

from . import shapes
from .roads import Settlement
from .scatter import Ground

PARCEL_AREA_M2 = (7_000.0, 34_000.0)  # most parcels end between; usual sizes in southern Germany
TRACK_AREA_M2 = 130_000.0  # larger pieces are divided by a farm track
TRACK_WIDTH_M, MARGIN_WIDTH_M = 4.0, 2.0
FOREST_PIXEL_M = 10.0
FOREST_SHARE = 0.27  # of the map, before villages and roads are taken out
COPSES = 70
LARGEST_GREEN_M2 = 15_000.0  # smaller gaps between houses are not farmed
QUARRY_RADII_M = (85.0, 65.0, 55.0, 45.0, 38.0)
ROCK_COUNT, LOT_COUNT = 38, 34


def parcels(rng: np.random.Generator, land: BaseGeometry) -> list[Polygon]:
    """Cut open land into parcels; each block between roads has its own direction."""
    found: list[Polygon] = []
    for block in shapes.polygons_of(land, 1500):
        heading = np.arctan2(*shapes.longest_side(block)[::-1]) + rng.normal(0, 0.12)
        found += cut(rng, block, heading)
    return found


def cut(rng: np.random.Generator, piece: Polygon, heading: float) -> list[Polygon]:
    """Halve a piece across its longer direction until it is a parcel; leaves a track or a margin at each cut."""
    if piece.area < rng.uniform(*PARCEL_AREA_M2) * 1.6:
        return [piece]
    if piece.area > 2.5 * TRACK_AREA_M2:
        heading += rng.normal(0, 0.22)  # large blocks are not plowed in one direction
    x0, y0, x1, y1 = rotate(piece, -heading, origin=(0, 0), use_radians=True).bounds
    if x1 - x0 > 1.35 * (y1 - y0) * rng.uniform(0.75, 1.9):
        x = x0 + rng.uniform(0.36, 0.64) * (x1 - x0)
        line = np.array([[x, y0 - 9], [x, y1 + 9]])
    else:
        y = y0 + rng.uniform(0.36, 0.64) * (y1 - y0)
        line = np.array([[x0 - 9, y], [x1 + 9, y]])
    width = TRACK_WIDTH_M if piece.area > TRACK_AREA_M2 else MARGIN_WIDTH_M
    gap = LineString(shapes.rotated(line, heading)).buffer(width / 2, cap_style=2)
    parts = shapes.polygons_of(piece.difference(gap), 900)
    return [parcel for part in parts for parcel in cut(rng, part, heading)]


def forest(
    rng: np.random.Generator, size_xy: tuple[float, float], settlements: Sequence[Settlement], river_line: LineString
) -> list[Polygon]:
    """Woods with ragged edges and clearings, away from the settlements; copses, and trees along the river."""
    width, height = (int(v / FOREST_PIXEL_M) for v in size_xy)
    x, y = np.meshgrid((np.arange(width) + 0.5) * FOREST_PIXEL_M, (np.arange(height) + 0.5) * FOREST_PIXEL_M)
    density = shapes.noise(rng, (height, width), 90, 7, 0.7)
    for place in settlements:
        distance = np.hypot(x - place.center_xy[0], y - place.center_xy[1])
        density -= 3.0 * np.exp(-((distance / (1.05 * place.radius + 60)) ** 2))
    woods = shapes.mask_polygons(density > np.quantile(density, 1 - FOREST_SHARE), FOREST_PIXEL_M, 6000)
    copses = [
        shapes.blob(
            rng, rng.uniform((0, 0), size_xy), rng.uniform(9, 24), 0.2, rng.uniform(1, 3.5), rng.uniform(0, np.pi)
        )
        for _ in range(COPSES)
    ]
    return woods + copses + riverside_trees(rng, river_line)


def riverside_trees(rng: np.random.Generator, line: LineString) -> list[Polygon]:
    """Strips of trees on pieces of either bank."""
    strips, at = [], rng.uniform(0, 200)
    while at < line.length:
        until = at + rng.uniform(60, 240)
        piece = LineString([shapes.point_xy(line.interpolate(s)) for s in np.arange(at, until, 12)])
        side = rng.choice([-1, 1])
        bank = piece.buffer(side * rng.uniform(27, 46), single_sided=True).buffer(-5).buffer(5, 2)
        strips += shapes.polygons_of(bank, 500)
        at = until + rng.uniform(20, 260)
    return strips


def gravel_banks(line: LineString, river: BaseGeometry, rng: np.random.Generator) -> list[Polygon]:
    """Gravel on the inner side of the river's bends, half under water."""
    points = np.array([shapes.point_xy(line.interpolate(s)) for s in np.arange(0, line.length, 40.0)])
    before, after = points[1:-1] - points[:-2], points[2:] - points[1:-1]
    turn = np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(axis=1))
    banks = []
    for k in range(1, len(turn) - 1):
        if abs(turn[k]) > 0.16 and abs(turn[k]) >= max(abs(turn[k - 1]), abs(turn[k + 1])):
            heading = np.arctan2(after[k, 1], after[k, 0])
            inner = np.array([-np.sin(heading), np.cos(heading)]) * np.sign(turn[k])
            banks.append(shapes.blob(rng, points[k + 1] + inner * 20, rng.uniform(13, 21), 0.1, 3.0, heading))
    return [bank for bank in banks if bank.difference(river).area > 150]


def bare_ground(
    rng: np.random.Generator, ground: Ground, woods: list[Polygon], places: Sequence[Settlement]
) -> list[Polygon]:
    """Quarries, rock in the forest, gravel lots by the settlements; added to `ground`."""
    wooded = prep(unary_union(woods))
    found: list[Polygon] = []
    for radius in QUARRY_RADII_M:
        found += ground.place_blob(rng, radius, 0.17, 1.8, 16)
    for _ in range(ROCK_COUNT):
        found += ground.place_blob(rng, rng.uniform(8, 19), 0.22, 2.5, 8, area=wooded)
    for _ in range(LOT_COUNT):
        size, place = rng.uniform((22, 16), (60, 34)), places[rng.integers(len(places))]
        reach = place.radius + 70
        near = (*np.subtract(place.center_xy, reach), *np.add(place.center_xy, reach))
        found += ground.place(rng, lambda at, s=size: [shapes.rectangle(at, rng.uniform(0, np.pi), *s)], 6, near)
    return found


def gardens(houses: list[Polygon], roads: BaseGeometry) -> list[MultiPolygon | Polygon]:
    """Green areas around groups of houses; one (multi)polygon per settlement."""
    green = unary_union([h.buffer(17, 3) for h in houses]).buffer(9, 3).buffer(-9, 3).simplify(0.6)
    clumps = [
        Polygon(c.exterior, [h for h in c.interiors if Polygon(h).area > LARGEST_GREEN_M2])
        for c in shapes.polygons_of(green)
    ]
    return [clump.difference(roads) for clump in clumps]
