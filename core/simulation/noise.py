"""THE engine that spoils simulated images: errors of segmentation, and of annotations, on labels and on landmarks.

Two things are spoiled, by the same ``LabelNoise``: label images (``spoil_labels``) and, where nothing but a catalogue
is there to be seen, landmarks (``spoil_landmarks``, ``with_moved_boundaries``). The steps on labels follow the order in
which errors happen: landmarks are missed, mislabeled, or spurious; near ones flow together, long ones break; thin parts
vanish; boundaries wander; whole patches get another class. Every step is left out by giving it 0.

Every function takes its random generator, so a seed repeats an image.

Example:
    >>> noise = LabelNoise(missed=0.2, spurious=0.2, mislabeled=0.05, jitter=1.0)   # lengths in map units
    >>> labels_hw = spoil_labels(labels_hw, noise.in_pixels(pixel_size), rng, (1, 2, 3), donor_hw)
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace

import cv2
import numpy as np

from ..errors import ParameterError
from ..landmarks.landmarks import Landmarks, class_mask

JITTER_LENGTH_PX = 8.0
"""Over what length boundaries move alike, unless a noise states its own."""

MERGED_LENGTH_PX = 100.0
"""Size of the parts of an image in which landmarks flow together, where they do so in a share of it."""

PLACES_TRIED = 20
"""A spurious landmark is left out when so many random places of the image have no room for it."""

LARGEST_KERNEL_PX = 61
"""Morphology with larger ellipses is done on that size; keeps the time bounded on very fine images."""

CENTER_SHARE, CENTER_LENGTHS = 0.66, 7.5
"""Boundaries moved by σ move the center of a landmark of size s = √area by CENTER_SHARE · σ / √(1 + s / (CENTER_LENGTHS
· JITTER_LENGTH_PX)) along each axis. Measured on Liechtenstein 2021 with σ of 1, 2 and 3 px, s of 10 to 150 px."""

AREA_SHARE = 1.8
"""The same boundaries change ln area with a standard deviation of AREA_SHARE · σ / s; measured on the same images."""

SAMPLING_AREA = 0.05
"""Standard deviation of ln area that turning and sampling an image brings by itself; measured on the same images."""

_SHARES = ("missed", "spurious", "mislabeled", "merge_share", "split", "patches")


@dataclass(frozen=True)
class LabelNoise:
    """How poor the labels of an image are. Lengths are in map units, or in pixels after ``in_pixels``.

    Attributes:
        missed: share of the landmarks that are missed, 0…1
        spurious: landmarks added that are not there, as a share of those that are, 0…1
        mislabeled: share of the landmarks that get another class
        jitter: standard deviation of the boundaries' displacement, along each axis
        jitter_length: over what length boundaries move alike; None for JITTER_LENGTH_PX, whatever the pixels
        missed_below: only landmarks of a smaller area are missed
        merge_gap: gaps between landmarks of a class up to this width are filled
        merge_share: share of the image in which they are
        split: chance that a landmark is cut across
        split_length: only longer landmarks are
        split_gap: width of the cut
        thin: narrower parts of any class are lost
        patches: share of the area that gets random classes, in whole patches
        patch_size: about the edge of such a patch
        center: of landmarks alone, standard deviation of the center along each axis
        log_area: of landmarks alone, standard deviation of ln area

    Raises:
        ParameterError: for a negative value, a share above 1, and what is no number.
    """

    missed: float = 0.0
    spurious: float = 0.0
    mislabeled: float = 0.0
    jitter: float = 0.0
    jitter_length: float | None = None
    missed_below: float = math.inf
    merge_gap: float = 0.0
    merge_share: float = 1.0
    split: float = 0.0
    split_length: float = 0.0
    split_gap: float = 3.0
    thin: float = 0.0
    patches: float = 0.0
    patch_size: float = 80.0
    center: float = 0.0
    log_area: float = 0.0

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            most = 1.0 if field.name in _SHARES else math.inf
            is_bounded = value is None or value < math.inf or field.name == "missed_below"
            if not is_bounded or value is not None and not 0 <= value <= most:
                raise ParameterError("simulation.noise", name=field.name, value=value, most=most)

    def in_pixels(self, pixel_size: float) -> LabelNoise:
        """The same noise, its lengths and areas in pixels of ``pixel_size`` map units."""
        lengths = ("jitter", "merge_gap", "split_length", "split_gap", "thin", "patch_size", "center")
        changed = {name: getattr(self, name) / pixel_size for name in lengths}
        if self.jitter_length is not None:
            changed["jitter_length"] = self.jitter_length / pixel_size
        return replace(self, **changed, missed_below=self.missed_below / pixel_size**2)

    @property
    def changes_landmarks(self) -> bool:
        """Whether landmarks are missed, spurious or mislabeled."""
        return self.missed > 0 or self.spurious > 0 or self.mislabeled > 0


USUAL = LabelNoise(missed=0.2, spurious=0.2, mislabeled=0.05, jitter=1.0)
"""What assessments and evaluations assume unless they are told otherwise; in meters."""

_NETWORK = LabelNoise(missed_below=200.0, split_length=40.0)

MODEST = replace(_NETWORK, merge_gap=6, split=0.2, jitter=3, jitter_length=9, patches=0.15, thin=4, missed=0.15)
"""A usable network, in meters, seen on aerial tiles with an IoU of buildings near 0.5: houses merged, boundaries off by
3 m, 15 % of the area in a random class."""

STRONG = replace(_NETWORK, merge_gap=10, split=0.4, jitter=6, jitter_length=18, patches=0.35, thin=8, missed=0.4)
"""A poor network, in meters: boundaries off by 6 m, 35 % of the area in a random class, four small landmarks of ten
missed."""


# --- label images ---


def spoil_labels(  # noqa: PLR0913 - an image, how it is spoiled, and what is known of its classes
    labels_hw: np.ndarray,
    noise: LabelNoise,
    rng: np.random.Generator,
    class_values: Sequence[int],
    donor_hw: np.ndarray | None = None,
    minimum_area_px: float = 1.0,
) -> np.ndarray:
    """A label image as a network, or an annotator, with these errors would have given it.

    Args:
        labels_hw: (H, W) uint8; stays as it is
        noise: in pixels of the image
        rng: a seeded one repeats the image
        class_values: classes made of landmarks; landmarks are missed, added, mislabeled, merged and split only there
        donor_hw: labels of another place at the same scale, whose landmarks are the spurious ones; None for none
        minimum_area_px: smaller regions are no landmarks

    Returns:
        (H, W) uint8. Random classes are drawn from those the image has, so an image of one class stays what it is.
    """
    labels = labels_hw.copy()
    if not labels.size:
        return labels
    if donor_hw is not None or noise.changes_landmarks:
        labels = _with_changed_landmarks(labels, noise, rng, class_values, donor_hw, minimum_area_px)
    for value in class_values:
        labels = _merged(labels, value, noise, rng)
        labels = _split(labels, value, noise, rng)
    labels = _without_thin_parts(labels, noise.thin)
    if noise.jitter > 0:
        labels = _displaced(labels, noise.jitter, noise.jitter_length or JITTER_LENGTH_PX, rng)
    return _with_swapped_patches(labels, noise, rng)


@dataclass(frozen=True)
class _Region:
    """A connected region of one class.

    Attributes:
        value: Its class.
        area_px: Pixels.
        box: Its bounding box as slices (rows, columns).
        mask: (h, w) bool, its pixels in the box.
    """

    value: int
    area_px: int
    box: tuple[slice, slice]
    mask: np.ndarray


def _regions(labels_hw: np.ndarray, class_values: Sequence[int], minimum_area_px: float) -> list[_Region]:
    found = []
    for value in class_values:
        _, numbers, stats, _ = cv2.connectedComponentsWithStats(class_mask(labels_hw, value))
        for number in range(1, len(stats)):
            left, top, width, height, area = stats[number]
            if area >= minimum_area_px:
                box = (slice(top, top + height), slice(left, left + width))
                found.append(_Region(int(value), int(area), box, numbers[box] == number))
    return found


def _with_changed_landmarks(  # noqa: PLR0913 - as spoil_labels
    labels_hw: np.ndarray,
    noise: LabelNoise,
    rng: np.random.Generator,
    class_values: Sequence[int],
    donor_hw: np.ndarray | None,
    minimum_area_px: float,
) -> np.ndarray:
    """Missed landmarks get the nearest label of no landmark; spurious ones lie where they touch no other."""
    regions = _regions(labels_hw, class_values, minimum_area_px)
    missed = rng.random(len(regions)) < noise.missed
    missed &= np.array([region.area_px < noise.missed_below for region in regions], bool)
    classes = _mislabeled(np.array([r.value for r in regions]), np.unique(class_values), noise.mislabeled, rng)
    count = rng.binomial(len(regions), min(noise.spurious, 1.0))
    spoiled, lost = labels_hw.copy(), np.zeros(labels_hw.shape, bool)
    for region, is_missed, value in zip(regions, missed, classes):
        if is_missed:
            lost[region.box] |= region.mask
        else:
            spoiled[region.box][region.mask] = value
    spoiled = _filled_from_around(spoiled, lost, ~np.isin(labels_hw, class_values))
    if donor_hw is not None:
        _draw_spurious(spoiled, _regions(donor_hw, class_values, minimum_area_px), count, rng, class_values)
    return spoiled


def _draw_spurious(
    labels_hw: np.ndarray, donors: list[_Region], count: int, rng: np.random.Generator, class_values: Sequence[int]
) -> None:
    """Draws ``count`` of the donors into ``labels_hw`` itself, each with a margin of a pixel to other landmarks."""
    taken = np.isin(labels_hw, class_values)
    for number in rng.integers(0, len(donors), count if donors else 0):
        mask = np.pad(donors[number].mask, 1)
        around = cv2.dilate(mask.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
        rows, columns = (whole - part + 1 for whole, part in zip(labels_hw.shape, mask.shape))
        if rows < 1 or columns < 1:
            continue
        for top, left in zip(rng.integers(0, rows, PLACES_TRIED), rng.integers(0, columns, PLACES_TRIED)):
            box = np.s_[top : top + mask.shape[0], left : left + mask.shape[1]]
            if not (taken[box] & around).any():
                labels_hw[box][mask] = donors[number].value
                taken[box] |= mask
                break


def _mislabeled(classes: np.ndarray, known: np.ndarray, share: float, rng: np.random.Generator) -> np.ndarray:
    """Classes of which a share is changed to any other known class."""
    if len(known) < 2:
        return classes
    step = rng.integers(1, len(known), len(classes))
    other = known[(np.searchsorted(known, classes) + step) % len(known)]
    return np.where(rng.random(len(classes)) < share, other, classes).astype(np.uint8)


def _merged(labels_hw: np.ndarray, value: int, noise: LabelNoise, rng: np.random.Generator) -> np.ndarray:
    """Gaps between regions of class ``value`` get that class, in a share of the image (morphological closing)."""
    kernel = _ellipse(noise.merge_gap)
    if kernel is None:
        return labels_hw
    closed = cv2.morphologyEx(
        class_mask(labels_hw, value), cv2.MORPH_CLOSE, kernel, borderType=cv2.BORDER_REPLICATE
    ).astype(bool)
    if noise.merge_share < 1:
        field = _smooth_noise(labels_hw.shape, MERGED_LENGTH_PX, rng)
        closed &= field <= np.quantile(field, noise.merge_share)
    return np.where(closed, np.uint8(value), labels_hw)


def _split(labels_hw: np.ndarray, value: int, noise: LabelNoise, rng: np.random.Generator) -> np.ndarray:
    """Long regions of class ``value`` are cut across, in their middle third, into what lies around."""
    if noise.split <= 0:
        return labels_hw
    mask = class_mask(labels_hw, value)
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    cuts = np.zeros_like(mask)
    for contour, is_cut in zip(contours, rng.random(len(contours)) < noise.split):
        corners = cv2.boxPoints(cv2.minAreaRect(contour))
        edges = np.roll(corners, -1, axis=0) - corners
        lengths = np.hypot(edges[:, 0], edges[:, 1])
        longest = int(lengths.argmax())
        if not is_cut or lengths[longest] < noise.split_length:
            continue
        at = corners[longest] + edges[longest] * rng.uniform(1 / 3, 2 / 3)
        start, end = (tuple(int(v) for v in np.rint(point)) for point in (at, at + edges[(longest + 1) % 4]))
        cv2.line(cuts, start, end, 1, max(1, int(round(noise.split_gap))))
    return _filled_from_around(labels_hw, (cuts & mask) > 0, labels_hw != value)


def _without_thin_parts(labels_hw: np.ndarray, width_px: float) -> np.ndarray:
    """Parts of any class narrower than ``width_px`` get the class of what is left nearest (opening of each class)."""
    kernel = _ellipse(width_px)
    if kernel is None:
        return labels_hw
    kept = np.zeros(labels_hw.shape, bool)
    for value in np.unique(labels_hw):
        mask = (labels_hw == value).astype(np.uint8)
        kept |= cv2.morphologyEx(mask, cv2.MORPH_OPEN, kernel, borderType=cv2.BORDER_REPLICATE) > 0
    return _filled_from_around(labels_hw, ~kept, kept)


def _with_swapped_patches(labels_hw: np.ndarray, noise: LabelNoise, rng: np.random.Generator) -> np.ndarray:
    """Patches that cover a share of the area get a random class of the image each, which may be the right one.

    The patches are cells around random points, with wandering boundaries; whole cells are taken in random order until
    the share is reached.
    """
    height, width = labels_hw.shape
    values = np.unique(labels_hw)
    if noise.patches <= 0 or len(values) < 2:
        return labels_hw
    size_px = max(noise.patch_size, 1.0)
    count = int(np.ceil(4 * height * width / size_px**2))
    points = np.full((height, width), 255, np.uint8)
    points[rng.integers(0, height, count), rng.integers(0, width, count)] = 0
    cells = _displaced(_nearest_zero(points).astype(np.float32), size_px / 10, 0.3 * size_px, rng).astype(int)
    areas = np.bincount(cells.ravel())
    order = rng.permutation(len(areas))
    taken = np.zeros(len(areas), bool)
    taken[order[np.cumsum(areas[order]) <= noise.patches * height * width]] = True
    classes = rng.choice(values, len(areas)).astype(np.uint8)
    return np.where(taken[cells], classes[cells], labels_hw).astype(np.uint8)


def _displaced(image_hw: np.ndarray, sigma_px: float, length_px: float, rng: np.random.Generator) -> np.ndarray:
    """(H, W) ``image_hw`` read at places displaced by ``sigma_px`` along each axis, alike over ``length_px``."""
    columns, rows = np.meshgrid(*(np.arange(size, dtype=np.float32) for size in image_hw.shape[::-1]))
    columns += sigma_px * _smooth_noise(image_hw.shape, length_px, rng)
    rows += sigma_px * _smooth_noise(image_hw.shape, length_px, rng)
    return cv2.remap(image_hw, columns, rows, cv2.INTER_NEAREST, borderMode=cv2.BORDER_REPLICATE)


def _smooth_noise(shape_hw: tuple[int, ...], length_px: float, rng: np.random.Generator) -> np.ndarray:
    """(H, W) float32 of variance 1, alike over about ``length_px``: white noise on a coarse grid, enlarged."""
    small = tuple(max(int(np.ceil(size / max(length_px, 1.0))) + 1, 2) for size in shape_hw)
    field = rng.normal(size=small).astype(np.float32)
    field = cv2.resize(field, (shape_hw[1], shape_hw[0]), interpolation=cv2.INTER_CUBIC)
    return field / max(float(field.std()), 1e-6)


def _ellipse(diameter_px: float) -> np.ndarray | None:
    """Structuring element of about that diameter, odd so that nothing is shifted; None when it would do nothing."""
    size = min(2 * int(round((diameter_px - 1) / 2)) + 1, LARGEST_KERNEL_PX)
    return None if size < 3 else cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))


def _nearest_zero(image_hw: np.ndarray) -> np.ndarray:
    """(H, W) int: index of the nearest zero pixel of ``image_hw``, counted from 0 in order of rows."""
    _, index = cv2.distanceTransformWithLabels(image_hw, cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL)
    return index - 1


def _filled_from_around(labels_hw: np.ndarray, lost: np.ndarray, sources: np.ndarray) -> np.ndarray:
    """``labels_hw`` where ``lost`` pixels have the label of the nearest pixel of ``sources`` (both (H, W) bool)."""
    sources = sources & ~lost
    if not lost.any() or not sources.any():
        return labels_hw
    index = _nearest_zero((~sources).astype(np.uint8))
    labels_of = np.zeros(index.max() + 1, np.uint8)
    labels_of[index[sources]] = labels_hw[sources]
    filled = labels_hw.copy()
    filled[lost] = labels_of[index[lost]]
    return filled


# --- landmarks ---


def spoil_landmarks(
    landmarks: Landmarks,
    noise: LabelNoise,
    rng: np.random.Generator,
    population: Landmarks,
    size_px: tuple[int, int],
) -> Landmarks:
    """Landmarks of an image missed, spurious, mislabeled, their centers and areas perturbed.

    Args:
        landmarks: of the image
        noise: in pixels of the image; what only labels can show is left out
        rng: a seeded one repeats the result
        population: spurious ones lie anywhere in the image and have class and area (px²) of one of these
        size_px: (width, height) of the image

    Returns:
        Those that are left, then the spurious ones.
    """
    kept = landmarks.select(rng.random(len(landmarks)) >= noise.missed)
    count = rng.binomial(len(landmarks), min(noise.spurious, 1.0)) if len(population) else 0
    both = joined(kept, _spurious(population, count, rng, size_px))
    centers = both.centers_xy + rng.normal(0, noise.center, both.centers_xy.shape)
    areas = both.areas_px * np.exp(rng.normal(0, noise.log_area, len(both)))
    classes = _mislabeled(both.classes, np.unique(population.classes), noise.mislabeled, rng)
    return replace(both, centers_xy=centers, classes=classes, areas_px=areas)


def with_moved_boundaries(landmarks: Landmarks, noise: LabelNoise, rng: np.random.Generator) -> Landmarks:
    """The centers and areas that landmarks get when boundaries move, and images are sampled (CENTER_SHARE and on)."""
    sizes = np.sqrt(landmarks.areas_px)
    deviation = CENTER_SHARE * noise.jitter / np.sqrt(1 + sizes / (CENTER_LENGTHS * JITTER_LENGTH_PX))
    centers = landmarks.centers_xy + rng.normal(0, 1, landmarks.centers_xy.shape) * deviation[:, None]
    spread = np.hypot(AREA_SHARE * noise.jitter / sizes, SAMPLING_AREA)
    areas = landmarks.areas_px * np.exp(rng.normal(0, 1, len(landmarks)) * spread)
    return replace(landmarks, centers_xy=centers, areas_px=areas)


def joined(one: Landmarks, other: Landmarks) -> Landmarks:
    """Both, the first ones first."""
    names = (field.name for field in fields(Landmarks))
    return Landmarks(*(np.concatenate([getattr(one, name), getattr(other, name)]) for name in names))


def _spurious(population: Landmarks, count: int, rng: np.random.Generator, size_px: tuple[int, int]) -> Landmarks:
    drawn = population.select(rng.integers(0, max(len(population), 1), count))
    centers = rng.uniform((0, 0), size_px, (count, 2))
    half = np.sqrt(drawn.areas_px)[:, None] / 2
    bounds = np.column_stack([np.floor(centers - half), np.ceil(centers + half)]).astype(np.int64)
    bounds = np.clip(bounds, 0, np.array([*size_px, *size_px], np.int64))
    touches = (bounds[:, :2] <= 0).any(axis=1) | (bounds[:, 2:] >= np.array(size_px)).any(axis=1)
    return replace(drawn, centers_xy=centers, bounds=bounds, touches_edge=touches)
