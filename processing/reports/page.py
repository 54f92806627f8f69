"""Parts of a report's page from one template, for light and dark screens and for paper.

Functions take plain text, which the template escapes, and return HTML.
"""

from __future__ import annotations

import base64
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, Callable, TypeVar

from ...core.evaluation.rates import Rate
from ..layers import palette
from ..messages.numbers import count, shown

T = TypeVar("T")
TEMPLATE = Path(__file__).resolve().parents[2] / "resources" / "report.html"

NOTHING = "–"
"""Text for unknown values."""

DASH = "\u2060–\u2060"
"""Dash of ranges without line break."""

NO_BREAK = "\u00a0"
"""Space without line break, between a number and its unit."""

_MAP_COLORS = {
    "s0": palette.FIX,
    "s1": palette.FLIGHT,
    "s2": palette.GOOD,
    "s3": palette.FOURTH,
    "good": palette.GOOD,
    "bad": palette.BAD,
}
_NAMES = "ground", "text", "soft", "line", "panel"
COLORS = {
    "light": dict(zip(_NAMES, ("#ffffff", palette.INK, palette.SOFT_INK, palette.LINE, "#f4f6f7")), **_MAP_COLORS),
    "dark": dict(
        zip(_NAMES, ("#16191c", "#e4e8eb", "#9ba6ae", "#3a4147", "#1f2428")),
        **{name: palette.DARK[color] for name, color in _MAP_COLORS.items()},
    ),
    "paper": dict(zip(_NAMES, ("#ffffff", "#000000", "#444444", "#bbbbbb", "#ffffff")), **_MAP_COLORS),
}
"""Variables of the page's style for each medium."""


@lru_cache(maxsize=1)
def macros() -> Any:
    """Return the template's macros. QGIS contains jinja2 for its plugin MetaSearch."""
    from jinja2 import Environment

    environment = Environment(autoescape=True, trim_blocks=True, lstrip_blocks=True)
    return environment.from_string(TEMPLATE.read_text("utf-8")).module


def page(title: str, subtitle: str, *parts: str, meta: Mapping[str, str] | None = None) -> str:
    """Return an HTML document; ``meta``: name and content of lines in its head."""
    return str(macros().page(title, subtitle, parts, meta or {}, COLORS))


def section(title: str, *parts: str) -> str:
    """Return a heading with its parts; empty without parts."""
    return macros().section(title, parts) if parts else ""


def paragraph(text: str) -> str:
    return macros().paragraph(text)


def figure(picture: str, caption: str) -> str:
    return macros().figure(picture, caption)


def image(png: bytes, alt: str) -> str:
    return macros().image(base64.b64encode(png).decode("ascii"), alt)


def columns(*parts: str) -> str:
    """Return parts side by side, if they fit."""
    return macros().columns(parts)


def key_figures(figures: Sequence[tuple[str, str, str]]) -> str:
    """Return boxes of key figures: (value, name, note)."""
    return macros().key_figures(figures)


class Marked(str):
    """Text of a table cell, colored as good or bad: ``Marked("wrong", False)``."""

    is_good: bool

    def __new__(cls, text: str, is_good: bool) -> Marked:
        made = super().__new__(cls, text)
        made.is_good = is_good
        return made


class Shaded(str):
    """Text of a table cell with a background as dark as its share of 0…1; without one for None."""

    style: str

    def __new__(cls, text: str, share: float | None) -> Shaded:
        made = super().__new__(cls, text)
        made.style = "" if share is None else f"background:rgba(31,111,214,{0.7 * share:.2f})"
        return made


def table(header: Sequence[str], rows: Sequence[Sequence[str]], numbers: Sequence[int] = ()) -> str:
    """Return a table of texts; columns in ``numbers`` (from 0) are aligned to the right."""
    return macros().table(header, rows, numbers)


def records(things: Iterable[T], columns: Sequence[tuple[str, Callable[[T], str]]], numbers: Sequence[int] = ()) -> str:
    """Return a table with a row for each of ``things``; columns: (title, function of the cell's text)."""
    rows = [[text(one) for _, text in columns] for one in things]
    return table([title for title, _ in columns], rows, numbers)


def percent(share, digits: int = 1) -> str:
    """Return “12.5 %” for 0.125; NOTHING for None."""
    return NOTHING if share is None else f"{shown(100 * share, f'.{digits}f')}{NO_BREAK}%"


def interval_text(rate: Rate) -> str:
    """Return the interval and the counts: “90.1–97.3 %, 93/98”."""
    low, high = rate.interval
    between = f"{shown(100 * low, '.1f')}{DASH}{shown(100 * high, '.1f')}"
    return f"{between}{NO_BREAK}%, {count(rate.successes)}/{count(rate.trials)}"


def rate_text(rate: Rate) -> str:
    """Return “95.0 % (90.1–97.3 %, 93/98)”; NOTHING without trials."""
    return f"{percent(rate.share)} ({interval_text(rate)})" if rate.trials else NOTHING


def fixed(value: float | None, spec: str, unit: str = "") -> str:
    """Return a number by Python's format specification, with its unit; NOTHING for None."""
    return NOTHING if value is None else shown(value, spec) + unit


def number(value, unit: str = "", digits: int = 3) -> str:
    """Return a number with ``digits`` significant digits and its unit; NOTHING for None."""
    if value is None:
        return NOTHING
    text = shown(value, f".{digits}g" if abs(value) < 10**digits else ",.0f")
    return text + (unit if unit in ("", "°") else NO_BREAK + unit)
