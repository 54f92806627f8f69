"""Draw images of other places, for which every position is wrong; one function for each kind."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from benchmarks.ground import Image, Wanted, random_view
from benchmarks.maps import NoDataError, read
from semref.core.evaluation.trial import Query
from semref.core.labels.class_shares import SeenLabels
from semref.core.simulation.views import PIXELS, View, cut

if TYPE_CHECKING:
    from benchmarks.accuracy import Source

EDGE_PX = 1280
SCALES = (0.8, 1.25)
FIELDS = (4, 5, 6, 7)
"""Background classes in the map of Liechtenstein."""

AERIAL_CLASSES = {1: 1, 2: 2, 3: 7, 4: 6, 5: 3}
"""Classes of Dubai's label maps, and the similar classes of the map."""

LATTICES = ("square", "rectangular", "hexagonal", "twin rows", "two classes")
CUTS = (0.3, 0.4, 0.5, 0.6, 0.7)
A_LANDSCAPE = 10
"""Draw images of one made-up landscape."""


def landscape(source: Source, rng: np.random.Generator, number: int) -> Image:
    """Draw made-up landscapes with the class values of the map."""
    return _view_of(_landscape(30_000 + number // A_LANDSCAPE), rng)


@lru_cache(maxsize=1)
def _landscape(seed: int) -> np.ndarray:
    from sample.files import rasterize
    from sample.landscape import make_landscape

    return rasterize(make_landscape(seed))


def aerial(source: Source, rng: np.random.Generator, number: int) -> Image:
    """Draw images from label maps of real aerial photos."""
    paths = sorted((source.world.data / "dubai_aerial").glob("tile*_label.tif"))
    if not paths:
        raise NoDataError("dubai_aerial is not here.")
    table = np.zeros(256, np.uint8)
    table[list(AERIAL_CLASSES)] = list(AERIAL_CLASSES.values())
    return _view_of(table[read(paths[number % len(paths)])], rng)


def _view_of(labels_hw: np.ndarray, rng: np.random.Generator) -> Image:
    height, width = labels_hw.shape
    edge = min(EDGE_PX, int(0.6 * min(height, width) / SCALES[0]))
    extent = (0.3 * width, -0.7 * height, 0.7 * width, -0.3 * height)
    view = random_view(rng, extent, (edge, edge), SCALES)
    return Image(Query(view, is_of_map=False), SeenLabels(cut(labels_hw, PIXELS, view)))


def lattice(source: Source, rng: np.random.Generator, number: int) -> Image:
    """Draw regular rows of plots with gaps, on two kinds of fields."""
    kind = LATTICES[number % len(LATTICES)]
    spacing = rng.uniform(40, 160)
    other = spacing * (1.0 if kind == "square" else rng.choice([1.0, rng.uniform(0.5, 2)]))
    columns, rows = np.meshgrid(np.arange(-40, 41), np.arange(-40, 41))
    if kind == "hexagonal":
        points = (columns + rows % 2 / 2) * spacing + 1j * rows * spacing * np.sqrt(0.75)
    elif kind == "twin rows":
        points = columns * spacing + 1j * (rows // 2 * 2 + rows % 2 * rng.uniform(0.5, 0.9)) * other
    else:
        points = columns * spacing + 1j * rows * other
    jitter = rng.normal(0, 1, (2, points.size))
    points = points.ravel() * np.exp(1j * rng.uniform(0, 2 * np.pi)) + jitter[0] + 1j * jitter[1]
    is_second = (kind == "two classes") & ((columns + rows).ravel() % 2 == 1)
    halves = np.sqrt(rng.uniform(100, 400) * np.exp(rng.normal(0, 0.1, points.size))) / 2
    kept = rng.random(points.size) > 0.15
    first, second = rng.choice(FIELDS, 2, replace=False)
    y, x = np.mgrid[:EDGE_PX, :EDGE_PX] - EDGE_PX / 2
    turn = rng.uniform(0, 2 * np.pi)
    labels = np.where(x * np.cos(turn) + y * np.sin(turn) > rng.uniform(-300, 300), second, first).astype(np.uint8)
    for point, half, value in zip(points[kept] + EDGE_PX / 2 * (1 + 1j), halves[kept], 1 + is_second[kept]):
        left, top = max(round(point.real - half), 0), max(round(point.imag - half), 0)
        labels[top : max(round(point.imag + half), 0), left : max(round(point.real + half), 0)] = value
    return Image(Query(View(0.0, 0.0, 0.0, 1.0, EDGE_PX, EDGE_PX), is_of_map=False), SeenLabels(labels))


def two_places(source: Source, rng: np.random.Generator, number: int) -> Image:
    """Join one side of an image with the other side of an image of another place."""
    ground = source.ground
    one = ground.draw(source.wanted, rng)
    scale = one.view.pixel_size / ground.frame.pixel_size
    other = ground.draw(Wanted((scale, scale), landmarks=source.wanted.landmarks), rng)
    both, where = one.labels_hw.copy(), int(rng.choice(CUTS) * one.view.width_px)
    if rng.integers(2):
        both[:, where:] = other.labels_hw[:, where:]
    else:
        both[where:] = other.labels_hw[where:]
    image = Image(Query(one.view, is_of_map=False), SeenLabels(both), one.landmarks)
    return ground.spoiled(image, source.noise(one.view, rng)[0], rng)


KINDS = {"landscape": landscape, "aerial": aerial, "lattice": lattice, "two places": two_places}
"""Kinds by name. ``mirrored`` and ``other half`` are drawn like images of the map and are not listed."""
