"""Simulated flights along a planned route: parameters and results."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterNumber,
)

from ...core.values import schema
from ..base.algorithm import follow, interruptible
from ..base.parameters import SEED, with_help
from ..base.values import Values
from ..compat import DOUBLE, INTEGER

if TYPE_CHECKING:
    import numpy as np

    from ...core.assessment.flights import FlownRoute
    from ...core.database.model import ReferenceDatabase
    from ...core.localizer.localizer import Localizer
    from ...core.simulation.conditions import Conditions
    from ..reports.route_report import AssessedRoute

FLIGHTS, IMAGE_DISTANCE, DRIFT = "FLIGHTS", "IMAGE_DISTANCE", "DRIFT"
FIRST_POSITION, LARGEST_RADIUS = "FIRST_POSITION", "LARGEST_RADIUS"
FIELDS = schema("flight_placed real, flight_radius real, flight_lost real")

FLOWN_PERCENT, DONE_PERCENT = 70, 97
"""Progress in percent after single images are assessed, if flights follow, and after the flights."""


def parameters() -> tuple[QgsProcessingParameterDefinition, ...]:
    return (
        with_help(
            QgsProcessingParameterNumber(FLIGHTS, "Simulated flights", INTEGER, 0, minValue=0, maxValue=100),
            "Number of simulated flights along each line, for example 5. They are localized as in “Localize "
            "flight”. The report shows where the first position is found, the largest error, and where the track "
            "is lost. Each image takes about 1 s until the first position. 0 means no flights.",
            advanced=True,
        ),
        with_help(
            QgsProcessingParameterNumber(
                IMAGE_DISTANCE, "Distance between images (m)", DOUBLE, optional=True, minValue=0.0
            ),
            "Distance between the images of a simulated flight. If not set, a third of the footprint width.",
            advanced=True,
        ),
        with_help(
            QgsProcessingParameterNumber(DRIFT, "Motion drift (%)", DOUBLE, 1.0, minValue=0.0, maxValue=20.0),
            "Error of the motion between images, in percent of the distance: a random error of each step, and a "
            "constant error of the same size.",
            advanced=True,
        ),
    )


def outputs() -> tuple[QgsProcessingOutputNumber, ...]:
    return (
        QgsProcessingOutputNumber(FIRST_POSITION, "Distance to the first position of a flight"),
        QgsProcessingOutputNumber(LARGEST_RADIUS, "Largest 95 % radius of a flight"),
    )


def simulate(
    values: Values,
    database: ReferenceDatabase,
    localizer: Localizer,
    lines: Sequence[np.ndarray],
    conditions: Conditions,
    footprint: float,
    feedback: QgsProcessingFeedback,
) -> FlownRoute | None:
    """Simulate flights along lines; None if the number of flights is 0."""
    from ...core.assessment.flights import FlownRoutes
    from ...core.assessment.route import route_points

    count = values.integer(FLIGHTS)
    if not count:
        return None
    points = route_points(lines, values.optional_number(IMAGE_DISTANCE) or footprint / 3)
    drift = values.number(DRIFT) / 100
    routes = FlownRoutes(database, localizer, conditions, footprint, drift, values.integer(SEED))
    return follow(interruptible(routes.fly(points, count), feedback), feedback, FLOWN_PERCENT, DONE_PERCENT)


def numbers(route: AssessedRoute) -> dict[str, float]:
    """Return the result numbers of the flights, as far as there are any."""
    if route.flown is None:
        return {}
    found = {}
    first = [route.flown.first(line, route.threshold) for line in range(len(route.points.lengths))]
    known = [along for along in first if along is not None]
    if len(known) == len(first):
        found[FIRST_POSITION] = max(known)
    known = [radius for radius in route.flown.radius.tolist() if isfinite(radius)]
    if known:
        found[LARGEST_RADIUS] = max(known)
    return found


def columns(flown: FlownRoute, n: int) -> dict[str, Any]:
    """Return the values of the flight columns at the image of that number."""
    radius = float(flown.radius[n])
    return {
        "flight_placed": float(flown.placed[n]),
        "flight_radius": radius if isfinite(radius) else None,
        "flight_lost": float(flown.lost[n]),
    }
