"""semref:assessroute – expected success along a planned route, its gaps, and where to shift them."""

from __future__ import annotations

import os

import numpy as np
from qgis.core import (
    QgsGeometry,
    QgsPointXY,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
)

from ...core.errors import ParameterError, SemRefError
from ...storage.route_files import is_waypoint_file
from ..compat import POINT, SOURCE_LINE, SOURCE_POINT
from ..framework.assessing import AssessAlgorithm, reason_text, setting_rows
from ..framework.base import LOCALIZATION, cancelable, check_canceled
from ..framework.sinks import Sink
from ..translation import tr

FIELDS = (
    ("route", "integer"),
    ("along", "real"),
    ("heading", "real"),
    ("success", "real"),
    ("success_low", "real"),
    ("success_high", "real"),
    ("error", "real"),
    ("objects", "real"),
    ("classes", "integer"),
    ("look_alikes", "real"),
    ("wrong", "real"),
    ("trials", "integer"),
    ("gap", "real"),
    ("gap_seconds", "real"),
    ("shift", "real"),
    ("shift_success", "real"),
    ("reason", "text"),
)

OUTSIDE = "Outside the database’s map."


class RouteParameter(QgsProcessingParameterFeatureSource):
    """Lines of a layer, or the path of a waypoint file, which QGIS itself would not take for a layer."""

    def checkValueIsAcceptable(self, value, context=None):
        return is_waypoint_file(_plain(value)) or super().checkValueIsAcceptable(value, context)


class AssessRoute(AssessAlgorithm):
    ID = "assessroute"
    BY_VALUES = False
    GROUP = LOCALIZATION
    TAGS = ("flight plan", "mission", "waypoints", "gpx", "kml", "qgroundcontrol", "planning", "gap", "profile")

    ROUTE = "ROUTE"
    SPACING = "SPACING"
    FOOTPRINT = "FOOTPRINT"
    SPEED = "SPEED"
    TRIALS = "TRIALS"
    SHIFT = "SHIFT"
    OUTPUT = "OUTPUT"
    REPORT = "REPORT"
    LONGEST_GAP = "LONGEST_GAP"
    LONGEST_GAP_SECONDS = "LONGEST_GAP_SECONDS"

    def title(self):
        return tr("Assess route")

    def summary(self):
        return tr(
            "Shows what to expect along a planned route: success, error and number of landmarks at every point, the "
            "longest stretch without an expected fix, and which stretches do better when they are shifted to a side."
            "\n\n"
            "The route is a line layer, or the path of a file that planners have: GPX (routes, else tracks, else "
            "waypoints), KML, a plan of QGroundControl (.plan, surveys included) or a waypoint list (.waypoints). "
            "Longitude and latitude are transformed to the database’s CRS. Images are simulated as “Assess reference "
            "database” does, under the noise that you state."
        )

    def initAlgorithm(self, config=None):
        number = QgsProcessingParameterNumber
        self.offer_database()
        self.offer(
            RouteParameter(self.ROUTE, tr("Route"), [SOURCE_LINE]),
            tr("A line layer, or the path of a GPX, KML, .plan or .waypoints file. Every line is a route of its own."),
        )
        self.offer(
            number(self.SPACING, tr("Spacing (map units)"), number.Double, None, optional=True, minValue=0.0),
            tr("Distance between the points; a quarter of the footprint if left out."),
        )
        self.offer(
            number(self.FOOTPRINT, tr("Footprint (map units)"), number.Double, None, optional=True, minValue=0.0),
            tr("Edge of the ground that an image shows; the window size if left out."),
        )
        self.offer(
            number(self.SPEED, tr("Speed (m/s)"), number.Double, None, optional=True, minValue=0.0),
            tr("Over ground; gaps are then told in seconds, too."),
        )
        self.offer(
            number(self.SHIFT, tr("Largest shift (map units)"), number.Double, None, optional=True, minValue=0.0),
            tr(
                "How far stretches without an expected fix may be shifted to either side; half of it is tried, too. "
                "The footprint if left out, 0 for none."
            ),
        )
        self.offer(
            number(self.TRIALS, tr("Simulated images a point"), number.Integer, 10, minValue=1, maxValue=1000),
            tr("More make the intervals narrower; points near each other learn from each other."),
        )
        self.offer_noise()
        self.offer(
            QgsProcessingParameterFeatureSink(self.OUTPUT, tr("Points along the route"), SOURCE_POINT),
            tr("What to expect at each point; “gap” is the length of the stretch without an expected fix it lies in."),
        )
        self.offer(
            QgsProcessingParameterFileDestination(self.REPORT, tr("Report"), tr("HTML files (*.html)"), optional=True),
            tr("Profile of expected success along the route, and its gaps, in one file to read and print."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.LONGEST_GAP, tr("Longest gap")))
        self.addOutput(QgsProcessingOutputNumber(self.LONGEST_GAP_SECONDS, tr("Longest gap in seconds")))

    def checkParameterValues(self, parameters, context):
        possible, reason = super().checkParameterValues(parameters, context)
        if not possible:
            return False, reason
        try:
            self.noise(parameters, context)
        except SemRefError as error:
            return False, str(error)
        return True, ""

    def read_layers(self, parameters, context, feedback):
        from ..exchange.routes import read_route, route_of_source

        value = _plain(parameters.get(self.ROUTE))
        if is_waypoint_file(value):
            self._route = read_route(value)
            return
        source = self.parameterAsSource(parameters, self.ROUTE, context)
        if source is None:
            raise ParameterError(
                f"ROUTE is {value}, which is neither a line layer nor a GPX, KML, .plan or .waypoints file."
            )
        self._route = route_of_source(source)

    def work(self, parameters, context, feedback):
        from ...core.assessment.route import gaps, route_points
        from ...core.localizer.localizer import Localizer
        from ..exchange.routes import lines_in
        from ..reports.route_report import AssessedRoute

        database, crs = self.read_all(parameters, context, feedback)
        footprint = self._number(parameters, context, self.FOOTPRINT, database.parameters.window_size)
        spacing = self._number(parameters, context, self.SPACING, footprint / 4)
        points = route_points(lines_in(self._route, crs, context.transformContext()), spacing)
        inside = _inside(database.parameters.extent, points.places)
        if not inside.any():
            raise ParameterError("ROUTE lies outside the database’s map; choose another route or database.")
        localizer = Localizer(database)
        self.index(localizer, feedback)
        assessment = self.assessment(parameters, context, database, localizer, footprint, feedback)
        count = self.parameterAsInt(parameters, self.TRIALS, context)
        reach = min(spacing, footprint / 10)
        estimates = self._estimated(assessment, points.places, reach, count, feedback, (5, 65))
        # Off the map there is nothing to agree with.
        for name in ("success", "low", "high"):
            getattr(estimates, name)[~inside] = 0.0
        threshold = self.threshold(parameters, context)
        stretches = gaps(points, estimates.success, threshold)
        largest = self._number(parameters, context, self.SHIFT, footprint)
        hints = self._hints(assessment, points, estimates, stretches, largest, count, feedback)
        speed = self._number(parameters, context, self.SPEED, 0.0) or None
        route = AssessedRoute(points, estimates, inside, stretches, hints, footprint, spacing, threshold, speed)
        check_canceled(feedback)
        report = self._write_report(parameters, context, database, route, assessment, feedback)
        destination = self._write_points(parameters, context, route, crs)
        longest = max((gap.length for gap in stretches), default=0.0)
        self._say(route, longest, feedback)
        results = {self.OUTPUT: destination, **report, self.LONGEST_GAP: longest}
        return {**results, self.LONGEST_GAP_SECONDS: longest / speed} if speed else results

    def _number(self, parameters, context, key, default: float) -> float:
        if parameters.get(key) in (None, ""):
            return default
        return self.parameterAsDouble(parameters, key, context)

    def _estimated(self, assessment, places, reach, count, feedback, share):
        queries = assessment.plan(places, reach, count * len(places))
        trials, correlated = self.simulate(assessment, queries, feedback, *share)
        return cancelable(assessment.estimate, places, trials, correlated, feedback=feedback)

    def _hints(self, assessment, points, estimates, stretches, largest, count, feedback):
        """A hint, or None, for each stretch: all shifts of all stretches are simulated together."""
        from ...core.assessment.route import SHIFTS, best_shift

        if not stretches or not largest > 0:
            return [None] * len(stretches)
        offsets = [share * largest for share in SHIFTS]
        chosen = np.concatenate([gap.points for gap in stretches])
        places = np.concatenate([points.shifted(chosen, offset) for offset in offsets])
        feedback.pushInfo(tr("Looking for better lines beside {count} gaps.").format(count=len(stretches)))
        found = self._estimated(assessment, places, 0.0, max(count // 2, 1), feedback, (65, 95)).success.reshape(
            len(offsets), -1
        )
        ends = np.cumsum([len(gap.points) for gap in stretches])
        return [
            best_shift(estimates.success[gap.points], offsets, list(found[:, end - len(gap.points) : end]))
            for gap, end in zip(stretches, ends)
        ]

    def _write_points(self, parameters, context, route, crs):
        from ..exchange.assessment_styles import point_renderer
        from ..exchange.output_style import style_output

        sink = Sink(self, parameters, self.OUTPUT, context, FIELDS, POINT, crs)
        gap_of = {int(n): (gap, hint) for gap, hint in zip(route.stretches, route.hints) for n in gap.points}
        for n, (x, y) in enumerate(route.points.places.tolist()):
            sink.add(QgsGeometry.fromPointXY(QgsPointXY(x, y)), _values(route, n, *gap_of.get(n, (None, None))))
        destination = sink.close()
        style_output(destination, point_renderer(route.threshold), context)
        return destination

    def _write_report(self, parameters, context, database, route, assessment, feedback):
        from ...storage.files import written_beside
        from ..reports.route_report import route_html

        path = self.parameterAsFileOutput(parameters, self.REPORT, context)
        if not path:
            return {}
        noise, seed = self.noise(parameters, context), self.parameterAsInt(parameters, self.SEED, context)
        settings = [
            (tr("Footprint (map units)"), f"{route.footprint:g}"),
            (tr("Spacing (map units)"), f"{route.spacing:g}"),
            (tr("Simulated images a point"), str(self.parameterAsInt(parameters, self.TRIALS, context))),
            *setting_rows(noise, route.threshold, assessment.correlation, seed),
        ]
        name = os.path.basename(database.source)
        html = route_html(route, name, noise, assessment.correlation, settings)
        with written_beside(path) as temporary, open(temporary, "w", encoding="utf-8") as file:
            file.write(html)
        return {self.REPORT: path}

    def _say(self, route, longest, feedback):
        feedback.pushInfo(
            tr("{count} points; {share:.0%} of them with an expected success of {threshold:.0%} or more.").format(
                count=len(route.points),
                share=float((route.estimates.success >= route.threshold).mean()),
                threshold=route.threshold,
            )
        )
        if longest:
            feedback.pushInfo(tr("Longest stretch without an expected fix: {length:.0f} m.").format(length=longest))
        for gap, hint in zip(route.stretches, route.hints):
            if hint is not None:
                feedback.pushInfo(hint_text(gap, hint))


def _plain(value):
    """What a dialog's “selected features only” is wrapped around."""
    return value.source.staticValue() if isinstance(value, QgsProcessingFeatureSourceDefinition) else value


def hint_text(gap, hint) -> str:
    """Where a stretch does better, in a sentence."""
    text = (
        tr(
            "From {start:.0f} to {end:.0f} m: {shift:.0f} m to the left success would be {after:.0%} instead of "
            "{before:.0%}."
        )
        if hint.offset < 0
        else tr(
            "From {start:.0f} to {end:.0f} m: {shift:.0f} m to the right success would be {after:.0%} instead of "
            "{before:.0%}."
        )
    )
    return text.format(start=gap.start, end=gap.end, shift=abs(hint.offset), after=hint.success, before=hint.before)


def _inside(extent, places: np.ndarray) -> np.ndarray:
    x_min, y_min, x_max, y_max = extent
    x, y = places.T
    return (x >= x_min) & (x <= x_max) & (y >= y_min) & (y <= y_max)


def _values(route, n: int, gap, hint) -> dict:
    points, estimates = route.points, route.estimates
    success, error = float(estimates.success[n]), float(estimates.error[n])
    reason = reason_text(estimates.reasons[n], float(estimates.landmarks[n])) if route.inside[n] else OUTSIDE
    return {
        "route": int(points.lines[n]) + 1,
        "along": float(points.along[n]),
        "heading": float(points.headings_deg[n]),
        "success": success,
        "success_low": float(estimates.low[n]),
        "success_high": float(estimates.high[n]),
        "error": error if np.isfinite(error) and route.inside[n] else None,
        "objects": float(estimates.landmarks[n]),
        "classes": int(estimates.classes[n]),
        "look_alikes": float(estimates.look_alikes[n]),
        "wrong": float(estimates.wrong[n]),
        "trials": int(estimates.trials[n]),
        "gap": gap.length if gap else 0.0,
        "gap_seconds": (gap.length if gap else 0.0) / route.speed if route.speed else None,
        "shift": hint.offset if hint else None,
        "shift_success": hint.success if hint else None,
        "reason": "" if success >= route.threshold else reason,
    }
