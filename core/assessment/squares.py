"""Assessed squares of ground as rows of a layer, with the reasons for failing images."""

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
from ..values import schema
from .assessment import WRONG, Estimates
from .cells import Cells

FIELDS = schema(
    "footprint real, success real, success_low real, success_high real, error real, objects real, "
    "classes integer, distinctiveness real, look_alikes real, wrong real, trials integer, verdict text, "
    "reason text"
)
"""Columns of the squares as a layer, with their types."""

VERDICTS = ("hardly_ever", "sometimes", "often", "reliably", "very_reliably")
"""From the worst to the best."""


def verdict_edges(threshold: float) -> tuple[float, ...]:
    """Return the least success of each of VERDICTS, and 1 at the end; the upper two are good enough.

    Args:
        threshold: Success that is good enough, 0…1.
    """
    return 0.0, threshold / 3, 2 * threshold / 3, threshold, (1 + threshold) / 2, 1.0


def footprint_sizes(text: str, default: float) -> list[float]:
    """Return the numbers of a list with ``;`` between them.

    Args:
        default: For an empty list.

    Raises:
        ParameterError: The text is not such a list.
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
            "“{text}” is not a list of footprint widths. Enter numbers in m with “;” between them.", text=text
        )
    return list(dict.fromkeys(sizes)) or [default]


def reason_sentence(reason: str, landmarks: float) -> Sentence | None:
    """Return the main reason against a right fix; None without one.

    Args:
        reason: Of ``assessment.REASONS``, or empty.
        landmarks: In view, on average.
    """
    if reason == Status.TOO_FEW_REFERENCES.key:
        return Sentence("Too few landmarks: {landmarks:.0f} in view on average.", landmarks=landmarks)
    if reason == Status.AMBIGUOUS.key:
        return Sentence("Similar places: another place or the mirrored image matches almost as well.")
    if reason == Status.NO_MATCH.key:
        return Sentence(
            "Too little evidence: the landmarks ({landmarks:.0f} in view) do not match the map closely enough.",
            landmarks=landmarks,
        )
    return Sentence("Some fixes would be wrong.") if reason == WRONG else None


def square_rows(  # noqa: PLR0913 - squares, their estimates, and how to word them
    cells: Cells,
    windows: Windows,
    footprint: float,
    estimates: Estimates,
    threshold: float,
    wording: Callable[[Sentence], str] = english,
) -> Iterator[dict[str, Any]]:
    """Yield the values of each square by the names of FIELDS; None if unknown.

    Args:
        footprint: Footprint width of the images, m.
        threshold: Success that is good enough, 0…1.
        wording: Converts a reason to text.
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
    """Return the values of the n-th place, by the columns that squares and points along a route share."""
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
    """Return that of the window nearest to each place, of the level nearest to the footprint; NaN if unknown."""
    sizes, known = np.unique(windows.sizes), windows.distinctiveness
    if known is None or not len(sizes):
        return [math.nan] * len(places)
    chosen = np.flatnonzero(windows.sizes == sizes[np.abs(np.log(sizes / footprint)).argmin()])
    middle = windows.centers[chosen].mean(axis=0)
    points, queries = ((xy - middle).astype(np.float32) for xy in (windows.centers[chosen], places))
    number, squared = nearest(points, queries, 1)
    found = known[chosen[number[:, 0]]]
    # A window without the place has no information about it.
    return np.where(squared[:, 0] <= (footprint / 2) ** 2, found, np.nan).tolist()
