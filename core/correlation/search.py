"""First look of map correlation: all places, headings and pixel sizes at coarse pixels, by FFT.

See docs/explanation/method.md#map-correlation. For every pixel size, the map is resampled so that the *image* always
has the same coarse size: the spectra of the turned images are computed once for all pixel sizes. The map is processed
in tiles (overlap-save), so that memory does not depend on its size; tiles without labels take no time.

The score of a place and a heading is Σ over channels of ⟨image, map⟩ under the turned footprint. The image has mean 0
there. The sum is divided by the image's norm and by the root of the map's energy around its own mean in the footprint,
averaged over headings. This is the zero-mean normalized cross-correlation except in the corners; refinement computes
the exact one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import NamedTuple

import cv2
import numpy as np

from .class_pyramid import EvidenceLevel, MapPyramid
from .refine import LEAST_KNOWN

TILE_SIZE = 128
"""Edge of a tile of the FFT, coarse pixels: powers of two are fastest, about four times the turned image is best."""

THREADS = 2
"""Tiles compared at a time; affects only the time."""


@dataclass(frozen=True)
class SearchSpace:
    """Poses to search.

    Attributes:
        headings_deg: (T,) headings of the image.
        pixel_sizes_m: (S,) ground sizes of a pixel.
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
    """Return the image in its direction on the map: a square template around its center.

    Args:
        image: Its evidence.
        heading_deg: Of its top, clockwise from up.
        edge: Of the template, in its own pixels.
        pixel: Edge of such a pixel, in image pixels.
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
    """Return the odd edge of the square that contains the image at any heading, in its own pixels."""
    height, width = image.known.shape
    return int(np.ceil(np.hypot(height, width))) // 2 * 2 + 3


def search(image: EvidenceLevel, pyramid: MapPyramid, space: SearchSpace) -> np.ndarray:
    """Return peaks of each tile and pixel size; one place can occur for several pixel sizes.

    Args:
        image: Coarse evidence.

    Returns:
        (N, 5) float64: score, x, y (meters right and down of the map's corner), heading (°), pixel size (m); best
        first.
    """
    templates = _templates(image, pyramid, space)

    def one_tile(job: tuple[float, _Tile]) -> list[tuple[float, ...]]:
        size_m, tile = job
        return _tile_peaks(pyramid, templates, space, size_m, tile)

    jobs = [
        (size_m, tile)
        for size_m in space.pixel_sizes_m
        for tile in _tiles(space.box_m, size_m * templates.pixel, templates.places)
    ]
    with ThreadPoolExecutor(THREADS) as pool:
        found = list(pool.map(one_tile, jobs))
    peaks = np.array([peak for peaks in found for peak in peaks], np.float64).reshape(-1, 5)
    return peaks[np.argsort(-peaks[:, 0], kind="stable")]


class _Tile(NamedTuple):
    """A part of the searched places: its corner in meters right and down of the map's, and its places along x and y."""

    left: float
    top: float
    columns: int
    rows: int


@dataclass(frozen=True)
class _Templates:
    """The image at every heading, prepared for comparison with a tile.

    Attributes:
        pixel: Edge of a template's pixel, in image pixels.
        edge: Of a template, in its pixels.
        tile_size: Edge of a tile, in such pixels.
        spectra: For each heading and channel, conjugate.
        mask: Spectrum of the mean mask over headings.
        mask_sum: Pixels that it covers.
        quiet: Energy that is added to a footprint's own.
    """

    pixel: float
    edge: int
    tile_size: int
    spectra: list[list[_Spectrum]]
    mask: _Spectrum
    mask_sum: float
    quiet: float

    @property
    def places(self) -> int:
        """Places along an edge of a tile."""
        return self.tile_size - self.edge + 1


def _templates(image: EvidenceLevel, pyramid: MapPyramid, space: SearchSpace) -> _Templates:
    edge = template_edge(image)
    pixel = float(np.sqrt(image.pixel[0] * image.pixel[1]))
    tile_size = _even_size(max(TILE_SIZE, 2 * edge))
    extent = max(space.box_m[2] - space.box_m[0], space.box_m[3] - space.box_m[1])
    needed = int(np.ceil(extent / (pixel * float(space.pixel_sizes_m.min())))) + edge + 1
    tile_size = min(tile_size, _even_size(needed))
    turned = [turn_image(image, heading, edge, pixel) for heading in space.headings_deg]
    spectra = [
        [_Spectrum.of(one.evidence[..., c], tile_size).conjugate() for c in range(one.evidence.shape[2])]
        for one in turned
    ]
    mean_mask = np.mean([one.mask for one in turned], axis=0)
    covered = float(mean_mask.sum())
    mask = _Spectrum.of(mean_mask, tile_size).conjugate()
    return _Templates(pixel, edge, tile_size, spectra, mask, covered, pyramid.quiet * covered)


def _tile_peaks(
    pyramid: MapPyramid, templates: _Templates, space: SearchSpace, size_m: float, tile: _Tile
) -> list[tuple[float, ...]]:
    """Return rows of ``search`` for one tile at one pixel size."""
    pixel_m = size_m * templates.pixel
    scores = _tile_scores(pyramid, templates, pixel_m, (tile.left, tile.top))
    if scores is None:
        return []
    scores = scores[:, : tile.rows, : tile.columns]
    best = scores.max(axis=0)
    return [
        (
            float(best[row, column]),
            tile.left + (column + 0.5) * size_m * templates.pixel,
            tile.top + (row + 0.5) * size_m * templates.pixel,
            float(space.headings_deg[scores[:, row, column].argmax()]),
            float(size_m),
        )
        for row, column in _peaks(best, max(1, templates.edge // 20), pyramid.settings.peaks_per_tile)
    ]


def _tiles(box_m: tuple[float, float, float, float], pixel_m: float, step: int) -> Iterator[_Tile]:
    """Yield tiles that cover the box, with ``step`` places along an edge."""
    columns = max(1, int(np.ceil((box_m[2] - box_m[0]) / pixel_m)))
    rows = max(1, int(np.ceil((box_m[3] - box_m[1]) / pixel_m)))
    for row in range(0, rows, step):
        for column in range(0, columns, step):
            corner = box_m[0] + column * pixel_m, box_m[1] + row * pixel_m
            yield _Tile(*corner, min(step, columns - column), min(step, rows - row))


def _tile_scores(
    pyramid: MapPyramid, templates: _Templates, pixel_m: float, corner_m: tuple[float, float]
) -> np.ndarray | None:
    """Return scores (headings, places, places) of every place of one tile, or None without labels.

    The first place is the pixel with the upper left corner ``corner_m``.
    """
    size, places = templates.tile_size, templates.places
    half = (templates.edge - 1) / 2 * pixel_m
    left, top = corner_m[0] - half, corner_m[1] - half
    # One more pixel on each side, for the interpolation.
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
    tile = [_Spectrum.of(evidence[..., c], size) for c in range(evidence.shape[2])]
    energy = _correlation([_Spectrum.of((evidence**2).sum(axis=2), size)], [templates.mask], places)
    for spectrum in tile:
        energy -= _correlation([spectrum], [templates.mask], places) ** 2 / templates.mask_sum
    share = _correlation([_Spectrum.of(known, size)], [templates.mask], places) / templates.mask_sum
    weight = 1 / np.sqrt(np.maximum(energy, 0) + templates.quiet)
    weight[share < LEAST_KNOWN] = 0
    if not weight.any():
        return None
    scores = np.empty((len(templates.spectra), places, places), np.float32)
    for score, template in zip(scores, templates.spectra):
        np.multiply(_correlation(tile, template, places), weight, out=score)
    return scores


@dataclass(frozen=True)
class _Spectrum:
    """Spectrum of a plane of even edge n, for products in NumPy, which are several times faster than in OpenCV.

    Attributes:
        inner: (n, n / 2 − 1) complex64, the columns that OpenCV packs as pairs of real and imaginary part.
        borders: (2, n) float32, the first and the last column: packed spectra of one dimension.
    """

    inner: np.ndarray
    borders: np.ndarray

    @classmethod
    def of(cls, plane: np.ndarray, size: int) -> _Spectrum:
        """Return the spectrum of a plane in the upper left corner of a ``size`` × ``size`` one."""
        if len(plane) < size:
            padded = np.zeros((size, size), np.float32)
            padded[: plane.shape[0], : plane.shape[1]] = plane
        else:
            padded = np.ascontiguousarray(plane)
        packed = cv2.dft(padded, nonzeroRows=plane.shape[0])
        inner = np.ascontiguousarray(packed[:, 1:-1]).view(np.complex64)
        return cls(inner, np.ascontiguousarray(packed[:, [0, -1]].T))

    def conjugate(self) -> _Spectrum:
        """Return it with conjugate ``inner``, the form of templates."""
        return _Spectrum(np.conj(self.inner), self.borders)


def _correlation(tile: Sequence[_Spectrum], template: Sequence[_Spectrum], places: int) -> np.ndarray:
    """Return (places, places) float32: Σ over channels of the correlation with a template of conjugate spectra."""
    inner = tile[0].inner * template[0].inner
    borders = cv2.mulSpectrums(tile[0].borders, template[0].borders, cv2.DFT_ROWS, conjB=True)
    one_channel = np.empty_like(inner)
    for one, other in zip(tile[1:], template[1:]):
        inner += np.multiply(one.inner, other.inner, out=one_channel)
        borders += cv2.mulSpectrums(one.borders, other.borders, cv2.DFT_ROWS, conjB=True)
    product = np.empty((len(inner), len(inner)), np.float32)
    product[:, 1:-1] = inner.view(np.float32)
    product[:, 0], product[:, -1] = borders
    flags = cv2.DFT_INVERSE | cv2.DFT_SCALE | cv2.DFT_REAL_OUTPUT
    return cv2.dft(product, flags=flags, nonzeroRows=places)[:places, :places]


def _even_size(least: int) -> int:
    """Return the smallest even edge of a tile, ``least`` or more, that is fast for the FFT."""
    return 2 * cv2.getOptimalDFTSize((least + 1) // 2)


def _peaks(score: np.ndarray, radius: int, count: int) -> np.ndarray:
    """Return (M, 2) int rows and columns of the local maxima above 0, best first, at most ``count``."""
    kernel = np.ones((2 * radius + 1, 2 * radius + 1), np.uint8)
    at = np.argwhere((score >= cv2.dilate(score, kernel)) & (score > 0))
    order = np.argsort(-score[at[:, 0], at[:, 1]], kind="stable")
    return at[order[:count]]
