"""How a flight looks on a map: where its images' tops point to, how exactly that is known, what each pose rests on."""

from __future__ import annotations

from qgis.core import QgsLineSymbol, QgsRuleBasedRenderer, QgsSingleSymbolRenderer, QgsVectorLayer

from ...storage import map_tips
from ..compat import is_null
from ..translation import tr
from ..wording.columns import source_words
from .output_style import Look
from .palette import BAD, CASING, FIX, FLIGHT
from .pose_symbols import CROSS, FILLED, HOLLOW
from .position_looks import IMAGE_NAME, pose_rules, position_pages, position_tip

TRACK_COLOR = "#3a4147"


def pose_kinds() -> tuple[tuple[str, str, str, str], ...]:
    """(expression, color, shape of the marker, words of the legend) of each kind of pose."""
    return (
        ("\"source\" = 'own'", FIX, FILLED, tr("Fix of the image itself")),
        (
            '"source" = \'flight\' AND NOT coalesce("outvoted", false)',
            FLIGHT,
            HOLLOW,
            tr("Placed by the flight"),
        ),
        ('"source" = \'flight\' AND "outvoted"', BAD, CROSS, tr("Its own fix was outvoted")),
    )


def poses_renderer() -> QgsRuleBasedRenderer:
    """Arrows where the images' tops point to, on their 95 % ellipses, which have the map's own scale."""
    return pose_rules(pose_kinds())


def track_renderer() -> QgsSingleSymbolRenderer:
    """Dark lines with a white rim: on forest and photos as on white."""
    symbol = QgsLineSymbol.createSimple({"line_color": CASING, "line_width": "1.0"})
    line = QgsLineSymbol.createSimple({"line_color": TRACK_COLOR, "line_width": "0.45"})
    symbol.appendSymbolLayer(line.symbolLayer(0).clone())
    return QgsSingleSymbolRenderer(symbol)


def flight_look(positions: QgsVectorLayer) -> Look:
    """What positions of a flight come with: their style and, with times, that QGIS plays them."""
    return poses_look(any(not is_null(feature["time"]) for feature in positions.getFeatures()))


def poses_look(is_timed: bool) -> Look:
    """What positions of a flight come with; ``is_timed``: whether any has a time."""
    more = [(tr("Held by"), map_tips.worded("source", source_words())), (tr("Track"), 'to_string("track")')]
    pages = position_pages("number", "time", "source", "track", "outvoted")
    tip = position_tip(is_timed, *more)
    return Look(poses_renderer(), "time" if is_timed else "", IMAGE_NAME, IMAGE_NAME, tip, pages, "image")


def track_look() -> Look:
    """What tracks come with."""
    rows = [
        (tr("Images"), map_tips.number("images")),
        (tr("Images with a fix of their own"), map_tips.number("own")),
        (tr("Length"), map_tips.number("length", 2, 0.001, "km")),
        (tr("Largest 95 % radius"), map_tips.number("largest_error_95", 1, unit="m")),
    ]
    track = tr("Track").replace("'", "''")
    title = f"'{track} ' || \"track\""
    return Look(track_renderer(), name=title, tip=map_tips.tip(title, rows))
