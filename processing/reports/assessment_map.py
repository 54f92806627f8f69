"""Squares of ground as a picture: inline SVG in the colors of the layer's style."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np

WIDTH = 960


def cell_map(
    columns: np.ndarray,
    rows: np.ndarray,
    success: np.ndarray,
    classes: Sequence[tuple[float, float, str, str]],
    name: str,
) -> str:
    """Squares at columns (C,) and rows (C,) colored by success (C,) 0…1; classes: (from, to, color, text)."""
    number = sum((success >= low).astype(int) for low, *_ in classes[1:])
    width, height = int(columns.max()) + 1, int(rows.max()) + 1
    parts = []
    for column, row, length, kind in _runs(columns, rows, number):
        # A hair wider than they are, so that no gaps show between neighbors.
        parts.append(
            f'<rect x="{column}" y="{row}" width="{length + 0.03:g}" height="1.03" fill="{classes[kind][2]}"/>'
        )
    return (
        f'<svg viewBox="0 0 {width} {height}" role="img" aria-label="{escape(name)}" style="max-height:560px" '
        f'xmlns="http://www.w3.org/2000/svg">\n<title>{escape(name)}</title>\n' + "\n".join(parts) + "\n</svg>"
    )


def legend(classes: Sequence[tuple[float, float, str, str]]) -> str:
    """The classes beside each other, from good to bad."""
    entries = "".join(
        f'<span style="white-space:nowrap;margin-right:18px"><svg viewBox="0 0 12 12" style="display:inline-block;'
        f'width:12px;height:12px;vertical-align:-1px"><rect x="0.5" y="0.5" width="11" height="11" fill="{color}" '
        f'stroke="var(--soft)"/></svg> '
        f"{escape(text)}</span> "
        for _, _, color, text in classes[::-1]
    )
    return f'<p class="legend">{entries}</p>'


def _runs(columns: np.ndarray, rows: np.ndarray, kinds: np.ndarray) -> list[tuple[int, int, int, int]]:
    """(first column, row, length, kind) of neighbors of one kind in a row."""
    order = np.lexsort((columns, rows))
    columns, rows, kinds = columns[order], rows[order], kinds[order]
    breaks = (np.diff(columns) != 1) | (np.diff(rows) != 0) | (np.diff(kinds) != 0)
    starts = np.concatenate([[0], np.flatnonzero(breaks) + 1])
    lengths = np.diff(np.append(starts, len(columns)))
    return [(int(columns[s]), int(rows[s]), int(length), int(kinds[s])) for s, length in zip(starts, lengths)]
