"""Relative motion from pixels: links of overlapping photos and label images with known truth, and of unrelated ones.

Photos are cut from orthophotos with any turn, scale 0.9–1.1, exposure, color, vignetting and blur that change from one
to the next; the truth is that of the two views. The spreads follow from geometry, none was fitted to these pairs.
"""

from __future__ import annotations

import math
import multiprocessing
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field, replace
from pathlib import Path

import cv2
import numpy as np

from bench import inputs, page
from bench.ground import GOAL
from semref.core.flight.motion import Link
from semref.core.flight.pixel_features import Features, label_features, photo_features
from semref.core.flight.pixel_motion import Motion, motion_between
from semref.core.geometry.camera import Camera
from semref.core.geometry.pose import turn_of
from semref.core.labels.photo_camera import photo_camera
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.noise import STRONG, LabelNoise
from semref.core.simulation.views import PIXELS, View, cut, lies_on, map_coordinates

PAGE = "benchmarks.md"
SEED = 1600
COUNT, QUICK_COUNT = 100, 3
MOST_UNRELATED = 60
"""Images that are compared with one another, at most."""

EDGE_PX = 512
LABEL_EDGE_PX = 640
OVERLAPS = ((0.3, 0.4), (0.4, 0.6), (0.6, 0.8))
SCALES = (0.9, 1.1)
BLUR_PX = 1.5
TILT_DEG, LENS = 2.0, 0.005
"""As assessments assume of a camera without calibration on a gimbal."""

WRONG = 0.05
"""A link is wrong that is off by so much of the edge, of the scale, or by so many radians."""

COLUMNS = (
    *("pairs", "overlap", "links", "wrong", "error, % of the edge: median, p95", "turn: p95", "scale: p95"),
    *("covered of 95 %: place, turn, scale", "ms an image, a link"),
)
UNRELATED = ("pairs of different ground", "pairs", "wrong links")


@dataclass(frozen=True)
class Source:
    """Ground that images are cut from: a photo (H, W, 3) or labels (H, W), one pixel a map unit."""

    name: str
    rasters: Sequence[np.ndarray]
    edge_px: int
    noise: LabelNoise | None = None
    pixel_sizes: tuple[float, float] = (1.0, 1.5)

    @property
    def is_photo(self) -> bool:
        """Whether images are photos, not labels."""
        return self.rasters[0].ndim == 3

    def features(self, image: np.ndarray) -> Features:
        """Of an image of this kind."""
        return photo_features(image) if self.is_photo else label_features(image)


@dataclass
class Tally:
    """What came of the pairs of a row."""

    pairs: int = 0
    wrong: int = 0
    reasons: Counter = field(default_factory=Counter)
    errors: list[np.ndarray] = field(default_factory=list)
    covered: list[np.ndarray] = field(default_factory=list)
    seconds: list[tuple[float, float]] = field(default_factory=list)

    def add(self, motion: Motion, truth: Link, edge_px: int) -> None:
        """Judges a motion by the true one."""
        self.pairs += 1
        if motion.link is None:
            self.reasons[motion.reason.code if motion.reason else ""] += 1
            return
        found = motion.link
        off = np.array([*found.translation, found.turn, found.log_scale]) - [
            *(*truth.translation, truth.turn, truth.log_scale)
        ]
        off[2] = (off[2] + math.pi) % (2 * math.pi) - math.pi
        known = np.array(found.covariance)
        place = off[:2] @ np.linalg.solve(known[:2, :2], off[:2])
        self.covered.append(np.array([place < 5.991, *(np.abs(off[2:]) < 1.96 * np.sqrt(np.diag(known)[2:]))]))
        error = np.array([math.hypot(*off[:2]) / edge_px, abs(off[2]), abs(off[3])])
        self.errors.append(error)
        self.wrong += bool((error > WRONG).any())

    def row(self, name: str, overlap: str) -> list[str]:
        """Of the table."""
        if not self.errors:
            return [name, overlap, page.rate(0, self.pairs), *["–"] * 6]
        errors = np.array(self.errors)
        middle, high = np.percentile(errors, [50, 95], axis=0)
        covered = ", ".join(f"{100 * share:.0f} %" for share in np.mean(self.covered, axis=0))
        an_image, a_link = np.median(self.seconds, axis=0) * 1000
        return [
            *(name, overlap, page.rate(len(errors), self.pairs), str(self.wrong)),
            *(f"{100 * middle[0]:.2f}, {100 * high[0]:.2f}", f"{math.degrees(high[1]):.2f}°", f"{100 * high[2]:.2f} %"),
            *(covered, f"{an_image:.0f}, {a_link:.0f}"),
        ]


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"relative motion": "Not measured: the real data is not here."}
    cv2.setNumThreads(1)
    count = run.how_many(COUNT, QUICK_COUNT)
    SOURCES.extend(_sources(run))
    cases = [
        (number, is_level, overlap)
        for number, source in enumerate(SOURCES)
        for is_level in (True, False)[: 1 + source.is_photo]
        for overlap in OVERLAPS
        if run.wants(_case(source, is_level, overlap))
    ]
    others = [number for number, source in enumerate(SOURCES) if run.wants(f"unrelated {source.name}")]
    with ProcessPoolExecutor(mp_context=multiprocessing.get_context("fork")) as pool:
        found = [pool.submit(_related, *case, count) for case in cases]
        refused = [pool.submit(_unrelated, number, count) for number in others]
        rows, unrelated = [one.result() for one in found], [one.result() for one in refused]
    body = f"{_ABOUT}\n\n{page.table(COLUMNS, rows)}\n\n{page.table(UNRELATED, unrelated)}"
    photos = sorted((run.data / "dji_brighton_beach").glob("*.JPG"))
    if photos and run.wants("drone"):
        body += "\n\n" + _drone(photos)
    return {"relative motion": body}


_ABOUT = f"""\
Any turn, scale {SCALES[0]}–{SCALES[1]}, other exposure, color, vignetting and blur (up to {BLUR_PX} pixels) in each
image; photos of {EDGE_PX} pixels, label images of {LABEL_EDGE_PX}. Wrong: off by more than {WRONG:.0%} of the edge, of
the scale, or {math.degrees(WRONG):.0f}°. Times on one thread, of the processor."""


SOURCES: list[Source] = []
"""What the processes that measure rows share."""


def _sources(run: inputs.Run) -> Iterator[Source]:
    tiles = sorted((run.data / inputs.TILES).glob("*_image.tif"))
    yield Source("Dubai, six tiles", [_colors(path) for path in tiles], EDGE_PX)
    banepa = run.data / "banepa" / "banepa_photo.tif"
    if banepa.exists():
        yield Source("Banepa", [_colors(banepa)], EDGE_PX, pixel_sizes=(1.0, 2.5))
    labels = [inputs.read_labels(run.label_map())]
    meters = {"true labels": None, "20 / 20 / 5 %": GOAL, "poor network": STRONG}
    for name, noise in meters.items():
        yield Source(f"Liechtenstein, {name}", labels, LABEL_EDGE_PX, noise, (0.9, 1.1))


def _colors(path: Path) -> np.ndarray:
    """(H, W, 3) of a photo."""
    from osgeo import gdal

    return np.ascontiguousarray(np.moveaxis(gdal.Open(str(path)).ReadAsArray()[:3], 0, 2))


def _case(source: Source, is_level: bool, overlap: tuple[float, float]) -> str:
    seen = source.name + ("" if is_level else f", tilt ≤ {TILT_DEG:g}°, lens ± {LENS:.1%}")
    return f"{seen} {overlap[0]:.0%}–{overlap[1]:.0%}"


def _related(number: int, is_level: bool, overlap: tuple[float, float], count: int) -> list[str]:
    """A row: pairs of a source with an overlap."""
    source, tally = SOURCES[number], Tally()
    for turn in range(count):
        rng = np.random.default_rng([SEED, round(100 * overlap[0]), turn])
        raster = source.rasters[turn % len(source.rasters)]
        views = _pair(raster, source, rng.uniform(*overlap), is_level, rng)
        images = [_shown(raster, view, source, rng) for view in views]
        start = time.process_time()
        features = [source.features(image) for image in images]
        middle = time.process_time()
        motion = motion_between(*features)
        tally.seconds.append(((middle - start) / 2, time.process_time() - middle))
        tally.add(motion, _truth(*views), source.edge_px)
    case, _, share = _case(source, is_level, overlap).rpartition(" ")
    row = tally.row(case, share)
    print("  " + " | ".join(row), dict(tally.reasons), file=sys.stderr, flush=True)
    return row


def _pair(raster: np.ndarray, source: Source, overlap: float, is_level: bool, rng: np.random.Generator) -> list[View]:
    """Two views with an overlap, wholly on the raster and, of labels, on labeled ground."""
    height, width = raster.shape[:2]
    frame = replace(PIXELS, shape_hw=(height, width))
    while True:
        first = _view(rng.uniform(0, width), -rng.uniform(0, height), source, is_level, rng)
        second = _view(first.x, first.y, source, is_level, rng)
        second = replace(second, pixel_size=first.pixel_size * rng.uniform(*SCALES))
        second = _moved(first, second, overlap, rng.uniform(0, 2 * math.pi))
        if not (lies_on(frame, first) and lies_on(frame, second)):
            continue
        if raster.ndim == 3 or all((cut(raster, PIXELS, view) > 0).mean() > 0.9 for view in (first, second)):
            return [first, second]


def _view(x: float, y: float, source: Source, is_level: bool, rng: np.random.Generator) -> View:
    size = float(np.exp(rng.uniform(*np.log(source.pixel_sizes))))
    view = View(x, y, rng.uniform(0, 360), size, source.edge_px, source.edge_px)
    tilt, direction, lens = rng.uniform(0, TILT_DEG), rng.uniform(0, 360), rng.uniform(-LENS, LENS)
    return view if is_level else replace(view, tilt_deg=tilt, tilt_direction_deg=direction, lens=lens)


def _moved(first: View, second: View, overlap: float, direction: float) -> View:
    """The second view so far from the first that so much of it lies there."""
    places = (np.arange(24) + 0.5) / 24
    u, v = np.meshgrid(places * second.width_px, places * second.height_px)
    near, far = 0.0, 2.0 * first.footprint
    for _ in range(16):
        middle = (near + far) / 2
        moved = replace(
            second, x=first.x + middle * math.cos(direction), y=first.y + middle * math.sin(direction), tilt_deg=0
        )
        x, y = map_coordinates(moved, u, v)
        turn = (x - first.x + 1j * (y - first.y)) / turn_of(first.heading_deg, first.pixel_size)
        inside = (np.abs(turn.real) < first.width_px / 2) & (np.abs(turn.imag) < first.height_px / 2)
        near, far = (middle, far) if inside.mean() > overlap else (near, middle)
    return replace(moved, tilt_deg=second.tilt_deg)


def _shown(raster: np.ndarray, view: View, source: Source, rng: np.random.Generator) -> np.ndarray:
    """The view's picture, its exposure drawn; of labels, spoilt."""
    if raster.ndim == 2:
        labels = cut(raster, PIXELS, view)
        if source.noise is None:
            return labels
        values = np.unique(labels[labels > 0]).tolist()
        return spoil_labels(labels, source.noise.in_pixels(view.pixel_size), rng, values, None, 1.0)
    columns, rows = np.meshgrid(np.arange(view.width_px) + 0.5, np.arange(view.height_px) + 0.5)
    x, y = map_coordinates(view, columns, rows)
    picture = cv2.remap(raster, (x - 0.5).astype(np.float32), (-y - 0.5).astype(np.float32), cv2.INTER_LINEAR)
    return exposed(picture, rng)


def exposed(picture: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """A photo (H, W, 3) uint8 with another exposure, gamma, color, vignetting, blur and noise."""
    picture = cv2.GaussianBlur(picture, (0, 0), rng.uniform(0.05, BLUR_PX))
    light = (picture.astype(np.float32) / 255) ** float(np.exp(rng.normal(0, 0.25)))
    light *= (np.exp(rng.normal(0, 0.15)) * np.exp(rng.normal(0, 0.06, 3))).astype(np.float32)
    down, right = (np.linspace(-1, 1, edge, dtype=np.float32) for edge in picture.shape[:2])
    light *= (1 - rng.uniform(0, 0.3) * (down[:, None] ** 2 + right**2) / 2)[..., None].astype(np.float32)
    light += rng.normal(0, 0.01, light.shape).astype(np.float32) + np.float32(rng.normal(0, 0.03))
    return np.clip(255 * light, 0, 255).astype(np.uint8)


def _truth(first: View, second: View) -> Link:
    apart = complex(second.x - first.x, second.y - first.y) / turn_of(first.heading_deg, first.pixel_size)
    turn = math.radians((second.heading_deg - first.heading_deg + 180) % 360 - 180)
    scale = math.log(second.pixel_size / first.pixel_size)
    return Link(0, 1, (apart.real, -apart.imag), turn, scale, tuple(tuple(row) for row in np.eye(4).tolist()))


def _unrelated(number: int, count: int) -> list[str]:
    """A row: images that show no ground in common, all against all."""
    source, rng = SOURCES[number], np.random.default_rng([SEED, 7])
    seen: list[tuple[int, View, Features]] = []
    for turn in range(min(3 * count, MOST_UNRELATED)):
        index = turn % len(source.rasters)
        view = _pair(source.rasters[index], source, 0.5, False, rng)[0]
        seen.append((index, view, source.features(_shown(source.rasters[index], view, source, rng))))
    wrong = pairs = 0
    for turn, (index, view, features) in enumerate(seen):
        for other_index, other, others in seen[:turn]:
            apart = math.hypot(view.x - other.x, view.y - other.y)
            if index == other_index and apart < 0.75 * (view.footprint + other.footprint):
                continue
            pairs += 1
            wrong += motion_between(others, features).link is not None
    row = [source.name, str(pairs), page.rate(wrong, pairs)]
    print("  " + " | ".join(row), file=sys.stderr, flush=True)
    return row


_TURNED = (
    "their XMP says that a photo viewer saved one of the two photos, which seems to have turned it after the camera "
    "wrote its yaw"
)


def _drone(photos: Sequence[Path]) -> str:
    """Links of consecutive drone photos in meters, by height and lens, beside what GPS says."""
    cameras = [photo_camera(str(path)) for path in photos]
    places = [_gps(path) for path in photos]
    features = [photo_features(_colors(path)) for path in photos]
    rows, ratios, turns = [], [], []
    for first in range(len(photos)):
        for second in range(first + 1, min(first + 3, len(photos))):
            east, north = _apart(places[first], places[second])
            by_gps = math.hypot(east, north)
            motion = motion_between(features[first], features[second], (first, second))
            name = f"{photos[first].stem} → {photos[second].stem}"
            if motion.link is None:
                rows.append([name, f"{by_gps:.1f}", "–", "–", "–", f"no: {motion.reason}"])
                continue
            meters = _pixel_size(cameras[first], photos[first])
            known = math.hypot(*motion.link.translation) * meters
            turned = math.degrees(motion.link.turn)
            told = (cameras[second].heading_deg - cameras[first].heading_deg + 180) % 360 - 180
            if by_gps > 5:
                ratios.append(known / by_gps)
            turns.append(abs((turned - told + 180) % 360 - 180))
            spread = math.sqrt(np.trace(np.array(motion.link.covariance)[:2, :2]) / 2) * meters
            moved = f"{known:.1f} ± {spread:.2f}"
            rows.append([name, f"{by_gps:.1f}", moved, f"{told:.1f}°", f"{turned:.1f}°", f"{motion.overlap:.0%}"])
    head = ("eight drone photos", "m by GPS", "m by pixels and height", "turned by yaw", "by pixels", "overlap")
    said = f"Meters by pixels over meters by GPS: {np.mean(ratios):.2f} ± {np.std(ratios):.2f}." if ratios else ""
    near = [off for off in turns if off < 90]
    off = (
        f" Turns by pixels and by yaw differ by {np.sqrt(np.mean(np.square(near))):.1f}° (root mean square)"
        if near
        else ""
    )
    off += f", and of {len(turns) - len(near)} pairs by half a turn: {_TURNED}." if len(near) < len(turns) else "."
    return f"{page.table(head, rows)}\n\n{said}{off}"


def _pixel_size(camera: Camera, photo: Path) -> float:
    """Meters a pixel by height above take-off and lens."""
    from osgeo import gdal

    file = gdal.Open(str(photo))
    return camera.height.meters / camera.lens.focal_length_px((file.RasterYSize, file.RasterXSize))


def _gps(path: Path) -> tuple[float, float]:
    """(longitude, latitude) of EXIF, degrees."""
    from osgeo import gdal

    tags = gdal.Open(str(path)).GetMetadata()
    found = []
    for name, negative in (("Longitude", "W"), ("Latitude", "S")):
        parts = [float(part.strip("() ")) for part in tags[f"EXIF_GPS{name}"].split(")") if part.strip()]
        degrees = sum(part / 60**power for power, part in enumerate(parts))
        found.append(-degrees if tags[f"EXIF_GPS{name}Ref"].startswith(negative) else degrees)
    return found[0], found[1]


def _apart(first: tuple[float, float], second: tuple[float, float]) -> tuple[float, float]:
    """Meters to the east and north."""
    meters = 111_320.0
    return (second[0] - first[0]) * meters * math.cos(math.radians(first[1])), (second[1] - first[1]) * meters
