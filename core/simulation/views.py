"""Seeded queries with known truth, cut from a label map and spoilt on purpose: what a localizer is measured with.

Two kinds of noise: of objects (``spoil_objects``: missed, invented, misnamed, moved; ``spoil_label_objects`` draws it
into labels) and of labels (``spoil_labels``: ragged edges, merged and split objects). Every function takes its random
generator, so a seed repeats a trial.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, Sequence, Tuple

import cv2
import numpy as np

from ..labels.sources import LabelSource
from ..landmarks.landmarks import Landmarks, class_mask
from .noise import filled_from_around


@dataclass(frozen=True)
class View:
    """What a camera sees: its image's center lies at (column, row) of the map, its top points to heading_deg.

    column, row: map pixel coordinates, (0.5, 0.5) the first pixel's center; heading_deg: clockwise from the map's
    up; scale: map pixels per image pixel at the center; tilt_deg: of the optical axis from the vertical, towards
    tilt_direction_deg (clockwise from the image's top), for a camera that sees field_of_view_deg across its width.
    """

    column: float
    row: float
    heading_deg: float = 0.0
    scale: float = 1.0
    width_px: int = 1280
    height_px: int = 1280
    tilt_deg: float = 0.0
    tilt_direction_deg: float = 0.0
    field_of_view_deg: float = 60.0


@dataclass(frozen=True)
class ObjectNoise:
    """missed: share of the objects removed; invented: number added, as a share of those before; misnamed: share given
    another class; jitter_px: standard deviation of a center in each axis; area: standard deviation of ln area."""

    missed: float = 0.0
    invented: float = 0.0
    misnamed: float = 0.0
    jitter_px: float = 0.0
    area: float = 0.0


@dataclass(frozen=True)
class LabelNoise:
    """ragged_px: standard deviation of how far edges move, and ragged_length_px over what length they move alike;
    merged: share of the image in which gaps up to merge_gap_px within a class are closed;
    split: share of the objects cut in two by a gap of split_gap_px."""

    ragged_px: float = 0.0
    ragged_length_px: float = 8.0
    merged: float = 0.0
    merge_gap_px: int = 7
    split: float = 0.0
    split_gap_px: int = 3


def map_coordinates(view: View, columns: np.ndarray, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Map (columns, rows) of image pixel coordinates, of any equal shapes; the view's truth."""
    right, up = columns - view.width_px / 2, view.height_px / 2 - rows
    if view.tilt_deg:
        right, up = _on_the_ground(view, right, up)
    turn = np.radians(view.heading_deg)
    # y goes down on the map: the image's up is (sin, −cos) there, its right (cos, sin).
    column = view.column + view.scale * (np.cos(turn) * right + np.sin(turn) * up)
    return column, view.row + view.scale * (np.sin(turn) * right - np.cos(turn) * up)


def _on_the_ground(view: View, right: np.ndarray, up: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Offsets on level ground, in pixels of the vertical view, that a tilted camera sees at image offsets."""
    tilt, direction = np.radians(view.tilt_deg), np.radians(view.tilt_direction_deg)
    focal = view.width_px / 2 / np.tan(np.radians(view.field_of_view_deg) / 2)
    along = np.sin(direction) * right + np.cos(direction) * up
    across = np.cos(direction) * right - np.sin(direction) * up
    depth = np.cos(tilt) - along / focal * np.sin(tilt)
    # The camera is lower the more it is tilted, so that a pixel at the center covers as much ground as a level one's.
    lower = np.cos(tilt) ** 1.5
    along, across = lower * along / (np.cos(tilt) * depth), lower * across / depth
    return (
        np.sin(direction) * along + np.cos(direction) * across,
        np.cos(direction) * along - np.sin(direction) * across,
    )


def cut_view(source: LabelSource, view: View) -> np.ndarray:
    """(H, W) uint8 labels that the view shows, by nearest neighbor; 0 beyond the map."""
    columns, rows = np.meshgrid(np.arange(view.width_px) + 0.5, np.arange(view.height_px) + 0.5)
    columns, rows = map_coordinates(view, columns, rows)
    # Rounding keeps quarter turns exact: cos 90° ≈ 6e-17 could push a sample over a pixel's edge.
    columns = np.floor(np.round(columns, 6)).astype(np.int64)
    rows = np.floor(np.round(rows, 6)).astype(np.int64)
    height, width = source.shape_hw
    left, top = max(int(columns.min()), 0), max(int(rows.min()), 0)
    right, bottom = min(int(columns.max()) + 1, width), min(int(rows.max()) + 1, height)
    if right <= left or bottom <= top:
        return np.zeros(columns.shape, np.uint8)
    piece = source.read(left, top, right - left, bottom - top)
    seen = (columns >= left) & (columns < right) & (rows >= top) & (rows < bottom)
    labels = piece[np.where(seen, rows - top, 0), np.where(seen, columns - left, 0)]
    return np.ascontiguousarray(np.where(seen, labels, 0).astype(np.uint8))


def random_view(
    rng: np.random.Generator, extent: tuple, size_px: tuple = (1280, 1280), scales: tuple = (1.0, 1.0)
) -> View:
    """Any heading, a scale uniform in its logarithm, a center anywhere in extent (left, top, right, bottom) map px."""
    column, row = rng.uniform(extent[0], extent[2]), rng.uniform(extent[1], extent[3])
    scale = float(np.exp(rng.uniform(*np.log(scales))))
    return View(float(column), float(row), float(rng.uniform(0, 360)), scale, *size_px)


def spoil_objects(
    objects: Landmarks,
    noise: ObjectNoise,
    rng: np.random.Generator,
    population: Landmarks,
    image_size: tuple,
) -> Landmarks:
    """The objects of an image after noise; invented ones lie anywhere in it and have class and area of one of
    ``population`` (areas in pixels of this image); image_size: (width, height) px."""
    kept = objects.select(rng.random(len(objects)) >= noise.missed)
    count = rng.binomial(len(objects), min(noise.invented, 1.0)) if len(population) else 0
    parts = [kept, _invented(population, count, rng, image_size)]
    joined = Landmarks(*(np.concatenate([getattr(part, name) for part in parts]) for name in _FIELDS))
    centers = joined.centers_xy + rng.normal(0, noise.jitter_px, joined.centers_xy.shape)
    areas = joined.areas_px * np.exp(rng.normal(0, noise.area, len(joined)))
    classes = _misnamed(joined.classes, np.unique(population.classes), noise.misnamed, rng)
    return Landmarks(centers, classes, areas, joined.bounds, joined.touches_edge)


_FIELDS = ("centers_xy", "classes", "areas_px", "bounds", "touches_edge")


def _invented(population: Landmarks, count: int, rng: np.random.Generator, image_size: tuple):
    drawn = population.select(rng.integers(0, max(len(population), 1), count))
    centers = rng.uniform((0, 0), image_size, (count, 2))
    half = np.sqrt(drawn.areas_px)[:, None] / 2
    bounds = np.column_stack([np.floor(centers - half), np.ceil(centers + half)]).astype(np.int64)
    bounds = np.clip(bounds, 0, np.array([*image_size, *image_size], np.int64))
    touches = (bounds[:, :2] <= 0).any(axis=1) | (bounds[:, 2:] >= np.array(image_size)).any(axis=1)
    return Landmarks(centers, drawn.classes, drawn.areas_px, bounds, touches)


def _misnamed(classes: np.ndarray, known: np.ndarray, share: float, rng: np.random.Generator) -> np.ndarray:
    """Classes of which a share is changed to any other known class."""
    if len(known) < 2:
        return classes
    step = rng.integers(1, len(known), len(classes))
    other = known[(np.searchsorted(known, classes) + step) % len(known)]
    return np.where(rng.random(len(classes)) < share, other, classes).astype(np.uint8)


PLACES_TRIED = 20
"""An invented object is left out when so many random places of the image have no room for it."""


@dataclass(frozen=True)
class _Region:
    """A connected region of one class: its bounding box as slices (rows, columns) and its mask in it."""

    value: int
    box: Tuple[slice, slice]
    mask: np.ndarray


def spoil_label_objects(
    labels_hw: np.ndarray,
    noise: ObjectNoise,
    rng: np.random.Generator,
    class_values: Sequence[int],
    donor_hw: np.ndarray,
    minimum_area_px: float = 1.0,
) -> np.ndarray:
    """(H, W) uint8 labels with objects missed, invented and misnamed, as ``noise`` asks (its jitter and area are for
    ``spoil_objects``; edges are moved by ``spoil_labels``).

    Objects are the regions of ``class_values`` of at least ``minimum_area_px`` pixels. Missed ones get the nearest
    label that is of none of these classes; invented ones have shape and class of an object of ``donor_hw`` (labels of
    another place at the same scale) and lie where they touch no other object.
    """
    regions = _regions(labels_hw, class_values, minimum_area_px)
    missed = rng.random(len(regions)) < noise.missed
    classes = _misnamed(np.array([r.value for r in regions]), np.unique(class_values), noise.misnamed, rng)
    count = rng.binomial(len(regions), min(noise.invented, 1.0))
    spoilt, lost = labels_hw.copy(), np.zeros(labels_hw.shape, bool)
    for region, is_missed, value in zip(regions, missed, classes):
        if is_missed:
            lost[region.box] |= region.mask
        else:
            spoilt[region.box][region.mask] = value
    spoilt = filled_from_around(spoilt, lost, ~np.isin(labels_hw, class_values))
    _draw_invented(spoilt, _regions(donor_hw, class_values, minimum_area_px), count, rng, class_values)
    return spoilt


def _regions(labels_hw: np.ndarray, class_values: Sequence[int], minimum_area_px: float) -> List[_Region]:
    found = []
    for value in class_values:
        _, numbers, stats, _ = cv2.connectedComponentsWithStats(class_mask(labels_hw, value))
        for number in range(1, len(stats)):
            left, top, width, height, area = stats[number]
            if area >= minimum_area_px:
                box = (slice(top, top + height), slice(left, left + width))
                found.append(_Region(int(value), box, numbers[box] == number))
    return found


def _draw_invented(
    labels_hw: np.ndarray, donors: List[_Region], count: int, rng: np.random.Generator, class_values: Sequence[int]
) -> None:
    """Draws ``count`` of the donors into ``labels_hw`` itself, each with a margin of a pixel to other objects."""
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


def spoil_labels(labels_hw: np.ndarray, noise: LabelNoise, rng: np.random.Generator, class_values: tuple) -> np.ndarray:
    """(H, W) uint8 labels after noise; ``class_values`` are the classes whose objects are merged and split."""
    labels = labels_hw
    if noise.merged > 0:
        labels = _merged(labels, noise, rng, class_values)
    if noise.split > 0:
        labels = _split(labels, noise, rng, class_values)
    if noise.ragged_px > 0:
        labels = _ragged(labels, noise, rng)
    return labels


def _smooth_noise(shape_hw: tuple, length_px: float, rng: np.random.Generator) -> np.ndarray:
    """(H, W) float32 of variance 1, alike over about ``length_px``."""
    small = tuple(max(int(np.ceil(size / length_px)) + 1, 2) for size in shape_hw)
    field = rng.normal(size=small).astype(np.float32)
    field = cv2.resize(field, (shape_hw[1], shape_hw[0]), interpolation=cv2.INTER_CUBIC)
    return field / max(float(field.std()), 1e-6)


def _ragged(labels: np.ndarray, noise: LabelNoise, rng: np.random.Generator) -> np.ndarray:
    columns, rows = np.meshgrid(*(np.arange(size, dtype=np.float32) for size in labels.shape[::-1]))
    columns += noise.ragged_px * _smooth_noise(labels.shape, noise.ragged_length_px, rng)
    rows += noise.ragged_px * _smooth_noise(labels.shape, noise.ragged_length_px, rng)
    return cv2.remap(labels, columns, rows, cv2.INTER_NEAREST, borderMode=cv2.BORDER_REPLICATE)


def _merged(labels: np.ndarray, noise: LabelNoise, rng: np.random.Generator, class_values: tuple) -> np.ndarray:
    field = _smooth_noise(labels.shape, 100, rng)
    there = field <= np.quantile(field, noise.merged)
    kernel = np.ones((noise.merge_gap_px, noise.merge_gap_px), np.uint8)
    merged = labels.copy()
    for value in class_values:
        closed = cv2.morphologyEx(class_mask(labels, value), cv2.MORPH_CLOSE, kernel)
        merged[(closed > 0) & there] = value
    return merged


def _split(labels: np.ndarray, noise: LabelNoise, rng: np.random.Generator, class_values: tuple) -> np.ndarray:
    split = labels.copy()
    for value in class_values:
        count, regions, stats, centers = cv2.connectedComponentsWithStats(class_mask(labels, value))
        for number in np.flatnonzero(rng.random(count) < noise.split):
            if number:
                left, top, width, height = stats[number, :4]
                window = np.s_[top : top + height, left : left + width]
                rows, columns = np.mgrid[top : top + height, left : left + width]
                # Across the longer side of its bounding box.
                off = columns - centers[number, 0] if width >= height else rows - centers[number, 1]
                gap = (np.abs(off) <= noise.split_gap_px / 2) & (regions[window] == number)
                split[window][gap] = 0
    return split
