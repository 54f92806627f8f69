"""How localized images look on a map: positions with heading and ellipse, their ground, possible places, landmarks."""

from __future__ import annotations

from qgis.core import QgsFillSymbol, QgsMarkerSymbol, QgsRuleBasedRenderer, QgsSingleSymbolRenderer
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QColor

from ...core.sentences import template_of
from ...storage import map_tips
from ..translation import tr
from ..wording.columns import method_words, status_words
from ..wording.sentences import worded
from .output_style import Look
from .palette import BAD, CASING, FIX, WARNING
from .pose_symbols import CROSS, DISC, FILLED, pose_symbol

IMAGE_NAME = 'base_file_name("image")'
"""Expression of what an image is called on a map."""

_PAGES = (
    ("x", "y", "longitude", "latitude", "heading", "pixel_size"),
    (
        *("confidence", "error_95", "error_95_minor", "error_95_direction", "heading_deviation"),
        *("pixel_size_deviation", "sigma_east", "sigma_north", "correlation", "sigma_heading", "sigma_scale"),
    ),
    (
        *("method", "distance", "inliers", "references", "log_odds", "window", "search_capped", "jump"),
        *("camera", "camera_x", "camera_y", "gps_distance"),
    ),
)
"""Columns of the form's pages after the first."""


def position_pages(*first: str) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Pages of the form of a position; ``first``: further columns of the first page."""
    titles = tr("Position"), tr("How exactly"), tr("How it was found")
    return ((tr("Image"), ("image", "status", "reason", *first)), *zip(titles, _PAGES))


def position_tip(is_timed: bool, *more: tuple[str, str]) -> str:
    """The map tip of a position with its picture and, with times, its time; ``more``: (title, expression) of lines."""
    from ...core.localizer.record import TESTED, error_probability

    is_probability = "\"method\" <> 'topology vector'"
    times = f'1 / max(1 - "confidence", 1.0 / {TESTED})'
    rounded = f"round({times}, 1 - to_int(floor(log10({times}))))"
    below, one_in = error_probability(1.0), tr(template_of(error_probability(0.0)))
    before, _, after = map_tips.quoted(one_in).partition("{count:,.0f}")
    error = (
        f"CASE WHEN \"confidence\" >= {1 - 1 / TESTED} THEN '{map_tips.quoted(worded(below))}' "
        f"ELSE '{before}' || format_number({rounded}, 0) || '{after}' END"
    )
    rows = [
        (tr("Status"), map_tips.worded("status", status_words())),
        (tr("95 % radius"), map_tips.number("error_95", 1, unit="m")),
        (tr("Heading"), "format_number(\"heading\", 1) || '°'"),
        (tr("Pixel size"), map_tips.number("pixel_size", 2, unit="m")),
        (tr("Error probability"), f"CASE WHEN {is_probability} THEN {error} END"),
        (tr("Method"), map_tips.worded("method", method_words())),
        (tr("Reason"), map_tips.text("reason")),
        *more,
        *([(tr("Time"), "format_date(\"time\", 'yyyy-MM-dd HH:mm:ss')")] if is_timed else []),
    ]
    return map_tips.tip(map_tips.file_name("image"), rows, "image")


def positions_look(is_timed: bool = False) -> Look:
    """Arrows in blue; discs where the method tells no heading; crosses where an image can't have been in time."""
    shown = (
        ('NOT coalesce("jump", false) AND "heading" IS NOT NULL', FIX, FILLED, tr("Fix, with its heading")),
        ('NOT coalesce("jump", false) AND "heading" IS NULL', FIX, DISC, tr("Fix without a heading")),
        ('"jump"', BAD, CROSS, tr("Out of reach in time")),
    )
    return Look(
        pose_rules(shown),
        "time" if is_timed else "",
        IMAGE_NAME,
        IMAGE_NAME,
        position_tip(is_timed),
        position_pages("time"),
        "image",
    )


def pose_rules(kinds: tuple[tuple[str, str, str, str], ...]) -> QgsRuleBasedRenderer:
    """A symbol for each kind of pose: (expression, color, shape, words of the legend)."""
    root = QgsRuleBasedRenderer.Rule(None)
    for expression, color, shape, words in kinds:
        root.appendChild(QgsRuleBasedRenderer.Rule(pose_symbol(color, shape), 0, 0, expression, words))
    return QgsRuleBasedRenderer(root)


def footprints_look() -> Look:
    """The ground that images show: what lies below stays visible."""
    tip = map_tips.tip(map_tips.file_name("image"), [], "image")
    return Look(_ground(FIX, 22, Qt.PenStyle.SolidLine), name=IMAGE_NAME, tip=tip, picture="image")


def places_look() -> Look:
    """Places that an image may show: dashed, since none is decided."""
    place = f"{IMAGE_NAME} || ' ' || \"rank\""
    rows = [
        (tr("Rank"), 'to_string("rank")'),
        (tr("Heading"), "format_number(\"heading\", 1) || '°'"),
        (tr("Pixel size"), map_tips.number("pixel_size", 2, unit="m")),
    ]
    tip = map_tips.tip(map_tips.file_name("image"), rows, "image")
    return Look(_ground(WARNING, 18, Qt.PenStyle.DashLine), name=place, label=place, tip=tip, picture="image")


def matches_look() -> Look:
    """Rings around the landmarks that agree, with the number that they have in the image."""
    symbol = QgsMarkerSymbol.createSimple(
        {"name": "circle", "color": "0,0,0,0", "outline_color": CASING, "outline_width": "0.9", "size": "3.4"}
    )
    ring = QgsMarkerSymbol.createSimple(
        {"name": "circle", "color": "0,0,0,0", "outline_color": FIX, "outline_width": "0.5", "size": "3.4"}
    )
    symbol.appendSymbolLayer(ring.symbolLayer(0).clone())
    rows = [(tr("Class"), map_tips.text("class_name")), (tr("Residual"), map_tips.number("residual", 2, unit="m"))]
    tip = map_tips.tip(f"{map_tips.file_name('image')} || ' ' || \"number\"", rows)
    return Look(QgsSingleSymbolRenderer(symbol), name='"number"', label='"number"', tip=tip, picture="image")


def _ground(color: str, alpha: int, stroke: Qt.PenStyle) -> QgsSingleSymbolRenderer:
    """An outline with a white rim around ground that shows through."""
    symbol = QgsFillSymbol.createSimple({"outline_color": CASING, "outline_width": "1.0", "outline_style": "solid"})
    fill = QColor(color)
    fill.setAlpha(alpha)
    symbol.symbolLayer(0).setFillColor(fill)
    line = QgsFillSymbol.createSimple({"style": "no", "outline_color": color, "outline_width": "0.6"})
    line.symbolLayer(0).setStrokeStyle(stroke)
    symbol.appendSymbolLayer(line.symbolLayer(0).clone())
    return QgsSingleSymbolRenderer(symbol)
