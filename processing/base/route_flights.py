"""Flights along a planned route: the parameters of simulating them, and what is told of them."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessingOutputNumber, QgsProcessingParameterDefinition, QgsProcessingParameterNumber

from ..compat import DOUBLE, INTEGER
from ..translation import tr
from .algorithm import check_canceled, interruptible
from .parameters import SEED, with_help

if TYPE_CHECKING:
    import numpy as np
    from qgis.core import QgsProcessingFeedback

    from ...core.assessment.flights import FlownRoute
    from ...core.database.model import ReferenceDatabase
    from ...core.localizer.localizer import Localizer
    from ...core.simulation.conditions import Conditions
    from ..reports.route_report import AssessedRoute
    from .values import Values

FLIGHTS, IMAGE_DISTANCE, DRIFT = "FLIGHTS", "IMAGE_DISTANCE", "DRIFT"
FIRST_POSITION, LARGEST_RADIUS = "FIRST_POSITION", "LARGEST_RADIUS"
FIELDS = (("flight_placed", "real"), ("flight_radius", "real"), ("flight_lost", "real"))

FLOWN_PERCENT, DONE_PERCENT = 70, 97
"""Progress when single images are assessed, where flights are flown, too, and when those are done."""


def parameters() -> tuple[QgsProcessingParameterDefinition, ...]:
    """How flights are simulated, if any are."""
    return (
        with_help(
            QgsProcessingParameterNumber(
                FLIGHTS, tr("Simulated flights"), type=INTEGER, defaultValue=0, minValue=0, maxValue=100
            ),
            tr(
                "So many flights along every line, as “Localize flight” and watch --flight follow them: where the "
                "first position comes, how large the error gets, where the track is lost. Each image takes about a "
                "second until the first position. 0 for none."
            ),
            advanced=True,
        ),
        with_help(
            QgsProcessingParameterNumber(
                IMAGE_DISTANCE, tr("Distance between images (map units)"), type=DOUBLE, optional=True, minValue=0.0
            ),
            tr("Of a simulated flight; a third of the footprint if left out."),
            advanced=True,
        ),
        with_help(
            QgsProcessingParameterNumber(
                DRIFT, tr("Drift of motion (%)"), type=DOUBLE, defaultValue=1.0, minValue=0.0, maxValue=20.0
            ),
            tr(
                "What motion from image to image is off by, a share of the distance: of each step by itself, and of "
                "all of them by as much again."
            ),
            advanced=True,
        ),
    )


def outputs() -> tuple[QgsProcessingOutputNumber, ...]:
    """Numbers that are told."""
    return (
        QgsProcessingOutputNumber(FIRST_POSITION, tr("Distance to the first position of a flight")),
        QgsProcessingOutputNumber(LARGEST_RADIUS, tr("Largest 95 % radius of a flight’s positions")),
    )


def share_before(values: Values) -> float:
    """Share of the progress that is made before flights are flown."""
    return FLOWN_PERCENT / 100 if values.integer(FLIGHTS) else 1.0


def simulate(
    values: Values,
    database: ReferenceDatabase,
    localizer: Localizer,
    lines: Sequence[np.ndarray],
    conditions: Conditions,
    footprint: float,
    feedback: QgsProcessingFeedback,
) -> FlownRoute | None:
    """What flights along lines came to; None where none are wanted."""
    from ...core.assessment.flights import FlightPlan, FlownRoutes
    from ...core.assessment.route import route_points

    count = values.integer(FLIGHTS)
    if not count:
        return None
    plan = FlightPlan(count, footprint, values.number(DRIFT) / 100, values.integer(SEED))
    points = route_points(lines, values.optional_number(IMAGE_DISTANCE) or footprint / 3)
    routes = FlownRoutes(database, localizer, conditions, plan)
    feedback.setProgressText(tr("Flying along the route"))
    for done, images in interruptible(routes.steps(points), feedback):
        check_canceled(feedback)
        feedback.setProgress(FLOWN_PERCENT + (DONE_PERCENT - FLOWN_PERCENT) * done / images)
    return routes.result


def numbers(route: AssessedRoute) -> dict[str, float]:
    """Numbers of the flights; none where they tell none."""
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
    """Columns of what flights came to at the image of that number."""
    radius = float(flown.radius[n])
    return {
        "flight_placed": float(flown.placed[n]),
        "flight_radius": radius if isfinite(radius) else None,
        "flight_lost": float(flown.lost[n]),
    }
