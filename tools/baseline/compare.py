"""Two recordings beside each other: what is identical, what differs by rounding, what is different."""

from __future__ import annotations

import fnmatch
import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from difflib import SequenceMatcher
from pathlib import Path
from typing import Any

import numpy as np

from .additions import without_additions
from .store import is_number, names, read_manifest, read_recording, same_float

TOLERANCE = 1e-9
"""Relative; numbers that differ by less were summed in another order."""

IGNORED = {
    "plugin_version": "the plugin's version",
    "content_hash": "of onboard files, which holds the version; that it is right is recorded",
    "exported": "time at which an onboard file was exported",
    "last_change": "time at which a GeoPackage was written",
    "timestamp": "time at which a GeoPackage's metadata were written",
    "update_time": "time at which a style was written",
    "time": "time at which an image file was written",
    "seconds": "how long something took",
}
"""Fields that are left out wherever they stand; paths are replaced when recording."""

SHOWN = 3
LONGEST_ALIGNED = 20_000
"""Rows that are aligned by their content; longer lists are compared row by row."""

SAME, CLOSE, DIFFERENT = range(3)


@dataclass
class Tally:
    """How one thing compares: number of items by SAME, CLOSE, DIFFERENT, and what the differences are."""

    counts: list[int] = field(default_factory=lambda: [0, 0, 0])
    notes: list[str] = field(default_factory=list)
    added: int = 0

    def add(self, verdict: int, note: str = "", items: int = 1) -> None:
        self.counts[verdict] += items
        if verdict == DIFFERENT and len(self.notes) < SHOWN:
            self.notes.append(note)


def compare(
    folder_a: Path, folder_b: Path, ignore: Sequence[str] = (), additions: bool = False, every: bool = False
) -> int:
    """Print the table and return the exit status: 1 for any difference.

    Args:
        folder_a: The reference recording.
        folder_b: The recording to check.
        ignore: Patterns of entries to leave out.
        additions: Whether B may have columns, keys and outputs that A lacks. They are counted.
        every: Whether identical entries also get a line.
    """
    manifests = [read_manifest(folder) for folder in (folder_a, folder_b)]
    for letter, folder, manifest in zip("AB", (folder_a, folder_b), manifests):
        kind = "quick" if manifest["quick"] else "full"
        print(f"{letter}: {folder}: {kind} recording of {manifest['commit']} ({manifest['versions']})")
    tallies = dict(tallies_of(folder_a, folder_b, ignore, additions))
    lines = list(_lines(tallies, every))
    width = max((len(what) for what, _ in lines), default=0)
    head = ("items", "identical", "within 1e-9", "different")
    print(f"\n{'what':{width}}" + "".join(f" | {title:>11}" for title in head))
    for what, tally in lines:
        print(f"{what:{width}}" + _numbers(tally.counts))
        for note in tally.notes:
            print(f"    {note}")
    totals = [sum(tally.counts[n] for tally in tallies.values()) for n in range(3)]
    print(f"{'all':{width}}" + _numbers(totals))
    print("\nNot compared, wherever they stand: " + "; ".join(f"{name} ({why})" for name, why in IGNORED.items()))
    if additions:
        print(f"Only in B, and allowed: {sum(tally.added for tally in tallies.values()):,} things")
    if ignore:
        print(f"Left out on request: {', '.join(ignore)}")
    print("Different." if totals[DIFFERENT] else "Nothing is different.")
    return 1 if totals[DIFFERENT] else 0


def _lines(tallies: dict[str, Tally], every: bool) -> Iterator[tuple[str, Tally]]:
    """Lines of the table: what is identical is summed up by the first two parts of its name."""
    sums: dict[str, Tally] = {}
    for what, tally in tallies.items():
        apart = every or tally.counts[CLOSE] or tally.counts[DIFFERENT]
        group = sums.setdefault(what if apart else "/".join(what.split("/")[:2]), Tally())
        group.counts = [total + count for total, count in zip(group.counts, tally.counts)]
        group.notes += tally.notes
    yield from sums.items()


def _numbers(counts: Sequence[int]) -> str:
    return "".join(f" | {number:>11,}" for number in (sum(counts), *counts))


def tallies_of(
    folder_a: Path, folder_b: Path, ignore: Sequence[str] = (), additions: bool = False
) -> Iterator[tuple[str, Tally]]:
    """(what, Tally) of everything that either recording has."""
    (values_a, arrays_a), (values_b, arrays_b) = (read_recording(folder) for folder in (folder_a, folder_b))
    for what in names({**values_a, **values_b}, {**arrays_a, **arrays_b}):
        if any(fnmatch.fnmatch(what, pattern) for pattern in ignore):
            continue
        tally = Tally()
        if additions and what not in values_a and what not in arrays_a:
            tally.added += 1
        elif what in arrays_a or what in arrays_b:
            _compare_arrays(arrays_a.get(what), arrays_b.get(what), tally)
        elif what not in values_a or what not in values_b:
            tally.add(DIFFERENT, "only in " + ("A" if what in values_a else "B"))
        else:
            value = values_b[what]
            if additions:
                value, tally.added = without_additions(values_a[what], value)
            _compare_values(values_a[what], value, tally)
        yield what, tally


def _compare_arrays(a: np.ndarray | None, b: np.ndarray | None, tally: Tally) -> None:
    if a is None or b is None:
        tally.add(DIFFERENT, "only in " + ("B" if a is None else "A"))
        return
    if a.shape != b.shape or a.dtype != b.dtype:
        tally.add(DIFFERENT, f"{a.dtype} {a.shape} is {b.dtype} {b.shape}", max(a.size, b.size))
        return
    unlike = a != b
    close = np.zeros_like(unlike)
    if a.dtype.kind == "f":
        unlike &= ~(np.isnan(a) & np.isnan(b))
        close = unlike & (np.abs(a - b) <= TOLERANCE * np.maximum(np.abs(a), np.abs(b)))
    places = np.argwhere(unlike & ~close)
    tally.add(SAME, items=int(a.size - unlike.sum()))
    tally.add(CLOSE, items=int(close.sum()))
    for place in map(tuple, places[:SHOWN].tolist()):
        tally.notes.append(f"{list(place)}: {a[place]} is {b[place]}")
    tally.counts[DIFFERENT] += len(places)


def _compare_values(a: Any, b: Any, tally: Tally) -> None:
    """Items are the entries of a dict, the rows of a list, or the value itself."""
    if isinstance(a, dict) and isinstance(b, dict):
        for key in sorted({*a, *b} - set(IGNORED)):
            if key not in a or key not in b:
                tally.add(DIFFERENT, f"{key}: only in {'A' if key in a else 'B'}")
            else:
                verdict, note = difference(a[key], b[key])
                tally.add(verdict, f"{key}{note}")
    elif isinstance(a, list) and isinstance(b, list):
        _compare_rows(a, b, tally)
    else:
        verdict, note = difference(a, b)
        tally.add(verdict, note.lstrip(": "))


def _compare_rows(a: list[Any], b: list[Any], tally: Tally) -> None:
    """Rows by their order; a row too many or too few doesn't shift the others."""
    texts_a, texts_b = (
        [json.dumps(_without_ignored(row), sort_keys=True, ensure_ascii=False) for row in rows] for rows in (a, b)
    )
    first = 0
    while first < min(len(a), len(b)) and texts_a[first] == texts_b[first]:
        first += 1
    tally.add(SAME, items=first)
    for start_a, end_a, start_b, end_b in _blocks(texts_a[first:], texts_b[first:]):
        rows_a, rows_b = a[first + start_a : first + end_a], b[first + start_b : first + end_b]
        for n, (row_a, row_b) in enumerate(zip(rows_a, rows_b)):
            verdict, note = difference(row_a, row_b)
            tally.add(verdict, f"row {first + start_a + n}{note}")
        for letter, rest in (("A", rows_a[len(rows_b) :]), ("B", rows_b[len(rows_a) :])):
            for row in rest:
                tally.add(DIFFERENT, f"row only in {letter}: {_short(row)}")


def _blocks(a: list[str], b: list[str]) -> Iterator[tuple[int, int, int, int]]:
    """Parts of two lists that belong together: equal ones and those between."""
    if max(len(a), len(b)) > LONGEST_ALIGNED or len(a) == len(b) and sum(x != y for x, y in zip(a, b)) > len(a) // 2:
        yield 0, len(a), 0, len(b)
        return
    for _, *block in SequenceMatcher(None, a, b, autojunk=False).get_opcodes():
        yield tuple(block)


def _without_ignored(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without_ignored(part) for key, part in value.items() if key not in IGNORED}
    return [_without_ignored(part) for part in value] if isinstance(value, list) else value


def difference(a: Any, b: Any) -> tuple[int, str]:
    """(SAME, CLOSE or DIFFERENT, where the worst difference is) of two values of JSON."""
    if isinstance(a, dict) and isinstance(b, dict):
        keys = sorted({*a, *b} - set(IGNORED))
        return _worst((f".{key}", *_parts(a, b, key)) for key in keys)
    if isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        return _worst((f"[{n}]", *difference(x, y)) for n, (x, y) in enumerate(zip(a, b)))
    if is_number(a) and is_number(b):
        if type(a) is type(b) and same_float(a, b):
            return SAME, ""
        close = abs(a - b) <= TOLERANCE * max(abs(a), abs(b))
        return (CLOSE, "") if close else (DIFFERENT, f": {a!r} is {b!r}")
    return (SAME, "") if type(a) is type(b) and a == b else (DIFFERENT, f": {_short(a)} is {_short(b)}")


def _parts(a: dict[str, Any], b: dict[str, Any], key: str) -> tuple[int, str]:
    if key not in a or key not in b:
        return DIFFERENT, f": only in {'A' if key in a else 'B'}"
    return difference(a[key], b[key])


def _worst(verdicts: Iterator[tuple[str, int, str]]) -> tuple[int, str]:
    """The first DIFFERENT one with its place, else whether all are SAME."""
    worst = SAME
    for place, verdict, note in verdicts:
        if verdict == DIFFERENT:
            return DIFFERENT, f"{place}{note}"
        worst = max(worst, verdict)
    return worst, ""


def _short(value: Any) -> str:
    text = json.dumps(value, sort_keys=True, ensure_ascii=False)
    return text if len(text) <= 120 else f"{text[:117]}…"
