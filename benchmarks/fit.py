"""Fit settings to the records of scenarios: curves of the error probability, and the factor of the radius.

The solvers' settings (docs/reference/settings.md) are chosen from the output; this program changes nothing. Fit on one
place or pair of dates, then run the scenario on another.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from benchmarks.accuracy import AT_95
from benchmarks.results import Table
from semref.core.constellation.settings import CONSTELLATION


def run(work: Path, names: Sequence[str], only: Sequence[str]) -> Table:
    """Return a row for each curve and for the radius, from all records of scenarios."""
    some = [one for name in names for one in read_records(work, name, only)]
    rows = [["records", str(len(some))]]
    stars = [one for one in some if one["by"] == "constellation" and one["log_odds"] is not None]
    if stars:
        leads = np.array(
            [one["log_odds"] - CONSTELLATION.decision.rival_weight * max(one["rival"] or 0, 0) for one in stars]
        )
        scale = CONSTELLATION.decision.confidence_scale
        grown = np.where(leads > 0, scale * np.log1p(np.maximum(leads, 0) / scale), leads)
        rows.append(["constellation: offset, slope of the risk", _fitted(grown, stars)])
    areas = [one for one in some if one["by"] == "map correlation" and one["lead"] is not None]
    if areas:
        known = np.array([[one["lead"], one["detail"], one["outlines"] or 0.0] for one in areas])
        rows.append(["map correlation: confidence_curve (offset, lead, detail, outlines)", _fitted(known, areas)])
    ratios = [one["ratio"] for one in some if one["right"] and one["ratio"] is not None]
    if ratios:
        rows.append(["factor of the 95 % ellipse that contains 95 %", f"{np.quantile(ratios, 0.95):.2f}"])
        held = [f"{np.mean(np.array(ratios) * AT_95 <= np.sqrt(-2 * np.log(1 - share))):.3f}" for share in (0.5, 0.95)]
        rows.append(["contained in the 50 %, 95 % ellipse", ", ".join(held)])
    return {"columns": ["what", "fit"], "rows": rows}


def read_records(work: Path, name: str, only: Sequence[str]) -> list[dict]:
    """Return the records of a scenario's rows."""
    found = []
    for path in sorted((work / "records").glob(f"{name}_*.jsonl")):
        head, *lines = path.read_text(encoding="utf-8").splitlines()
        row = json.loads(head)["row"].casefold()
        if not only or any(part.casefold() in row for part in only):
            found += [json.loads(line) for line in lines]
    return found


def _fitted(known: np.ndarray, some: Sequence[dict]) -> str:
    right = np.array([float(one["best_right"]) for one in some])
    weights = ", ".join(f"{weight:.2f}" for weight in logistic_fit(known, right))
    return f"{weights} ({right.sum():.0f} of {len(right)} right)"


def logistic_fit(x: np.ndarray, y: np.ndarray, steps: int = 50) -> np.ndarray:
    """Fit a logistic curve to (N,) or (N, K) values and return offset and slopes. Damping keeps slopes finite."""
    design = np.column_stack([np.ones(len(x)), x])
    weights = np.zeros(design.shape[1])
    for _ in range(steps):
        chance = 1 / (1 + np.exp(-np.clip(design @ weights, -30, 30)))
        normal = (design * (chance * (1 - chance))[:, None]).T @ design + 1e-3 * np.eye(len(weights))
        weights += np.linalg.solve(normal, design.T @ (y - chance) - 1e-3 * weights)
    return weights
