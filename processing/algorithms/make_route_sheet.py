"""semref:routesheet – an assessed route as a PDF for the planner's folder."""

from __future__ import annotations

import re
from itertools import groupby
from typing import TYPE_CHECKING, Any, NamedTuple

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
    QgsProject,
)

from ...core.errors import ParameterError
from ..compat import SOURCE_POINT, SOURCE_POLYGON, is_null
from ..framework.base import LOCALIZATION, Declared, SemRefAlgorithm, check_canceled
from ..framework.parameters import with_help
from ..translation import tr
from ..wording.numbers import Local, shown

if TYPE_CHECKING:
    from collections.abc import Sequence

    from qgis.core import QgsMapLayer, QgsProcessingFeedback, QgsVectorLayer

    from ..framework.outputs import Outputs
    from ..framework.values import Values

NEEDED = ("route", "along", "success", "gap")
"""Columns of an assessed route."""


class MakeRouteSheet(SemRefAlgorithm):
    ID = "routesheet"
    GROUP = LOCALIZATION
    TAGS = ("pdf", "print", "layout", "flight plan", "mission", "report", "paper")
    PACKAGES = ()

    ROUTE, ASSESSMENT, BASE_MAP, TITLE, OUTPUT = "ROUTE", "ASSESSMENT", "BASE_MAP", "TITLE", "OUTPUT"

    def flags(self) -> Any:
        # QGIS's layouts live in the main thread.
        return super().flags() | QgsProcessingAlgorithm.FlagNoThreading

    def title(self) -> str:
        return tr("Make route sheet")

    def summary(self) -> str:
        return tr(
            "Puts an assessed route on paper: a PDF in A4 with the map, the route graded by expected success, key "
            "figures, and a table of the stretches without an expected fix.\n\n"
            "Layers are drawn as they are styled in the project."
        )

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterFeatureSource(self.ROUTE, tr("Points along the route"), types=[SOURCE_POINT]),
                tr("The points that “Assess route” wrote."),
            ),
            with_help(
                QgsProcessingParameterFeatureSource(
                    self.ASSESSMENT, tr("Expected success"), types=[SOURCE_POLYGON], optional=True
                ),
                tr("The squares that “Assess reference database” wrote, drawn below the route."),
            ),
            with_help(
                QgsProcessingParameterRasterLayer(self.BASE_MAP, tr("Base map"), optional=True),
                tr("An orthophoto, map tiles, or the overview of the database, drawn below everything."),
            ),
            with_help(
                QgsProcessingParameterString(self.TITLE, tr("Title"), optional=True),
                tr("Heading of the sheet; the route layer’s name if left out."),
            ),
            with_help(
                QgsProcessingParameterFileDestination(
                    self.OUTPUT, tr("Route sheet"), fileFilter=tr("PDF files (*.pdf)")
                ),
                tr("A PDF to print and to file."),
            ),
        )

    def read_layers(self, values: Values) -> None:
        self._route = _styled(values.vector(self.ROUTE))
        if self._route is None:
            raise ParameterError("algorithms.no_assessed_route", name=str(values.raw(self.ROUTE)), missing=NEEDED)
        missing = [name for name in NEEDED if self._route.fields().lookupField(name) < 0]
        if missing or not self._route.featureCount():
            raise ParameterError("algorithms.no_assessed_route", name=self._route.name(), missing=missing or NEEDED)
        squares = _styled(values.vector(self.ASSESSMENT)) if values.has(self.ASSESSMENT) else None
        ground = values.raster(self.BASE_MAP) if values.has(self.BASE_MAP) else None
        self._below: list[QgsMapLayer] = [layer for layer in (squares, ground) if layer is not None]

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> None:
        from ..exchange.route_sheet import RouteSheet

        points = sorted(
            ({field.name(): one[field.name()] for field in self._route.fields()} for one in self._route.getFeatures()),
            key=lambda point: (str(point["route"]), _number(point, "along")),
        )
        check_canceled(feedback)
        poor = stretches(points)
        subtitle = tr("{count} points, {date}").format(count=shown(len(points), ","), date=_today())
        sheet = RouteSheet(
            values.text(self.TITLE) or self._route.name(),
            subtitle,
            self._route,
            self._below,
            key_figures(points),
            [tr("Route"), tr("from (m)"), tr("to (m)"), tr("length (m)"), tr("reason"), tr("hint")],
            [stretch_row(stretch) for stretch in poor],
            tr("Stretches without an expected fix"),
        )
        with outputs.file(self.OUTPUT) as path:
            sheet.write(path)


class Stretch(NamedTuple):
    """Neighboring points without an expected fix, and where along their route the good ones beside them lie."""

    points: list[dict[str, Any]]
    start: float
    end: float


def stretches(points: Sequence[dict[str, Any]]) -> list[Stretch]:
    """Runs of neighboring points that lie in one stretch without an expected fix, the longest first."""
    found: list[Stretch] = []
    for _, run in groupby(range(len(points)), key=lambda n: (points[n]["route"], _number(points[n], "gap"))):
        numbers = list(run)
        first, last = numbers[0], numbers[-1]
        if _number(points[first], "gap"):
            start, end = (_beside(points, n, step) for n, step in ((first, -1), (last, 1)))
            found.append(Stretch(list(points[first : last + 1]), start, end))
    return sorted(found, key=lambda stretch: -_number(stretch.points[0], "gap"))


def _beside(points: Sequence[dict[str, Any]], number: int, step: int) -> float:
    """Where the neighbor of a point lies along their route; the point itself where the route begins or ends."""
    beside = number + step
    is_there = 0 <= beside < len(points) and points[beside]["route"] == points[number]["route"]
    return _number(points[beside if is_there else number], "along")


def key_figures(points: Sequence[dict[str, Any]]) -> list[tuple[str, str]]:
    """(what, value) of the route as a whole."""
    lengths = {point["route"]: _number(point, "along") for point in points}
    good = sum(not _number(point, "gap") for point in points) / len(points)
    longest = max(points, key=lambda point: _number(point, "gap"))
    seconds = _number(longest, "gap_seconds")
    told = f"{shown(_number(longest, 'gap'), ',.0f')} m" + (f", {shown(seconds, ',.0f')} s" if seconds else "")
    return [
        (tr("length"), f"{shown(sum(lengths.values()) / 1000, '.3g')} km"),
        (tr("of the points good enough"), f"{shown(100 * good, '.0f')} %"),
        (tr("without an expected fix"), told if _number(longest, "gap") else tr("nowhere")),
    ]


def stretch_row(stretch: Stretch) -> list[str]:
    """Cells of a stretch."""
    first = stretch.points[0]
    shift = _number(first, "shift")
    text = tr("{shift:.0f} m to the left") if shift < 0 else tr("{shift:.0f} m to the right")
    return [
        str(first["route"]),
        shown(stretch.start, ",.0f"),
        shown(stretch.end, ",.0f"),
        shown(_number(first, "gap"), ",.0f"),
        _reason_of(stretch.points),
        text.format(shift=Local(abs(shift))) if shift else "",
    ]


def _reason_of(points: Sequence[dict[str, Any]]) -> str:
    """Why there is no fix at most of the points, as the middle one of these has it; they differ by their numbers."""
    told = [str(point["reason"]) for point in points if not is_null(point.get("reason"))]
    kinds = [re.sub(r"\d+", "", text) for text in told]
    if not told:
        return ""
    most = max(kinds, key=kinds.count)
    of_most = [text for text, kind in zip(told, kinds) if kind == most]
    return of_most[len(of_most) // 2]


def _number(point: dict[str, Any], name: str) -> float:
    """A column's number; 0 for NULL, for what is none and where the column is missing."""
    value = point.get(name)
    try:
        return 0.0 if is_null(value) else float(value)
    except (TypeError, ValueError):
        return 0.0


def _styled(layer: QgsVectorLayer | None) -> QgsVectorLayer | None:
    """A layer with its own style: QGIS opens files for algorithms without theirs."""
    if layer is not None and QgsProject.instance().mapLayer(layer.id()) is None:
        layer.loadDefaultStyle()
    return layer


def _today() -> str:
    from qgis.PyQt.QtCore import QDate, QLocale

    return QLocale().toString(QDate.currentDate(), QLocale.FormatType.ShortFormat)
