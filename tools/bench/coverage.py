"""How often the stated radius holds: 50, 95 and 99 %, by road, where errors are shared.

In parts, each with its own seed; a later run with the same --work goes on, and joins what runs of some rows kept.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import partial

import numpy as np

from bench import coverage_sources, inputs, kept, page
from bench.ground import GOAL, HARD, NONE, Ground, Image, Wanted
from semref.core.evaluation.summary import held_shares, percentile
from semref.core.evaluation.trial import Trial
from semref.core.geometry.error_settings import NETWORK_SPREAD, ClassBias
from semref.core.localization import Method, Prior
from semref.core.simulation.noise import DISPLACED_M, MODEST, LabelNoise

PAGE = "benchmarks.md"
SEED = 2101
COUNT, QUICK_COUNT = 200, 3
PART = 25
RIGHT_SHARE = 0.02
BUILDINGS = 1
STATED_SPREAD_M = 0.2
PRIOR_RADIUS_M = 600.0
"""Map correlation is told where it is, to this radius: the search takes a second and is not what is measured."""

METERS = LabelNoise(displaced=DISPLACED_M)
BACKGROUND = replace(GOAL, background=0.2)
PRIOR_SHARE = PRIOR_RADIUS_M / 1280
RIGHT_ANGLES = (0.0, 90.0, 180.0, 270.0)
COLUMNS = (
    "images",
    "right fixes; wrong",
    "in the 50 % ellipse",
    "95 %",
    "99 %",
    "median 95 % radius, error",
    "heading, scale 95 %",
)


@dataclass(frozen=True)
class Row:
    """A kind of images.

    Attributes:
        name: of the row
        noise: in pixels
        shared: errors in meters, added to it
        wanted: what is drawn
        lens: radial distortion, of either sign
        shift_m: of all buildings, to any side
        is_stated: whether the localizer is told that shift; else that a network made the labels that states none
        method: that localizes
    """

    name: str
    noise: LabelNoise = GOAL
    shared: LabelNoise = NONE
    wanted: Wanted = field(default_factory=Wanted)
    lens: float = 0.0
    shift_m: float = 0.0
    is_stated: bool = False
    method: Method = Method.CONSTELLATION


LEVEL = (
    Row("own date"),
    Row("other date", shared=METERS),
    Row("other date, no other noise", NONE, METERS),
    Row("right angles at scale 1", wanted=Wanted((1.0, 1.0), RIGHT_ANGLES)),
    Row("right angles at scale 1, other date", shared=METERS, wanted=Wanted((1.0, 1.0), RIGHT_ANGLES)),
    Row("boundaries ragged by 1.5 px", LabelNoise(jitter=1.5)),
    Row("boundaries ragged by 5 px", LabelNoise(jitter=5.0)),
    Row("40 / 40 / 10 %, other date", HARD, METERS),
)
CAMERAS = (
    Row("tilt 5°", wanted=Wanted(tilt_deg=5.0)),
    Row("tilt 10°", wanted=Wanted(tilt_deg=10.0)),
    Row("lens 1 %", lens=0.01),
    Row("lens 3 %", lens=0.03),
    Row("leaning roofs, 0.7 %", shared=LabelNoise(leaning=0.007, leaning_classes=(BUILDINGS,))),
)
SHIFTS = tuple(
    Row(f"buildings shifted by {meters:g} m, {'' if told else 'not '}stated", shift_m=meters, is_stated=told)
    for meters in (1.0, 3.0)
    for told in (True, False)
)
AREAS = tuple(
    replace(row, method=Method.MAP_CORRELATION)
    for row in (
        Row("own date", MODEST),
        Row("other date", MODEST, METERS),
        Row("other date, clean labels", NONE, METERS),
        Row("other date, right angles at scale 1", MODEST, METERS, Wanted((1.0, 1.0), RIGHT_ANGLES)),
        Row("other date, background spoilt too", BACKGROUND, METERS),
        Row("tilt 5°", MODEST, wanted=Wanted(tilt_deg=5.0)),
        Row("lens 1 %", MODEST, lens=0.01),
        Row("buildings shifted by 1 m, not stated", MODEST, shift_m=1.0),
    )
)
BOTH = (
    Row("own date", GOAL, method=Method.AUTOMATIC),
    Row("other date", GOAL, METERS, method=Method.AUTOMATIC),
    Row("other date, 40 / 40 / 10 %", HARD, METERS, method=Method.AUTOMATIC),
    Row("other date, background spoilt too", BACKGROUND, METERS, method=Method.AUTOMATIC),
    Row("other date, poor labels", MODEST, METERS, method=Method.AUTOMATIC),
)


@dataclass(frozen=True)
class Told:
    """What a table counts of one trial; None where nothing was told or nothing is right."""

    is_right: bool
    is_wrong: bool
    radius_ratio: float | None = None
    radius: float | None = None
    error: float | None = None
    is_heading_held: bool | None = None
    is_scale_held: bool | None = None

    @classmethod
    def of(cls, trial: Trial) -> Told:
        """Of a trial; errors of right fixes alone."""
        if not trial.is_right:
            return cls(False, trial.is_wrong)
        held: list[bool | None] = [None, None]
        known = trial.result.covariance
        if known is not None and trial.heading_error_deg is not None and trial.scale_error is not None:
            off = trial.scale_error * trial.query.view.pixel_size
            held = [
                bool(trial.heading_error_deg <= 1.96 * known.heading_deviation_deg),
                bool(off <= 1.96 * known.pixel_size_deviation),
            ]
        return cls(True, False, trial.radius_ratio, trial.result.error_95_m, trial.error, *held)


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"coverage": "Not measured: the real data is not here."}
    ground = Ground.of(run)
    alone, with_areas = _table(run, ground, True), _table(run, ground, False)
    sections = {}
    if alone:
        about = _ABOUT.format(half=run.half, displaced=DISPLACED_M, share=100 * RIGHT_SHARE, spread=NETWORK_SPREAD)
        sections["coverage"] = f"{about}\n\n{page.table(COLUMNS, alone)}"
    if with_areas:
        about = _ABOUT_AREAS.format(radius=PRIOR_RADIUS_M)
        sections["coverage of map correlation"] = f"{about}\n\n{page.table(COLUMNS, with_areas)}"
    return sections


def _table(run: inputs.Run, ground: Ground, is_alone: bool) -> list[list[str]]:
    """Rows of the constellation alone, or of the roads that areas have a part in."""
    rows = []
    for name, sizes, measured in _rows(run, ground, run.how_many(COUNT, QUICK_COUNT)):
        if name.startswith(Method.CONSTELLATION.key) != is_alone:
            continue
        # What finds no place alone has no part in a row of the constellation.
        packages = (*kept.OF_CONSTELLATION, "localizer") if is_alone else kept.OF_AREAS
        if any(kind in name for kind in (coverage_sources.RENDERED, coverage_sources.REAL)):
            packages = kept.OF_ALL
        told = [Told(**one) for one in kept.row(run, "coverage", name, sizes, measured, packages)]
        if not told:
            continue
        rows.append(cells(name, told))
        print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    return rows


Measured = Callable[[int, int], list]


def _rows(run: inputs.Run, ground: Ground, count: int) -> Iterator[tuple[str, list[int], Measured]]:
    """Name, images a part, and what measures a part, of every row that the run wants and has the data of."""
    for number, row in enumerate((*LEVEL, *CAMERAS, *SHIFTS, *AREAS, *BOTH)):
        name = f"{row.method.key}: {row.name}"
        if run.wants(name):
            yield name, kept.parts(count, PART), partial(_of_row, ground, row, number)
    for name, make in coverage_sources.every(run, PRIOR_SHARE):
        yield name, kept.parts(count, PART), partial(_of_source, make)


def _of_row(ground: Ground, row: Row, number: int, part: int, size: int) -> list[dict]:
    return [asdict(Told.of(trial)) for trial in tried(ground, row, size, np.random.default_rng([SEED, number, part]))]


def _of_source(make: Callable[[int, int], Sequence[Trial]], part: int, size: int) -> list[dict]:
    return [asdict(Told.of(trial)) for trial in make(part, size)]


_ABOUT = """\
Images of 1,280 px of Liechtenstein's {half}ern half at 0.8–1.25 m, ≥ 20 landmarks, 20 % missed, 20 % spurious, 5 %
mislabeled, boundaries moved by σ 1.5 px unless said otherwise. “Other date”: landmarks and background displaced by
σ {displaced:g} m along each axis, with the correlation found between maps of two dates; shifts, leaning and
displacement are simulated, constants were fitted on the northern half. Coverage: of right fixes (within {share:g} % of
the footprint), by the ellipse of the told covariance. Goal: 93–97 % in the 95 % ellipse. The database is of the map's
own date and states the default accuracy, so images of its own date have errors smaller than told. “Not stated”: a
network made the labels whose metadata state no bias, so that {spread:g} m along each axis is added. Christchurch: label
images of another date of LCDB v5.0, 10 m pixels, 6.4 km of ground, any number of landmarks. Photos: as under “photos of
the sample area” and “real photos”, with `--model FOLDER`;
Dubai's by *without_tileN.onnx, in pixels, Banepa's by the networks of `own_buildings`, at 0.25 m."""

_ABOUT_AREAS = """\
Map correlation and automatic, told the position to {radius:g} m; otherwise as above. Map correlation: “modest” noise in
meters."""


def tried(ground: Ground, row: Row, count: int, rng: np.random.Generator) -> Iterator[Trial]:
    for _ in range(count):
        image = ground.draw(row.wanted, rng)
        view = image.view
        if row.lens:
            view = replace(view, lens=float(rng.choice([-1, 1])) * row.lens)
            image = Image(replace(image.query, view=view), ground.cut(view), image.landmarks)
        yield _trial(ground, row, image, rng)


def _trial(ground: Ground, row: Row, image: Image, rng: np.random.Generator) -> Trial:
    view = image.view
    noise = row.noise.in_pixels(view.pixel_size) if row.noise == MODEST else row.noise
    shared, biases = row.shared, ()
    if row.shift_m:
        angle = rng.uniform(0, 2 * np.pi)
        right, down = row.shift_m * np.cos(angle), row.shift_m * np.sin(angle)
        shared = replace(shared, class_shifts=((BUILDINGS, right, down),))
        biases = (ClassBias(BUILDINGS, right=right, down=down, spread=STATED_SPREAD_M),) if row.is_stated else ()
    # What is shared is as large on the ground in every image.
    shared = shared.in_pixels(view.pixel_size)
    names = ("displaced", "displaced_kernels", "class_shifts", "leaning", "leaning_classes")
    noise = replace(noise, **{name: getattr(shared, name) for name in names})
    spoiled = ground.spoiled(image, noise, rng)
    localizer = ground.localizer
    prior = ground.prior
    if row.method is not Method.CONSTELLATION:
        off = rng.uniform(-0.5, 0.5, 2) * PRIOR_RADIUS_M
        prior = Prior((view.x + off[0], view.y + off[1]), PRIOR_RADIUS_M)
    localizer.heed_biases(biases, NETWORK_SPREAD if row.shift_m and not row.is_stated else 0.0)
    ground.prior, before = prior, ground.prior
    try:
        return ground.try_image(spoiled, row.method, RIGHT_SHARE * view.footprint)
    finally:
        localizer.heed_biases()
        ground.prior = before


def cells(name: str, told: Sequence[Told]) -> list[str]:
    """A row of the table."""
    right = [one for one in told if one.is_right]
    wrong = sum(one.is_wrong for one in told)
    row = [name, f"{page.rate(len(right), len(told))}; {wrong}"]
    if not right:
        return row + ["–"] * (len(COLUMNS) - 2)
    row += [page.rate(share.successes, share.trials) for share in held_shares(right)]
    radius, error = (percentile([getattr(one, which) for one in right], 50) for which in ("radius", "error"))
    row.append("–" if radius is None or error is None else f"{radius:.2f} m, {error:.2f} m")
    known = [one for one in right if one.is_heading_held is not None]
    if not known:
        return [*row, "–"]
    heading, size = (np.mean([getattr(one, f"is_{which}_held") for one in known]) for which in ("heading", "scale"))
    return [*row, f"{heading:.0%}, {size:.0%}"]
