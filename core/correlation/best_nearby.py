"""Search the surroundings of a place in map correlation for the pose with the best agreement.

See docs/explanation/method.md#map-correlation.

Refinement ends at the nearest optimum, and labels of real photos have several within a few percent of the image's edge.
Therefore it starts again from shifted, turned and scaled poses.
"""

from __future__ import annotations

from itertools import product

import numpy as np

from .class_pyramid import EvidenceLevel, MapPyramid
from .places import edge_m, reduce_image
from .refine import ScoredPose, moved
from .refine_many import refine_many

DISTANCES, DIRECTIONS = (0.03, 0.06), 8
"""Shifts of the starts, as shares of the image's edge, and their directions. Set by hand."""

SIZES, TURNS_DEG = (0.92, 0.96, 1.04, 1.08), (-3.0, 0.0, 3.0)
"""Pixel sizes of the other starts, as ratios, each with these turns. Set by hand."""

FIRST_STEPS, LAST_STEPS, KEPT = 3, 12, 4
"""Steps from every start at the pixels of the second look, then of the best ones and of the place itself at the pixels
of the decision. Set by hand."""


def best_nearby(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose) -> ScoredPose:
    """Return the pose of the best agreement near a pose, with the score there at the pixels of the decision.

    Args:
        image: Evidence at the pixels of the decision or finer ones.
    """
    settings, quiet = pyramid.settings, pyramid.quiet
    starts = [ScoredPose(*row) for row in starts_around(pose, edge_m(image, 1.0)).tolist()]
    found = refine_many(reduce_image(image, settings.middle_edge), pyramid, starts, quiet, FIRST_STEPS)
    best = sorted(found, key=lambda one: -one.score)[:KEPT]
    found = refine_many(reduce_image(image, settings.decision_edge), pyramid, [pose, *best], quiet, LAST_STEPS)
    return max(found, key=lambda one: one.score)


def starts_around(pose: ScoredPose, edge: float) -> np.ndarray:
    """Return (28, 4) rows of x, y, heading and pixel size around a pose.

    Args:
        edge: Of the image, in its pixels.
    """
    ways = 2 * np.pi / DIRECTIONS * np.arange(DIRECTIONS)
    shifts = [(far * edge * np.cos(way), far * edge * np.sin(way), 0.0, 0.0) for far in DISTANCES for way in ways]
    others = [(0.0, 0.0, np.radians(turn), np.log(size)) for size, turn in product(SIZES, TURNS_DEG)]
    moves = np.array([*shifts, *others])
    return moved(np.tile((pose.x, pose.y, pose.heading_deg, pose.pixel_size_m), (len(moves), 1)), moves)
