"""Landmarks of an image, and its triangles, which make hypotheses of its position.

See docs/explanation/method.md#constellation.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .settings import ConstellationSettings
from .triangles import ORDERS, canonical_order, describe_triangles, neighbor_pairs, triples

SMALLEST_OBJECT_PX = 9.0
"""Contour area, px², of the smallest landmark of an image with a usable shape and center."""

MINIMUM_OBJECTS = 4
"""Smallest number of whole landmarks of known class for a search: three make a hypothesis, one more tests it."""

PLACE_TOLERANCE_IN_NOISE = 3.5
"""Tolerance of C in the frame of AB, in noise over |AB|: 2.5 σ of a difference of three noisy centers."""

PLACE_TOLERANCE_MINIMUM = 0.012
"""Smallest such tolerance, share of |AB|: the resolution of the index's 8-bit numbers."""

PLACE_TOLERANCE_MAXIMUM = (0.06, 0.12)
"""Largest such tolerance, share of |AB|: triangles that need more are too unspecific and omitted. The second one is for
images with few other triangles (``first_triangles``): of 40 views with 3 to 20 buildings of Andorra the right place was
the best candidate for 30 instead of 21, of Monaco for 22 instead of 13. Set by hand."""


@dataclass(frozen=True)
class SeenLandmarks:
    """The n landmarks of an image.

    Attributes:
        points: (n,) complex, pixels from the image's center, y up.
        ranks: (n,) int64 index of each class in the index, −1 for an unknown class.
        log_areas: (n,) ln of areas in px².
        whole: (n,) bool, not cut by the image's border.
        diagonal: Of the image in pixels.
    """

    points: np.ndarray
    ranks: np.ndarray
    log_areas: np.ndarray
    whole: np.ndarray
    diagonal: float

    @property
    def usable_count(self) -> int:
        """Number of whole landmarks of known class."""
        return int((self.whole & (self.ranks >= 0)).sum())

    def select(self, chosen: np.ndarray) -> SeenLandmarks:
        """Return the landmarks with these indices, in that order."""
        return SeenLandmarks(
            self.points[chosen], self.ranks[chosen], self.log_areas[chosen], self.whole[chosen], self.diagonal
        )

    def mirrored(self) -> SeenLandmarks:
        """Return the landmarks of the mirrored image: same density and regularity, but impossible for a camera."""
        return SeenLandmarks(-self.points.conj(), self.ranks, self.log_areas, self.whole, self.diagonal)


@dataclass(frozen=True)
class QueryTriangles:
    """Q labeled triangles of an image.

    Attributes:
        members: (Q, 3) int64, landmarks A, B, C of the image.
        numbers: (Q, 5) float64, description of the triangles (``describe_triangles``).
        tolerances: (Q,) float64, of the position of C in the frame of AB.
    """

    members: np.ndarray
    numbers: np.ndarray
    tolerances: np.ndarray

    def __len__(self) -> int:
        return len(self.members)

    def every(self, step: int) -> QueryTriangles:
        """Return the first triangle and every ``step``-th after it."""
        return QueryTriangles(self.members[::step], self.numbers[::step], self.tolerances[::step])

    def mirrored(self) -> QueryTriangles:
        """Return the triangles of the mirrored image."""
        return QueryTriangles(self.members, self.numbers * np.array([1, -1, 1, 1, 1]), self.tolerances)


def query_triangles(query: SeenLandmarks, settings: ConstellationSettings, anchors: int) -> QueryTriangles:
    """Return the triangles of an image's whole landmarks of known class.

    If noise could change the order of a triangle's sides, it is returned in each order.

    Args:
        anchors: Largest landmarks that form triangles.
    """
    usable = np.flatnonzero(query.whole & (query.ranks >= 0))
    areas = np.exp(query.log_areas[usable])
    neighbors, exists = triples(query.points[usable], areas, settings.limits.query_neighbors)
    exists[np.argsort(-areas, kind="stable")[anchors:]] = False
    rows, pair = np.nonzero(exists)
    chosen = np.take_along_axis(neighbors[rows], neighbor_pairs(settings.limits.query_neighbors)[pair], axis=1)
    triple = usable[np.column_stack([rows, chosen])].reshape(-1, 3)
    order, sides = canonical_order(query.points[triple])
    sizes = np.exp(query.log_areas[triple] / 2).mean(axis=1)
    noise = np.hypot(settings.noise.center_noise_px, settings.noise.center_noise_in_sizes * sizes)
    tolerance = PLACE_TOLERANCE_IN_NOISE * noise / np.maximum(sides[:, 2], 1e-9)
    large = sides[:, 2] >= settings.limits.minimum_side_in_sizes * np.exp(query.log_areas[triple[:, 0]] / 2)
    large &= sides[:, 0] > 0
    usual, most = (large & (tolerance <= largest) for largest in PLACE_TOLERANCE_MAXIMUM)
    good = usual if usual.sum() >= settings.limits.first_triangles else most
    triple = np.take_along_axis(triple[good], ORDERS[order[good]], axis=1)
    tolerance, sides = np.maximum(tolerance[good], PLACE_TOLERANCE_MINIMUM), sides[good]
    alike = tolerance * sides[:, 2]
    middle = sides[:, 2] - sides[:, 1] < alike
    short = sides[:, 1] - sides[:, 0] < alike
    triple = np.concatenate([triple, triple[middle][:, (2, 1, 0)], triple[short][:, (1, 0, 2)]])
    tolerance = np.concatenate([tolerance, tolerance[middle], tolerance[short]])
    return QueryTriangles(triple, describe_triangles(query.points[triple], query.log_areas[triple]), tolerance)
