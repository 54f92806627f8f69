"""Measure flights: draw routes over a map, add noise to their images, and localize each flight as one track."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any, cast

import cv2
import numpy as np

from benchmarks import photos
from benchmarks.accuracy import BUILDINGS, NOISES, MapRow, measure, rows_of
from benchmarks.ground import Ground
from benchmarks.maps import World
from benchmarks.network_errors import NetworkNoise, spoil
from benchmarks.results import Table, rate
from semref.core.assessment.flights import SIZE_KNOWN, link_between
from semref.core.flight.flight import FlightSolver
from semref.core.flight.model import FlightImage
from semref.core.flight.motion import Link
from semref.core.flight.pixel_features import photo_features
from semref.core.flight.pixel_links import PixelLinks
from semref.core.localization import RISK, Localization, Method, Place, Prior
from semref.core.localizer.reach import Reach, search_within_reach
from semref.core.localizer.search import Search
from semref.core.pipeline import localize_with
from semref.core.simulation.noise import DISPLACED_M
from semref.core.simulation.views import View, cut

LARGEST_TRIES = 50_000
BEND_DEG, CRAB_DEG = 6.0, 10.0
"""Deviation of the course from image to image, and largest difference of heading and course."""

WRONG_SHARE = 0.1
"""A pose with a larger error, as a share of the image's edge, is wrong."""

AT = (1, 3, 5, 10, 20, 30)
COLUMNS = (
    "flights",
    "flights, images",
    "placed (whole flight)",
    "wrong",
    "median, 95th percentile of error",
    "in the 95 % ellipse",
    "right alone",
    *(f"image {n}" for n in AT),
    "only predicted, in the 95 % ellipse",
    "likely, wrong of these",
)


@dataclass(frozen=True)
class Row(MapRow):
    """Flights of one kind, with noise in meters.

    Attributes:
        ground_m: Footprint width of an image.
        step_m: Distance from image to image.
        length: Number of images.
        drift: Drift of the links, as a share of the distance.
        missing: Every n-th link is missing; 0 for no missing link.
        scales: Pixel sizes in pixels of the map.
        landmarks: Least number of the database's landmarks in each image.
        labeled: Least share of each image that the database's map labels, too.
        reach_m: Distance that the aircraft can fly from image to image; the motion is unknown then. 0 for known motion.
    """

    noise: str = "strong"
    count: int = 20
    ground_m: float = 640.0
    step_m: float = 200.0
    length: int = 30
    drift: float = 0.01
    missing: int = 0
    scales: list[float] = field(default_factory=lambda: [0.8, 1.25])
    landmarks: int = 0
    labeled: float = 0.0
    reach_m: float = 0.0


def run(world: World, name: str, scenario: dict[str, Any], only: Sequence[str]) -> list[Table]:
    """Measure the flights of a scenario."""

    def measured(row: Row) -> list[str]:
        source = photos.of(world, row) if row.photos else None
        ground = row.ground(world) if source is None else source.ground
        known, numbers = row.known(ground), range(world.count or row.count)
        found = cells(row, [one_flight(ground, known, row, number, source) for number in numbers])
        print("  " + " | ".join(found), file=sys.stderr, flush=True)
        return found

    return [{"columns": list(COLUMNS), "rows": list(measure(rows_of(scenario, Row), only, measured).values())}]


def one_flight(
    ground: Ground, known: Ground, row: Row, number: int, source: photos.Photos | None = None
) -> dict[str, list]:
    """Return the poses of the whole flight, and the poses known at each image."""
    rng = np.random.default_rng([1616, len(row.name), number])
    images, links, views, alone = draw(ground, row, rng, source)
    if row.foreign == "mirrored" and source is None:
        images = [replace(i, labels_hw=np.ascontiguousarray(i.labels_hw[:, ::-1])) for i in images]
        links = [link.mirrored() for link in links]
    # As for the user, the flight starts from what each image shows by itself.
    if source is None:
        images = [replace(i, own=known.localizer.localize(i.labels_hw, Method.AUTOMATIC, i.prior)) for i in images]
    if row.reach_m:
        images, links = _found_within_reach(images, known, row.reach_m), []
    solver = FlightSolver(known.localizer)
    for _ in solver.steps(images, links):
        pass
    ways = {"whole": solver.poses, "causal": solver.causal}
    placed = {name: [_placed(pose, view) for pose, view in zip(poses, views)] for name, poses in ways.items()}
    left = [(pose, view) for pose, view in zip(solver.causal, views) if not pose.is_fix and pose.place is not None]
    fixes = [found.fix for found in alone or (cast(Localization, image.own) for image in images)]
    right = [fix and _off(fix, view) <= WRONG_SHARE * view.footprint for fix, view in zip(fixes, views)]
    predicted = [_in_ellipse(*one) for one in left]
    likely = [(pose, view) for pose, view in zip(solver.poses, views) if pose.is_shown and not pose.is_fix]
    placed["likely"] = [(_off(pose.place, view), view.footprint) for pose, view in likely]
    return {**placed, "predicted": predicted, "alone": [bool(one) for one in right]}


def _found_within_reach(images: Sequence[FlightImage], known: Ground, reach_m: float) -> list[FlightImage]:
    """Return the images with what they show within reach of others, one unit of time apart."""

    def search(n: int, reach: Reach) -> Localization:
        localizer = known.localizer.with_risk(reach.allowed_risk)
        return localizer.localize(images[n].labels_hw, Method.AUTOMATIC, reach.narrow(images[n].prior))

    own, times_s = [image.own for image in images], [image.time_s for image in images]
    found = search_within_reach(own, times_s, reach_m, RISK, search)
    return [replace(image, own=found.get(n, image.own)) for n, image in enumerate(images)]


def _placed(pose: Any, view: View) -> tuple[float, float, bool] | None:
    """Return (error, footprint width, whether the ellipse contains the truth); None without a fix."""
    if not pose.is_fix:
        return None
    return _off(pose.place, view), view.footprint, _in_ellipse(pose, view)


def _off(place: Place, view: View) -> float:
    return float(np.hypot(*np.subtract(place.position, view.position)))


def _in_ellipse(pose: Any, view: View) -> bool:
    """Return whether the 95 % ellipse of a pose contains the truth."""
    off = np.subtract(pose.place.position, view.position)
    return float(off @ np.linalg.solve(np.array(pose.covariance.position), off)) <= -2 * np.log(0.05)


def draw(
    ground: Ground, row: Row, rng: np.random.Generator, source: photos.Photos | None = None
) -> tuple[list[FlightImage], list[Link], list[View], list[Localization]]:
    """Draw a flight over the extent of a ground, and localize its photos alone. All of its images show the map.

    Args:
        source: Photos of the ground and their network; None for noise instead.

    Raises:
        ValueError: The map has no room for a flight.
    """
    if source is not None:
        source.stay_inside()
    left, bottom, right, top = ground.extent
    for _ in range(LARGEST_TRIES):
        views = _route(ground, row, rng)
        if not all(left < view.x < right and bottom < view.y < top for view in views):
            continue
        if row.landmarks and not all(_landmarks_in(ground, view) >= row.landmarks for view in views):
            continue
        if row.labeled and min(_labeled(ground, view) for view in views) < row.labeled:
            continue
        columns, rows = ground.frame.to_pixels(np.array([view.position for view in views])).astype(int).T
        if not ground.labels_hw[rows, columns].all():
            continue
        seen = [cut(ground.labels_hw, ground.frame, view) for view in views]
        if min((labels > 0).mean() for labels in seen) >= 0.7:
            if source is None:
                return *_fly(ground, row, views, seen, rng), views, []
            images, links, alone = _photograph(source, row, views, rng)
            return images, links, views, alone
    raise ValueError(f"{LARGEST_TRIES} flights left the map.")


def _landmarks_in(ground: Ground, view: View) -> int:
    """Return the number of the database's landmarks in the circle that fits in an image."""
    away = ground.database.references.positions - np.array(view.position)
    return int((np.hypot(*away.T) < view.footprint / 2).sum())


def _labeled(ground: Ground, view: View) -> float:
    """Return the share of a view that the database's map labels."""
    pyramid, (left, top) = ground.localizer.pyramid, ground.localizer.pyramid.frame.origin
    reach = view.footprint / 2
    x, y = view.x - left, top - view.y
    level, _, _ = pyramid.crop(reach / 8, (x - reach, y - reach, x + reach, y + reach))
    return float(level.known.mean())


def _route(ground: Ground, row: Row, rng: np.random.Generator) -> list[View]:
    left, bottom, right, top = ground.extent
    x, y, course = rng.uniform(left, right), rng.uniform(bottom, top), rng.uniform(0, 360)
    crab, size = rng.uniform(-CRAB_DEG, CRAB_DEG), np.exp(rng.uniform(*np.log(row.scales))) * ground.frame.pixel_size
    edge, views = round(row.ground_m / size), []
    for _ in range(row.length):
        here = float(size * np.exp(rng.normal(0, 0.005)))
        views.append(View(float(x), float(y), float((course + crab) % 360), here, edge, edge))
        course += rng.normal(0, BEND_DEG)
        x, y = x + row.step_m * np.sin(np.radians(course)), y + row.step_m * np.cos(np.radians(course))
    return views


def _fly(
    ground: Ground, row: Row, views: list[View], seen: list[np.ndarray], rng: np.random.Generator
) -> tuple[list[FlightImage], list[Link]]:
    bias = complex(*rng.normal(0, row.drift, 2))
    links = [link_between(number, pair, row.drift, bias, rng) for number, pair in enumerate(zip(views, views[1:]))]
    if row.missing:
        links = [link for link in links if link.second % row.missing]
    noise = NOISES[row.noise]
    if noise != NetworkNoise():
        noise = replace(noise, displaced=DISPLACED_M, leaning=row.leaning, leaning_classes=BUILDINGS)
    images = []
    for number, (view, labels) in enumerate(zip(views, seen)):
        smallest = max(ground.database.parameters.minimum_area / view.pixel_size**2, 1.0)
        if noise != NetworkNoise():
            labels = spoil(labels, noise.in_pixels(view.pixel_size), rng, BUILDINGS, None, smallest)
        sizes = view.pixel_size / SIZE_KNOWN, view.pixel_size * SIZE_KNOWN
        prior = Prior(pixel_size_range=sizes, **row.heading(view, rng))
        images.append(FlightImage(f"{number:03d}", labels, time_s=float(number), prior=prior))
    return images, links


def _photograph(
    source: photos.Photos, row: Row, views: list[View], rng: np.random.Generator
) -> tuple[list[FlightImage], list[Link], list[Localization]]:
    """Take the photos of a flight with another exposure, blur and noise each; label, link and localize them.

    Alone, a photo without a position is labeled again, as by *Localize images*; *Localize flight* labels it once.
    """
    images, pixels, alone = [], PixelLinks(), []
    for number, view in enumerate(views):
        photo = source.taken(replace(view, is_mirrored=row.foreign == "mirrored")) * rng.uniform(0.85, 1.15)
        photo = cv2.GaussianBlur(photo, (0, 0), rng.uniform(0.3, 0.8)) + rng.normal(0, 3, photo.shape)
        photo = np.clip(photo, 0, 255).astype(np.uint8)
        prior, seen = Prior(pixel_size_range=source.searched), source.labeled(photo)
        known = source.ground.localizer, Search(Method.AUTOMATIC)
        own = localize_with(*known, replace(seen, look_again=None), prior, None).localization
        alone.append(own if own.is_fix else localize_with(*known, seen, prior, None).localization)
        is_apart = pixels.add(photo_features(photo))
        known = own, float(number), prior, seen.biases
        images.append(FlightImage(f"{number:03d}", seen.labels_hw, *known, is_apart=is_apart, shares=seen.shares))
    return images, pixels.links, alone


def cells(row: Row, flown: Sequence[dict[str, list]]) -> list[str]:
    """Return the cells of a row, one per column."""
    images = [one for flight in flown for one in flight["whole"]]
    placed = [one for one in images if one]
    wrong = [one for one in placed if row.foreign or one[0] > WRONG_SHARE * one[1]]
    likely = [one for flight in flown for one in flight["likely"]]
    wrong_likely = [one for one in likely if row.foreign or one[0] > WRONG_SHARE * one[1]]
    errors = [] if row.foreign else [one[0] for one in placed]
    predicted = [one for flight in flown for one in flight["predicted"]]
    steps = []
    for number in AT:
        known = [flight["causal"][number - 1] for flight in flown if number <= len(flight["causal"])]
        steps.append(f"{sum(one is not None for one in known)}/{len(known)}")
    return [
        row.name,
        f"{len(flown)}, {len(images)}",
        rate(len(placed), len(images)),
        rate(len(wrong), len(images)),
        f"{np.median(errors):.1f} m, {np.percentile(errors, 95):.1f} m" if errors else "–",
        rate(sum(one[2] for one in placed), len(placed)) if errors else "–",
        rate(sum(sum(flight["alone"]) for flight in flown), len(images)),
        *steps,
        rate(sum(predicted), len(predicted)) if predicted else "–",
        f"{len(likely)}, {len(wrong_likely)}",
    ]
