"""Tilted cameras, with and without leveling: the same images as they are, leveled, and leveled a little wrongly."""

from __future__ import annotations

import sys
import time

import numpy as np

from bench import inputs, page
from bench.ground import COLUMNS, GOAL, Ground, Image, Wanted, cells
from semref.core.evaluation.trial import Trial, judge
from semref.core.geometry.leveling import Attitude, focal_length_from_view, leveling
from semref.core.localization import Method, Prior
from semref.core.localizer.leveled import localize_leveled
from semref.core.simulation.views import View

PAGE = "benchmarks.md"
SEED = 1
COUNT, QUICK_COUNT = 100, 2
TILTS_DEG = (10.0, 20.0, 30.0)
ERROR_DEG = 1.0


def measure(run: inputs.Run) -> dict[str, str]:
    ground, count = Ground.of(run), run.how_many(COUNT, QUICK_COUNT)
    rows, seconds = [], []
    for tilt_deg in TILTS_DEG[:1] if run.quick else TILTS_DEG:
        if not run.wants(f"{tilt_deg:g}°"):
            continue
        rng = np.random.default_rng([SEED, int(10 * tilt_deg)])
        trials: dict[str, list[Trial]] = {"as they are": [], "leveled": [], f"roll and pitch ± {ERROR_DEG:g}°": []}
        for _ in range(count):
            image = ground.spoiled(ground.draw(Wanted(tilt_deg=tilt_deg), rng), GOAL, rng)
            errors = (None, np.zeros(2), rng.normal(0, ERROR_DEG, 2))
            for tried, error in zip(trials.values(), errors):
                trial, took = _tried(ground, image, error)
                tried.append(trial)
                seconds += took
        for name, tried in trials.items():
            rows.append(cells(tried, f"{tilt_deg:g}°, {name}"))
            print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    low, high = 1000 * np.percentile(seconds, [5, 95])
    about = _ABOUT.format(error=ERROR_DEG, count=count, low=low, high=high)
    return {"tilted cameras": f"{about}\n\n{page.table(COLUMNS, rows)}"}


_ABOUT = """\
Constellation, field of view 60°, labels with 20 / 20 / 5 % noise, tilt in any direction; leveled with the true roll and
pitch, or with errors of σ {error:g}° in each. Right: within 2 % of the footprint; {count} images a row, the same ones
in the three rows of a tilt. Leveling takes {low:.0f}–{high:.0f} ms of processor time an image (5–95 %)."""


def _tried(ground: Ground, image: Image, errors_deg: np.ndarray | None) -> tuple[Trial, list[float]]:
    """One image, leveled unless ``errors_deg`` of roll and pitch is None; the seconds that leveling took."""
    if errors_deg is None:
        return ground.try_image(image, Method.CONSTELLATION), []
    shape = image.view.shape_hw
    started = time.process_time()
    focal = focal_length_from_view(image.view.field_of_view_deg, shape)
    way = leveling(attitude_of(image.view, errors_deg), focal, shape)
    way.level(image.labels_hw)
    leveled = time.process_time()
    scales = ground.localizer.settings.constellation.scales
    prior = Prior(pixel_size_range=ground.localizer.pixel_sizes(shape, scales))
    found = localize_leveled(ground.localizer, image.labels_hw, Method.CONSTELLATION, prior, way)
    seconds = time.process_time() - leveled
    return judge(image.query, Method.CONSTELLATION, found, None, image.landmarks, seconds), [leveled - started]


def attitude_of(view: View, errors_deg: np.ndarray) -> Attitude:
    """Roll and pitch of a view, plus errors."""
    tilt, direction = np.radians((view.tilt_deg, view.tilt_direction_deg))
    pitch = np.arcsin(np.sin(tilt) * np.cos(direction))
    roll = np.arctan2(np.sin(tilt) * np.sin(direction), np.cos(tilt))
    return Attitude(float(np.degrees(roll) + errors_deg[0]), float(np.degrees(pitch) + errors_deg[1]))
