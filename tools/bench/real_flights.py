"""Flights over real pixels: strips of photos cut from ground that the network was not trained on.

.venv/bin/python tools/bench real_flights --model FOLDER [--count 10] [--only banepa] [--write]

FOLDER holds networks named after the tiles (real_tiles.py) or the half of Banepa (real_places.py) that were left out;
each is a section of its own, and what FOLDER has no network for is not touched. Exposure, color, vignetting and blur
change from photo to photo; labels are the network's, motion is seen in the pixels, nothing is told but the pixel size
to 10 %.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from bench import inputs, kept, page, photo_places, real_places
from bench.flights import WRONG_SHARE, is_wrong
from bench.ground import Ground
from bench.motion import exposed
from bench.photos import TRUE_LABELS, Network, seen
from bench.real_tiles import networks
from bench.tiles import tile_ground, tile_paths
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
AREA = "dubai_aerial, and banepa where named."
HALVES = ("banepa_west", "banepa_east")
"""Flown by networks that were trained without them."""

SEED = 1617
COUNT, QUICK_COUNT = 10, 1
EDGE_PX, IMAGES, OVERLAP = 512, 6, 0.6
SCALES = (0.9, 1.1)
CRAB_DEG, BEND_DEG = 10.0, 3.0
MOST_TRIES = 100_000

Placed = list[Any]
"""Of an image with a position: error and edge in pixels of the tile, whether its ellipse holds it; else None."""


@dataclass(frozen=True)
class Strips:
    """What strips are cut from.

    Attributes:
        ground: With the labels; its database is searched.
        picture: (H, W, 3) uint8 on its pixels.
        columns: (first, last) that strips may show.
    """

    ground: Ground
    picture: np.ndarray
    columns: tuple[int, int]


@dataclass(frozen=True)
class Strip:
    """Photos of a flight, as views of the ground."""

    views: list[View]
    photos: list[np.ndarray]


def measure(run: inputs.Run) -> dict[str, str]:
    if not (run.model and run.model.is_dir()):
        return {"flights over real photos": "Not measured: --model names no folder of networks."}
    found = {"flights over real photos": _tiles(run), "flights over Banepa": _banepa(run)}
    if not any(found.values()):
        print(f"Not measured: {run.model} holds no network that was trained without such ground.", file=sys.stderr)
    return {name: body for name, body in found.items() if body}


def _tiles(run: inputs.Run) -> str:
    """The section of dubai_aerial; empty without networks or photos."""
    models = networks(run.model)
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
        return ""
    rows += _rows("all", flights)
    about = _ABOUT.format(images=IMAGES, edge=EDGE_PX, overlap=100 * OVERLAP, wrong=100 * WRONG_SHARE)
    return f"{about}\n\n{page.table(COLUMNS, rows)}\n\n{_motion(flights)}"


def _banepa(run: inputs.Run) -> str:
    """The section of flights over a half of Banepa by networks that did not see it; empty without any."""
    flights: list[dict[str, Any]] = []
    rows = []
    for name in HALVES:
        models = real_places.without(run.model, name) if run.wants(name) else []
        (photo,) = photo_places.place(name).photos
        if not models or not (run.data / photo.image).exists():
            continue
        place = real_places.ground_of(run, photo)
        strips = Strips(place.ground, place.picture, place.part)
        for model in models:
            network = real_places.BuildingsNetwork(model, place.ground)
            title = f"{name}, {model.stem.partition('_without_')[0].replace('_', ' ')}"
            here = _flights(run, strips, network, (title, HALVES.index(name)))
            rows += _rows(title, [{way: found for way, found in one.items() if TRUE_LABELS not in way} for one in here])
        # The same strips for all networks, so that motion and true labels are those of any.
        flights += here
        rows += _rows(name, [{way: found for way, found in one.items() if TRUE_LABELS in way} for one in here])
    if not flights:
        return ""
    about = _ABOUT_BANEPA.format(images=IMAGES, edge=EDGE_PX, overlap=100 * OVERLAP, wrong=100 * WRONG_SHARE)
    return f"{about}\n\n{page.table(COLUMNS, rows)}\n\n{_motion(flights)}"


def _of_tile(run: inputs.Run, path: Path, number: int, model: Path) -> list[dict[str, Any]]:
    ground = tile_ground(path)
    picture = np.ascontiguousarray(np.moveaxis(inputs.read_labels(str(path).replace("_label", "_image"))[:3], 0, 2))
    network = Network(model, ground)
    strips = Strips(ground, picture, (0, picture.shape[1]))
    return _flights(run, strips, network, (f"tile {number} {model.stem}", number))


def _flights(run: inputs.Run, strips: Strips, network: Network, named: tuple[str, int]) -> list[dict[str, Any]]:
    """What is made of each strip; ``named``: under which name it is kept, and what the strips are drawn by."""
    ground, (name, number) = strips.ground, named
    ground.localizer.heed_biases(*network.biases)

    def now(part: int, _: int) -> dict[str, Any]:
        return _flown(ground, _strip(strips, np.random.default_rng([SEED, number, part])), network)

    found = []
    for part in range(run.how_many(COUNT, QUICK_COUNT)):
        found.append(kept.part(run, "real_flights", name, part, 1, now, (*kept.OF_ALL, "flight")))
        print(f"  {name}, strip {part + 1}: {_rows('', [found[-1]])}", file=sys.stderr, flush=True)
    return found


def _strip(strips: Strips, rng: np.random.Generator) -> Strip:
    """A strip that lies on the ground; ValueError where none does."""
    ground, picture, (first, last) = strips.ground, strips.picture, strips.columns
    height, width = picture.shape[0], last - first
    frame = ground.frame.part(first, 0, (height, width))
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
    raise ValueError(f"No strip of {IMAGES} images lies on the ground.")


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
    # In pixels of the image: of one ground meters are known, of the other not.
    return [float(np.hypot(*off)) / view.pixel_size, view.footprint / view.pixel_size, holds]


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

_ABOUT_BANEPA = """\
Strips of {images} photos of {edge} px of 0.25 m with an overlap of {overlap:g} %, straight but for 3° from photo to
photo, wholly on the half of Banepa that the network was not trained on, at 0.9–1.1 of its pixels; exposure, color,
vignetting and blur differ from photo to photo. Networks saw the other half for so many minutes
(`tools/bench own_buildings`), buildings and “other” alone; motion from the pixels, pixel size told to 10 %, start,
heading and place unknown; searched: both halves, 413 × 544 m. Wrong: off by more than {wrong:g} % of the edge."""
