"""Imitates the errors of a modest segmentation network on a label image; seeded, for trials and for training nothing.

What such a network does to labels (seen on aerial tiles with an IoU of buildings near 0.5): near houses flow together,
long ones break, edges wander by meters, thin roads and small objects vanish, and whole patches get another class.
The steps follow that order; each is a function of its own and can be left out by giving it 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence

import cv2
import numpy as np

EDGE_LENGTHS = 3.0
"""Correlation length of the edges' wandering, in units of its standard deviation: smooth enough not to fold."""

LARGEST_KERNEL_PX = 61
"""Morphology with larger ellipses is done on that size; keeps the time bounded on very fine images."""


@dataclass(frozen=True)
class LabelNoise:
    """How bad the labels get; lengths in meters on the ground, areas in m², shares from 0 to 1.

    merge_m: gaps between objects up to this width are filled; split_length_m: objects longer than this are cut across
    with the chance split_share, by a gap of split_gap_m; edge_m: standard deviation of the edges' displacement along
    each axis; patch_share: share of the area that gets random classes, in patches of about patch_size_m;
    thin_m: narrower parts of a class are lost; missed_share: chance that an object below missed_area_m2 is missed.
    Raises ValueError for negative values and shares above 1.
    """

    merge_m: float = 0.0
    split_length_m: float = 40.0
    split_share: float = 0.0
    split_gap_m: float = 3.0
    edge_m: float = 0.0
    patch_share: float = 0.0
    patch_size_m: float = 80.0
    thin_m: float = 0.0
    missed_share: float = 0.0
    missed_area_m2: float = 200.0

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if value < 0 or (name.endswith("_share") and value > 1):
                raise ValueError(f"{name} = {value:g} is out of range.")


MODEST = LabelNoise(merge_m=6, split_share=0.2, edge_m=3, patch_share=0.15, thin_m=4, missed_share=0.15)
"""A usable network: houses merged, edges off by 3 m, 15 % of the area in a random class."""

STRONG = LabelNoise(merge_m=10, split_share=0.4, edge_m=6, patch_share=0.35, thin_m=8, missed_share=0.4)
"""A poor network: edges off by 6 m, 35 % of the area in a random class, four small objects of ten missed."""


def degrade_labels(
    labels_hw: np.ndarray,
    pixel_size_m: float,
    noise: LabelNoise,
    seed: int,
    object_values: Sequence[int] = (1,),
) -> np.ndarray:
    """(H, W) uint8: ``labels_hw`` as a network with these errors would have given it. Same seed, same result.

    ``object_values``: classes made of separate objects (buildings); merged, split and missed only there.
    Random classes are drawn from those the image has, so a one-class image stays what it is.
    """
    rng = np.random.default_rng(seed)
    labels = labels_hw.copy()
    if labels.size == 0:
        return labels
    for value in object_values:
        labels = miss_small_objects(labels, value, noise.missed_area_m2 / pixel_size_m**2, noise.missed_share, rng)
        labels = merge_near_objects(labels, value, noise.merge_m / pixel_size_m)
        labels = split_long_objects(
            labels, value, noise.split_length_m / pixel_size_m, noise.split_gap_m / pixel_size_m, noise.split_share, rng
        )
    labels = lose_thin_parts(labels, noise.thin_m / pixel_size_m)
    labels = move_edges(labels, noise.edge_m / pixel_size_m, rng)
    return swap_patches(labels, noise.patch_size_m / pixel_size_m, noise.patch_share, rng)


def miss_small_objects(
    labels_hw: np.ndarray, value: int, area_px: float, share: float, rng: np.random.Generator
) -> np.ndarray:
    """Regions of class ``value`` smaller than ``area_px`` vanish with the chance ``share`` into what lies around."""
    if share <= 0:
        return labels_hw
    count, regions, statistics, _ = cv2.connectedComponentsWithStats((labels_hw == value).astype(np.uint8))
    gone = (statistics[:, cv2.CC_STAT_AREA] < area_px) & (rng.random(count) < share)
    gone[0] = False
    return filled_from_around(labels_hw, gone[regions], labels_hw != value)


def merge_near_objects(labels_hw: np.ndarray, value: int, gap_px: float) -> np.ndarray:
    """Gaps up to ``gap_px`` between regions of class ``value`` get that class (morphological closing)."""
    kernel = _ellipse(gap_px)
    if kernel is None:
        return labels_hw
    mask = (labels_hw == value).astype(np.uint8)
    merged = labels_hw.copy()
    merged[cv2.morphologyEx(mask, cv2.MORPH_CLOSE, kernel, borderType=cv2.BORDER_REPLICATE) > 0] = value
    return merged


def split_long_objects(
    labels_hw: np.ndarray, value: int, length_px: float, gap_px: float, share: float, rng: np.random.Generator
) -> np.ndarray:
    """Regions of class ``value`` longer than ``length_px`` are cut across, in their middle third, with this chance."""
    if share <= 0:
        return labels_hw
    mask = (labels_hw == value).astype(np.uint8)
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    cuts = np.zeros_like(mask)
    for contour, cut in zip(contours, rng.random(len(contours)) < share):
        corners = cv2.boxPoints(cv2.minAreaRect(contour))
        edges = np.roll(corners, -1, axis=0) - corners
        lengths = np.hypot(edges[:, 0], edges[:, 1])
        longest = int(lengths.argmax())
        if not cut or lengths[longest] < length_px:
            continue
        at = corners[longest] + edges[longest] * rng.uniform(1 / 3, 2 / 3)
        across = at + edges[(longest + 1) % 4]
        ends = [tuple(int(v) for v in np.rint(point)) for point in (at, across)]
        cv2.line(cuts, *ends, 1, max(1, int(round(gap_px))))
    return filled_from_around(labels_hw, (cuts & mask) > 0, labels_hw != value)


def lose_thin_parts(labels_hw: np.ndarray, width_px: float) -> np.ndarray:
    """Parts of any class narrower than ``width_px`` get the class of what is left nearest (opening of each class)."""
    kernel = _ellipse(width_px)
    if kernel is None:
        return labels_hw
    kept = np.zeros(labels_hw.shape, bool)
    for value in np.unique(labels_hw):
        mask = (labels_hw == value).astype(np.uint8)
        kept |= cv2.morphologyEx(mask, cv2.MORPH_OPEN, kernel, borderType=cv2.BORDER_REPLICATE) > 0
    return filled_from_around(labels_hw, ~kept, kept)


def move_edges(labels_hw: np.ndarray, sigma_px: float, rng: np.random.Generator) -> np.ndarray:
    """Every edge wanders: the labels are read at places displaced by a smooth random field of ``sigma_px``."""
    if sigma_px <= 0:
        return labels_hw
    x, y = _displaced_grid(labels_hw.shape, sigma_px, rng)
    return cv2.remap(labels_hw, x, y, cv2.INTER_NEAREST, borderMode=cv2.BORDER_REPLICATE)


def swap_patches(labels_hw: np.ndarray, size_px: float, share: float, rng: np.random.Generator) -> np.ndarray:
    """Patches of about ``size_px`` that cover ``share`` of the area get a random class of the image each.

    The patches are cells around random points, with wandering edges; whole cells are taken in random order until the
    share is reached. A random class may be the right one.
    """
    height, width = labels_hw.shape
    values = np.unique(labels_hw)
    count = int(np.ceil(4 * height * width / max(size_px, 1.0) ** 2))
    if share <= 0 or len(values) < 2:
        return labels_hw
    points = np.full((height, width), 255, np.uint8)
    points[rng.integers(0, height, count), rng.integers(0, width, count)] = 0
    cells = _nearest_zero(points)
    x, y = _displaced_grid(labels_hw.shape, max(size_px, 1.0) / 10, rng)
    cells = cv2.remap(cells.astype(np.float32), x, y, cv2.INTER_NEAREST, borderMode=cv2.BORDER_REPLICATE).astype(int)
    areas = np.bincount(cells.ravel())
    order = rng.permutation(len(areas))
    taken = np.zeros(len(areas), bool)
    taken[order[np.cumsum(areas[order]) <= share * height * width]] = True
    classes = rng.choice(values, len(areas)).astype(np.uint8)
    return np.where(taken[cells], classes[cells], labels_hw).astype(np.uint8)


def _displaced_grid(shape_hw, sigma_px: float, rng: np.random.Generator):
    """Two (H, W) float32 arrays: column and row of every pixel, displaced smoothly by ``sigma_px`` along each axis."""
    height, width = shape_hw
    length = max(EDGE_LENGTHS * sigma_px, 1.0)
    # White noise on a grid as coarse as the correlation length, enlarged: cheap whatever the length.
    coarse = int(np.ceil(height / length)) + 2, int(np.ceil(width / length)) + 2
    grid = np.mgrid[0:height, 0:width].astype(np.float32)
    moved = []
    for axis in (1, 0):
        field = cv2.resize(
            rng.standard_normal(coarse).astype(np.float32), (width, height), interpolation=cv2.INTER_CUBIC
        )
        deviation = float(field.std())
        moved.append(grid[axis] + field * np.float32(sigma_px / deviation if deviation > 0 else 0.0))
    return moved


def _ellipse(diameter_px: float):
    """Structuring element of about that diameter, odd so that nothing is shifted; None when it would do nothing."""
    size = min(2 * int(round((diameter_px - 1) / 2)) + 1, LARGEST_KERNEL_PX)
    return None if size < 3 else cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))


def _nearest_zero(image_hw: np.ndarray) -> np.ndarray:
    """(H, W) int: index of the nearest zero pixel of ``image_hw``, counted from 0 in order of rows."""
    _, index = cv2.distanceTransformWithLabels(image_hw, cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL)
    return index - 1


def filled_from_around(labels_hw: np.ndarray, lost: np.ndarray, sources: np.ndarray) -> np.ndarray:
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
