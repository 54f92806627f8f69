"""Write and read the label errors of a network: one line in the head of a comparison report, for assessments."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from html import unescape

from ...core import limits
from ...core.errors import ParameterError
from ...core.tables import bytes_of

NAME = "semref-network"
"""Name of the line. Its content is JSON: numbers by the parameter keys of assessments, and LANDMARKS."""

LANDMARKS = "LANDMARKS"

LEAST_LANDMARKS = 20
"""With fewer landmarks, a share of one fifth is uncertain by more than one tenth."""

_HEAD_BYTES = 100_000
"""Bytes to read; the line is in the head of a report."""

_LINE = re.compile(f'<meta name="{NAME}" content="([^"]*)">')


def network_meta(numbers: Mapping[str, float | None], landmarks: int) -> dict[str, str]:
    """Return name and content of the line: percent and m, None for unknown numbers."""
    rounded = {key: None if number is None else round(number, 3) for key, number in numbers.items()}
    return {NAME: json.dumps({LANDMARKS: landmarks, **rounded})}


def read_network(path: str) -> dict[str, float]:
    """Return the known numbers by key.

    Raises:
        ParameterError: The file is not such a report, can't be read, or has too few landmarks.
    """
    no_report = ParameterError(
        "{path} is not a report of “Compare label maps” with landmarks. Run “Compare label maps” with a report, and "
        "choose its page as comparison report.",
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
            "{path} compares only {count} landmarks; at least {least} are needed. Compare a larger area, or leave "
            "“Comparison report” empty.",
            path=path,
            count=landmarks,
            least=LEAST_LANDMARKS,
        )
    return numbers
