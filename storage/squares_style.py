"""How assessed squares of ground look on a map: five steps of expected success, with words in the legend.

``processing/exchange/assessment_styles.py`` has QGIS draw them so; where there is no QGIS, QML says the same.
"""

from __future__ import annotations

from collections.abc import Callable
from html import escape

from . import map_tips
from .qml import POLYGON, rgba, symbol, vector_style

COLORS = ("#00204d", "#46516c", "#7c7b78", "#bcad6c", "#ffea46")
"""Expected success from hardly ever to very reliably: cividis (Nuñez et al. 2018) at even steps, dark to light."""

OPACITY = 0.5
"""Of squares: forest, roads and roofs of a base map stay readable, and the steps of the ramp told apart."""

SENTENCES_OF_VERDICTS = {
    "hardly_ever": "hardly ever",
    "sometimes": "sometimes",
    "often": "often",
    "reliably": "reliably",
    "very_reliably": "very reliably",
}
"""From the worst to the best."""

SENTENCES_OF_SQUARES = {
    "footprint": "Footprint (m)",
    "success": "Expected success",
    "success_low": "Expected success, at least (95 %)",
    "success_high": "Expected success, at most (95 %)",
    "error": "Error (m)",
    "objects": "Landmarks in view",
    "classes": "Classes in view",
    "distinctiveness": "Distinctiveness",
    "look_alikes": "Look-alikes",
    "wrong": "Wrong fixes (share)",
    "trials": "Simulated images",
    "verdict": "Verdict",
    "reason": "Reason",
}
"""Titles of columns."""

SENTENCES_OF_TIPS = {
    "interval": "95 % interval",
    "error": "Expected error",
    "objects": "Landmarks in view",
    "reason": "Reason",
    "verdict": "Verdict",
    "distinctiveness": "Distinctiveness",
}

_Wording = Callable[[str], str]


def squares_qml(threshold: float, footprint: float, is_only: bool) -> str:
    """QML of the style, in English.

    Args:
        threshold: Success that is good enough, 0…1.
        footprint: The one whose squares are drawn.
        is_only: Whether there is no other.
    """
    ranges, symbols = [], []
    # From good to bad, as a legend is read.
    for number, (low, high, color, text) in enumerate(success_classes(threshold)[::-1]):
        ranges.append(
            f'<range render="true" symbol="{number}" lower="{low!r}" upper="{high!r}" label="{escape(text)}"/>'
        )
        fill = {"color": rgba(color), "style": "solid", "outline_style": "no"}
        symbols.append(symbol("fill", number, "SimpleFill", fill, OPACITY))
    renderer = (
        f'<renderer-v2 type="graduatedSymbol" graduatedMethod="GraduatedColor" '
        f'attr="{escape(success_expression(footprint, is_only))}">'
        f"<ranges>{''.join(ranges)}</ranges><symbols>{''.join(symbols)}</symbols></renderer-v2>"
    )
    words = {"verdict": SENTENCES_OF_VERDICTS}
    return vector_style(renderer, POLYGON, SENTENCES_OF_SQUARES, squares_tip(), words)


def success_classes(
    threshold: float, wording: _Wording = str, number: Callable[[float], str] = "{:.3g}".format
) -> list[tuple[float, float, str, str]]:
    """(from, to, color, legend text) of five classes of success 0…1; the upper two are good enough.

    Args:
        threshold: Success that is good enough.
        wording: Translates a text.
        number: How percent are written.
    """
    # Here, as the words above are wanted without OpenCV, too.
    from ..core.assessment.squares import verdict_edges

    edges = verdict_edges(threshold)
    return [
        (low, high, color, f"{wording(word)} ({number(100 * low)}–{number(100 * high)} %)")
        for low, high, color, word in zip(edges, edges[1:], COLORS, SENTENCES_OF_VERDICTS.values())
    ]


def success_expression(footprint: float, is_only: bool) -> str:
    """What squares are colored by; of several footprints in one layer those of ``footprint`` alone."""
    return "success" if is_only else f'if("footprint" = {footprint!r}, "success", NULL)'


def squares_tip(wording: _Wording = str) -> str:
    """Their map tip; ``wording``: translates a text."""
    verdicts = {key: wording(text) for key, text in SENTENCES_OF_VERDICTS.items()}
    rows = [
        *expected_rows(wording),
        (wording(SENTENCES_OF_TIPS["verdict"]), map_tips.worded("verdict", verdicts)),
        (wording(SENTENCES_OF_TIPS["distinctiveness"]), map_tips.number("distinctiveness", 2)),
    ]
    return map_tips.tip(success_heading(), rows)


def success_heading() -> str:
    """Expression above a map tip."""
    return _percent("success")


def expected_rows(wording: _Wording) -> list[tuple[str, str]]:
    """(title, expression) of what is expected at a place, for its map tip; ``wording``: translates a text."""
    told = {
        "interval": f"{_percent('success_low')} || '–' || {_percent('success_high')}",
        "error": map_tips.number("error", 1, unit="m"),
        "objects": map_tips.number("objects", 0),
        "reason": f"nullif({map_tips.text('reason')}, '')",
    }
    return [(wording(SENTENCES_OF_TIPS[name]), expression) for name, expression in told.items()]


def _percent(column: str) -> str:
    return map_tips.number(column, 0, 100, "%")
