"""What the trials of an evaluation say: rates with intervals, errors, curves."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np

from .evaluation import MAP, MIRRORED, NOISE, NOISE_LEVELS, OFFSET, OFFSETS, Outcome
from .rates import Rate, rate_of

CONFIDENCE_BINS = np.linspace(0, 1, 11)
LANDMARK_BINS = (0, 5, 10, 20, 40, 80)
"""Landmarks of the window around which an image lies, from each number to the next, the last without end."""


@dataclass(frozen=True)
class MethodSummary:
    """One method over all trials.

    right, wrong: fixes at the right and at a wrong place, of the images of the map; false_accepts: fixes of mirrored
    images; median_error, error_95: 50th and 95th percentile of right fixes (CEP50 and CEP95), map units;
    heading_error_deg, scale_error: medians of right fixes; covered: errors within the 95 % ellipse that was told;
    statuses: number of images of the map a status. None where nothing is known.
    """

    method: str
    right: Rate
    wrong: Rate
    false_accepts: Rate
    median_error: Optional[float]
    error_95: Optional[float]
    heading_error_deg: Optional[float]
    scale_error: Optional[float]
    covered: Rate
    statuses: Dict[str, int]


@dataclass(frozen=True)
class RateAt:
    """A rate of trials whose value lies around ``at``: their mean, the bin from ``low`` to ``high``."""

    at: float
    low: float
    high: float
    rate: Rate


def of_method(outcomes: Sequence[Outcome], method: str, *parts: str) -> List[Outcome]:
    """The outcomes of a method in some parts of the evaluation."""
    return [o for o in outcomes if o.method == method and o.query.part in parts]


def summarize(outcomes: Sequence[Outcome], method: str) -> MethodSummary:
    """Sums up a method's trials, images of the map and mirrored ones."""
    tried = of_method(outcomes, method, MAP)
    right = [o for o in tried if o.right]
    told = [o for o in right if o.ellipse_ratio is not None]
    return MethodSummary(
        method,
        rate_of(o.right for o in tried),
        rate_of(o.is_fix and not o.right for o in tried),
        rate_of(o.is_fix for o in of_method(outcomes, method, MIRRORED)),
        percentile([o.error for o in right], 50),
        percentile([o.error for o in right], 95),
        percentile([o.heading_error_deg for o in right], 50),
        percentile([o.scale_error for o in right], 50),
        rate_of(o.ellipse_ratio <= 1 for o in told),
        dict(sorted(Counter(o.result.status for o in tried).items())),
    )


def percentile(values: Sequence[Optional[float]], percent: float) -> Optional[float]:
    """Percentile of the values that are known; None when none is."""
    known = [value for value in values if value is not None]
    return float(np.percentile(known, percent)) if known else None


def success_by_offset(outcomes: Sequence[Outcome], method: str) -> List[RateAt]:
    """Right fixes of windows that were moved by each of OFFSETS."""
    edges = (*OFFSETS, np.inf)
    moved = of_method(outcomes, method, OFFSET)
    return _binned(moved, lambda o: round(o.query.offset, 6), edges, lambda o: o.right)


def success_by_landmarks(outcomes: Sequence[Outcome], method: str) -> List[RateAt]:
    """Right fixes by the number of landmarks that the database has in the window."""
    edges = (*LANDMARK_BINS, np.inf)
    return _binned(of_method(outcomes, method, MAP), lambda o: o.query.landmarks, edges, lambda o: o.right)


def reliability(outcomes: Sequence[Outcome], method: str) -> List[RateAt]:
    """Share of right ones among the fixes of a confidence, mirrored images among them."""
    fixes = [o for o in of_method(outcomes, method, MAP, MIRRORED) if o.is_fix]
    return _binned(fixes, lambda o: o.result.confidence, CONFIDENCE_BINS, lambda o: o.right)


def error_curve(outcomes: Sequence[Outcome], method: str) -> Tuple[np.ndarray, np.ndarray]:
    """Errors of all fixes in order (n,), and the share of the map's images with a fix at most so far off (n,)."""
    tried = of_method(outcomes, method, MAP)
    errors = np.sort([o.error for o in tried if o.is_fix])
    return errors, np.arange(1, len(errors) + 1) / max(len(tried), 1)


def noise_rates(outcomes: Sequence[Outcome]) -> List[List[Rate]]:
    """Right fixes of the noise grid: a row for each level missed, a column for each level invented."""
    tried = [o for o in outcomes if o.query.part == NOISE]
    levels = [level / 100 for level in NOISE_LEVELS]
    return [
        [rate_of(o.right for o in tried if (o.query.noise.missed, o.query.noise.invented) == pair) for pair in row]
        for row in ([(missed, invented) for invented in levels] for missed in levels)
    ]


def _binned(
    outcomes: Sequence[Outcome],
    value: Callable[[Outcome], float],
    edges: Sequence[float],
    success: Callable[[Outcome], bool],
) -> List[RateAt]:
    """One rate for each bin that has outcomes; the last bin includes its end."""
    values = np.array([value(o) for o in outcomes], float)
    numbers = np.clip(np.searchsorted(edges, values, side="right") - 1, 0, len(edges) - 2)
    found = []
    for number in np.unique(numbers):
        inside = np.flatnonzero(numbers == number)
        rate = rate_of(success(outcomes[i]) for i in inside)
        found.append(RateAt(float(values[inside].mean()), float(edges[number]), float(edges[number + 1]), rate))
    return found
