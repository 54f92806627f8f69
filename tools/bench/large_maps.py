"""Map correlation on maps of 10³, 10⁴ and 10⁵ km² of different ground: time, memory, and what a first look at larger
pixels costs in places."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace

import cv2
import numpy as np

from bench import inputs, page
from bench.correlation import ON_THE_MAP, best_right, country
from bench.ground import Ground, Image, Wanted
from semref.core.correlation import cached
from semref.core.correlation.class_pyramid import MapPyramid
from semref.core.correlation.settings import CORRELATION
from semref.core.correlation.solver import localize
from semref.core.evaluation.trial import Trial, judge
from semref.core.flight.evidence import best_of, seen_image
from semref.core.flight.settings import FLIGHT
from semref.core.geometry.frame import MapFrame
from semref.core.localization import Method, Prior
from semref.core.simulation.noise import MODEST, STRONG, LabelNoise

PAGE = "benchmarks.md"
SEED = 1671
COUNT, QUICK_COUNT = 40, 1
EDGES_KM = (32, 100, 316)
PIXEL_M = 8.0
"""Of the large map's overview."""

PATCH_KM = 6.0
LEAST_LABELED, TRIES = 0.85, 50
"""Of a patch of other ground, and how many are looked at for one."""

CASES = (
    ("modest noise", MODEST, ON_THE_MAP),
    ("strong noise", STRONG, ON_THE_MAP),
    ("mirrored, modest noise", MODEST, replace(ON_THE_MAP, is_mirrored=True)),
)
LOOKS = {"all places": np.inf, "larger pixels first": 0.0}
MOST_FOR_ALL_KM = 100

COLUMNS = (
    "map",
    "labeled km²",
    "images",
    "first look",
    "right fixes",
    "wrong fixes",
    "best place right, fix or not",
    "s median",
    "p95",
    "times the processor time of all places",
    "pyramid, s",
    "MB",
)
KEPT_COLUMNS = ("map", "labeled km²", "made, s", "made and kept, s", "opened, s", "times as fast", "file")
FLIGHT_COLUMNS = ("map", "images", "first look", "right place among them", "s median", "p95")
AMONG_SHARE = 0.05
"""Of an image's edge, from its place: a hypothesis nearer than that is drawn to it."""


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"large maps": "Not measured: the real data is not here."}
    ground, count = country(run), run.how_many(COUNT, QUICK_COUNT)
    rows, kept, flights = [], [], []
    for edge_km in EDGES_KM[: 1 if run.quick else None]:
        name = f"{edge_km} km square"
        cases = [case for case in CASES if run.wants(f"{name}, {case[0]}")]
        wants_kept, wants_flights = run.wants(f"{name}, kept"), run.wants(f"{name}, flights")
        if not (cases or wants_kept or wants_flights):
            continue
        labels, frame = amid_other_ground(ground, edge_km)
        started = time.perf_counter()
        pyramid = MapPyramid(labels, frame)
        made = time.perf_counter() - started
        rows += _rows(ground, edge_km, cases, pyramid, made, count)
        if wants_flights:
            flights += _flight_rows(ground, edge_km, pyramid, count)
        if wants_kept:
            kept.append([name, f"{_labeled_km2(labels):,.0f}", f"{made:.1f}", *_kept(labels, frame)])
    sections = {}
    if rows:
        sections["large maps"] = f"{_ABOUT.format(half=run.half, count=count)}\n\n{page.table(COLUMNS, rows)}"
    if flights:
        about = _ABOUT_FLIGHTS.format(half=run.half, count=count)
        sections["flights over large maps"] = f"{about}\n\n{page.table(FLIGHT_COLUMNS, flights)}"
    if kept:
        sections["pyramids opened"] = f"{_ABOUT_KEPT}\n\n{page.table(KEPT_COLUMNS, kept)}"
    return sections


_ABOUT = """\
Images of 1,280 px of Liechtenstein's {half}ern half at 0.8–1.25 m, any heading, {count} a row, on the country amid
other ground: patches of 6 km of it, turned, half of them mirrored, stretched by 15–40 % along one axis and pressed
along the other, at 8 m; so every image has stretched copies of its own ground as opponents, which no real map has.
Pixel sizes searched: 0.4–2.5 × nominal. “All places”: every one is compared at sixteenths of the image's edge;
“larger pixels first”: at eighths, and what fits best there at sixteenths, as SemRef does from 4·10⁸ comparisons on.
Seconds: wall time with two threads. Right: within 2 % of the footprint; any fix of a mirrored image is wrong."""


_ABOUT_FLIGHTS = """\
The places that a flight over such a map begins with: the best 200 of an image of the {half}ern half with modest noise,
by itself. Right: one of them is within 5 % of the image's edge. {count} images a row; wall time with two threads."""

_ABOUT_KEPT = """\
The pyramid of these maps in the cache: made and written at the first start, from then on opened by memory
mapping, its overview hashed and its file checked each time; the file was in memory. SemRef stores those of
64 million pixels or more: here all but the first."""


def _labeled_km2(labels_hw: np.ndarray) -> float:
    return np.count_nonzero(labels_hw) * (PIXEL_M / 1000) ** 2


def _kept(labels: np.ndarray, frame: MapFrame) -> list[str]:
    """Seconds to make and store a pyramid and to load it, and its file's size; the file goes."""
    page.cached_size("pyramid")
    seconds = []
    fewest, cached.FEWEST_PIXELS = cached.FEWEST_PIXELS, 0
    for _ in range(2):
        started = time.perf_counter()
        cached.cached_pyramid(labels, frame, CORRELATION)
        seconds.append(time.perf_counter() - started)
    cached.FEWEST_PIXELS = fewest
    first, again = seconds
    return [f"{first:.1f}", f"{again:.2f}", f"{first / again:.0f}", page.cached_size("pyramid")]


def _flight_rows(ground: Ground, edge_km: int, pyramid: MapPyramid, count: int) -> list[list[str]]:
    rows = []
    images = _images(ground, MODEST, ON_THE_MAP, count)
    for look, most in LOOKS.items():
        if look == "all places" and edge_km > MOST_FOR_ALL_KM:
            continue
        pyramid.settings = replace(CORRELATION, most_at_once=most)
        found = [_begun(ground, pyramid, image) for image in images]
        shares = [f"{value:.2f}" for value in np.percentile([wall for _, wall in found], [50, 95])]
        among = page.rate(sum(is_among for is_among, _ in found), count)
        rows.append([f"{edge_km} km square", "modest noise", look, among, *shares])
        print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    return rows


def _begun(ground: Ground, pyramid: MapPyramid, image: Image) -> tuple[bool, float]:
    """Whether the right place is among those that a flight begins with, and the seconds that finding them took."""
    sizes = ground.localizer.pixel_sizes(image.view.shape_hw, CORRELATION.scales)
    started = time.perf_counter()
    seen = seen_image(image.labels_hw, pyramid, Prior(pixel_size_range=sizes), None, FLIGHT)
    found = best_of(seen, pyramid, FLIGHT.candidates, FLIGHT.apart)
    seconds = time.perf_counter() - started
    x, y = image.view.x - pyramid.frame.origin[0], pyramid.frame.origin[1] - image.view.y
    near = AMONG_SHARE * seen.edge_px * image.view.pixel_size
    return any(np.hypot(pose.x - x, pose.y - y) < near for pose in found), seconds


def _rows(
    ground: Ground, edge_km: int, cases: Sequence[tuple], pyramid: MapPyramid, made: float, count: int
) -> list[list[str]]:
    labeled, rows = _labeled_km2(pyramid.labels), []
    for title, noise, wanted in cases:
        images, seconds = _images(ground, noise, wanted, count), {}
        for look, most in LOOKS.items():
            if look == "all places" and edge_km > MOST_FOR_ALL_KM:
                continue
            pyramid.settings = replace(CORRELATION, most_at_once=most)
            trials = [_tried(ground, pyramid, image) for image in images]
            seconds[look] = sum(processor for _, _, processor in trials)
            rows.append(_row(f"{edge_km} km square", labeled, title, look, [trial for trial, _, _ in trials]))
            rows[-1] += [f"{value:.2f}" for value in np.percentile([wall for _, wall, _ in trials], [50, 95])]
            first = seconds.get("all places")
            rows[-1] += [
                "–" if first is None else f"{seconds[look] / first:.2f}",
                f"{made:.1f}",
                f"{pyramid.bytes / 1e6:,.0f}",
            ]
            print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    return rows


def _row(name: str, labeled: float, title: str, look: str, trials: list[Trial]) -> list[str]:
    right, wrong = sum(t.is_right for t in trials), sum(t.is_wrong for t in trials)
    can_be = trials[0].query.can_be_right
    rates = [page.rate(right, len(trials)) if can_be else "–", page.rate(wrong, len(trials)), best_right(trials)]
    return [name, f"{labeled:,.0f}", title, look, *rates]


def _images(ground: Ground, noise: LabelNoise, wanted: Wanted, count: int) -> list[Image]:
    rng = np.random.default_rng([SEED, 3])
    drawn = (ground.draw(wanted, rng) for _ in range(count))
    return [ground.spoiled(image, noise.in_pixels(image.view.pixel_size), rng) for image in drawn]


def _tried(ground: Ground, pyramid: MapPyramid, image: Image) -> tuple[Trial, float, float]:
    """What came of it, with the seconds and those of the processor that it took."""
    sizes = ground.localizer.pixel_sizes(image.view.shape_hw, CORRELATION.scales)
    started, worked = time.perf_counter(), time.process_time()
    found = localize(image.labels_hw, pyramid, Prior(pixel_size_range=sizes), errors=ground.localizer.errors)
    wall, processor = time.perf_counter() - started, time.process_time() - worked
    return judge(image.query, Method.MAP_CORRELATION, found), wall, processor


def amid_other_ground(ground: Ground, edge_km: float) -> tuple[np.ndarray, MapFrame]:
    """(h, w) uint8 labels of a square with the ground's own map in its middle and other ground around it, and their
    frame; the same for the same edge."""
    of_map = ground.database.parameters.overview_frame
    every = round(PIXEL_M / of_map.pixel_size)
    own = np.ascontiguousarray(ground.database.overview[::every, ::every])
    count, patch = round(edge_km * 1000 / PIXEL_M), round(PATCH_KM * 1000 / PIXEL_M)
    labels, rng = np.zeros((count, count), np.uint8), np.random.default_rng([SEED, 10])
    other = other_ground(own, patch, rng)
    for row in range(0, count, patch):
        for column in range(0, count, patch):
            here = labels[row : row + patch, column : column + patch]
            here[:] = other()[: here.shape[0], : here.shape[1]]
    top, left = (count - own.shape[0]) // 2, (count - own.shape[1]) // 2
    middle = labels[top : top + own.shape[0], left : left + own.shape[1]]
    middle[own > 0] = own[own > 0]
    pixel = of_map.pixel_size * every
    origin = of_map.origin[0] - left * pixel, of_map.origin[1] + top * pixel
    return labels, MapFrame.at(origin, pixel, labels.shape)


def other_ground(own: np.ndarray, edge: int, rng: np.random.Generator) -> Callable[[], np.ndarray]:
    """Gives one (edge, edge) patch after the other of ground of the same kind that lies nowhere."""
    flags = cv2.INTER_NEAREST | cv2.WARP_INVERSE_MAP

    def patch() -> np.ndarray:
        for _ in range(TRIES):
            stretch, turn = rng.uniform(1.15, 1.4), rng.uniform(0, 2 * np.pi)
            cosine, sine = np.cos(turn), np.sin(turn)
            matrix = np.array([[cosine, -sine], [sine, cosine]]) * (stretch, rng.choice([-1, 1]) / stretch)
            center = rng.uniform((0, 0), own.shape[::-1])
            offset = center - matrix @ [edge / 2, edge / 2]
            found = cv2.warpAffine(own, np.column_stack([matrix, offset]), (edge, edge), flags=flags)
            if (found > 0).mean() > LEAST_LABELED:
                break
        return found

    return patch
