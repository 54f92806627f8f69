"""Relative motion of two overlapping images from their pixels: a link with its covariance, or why there is none.

See docs/explanation/method.md#relative-motion.

Corners that look alike propose a motion; what proves it is the ground: cells
of the overlap, each looked for in the other image by itself. A motion counts when most of them agree with it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial

import cv2
import numpy as np

from ..sentences import Sentence
from .motion import Link, LinkSource, as_rows
from .pixel_cells import SharedGround
from .pixel_features import Features
from .pixel_fit import Fitted, Mapping, fit_mapping, similarity

RATIO = 0.85
"""A corner counts when its best likeness is nearer than this share of the second best."""

PROPOSED_WITHIN_PX = 4.0
PROPOSALS = 4000
LEAST_CORNERS = 5
"""Working pixels within which corners agree, how many pairs of them are tried, and how many must agree."""

MOST_SCALE = 2.0
"""Of two images of one flight, one shows at most so many times as much ground as the other across its longer edge."""

LEAST_AGREEING = 7
CHANCE = 0.03
LEAST_EVIDENCE = 7.0
"""At least so many cells must agree, and so many that by chance, if a cell agreed with a wrong motion with probability
``CHANCE``, it would be so with one below exp(−evidence). Under low cameras trees and roofs leave few on the ground."""

AGREES_WITHIN_PX = 2.5
"""Working pixels from the fitted motion."""

TILT_SPREAD = 0.0165
"""Standard deviation of a tilt that nobody tells, to either side, over the focal length in edges: up to 2° in any
direction under a view of 60°."""

RELIEF_SHARES = (0.03, 0.075, 0.075)
"""What comes on top, growing with the way, where no cell agrees; it falls with the square of the share that doesn't:
trees, roofs and slopes move otherwise than the ground on which the cells agree."""

ROUNDS = 2
"""Cells are looked for by the proposed motion, and again by the one fitted to them."""


@dataclass(frozen=True)
class Motion:
    """What came of two images.

    Attributes:
        link: The motion; None where none was found.
        reason: Why none was found; None with a link.
    """

    link: Link | None
    reason: Sentence | None = None


def motion_between(first: Features, second: Features, numbers: tuple[int, int] = (0, 1)) -> Motion:
    """How the second image lies in the first one.

    Args:
        first: Of the earlier image.
        second: Of the later one.
        numbers: Of the two images in their flight.
    """
    if min(len(first.points), len(second.points)) < LEAST_CORNERS:
        return Motion(None, Sentence("One of the two images shows nothing that could be found in the other one."))
    proposed = _proposed(first, second)
    if proposed is None:
        return Motion(
            None, Sentence("Nothing in the two images tells a common motion; they may show different ground.")
        )
    mapping: Mapping = partial(similarity, proposed)
    motion = Motion(None)
    for _ in range(ROUNDS):
        ground = SharedGround(first, second, mapping)
        at_second, at_first = ground.match_cells()
        found = fit_mapping(at_second, at_first, AGREES_WITHIN_PX) if len(at_first) >= LEAST_AGREEING else None
        agreeing, cells = 0 if found is None else int(found.is_used.sum()), len(ground.corners)
        if found is None or agreeing < LEAST_AGREEING or evidence(agreeing, cells) < LEAST_EVIDENCE:
            reason = Sentence(
                "Where the two images would overlap, only {agreeing} of {cells} pieces of ground look alike.",
                agreeing=agreeing,
                cells=cells,
            )
            return Motion(None, reason)
        mapping = found.mapping
        motion = Motion(_link(first, second, found, agreeing / cells, numbers))
    return motion


def evidence(agreeing: int, cells: int) -> float:
    """How much speaks against chance: Chernoff's bound of the binomial tail, nats; 0 where chance would do.

    Args:
        agreeing: Cells that agree.
        cells: Cells that could, one or more.
    """
    share = agreeing / cells
    if share <= CHANCE:
        return 0.0
    others = (1 - share) * math.log((1 - share) / (1 - CHANCE)) if share < 1 else 0.0
    return cells * (share * math.log(share / CHANCE) + others)


def _proposed(first: Features, second: Features) -> np.ndarray | None:
    """(4,) parameters of the similarity that most corners which look alike agree with; None where too few do."""
    found = cv2.BFMatcher(cv2.NORM_HAMMING).knnMatch(second.descriptors, first.descriptors, k=2)
    pairs = [(best.queryIdx, best.trainIdx) for best, rival in found if best.distance < RATIO * rival.distance]
    if len(pairs) < LEAST_CORNERS:
        return None
    ours, theirs = np.array(pairs).T
    matrix, is_agreeing = cv2.estimateAffinePartial2D(
        second.points[ours],
        first.points[theirs],
        method=cv2.RANSAC,
        ransacReprojThreshold=PROPOSED_WITHIN_PX,
        maxIters=PROPOSALS,
        confidence=0.999,
    )
    if matrix is None or int(is_agreeing.sum()) < LEAST_CORNERS:
        return None
    parameters = np.array([matrix[0, 0], matrix[1, 0], matrix[0, 2], matrix[1, 2]])
    return parameters if 1 / MOST_SCALE <= float(np.hypot(*parameters[:2])) <= MOST_SCALE else None


def _link(first: Features, second: Features, found: Fitted, share: float, numbers: tuple[int, int]) -> Link:
    """The motion in pixels of the images, of which a share of the cells tells."""
    (right, down, turn, log_scale), covariance = found.pose()
    covariance = covariance + unmeasured_covariance(np.array([right, down]), max(first.picture_hw.shape), share)
    units = np.array([first.scale, first.scale, 1.0, 1.0])
    return Link(
        *numbers,
        (right * first.scale, down * first.scale),
        float(turn),
        float(log_scale + np.log(first.scale / second.scale)),
        as_rows(covariance * np.outer(units, units)),
        LinkSource.PIXELS,
    )


def unmeasured_covariance(move: np.ndarray, edge: int, share: float) -> np.ndarray:
    """(4, 4) of what two images alone do not tell: tilt of the first one, relief of the ground.

    Args:
        move: (2,) right and down, working pixels.
        edge: Of the first picture, working pixels.
        share: Of the cells that agree.

    Returns:
        Of right, down (working pixels), turn and log scale.

    A tilt along the way shortens or lengthens it by its square, and what lies there by one and a half times the way on
    average over both directions; a tilt across the way shears, which turns by half of it.
    """
    way = float(np.hypot(*move)) / edge
    along, across = np.array([*(move * way), 0.0, 1.5 * way]), np.array([0.0, 0.0, 0.5 * way, 0.0])
    tilt = TILT_SPREAD**2 * (np.outer(along, along) + np.outer(across, across))
    relief = (1 - share) ** 2 * way * np.array(RELIEF_SHARES)[[0, 0, 1, 2]] * [edge, edge, 1.0, 1.0]
    return tilt + np.diag(relief**2)
