"""What only the second of two recordings has, for changes that were to add something: columns, keys, outputs."""

from __future__ import annotations

from typing import Any


def without_additions(a: Any, b: Any) -> tuple[Any, int]:
    """(b without what a lacks, the number of things taken out).

    Taken out are entries of dicts, fields that no row of a list has, and lines of texts; never a row of a list.
    """
    if isinstance(a, dict) and isinstance(b, dict):
        kept = {key: without_additions(a[key], value) for key, value in b.items() if key in a}
        added = sum(1 for key in b if key not in a) + sum(count for _, count in kept.values())
        return {key: value for key, (value, _) in kept.items()}, added
    if not isinstance(a, list) or not isinstance(b, list):
        return b, 0
    if len(b) > len(a) and all(isinstance(line, str) for line in b) and _in_order(a, b):
        return a, len(b) - len(a)
    return _rows(a, b)


def _rows(a: list[Any], b: list[Any]) -> tuple[list[Any], int]:
    known = {key for row in a if isinstance(row, dict) for key in row}
    added = {key for row in b if isinstance(row, dict) for key in row} - known
    if not known or not added:
        return b, 0
    return [{key: row[key] for key in row if key in known} if isinstance(row, dict) else row for row in b], len(added)


def _in_order(a: list[str], b: list[str]) -> bool:
    """Whether b has all lines of a, in their order."""
    rest = iter(b)
    return all(line in rest for line in a)
