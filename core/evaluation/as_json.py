"""An evaluation as JSON, for scripts that compare databases, methods or versions. The same seed gives the same text."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any, Callable, cast

from ..localizer.record import record
from ..sentences import Sentence, english
from ..values import schema
from .evaluation import MAP, MIRRORED, NOISE_LEVELS, ROTATION, SCALING, WindowQuery
from .rates import Rate, RateAt
from .summary import (
    HELD_SHARES,
    AccuracySummary,
    accuracy_summaries,
    noise_rates,
    of_method,
    reliability,
    success_by_landmarks,
    success_by_offset,
    summarize,
)
from .trial import Trial

FORMAT = "semref evaluation 1"

FIELDS = schema(
    "trial integer, kind text, method text, status text, right integer, error real, heading_error real, "
    "scale_error real, confidence real, error_95 real, true_x real, true_y real, x real, y real, window text, "
    "heading real, scale real, offset real, missed real, invented real, misnamed real, ragged real, "
    "landmarks integer, references integer, inliers integer, distance real, log_odds real, reason text, "
    "background real, displaced real, shifted real, leaning real, lens real, tilt real, road text, "
    "radius_ratio real"
)
"""Columns of the trials as a layer, with their types."""


def evaluation_json(
    trials: Sequence[Trial], methods: Sequence[str], settings: dict[str, Any], tried_windows: Rate
) -> str:
    """Return an evaluation as JSON text.

    Args:
        methods: The most important one first; the grid of noise uses it.
        tried_windows: Windows that images were taken around, of all windows.
    """
    content = {
        "format": FORMAT,
        "settings": settings,
        "windows": {"tried": tried_windows.successes, "all": tried_windows.trials},
        "methods": {method: _method(trials, method) for method in methods},
        "noise": {
            "method": methods[0],
            "percent": NOISE_LEVELS,
            "missed_by_invented": [[_rate(rate) for rate in row] for row in noise_rates(trials)],
        },
        "trials": [values_of(t) for method in methods for t in of_method(trials, method, MAP, MIRRORED)],
        "scaling": [values_of(t) for method in methods for t in of_method(trials, method, SCALING)],
        "rotation": [values_of(t) for method in methods for t in of_method(trials, method, ROTATION)],
    }
    return json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False)


def values_of(trial: Trial, wording: Callable[[Sentence], str] = english) -> dict[str, Any]:
    """Return a trial by the names of OUTPUT's columns; ``wording`` converts its reason to text."""
    query = cast(WindowQuery, trial.query)
    view, known = query.view, record(trial.result, wording)
    return {
        "trial": query.number,
        "kind": query.kind,
        "method": trial.method.key,
        "status": known["status"],
        "right": int(trial.is_right),
        "error": trial.error,
        "heading_error": trial.heading_error_deg,
        "scale_error": trial.scale_error,
        "confidence": known["confidence"],
        "error_95": known["error_95"],
        "true_x": view.x,
        "true_y": view.y,
        "x": known["x"],
        "y": known["y"],
        "window": trial.window,
        "heading": view.heading_deg,
        "scale": query.scale,
        "offset": query.offset,
        "missed": 100 * query.noise.missed,
        "invented": 100 * query.noise.spurious,
        "misnamed": 100 * query.noise.mislabeled,
        "ragged": query.noise.jitter,
        "landmarks": trial.landmarks,
        **{name: known[name] for name in ("references", "inliers", "distance", "log_odds", "reason")},
        "background": 100 * query.noise.background,
        "displaced": query.noise.displaced,
        "shifted": query.shifted,
        "leaning": 100 * query.noise.leaning,
        "lens": 100 * view.lens,
        "tilt": view.tilt_deg,
        "road": trial.result.method.key,
        "radius_ratio": trial.radius_ratio,
    }


def _method(trials: Sequence[Trial], method: str) -> dict[str, Any]:
    summary = summarize(trials, method)
    values = {name: _rate(value) if isinstance(value, Rate) else value for name, value in vars(summary).items()}
    values["success_by_offset"] = [_rate_at(one) for one in success_by_offset(trials, method)]
    values["success_by_landmarks"] = [_rate_at(one) for one in success_by_landmarks(of_method(trials, method, MAP))]
    values["roads"] = [_accuracy(one) for one in accuracy_summaries(of_method(trials, method, MAP, MIRRORED))]
    values["reliability"] = [_rate_at(one) for one in reliability(trials, method)]
    return values


def _accuracy(one: AccuracySummary) -> dict[str, Any]:
    """Return a summary under the keys of the file format, in which a method is a “road”."""
    values = {name: getattr(one, name) for name in ("calibration_error", "median_radius", "median_error")}
    held = {f"held_{100 * share:.0f}": _rate(rate) for share, rate in zip(HELD_SHARES, one.contained)}
    return {"road": one.method.key, "right": _rate(one.right), "told": one.confidence, **values, **held}


def _rate(rate: Rate) -> dict[str, Any]:
    low, high = rate.interval
    return {**asdict(rate), "share": rate.share, "low": low, "high": high}


def _rate_at(one: RateAt) -> dict[str, Any]:
    return {"mean": one.at, "from": one.low, **_rate(one.rate)}
