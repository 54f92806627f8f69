"""The curve of map correlation's risk: right and wrong places of three places, by lead and by detail."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from bench import area_reliability, inputs, page
from bench.reliability import Told

from calibration.trials import logistic_fit
from semref.core.correlation.settings import CORRELATION
from semref.core.evaluation.trial import RIGHT_SHARE

PLACES = (area_reliability.LIECHTENSTEIN, area_reliability.CHRISTCHURCH, area_reliability.TILES)
OFFSETS, LEADS, DETAILS = (-5.2, -4.9, -4.6, -4.3), (4.5, 5.5, 6.5, 8.0, 12.0), (0.5, 0.6, 0.7, 0.8)
LARGEST_ERROR = 0.0185
COLUMNS = ("offset, lead, surprise", *(f"{name}: error; wrong below 1 %; right below 0.01 %" for name in PLACES))


def areas(run: inputs.Run) -> str:
    """Logistic curves of each place and of all alike, and what curves around them give at each place."""
    found = {name: list(area_reliability.kept(run, name, run.count)) for name in PLACES}
    said = {name: [one for places in found[name] for one in area_reliability.judged(places)] for name in PLACES}
    others = [p[1] for places in found[PLACES[0]] for p in places.own + places.mirrored if p[2] > RIGHT_SHARE]
    rows = []
    for curve in itertools.product(OFFSETS, LEADS, DETAILS):
        settings = replace(CORRELATION, confidence_curve=curve)
        told = [[t for places in found[n] for t in area_reliability.judged(places, settings)] for n in PLACES]
        errors = [calibration_error(some) for some in told]
        if max(errors) <= LARGEST_ERROR or curve == CORRELATION.confidence_curve:
            rows.append([", ".join(f"{value:g}" for value in curve), *map(_cell, errors, told)])
    return "\n".join(
        [
            f"details of wrong places: median {np.median(others):.2f}, spread of the inner half "
            f"{np.subtract(*np.quantile(others, (0.75, 0.25))) / 1.35:.2f}",
            *(f"logistic curve of {name}: {_fit([said[name]])}" for name in PLACES),
            f"of all three alike: {_fit(list(said.values()))}",
            "",
            page.table(COLUMNS, rows),
        ]
    )


def calibration_error(told: Sequence[Told]) -> float:
    """Expected, over tenths of the told probability."""
    chances = np.array([1 - one.risk for one in told])
    tenths = np.minimum((10 * chances).astype(int), 9)
    off = chances - np.array([one.is_right for one in told])
    return float(sum(abs(off[tenths == tenth].sum()) for tenth in range(10)) / len(told))


def _cell(error: float, told: Sequence[Told]) -> str:
    wrong = sum(one.risk < 1e-2 and not one.is_right for one in told)
    return f"{error:.4f}; {wrong}; {sum(one.risk < 1e-4 and one.is_right for one in told)}"


def _fit(places: Sequence[Sequence[Told]]) -> str:
    """Offset, slope of the lead and of the surprise; as many of each place, drawn again where there are fewer."""
    rng, most = np.random.default_rng(0), max(map(len, places))
    drawn = [some[n] for some in places for n in rng.permutation(np.resize(np.arange(len(some)), most))]
    seen = np.array([[one.rival, one.log_odds] for one in drawn])
    return str(np.round(logistic_fit(seen, np.array([one.is_right for one in drawn], float)), 2))
