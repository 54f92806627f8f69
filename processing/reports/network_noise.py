"""How poor a network's labels are, as one line in the head of a comparison's report that assessments read again."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from html import unescape

from ...core import limits
from ...core.errors import ParameterError
from ...core.flight.table import bytes_of

NAME = "semref-network"
"""Of the line. Its content is JSON: numbers by the keys that assessments have for them, and LANDMARKS."""

LANDMARKS = "LANDMARKS"

LEAST_LANDMARKS = 20
"""With fewer a share of a fifth is not known to a tenth."""

_HEAD_BYTES = 100_000
"""The line stands in a report's head; what else somebody gives is read no further."""

_LINE = re.compile(f'<meta name="{NAME}" content="([^"]*)">')


def network_meta(numbers: Mapping[str, float | None], landmarks: int) -> dict[str, str]:
    """Name and content of the line: percent and map units, None for what the maps don't tell."""
    content = {LANDMARKS: landmarks, **{key: _rounded(number) for key, number in numbers.items()}}
    return {NAME: json.dumps(content)}


def read_network(path: str) -> dict[str, float]:
    """The numbers by key; those that the maps did not tell are left out.

    Raises ParameterError for a file that is no such report or can't be read, and for one of too few landmarks.
    """
    no_report = ParameterError(
        "{path} is no report of “Compare label maps” that tells of landmarks; run that with REPORT and give its "
        "page as COMPARISON.",
        path=path,
    )
    try:
        text = bytes_of(path, limits.COMPARISON_BYTES, _HEAD_BYTES).decode("utf-8", errors="replace")
    except ParameterError:
        raise no_report from None
    line = _LINE.search(text)
    try:
        content = json.loads(unescape(line[1]) if line else "")
        landmarks = int(content.pop(LANDMARKS))
        numbers = {str(key): float(number) for key, number in content.items() if number is not None}
    except (ValueError, TypeError, AttributeError, KeyError, RecursionError, OverflowError):
        raise no_report from None
    if not all(0 <= number < math.inf for number in numbers.values()):
        raise no_report
    if landmarks < LEAST_LANDMARKS:
        raise ParameterError(
            "{path} compares {count} landmarks, and fewer than {least} tell little of a network; compare a larger "
            "area, or leave COMPARISON empty.",
            path=path,
            count=landmarks,
            least=LEAST_LANDMARKS,
        )
    return numbers


def _rounded(number: float | None) -> float | None:
    return None if number is None else round(number, 3)
