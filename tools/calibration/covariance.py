"""What told covariances are worth under other settings of the errors that landmarks share.

The same images, of rows of tools/bench coverage, are localized under every setting. A setting is better whose score is
lower: the mean of ln of the told density at the true place, its sign changed, which asks for radii that are neither too
large nor too small; coverage stands beside it.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from bench import coverage, inputs, page
from bench.ground import Ground

from calibration.settings import VARIANTS
from semref.core.evaluation.summary import held_shares, percentile
from semref.core.evaluation.trial import Trial
from semref.core.geometry.error_settings import ERRORS

SEED = 2103
COLUMNS = ("setting", "score", "score of the worst row", "50 %", "95 %", "99 %", "median 95 % radius")
BOTTOM = 1e-12
"""m⁴: a covariance's least determinant."""


def covariance(run: inputs.Run) -> str:
    """A row a setting, over all images, and a table of the 95 % ellipse by row and setting."""
    ground = Ground.of(run)
    rows = [row for row in (*coverage.LEVEL, *coverage.CAMERAS, *coverage.SHIFTS[:3]) if run.wants(row.name)]
    found: dict[str, dict[str, list[Trial]]] = {name: {} for name in VARIANTS}
    for number, row in enumerate(rows):
        for name, trials in _tried(ground, row, run.count, number).items():
            found[name][row.name] = trials
        held = {name: _share(by_row[row.name]) for name, by_row in found.items()}
        print(f"  {row.name}: {held}", file=sys.stderr, flush=True)
    table = page.table(COLUMNS, [_row(name, by_row) for name, by_row in found.items()])
    by_row = [[row.name, *(_share(found[name][row.name]) for name in VARIANTS)] for row in rows]
    return f"{table}\n\nIn the 95 % ellipse:\n\n{page.table(('images', *VARIANTS), by_row)}"


def _tried(ground: Ground, row: coverage.Row, count: int, number: int) -> dict[str, list[Trial]]:
    """Right fixes of the same images under every setting."""
    found: dict[str, list[Trial]] = {}
    for name, changes in VARIANTS.items():
        known = ground.localizer.errors
        ground.localizer.errors = replace(known, settings=replace(ERRORS, **changes))
        try:
            trials = coverage.tried(ground, row, count, np.random.default_rng([SEED, number]))
            found[name] = [trial for trial in trials if trial.is_right]
        finally:
            ground.localizer.errors = known
    return found


def _row(name: str, by_row: dict[str, list[Trial]]) -> list[str]:
    every = [trial for trials in by_row.values() for trial in trials]
    scores = [float(np.mean(list(_scores(trials)))) for trials in by_row.values() if trials]
    cells = [name, f"{np.mean(list(_scores(every))):.3f}", f"{max(scores):.3f}"]
    cells += [f"{rate.share:.1%}" for rate in held_shares(every)]
    return [*cells, f"{percentile([trial.result.error_95_m for trial in every], 50):.2f} m"]


def _scores(trials: Sequence[Trial]) -> Iterator[float]:
    """−ln of the told Gaussian's density at the truth, map units."""
    for trial in trials:
        off = np.subtract(trial.result.best.position, trial.query.view.position)
        spread = np.array(trial.result.covariance.position)
        determinant = max(float(np.linalg.det(spread)), BOTTOM)
        yield float(off @ np.linalg.solve(spread, off) / 2 + np.log(determinant) / 2 + np.log(2 * np.pi))


def _share(trials: Sequence[Trial]) -> str:
    rate = held_shares(trials)[1]
    return f"{rate.share:.0%} of {rate.trials}" if rate.trials else "–"
