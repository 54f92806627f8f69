"""What *Assess route* predicts of flights, against flights along the same routes that it knows nothing of.

.venv/bin/python tools/bench route_prediction [--count 10] [--write]

Predicted are flights as the algorithm flies them: simulated from the database's overview, level, tops forward. Flown
are images of the label map at its full resolution, other pixel sizes, headings off the course, other draws of errors.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from bench import inputs, kept, page
from bench.correlation import BUILDINGS
from bench.flights import PACKAGES, POOR, SEED, USUAL
from bench.flown import Kind, fly, route
from bench.ground import Ground
from semref.core.assessment.flights import FlightPlan, FlownRoutes
from semref.core.assessment.route import route_points
from semref.core.flight.tracker import FlightTracker
from semref.core.simulation.conditions import Conditions

PAGE = "benchmarks.md"
COUNT, QUICK_COUNT = 10, 1
IMAGES = 15
PREDICTED, FLOWN = 4, 4
"""Flights along each route, of either kind."""

HALF = 0.5
"""Share of the flights that have had a position: where the first one is said to come."""

KINDS = {
    "640 m, every 200 m": replace(USUAL, count=IMAGES),
    "320 m, every 100 m": replace(USUAL, ground_m=320.0, step_m=100.0, count=IMAGES),
}

Seen = list[list[Any]]
"""Of each flight, of each image: the 95 % radius and the error in meters; None without a position."""


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"route prediction": "Not measured: the real data is not here."}
    ground, rows, shares = Ground.of(run), [], []
    ground.spoiled_values = BUILDINGS
    for seed, (name, kind) in enumerate(KINDS.items()):
        if not run.wants(name):
            continue

        def now(part: int, _: int, kind: Kind = kind, seed: int = seed) -> dict[str, Seen]:
            return _both(ground, kind, [SEED, 7, seed, part])

        for number in range(run.how_many(COUNT, QUICK_COUNT)):
            both = kept.part(run, "route_prediction", name, number, 1, now, (*PACKAGES, "assessment"))
            rows.append((name, number + 1, *_cells(both)))
            shares.append([placed_share(both[way]) for way in ("predicted", "flown")])
            print("  " + " | ".join(map(str, rows[-1])), file=sys.stderr, flush=True)
    text = [_ABOUT.format(predicted=PREDICTED, flown=FLOWN, images=IMAGES), page.table(COLUMNS, rows)]
    return {"route prediction": "\n\n".join([*text, _said(np.array(shares))])}


def _both(ground: Ground, kind: Kind, seed: Sequence[int]) -> dict[str, Seen]:
    """A route, predicted and flown."""
    views, seen = route(ground, kind, np.random.default_rng(seed))
    line = np.array([view.position for view in views])
    plan = FlightPlan(PREDICTED, kind.ground_m, kind.drift, seed=1)
    routes = FlownRoutes(ground.database, ground.localizer, Conditions(noise=POOR), plan)
    for _ in routes.steps(route_points([line], kind.step_m)):
        pass
    found = routes.result
    predicted = [
        [[float(radius), float(error)] if known else None for known, radius, error in zip(*flight)]
        for flight in zip(found.is_placed, found.radii, found.errors)
    ]
    flown = []
    for number in range(FLOWN):
        one = fly(ground, kind, views, seen, np.random.default_rng([*seed, number]))
        tracker = FlightTracker(ground.localizer)
        links, poses = {link.second: link for link in one.links}, []
        for n, (image, view) in enumerate(zip(one.images, views)):
            pose = tracker.add(image, links.get(n))
            off = float(np.hypot(*np.subtract(pose.place.position, view.position))) if pose.is_fix else None
            poses.append([float(pose.error_95_m), off] if pose.is_fix else None)
        flown.append(poses)
    return {"predicted": predicted, "flown": flown}


COLUMNS = (
    "route",
    "number",
    "first position, image: predicted",
    "flown",
    "flights, first image each",
    "placed: predicted",
    "flown",
    "95 % radius, median: predicted",
    "flown",
    "largest error flown",
)


def first_image(flights: Seen) -> int | None:
    """From which image on half of the flights have had a position, counted from 1; None where they never have."""
    known = np.logical_or.accumulate([[image is not None for image in flight] for flight in flights], axis=1)
    usual = known.mean(axis=0) >= HALF
    return int(usual.argmax()) + 1 if usual.any() else None


def placed_share(flights: Seen) -> float:
    """Share of all images that have a position."""
    return float(np.mean([image is not None for flight in flights for image in flight]))


def _cells(both: dict[str, Seen]) -> list[str]:
    predicted, flown = both["predicted"], both["flown"]
    each = [first_image([flight]) for flight in flown]
    errors = [image[1] for flight in flown for image in flight if image]
    return [
        *(_number(first_image(flights)) for flights in (predicted, flown)),
        ", ".join(map(_number, each)),
        *(f"{100 * placed_share(flights):.0f} %" for flights in (predicted, flown)),
        *(_radius(flights) for flights in (predicted, flown)),
        f"{max(errors):.1f} m" if errors else "–",
    ]


def _number(image: int | None) -> str:
    return "never" if image is None else str(image)


def _radius(flights: Seen) -> str:
    radii = [image[0] for flight in flights for image in flight if image]
    return f"{np.median(radii):.1f} m" if radii else "–"


def _said(shares: np.ndarray) -> str:
    """How the predicted share of placed images compares with the flown one."""
    if not len(shares):
        return ""
    off = 100 * (shares[:, 0] - shares[:, 1])
    text = (
        "Share of images with a position, predicted less flown: {mean:+.0f} % in the mean of {count} routes, "
        "{spread:.0f} % (σ)."
    )
    return text.format(mean=off.mean(), count=len(off), spread=off.std())


_ABOUT = """\
Random routes over Liechtenstein's southern half, {images} images each. Predicted: {predicted} flights as *Assess route*
simulates them (FLIGHTS), from the database's overview, labels of a poor network and displaced ground assumed. Flown:
{flown} flights along the same route, cut from the label map at 1 m, pixels of 0.8–1.25 m, headings up to 10° off the
course, with other draws of labels' errors, displacement and motion. Everything is what is known in flight, from the
images until then alone. First position: from this image on half of the flights have had one."""
