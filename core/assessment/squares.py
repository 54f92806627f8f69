"""Assessed squares of ground as rows of a layer, and why images fail there."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, Callable

import numpy as np

from ..constellation.neighbors import nearest
from ..database.model import Windows
from ..errors import ParameterError
from ..localization import Status
from ..sentences import Sentence, english
from .assessment import WRONG, Estimates
from .cells import Cells

FIELDS = (
    ("footprint", "real"),
    ("success", "real"),
    ("success_low", "real"),
    ("success_high", "real"),
    ("error", "real"),
    ("objects", "real"),
    ("classes", "integer"),
    ("distinctiveness", "real"),
    ("look_alikes", "real"),
    ("wrong", "real"),
    ("trials", "integer"),
    ("verdict", "text"),
    ("reason", "text"),
)
"""Columns of the squares as a layer, with their types."""

VERDICTS = ("hardly_ever", "sometimes", "often", "reliably", "very_reliably")
"""From the worst to the best."""


def verdict_edges(threshold: float) -> tuple[float, ...]:
    """Success from which each of VERDICTS is given, and 1 at the end; the upper two are good enough.

    Args:
        threshold: Success that is good enough, 0…1.
    """
    return 0.0, threshold / 3, 2 * threshold / 3, threshold, (1 + threshold) / 2, 1.0


def footprint_sizes(text: str, default: float) -> list[float]:
    """Numbers of a list separated by ``;``.

    Args:
        default: For an empty one.

    Raises:
        ParameterError: For anything else.
    """
    sizes = []
    for part in (text or "").split(";"):
        if part.strip():
            try:
                sizes.append(float(part.replace(",", ".")))
            except ValueError:
                sizes.append(math.nan)
    if not all(0 < size < math.inf for size in sizes):
        raise ParameterError(
            "“{text}” is no list of footprints; give edges of the ground in map units, separated by “;”.", text=text
        )
    return list(dict.fromkeys(sizes)) or [default]


def reason_sentence(reason: str, landmarks: float) -> Sentence | None:
    """What keeps most images from a right fix; None where nothing does.

    Args:
        reason: Of ``assessment.REASONS``, or empty.
        landmarks: In view, on average.
    """
    if reason == Status.TOO_FEW_REFERENCES.key:
        return Sentence("Too few landmarks: {landmarks:.0f} in view on average.", landmarks=landmarks)
    if reason == Status.AMBIGUOUS.key:
        return Sentence("Look-alikes: another place, or the mirrored image, fits almost as well.")
    if reason == Status.NO_MATCH.key:
        return Sentence(
            "Too little evidence: landmarks ({landmarks:.0f} in view) agree with the map too loosely.",
            landmarks=landmarks,
        )
    return Sentence("Some fixes would be wrong.") if reason == WRONG else None


def square_rows(  # noqa: PLR0913 - what is told of squares, and in which words
    cells: Cells,
    windows: Windows,
    footprint: float,
    estimates: Estimates,
    threshold: float,
    wording: Callable[[Sentence], str] = english,
) -> Iterator[dict[str, Any]]:
    """What is told of each square, by the names of FIELDS; None for what is not known.

    Args:
        footprint: Edge of the ground that images show.
        threshold: Success that is good enough, 0…1.
        wording: How a reason is said.
    """
    unlike, inner = _nearest_distinctiveness(windows, cells.centers, footprint), verdict_edges(threshold)[1:-1]
    for n in range(len(cells)):
        expected = expectation(estimates, n, threshold, wording)
        yield {
            "footprint": footprint,
            **expected,
            "distinctiveness": unlike[n] if math.isfinite(unlike[n]) else None,
            "verdict": VERDICTS[sum(expected["success"] >= low for low in inner)],
        }


def expectation(
    estimates: Estimates, n: int, threshold: float, wording: Callable[[Sentence], str] = english
) -> dict[str, Any]:
    """What is told of the n-th place of some, by the columns that squares and points along a route share."""
    success, error, landmarks = (float(of[n]) for of in (estimates.success, estimates.error, estimates.landmarks))
    reason = None if success >= threshold else reason_sentence(estimates.reasons[n], landmarks)
    return {
        "success": success,
        "success_low": float(estimates.low[n]),
        "success_high": float(estimates.high[n]),
        "error": error if math.isfinite(error) else None,
        "objects": landmarks,
        "classes": int(estimates.classes[n]),
        "look_alikes": float(estimates.look_alikes[n]),
        "wrong": float(estimates.wrong[n]),
        "trials": int(estimates.trials[n]),
        "reason": "" if reason is None else wording(reason),
    }


def _nearest_distinctiveness(windows: Windows, places: np.ndarray, footprint: float) -> list[float]:
    """Of the window nearest to each place, of the level whose size is nearest to the footprint; NaN where unknown."""
    sizes, known = np.unique(windows.sizes), windows.distinctiveness
    if known is None or not len(sizes):
        return [math.nan] * len(places)
    chosen = np.flatnonzero(windows.sizes == sizes[np.abs(np.log(sizes / footprint)).argmin()])
    middle = windows.centers[chosen].mean(axis=0)
    points, queries = ((xy - middle).astype(np.float32) for xy in (windows.centers[chosen], places))
    number, squared = nearest(points, queries, 1)
    found = known[chosen[number[:, 0]]]
    # A window that doesn't hold the place says nothing about it.
    return np.where(squared[:, 0] <= (footprint / 2) ** 2, found, np.nan).tolist()
