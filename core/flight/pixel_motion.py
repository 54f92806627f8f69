"""Relative motion of two overlapping images from their pixels: a link with its covariance, or why there is no link.

See docs/explanation/method.md#relative-motion. Matching corners propose a motion. Cells of the overlap, each searched
in the other image, confirm it: most of them must agree.
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
"""Largest ratio of the best to the second-best descriptor distance."""

PROPOSED_WITHIN_PX = 4.0
PROPOSALS = 4000
LEAST_CORNERS = 5
"""Tolerance of agreeing corners (working pixels), tried pairs of corners, and least number of agreeing corners."""

MOST_SCALE = 2.0
"""Largest ratio of ground size, across the longer edge, of two images of one flight."""

LEAST_AGREEING = 7
CHANCE = 0.03
LEAST_EVIDENCE = 7.0
"""Least number of agreeing cells, and limit for chance: if a cell agreed with a wrong motion with probability
``CHANCE``, as many would agree with probability below exp(−evidence). From low cameras, trees and roofs leave few cells
on the ground."""

AGREES_WITHIN_PX = 2.5
"""Tolerance of agreeing cells, working pixels."""

TILT_SPREAD = 0.0165
"""Standard deviation of an unknown tilt, to either side, divided by the focal length in edges: up to 2° in any
direction for a field of view of 60°."""

RELIEF_SHARES = (0.03, 0.075, 0.075)
"""Added uncertainty if no cell agrees, proportional to the distance. It decreases with the square of the share of cells
that disagree: trees, roofs and slopes move differently from the ground."""

ROUNDS = 2
"""Cells are searched by the proposed motion, then by the fitted one."""


@dataclass(frozen=True)
class Motion:
    """Result for two images.

    Attributes:
        link: The motion; None without one.
        reason: Why there is no motion; None with a link.
        is_apart: Whether the images have enough texture to show a common motion, and show none.
    """

    link: Link | None
    reason: Sentence | None = None
    is_apart: bool = False


def motion_between(first: Features, second: Features, numbers: tuple[int, int] = (0, 1)) -> Motion:
    """Return the motion from one image to another."""
    if min(len(first.points), len(second.points)) < LEAST_CORNERS:
        return Motion(None, Sentence("One of the two images has too little texture to match it with the other."))
    proposed = _propose(first, second)
    if proposed is None:
        return Motion(None, Sentence("No common motion matches the two images. They may show different ground."), True)
    mapping: Mapping = partial(similarity, proposed)
    motion = Motion(None)
    for _ in range(ROUNDS):
        ground = SharedGround(first, second, mapping)
        at_second, at_first = ground.match_cells()
        found = fit_mapping(at_second, at_first, AGREES_WITHIN_PX) if len(at_first) >= LEAST_AGREEING else None
        agreeing, cells = 0 if found is None else int(found.is_used.sum()), len(ground.corners)
        if found is None or agreeing < LEAST_AGREEING or evidence(agreeing, cells) < LEAST_EVIDENCE:
            reason = Sentence(
                "In the overlap of the two images, only {agreeing} of {cells} parts match.",
                agreeing=agreeing,
                cells=cells,
            )
            return Motion(None, reason, True)
        mapping = found.mapping
        motion = Motion(_link(first, second, found, agreeing / cells, numbers))
    return motion


def evidence(agreeing: int, cells: int) -> float:
    """Return the evidence against chance: Chernoff's bound of the binomial tail, nats; 0 if chance suffices."""
    share = agreeing / cells
    if share <= CHANCE:
        return 0.0
    others = (1 - share) * math.log((1 - share) / (1 - CHANCE)) if share < 1 else 0.0
    return cells * (share * math.log(share / CHANCE) + others)


def _propose(first: Features, second: Features) -> np.ndarray | None:
    """Return (4,) parameters of the similarity that most matching corners agree with; None if too few agree."""
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
    """Return the motion in pixels of the images, from the share of cells that agree."""
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
    """Return (4, 4) of what two images can't show: tilt of the first image and relief of the ground.

    Args:
        move: (2,) right and down, working pixels.
        edge: Of the first picture, working pixels.
        share: Of the cells that agree.

    Returns:
        Covariance of right, down (working pixels), turn and log scale.

    Tilt along the motion changes its length with the square of the length, and the scale by one and a half times the
    length on average. Tilt across the motion shears the image, which rotates it by half of that.
    """
    way = float(np.hypot(*move)) / edge
    along, across = np.array([*(move * way), 0.0, 1.5 * way]), np.array([0.0, 0.0, 0.5 * way, 0.0])
    tilt = TILT_SPREAD**2 * (np.outer(along, along) + np.outer(across, across))
    relief = (1 - share) ** 2 * way * np.array(RELIEF_SHARES)[[0, 0, 1, 2]] * [edge, edge, 1.0, 1.0]
    return tilt + np.diag(relief**2)
