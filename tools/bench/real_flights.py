"""Flights over real pixels: strips of photos cut from a tile that the network was not trained on.

.venv/bin/python tools/bench real_flights --model FOLDER [--count 10] [--write]

FOLDER holds networks named after the tiles that were left out (real_tiles.py). Exposure, color, vignetting and blur
change from photo to photo; labels are the network's, motion is seen in the pixels, nothing is told but the pixel size
to 10 %.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from bench import inputs, kept, page
from bench.flights import WRONG_SHARE, is_wrong
from bench.ground import Ground, tile_ground, tile_paths
from bench.motion import exposed
from bench.photos import TRUE_LABELS, Network, seen
from bench.real_tiles import networks
from semref.core.assessment.flights import SIZE_KNOWN
from semref.core.flight.flight import localize_flight
from semref.core.flight.model import FlightImage
from semref.core.flight.motion import Link
from semref.core.flight.pixel_features import photo_features
from semref.core.flight.pixel_motion import motion_between
from semref.core.labels.class_shares import SeenLabels
from semref.core.localization import Localization, Method, Prior
from semref.core.simulation.views import View, lies_on

PAGE = "benchmarks.md"
AREA = "dubai_aerial."
SEED = 1617
COUNT, QUICK_COUNT = 10, 1
EDGE_PX, IMAGES, OVERLAP = 512, 6, 0.6
SCALES = (0.9, 1.1)
CRAB_DEG, BEND_DEG = 10.0, 3.0
MOST_TRIES = 100_000

Placed = list[Any]
"""Of an image with a position: error and edge in pixels of the tile, whether its ellipse holds it; else None."""


@dataclass(frozen=True)
class Strip:
    """Photos of a flight, as views of a tile."""

    views: list[View]
    photos: list[np.ndarray]


def measure(run: inputs.Run) -> dict[str, str]:
    models = networks(run.model) if run.model and run.model.is_dir() else {}
    flights: list[dict[str, Any]] = []
    rows = []
    for path in tile_paths(run):
        number = int(path.stem.removeprefix("tile").partition("_")[0])
        if number not in models or not run.wants(f"tile {number}"):
            continue
        here = _of_tile(run, path, number, models[number])
        flights += here
        rows += _rows(f"tile {number}", here)
    if not flights:
        return {"flights over real photos": "Not measured: there is no network without a tile, or no tile."}
    rows += _rows("all", flights)
    about = _ABOUT.format(images=IMAGES, edge=EDGE_PX, overlap=100 * OVERLAP, wrong=100 * WRONG_SHARE)
    return {"flights over real photos": f"{about}\n\n{page.table(COLUMNS, rows)}\n\n{_motion(flights)}"}


def _of_tile(run: inputs.Run, path: Path, number: int, model: Path) -> list[dict[str, Any]]:
    ground = tile_ground(path)
    picture = np.ascontiguousarray(np.moveaxis(inputs.read_labels(str(path).replace("_label", "_image"))[:3], 0, 2))
    network = Network(model, ground)
    ground.localizer.heed_biases(*network.biases)

    def now(part: int, _: int) -> dict[str, Any]:
        return _flown(ground, _strip(ground, picture, np.random.default_rng([SEED, number, part])), network)

    found = []
    for part in range(run.how_many(COUNT, QUICK_COUNT)):
        name = f"tile {number} {model.stem}"
        found.append(kept.part(run, "real_flights", name, part, 1, now, (*kept.OF_ALL, "flight")))
        print(f"  tile {number}, strip {part + 1}: {_rows('', [found[-1]])}", file=sys.stderr, flush=True)
    return found


def _strip(ground: Ground, picture: np.ndarray, rng: np.random.Generator) -> Strip:
    """A strip that lies on the tile; ValueError where none does."""
    height, width = picture.shape[:2]
    frame = replace(ground.frame, shape_hw=(height, width))
    for _ in range(MOST_TRIES):
        x, y = frame.to_map(np.array([rng.uniform(0, width), rng.uniform(0, height)]))
        course, crab = rng.uniform(0, 360), rng.uniform(-CRAB_DEG, CRAB_DEG)
        size, views = float(np.exp(rng.uniform(*np.log(SCALES)))), []
        for _ in range(IMAGES):
            here = size * float(np.exp(rng.normal(0, 0.01))) * frame.pixel_size
            views.append(View(float(x), float(y), float((course + crab) % 360), here, EDGE_PX, EDGE_PX))
            course += rng.normal(0, BEND_DEG)
            step = (1 - OVERLAP) * EDGE_PX * size * frame.pixel_size
            x, y = x + step * np.sin(np.radians(course)), y + step * np.cos(np.radians(course))
        if all(lies_on(frame, view) for view in views):
            return Strip(views, [exposed(seen(ground, picture, view), rng) for view in views])
    raise ValueError(f"No strip of {IMAGES} images lies on the tile.")


def _flown(ground: Ground, strip: Strip, network: Network) -> dict[str, Any]:
    """What each way makes of a strip, and how far its links are off."""
    features = [photo_features(photo) for photo in strip.photos]
    motions = [motion_between(*pair, (number, number + 1)) for number, pair in enumerate(zip(features, features[1:]))]
    links = [motion.link for motion in motions if motion.link is not None]
    found: dict[str, Any] = {"links": [len(links), len(motions)], "off": [_off(link, strip.views) for link in links]}
    sources: dict[str, Callable[[int], SeenLabels]] = {
        "network": lambda n: network.seen(strip.photos[n]),
        TRUE_LABELS: lambda n: SeenLabels(ground.cut(strip.views[n])),
    }
    for source, look in sources.items():
        images = []
        for number, view in enumerate(strip.views):
            sizes = view.pixel_size / SIZE_KNOWN, view.pixel_size * SIZE_KNOWN
            given, prior = look(number), Prior(pixel_size_range=sizes)
            own = ground.localizer.localize(given.labels_hw, Method.AUTOMATIC, prior, shares=given.shares)
            images.append(FlightImage(f"{number}", given.labels_hw, own, float(number), prior))
        found[f"{source}, each image alone"] = [_placed(one.own, view) for one, view in zip(images, strip.views)]
        poses = [pose.localization() for pose in localize_flight(images, links, ground.localizer).poses]
        found[f"{source}, flight"] = [_placed(pose, view) for pose, view in zip(poses, strip.views)]
    return found


def _off(link: Link, views: Sequence[View]) -> float:
    """By what share of the way a link is off."""
    first, second = views[link.first], views[link.second]
    turn, size = np.radians(first.heading_deg), first.pixel_size
    away = complex(second.x - first.x, second.y - first.y) * np.exp(1j * turn) / size
    return float(abs(link.step - away) / abs(away))


def _placed(found: Localization, view: View) -> Placed | None:
    if not found.is_fix:
        return None
    off = np.subtract(found.position, view.position)
    known = np.array(found.covariance.position)
    holds = bool(off @ np.linalg.solve(known, off) <= -2 * np.log(0.05))
    return [float(np.hypot(*off)), view.footprint, holds]


COLUMNS = ("strips, labels, way", "placed", "wrong", "median, largest error, px", "in the 95 % ellipse")


def _rows(name: str, flights: Sequence[dict[str, Any]]) -> list[list[str]]:
    rows = []
    for way in flights[0]:
        if way in ("links", "off"):
            continue
        images = [image for flight in flights for image in flight[way]]
        placed = [image for image in images if image]
        errors = [image[0] for image in placed]
        rows.append(
            [
                f"{name}, {way}",
                page.rate(len(placed), len(images)),
                page.rate(sum(map(is_wrong, placed)), len(images)),
                f"{np.median(errors):.1f}, {max(errors):.1f}" if errors else "–",
                page.rate(sum(image[2] for image in placed), len(placed)),
            ]
        )
    return rows


def _motion(flights: Sequence[dict[str, Any]]) -> str:
    linked, pairs = np.sum([flight["links"] for flight in flights], axis=0)
    off = [share for flight in flights for share in flight["off"]]
    told = f"off by {100 * np.median(off):.3f} % of the way (median), {100 * max(off):.2g} % at most" if off else "–"
    return f"Motion from pixels: {page.rate(int(linked), int(pairs))} of the pairs of neighbors are linked, {told}."


_ABOUT = """\
Strips of {images} photos of {edge} px with an overlap of {overlap:g} %, straight but for 3° from photo to photo, any
course, at 0.9–1.1 of the tile's pixels; exposure, color, vignetting and blur differ from photo to photo. Labels by the
network that was trained without the tile, motion from the pixels, pixel size told to 10 %, start, heading and place
unknown; searched: the tile, whose annotation is the database. Wrong: off by more than {wrong:g} % of the edge."""
