"""The page of a report: one HTML file with its style inside, readable on screen, in the dark and on paper.

Functions take plain text and escape it; what they return is HTML and is put together as it is.
"""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from ...core.evaluation.rates import Rate
from ..exchange import palette
from ..wording.numbers import count, shown

NOTHING = "–"
"""Stands where nothing is known."""

DASH = "\u2060–\u2060"
"""“to”, at which no line breaks."""

NO_BREAK = "\u00a0"
"""A space at which no line breaks, between a number and its unit."""

_COLORS = {
    "s0": palette.FIX,
    "s1": palette.FLIGHT,
    "s2": palette.GOOD,
    "s3": palette.FOURTH,
    "good": palette.GOOD,
    "bad": palette.BAD,
    "warning": palette.WARNING,
    "information": palette.INFORMATION,
}
"""The maps' colors by the names that a page has for them."""


def _variables(colors: dict[str, str]) -> str:
    return " ".join(f"--{name}: {color};" for name, color in colors.items())


_LIGHT = _variables(
    {
        "ground": "#ffffff",
        "text": palette.INK,
        "soft": palette.SOFT_INK,
        "line": palette.LINE,
        "panel": "#f4f6f7",
        **_COLORS,
    }
)
_DARK = _variables(
    {
        "ground": "#16191c",
        "text": "#e4e8eb",
        "soft": "#9ba6ae",
        "line": "#3a4147",
        "panel": "#1f2428",
        **{name: palette.DARK[color] for name, color in _COLORS.items()},
    }
)
_PAPER = _variables(
    {"ground": "#ffffff", "text": "#000000", "soft": "#444444", "line": "#bbbbbb", "panel": "#ffffff", **_COLORS}
)

_STYLE = (
    f":root {{ color-scheme: light dark; {_LIGHT} }}\n"
    f"@media (prefers-color-scheme: dark) {{ :root {{ {_DARK} }} }}\n"
    f"@media print {{ :root {{ color-scheme: light; {_PAPER} }} }}\n"
    """body { margin: 0; background: var(--ground); color: var(--text); font: 15px/1.5 system-ui, "Segoe UI",
  "Noto Sans", sans-serif; }
main { max-width: 1020px; margin: 0 auto; padding: 28px 24px 48px; }
h1 { font-size: 26px; line-height: 1.25; margin: 0 0 4px; }
h2 { font-size: 18px; margin: 36px 0 8px; padding-top: 14px; border-top: 1px solid var(--line); }
p { margin: 0 0 10px; max-width: 74ch; }
p.legend { max-width: none; }
.soft, figcaption { color: var(--soft); }
figure { margin: 0; }
figcaption { font-size: 13px; margin-top: 2px; }
svg { display: block; width: 100%; height: auto; }
svg text { font: 12px system-ui, "Segoe UI", "Noto Sans", sans-serif; fill: var(--text); }
svg .soft { fill: var(--soft); }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(420px, 1fr)); gap: 24px; align-items: start; }
.columns > div { min-width: 0; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(190px, 1fr)); gap: 12px; margin: 18px 0; }
.figures div { background: var(--panel); border: 1px solid var(--line); border-radius: 6px; padding: 10px 14px; }
.figures b { display: block; font-size: 26px; line-height: 1.2; font-weight: 600; }
.figures span { font-size: 13px; color: var(--soft); display: block; }
table { border-collapse: collapse; margin: 8px 0 14px; font-size: 14px; font-variant-numeric: tabular-nums; }
th, td { padding: 4px 14px 4px 0; text-align: left; vertical-align: top; border-bottom: 1px solid var(--line); }
th { font-weight: 600; color: var(--soft); }
td.number, th.number { text-align: right; white-space: nowrap; }
td.good { color: var(--good); } td.bad { color: var(--bad); }
.scroll { overflow-x: auto; }
.next { background: var(--panel); border-left: 4px solid var(--s0); border-radius: 0 6px 6px 0; padding: 12px 18px 6px;
  margin: 18px 0; }
.next h2 { border: 0; margin: 0 0 6px; padding: 0; font-size: 15px; }
.next ul { margin: 0 0 8px; padding-left: 18px; } .next li { margin: 0 0 4px; max-width: 78ch; }
@media (max-width: 520px) { .columns { grid-template-columns: 1fr; } }
@page { margin: 16mm 14mm; }
@media print { figure, .figures, .next, tr { break-inside: avoid; } thead { display: table-header-group; }
  h2 { break-after: avoid; } main { max-width: none; padding: 0; } .scroll { overflow: visible; }
  .figures { grid-template-columns: repeat(4, 1fr); } .figures b { font-size: 20px; }
  table { font-size: 11px; } th, td { padding-right: 8px; } td.number, th.number { white-space: normal; }
  svg { max-height: 84mm; } .legend, tbody tr:nth-child(-n+3) { break-after: avoid; }
  svg, .figures div, .next, td { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
"""
)


def page(title: str, subtitle: str, *parts: str, head: str = "") -> str:
    """A whole HTML document; title and subtitle are text, parts and lines of its head HTML."""
    return (
        '<!DOCTYPE html>\n<html>\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"{head}<title>{escape(title)}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n<main>\n"
        f'<h1>{escape(title)}</h1>\n<p class="soft">{escape(subtitle)}</p>\n'
        + "\n".join(parts)
        + "\n</main>\n</body>\n</html>\n"
    )


def section(title: str, *parts: str) -> str:
    """A heading with what belongs to it."""
    return f"<section>\n<h2>{escape(title)}</h2>\n" + "\n".join(parts) + "\n</section>"


def paragraph(text: str) -> str:
    return f"<p>{escape(text)}</p>"


def next_steps(title: str, steps: Sequence[str]) -> str:
    """What to do with what the page says, below its key figures: a sentence each."""
    items = "".join(f"<li>{escape(step)}</li>" for step in steps)
    return f'<section class="next">\n<h2>{escape(title)}</h2>\n<ul>{items}</ul>\n</section>' if steps else ""


def figure(svg: str, caption: str) -> str:
    """A chart with the sentence below it."""
    return f"<figure>\n{svg}\n<figcaption>{escape(caption)}</figcaption>\n</figure>"


def columns(*parts: str) -> str:
    """Parts beside each other where there is room."""
    return '<div class="columns">\n' + "\n".join(f"<div>{part}</div>" for part in parts) + "\n</div>"


def key_figures(figures: Sequence[tuple[str, str, str]]) -> str:
    """The numbers that matter most: (value, what it is, a note)."""
    cells = (
        f"<div><span>{escape(name)}</span><b>{escape(value)}</b><span>{escape(note)}</span></div>"
        for value, name, note in figures
    )
    return '<div class="figures">\n' + "\n".join(cells) + "\n</div>"


class Marked(str):
    """A table cell's text that is good or bad news: ``Marked("wrong", False)``."""

    is_good: bool

    def __new__(cls, text: str, is_good: bool) -> Marked:
        made = super().__new__(cls, text)
        made.is_good = is_good
        return made


def table(header: Sequence[str], rows: Sequence[Sequence[str]], numbers: Sequence[int] = ()) -> str:
    """A table of texts; the columns in ``numbers`` (from 0) are aligned to the right."""
    head = "".join(f"<th{_kinds(n in numbers)}>{escape(text)}</th>" for n, text in enumerate(header))
    body = "\n".join(
        "<tr>" + "".join(f"<td{_kinds(n in numbers, cell)}>{escape(cell)}</td>" for n, cell in enumerate(row)) + "</tr>"
        for row in rows
    )
    return f'<div class="scroll"><table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody>\n</table></div>'


def _kinds(is_number: bool, cell: str = "") -> str:
    kinds = ["number"] if is_number else []
    if isinstance(cell, Marked):
        kinds.append("good" if cell.is_good else "bad")
    return f' class="{" ".join(kinds)}"' if kinds else ""


def percent(share, digits: int = 1) -> str:
    """0.125 → “12.5 %”; NOTHING for None."""
    return NOTHING if share is None else f"{shown(100 * share, f'.{digits}f')}{NO_BREAK}%"


def interval_text(rate: Rate) -> str:
    """“90.1–97.3 %, 93/98”."""
    low, high = rate.interval
    between = f"{shown(100 * low, '.1f')}{DASH}{shown(100 * high, '.1f')}"
    return f"{between}{NO_BREAK}%, {count(rate.successes)}/{count(rate.trials)}"


def rate_text(rate: Rate) -> str:
    """“95.0 % (90.1–97.3 %, 93/98)”; NOTHING without trials."""
    return f"{percent(rate.share)} ({interval_text(rate)})" if rate.trials else NOTHING


def number(value, unit: str = "", digits: int = 3) -> str:
    """A number to so many significant digits with its unit; NOTHING for None."""
    if value is None:
        return NOTHING
    text = shown(value, f".{digits}g" if abs(value) < 10**digits else ",.0f")
    return text + (unit if unit in ("", "°") else NO_BREAK + unit)
