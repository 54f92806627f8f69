"""A particle filter of the published kind, to be compared with: poses drawn over the whole map, weighed by labels.

Each particle is a place and a heading; pixel sizes are told exactly, which no published filter has better. Its
likelihood is that of the labels: of a grid of points in the image, each shows its map's class with one probability
and any other with another, and neighbors are not independent, so that the grid counts as fewer points (semantic Monte
Carlo localization; one label raster against another). Systematic resampling, motion by the same links, roughened.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from bench.flown import Flown
from semref.core.database.model import ReferenceDatabase

GRID = 16
POINTS = 40.0
"""The grid's points count as so many independent ones."""

RIGHT_LABEL = 0.6
ROUGH_M, ROUGH_DEG = 8.0, 2.0
CONVERGED_M = 60.0
"""Standard deviation of the particles' places below which the filter is said to know where it is."""


@dataclass(frozen=True)
class ParticlePose:
    """What the filter says of an image."""

    position: tuple[float, float]
    is_converged: bool


def follow(database: ReferenceDatabase, flown: Flown, count: int, rng: np.random.Generator) -> list[ParticlePose]:
    """Poses of a flight by a particle filter that knows nothing of its start."""
    overview, frame = database.overview, database.parameters.overview_frame
    classes = len(np.unique(overview[overview > 0]))
    rows, columns = np.nonzero(overview)
    picked = rng.integers(0, len(rows), count)
    places = frame.to_map(np.column_stack([columns[picked], rows[picked]]) + rng.random((count, 2)))
    where, headings = places[:, 0] + 1j * places[:, 1], rng.uniform(0, 2 * np.pi, count)
    links = {link.second: link for link in flown.links}
    found = []
    for number, (image, view) in enumerate(zip(flown.images, flown.views)):
        link = links.get(number)
        if link is not None:
            size = flown.views[number - 1].pixel_size
            where = where + size * np.exp(-1j * headings) * link.step
            headings = headings + link.turn
        where = where + ROUGH_M * (rng.normal(size=count) + 1j * rng.normal(size=count))
        headings = headings + np.radians(ROUGH_DEG) * rng.normal(size=count)
        agreement = _agreement(image.labels_hw, view.pixel_size, where, headings, overview, frame)
        other = (1 - RIGHT_LABEL) / max(classes - 1, 1)
        weights = POINTS * agreement * np.log(RIGHT_LABEL / other)
        weights = np.exp(weights - weights.max())
        weights /= weights.sum()
        mean = (weights * where).sum()
        spread = np.sqrt((weights * np.abs(where - mean) ** 2).sum() / 2)
        found.append(ParticlePose((mean.real, mean.imag), bool(spread < CONVERGED_M)))
        steps = (rng.random() + np.arange(count)) / count
        kept = np.minimum(np.searchsorted(np.cumsum(weights), steps), count - 1)
        where, headings = where[kept], headings[kept]
    return found


def _agreement(
    labels_hw: np.ndarray, size: float, where: np.ndarray, headings: np.ndarray, overview: np.ndarray, frame: object
) -> np.ndarray:
    """(n,) share of the grid's points whose label is the map's there."""
    height, width = labels_hw.shape
    rows = ((np.arange(GRID) + 0.5) * height / GRID).astype(int)
    columns = ((np.arange(GRID) + 0.5) * width / GRID).astype(int)
    labels = labels_hw[np.ix_(rows, columns)].ravel()
    points = (columns[None, :] + 0.5 - width / 2) + 1j * (height / 2 - rows[:, None] - 0.5)
    agreeing = np.zeros(len(where))
    for label, point in zip(labels, points.ravel()):
        there = where + size * np.exp(-1j * headings) * point
        pixels = np.floor(frame.to_pixels(np.column_stack([there.real, there.imag]))).astype(np.int64)
        inside = ((pixels >= 0) & (pixels < overview.shape[::-1])).all(axis=1)
        pixels[~inside] = 0
        agreeing += inside & (overview[pixels[:, 1], pixels[:, 0]] == label) & (label > 0)
    return agreeing / len(labels)
