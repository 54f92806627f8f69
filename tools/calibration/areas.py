"""Leads and details of map correlation's right and wrong places, and the curve of its risk."""

from __future__ import annotations

import numpy as np
from bench import area_reliability, inputs

from calibration.trials import logistic_fit
from semref.core.evaluation.trial import RIGHT_SHARE

TAIL = 0.1
"""Of wrong places, those whose excess tells how fast they become rarer."""


def areas(run: inputs.Run) -> str:
    """Leads and details of map correlation's right and wrong places, and the curve of its risk."""
    found = list(area_reliability.kept(run, "liechtenstein", run.count))
    told = [one for places in found for one in area_reliability.judged(places)]
    others = [place[1] for one in found for place in one.own + one.mirrored if place[2] > RIGHT_SHARE]
    is_right = np.array([one.is_right for one in told])
    leads, details = np.array([one.rival for one in told]), np.array([one.log_odds for one in told])
    slopes = [1 / _tail(values[~is_right]) for values in (leads, details)]
    worth = slopes[0] * leads + slopes[1] * details
    return "\n".join(
        [
            f"details of wrong places: median {np.median(others):.2f}, spread of the inner half "
            f"{np.subtract(*np.quantile(others, (0.75, 0.25))) / 1.35:.2f}",
            _ends("leads", leads, is_right),
            _ends("surprises", details, is_right),
            f"correlation of both at wrong places: {np.corrcoef(leads[~is_right], details[~is_right])[0, 1]:.2f}",
            f"worth a unit in the tail of wrong places: of leads {slopes[0]:.2f}, of surprises {slopes[1]:.2f}; "
            f"of their sum {1 / _tail(worth[~is_right]):.2f}",
            "logistic curve: offset, leads, surprises "
            + str(np.round(logistic_fit(np.column_stack([leads, details]), is_right.astype(float)), 2)),
        ]
    )


def _tail(values: np.ndarray) -> float:
    """Mean excess of the highest tenth: of an exponential tail, its length."""
    first = np.quantile(values, 1 - TAIL)
    return float((values[values > first] - first).mean())


def _ends(name: str, values: np.ndarray, is_right: np.ndarray) -> str:
    wrong, right = np.sort(values[~is_right])[::-1], np.sort(values[is_right])
    return (
        f"{name}: highest of {len(wrong)} wrong places {wrong[:8].round(2)}, lowest of {len(right)} right ones "
        f"{right[:12].round(2)}"
    )
