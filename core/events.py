"""Events of a process beside QGIS: lines of JSON, which ``processing/base/event_process.py`` reads."""

from __future__ import annotations

import json
import traceback
from collections.abc import Callable

from .errors import SemRefError
from .sentences import english


def report(event: str, **values: object) -> None:
    """Print an event as a line of JSON."""
    print(json.dumps({"event": event, **values}), flush=True)


def reporting_errors(work: Callable[[], None]) -> int:
    """Call ``work`` and report its error. Return the exit status of the process."""
    try:
        work()
    except SemRefError as error:
        sentence = error.sentence
        values = {key: _plain(value) for key, value in sentence.values}
        report("failed", template=sentence.template, values=values, text=english(sentence))
        return 1
    except Exception as error:  # QGIS reports it as a bug
        report("broke", text=traceback.format_exc(), reason=f"{type(error).__name__}: {error}".partition("\n")[0])
        return 2
    return 0


def _plain(value: object) -> object:
    """Return a value of a sentence for JSON."""
    if isinstance(value, (tuple, list)):
        return [_plain(part) for part in value]
    return value if isinstance(value, (int, float)) or value is None else str(value)
