"""Simulated flights: where their images lie, what those show, how they seem to move. What benches of flights share."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from bench.ground import Ground
from semref.core.assessment.flights import SIZE_KNOWN, link_between
from semref.core.flight.model import FlightImage
from semref.core.flight.motion import Link
from semref.core.localization import Prior
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.noise import LabelNoise
from semref.core.simulation.views import View, cut

LARGEST_TRIES = 5_000
BEND_DEG = 6.0
"""Deviation of the course from one image to the next."""

CRAB_DEG = 10.0
"""Headings differ from courses by so much at most, the same all along a flight."""

LEAST_LABELED, LEAST_PIXEL = 0.7, 0.5


@dataclass(frozen=True)
class Kind:
    """What flights to draw.

    Attributes:
        ground_m: edge of an image on the ground
        step_m: from image to image
        count: images
        noise: of the labels, in map units
        drift: of the links: deviation of each, and of what is wrong all along, shares of the distance
        missing: every so many-th link is missing; 0 for none
        scales: smallest and largest pixel size, pixels of the map
    """

    ground_m: float = 640.0
    step_m: float = 200.0
    count: int = 30
    noise: LabelNoise = LabelNoise()
    drift: float = 0.01
    missing: int = 0
    scales: tuple[float, float] = (0.8, 1.25)


@dataclass(frozen=True)
class Flown:
    """A flight with its truth."""

    images: list[FlightImage]
    links: list[Link]
    views: list[View]

    def mirrored(self) -> Flown:
        """It lies nowhere."""
        images = [replace(i, labels_hw=np.ascontiguousarray(i.labels_hw[:, ::-1])) for i in self.images]
        return Flown(images, [link.mirrored() for link in self.links], self.views)


def draw(ground: Ground, kind: Kind, rng: np.random.Generator) -> Flown:
    """A flight over a ground's extent whose images all show the map; ValueError where there is none."""
    return fly(ground, kind, *route(ground, kind, rng), rng)


def route(ground: Ground, kind: Kind, rng: np.random.Generator) -> tuple[list[View], list[np.ndarray]]:
    """Views of a flight, all of the map, and what they show of it; ValueError where there is none."""
    left, bottom, right, top = ground.extent
    for _ in range(LARGEST_TRIES):
        views = _views(ground, kind, rng)
        if not all(left < view.x < right and bottom < view.y < top for view in views):
            continue
        columns, rows = ground.frame.to_pixels(np.array([view.position for view in views])).astype(int).T
        if not ground.labels_hw[rows, columns].all():
            continue
        seen = [cut(ground.labels_hw, ground.frame, view) for view in views]
        if min((labels > 0).mean() for labels in seen) >= LEAST_LABELED:
            return views, seen
    raise ValueError(f"{LARGEST_TRIES} flights left the map.")


def _views(ground: Ground, kind: Kind, rng: np.random.Generator) -> list[View]:
    left, bottom, right, top = ground.extent
    x, y, course = rng.uniform(left, right), rng.uniform(bottom, top), rng.uniform(0, 360)
    crab, size = rng.uniform(-CRAB_DEG, CRAB_DEG), np.exp(rng.uniform(*np.log(kind.scales))) * ground.frame.pixel_size
    edge, views = round(kind.ground_m / size), []
    for _ in range(kind.count):
        here = float(size * np.exp(rng.normal(0, 0.005)))
        views.append(View(float(x), float(y), float((course + crab) % 360), here, edge, edge))
        course += rng.normal(0, BEND_DEG)
        x, y = x + kind.step_m * np.sin(np.radians(course)), y + kind.step_m * np.cos(np.radians(course))
    return views


def fly(ground: Ground, kind: Kind, views: list[View], seen: list[np.ndarray], rng: np.random.Generator) -> Flown:
    """Images and links as a flight along a route has them: another one each time."""
    bias = complex(*rng.normal(0, kind.drift, 2))
    links = [link_between(number, pair, kind.drift, bias, rng) for number, pair in enumerate(zip(views, views[1:]))]
    if kind.missing:
        links = [link for link in links if link.second % kind.missing]
    images = []
    for number, (view, labels) in enumerate(zip(views, seen)):
        smallest = max(ground.database.parameters.minimum_area / view.pixel_size**2, 1.0)
        noise = kind.noise.in_pixels(view.pixel_size)
        if kind.noise != LabelNoise():
            labels = spoil_labels(labels, noise, rng, ground.spoiled_values, None, smallest)
        sizes = view.pixel_size / SIZE_KNOWN, view.pixel_size * SIZE_KNOWN
        images.append(FlightImage(f"{number:03d}", labels, time_s=float(number), prior=Prior(pixel_size_range=sizes)))
    return Flown(images, links, views)
