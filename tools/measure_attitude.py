"""Measure localization of tilted cameras, with and without leveling, on Liechtenstein 2021; prints a Markdown table.

    python tools/measure_attitude.py [--trials 100] [--tilts 10,20,30] [--error 1] [--half south|north|both] [--seed 1]

The same queries are localized as they are, leveled with their true attitude, and leveled with roll and pitch wrong by
normal errors of --error degrees each. The camera sees 60° across; 20 % of the objects in the image are missed, 20 %
invented, 5 % misnamed (``measure_constellation``'s “goal”). Right: a fix within 2 % of the footprint's edge.
"""

from __future__ import annotations

import argparse
import sys
import time
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
# First, because it loads the package and sets the number of threads.
import measure_constellation as constellation  # noqa: I001
import cv2
import numpy as np
from measure_constellation import CLASSES, DATA, GOAL, IMAGE_PX, LAYER, MINIMUM_AREA_M2, PIXEL_SIZES_M
from semref.core.simulation.noise import spoil_landmarks
from semref.core.simulation.views import PIXELS, View, cut, random_view
from semref.core.geometry.leveling import Attitude, focal_length_from_view, leveling
from semref.core.constellation.solver import localize
from semref.core.constellation.index import build_index
from semref.core.localization import Prior
from semref.core.geometry.pose import turn_of
from semref.core.landmarks.landmarks import extract_landmarks

SHAPE = (IMAGE_PX, IMAGE_PX)
SMALLEST_PX = max(MINIMUM_AREA_M2 / PIXEL_SIZES_M[1] ** 2, 9)
LEAST_OBJECTS = 20


def main() -> int:
    options = parse()
    if not (DATA / LAYER).exists():
        print(f"measure_attitude: the real data is not here: {DATA / LAYER}")
        return 0
    cv2.setNumThreads(1)
    area = constellation.Area(constellation.rasterize(DATA / LAYER), options.half)
    index = build_index(area.references(), 1.0)
    print("| tilt | images | right fixes | wrong fixes | median error of the right ones | leveling, ms |")
    print("|---|---|---|---|---|---|", flush=True)
    for tilt_deg in options.tilts:
        rng = np.random.default_rng([options.seed, int(10 * tilt_deg)])
        queries = [query(area, tilt_deg, rng) for _ in range(options.trials)]
        wrongs = rng.normal(0, options.error, (options.trials, 2))
        rows = {
            "as they are": [None] * options.trials,
            "leveled": np.zeros((options.trials, 2)),
            f"leveled, roll and pitch ± {options.error:g}°": wrongs,
        }
        for name, errors in rows.items():
            outcomes = [trial(area, index, *queries[n], errors[n], [options.seed, n]) for n in range(options.trials)]
            print_row(f"| {tilt_deg:g}° | {name}", outcomes)
    return 0


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--trials", type=int, default=100)
    parser.add_argument("--tilts", default="10,20,30", help="degrees, separated by commas")
    parser.add_argument("--error", type=float, default=1.0, help="standard deviation of roll and of pitch, degrees")
    parser.add_argument("--half", choices=("north", "south", "both"), default="south")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    options.tilts = [float(tilt) for tilt in options.tilts.split(",")]
    return options


def query(area: constellation.Area, tilt_deg: float, rng: np.random.Generator) -> tuple:
    """(view, labels) with at least LEAST_OBJECTS whole objects in the image."""
    while True:
        view = random_view(rng, area.extent, (IMAGE_PX, IMAGE_PX), (0.8, 1.25))
        view = replace(view, tilt_deg=tilt_deg, tilt_direction_deg=float(rng.uniform(0, 360)))
        near = np.abs(area.objects.centers_xy - (view.x, -view.y)).max(axis=1) < IMAGE_PX * view.pixel_size / 2
        if near.sum() < LEAST_OBJECTS / 2:
            continue
        labels = cut(area.labels, PIXELS, view)
        found = extract_landmarks(labels, CLASSES, MINIMUM_AREA_M2 / view.pixel_size**2)
        if (~found.touches_edge).sum() >= LEAST_OBJECTS:
            return view, labels


def attitude_of(view: View, errors_deg: np.ndarray) -> Attitude:
    """Roll and pitch of a view, plus errors."""
    tilt, direction = np.radians((view.tilt_deg, view.tilt_direction_deg))
    pitch = np.arcsin(np.sin(tilt) * np.cos(direction))
    roll = np.arctan2(np.sin(tilt) * np.sin(direction), np.cos(tilt))
    return Attitude(float(np.degrees(roll) + errors_deg[0]), float(np.degrees(pitch) + errors_deg[1]))


def trial(area: constellation.Area, index, view: View, labels: np.ndarray, errors_deg, seed: list) -> tuple:
    """(is a fix, error as a share of the footprint's edge, seconds of leveling)."""
    middle, seconds = 0j, 0.0
    if errors_deg is not None:
        started = time.process_time()
        focal = focal_length_from_view(view.field_of_view_deg, SHAPE)
        way = leveling(attitude_of(view, errors_deg), focal, SHAPE)
        labels, middle = way.level(labels), way.middle
        seconds = time.process_time() - started
    height, width = labels.shape
    objects = extract_landmarks(labels, CLASSES, SMALLEST_PX)
    population = replace(area.objects, areas_px=area.objects.areas_px / view.pixel_size**2)
    objects = spoil_landmarks(objects, GOAL, np.random.default_rng(seed), population, (width, height))
    found = localize(objects, width, height, index, Prior(pixel_size_range=PIXEL_SIZES_M))
    if not found.is_fix:
        return False, np.nan, seconds
    place = found.place
    center = complex(*place.position) - turn_of(place.heading_deg, place.pixel_size_m) * middle
    return True, abs(center - complex(*view.position)) / (IMAGE_PX * view.pixel_size), seconds


def print_row(start: str, outcomes: list) -> None:
    fixes = np.array([outcome[0] for outcome in outcomes])
    shares = np.array([outcome[1] for outcome in outcomes])
    right = fixes & (np.nan_to_num(shares, nan=1.0) <= constellation.RIGHT_TILTED)
    error = f"{100 * np.median(shares[right]):.2f} % of the footprint" if right.any() else "–"
    counts = int(right.sum()), int((fixes & ~right).sum())
    found, wrong = (constellation.rate_text(count, len(outcomes)) for count in counts)
    seconds = np.median([outcome[2] for outcome in outcomes])
    print(f"{start} | {found} | {wrong} | {error} | {1000 * seconds:.0f} |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
