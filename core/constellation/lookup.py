"""Look up triangles of the map that are similar to those of an image, and convert them to poses.

See docs/explanation/method.md#constellation.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property

import numpy as np

from ..localization import Prior
from .clusters import Poses, Seeds, cluster, poses_in_cells
from .hypotheses import QueryTriangles, SeenLandmarks
from .index import ConstellationIndex, key_ranges, numbers_in, similar_triangles

AREA_TOLERANCE = 0.4
"""Tolerance of ln(area / |AB|²): boundaries with an error of one or two pixels."""

PORTION = 100_000
"""Triangles of the index processed at a time; few enough for their data to stay in the cache."""


class Lookup:
    """Poses at which triangles of an image match similar ones of the map.

    Results are cached: a wider search continues from them.
    """

    def __init__(
        self, index: ConstellationIndex, query: SeenLandmarks, triangles: QueryTriangles, prior: Prior | None
    ) -> None:
        """Look up nothing yet."""
        self.index, self.query, self.triangles, self.prior = index, query, triangles, prior
        self._done = np.zeros(len(triangles), bool)
        self._found: list[Poses] = []

    def mirrored(self) -> Lookup:
        """Return the lookup for the mirrored image, without a prior heading."""
        prior = None if self.prior is None else replace(self.prior, heading_deg=None)
        return Lookup(self.index, self.query.mirrored(), self.triangles.mirrored(), prior)

    def every(self, step: int) -> Lookup:
        """Return the lookup for the first triangle and every ``step``-th after it."""
        return Lookup(self.index, self.query, self.triangles.every(step), self.prior)

    def poses(self, cap: int) -> tuple[list[Poses], bool]:
        """Return poses in portions, for the triangles with the fewest hits, and whether any triangle is omitted.

        Args:
            cap: Largest number of index triangles to examine. If there are more, only those near the prior position
                are counted.
        """
        which, first, last = self._stretches
        if (last - first).sum() > cap:
            near = _triangles_near(self.index, self.query, self.prior)
            if near is not None:
                # Ranges of ``near`` instead of ranges of the index.
                first, last = np.searchsorted(near, first), np.searchsorted(near, last)
                allowed = self._rarest(last - first, cap)
                some = allowed[which]
                return [*self._look_up(which[some], first[some], last[some], near)], not allowed.all()
        allowed = self._rarest(last - first, cap)
        if (self._done & ~allowed).any():
            self._done[:], self._found = False, []
        some = (allowed & ~self._done)[which]
        self._found.extend(self._look_up(which[some], first[some], last[some], None))
        self._done = allowed
        return self._found, not allowed.all()

    @cached_property
    def _stretches(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(R,) triangle of the image, (R,) first and (R,) last + 1 triangle of the index that may be similar."""
        ranks = self.query.ranks[self.triangles.members]
        return key_ranges(self.index, self.triangles.numbers, ranks, self._reach)

    @cached_property
    def _reach(self) -> np.ndarray:
        """(Q, 5) tolerances of the triangles' numbers."""
        place = self.triangles.tolerances
        area = np.full(len(place), AREA_TOLERANCE)
        return np.column_stack([place, place, area, area, area])

    def _rarest(self, spans: np.ndarray, cap: int) -> np.ndarray:
        """Return (Q,) bool: the triangles with the fewest hits, as many as the cap allows."""
        hits = np.bincount(self._stretches[0], weights=spans, minlength=len(self.triangles))
        order = np.argsort(hits, kind="stable")
        allowed = np.zeros(len(hits), bool)
        allowed[order[np.cumsum(hits[order]) <= cap]] = True
        return allowed

    def _look_up(
        self, which: np.ndarray, first: np.ndarray, last: np.ndarray, near: np.ndarray | None
    ) -> Iterator[Poses]:
        """Yield poses of the similar triangles in ranges of ``near`` or of the index, a portion at a time."""
        for portion in _portions(last - first, PORTION):
            spans = last[portion] - first[portion]
            source, hits = np.repeat(which[portion], spans), numbers_in(first[portion], spans)
            hits = hits if near is None else near[hits]
            like, source = similar_triangles(self.index, hits, source, self.triangles.numbers, self._reach)
            centers, turns, focuses = _fitted(self.index, self.query, self.triangles.members, source, like)
            kept = np.flatnonzero(allowed_poses(self.index, centers, turns, self.prior))
            fitted = centers.take(kept), turns.take(kept), focuses.take(kept)
            yield poses_in_cells(*fitted, self.query.diagonal)


def find_seeds(lookup: Lookup, cap: int, count: int | None = None, prior: Prior | None = None) -> Seeds:
    """Return the poses of an image with the most votes.

    Args:
        cap: Largest number of index triangles to examine, see ``Lookup.poses``.
        count: Poses of each of two lattices of cells; the default is the index's setting.
        prior: Additional prior beyond that of the lookup.
    """
    portions, capped = lookup.poses(cap)
    if prior is not None:
        allowed = (allowed_poses(lookup.index, poses.centers, poses.turns, prior) for poses in portions)
        portions = [poses.select(np.flatnonzero(kept)) for poses, kept in zip(portions, allowed)]
    return cluster(portions, capped, count or lookup.index.settings.limits.seeds)


def _portions(spans: np.ndarray, most: int) -> Iterator[slice]:
    """Yield ranges in portions of about ``most`` triangles, which limits memory."""
    ends = np.cumsum(spans)
    first = 0
    while first < len(spans):
        looked = ends[first - 1] if first else 0
        last = max(int(np.searchsorted(ends, looked + most, side="right")), first + 1)
        yield slice(first, last)
        first = last


def _fitted(
    index: ConstellationIndex, query: SeenLandmarks, triple: np.ndarray, source: np.ndarray, hits: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return centers, turns and the triangles' centers in the image, for similar triangles with equal classes.

    Args:
        triple: (Q, 3) corners of the image's triangles.
        source: (H,) the triangle of the image of each hit.
        hits: (H,) the similar triangles of the index.
    """
    members = index.members(hits)
    if not index.keys_tell_classes:
        alike = [index.ranks[of] == query.ranks[triple[source, k]] for k, of in enumerate(members)]
        same = np.logical_and.reduce(alike)
        members, source = [of[same] for of in members], source[same]
    # Least squares of three points, as in ``fit_similarity``; factors of the image are computed once per triangle.
    corners = query.points[triple]
    middles = corners.mean(axis=1)
    away = corners - middles[:, None]
    away = away.conj() / np.maximum((away.real**2 + away.imag**2).sum(axis=1), 1e-300)[:, None]
    a, b, c = (index.points.take(of) for of in members)
    middles = middles.take(source)
    turns = away[:, 1].take(source) * (b - a) + away[:, 2].take(source) * (c - a)
    # Dividing a complex number by 3 takes several times as long as multiplying its two parts by a third.
    centers = ((a + b + c).view(np.float64) * (1 / 3)).view(np.complex128)
    return centers - turns * middles, turns, middles


def _triangles_near(index: ConstellationIndex, query: SeenLandmarks, prior: Prior | None) -> np.ndarray | None:
    """Return ascending triangles of the index that an image may show at the prior position; None without one."""
    if prior is None or prior.position is None or prior.radius is None or prior.pixel_size_range is None:
        return None
    # Landmarks are within half a diagonal of the center; the rest is for triangles that match approximately.
    reach = prior.radius + query.diagonal * prior.pixel_size_range[1]
    center, corner = complex(*prior.position) - index.origin, complex(reach, reach)
    inside = np.zeros(len(index), bool)
    inside[index.within(center - corner, center + corner)] = True
    return np.flatnonzero(inside[index.anchors()])


def allowed_poses(index: ConstellationIndex, centers: np.ndarray, turns: np.ndarray, prior: Prior | None) -> np.ndarray:
    """Return (H,) bool: poses that the prior does not exclude."""
    size = np.abs(turns)
    kept = size > 0
    if prior is None:
        return kept
    if prior.pixel_size_range is not None:
        kept &= (size >= prior.pixel_size_range[0]) & (size <= prior.pixel_size_range[1])
    if prior.position is not None and prior.radius is not None:
        kept &= np.abs(centers + index.origin - complex(*prior.position)) <= prior.radius
    if prior.heading_deg is not None:
        away = (-np.degrees(np.angle(turns)) - prior.heading_deg + 180) % 360 - 180
        kept &= np.abs(away) <= prior.heading_range_deg
    return kept
