"""Markdown: tables, and the sections of a page that benchmarks refresh between marker comments."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path


def table(header: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """A Markdown table; the first column is text, the others are aligned right."""
    lines = [_line(header), _line(["---"] + ["---:"] * (len(header) - 1))]
    return "\n".join(lines + [_line(row) for row in rows])


def rate(successes: int, trials: int) -> str:
    """“299/300, 100 % (98–100)”: count, rate and its 95 % interval; “–” without trials."""
    return f"{successes}/{trials}, {share(successes, trials)}" if trials else "–"


def share(successes: int, trials: int) -> str:
    """“97 % (92–99)”: rate and interval in percent, with a decimal beyond 500 trials, two beyond 5,000."""
    from semref.core.evaluation.rates import wilson

    digits = sum(trials > most for most in (500, 5000))
    low, high = wilson(successes, trials)
    return f"{100 * successes / max(trials, 1):.{digits}f} % ({100 * low:.{digits}f}–{100 * high:.{digits}f})"


def _line(cells: Sequence[object]) -> str:
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def write_section(path: Path, name: str, body: str) -> None:
    """Replaces what stands between the markers of `name` in a page, or adds them at its end."""
    text = path.read_text(encoding="utf-8") if path.exists() else ""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(with_section(text, name, body), encoding="utf-8")


def with_section(text: str, name: str, body: str) -> str:
    """`text` with `body` between `<!-- bench:name -->` and `<!-- /bench:name -->`; raises ValueError for one alone."""
    begin, end = f"<!-- bench:{name} -->", f"<!-- /bench:{name} -->"
    section = f"{begin}\n\n{body.strip()}\n\n{end}"
    if begin not in text and end not in text:
        return f"{text.rstrip()}\n\n## {name}\n\n{section}\n".lstrip()
    before, found, rest = text.partition(begin)
    _, closed, after = rest.partition(end)
    if not found or not closed:
        raise ValueError(f"The page has only one of the markers {begin} and {end}; add the other.")
    return before + section + after


def cached_size(kind: str) -> str:
    """Remove what the cache has of a kind and return its size; “–” for nothing."""
    from semref.core.cache import cache_folder

    files = [(path, path.stat().st_size) for path in cache_folder().glob(f"{kind}-*")]
    for path, _ in files:
        path.unlink()
    return size(sum(count for _, count in files)) if files else "–"


def size(count: float) -> str:
    """Bytes for people: “33.1 kB”, in thousands."""
    for unit in ("B", "kB", "MB"):
        if count < 1000:
            return f"{count:.0f} {unit}" if unit == "B" else f"{count:.1f} {unit}"
        count /= 1000
    return f"{count:.2f} GB"
