"""An evaluation as JSON: for scripts that compare databases, methods or versions. Same seed, same text."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import Any, Dict, Sequence

from ...core.evaluation.evaluation import MAP, MIRRORED, NOISE_LEVELS, ROTATION, SCALING, Outcome
from ...core.evaluation.rates import Rate
from ...core.evaluation.summary import (
    RateAt,
    noise_rates,
    of_method,
    reliability,
    success_by_landmarks,
    success_by_offset,
    summarize,
)

FORMAT = "semref evaluation 1"


def evaluation_json(outcomes: Sequence[Outcome], methods: Sequence[str], settings: Dict[str, Any]) -> str:
    """settings: as they were given; methods: the most important first, whose grid of noise it is."""
    content = {
        "format": FORMAT,
        "settings": settings,
        "methods": {method: _method(outcomes, method) for method in methods},
        "noise": {
            "method": methods[0],
            "percent": NOISE_LEVELS,
            "missed_by_invented": [[_rate(rate) for rate in row] for row in noise_rates(outcomes)],
        },
        "trials": [values_of(o) for method in methods for o in of_method(outcomes, method, MAP, MIRRORED)],
        "scaling": [values_of(o) for method in methods for o in of_method(outcomes, method, SCALING)],
        "rotation": [values_of(o) for method in methods for o in of_method(outcomes, method, ROTATION)],
    }
    return json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False)


def values_of(outcome: Outcome) -> Dict[str, Any]:
    """One outcome by the names of OUTPUT's columns."""
    query, result = outcome.query, outcome.result
    x, y = result.position or (None, None)
    return {
        "trial": query.number,
        "kind": query.part,
        "method": outcome.method,
        "status": result.status,
        "right": int(outcome.right),
        "error": outcome.error,
        "heading_error": outcome.heading_error_deg,
        "scale_error": outcome.scale_error,
        "confidence": result.confidence,
        "error_95": result.error_95_m,
        "true_x": query.position[0],
        "true_y": query.position[1],
        "x": x,
        "y": y,
        "window": outcome.window,
        "heading": query.heading_deg,
        "scale": query.scale,
        "offset": query.offset,
        "missed": 100 * query.noise.missed,
        "invented": 100 * query.noise.invented,
        "misnamed": 100 * query.noise.misnamed,
        "ragged": query.ragged,
        "landmarks": query.landmarks,
        "references": result.references,
        "inliers": result.inliers,
        "distance": result.distance,
        "log_odds": result.log_odds,
        "reason": result.reason,
    }


def _method(outcomes: Sequence[Outcome], method: str) -> Dict[str, Any]:
    summary = summarize(outcomes, method)
    values = {name: _rate(value) if isinstance(value, Rate) else value for name, value in vars(summary).items()}
    values["success_by_offset"] = [_rate_at(one) for one in success_by_offset(outcomes, method)]
    values["success_by_landmarks"] = [_rate_at(one) for one in success_by_landmarks(outcomes, method)]
    values["reliability"] = [_rate_at(one) for one in reliability(outcomes, method)]
    return values


def _rate(rate: Rate) -> Dict[str, Any]:
    low, high = rate.interval
    return {**asdict(rate), "share": rate.share, "low": low, "high": high}


def _rate_at(one: RateAt) -> Dict[str, Any]:
    return {"mean": one.at, "from": one.low, **_rate(one.rate)}
