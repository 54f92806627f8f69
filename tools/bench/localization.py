"""Constellation localization by docs/benchmarks.md's goals, end to end: a database and a label image in, a fix out."""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass, field, replace

import numpy as np

from bench import inputs, page
from bench.localization_trials import Outcome, QueryMap, Wanted, accuracy, milliseconds, rate

PAGE = "benchmarks.md"
SEED = 1671
COUNT = 300
QUICK_COUNT = 4
ROTATIONS_DEG = tuple(range(0, 360, 30))

RIGHT_M = 10.0
RIGHT_TILTED = 0.02
"""A fix is right within so many meters; of a tilted camera within this share of its footprint."""

NOISES = {"none": (0, 0, 0), "goal": (0.2, 0.2, 0.05), "hard": (0.4, 0.4, 0.1)}
"""Shares of the objects missed, invented, misnamed."""

JITTER_PX, AREA_NOISE = 1.5, 0.1
"""Of objects' centers and ln area, where they are perturbed themselves. In label images the edges move instead."""

RAGGED_PX = 1.5


@dataclass(frozen=True)
class Case:
    """One row: noise by its name, put into the label image or into the objects that were found in it."""

    name: str
    noise: str = "goal"
    goal: str = ""
    wanted: Wanted = field(default_factory=Wanted)
    in_labels: bool = True


CASES = (
    Case("20 % missed, 20 % invented, 5 % misnamed", goal="≥ 99 %, wrong ≤ 0.1 %"),
    Case("40 / 40 / 10 %", "hard", "≥ 85 %"),
    Case("20 / 20 / 5 %, perturbed as objects", goal="≥ 99 %", in_labels=False),
    Case("40 / 40 / 10 %, perturbed as objects", "hard", "≥ 85 %", in_labels=False),
    Case("20 / 20 / 5 %, scale 0.5–2", goal="≥ 95 %", wanted=Wanted(scales=(0.5, 2.0))),
    Case("no noise, scale 0.5–2", "none", wanted=Wanted(scales=(0.5, 2.0))),
    Case("20 / 20 / 5 %, 8–12 objects", wanted=Wanted(objects=(8, 12))),
    Case("no noise, 8–12 objects", "none", wanted=Wanted(objects=(8, 12))),
    Case("20 / 20 / 5 %, camera tilted 5°", wanted=Wanted(tilt_deg=5.0)),
    Case("20 / 20 / 5 %, camera tilted 10°", wanted=Wanted(tilt_deg=10.0)),
    *(
        Case(f"20 / 20 / 5 %, rotation {angle}°", goal="≥ 99 %", wanted=Wanted((1.0, 1.0), (angle,)))
        for angle in ROTATIONS_DEG
    ),
)


def measure(run: inputs.Run) -> dict[str, str]:
    text = [_about(run), _table(run, southern=run.area.name != "sample")]
    if run.area.name != "sample":
        sample = replace(run, area=inputs.sample_area(run.work))
        text += [_SAMPLE.format(size=sample.area.window_size), _table(sample, southern=False)]
    return {"localization": "\n\n".join(text)}


_SAMPLE = """\
The same on the sample area of `tools/make_sample.py`, a made-up landscape with other classes, images of {size:g} px:"""


def query_map(run: inputs.Run, southern: bool) -> QueryMap:
    """The area's map and its database file; ``southern``: images from the half with a row beyond the objects' median.

    The whole map is in the database; every constant of the method was set with images from the northern half.
    """
    labels = inputs.read_labels(run.label_map())
    size = round(run.area.window_size / inputs.PIXEL_SIZE)
    area = QueryMap(labels, run.database(run.area.stride), size)
    if southern:
        left, bottom, right, _ = area.extent
        area.extent = left, bottom, right, -int(np.median(area.objects.centers_xy[:, 1]))
    return area


def _about(run: inputs.Run) -> str:
    return _ABOUT.format(
        ragged=RAGGED_PX,
        jitter=JITTER_PX,
        area=AREA_NOISE,
        count=run.how_many(COUNT, QUICK_COUNT),
        right=RIGHT_M,
        tilted=100 * RIGHT_TILTED,
    )


_ABOUT = """\
Constellation, end to end: `semref:builddatabase`'s file is read, a label image is cut from the map at any place and
heading (scale 0.8–1.25 and ≥ 20 whole objects in view unless said otherwise), spoilt, and given to `core.localizer`.
Noise in the label image: objects erased, objects of elsewhere drawn in, objects given another class, edges moved by σ
{ragged:g} px; “perturbed as objects”: the same shares of the objects found in the clean image, centers moved by σ
{jitter:g} px, ln area by σ {area:g}. {count} images a row. Right: within {right:g} m, with a tilted camera within
{tilted:g} % of the footprint. Liechtenstein: images from the southern half, the method's constants are from the
northern. Goals of accuracy: position ≤ 0.3 % of the footprint, heading ≤ 0.3°, scale ≤ 0.5 % (medians); the ellipse
holds in 93–97 %. Objects found: in the spoilt image, down to the smallest area at the coarsest pixel size searched.
Images are of the map's own date. Times: processor, one core."""


def _table(run: inputs.Run, southern: bool) -> str:
    area = query_map(run, southern)
    count = run.how_many(COUNT, QUICK_COUNT)
    rows = []
    for number, case in list(enumerate(CASES))[:: 4 if run.quick else 1]:
        rng = np.random.default_rng([SEED, number])
        try:
            outcomes = [attempt(area, case, rng) for _ in range(count)]
        except ValueError as error:
            rows.append([case.name, case.goal, f"not measured: {error}", *[""] * 6])
            continue
        rows.append(row(case, outcomes))
        print("  " + " | ".join(map(str, rows[-1])), file=sys.stderr, flush=True)
    header = [
        "images",
        "goal",
        "right fixes",
        "wrong fixes",
        "objects in view → found (medians)",
        "median error, heading, scale",
        "in the 95 % ellipse",
        "ms median, p95",
        "no fix",
    ]
    return page.table(header, rows)


def attempt(area: QueryMap, case: Case, rng: np.random.Generator) -> Outcome:
    """One image of a case, cut, spoilt and localized."""
    view, labels, count = area.draw(case.wanted, rng)
    if case.in_labels:
        return area.localize(view, spoil(area, case, view, labels, rng), count, "constellation")
    return _localize_objects(area, case, view, labels, count, rng)


def spoil(area: QueryMap, case: Case, view, labels: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """The label image with the case's noise; invented objects are of another view at about this scale."""
    from semref.core.simulation.noise import LabelNoise, spoil_labels

    if not NOISES[case.noise][0]:
        return labels
    noise = LabelNoise(*NOISES[case.noise], jitter=RAGGED_PX)
    donor = area.draw(Wanted((view.pixel_size, view.pixel_size), objects=(4, 10**9)), rng)[1]
    smallest = max(area.minimum_area_px / view.pixel_size**2, 1.0)
    return spoil_labels(labels, noise, rng, area.values, donor, smallest)


def _localize_objects(area: QueryMap, case: Case, view, labels, count: int, rng: np.random.Generator) -> Outcome:
    from semref.core.constellation.solver import localize
    from semref.core.localization import Prior
    from semref.core.simulation.noise import LabelNoise, spoil_landmarks

    size = (view.width_px, view.height_px)
    noise = LabelNoise(*NOISES[case.noise], center=JITTER_PX, log_area=AREA_NOISE)
    population = replace(area.objects, areas_px=area.objects.areas_px / view.pixel_size**2)
    objects = spoil_landmarks(area.objects_of(labels, view.pixel_size), noise, rng, population, size)
    prior = Prior(
        pixel_size_range=area.localizer.pixel_sizes(labels.shape, area.localizer.settings.constellation.scales)
    )
    index = area.localizer.index
    started = time.process_time()
    found = localize(objects, *size, index, prior)
    return area.judge(view, found, found.place, count, time.process_time() - started)


def row(case: Case, outcomes: list[Outcome]) -> list[str]:
    """A line of the table."""
    total = len(outcomes)
    right = [
        outcome
        for outcome in outcomes
        if outcome.is_right(RIGHT_TILTED * outcome.footprint_m if case.wanted.tilt_deg else RIGHT_M)
    ]
    wrong = sum(outcome.is_fix for outcome in outcomes) - len(right)
    refused = [outcome.status for outcome in outcomes if not outcome.is_fix]
    seen, used = (np.median([getattr(outcome, name) for outcome in outcomes]) for name in ("objects", "references"))
    return [
        case.name,
        case.goal,
        rate(len(right), total),
        rate(wrong, total),
        f"{seen:.0f} → {used:.0f}",
        *accuracy(right),
        milliseconds(outcomes),
        ", ".join(f"{refused.count(status)} {status}" for status in sorted(set(refused))) or "0",
    ]
