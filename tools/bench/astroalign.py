"""The constellation beside astroalign (PyPI) on the same points: benchmark only, the plugin never needs it."""

from __future__ import annotations

import importlib
import importlib.metadata
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import cv2
import numpy as np

from bench import inputs, page
from bench.ground import GOAL, HARD, NONE, Case, Ground, Wanted, chosen

if TYPE_CHECKING:
    from semref.core.landmarks.landmarks import Landmarks
    from semref.core.simulation.views import View

PAGE = "benchmarks.md"
SEED = 1671
COUNT = 20
QUICK_COUNT = 3
WHOLE_COUNT = 2
"""Attempts of astroalign with the whole catalogue; each takes as long as it may."""

CASES = (
    Case("no noise, scale 0.5–2", NONE, wanted=Wanted(scales=(0.5, 2.0))),
    Case("20 / 20 / 5 %", GOAL),
    Case("40 / 40 / 10 %", HARD),
)
PIECES = (1.0, 2.0)
"""Edges of the piece of the catalogue around the true place, in footprints."""

LIMIT_S, WHOLE_LIMIT_S, QUICK_LIMIT_S = 10.0, 120.0, 1.0
"""Processor seconds an answer may take."""

RIGHT_PX = 10.0
IMAGE_PX, PIXEL_SIZES_M = 1280, (0.4, 2.5)
"""Of the images; pixel sizes the constellation searches."""


@dataclass(frozen=True)
class Setting:
    """astroalign's: how many points (largest objects first) and its PIXEL_TOL; its defaults are 50 and 2."""

    control_points: int
    tolerance_px: float

    def __str__(self) -> str:
        points = f"{self.control_points} points" if self.control_points < 10**6 else "all points"
        return f"astroalign, {points}, {self.tolerance_px:g} px"


SETTINGS = (Setting(50, 2.0), Setting(200, 6.0))
WHOLE = Setting(10**6, 6.0)


@dataclass(frozen=True)
class Query:
    """Where an image was taken, and its objects after noise."""

    view: View
    objects: Landmarks

    @property
    def place(self) -> complex:
        return complex(*self.view.position)


@dataclass(frozen=True)
class Answer:
    """Where the image's center is said to lie (complex map pixels; None without an answer), and processor seconds."""

    place: complex | None
    seconds: float
    timed_out: bool = False


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"astroalign": "Not measured: the real data is not here."}
    try:
        astroalign = install(run.work / "astroalign")
    except subprocess.CalledProcessError as error:
        return {"astroalign": f"Not measured: pip could not install astroalign: {error.stderr.strip()[-200:]}"}
    cv2.setNumThreads(1)
    count = run.how_many(COUNT, QUICK_COUNT)
    ground = Ground.of(run)
    rows = []
    for number, case in enumerate(CASES):
        if not run.wants(case.name):
            continue
        rng = np.random.default_rng([SEED, number])
        images = [ground.draw(case.wanted, rng) for _ in range(count)]
        queries = [Query(image.view, ground.spoiled_landmarks(image, case.noise, rng)) for image in images]
        for cells in _compared(astroalign, ground.database.references, queries, number == 0, run.quick):
            rows.append([case.name, *cells])
            print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    header = [
        "images",
        "catalogue, objects (median)",
        "",
        "right",
        "wrong",
        "no answer",
        "out of time",
        "s median, p95",
    ]
    known = dict(zip(("piece", "larger", "limit", "whole_limit"), (*PIECES, *_limits(run.quick))))
    version = importlib.metadata.version("astroalign")
    about = _ABOUT.format(version=version, count=count, right=RIGHT_PX, **known)
    return {"astroalign": f"{about}\n\n{page.table(header, rows)}"}


_ABOUT = """\
[astroalign](https://github.com/quatrope/astroalign) {version} aligns pictures of stars by triangles of near
neighbors, as the constellation does, but knows neither classes nor areas and does not judge what it finds against
chance. Same points for both: objects of the map of Liechtenstein and of images from its southern half (1,280 px, any
heading, scale 0.8–1.25 unless said otherwise, ≥ 20 objects in view, perturbed as named), {count} images a row,
largest objects first. The catalogue is a piece around the true place, {piece:g} or {larger:g} × the footprint wide,
as if the place were roughly known, or the whole map. astroalign has its defaults (50 points, 2 px), or more points
with a tolerance that fits the noise; an answer may take {limit:g} s ({whole_limit:g} s with the whole map). Its
search isn't seeded: a second run differs a little. Right: the image's center within {right:g} m. Times: processor,
with indexing of the piece for both, but not of the whole map for the constellation, which is done once."""


def _limits(quick: bool) -> tuple[float, float]:
    """Processor seconds for an answer from a piece of the catalogue, and from all of it."""
    return (QUICK_LIMIT_S, QUICK_LIMIT_S) if quick else (LIMIT_S, WHOLE_LIMIT_S)


def _compared(astroalign, references, queries: list[Query], with_whole: bool, quick: bool) -> Iterator[list[str]]:
    """Rows of one kind of images: pieces of the catalogue with either method, then the whole catalogue."""
    limit, whole_limit = _limits(quick)
    for edge in PIECES:
        pieces = [_piece(references, query.view, edge) for query in queries]
        name = f"{edge:g} × footprint, {np.median([len(piece) for piece in pieces]):.0f}"
        for setting in SETTINGS:
            answers = [_align(astroalign, q.objects, piece, setting, limit) for q, piece in zip(queries, pieces)]
            yield [name, str(setting), *judged(queries, answers)]
        answers = [_ours(q.objects, partial(_index, piece)) for q, piece in zip(queries, pieces)]
        yield [name, "constellation", *judged(queries, answers)]
    name = f"whole map, {len(references)}"
    if with_whole:
        few = queries[: 1 if quick else WHOLE_COUNT]
        answers = [_align(astroalign, q.objects, references, WHOLE, whole_limit) for q in few]
        yield [name, str(WHOLE), *judged(few, answers)]
    whole = _index(references)
    yield [name, "constellation", *judged(queries, [_ours(q.objects, lambda: whole) for q in queries])]


def install(folder: Path):
    """The module astroalign, put into a folder of its own by pip with the numpy that is here."""
    if not folder.exists():
        command = [sys.executable, "-m", "pip", "install", "--quiet", "--target", str(folder)]
        command += [f"numpy=={np.__version__}", "astroalign"]
        subprocess.run(command, check=True, capture_output=True, text=True)
    # Before Debian's scipy, which is older than the scikit-image that pip chose.
    sys.path.insert(1, str(folder))
    return importlib.import_module("astroalign")


def judged(queries: list[Query], answers: list[Answer]) -> list[str]:
    """Cells of a row: right, wrong, no answer, out of time, seconds."""
    total = len(answers)
    errors = [abs(a.place - query.place) for a, query in zip(answers, queries) if a.place is not None]
    right = sum(error <= RIGHT_PX for error in errors)
    late = sum(a.timed_out for a in answers)
    median, high = np.percentile([a.seconds for a in answers], [50, 95])
    return [
        page.rate(right, total),
        page.rate(len(errors) - right, total),
        str(total - len(errors) - late),
        str(late),
        f"{median:.2g}, {high:.2g}",
    ]


def _align(astroalign, objects, catalogue, setting: Setting, limit_s: float) -> Answer:
    """astroalign's answer, or none, from points alone; both sets with y downwards."""
    order = np.argsort(-objects.areas_px)
    image = objects.centers_xy[order]
    larger = np.argsort(-catalogue.areas_m2)
    ground = (catalogue.positions * (1, -1))[larger]
    astroalign.PIXEL_TOL = setting.tolerance_px
    started = time.process_time()
    try:
        found = in_time(limit_s, lambda: astroalign.find_transform(image, ground, setting.control_points)[0])
    except TimeoutError:
        return Answer(None, time.process_time() - started, True)
    except (astroalign.MaxIterError, ValueError, TypeError, IndexError):  # IndexError: not one like triangle
        return Answer(None, time.process_time() - started)
    column, row = found((IMAGE_PX / 2, IMAGE_PX / 2))[0]
    return Answer(complex(column, -row), time.process_time() - started)


def in_time(limit_s: float, work: Callable):
    """What ``work`` returns; raises TimeoutError after ``limit_s`` processor seconds (main thread only)."""

    def stop(*_: object) -> None:
        raise TimeoutError

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, limit_s)
    try:
        return work()
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def _ours(objects, index_of: Callable) -> Answer:
    from semref.core.constellation.solver import localize
    from semref.core.localization import Prior

    started = time.process_time()
    found = localize(objects, (IMAGE_PX, IMAGE_PX), index_of(), Prior(pixel_size_range=PIXEL_SIZES_M))
    place = complex(*found.place.position) if found.is_fix else None
    return Answer(place, time.process_time() - started)


def _index(references):
    from semref.core.constellation.index import build_index

    return build_index(references, 1.0)


def _piece(references, view, edge: float):
    """The catalogue's landmarks in an upright square around a view."""
    away = np.abs(references.positions - view.position).max(axis=1)
    near = away < edge * IMAGE_PX * view.pixel_size / 2
    return chosen(references, near)
