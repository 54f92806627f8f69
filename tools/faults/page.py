"""The table of docs/reliability.md."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .trials import Row


def table(rows: Sequence[Row], told: str) -> str:
    """Markdown: a row a writer, with how many faults it survived of those that were injected; ``told`` below it."""
    kinds = list(dict.fromkeys(kind for row in rows for kind in row.counts))
    lines = ["| writer | " + " | ".join(kinds) + " | outputs of different age |", "|---" * (len(kinds) + 2) + "|"]
    for row in rows:
        cells = [row.cell(kind) for kind in kinds]
        lines.append(f"| {row.name} | " + " | ".join(cells) + f" | {row.mixed or ''} |")
    totals = [str(sum(row.counts.get(kind, 0) for row in rows)) for kind in kinds]
    lines.append("| **together** | " + " | ".join(totals) + f" | {sum(row.mixed for row in rows)} |")
    finds = sum(len(row.finds) for row in rows)
    lines.append("")
    lines.append(f"{finds or 'None'} of these lost anything, left anything half or ended otherwise than it said.")
    lines += ["", told]
    return "\n".join(lines)


def write(path: Path, text: str) -> None:
    """Puts the table between its marks."""
    from benchmarks.results import write_section

    write_section(path, "faults", text)
