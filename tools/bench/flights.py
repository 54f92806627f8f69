"""Flights: many images, one track; beside it single images, and a particle filter, for the same images and motion.

.venv/bin/python tools/bench flights [--count 10] [--only "640 m"] [--write]
"""

from __future__ import annotations

import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from bench import inputs, page, particles, two_dates
from bench.correlation import BUILDINGS
from bench.flown import Flown, Kind, draw
from bench.ground import Ground
from semref.core.flight.flight import FlightSolver
from semref.core.flight.model import FlightPose
from semref.core.localization import Method
from semref.core.simulation.noise import DISPLACED_M, STRONG
from semref.core.simulation.views import View
from semref.storage.database.reader import read_database

PAGE = "benchmarks.md"
SEED = 1616
COUNT, QUICK_COUNT = 40, 1
NOTHING_COUNT = 10
"""Images of flights that lie nowhere: as long as nothing is found each of them costs a search of the whole map."""

WRONG_SHARE = 0.1
"""A pose farther off than this share of an image's edge is wrong."""

AT = (1, 2, 3, 5, 10, 20, 30)
EVERY = 10
"""Of a flight's images so many-th is localized alone."""

PARTICLES = (1_000, 10_000)
POOR = replace(STRONG, displaced=DISPLACED_M)
USUAL = Kind(noise=POOR)
CHRISTCHURCH_M = 6_400.0


@dataclass(frozen=True)
class Case:
    """A row: flights of a kind, a share of the count."""

    name: str
    kind: Kind = USUAL
    is_alone: bool = False
    is_mirrored: bool = False
    is_elsewhere: bool = False
    share: float = 0.5

    @property
    def is_somewhere(self) -> bool:
        return not (self.is_mirrored or self.is_elsewhere)


CASES = (
    Case("640 m", is_alone=True, share=1.0),
    Case("320 m, every 100 m", replace(USUAL, ground_m=320.0, step_m=100.0), is_alone=True),
    Case("640 m, drift 3 %", replace(USUAL, drift=0.03)),
    Case("640 m, drift 5 %", replace(USUAL, drift=0.05)),
    Case("640 m, every third link missing", replace(USUAL, missing=3)),
)
NOTHING = replace(USUAL, count=NOTHING_COUNT)
NOWHERE = (
    Case("640 m, mirrored", NOTHING, is_mirrored=True, share=1.0),
    Case("640 m, of the other half", NOTHING, is_elsewhere=True, share=1.0),
)
TWO_DATES = Case(
    "Christchurch, map of 1996, flights of 2018, 6.4 km",
    Kind(CHRISTCHURCH_M, 1_600.0, 12, scales=(0.8, 1.25)),
    is_alone=True,
)


@dataclass(frozen=True)
class Tried:
    """One flight and what came of it: the whole flight's poses, and those known image by image."""

    flown: Flown
    whole: Sequence[FlightPose]
    causal: Sequence[FlightPose]
    seconds: Sequence[float]


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"flights": "Not measured: the real data is not here."}
    count = run.how_many(COUNT, QUICK_COUNT)
    ground = Ground.of(run)
    ground.spoiled_values = BUILDINGS
    rows, steps, beside, counts = [], [], [], []
    for number, case in enumerate((*CASES, *NOWHERE, TWO_DATES)):
        if not run.wants(case.name):
            continue
        here = _two_dates(run) if case is TWO_DATES else ground
        if here is None:
            continue
        here = here.known_elsewhere() if case.is_elsewhere else here
        tried = _tried(here, case, max(1, round(case.share * count)), number)
        rows.append(_cells(case, tried))
        print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
        if case.is_somewhere:
            steps.append([case.name, *_by_number(tried)])
        if case.is_alone:
            beside += _beside(here, case, tried, number)
            print("  " + " | ".join(beside[-1]), file=sys.stderr, flush=True)
        counts.append(len(tried))
    text = [_ABOUT.format(half=run.half, displaced=DISPLACED_M, wrong=100 * WRONG_SHARE, every=EVERY)]
    text += [page.table(COLUMNS, rows), _STEPS, page.table(("flights", *(f"image {n}" for n in AT)), steps)]
    text += [_BESIDE, page.table(BESIDE_COLUMNS, beside)]
    return {"flights": "\n\n".join(text)}


def _two_dates(run: inputs.Run) -> Ground | None:
    """The map of 1996, flown over in 2018; None where the data is not here."""
    if not (run.data / two_dates.SOURCE).exists():
        return None
    content = read_database(str(two_dates.database(run, CHRISTCHURCH_M)), with_overview=True)
    labels = inputs.read_labels(two_dates.label_map(run, two_dates.AFTER))
    return Ground(labels, content, size_px=round(CHRISTCHURCH_M / two_dates.PIXEL_SIZE_M))


def _tried(ground: Ground, case: Case, count: int, seed: int) -> list[Tried]:
    found = []
    for number in range(count):
        flown = draw(ground, case.kind, np.random.default_rng([SEED, seed, number]))
        flown = flown.mirrored() if case.is_mirrored else flown
        solver, seconds = FlightSolver(ground.localizer), []
        started = time.process_time()
        for _ in solver.steps(flown.images, flown.links):
            seconds.append(time.process_time() - started)
            started = time.process_time()
        found.append(Tried(flown, solver.result.poses, solver.causal, seconds))
        print(f"    {case.name} {number}: {_short(found[-1])}", file=sys.stderr, flush=True)
    return found


def _short(tried: Tried) -> str:
    errors = [error(p, v) for p, v in zip(tried.whole, tried.flown.views) if p.is_fix]
    first = next((p.number + 1 for p in tried.causal if p.is_fix), None)
    middle = f"{np.median(errors):.1f} m, at most {max(errors):.1f} m" if errors else "–"
    return f"{len(errors)}/{len(tried.whole)} placed, known from image {first}, {middle}, {sum(tried.seconds):.0f} s"


def error(pose: FlightPose, view: View) -> float:
    """Meters of a placed image."""
    return float(np.hypot(*np.subtract(pose.place.position, view.position)))


def is_held(pose: FlightPose, view: View) -> bool:
    """Whether the 95 % ellipse holds the true position."""
    off = np.subtract(pose.place.position, view.position)
    return bool(off @ np.linalg.solve(np.array(pose.covariance.position), off) <= -2 * np.log(0.05))


COLUMNS = (
    "flights",
    "flights, images",
    "placed (whole flight)",
    "wrong",
    "flights with a wrong track",
    "median, 95th percentile of error",
    "in the 95 % ellipse",
    "wrong ones that risks tell",
    "s an image: median, p95; before, with a track",
)


def _cells(case: Case, tried: Sequence[Tried]) -> list[str]:
    pairs = [(pose, view) for one in tried for pose, view in zip(one.whole, one.flown.views)]
    placed = [(pose, view) for pose, view in pairs if pose.is_fix]
    wrong = [pair for pair in placed if not case.is_somewhere or is_wrong(*pair)]
    lost = sum(any(p.is_fix and (not case.is_somewhere or is_wrong(p, v)) for p, v in _both(one)) for one in tried)
    told = placed if case.is_somewhere else []
    errors = [error(*pair) for pair in told]
    seconds = np.concatenate([one.seconds for one in tried])
    held = np.concatenate([[pose.is_fix for pose in one.causal] for one in tried])
    parts = [f"{np.median(seconds[part]):.1f}" if part.any() else "–" for part in (~held, held)]
    return [
        case.name,
        f"{len(tried)}, {len(pairs)}",
        page.rate(len(placed), len(pairs)),
        page.rate(len(wrong), len(pairs)),
        page.rate(lost, len(tried)),
        f"{np.median(errors):.1f} m, {np.percentile(errors, 95):.1f} m" if errors else "–",
        page.rate(sum(is_held(*pair) for pair in told), len(told)),
        f"{sum(pose.risk for pose, _ in told):.1f}" if told else "–",
        f"{np.median(seconds):.1f}, {np.percentile(seconds, 95):.1f}; {parts[0]}, {parts[1]}",
    ]


def _both(one: Tried) -> list[tuple[FlightPose, View]]:
    return list(zip((*one.whole, *one.causal), (*one.flown.views, *one.flown.views)))


def is_wrong(pose: FlightPose, view: View) -> bool:
    """Whether a placed image is somewhere else."""
    return error(pose, view) > WRONG_SHARE * view.footprint


def _by_number(tried: Sequence[Tried]) -> list[str]:
    """Known after so many images, from these alone: share of flights, median error, share in the ellipse."""
    cells = []
    for number in AT:
        known = [(one.causal[number - 1], one.flown.views[number - 1]) for one in tried if number <= len(one.causal)]
        placed = [pair for pair in known if pair[0].is_fix]
        if not placed:
            cells.append(f"0/{len(known)}" if known else "–")
            continue
        held = sum(is_held(*pair) for pair in placed)
        middle = np.median([error(*pair) for pair in placed])
        cells.append(f"{len(placed)}/{len(known)}, {middle:.1f} m, {held}/{len(placed)}")
    return cells


BESIDE_COLUMNS = ("way", "placed", "wrong", "median error", "s an image, median")


def _beside(ground: Ground, case: Case, tried: Sequence[Tried], seed: int) -> list[list[str]]:
    """Single images by Automatic, and particle filters over the same flights."""
    alone, seconds = [], []
    for one in tried:
        for image, view in list(zip(one.flown.images, one.flown.views))[::EVERY]:
            started = time.process_time()
            found = ground.localizer.localize(image.labels_hw, Method.AUTOMATIC, image.prior)
            seconds.append(time.process_time() - started)
            off = None if found.position is None else float(np.hypot(*np.subtract(found.position, view.position)))
            alone.append((off, view))
    rows = [_way(f"{case.name}: each image alone, automatic", alone, seconds)]
    for count in PARTICLES:
        poses, seconds = [], []
        for number, one in enumerate(tried):
            started = time.process_time()
            rng = np.random.default_rng([SEED, seed, number, count])
            for pose, view in zip(particles.follow(ground.database, one.flown, count, rng), one.flown.views):
                off = float(np.hypot(*np.subtract(pose.position, view.position)))
                poses.append((off if pose.is_converged else None, view))
            seconds.append((time.process_time() - started) / len(one.flown.views))
        rows.append(_way(f"{case.name}: {count:,} particles, pixel size told exactly", poses, seconds))
    return rows


def _way(name: str, found: Sequence[tuple[float | None, View]], seconds: Sequence[float]) -> list[str]:
    wrong = sum(off is not None and off > WRONG_SHARE * view.footprint for off, view in found)
    right = [off for off, view in found if off is not None and off <= WRONG_SHARE * view.footprint]
    placed = len(right) + wrong
    middle = f"{np.median(right):.1f} m" if right else "–"
    return [name, page.rate(placed, len(found)), page.rate(wrong, len(found)), middle, f"{np.median(seconds):.2f}"]


_ABOUT = """\
Random flights over Liechtenstein's {half}ern half, 30 images 200 m apart unless said otherwise, courses that bend by
6° from image to image, headings up to 10° off the course, pixels of 0.8–1.25 m; labels of a poor network (“strong”
noise) and ground displaced by σ {displaced:g} m as maps of two dates are. Told: motion between neighbors, each link
off by 1 % of the distance (σ, right and down) and all of them by another 1 %, turn by 0.3°, ln scale by 0.003; pixel
size to 10 %; nothing of place and heading; no image has a fix of its own. Drift: that share instead of 1 %. Searched:
the whole country. Whole flight: with what later images tell. Wrong: farther off than {wrong:g} % of the image's edge;
flights that are mirrored or of the half that the database lacks (10 images) have no right place. Errors and ellipses:
of all images that are placed, wrong ones included; beside them the sum of the risks that are told of them.
Christchurch: LCDB v5.0, label images of another date without other noise, 12 images of 6.4 km, 1.6 km apart. Times:
processor, on a machine that others used too."""

_STEPS = "Known image by image, from the images until then alone: flights placed, median error, in the 95 % ellipse:"
_BESIDE = """\
The same images and links otherwise: every tenth image alone, and a particle filter of the published kind
(`tools/bench/particles.py`), which is told the pixel size exactly. Placed: with a fix; particles within 60 m (σ)."""
