"""Map correlation's first look: all places, turns and scales at coarse pixels, by FFT (docs/method.md#map-correlation).

For every assumed ground sampling distance the map is resampled so that the *image* always has the same coarse size:
the spectra of the turned images are computed once and serve all scales. The map goes tile by tile (overlap-save),
so memory does not depend on its size; tiles without labels cost nothing.

Score of a place and a turn: Σ over channels of ⟨image, map⟩ under the turned footprint, image free of its mean there,
divided by the image's norm and by the root of the map's energy around its own mean in the footprint averaged over
turns: the zero-mean normalized cross-correlation but for the corners; the exact one follows in the refinement.
"""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import NamedTuple

import cv2
import numpy as np

from .class_pyramid import EvidenceLevel, MapPyramid


@dataclass(frozen=True)
class SearchSpace:
    """What is searched.

    Attributes:
        headings_deg: (T,) turns of the image.
        pixel_sizes_m: (S,) ground sampling distances.
        box_m: (left, top, right, bottom) of the image's center, in meters right and down from the map's upper left
            corner.
    """

    headings_deg: np.ndarray
    pixel_sizes_m: np.ndarray
    box_m: tuple[float, float, float, float]


@dataclass(frozen=True)
class TurnedImage:
    """One turned image as a template.

    Attributes:
        evidence: (t, t, C) float32, mean 0 and norm 1 under its mask.
        mask: (t, t) float32, share of each pixel that the image covers.
    """

    evidence: np.ndarray
    mask: np.ndarray


def turn_image(image: EvidenceLevel, heading_deg: float, edge: int, pixel: float) -> TurnedImage:
    """The image as it lies on the map: a square template around its center.

    Args:
        image: Its evidence.
        heading_deg: Of its top, clockwise from up.
        edge: Of the template, its own pixels.
        pixel: Edge of such a pixel, image pixels.
    """
    height, width = image.known.shape
    cos, sin = np.cos(np.radians(heading_deg)), np.sin(np.radians(heading_deg))
    inverse = np.array([[cos, sin], [-sin, cos]]) * pixel / np.array(image.pixel)[:, None]
    offset = np.array([(width - 1) / 2, (height - 1) / 2]) - inverse @ np.array([(edge - 1) / 2, (edge - 1) / 2])
    matrix = np.column_stack([inverse, offset])
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    evidence = cv2.warpAffine(image.evidence, matrix, (edge, edge), flags=flags).reshape(edge, edge, -1)
    mask = cv2.warpAffine(np.ones((height, width), np.float32), matrix, (edge, edge), flags=flags)
    evidence = evidence - mask[..., None] * (evidence.sum(axis=(0, 1)) / max(float(mask.sum()), 1e-9))
    norm = float(np.sqrt((evidence**2).sum()))
    return TurnedImage(np.ascontiguousarray(evidence / max(norm, 1e-9)), mask)


def template_edge(image: EvidenceLevel) -> int:
    """Odd edge of the square that holds the image at any turn, in its own pixels."""
    height, width = image.known.shape
    return int(np.ceil(np.hypot(height, width))) // 2 * 2 + 3


def search(image: EvidenceLevel, pyramid: MapPyramid, space: SearchSpace) -> np.ndarray:
    """Peaks of each tile and scale; the same place can come up for several scales.

    Args:
        image: Coarse evidence.
        pyramid: The map's.
        space: What is searched.

    Returns:
        (N, 5) float64: score, x, y (meters right and down of the map's corner), heading (°), pixel size (m); best
        first.
    """
    threads = pyramid.settings.threads
    templates = _templates(image, pyramid, space)

    def one_tile(job: tuple[float, _Tile]) -> list[tuple[float, ...]]:
        size_m, tile = job
        return _tile_peaks(pyramid, templates, space, size_m, tile)

    jobs = [
        (size_m, tile)
        for size_m in space.pixel_sizes_m
        for tile in _tiles(space.box_m, size_m * templates.pixel, templates.places)
    ]
    if threads > 1 and len(jobs) > 1:
        with ThreadPoolExecutor(threads) as pool:
            found = list(pool.map(one_tile, jobs))
    else:
        found = [one_tile(job) for job in jobs]
    peaks = np.array([peak for peaks in found for peak in peaks], np.float64).reshape(-1, 5)
    return peaks[np.argsort(-peaks[:, 0], kind="stable")]


class _Tile(NamedTuple):
    """A part of the places searched: its corner in meters right and down of the map's, and its places along x and y."""

    left: float
    top: float
    columns: int
    rows: int


@dataclass(frozen=True)
class _Templates:
    """The image at every turn, ready to be laid over a tile.

    Attributes:
        pixel: Edge of a template's pixel, image pixels.
        edge: Of a template, its pixels.
        tile_size: Edge of a tile, such pixels.
        spectra: Of each turn and channel, as a tile's.
        mask: Spectrum of the mean mask over turns.
        mask_sum: Pixels that it covers.
        quiet: Energy that is added to a footprint's own.
    """

    pixel: float
    edge: int
    tile_size: int
    spectra: list[list[np.ndarray]]
    mask: np.ndarray
    mask_sum: float
    quiet: float

    @property
    def places(self) -> int:
        """Places along an edge of a tile."""
        return self.tile_size - self.edge + 1


def _templates(image: EvidenceLevel, pyramid: MapPyramid, space: SearchSpace) -> _Templates:
    edge = template_edge(image)
    pixel = float(np.sqrt(image.pixel[0] * image.pixel[1]))
    tile_size = cv2.getOptimalDFTSize(max(pyramid.settings.tile_size, 2 * edge))
    extent = max(space.box_m[2] - space.box_m[0], space.box_m[3] - space.box_m[1])
    needed = int(np.ceil(extent / (pixel * float(space.pixel_sizes_m.min())))) + edge + 1
    tile_size = min(tile_size, cv2.getOptimalDFTSize(needed))
    turned = [turn_image(image, heading, edge, pixel) for heading in space.headings_deg]
    spectra = [[_spectrum(one.evidence[..., c], tile_size) for c in range(one.evidence.shape[2])] for one in turned]
    mean_mask = np.mean([one.mask for one in turned], axis=0)
    covered = float(mean_mask.sum())
    return _Templates(
        pixel, edge, tile_size, spectra, _spectrum(mean_mask, tile_size), covered, pyramid.quiet * covered
    )


def _tile_peaks(
    pyramid: MapPyramid, templates: _Templates, space: SearchSpace, size_m: float, tile: _Tile
) -> list[tuple[float, ...]]:
    """Rows of ``search`` of one tile at one pixel size."""
    pixel_m = size_m * templates.pixel
    scores = _tile_scores(pyramid, templates, pixel_m, (tile.left, tile.top))
    if scores is None:
        return []
    best, turn = (plane[: tile.rows, : tile.columns] for plane in scores)
    return [
        (
            float(best[row, column]),
            tile.left + (column + 0.5) * size_m * templates.pixel,
            tile.top + (row + 0.5) * size_m * templates.pixel,
            float(space.headings_deg[turn[row, column]]),
            float(size_m),
        )
        for row, column in _peaks(best, max(1, templates.edge // 20), pyramid.settings.peaks_per_tile)
    ]


def _tiles(box_m: tuple[float, float, float, float], pixel_m: float, step: int) -> Iterator[_Tile]:
    """Tiles that together cover the box, ``step`` places along an edge."""
    columns = max(1, int(np.ceil((box_m[2] - box_m[0]) / pixel_m)))
    rows = max(1, int(np.ceil((box_m[3] - box_m[1]) / pixel_m)))
    for row in range(0, rows, step):
        for column in range(0, columns, step):
            corner = box_m[0] + column * pixel_m, box_m[1] + row * pixel_m
            yield _Tile(*corner, min(step, columns - column), min(step, rows - row))


def _tile_scores(
    pyramid: MapPyramid, templates: _Templates, pixel_m: float, corner_m: tuple[float, float]
) -> tuple[np.ndarray, np.ndarray] | None:
    """Best score and turn of every place of one tile: two (places, places) arrays, or None without labels.

    The first place is the pixel whose upper left corner is ``corner_m``.
    """
    size, places = templates.tile_size, templates.places
    half = (templates.edge - 1) / 2 * pixel_m
    left, top = corner_m[0] - half, corner_m[1] - half
    # One pixel more on each side, for the interpolation.
    box = left - pixel_m, top - pixel_m, left + (size + 1) * pixel_m, top + (size + 1) * pixel_m
    level, first_x, first_y = pyramid.crop(pixel_m, box)
    step = pixel_m / level.pixel[0]
    matrix = np.array(
        [
            [step, 0, (left - first_x) / level.pixel[0] + step / 2 - 0.5],
            [0, step, (top - first_y) / level.pixel[0] + step / 2 - 0.5],
        ]
    )
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    known = cv2.warpAffine(level.known, matrix, (size, size), flags=flags)
    if not known.any():
        return None
    evidence = cv2.warpAffine(level.evidence, matrix, (size, size), flags=flags).reshape(size, size, -1)
    tile = [cv2.dft(np.ascontiguousarray(evidence[..., c])) for c in range(evidence.shape[2])]
    energy = _correlation([cv2.dft((evidence**2).sum(axis=2))], [templates.mask], places)
    for spectrum in tile:
        energy -= _correlation([spectrum], [templates.mask], places) ** 2 / templates.mask_sum
    share = _correlation([cv2.dft(known)], [templates.mask], places) / templates.mask_sum
    weight = 1 / np.sqrt(np.maximum(energy, 0) + templates.quiet)
    weight[share < pyramid.settings.least_known] = 0
    best = np.full((places, places), -1.0, np.float32)
    turn = np.zeros((places, places), np.uint16)
    if not weight.any():
        return None
    for index, template in enumerate(templates.spectra):
        score = _correlation(tile, template, places)
        better = cv2.compare(score, best, cv2.CMP_GT)
        cv2.max(score, best, dst=best)
        turn[better > 0] = index
    best *= weight
    return best, turn


def _correlation(tile: list[np.ndarray], template: list[np.ndarray], places: int) -> np.ndarray:
    """(places, places) float32: Σ over channels of the correlation, from spectra in OpenCV's packed format."""
    product = cv2.mulSpectrums(tile[0], template[0], 0, conjB=True)
    for one, other in zip(tile[1:], template[1:]):
        cv2.add(product, cv2.mulSpectrums(one, other, 0, conjB=True), dst=product)
    return cv2.dft(product, flags=cv2.DFT_INVERSE | cv2.DFT_SCALE | cv2.DFT_REAL_OUTPUT)[:places, :places]


def _spectrum(plane: np.ndarray, size: int) -> np.ndarray:
    """Spectrum of a template, put into the upper left corner of a ``size`` × ``size`` tile."""
    padded = np.zeros((size, size), np.float32)
    padded[: plane.shape[0], : plane.shape[1]] = plane
    return cv2.dft(padded, nonzeroRows=plane.shape[0])


def _peaks(score: np.ndarray, radius: int, count: int) -> np.ndarray:
    """(M, 2) int rows and columns of the local maxima above 0, best first, at most ``count``."""
    kernel = np.ones((2 * radius + 1, 2 * radius + 1), np.uint8)
    at = np.argwhere((score >= cv2.dilate(score, kernel)) & (score > 0))
    order = np.argsort(-score[at[:, 0], at[:, 1]], kind="stable")
    return at[order[:count]]
