"""A made map of patches, and flights over it with known truth."""

from dataclasses import dataclass, replace

import numpy as np

from semref.core.flight.model import FlightImage
from semref.core.flight.motion import Link, as_rows
from semref.core.flight.settings import FLIGHT
from semref.core.geometry.frame import MapFrame
from semref.core.geometry.pose import PoseCovariance, turn_of
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.localization import Localization, Method, Place, Prior, Status
from semref.core.simulation.views import View, cut

FRAME = MapFrame.at((500_000.0, 5_200_000.0), 4.0, (420, 480), "a metric CRS")
TABLE = ClassTable(tuple(LandCoverClass(n, f"class {n}", f"#0000{n}0", "reference") for n in range(1, 6)))
EDGE_PX, PIXEL_M = 96, 3.0
FEW = replace(FLIGHT, candidates=40, added=10, hypotheses=30, nulls=40)
"""Settings for a small map."""


@dataclass
class Flown:
    """Images of a flight, links between consecutive images, and the true views."""

    images: list
    links: list
    views: list

    def mirrored(self):
        flipped = [FlightImage(i.name, i.labels_hw[:, ::-1].copy(), prior=i.prior) for i in self.images]
        return Flown(flipped, [link.mirrored() for link in self.links], self.views)


def link_between(number, first, second, drift=0.01, rng=None):
    """Return the relative motion: the truth with an error that is a share of the distance."""
    turns = [turn_of(view.heading_deg, view.pixel_size) for view in (first, second)]
    step, ratio = (complex(*second.position) - complex(*first.position)) / turns[0], turns[1] / turns[0]
    off = drift * abs(step)
    if rng is not None:
        step += complex(*rng.normal(0, off, 2))
    known = as_rows(np.diag([off**2 + 0.1, off**2 + 0.1, 0.005**2, 0.003**2]))
    return Link(number, number + 1, (step.real, -step.imag), -np.angle(ratio), float(np.log(abs(ratio))), known)


def fly(labels, seed=3, count=7, spoiled=0.3, start=(500_420.0, 5_199_300.0), step=80.0):
    """Return a flight of turned images; a share of each image has random classes in patches."""
    rng = np.random.default_rng(seed)
    views, course, (x, y) = [], 60.0, start
    for _ in range(count):
        views.append(View(x, y, (course + 15.0) % 360, PIXEL_M, EDGE_PX, EDGE_PX))
        course += rng.normal(0, 8.0)
        x, y = x + step * np.sin(np.radians(course)), y + step * np.cos(np.radians(course))
    images = []
    for number, view in enumerate(views):
        seen = cut(labels, FRAME, view)
        wrong = np.kron(rng.random((12, 12)) < spoiled, np.ones((8, 8), bool))
        classes = np.kron(rng.integers(1, 6, (12, 12)), np.ones((8, 8), int)).astype(np.uint8)
        prior = Prior(pixel_size_range=(PIXEL_M / 1.1, PIXEL_M * 1.1))
        images.append(FlightImage(f"{number}.png", np.where(wrong, classes, seen), prior=prior, time_s=float(number)))
    links = [link_between(n, *pair, rng=rng) for n, pair in enumerate(zip(views, views[1:]))]
    return Flown(images, links, views)


def errors_m(poses, views):
    """Return (n,) errors in meters; NaN without a position."""
    return np.array(
        [np.hypot(*np.subtract(p.place.position, v.position)) if p.is_fix else np.nan for p, v in zip(poses, views)]
    )


def own_fix(view, off=0.0, risk=1e-6):
    """Return a fix of an image by itself, off to the east of the truth."""
    place = Place((view.x + off, view.y), view.heading_deg, view.pixel_size, 30.0, 12)
    known = PoseCovariance(((4.0, 0.0), (0.0, 4.0)), 0.5, 0.02, radius_95=4.9)
    return Localization(
        Status.FIX, Method.CONSTELLATION, 12, best=place, confidence=1 - risk, risk=risk, covariance=known
    )


def with_own(flown, **values):
    return [replace(image, own=own_fix(view, **values)) for image, view in zip(flown.images, flown.views)]
