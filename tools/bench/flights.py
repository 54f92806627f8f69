"""Flights: many images, one track; beside it single images, and a particle filter, for the same images and motion.

.venv/bin/python tools/bench flights [--count 10] [--only "640 m"] [--write]
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Optional

import numpy as np

from bench import inputs, kept, page, particles, two_dates
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

PACKAGES = (*kept.OF_ALL, "flight")
"""Of core that the figures come from."""

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


Seen = Optional[list[float]]
"""Of an image that is placed: error in meters, edge of its ground, whether the ellipse holds it (1 or 0), its risk."""


@dataclass(frozen=True)
class Tried:
    """One flight and what came of it: the whole flight's poses, those known image by image, seconds an image."""

    whole: Sequence[Seen]
    causal: Sequence[Seen]
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
        total = max(1, round(case.share * count))
        tried = [Tried(**_kept(run, here, case, number, n, "flown", _fly)) for n in range(total)]
        rows.append(_cells(case, tried))
        print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
        if case.is_somewhere:
            steps.append([case.name, *_by_number(tried)])
        if case.is_alone:
            ways = [_kept(run, here, case, number, n, "beside", _ways) for n in range(total)]
            beside += [_way(f"{case.name}: {name}", [way[name] for way in ways]) for name in ways[0]]
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


def _kept(
    run: inputs.Run, ground: Ground, case: Case, seed: int, number: int, what: str, measured: Callable
) -> dict[str, Any]:
    """What a flight came to, measured unless this state of the code has done so."""

    def now(part: int, _: int) -> dict[str, Any]:
        flown = draw(ground, case.kind, np.random.default_rng([SEED, seed, part]))
        return measured(ground, flown.mirrored() if case.is_mirrored else flown, [SEED, seed, part])

    found = kept.part(run, "flights", f"{case.name} {what}", number, 1, now, PACKAGES)
    if what == "flown":
        print(f"    {case.name} {number}: {_short(Tried(**found))}", file=sys.stderr, flush=True)
    return found


def _fly(ground: Ground, flown: Flown, _: Sequence[int]) -> dict[str, Any]:
    solver, seconds = FlightSolver(ground.localizer), []
    started = time.process_time()
    for done, _count in solver.steps(flown.images, flown.links):
        # Looks back at images count with the last one.
        seconds += [0.0] * (done - len(seconds))
        seconds[-1] += time.process_time() - started
        started = time.process_time()
    seconds[-1] += time.process_time() - started
    ways = {"whole": solver.result.poses, "causal": solver.causal}
    seen = {name: [_seen(pose, view) for pose, view in zip(poses, flown.views)] for name, poses in ways.items()}
    return {**seen, "seconds": seconds}


def _seen(pose: FlightPose, view: View) -> Seen:
    if not pose.is_fix:
        return None
    off = np.subtract(pose.place.position, view.position)
    square = float(off @ np.linalg.solve(np.array(pose.covariance.position), off))
    return [float(np.hypot(*off)), view.footprint, float(square <= -2 * np.log(0.05)), float(pose.risk)]


def _short(tried: Tried) -> str:
    errors = [seen[0] for seen in tried.whole if seen]
    first = next((n for n, seen in enumerate(tried.causal, 1) if seen), None)
    middle = f"{np.median(errors):.1f} m, at most {max(errors):.1f} m" if errors else "–"
    return f"{len(errors)}/{len(tried.whole)} placed, known from image {first}, {middle}, {sum(tried.seconds):.0f} s"


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
    images = [seen for one in tried for seen in one.whole]
    placed = [seen for seen in images if seen]
    wrong = [seen for seen in placed if not case.is_somewhere or is_wrong(seen)]
    lost = sum(
        any(seen and (not case.is_somewhere or is_wrong(seen)) for seen in (*one.whole, *one.causal)) for one in tried
    )
    told = placed if case.is_somewhere else []
    seconds = np.concatenate([one.seconds for one in tried])
    held = np.concatenate([[seen is not None for seen in one.causal] for one in tried])
    parts = [f"{np.median(seconds[part]):.1f}" if part.any() else "–" for part in (~held, held)]
    errors = [seen[0] for seen in told]
    return [
        case.name,
        f"{len(tried)}, {len(images)}",
        page.rate(len(placed), len(images)),
        page.rate(len(wrong), len(images)),
        page.rate(lost, len(tried)),
        f"{np.median(errors):.1f} m, {np.percentile(errors, 95):.1f} m" if errors else "–",
        page.rate(round(sum(seen[2] for seen in told)), len(told)),
        f"{sum(seen[3] for seen in told):.1f}" if told else "–",
        f"{np.median(seconds):.1f}, {np.percentile(seconds, 95):.1f}; {parts[0]}, {parts[1]}",
    ]


def is_wrong(seen: list[float]) -> bool:
    """Whether a placed image is somewhere else."""
    return seen[0] > WRONG_SHARE * seen[1]


def _by_number(tried: Sequence[Tried]) -> list[str]:
    """Known after so many images, from these alone: share of flights, median error, share in the ellipse."""
    cells = []
    for number in AT:
        known = [one.causal[number - 1] for one in tried if number <= len(one.causal)]
        placed = [seen for seen in known if seen]
        if not placed:
            cells.append(f"0/{len(known)}" if known else "–")
            continue
        middle = np.median([seen[0] for seen in placed])
        cells.append(
            f"{len(placed)}/{len(known)}, {middle:.1f} m, {round(sum(seen[2] for seen in placed))}/{len(placed)}"
        )
    return cells


BESIDE_COLUMNS = ("way", "placed", "wrong", "median error", "s an image, median")


def _ways(ground: Ground, flown: Flown, seed: Sequence[int]) -> dict[str, Any]:
    """Single images by Automatic, and particle filters over the same flight: (error or None, edge, seconds)."""
    alone = []
    for image, view in list(zip(flown.images, flown.views))[::EVERY]:
        started = time.process_time()
        found = ground.localizer.localize(image.labels_hw, Method.AUTOMATIC, image.prior)
        seconds = time.process_time() - started
        off = None if found.position is None else float(np.hypot(*np.subtract(found.position, view.position)))
        alone.append([off, view.footprint, seconds])
    ways = {"each image alone, automatic": alone}
    for count in PARTICLES:
        poses, started = [], time.process_time()
        rng = np.random.default_rng([*seed, count])
        for pose, view in zip(particles.follow(ground.database, flown, count, rng), flown.views):
            off = float(np.hypot(*np.subtract(pose.position, view.position)))
            poses.append([off if pose.is_converged else None, view.footprint])
        seconds = (time.process_time() - started) / len(flown.views)
        ways[f"{count:,} particles, pixel size told exactly"] = [[*pose, seconds] for pose in poses]
    return ways


def _way(name: str, flights: Sequence[Sequence[Sequence]]) -> list[str]:
    found = [image for images in flights for image in images]
    placed = [(off, edge) for off, edge, _ in found if off is not None]
    right = [off for off, edge in placed if off <= WRONG_SHARE * edge]
    middle = f"{np.median(right):.1f} m" if right else "–"
    seconds = float(np.median([seconds for _, _, seconds in found]))
    wrong = len(placed) - len(right)
    return [name, page.rate(len(placed), len(found)), page.rate(wrong, len(found)), middle, f"{seconds:.2f}"]


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
