"""semref:assessroute: expected success along a planned route, its gaps, and better parallel lines."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsRectangle,
    QgsWkbTypes,
)

from ...core.errors import ParameterError
from ...core.values import schema
from ..base import parameters
from ..base.algorithm import LOCALIZATION, Declared, cancelable, check_canceled
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import DOUBLE, INTEGER, POINT, POINT_GEOMETRY, POLYGON_GEOMETRY, SOURCE_LINE, SOURCE_POINT, SOURCE_POLYGON
from ..jobs import route_flights
from ..jobs.assessing import AssessAlgorithm, setting_rows
from ..messages.numbers import shown
from ..messages.sentences import worded
from ..translation import tr

if TYPE_CHECKING:
    import numpy as np

    from ...core.assessment.assessment import Assessment, Estimates
    from ...core.assessment.route import RouteGap, RoutePoints, ShiftHint
    from ...core.database.model import ReferenceDatabase
    from ..reports.route_report import AssessedRoute

FIELDS = (
    *schema(
        "route integer, along real, heading real, success real, success_low real, success_high real, error real, "
        "objects real, classes integer, look_alikes real, wrong real, trials integer, gap real, gap_seconds real, "
        "shift real, shift_success real, reason text, stretch text"
    ),
    *route_flights.FIELDS,
)


class RouteParameter(QgsProcessingParameterFeatureSource):
    """Lines of a layer, or the path of a waypoint file, which QGIS does not accept as a layer."""

    def checkValueIsAcceptable(self, value, context=None):
        # Imported here because it loads numpy, and QGIS starts without it.
        from ...storage.route_files import is_waypoint_file

        return is_waypoint_file(_plain(value)) or super().checkValueIsAcceptable(value, context)


class AssessRoute(AssessAlgorithm):
    ID = "assessroute"
    TITLE = "Assess route"
    GROUP = LOCALIZATION
    TAGS = (
        *("flight plan", "mission", "waypoints", "gpx", "kml", "qgroundcontrol", "planning", "gap", "profile"),
        *("print", "paper", "report"),
    )
    SUMMARY = (
        "Estimates the success and error of localization at points along a planned route, its longest gap, and "
        "parallel lines with more success.\n\nThe route is a line layer or a file: GPX, KML, QGroundControl plan "
        "(.plan, also surveys) or waypoint list (.waypoints). Images are simulated as in “Assess reference database”."
    )

    ROUTE = "ROUTE"
    SPACING = "SPACING"
    FOOTPRINT = "FOOTPRINT"
    SPEED = "SPEED"
    TRIALS = "TRIALS"
    SHIFT = "SHIFT"
    ASSESSMENT = "ASSESSMENT"
    BASE_MAP = "BASE_MAP"
    LONGEST_GAP = "LONGEST_GAP"
    LONGEST_GAP_SECONDS = "LONGEST_GAP_SECONDS"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            parameters.database(),
            with_help(
                RouteParameter(self.ROUTE, "Route", types=[SOURCE_LINE]),
                "Line layer, or path of a GPX, KML, .plan or .waypoints file. Each line is a separate route.",
            ),
            with_help(
                QgsProcessingParameterNumber(self.SPACING, "Spacing (m)", DOUBLE, optional=True, minValue=0.0),
                "Distance between the points. If not set, a quarter of the footprint width.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.FOOTPRINT, "Footprint width (m)", DOUBLE, optional=True, minValue=0.0
                ),
                "Edge length of the ground that an image shows. If not set, the window size of the database.",
            ),
            with_help(
                QgsProcessingParameterNumber(self.SPEED, "Speed (m/s)", DOUBLE, optional=True, minValue=0.0),
                "Ground speed, for example 20. It is used to give the length of gaps in seconds.",
            ),
            with_help(
                QgsProcessingParameterNumber(self.SHIFT, "Maximum shift (m)", DOUBLE, optional=True, minValue=0.0),
                "Maximum distance by which gaps may be moved to the left or right. Half of it is tested, too. If not "
                "set, the footprint width. 0 disables it.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.TRIALS, "Simulated images per point", INTEGER, 10, minValue=1, maxValue=1000
                ),
                "Number of simulated images at each point, for example 10. More images give narrower intervals. "
                "Nearby points share their results.",
                advanced=True,
            ),
            *self.noise_parameters(),
            with_help(
                QgsProcessingParameterFeatureSink(self.OUTPUT, "Points along the route", type=SOURCE_POINT),
                "Expected success at each point. The field “gap” is the length of the gap that contains the point.",
            ),
            parameters.report("Page with a map of the route, a profile of the expected success, and the gaps."),
            with_help(
                QgsProcessingParameterFeatureSource(
                    self.ASSESSMENT, "Expected success", types=[SOURCE_POLYGON], optional=True
                ),
                "Squares of “Assess reference database”. They are drawn below the route in the report.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterRasterLayer(self.BASE_MAP, "Base map", optional=True),
                "Orthophoto, map tiles or overview of the database. It is drawn below everything else in the report.",
                advanced=True,
            ),
            *route_flights.parameters(),
            QgsProcessingOutputNumber(self.LONGEST_GAP, "Longest gap"),
            QgsProcessingOutputNumber(self.LONGEST_GAP_SECONDS, "Longest gap in seconds"),
            *route_flights.outputs(),
        )

    def read_layers(self, values: Values) -> None:
        from ...storage.route_files import is_waypoint_file
        from ..layers.rendering import styled_copy
        from ..layers.routes import read_route, route_of_source

        squares = values.vector(self.ASSESSMENT) if values.has(self.ASSESSMENT) else None
        ground = values.raster(self.BASE_MAP) if values.has(self.BASE_MAP) else None
        self._below = [styled_copy(layer) for layer in (squares, ground) if layer is not None]
        value = _plain(values.raw(self.ROUTE))
        if is_waypoint_file(value):
            self._route = read_route(value)
            return
        source = None
        with suppress(ParameterError):
            source = values.source(self.ROUTE)
        if source is None or QgsWkbTypes.geometryType(source.wkbType()) in (POINT_GEOMETRY, POLYGON_GEOMETRY):
            raise ParameterError(
                "The route {value} is not a line layer and not a GPX, KML, .plan or .waypoints file. Select one of "
                "these.",
                value=value if source is None else source.sourceName(),
            )
        self._route = route_of_source(source)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, float]:
        from ...core.assessment.route import gaps, route_points
        from ..layers.routes import lines_in
        from ..reports.route_report import AssessedRoute

        database, crs = self.read_all(values, feedback)
        footprint = values.optional_number(self.FOOTPRINT, database.parameters.window_size)
        spacing = values.optional_number(self.SPACING, footprint / 4)
        lines = lines_in(self._route, crs, values.transform_context)
        points = route_points(lines, spacing)
        inside = _inside(database.parameters.extent, points.places)
        if not inside.any():
            raise ParameterError("The route is outside the map of the database. Select another route or database.")
        below = self._picture_below(values, points, crs, feedback) if values.has(self.REPORT) else b""
        assessment = self.assessment(values, database, self.localizer(database, feedback), footprint, feedback)
        count = values.integer(self.TRIALS)
        part = route_flights.FLOWN_PERCENT / 100 if values.integer(route_flights.FLIGHTS) else 1.0
        estimates = self._estimate(
            assessment, points.places, min(spacing, footprint / 10), count, feedback, (5, 65 * part)
        )
        # Outside the map nothing can match.
        for name in ("success", "low", "high"):
            getattr(estimates, name)[~inside] = 0.0
        threshold = self.threshold(values)
        stretches = gaps(points, estimates.success, threshold)
        largest = values.optional_number(self.SHIFT, footprint)
        hints = self._hints(assessment, points, estimates, stretches, largest, count, feedback, part)
        speed = values.optional_number(self.SPEED) or None
        route = AssessedRoute(points, estimates, inside, stretches, hints, footprint, spacing, threshold, speed)
        flown = route_flights.simulate(
            values, database, assessment.localizer, lines, self.conditions(values), footprint, feedback
        )
        route = replace(route, flown=flown)
        check_canceled(feedback)
        if values.has(self.REPORT):
            outputs.text(self.REPORT, self._report(values, database, route, assessment, below))
        self._write_points(outputs, route, crs)
        longest = max((gap.length for gap in stretches), default=0.0)
        self._log(route, longest, feedback)
        seconds = {self.LONGEST_GAP_SECONDS: longest / speed} if speed else {}
        return {self.LONGEST_GAP: longest, **seconds, **route_flights.numbers(route)}

    def _estimate(
        self,
        assessment: Assessment,
        places: np.ndarray,
        reach: float,
        count: int,
        feedback: QgsProcessingFeedback,
        share: tuple[float, float],
    ) -> Estimates:
        """Return the estimates at places (P, 2), from ``count`` images each within ``reach``."""
        queries = assessment.plan(places, reach, count * len(places))
        ((trials, correlated),) = self.simulate([assessment], [queries], feedback, *share)
        return cancelable(assessment.estimate, places, trials, correlated, feedback=feedback)

    def _hints(
        self,
        assessment: Assessment,
        points: RoutePoints,
        estimates: Estimates,
        stretches: Sequence[RouteGap],
        largest: float,
        count: int,
        feedback: QgsProcessingFeedback,
        part: float,
    ) -> list[ShiftHint | None]:
        """Return a hint, or None, for each gap. All shifts of all gaps are simulated together."""
        import numpy as np

        from ...core.assessment.route import SHIFTS, best_shift

        if not stretches or not largest > 0:
            return [None] * len(stretches)
        offsets = [share * largest for share in SHIFTS]
        chosen = np.concatenate([gap.points for gap in stretches])
        places = np.concatenate([points.shifted(chosen, offset) for offset in offsets])
        feedback.pushInfo(tr("Searching better lines beside gaps: {count}.").format(count=len(stretches)))
        found = self._estimate(
            assessment, places, 0.0, max(count // 2, 1), feedback, (65 * part, 95 * part)
        ).success.reshape(len(offsets), -1)
        ends = np.cumsum([len(gap.points) for gap in stretches])
        return [
            best_shift(estimates.success[gap.points], offsets, list(found[:, end - len(gap.points) : end]))
            for gap, end in zip(stretches, ends)
        ]

    def _picture_below(
        self, values: Values, points: RoutePoints, crs: QgsCoordinateReferenceSystem, feedback: QgsProcessingFeedback
    ) -> bytes:
        from ..layers.rendering import map_picture
        from ..reports.maps import PICTURE_PX, route_ground

        if not self._below:
            return b""
        x_min, y_min, x_max, y_max = route_ground(points).extent
        extent = QgsRectangle(x_min, y_min, x_max, y_max)
        picture = map_picture(self._below, extent, crs, PICTURE_PX, values.transform_context, feedback.isCanceled)
        check_canceled(feedback)
        return picture

    def _report(
        self, values: Values, database: ReferenceDatabase, route: AssessedRoute, assessment: Assessment, below: bytes
    ) -> str:
        from ..reports.route_report import route_html

        conditions = self.conditions(values)
        settings = [
            (tr("Footprint width (m)"), shown(route.footprint, "g")),
            (tr("Spacing (m)"), shown(route.spacing, "g")),
            (tr("Simulated images per point"), str(values.integer(self.TRIALS))),
            *setting_rows(conditions, route.threshold, assessment.correlation, values.integer(self.SEED)),
        ]
        title = f"{self._route.name}, {os.path.basename(database.source)}"
        return route_html(route, title, conditions, assessment.correlation, settings, below)

    def _write_points(self, outputs: Outputs, route: AssessedRoute, crs: QgsCoordinateReferenceSystem) -> None:
        import numpy as np

        from ...core.assessment.route import stretch
        from ..layers.class_styles import route_renderer

        nearest = np.zeros(0) if route.flown is None else route.flown.at(route.points)
        gap_of = {int(n): (gap, hint) for gap, hint in zip(route.stretches, route.hints) for n in gap.points}
        renderer = route_renderer(route.threshold)
        with outputs.layer(self.OUTPUT, FIELDS, POINT, crs, "route", renderer=renderer) as sink:
            for n, (x, y) in enumerate(route.points.places.tolist()):
                attributes = _values(route, n, *gap_of.get(n, (None, None)))
                line = QgsGeometry.fromPolylineXY([QgsPointXY(*place) for place in stretch(route.points, n).tolist()])
                # Rounded to 1 cm.
                attributes["stretch"] = line.asWkt(2)
                attributes.update({} if route.flown is None else route_flights.columns(route.flown, int(nearest[n])))
                sink.add(QgsGeometry.fromPointXY(QgsPointXY(x, y)), attributes)

    def _log(self, route: AssessedRoute, longest: float, feedback: QgsProcessingFeedback) -> None:
        feedback.pushInfo(
            tr("{count} points. {share:.0%} of them have an expected success of {threshold:.0%} or more.").format(
                count=len(route.points),
                share=float((route.estimates.success >= route.threshold).mean()),
                threshold=route.threshold,
            )
        )
        if longest:
            feedback.pushInfo(tr("Longest gap without an expected position: {length:.0f} m.").format(length=longest))


def _plain(value: Any) -> Any:
    """Return the value without the wrapper that a dialog adds for “selected features only”."""
    return value.source.staticValue() if isinstance(value, QgsProcessingFeatureSourceDefinition) else value


def _inside(extent: Sequence[float], places: np.ndarray) -> np.ndarray:
    x_min, y_min, x_max, y_max = extent
    x, y = places.T
    return (x >= x_min) & (x <= x_max) & (y >= y_min) & (y <= y_max)


def _values(route: AssessedRoute, n: int, gap: RouteGap | None, hint: ShiftHint | None) -> dict[str, Any]:
    from ...core.assessment.squares import expectation

    expected = expectation(route.estimates, n, route.threshold, worded)
    if not route.inside[n]:
        outside = tr("This point is outside the map of the database.")
        expected.update(error=None, reason="" if expected["success"] >= route.threshold else outside)
    return {
        **expected,
        "route": int(route.points.lines[n]) + 1,
        "along": float(route.points.along[n]),
        "heading": float(route.points.headings_deg[n]),
        "gap": gap.length if gap else 0.0,
        "gap_seconds": (gap.length if gap else 0.0) / route.speed if route.speed else None,
        "shift": hint.offset if hint else None,
        "shift_success": hint.success if hint else None,
    }
