"""Effects of rasterizing on drawn regions: which are lost, merged with a neighbor, or split."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..landmarks.joining import connected_components, touching_runs
from ..landmarks.landmarks import region_rows

LARGEST_MASK_PX = 200_000_000
"""Regions with a larger bounding box are not measured, because a raster can't lose them."""


@dataclass(frozen=True)
class RegionRuns:
    """Pixels of numbered regions as K runs along rows, in reading order.

    Attributes:
        rows: (K,) int64 row of each run.
        starts: (K,) int64 first column of each run.
        stops: (K,) int64 last column + 1.
        regions: (K,) int64 number of its region.
    """

    rows: np.ndarray
    starts: np.ndarray
    stops: np.ndarray
    regions: np.ndarray

    def __len__(self) -> int:
        return len(self.rows)


def runs_of_strip(regions_hw: np.ndarray, first_row: int) -> RegionRuns:
    """Return the runs of some rows of a raster.

    Args:
        regions_hw: (H, W) numbers of regions, 0 elsewhere.
        first_row: Row of the raster where these rows start.
    """
    height, width = regions_hw.shape
    begins = np.ones((height, width), bool)
    begins[:, 1:] = regions_hw[:, 1:] != regions_hw[:, :-1]
    starts = np.flatnonzero(begins)
    stops = np.append(starts[1:], regions_hw.size)
    regions = regions_hw.reshape(-1)[starts].astype(np.int64)
    starts, stops, regions = (values[regions > 0] for values in (starts, stops, regions))
    rows = starts // width
    return RegionRuns(rows + first_row, starts - rows * width, stops - rows * width, regions)


def join_runs(strips: list[RegionRuns]) -> RegionRuns:
    """Return the runs of consecutive strips, top first."""
    names = ("rows", "starts", "stops", "regions")
    empty = np.empty(0, np.int64)
    return RegionRuns(*(np.concatenate([empty, *(getattr(s, name) for s in strips)]) for name in names))


def merged_regions(runs: RegionRuns, region_classes: np.ndarray) -> np.ndarray:
    """Return pairs of regions of one class with touching pixels (8-connected), which become one landmark.

    Args:
        runs: Their pixels.
        region_classes: (R,) class values by number of region.

    Returns:
        (P, 2) int64 numbers of regions, each pair once.
    """
    beside = np.flatnonzero((runs.rows[1:] == runs.rows[:-1]) & (runs.starts[1:] == runs.stops[:-1]))
    links = np.concatenate([touching_runs(runs.rows, runs.starts, runs.stops), np.column_stack([beside, beside + 1])])
    pairs = runs.regions[links]
    pairs = pairs[(pairs[:, 0] != pairs[:, 1]) & (region_classes[pairs[:, 0]] == region_classes[pairs[:, 1]])]
    return np.unique(np.sort(pairs, axis=1), axis=0)


def count_pieces(runs: RegionRuns, count: int) -> np.ndarray:
    """Return (count,) int64 numbers of 8-connected pieces of each region; 0 for a region without pixels."""
    links = touching_runs(runs.rows, runs.starts, runs.stops)
    links = links[runs.regions[links[:, 0]] == runs.regions[links[:, 1]]]
    pieces = connected_components(len(runs), links)
    first_of_piece = np.unique(pieces, return_index=True)[1]
    return np.bincount(runs.regions[first_of_piece], minlength=count)


def lost_regions(runs: RegionRuns, count: int, minimum_area_px: float) -> np.ndarray:
    """Return (count,) bool: whether no piece of the region has this contour area (``cv2.contourArea``)."""
    lost = np.ones(count, bool)
    order = np.argsort(runs.regions, kind="stable")
    bounds = np.searchsorted(runs.regions[order], np.arange(count + 1))
    for region in np.unique(runs.regions).tolist():
        own = order[bounds[region] : bounds[region + 1]]
        rows, starts, stops = runs.rows[own] - runs.rows[own[0]], runs.starts[own], runs.stops[own]
        shape = int(rows[-1]) + 1, int(stops.max() - starts.min())
        large = shape[0] * shape[1] > LARGEST_MASK_PX
        lost[region] = not large and not len(region_rows(_mask(rows, starts, stops, shape), 1, minimum_area_px))
    return lost


def _mask(rows: np.ndarray, starts: np.ndarray, stops: np.ndarray, shape: tuple[int, int]) -> np.ndarray:
    """Return (H, W) uint8, 1 on the runs."""
    steps = np.zeros((shape[0], shape[1] + 1), np.int8)
    left = starts.min()
    steps[rows, starts - left] = 1
    steps[rows, stops - left] = -1
    return np.ascontiguousarray(np.cumsum(steps, axis=1, dtype=np.int8)[:, :-1]).view(np.uint8)
