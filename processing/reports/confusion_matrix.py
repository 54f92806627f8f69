"""The confusion matrix as a picture (SVG): a row a class, with room for names of any length."""

from __future__ import annotations

from html import escape
from typing import List, Sequence

from .charts import ramp

CELL_W, CELL_H = 54, 34
CHARACTER = 8.0
"""Room for a character of a name; names are cut after NAME_LENGTH of them."""

NAME_LENGTH = 24
_TITLE = 24


def confusion_matrix(
    shares: Sequence[Sequence[float]],
    texts: Sequence[Sequence[str]],
    row_names: Sequence[str],
    column_names: Sequence[str],
    y_title: str,
    x_title: str,
    name: str,
) -> str:
    """Cells colored from 0 (dark) to 1 (light) with their texts; the first row lies at the top, as in a table."""
    rows, columns = ([_cut(text) for text in names] for names in (row_names, column_names))
    left = _TITLE + 10 + CHARACTER * max(map(_room, rows))
    # Names of columns stand aslant above them.
    top = _TITLE + 10 + 0.71 * CHARACTER * max(map(_room, columns))
    bottom = top + CELL_H * len(rows)
    right = left + CELL_W * len(columns)
    width, height = right + 0.71 * CHARACTER * _room(columns[-1]), bottom + 6
    parts = [_text((left + right) / 2, 14, x_title), _text(14, (top + bottom) / 2, y_title, "middle", -90)]
    for n, text in enumerate(columns):
        parts.append(_text(left + CELL_W * (n + 0.5), top - 8, text, "start", -45, "soft"))
    for n, (line, line_texts) in enumerate(zip(shares, texts)):
        y = top + CELL_H * n
        parts.append(_text(left - 8, y + CELL_H / 2 + 4, rows[n], "end", 0, "soft"))
        for m, (share, text) in enumerate(zip(line, line_texts)):
            parts += _cell(left + CELL_W * m, y, share, text)
    return (
        f'<svg viewBox="0 0 {width:.0f} {height:.0f}" role="img" aria-label="{escape(name)}" '
        f'style="max-width:{width:.0f}px" xmlns="http://www.w3.org/2000/svg">\n<title>{escape(name)}</title>\n'
        + "\n".join(parts)
        + "\n</svg>"
    )


def _cut(name: str) -> str:
    return name if len(name) <= NAME_LENGTH else name[: NAME_LENGTH - 1] + "…"


def _room(name: str) -> float:
    """Characters, of which Chinese ones are twice as wide."""
    return sum(2 if ord(character) > 0x2E80 else 1 for character in name)


def _cell(x: float, y: float, share: float, text: str) -> List[str]:
    fill, ink = ramp(share)
    return [
        f'<rect x="{x + 1:.1f}" y="{y + 1:.1f}" width="{CELL_W - 2}" height="{CELL_H - 2}" style="fill:{fill}"/>'
        f'<text x="{x + CELL_W / 2:.1f}" y="{y + CELL_H / 2 + 4:.1f}" text-anchor="middle" style="fill:{ink}">'
        f"{escape(text)}</text>"
    ]


def _text(x: float, y: float, text: str, anchor: str = "middle", turn: float = 0, kind: str = "") -> str:
    turned = f' transform="rotate({turn:g} {x:.1f} {y:.1f})"' if turn else ""
    marked = f' class="{kind}"' if kind else ""
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{marked}{turned}>{escape(text)}</text>'
