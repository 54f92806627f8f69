"""Cluster poses: find the fullest cells of two lattices.

See docs/explanation/method.md#constellation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .index import ascending_order, expand_ranges

CELL_OF_IMAGE = 0.04
"""Cell size for positions, as a share of the image's diagonal on the ground. Set by hand."""

CELL_OF_TURN = 0.1
"""Cell size for heading, radians, and ln pixel size. Set by hand."""

_CELLS_AROUND = int(np.ceil(2 * np.pi / CELL_OF_TURN))

_SORTED_AT_ONCE = 20_000
"""Fewer poses are sorted faster than counted."""

_GROUP_BITS = 21
"""Largest number of bits of a group number: the counts, 16 MB, stay in a processor's cache."""

_FIRST_SHARE = 0.25
"""Largest share of the poses that is examined in the first pass."""

_FARTHEST = 2.0**30
"""Half cells beyond this are one: such an image would show almost nothing of the map."""

_SPREADING = np.array([0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D, 0x27D4EB2F], np.uint32)
"""Factors of a cell's integers: adjacent cells get distant group numbers."""


@dataclass(frozen=True)
class Poses:
    """H poses of similar triangles, with their cells.

    Attributes:
        centers: (H,) complex, map units from the index's origin.
        turns: (H,) complex, heading and pixel size, never 0.
        focuses: (H,) complex, positions of the triangles in the image.
        places: (4, H) int32, half cells to the right and up, cells of ln pixel size, and half cells of heading.
    """

    centers: np.ndarray
    turns: np.ndarray
    focuses: np.ndarray
    places: np.ndarray

    def __len__(self) -> int:
        return len(self.centers)

    def select(self, chosen: np.ndarray) -> Poses:
        """Return the poses with these indices."""
        centers, turns, focuses = (value.take(chosen) for value in (self.centers, self.turns, self.focuses))
        return Poses(centers, turns, focuses, self.places.take(chosen, axis=1))


@dataclass(frozen=True)
class _Lattice:
    """Cells of poses. Cells of position grow with the pixel size in whole steps, so that equal poses share a lattice.

    Attributes:
        shift: Half cells by which the lattice is shifted, 0 or 1.
    """

    shift: int

    def columns(self, places: np.ndarray) -> tuple[np.ndarray, ...]:
        """Return (H,) each: cells to the right, up, of the pixel size and of the heading."""
        across, along, sizes, turned = places
        shift = self.shift
        return (across + shift) >> 1, (along + shift) >> 1, sizes, ((turned + shift) >> 1) % _CELLS_AROUND

    def numbers(self, places: np.ndarray) -> np.ndarray:
        """Return (H,) uint32 numbers that are equal for poses in one cell, and rarely for others."""
        columns = self.columns(places)
        return sum(column.view(np.uint32) * factor for column, factor in zip(columns, _SPREADING))


@dataclass(frozen=True)
class Seeds:
    """S clusters of poses, most votes first.

    Attributes:
        centers: (S,) complex, map units from the index's origin.
        turns: (S,) complex, heading and pixel size.
        focuses: (S,) complex, mean position of the triangles in the image.
        votes: (S,) int64, triangles that agree.
        capped: Some matching triangles were omitted.
    """

    centers: np.ndarray
    turns: np.ndarray
    focuses: np.ndarray
    votes: np.ndarray
    capped: bool


def poses_in_cells(centers: np.ndarray, turns: np.ndarray, focuses: np.ndarray, diagonal: float) -> Poses:
    """Return poses (H,) with their cells; ``diagonal``: of the image, pixels."""
    size = np.abs(turns)
    places = np.empty((4, len(size)), np.int32)
    if len(size):
        step = CELL_OF_TURN
        places[2] = np.floor(np.log(size) / step + 0.5)
        least = int(places[2].min())
        edges = CELL_OF_IMAGE * diagonal * np.exp(np.arange(least, int(places[2].max()) + 1) * step)
        halves = (edges / 2)[places[2] - least]
        for row, part in enumerate((centers.real, centers.imag)):
            places[row] = np.clip(np.floor(part / halves), -_FARTHEST, _FARTHEST)
        places[3] = np.floor((np.angle(turns) + np.pi) / (2 * np.pi) * _CELLS_AROUND * 2)
    return Poses(centers, turns, focuses, places)


def cluster(portions: Sequence[Poses], capped: bool, count: int) -> Seeds:
    """Return the means of the poses in the fullest cells of two lattices, so that one of them does not cut a cluster.

    Args:
        capped: Copied to the result.
        count: Cells of each lattice.
    """
    found = [_cell_means(portions, _Lattice(shift), count) for shift in (0, 1)]
    centers, turns, focuses, votes = (np.concatenate(parts) for parts in zip(*found))
    order = np.argsort(-votes, kind="stable")
    # A cluster that neither lattice cuts occurs twice.
    once = list({pose: number for number, pose in reversed([*enumerate(zip(centers[order], turns[order]))])}.values())
    order = order[np.sort(np.array(once, np.int64))]
    return Seeds(centers[order], turns[order], focuses[order], votes[order], capped)


def _cell_means(
    portions: Sequence[Poses], lattice: _Lattice, count: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return means of centers, turns and focuses in the fullest cells, and the number of poses in each."""
    poses, key = _in_full_cells(portions, lattice, count)
    if not len(poses):
        return *(np.empty(0, complex),) * 3, np.empty(0, np.int64)
    order = ascending_order(key)
    ordered = key[order]
    starts = np.flatnonzero(np.concatenate([[True], ordered[1:] != ordered[:-1]]))
    votes = np.diff(np.append(starts, len(order)))
    best = _fullest(votes, count)
    starts, votes = starts[best], votes[best]
    # In their original order, so that equal cells have equal means.
    _, places = expand_ranges(starts, starts + votes)
    begins, chosen = np.cumsum(votes) - votes, order[places]
    return (
        *(np.add.reduceat(value[chosen], begins) / votes for value in (poses.centers, poses.turns, poses.focuses)),
        votes,
    )


def _in_full_cells(portions: Sequence[Poses], lattice: _Lattice, count: int) -> tuple[Poses, np.ndarray]:
    """Return poses that include all of the ``count`` fullest cells, and the keys of their cells.

    Of millions of poses nearly all are alone in their cells. Cells are counted in groups, which needs no sorting: a
    group of few poses contains only cells of few.
    """
    total = sum(len(poses) for poses in portions)
    if total < _SORTED_AT_ONCE:
        return _keyed(portions, lattice)
    numbers = np.concatenate([lattice.numbers(poses.places) for poses in portions])
    groups = _groups(numbers, total)
    sizes = np.bincount(groups)
    groups_of = np.bincount(sizes)
    poses_of = (groups_of * np.arange(len(groups_of)))[::-1].cumsum()[::-1]
    # Start with groups that leave few poses to examine; go down until enough cells have at least this many poses.
    least = max(int((poses_of > total * _FIRST_SHARE).sum()), 2)
    while least > 1:
        votes = np.zeros(0, np.int64)
        if groups_of[least:].sum() >= count:
            found = np.flatnonzero((sizes >= least).take(groups))
            # Most of them share a group by chance; with other group numbers, hardly any do.
            others = _groups(numbers.take(found) * _SPREADING[0], len(found))
            found = found[(np.bincount(others) >= least).take(others)]
            poses, key = _keyed(_selected(portions, found), lattice)
            votes = np.unique(key, return_counts=True)[1]
            if (votes >= least).sum() >= count:
                return poses, key
        # Once enough cells are known, the smallest of them is the limit.
        enough = int(np.partition(votes, -count)[-count]) if len(votes) >= count else 0
        least = max(least * 3 // 4, enough)
    return _keyed(portions, lattice)


def _groups(numbers: np.ndarray, count: int) -> np.ndarray:
    """Return (H,) groups, a few times as many as poses, of numbers (H,) uint32."""
    bits = min(count.bit_length() + 1, _GROUP_BITS)
    return (numbers >> np.uint32(32 - bits)).astype(np.intp)


def _selected(portions: Sequence[Poses], chosen: np.ndarray) -> list[Poses]:
    """Return the poses with these ascending indices, counted through all portions."""
    starts = np.cumsum([0, *(len(poses) for poses in portions)])
    parts = np.split(chosen, np.searchsorted(chosen, starts[1:-1]))
    return [poses.select(part - start) for poses, part, start in zip(portions, parts, starts)]


def _keyed(portions: Sequence[Poses], lattice: _Lattice) -> tuple[Poses, np.ndarray]:
    """Return all poses, and (H,) int64 keys that are equal within a cell and ascend with the cells."""
    if not portions:
        nothing = np.empty(0, complex)
        return Poses(nothing, nothing, nothing, np.empty((4, 0), np.int32)), np.empty(0, np.int64)
    parts = ([getattr(poses, name) for poses in portions] for name in ("centers", "turns", "focuses", "places"))
    poses = Poses(*(np.concatenate(part, axis=-1) for part in parts))
    key = np.zeros(len(poses), np.int64)
    for column in lattice.columns(poses.places) if len(poses) else ():
        place = column.astype(np.int64) - int(column.min())
        key = key * (int(place.max()) + 1) + place
    return poses, key


def _fullest(votes: np.ndarray, count: int) -> np.ndarray:
    """Return the ``count`` fullest cells, fullest first."""
    if len(votes) <= count:
        return np.argsort(-votes, kind="stable")
    least = np.partition(votes, len(votes) - count)[len(votes) - count]
    order = np.flatnonzero(votes >= least)
    return order[np.argsort(-votes[order], kind="stable")[:count]]
