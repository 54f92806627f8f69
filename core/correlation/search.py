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

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import NamedTuple

import cv2
import numpy as np

from .class_pyramid import EvidenceLevel, MapPyramid
from .compare import LEAST_KNOWN

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

    Returns:
        (N, 5) float64: score, x, y (meters right and down of the map's corner), heading (°), pixel size (m); best
        first.
    """
    templates = _templates(image, pyramid, space)

    def one_tile(job: tuple[float, _Tile]) -> np.ndarray:
        size_m, tile = job
        return _tile_peaks(pyramid, templates, space, size_m, tile)

    jobs = [
        (size_m, tile)
        for size_m in space.pixel_sizes_m
        for tile in _tiles(space.box_m, size_m * templates.pixel, templates.places)
    ]
    with ThreadPoolExecutor(THREADS) as pool:
        found = list(pool.map(one_tile, jobs))
    peaks = np.concatenate(found)
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

    Two headings share a complex plane: the correlation of a real tile with both is one complex plane.

    Attributes:
        pixel: Edge of a template's pixel, in image pixels.
        edge: Of a template, in its pixels.
        tile_size: Edge n of a tile, in such pixels.
        spectra: (pairs of headings, C, n, n) complex64.
        mask: (n, n) complex64, of the mean mask over headings.
        mask_sum: Pixels that it covers.
        quiet: Energy that is added to a footprint's own.
    """

    pixel: float
    edge: int
    tile_size: int
    spectra: np.ndarray
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
    tile_size = _even_size(max(TILE_SIZE, 2 * edge))
    extent = max(space.box_m[2] - space.box_m[0], space.box_m[3] - space.box_m[1])
    needed = int(np.ceil(extent / (pixel * float(space.pixel_sizes_m.min())))) + edge + 1
    tile_size = min(tile_size, _even_size(needed))
    turned = [turn_image(image, heading, edge, pixel) for heading in space.headings_deg]
    mean_mask = np.mean([one.mask for one in turned], axis=0)
    # The last of an odd number of headings is its own partner. The conjugate spectrum of a − ib gives the correlations
    # with a and b as real and imaginary part.
    planes = np.moveaxis(np.array([one.evidence for one in [*turned, turned[-1]]]), 3, 1)
    pairs = planes[0:-1:2] - 1j * planes[1::2]
    spectra = np.array([[_template(plane, tile_size) for plane in pair] for pair in pairs])
    covered = float(mean_mask.sum())
    mask = _template(mean_mask, tile_size)
    return _Templates(pixel, edge, tile_size, spectra, mask, covered, pyramid.quiet * covered)


def _template(plane: np.ndarray, size: int) -> np.ndarray:
    """Return (size, size) complex64, the conjugate spectrum of a plane in the upper left corner."""
    padded = np.zeros((size, size), np.complex64)
    padded[: plane.shape[0], : plane.shape[1]] = plane
    return np.conj(_transform(padded))


def _transform(plane: np.ndarray, flags: int = 0) -> np.ndarray:
    """Return the spectrum of an (n, n) complex64 plane, or the plane of a spectrum."""
    both = cv2.dft(plane.view(np.float32).reshape(*plane.shape, 2), flags=flags)
    return both.view(np.complex64)[..., 0]


def _tile_peaks(
    pyramid: MapPyramid, templates: _Templates, space: SearchSpace, size_m: float, tile: _Tile
) -> np.ndarray:
    """Return rows of ``search``, (N, 5), for one tile at one pixel size."""
    pixel_m = size_m * templates.pixel
    found = _tile_scores(pyramid, templates, pixel_m, (tile.left, tile.top))
    if found is None:
        return np.empty((0, 5))
    products, weight = found
    best = products[0]
    for product in products[1:]:
        best = cv2.max(best, product)
    best = (np.maximum(best[..., 0], best[..., 1]) * weight)[: tile.rows, : tile.columns]
    rows, columns = _peaks(best, max(1, templates.edge // 20), pyramid.settings.peaks_per_tile)
    # (turns, N) products at the peaks.
    turned = np.moveaxis(np.array([one[rows, columns] for one in products]), 2, 1).reshape(2 * len(products), -1)
    headings = space.headings_deg[turned[: len(space.headings_deg)].argmax(axis=0)]
    x, y = tile.left + (columns + 0.5) * size_m * templates.pixel, tile.top + (rows + 0.5) * size_m * templates.pixel
    return np.column_stack([best[rows, columns], x, y, headings, np.full(len(rows), size_m)])


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
) -> tuple[list[np.ndarray], np.ndarray] | None:
    """Return the products of every place of one tile, and the weights that make scores of them; None without labels.

    The first place is the pixel with the upper left corner ``corner_m``.

    Returns:
        (places, places, 2) float32 for each pair of headings, and (places, places) float32.
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
    evidence = cv2.warpAffine(level.evidence, matrix, (size, size), flags=flags)
    channels = cv2.split(evidence)
    tile = np.empty((len(channels), size, size), np.complex64)
    for channel, spectrum in zip(channels, tile.view(np.float32).reshape(*tile.shape, 2)):
        cv2.dft(channel, spectrum, cv2.DFT_COMPLEX_OUTPUT)

    def plane_of(spectrum: np.ndarray) -> np.ndarray:
        """Return (places, places, 2): real and imaginary part of the plane of a spectrum."""
        found = _transform(spectrum, cv2.DFT_INVERSE | cv2.DFT_SCALE)
        return found.view(np.float32).reshape(size, size, 2)[:places, :places]

    energy = np.sum([channel * channel for channel in channels], axis=0)
    both = cv2.merge([energy, known]).view(np.complex64)[..., 0]
    energy, share = cv2.split(plane_of(_transform(both) * templates.mask))
    for channel in range(0, len(tile), 2):
        pair = tile[channel] if channel + 1 == len(tile) else tile[channel] + 1j * tile[channel + 1]
        sums = plane_of(pair * templates.mask)
        energy -= np.einsum("ijk,ijk->ij", sums, sums) / templates.mask_sum
    weight = 1 / np.sqrt(np.maximum(energy, 0) + templates.quiet)
    weight[share / templates.mask_sum < LEAST_KNOWN] = 0
    if not weight.any():
        return None
    return [plane_of(np.einsum("cij,cij->ij", tile, template)) for template in templates.spectra], weight


def _even_size(least: int) -> int:
    """Return the smallest even edge of a tile, ``least`` or more, that is fast for the FFT."""
    return 2 * cv2.getOptimalDFTSize((least + 1) // 2)


def _peaks(score: np.ndarray, radius: int, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return (M,) rows and columns of the local maxima above 0, best first, at most ``count``."""
    kernel = np.ones((2 * radius + 1, 2 * radius + 1), np.uint8)
    at = np.flatnonzero((score >= cv2.dilate(score, kernel)) & (score > 0))
    order = np.argsort(-score.ravel()[at], kind="stable")
    return np.divmod(at[order[:count]], score.shape[1])
