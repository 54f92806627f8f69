"""Checks of values from files: type, finite, in range and of limited length. Columns of layers."""

from __future__ import annotations

import json
import math
import re
from typing import Any

from . import limits

_JSON_STRING = re.compile(r'"(?:[^"\\]|\\.?)*"?', re.DOTALL)
"""A string, also an unterminated one. The pattern can't fail and never backtracks, so the search is linear."""


def read_json(text: str, longest: int = limits.JSON_CHARACTERS) -> Any:  # noqa: ANN401 -- JSON is of any type
    """Parse a JSON text.

    Args:
        longest: Maximum number of characters.

    Raises:
        ValueError: The text is not JSON, is too long or too deep, or has a whole number with too many digits.
    """
    if len(text) > longest:
        raise ValueError(f"it has {len(text)} characters, more than {longest}")
    depth = 0
    for bracket in re.finditer(r"[][{}]", _JSON_STRING.sub("", text)):
        depth += 1 if bracket[0] in "[{" else -1
        if depth > limits.JSON_DEPTH:
            raise ValueError(f"it has lists in more than {limits.JSON_DEPTH} lists")
    return json.loads(text, parse_int=_whole)


def _whole(text: str) -> int:
    if len(text) > limits.NUMBER_DIGITS:
        raise ValueError(f"a number has {len(text)} digits")
    return int(text)


def checked(value: Any, kind: type | tuple[type, ...], name: str) -> Any:  # noqa: ANN401 -- as it came
    """Return ``value`` if it has one of the types ``kind``, else raise ValueError. True and false are not numbers."""
    if isinstance(value, bool) or not isinstance(value, kind):
        raise ValueError(f"{name} is {shown(value)}")
    return value


def number(
    value: Any,  # noqa: ANN401 -- as it came
    name: str,
    above: float = -math.inf,
    most: float = math.inf,
) -> float:
    """Return ``value`` as a finite number above ``above``, up to ``most``; raise ValueError otherwise."""
    if not above < checked(value, (int, float), name) < math.inf or value > most:
        raise ValueError(f"{name} is {shown(value)}")
    return float(value)


def short_text(value: Any, name: str, longest: int = limits.NAME_CHARACTERS) -> str:  # noqa: ANN401 -- as it came
    """Return ``value`` if it is a text of at most ``longest`` characters; raise ValueError otherwise."""
    if len(checked(value, str, name)) > longest:
        raise ValueError(f"{name} has {len(value)} characters, more than {longest}")
    return value


def shown(value: object) -> str:
    """Return a value as text for a sentence, cut to a readable length."""
    if isinstance(value, int) and abs(value) > 10**limits.NUMBER_DIGITS:
        return "a number of too many digits"
    text = repr(value)
    return text if len(text) <= limits.NUMBER_DIGITS else text[: limits.NUMBER_DIGITS] + "…"


def schema(text: str) -> tuple[tuple[str, str], ...]:
    """Return (name, kind) of each column of a layer.

    >>> schema("image text, x real")
    (('image', 'text'), ('x', 'real'))
    """
    return tuple((name, kind) for name, kind in (one.split() for one in text.split(",")))
