"""Class fractions of label rasters at increasingly coarse pixels, which map correlation compares.

See docs/explanation/method.md#map-correlation.

For each class, a label raster becomes the fraction of each coarse pixel that the class covers. Area overlap is robust
where centers of gravity are not: merged houses, boundary jitter, missing roads. Pixels without a label count neither
for nor against a class, so that the edge of a map is not its most distinctive feature. On a map with a single class
they count as a class of their own.

Fractions are not compared class by class but as *evidence*: at most ``MAXIMUM_CHANNELS`` numbers per pixel. Evidence is
the fractions minus their mean on this map, weighted by the information of each class, and projected to the few
directions of largest variance (principal components). The time is therefore the same for 5 and for 200 classes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np

from ..geometry.frame import MapFrame
from ..labels.class_shares import FULL, ClassShares
from ..labels.class_table import UNLABELED
from .settings import CORRELATION, CorrelationSettings

MAXIMUM_CHANNELS = 4
"""Evidence channels; OpenCV's samplers process four at once."""

STORED_REDUCTION = 4
"""Evidence is stored from this reduction of the overview on; finer levels are computed when needed."""

KEPT_PIXELS = 2_000_000
"""Of an overview with at most so many pixels, finer levels are kept in memory, up to 25 bytes per pixel."""


@dataclass(frozen=True)
class ClassSpace:
    """Projection from the labels of a map to evidence. K classes, C ≤ MAXIMUM_CHANNELS channels.

    Attributes:
        values: (K,) uint8, class values of the map; 0 (unlabeled) only beside a single class.
        usual: (K,) float64, share of the labeled area that each class covers.
        projection: (C, K) float32, evidence of fractions minus the usual ones.
    """

    values: np.ndarray
    usual: np.ndarray
    projection: np.ndarray

    @property
    def channels(self) -> int:
        """Channels of evidence, C; 0 if the map contains no information."""
        return len(self.projection)


@dataclass(frozen=True)
class EvidenceLevel:
    """Evidence on a grid.

    Attributes:
        evidence: (H, W, C) float32, 0 without labels.
        known: (H, W) float32, labeled share of each pixel.
        pixel: (x, y) edges of a pixel in the unit of the raster: meters for a map, pixels for an image.
        picture: (H, W, 3) uint8 of a photo; None for a map and an image of labels.
        has_edges: The last two channels are the directions of its edges (``outlines.with_edges``).
    """

    evidence: np.ndarray
    known: np.ndarray
    pixel: tuple[float, float]
    picture: np.ndarray | None = None
    has_edges: bool = False

    @cached_property
    def centered(self) -> np.ndarray:
        """(H, W · C) evidence minus the mean of each channel."""
        return centered(self.evidence)

    @cached_property
    def least_known(self) -> float:
        """Smallest labeled share of a pixel."""
        return float(self.known.min())


def centered(planes: np.ndarray, weights: np.ndarray | None = None) -> np.ndarray:
    """Return (…, H, W · C) of (…, H, W, C) float32 planes, minus the mean of each channel over its pixels.

    All channels of a row are in one axis: loops over a few channels take longer than the arithmetic.

    Args:
        planes: Multiplied by the weights.
        weights: (H, W) of pixels; None if all are 1.
    """
    *_, height, width, channels = planes.shape
    sums, rows = np.einsum("...hwc->...c", planes), planes.reshape(*planes.shape[:-2], -1)
    if weights is None:
        return rows - np.tile(sums / np.float32(height * width), width)[..., None, :]
    means = np.tile(sums / np.float32(max(float(weights.sum()), 1e-6)), width)
    return rows - np.repeat(weights, channels, axis=1) * means


def class_fractions(labels_hw: np.ndarray, values: Sequence[int] | np.ndarray, size_wh: tuple[int, int]) -> np.ndarray:
    """Return (h, w, K) uint8: the share of each coarse pixel (``FULL`` = all of it) that each class covers.

    Args:
        labels_hw: (H, W) uint8 labels.
        values: (K,) class values.
        size_wh: (w, h), coarse pixels along x and y, at most those of the raster; pixel edges need not coincide.
    """
    fractions = np.zeros((size_wh[1], size_wh[0], len(values)), np.uint8)
    for index, value in enumerate(values):
        # FULL where the label is the value; ``cv2.compare`` fails for a raster of one pixel.
        covered = cv2.inRange(labels_hw, int(value), int(value))
        if cv2.countNonZero(covered):
            fractions[..., index] = cv2.resize(covered, size_wh, interpolation=cv2.INTER_AREA)
    return fractions


def class_space(fractions: np.ndarray, values: np.ndarray, rarity_exponent: float) -> ClassSpace:
    """Return the class space of a map; without labeled pixels it has no channels.

    Args:
        fractions: (h, w, K) uint8, coarse ones of the map.
        values: (K,) uint8, its class values.
        rarity_exponent: As of CorrelationSettings.
    """
    pixels = fractions.reshape(fractions.shape[0] * fractions.shape[1], len(values))
    pixels = pixels[pixels.any(axis=1)].astype(np.float64) / FULL
    if not len(pixels):
        return ClassSpace(values, np.zeros(len(values)), np.zeros((0, len(values)), np.float32))
    known = pixels.sum(axis=1)
    usual = pixels.sum(axis=0) / known.sum()
    surprise = pixels - known[:, None] * usual
    covariance = surprise.T @ surprise / len(surprise)
    weights = np.maximum(np.diag(covariance), 1e-9) ** (-rarity_exponent / 2)
    strength, directions = np.linalg.eigh(covariance * weights[:, None] * weights)
    used = np.argsort(-strength, kind="stable")[:MAXIMUM_CHANNELS]
    used = used[strength[used] > 1e-9 * max(strength.max(), 1e-12)]
    projection = directions[:, used].T * weights
    # The sign of an eigenvector depends on the linear algebra library: fix it.
    projection *= np.sign(projection[np.arange(len(used)), np.abs(projection).argmax(axis=1)])[:, None]
    return ClassSpace(values, usual, projection.astype(np.float32))


def evidence_of(fractions: np.ndarray, space: ClassSpace) -> tuple[np.ndarray, np.ndarray]:
    """Return evidence = projection · (fraction − labeled share × usual fraction), 0 without labels.

    Args:
        fractions: (h, w, K) uint8.

    Returns:
        Evidence (h, w, C) float32 and labeled share (h, w) float32.
    """
    # projection · (f − usual · Σf) is linear in f; the last row gives the labeled share.
    matrix = np.vstack([space.projection - (space.projection @ space.usual)[:, None], np.ones(len(space.values))])
    height, width, count = fractions.shape
    pixels = fractions.reshape(height * width, count).astype(np.float32)
    # OpenCV's product: that of BLAS would start threads that keep spinning.
    both = cv2.gemm(pixels, np.ascontiguousarray(matrix.T / FULL, np.float32), 1, None, 0)
    both = both.reshape(height, width, space.channels + 1)
    return np.ascontiguousarray(both[..., :-1]), np.ascontiguousarray(both[..., -1])


def evidence_level(labels_hw: np.ndarray, space: ClassSpace, size_wh: tuple[int, int]) -> EvidenceLevel:
    """Return a label raster's evidence at coarse pixels; its ``pixel`` is in pixels of the raster.

    Args:
        labels_hw: (H, W) uint8 labels.
        size_wh: Coarse pixels along x and y.
    """
    evidence, known = evidence_of(class_fractions(labels_hw, space.values, size_wh), space)
    return EvidenceLevel(evidence, known, (labels_hw.shape[1] / size_wh[0], labels_hw.shape[0] / size_wh[1]))


def evidence_of_shares(shares: ClassShares, space: ClassSpace, shape_hw: tuple[int, int]) -> EvidenceLevel:
    """Return the evidence of an image of that shape from the probable shares of its classes, on their grid."""
    evidence, known = evidence_of(shares.of(space.values), space)
    height, width = known.shape
    return EvidenceLevel(evidence, known, (shape_hw[1] / width, shape_hw[0] / height), shares.picture)


def reduce_level(level: EvidenceLevel, size_wh: tuple[int, int]) -> EvidenceLevel:
    """Return the evidence on fewer, larger pixels: means of areas, because evidence is linear in the fractions."""
    height, width = level.known.shape
    if size_wh == (width, height):
        return level
    evidence = cv2.resize(level.evidence, size_wh, interpolation=cv2.INTER_AREA)
    known = cv2.resize(level.known, size_wh, interpolation=cv2.INTER_AREA)
    pixel = level.pixel[0] * width / size_wh[0], level.pixel[1] * height / size_wh[1]
    picture = None if level.picture is None else cv2.resize(level.picture, size_wh, interpolation=cv2.INTER_AREA)
    return EvidenceLevel(evidence.reshape(*known.shape, -1), known, pixel, picture)


def mirror_level(level: EvidenceLevel) -> EvidenceLevel:
    """Return the evidence with left and right exchanged."""
    evidence, known = (np.ascontiguousarray(plane[:, ::-1]) for plane in (level.evidence, level.known))
    picture = None if level.picture is None else np.ascontiguousarray(level.picture[:, ::-1])
    return EvidenceLevel(evidence, known, level.pixel, picture)


PyramidParts = dict[str, np.ndarray]
"""Arrays of a pyramid by name."""


def pyramid_parts(labels_hw: np.ndarray, rarity_exponent: float) -> PyramidParts:
    """Return the arrays of a pyramid that take time to compute, by name.

    Args:
        labels_hw: (H, W) uint8, a map's overview.
        rarity_exponent: As of CorrelationSettings.
    """
    values = np.unique(labels_hw)
    if (values != UNLABELED).sum() > 1:
        # On a map with a single class, ground without a label is the other class.
        values = values[values != UNLABELED]
    # Whole blocks only: padding counts as unlabeled.
    block = STORED_REDUCTION
    height, width = labels_hw.shape
    padded = cv2.copyMakeBorder(labels_hw, 0, -height % block, 0, -width % block, cv2.BORDER_CONSTANT, value=0)
    fractions = class_fractions(padded, values, (padded.shape[1] // block, padded.shape[0] // block))
    space = class_space(_halve(_halve(fractions)), values, rarity_exponent)
    parts = {"values": space.values, "usual": space.usual, "projection": space.projection}
    levels: list[tuple[np.ndarray, np.ndarray]] = []
    while space.channels and min(fractions.shape[:2]) >= 1:
        levels.append(evidence_of(fractions, space))
        if min(fractions.shape[:2]) < 2:
            break
        fractions = _halve(fractions)
    for number, (evidence, known) in enumerate(levels):
        parts |= {f"evidence_{number}": evidence, f"known_{number}": known}
    parts["energy"] = np.array([_mean_energy(*levels[min(1, len(levels) - 1)]) if levels else 0.0])
    return parts


def _mean_energy(evidence: np.ndarray, known: np.ndarray) -> float:
    """Return the mean, over the labeled map, of the squared evidence, summed over channels."""
    labeled = known > 0.5
    return float((evidence[labeled] ** 2).sum(axis=1).mean()) if labeled.any() else 0.0


class MapPyramid:
    """A map's evidence at pixels of 1, 2, 4, … overview pixels, prepared once for all queries.

    Levels from STORED_REDUCTION on are computed beforehand (C·4 bytes per pixel, a quarter of the pixels each) and
    stored in memory or mapped from a file. Finer levels are computed when needed, of a large map only the crop.
    """

    def __init__(
        self,
        overview_hw: np.ndarray,
        frame: MapFrame,
        settings: CorrelationSettings = CORRELATION,
        parts: PyramidParts | None = None,
    ) -> None:
        """Prepare an overview.

        Args:
            overview_hw: (H, W) uint8 labels.
            frame: Grid of its pixels.
            settings: Of the pyramid and of every search in it.
            parts: Of ``pyramid_parts`` of this overview; None to compute them.
        """
        self.labels = np.ascontiguousarray(overview_hw)
        self.frame = frame
        self.settings = settings
        parts = pyramid_parts(self.labels, settings.rarity_exponent) if parts is None else parts
        self.space = ClassSpace(parts["values"], parts["usual"], parts["projection"])
        self.energy = float(parts["energy"][0])
        self._levels: dict[int, EvidenceLevel] = {}
        finest = self._count = int(np.log2(STORED_REDUCTION))
        while (evidence := parts.get(f"evidence_{self._count - finest}")) is not None:
            pixel = self.frame.pixel_size * 2**self._count
            known = parts[f"known_{self._count - finest}"]
            self._levels[self._count] = EvidenceLevel(evidence, known, (pixel, pixel))
            self._count += 1

    @property
    def quiet(self) -> float:
        """Energy per pixel that is added to the map's own in a score."""
        return self.settings.quiet_energy * self.energy

    @property
    def size_m(self) -> tuple[float, float]:
        """Width and height of the map, m."""
        return self.labels.shape[1] * self.frame.pixel_size, self.labels.shape[0] * self.frame.pixel_size

    def level_of(self, pixel_m: float) -> int:
        """Return the level with pixels nearest to ``pixel_m`` (×0.71 to ×1.41); its reduction is 2 ** level."""
        return int(self.levels_of(np.array([pixel_m]))[0])

    def levels_of(self, pixels_m: np.ndarray) -> np.ndarray:
        """Return (N,) int levels of N pixel sizes, see ``level_of``."""
        levels = np.round(np.log2(pixels_m / self.frame.pixel_size)).astype(int)
        return np.clip(levels, 0, self._count - 1)

    def whole(self, level: int) -> EvidenceLevel | None:
        """Return the whole map at a level; None if only crops of it are computed."""
        found = self._levels.get(level)
        if found is None and self.labels.size <= KEPT_PIXELS:
            height, width = self._size_hw(level)
            found = self._levels[level] = self._computed(level, 0, 0, width, height)
        return found

    def crop(self, pixel_m: float, box_m: tuple[float, float, float, float]) -> tuple[EvidenceLevel, float, float]:
        """Return the level with the nearest pixel size (×0.71 to ×1.41), cut to a box.

        Args:
            pixel_m: Edge of a pixel, meters.
            box_m: (left, top, right, bottom) in meters right and down from the map's upper left corner.

        Returns:
            The level, and the left and top edge of its first pixel in meters. Never empty: a box beside the map gives
            one unknown pixel.
        """
        level = self.level_of(pixel_m)
        pixel = self.frame.pixel_size * 2**level
        height, width = self._size_hw(level)
        left, top = (max(math.floor(edge / pixel), 0) for edge in box_m[:2])
        right, bottom = (min(math.ceil(edge / pixel), size) for edge, size in zip(box_m[2:], (width, height)))
        if left >= right or top >= bottom:
            nothing = np.zeros((1, 1), np.float32)
            return EvidenceLevel(np.zeros((1, 1, self.space.channels), np.float32), nothing, (pixel, pixel)), 0.0, 0.0
        whole = self.whole(level)
        if whole is None:
            part = self._computed(level, left, top, right, bottom)
        else:
            cut = np.s_[top:bottom, left:right]
            part = EvidenceLevel(whole.evidence[cut], whole.known[cut], whole.pixel)
        return part, left * pixel, top * pixel

    def _size_hw(self, level: int) -> tuple[int, int]:
        height, width = self.labels.shape
        return -(-height // 2**level), -(-width // 2**level)

    def _computed(self, level: int, left: int, top: int, right: int, bottom: int) -> EvidenceLevel:
        """Return a part of a level in its pixels; beyond the map is unlabeled."""
        reduction = 2**level
        labels = self.labels[top * reduction : bottom * reduction, left * reduction : right * reduction]
        labels = cv2.copyMakeBorder(
            labels, 0, -labels.shape[0] % reduction, 0, -labels.shape[1] % reduction, cv2.BORDER_CONSTANT, value=0
        )
        fractions = class_fractions(labels, self.space.values, (right - left, bottom - top))
        pixel = self.frame.pixel_size * reduction
        return EvidenceLevel(*evidence_of(fractions, self.space), (pixel, pixel))


def _halve(fractions: np.ndarray) -> np.ndarray:
    """Return (⌈h/2⌉, ⌈w/2⌉, K) uint8: means of 2 × 2 pixels; beyond the edge is unlabeled."""
    height, width, count = fractions.shape
    halved = np.empty((-(-height // 2), -(-width // 2), count), np.uint8)
    for index in range(count):
        plane = cv2.copyMakeBorder(
            np.ascontiguousarray(fractions[..., index]), 0, height % 2, 0, width % 2, cv2.BORDER_CONSTANT, value=0
        )
        halved[..., index] = cv2.resize(plane, halved.shape[1::-1], interpolation=cv2.INTER_AREA)
    return halved
