"""Have workers do the tasks that QGIS asks for, and report what comes of them as a line of JSON each.

QGIS writes lines to this process: a task (``task``, ``in_order``, and ``shared``, the file of what all its calls
share), and then, whenever it reads “next”, the file of a call's arguments or null for the end. Result number N
goes into the file ``result_N`` of the order's folder. All files are of ``storage.serialization``.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ..core.errors import SemRefError
from ..storage.serialization import read, write
from .engine import DaskRunner, connected

DONE, REFUSED, INTERRUPTED = 0, 3, 130
"""Exit codes."""


def main(path: str) -> int:
    """Serve until the input ends; ``path``: a JSON with ``scheduler`` or ``local``, ``labels`` and ``folder``."""
    # QGIS ends it so.
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, _interrupted)
    try:
        order = json.loads(Path(path).read_text(encoding="utf-8"))
        with connected(order["scheduler"], order["local"], lambda text: _report("info", text=text)) as client:
            runner = DaskRunner(client, order["labels"])
            _report("ready")
            while (asked := _line()) is not None:
                _do(asked, runner, Path(order["folder"]))
    except SemRefError as error:
        sentence = error.sentence
        values = {key: _plain(value) for key, value in sentence.values}
        _report("failed", template=sentence.template, values=values)
        return REFUSED
    except KeyboardInterrupt:
        return INTERRUPTED
    except Exception as error:
        _report("broke", reason=f"{type(error).__name__}: {error}".partition("\n")[0])
        return REFUSED
    return DONE


def _do(asked: dict[str, Any], runner: DaskRunner, folder: Path) -> None:
    """Have all calls of a task done."""
    shared = read(asked["shared"])
    found = (
        enumerate(runner.in_order(asked["task"], _calls(), shared))
        if asked["in_order"]
        else runner(asked["task"], _calls(), shared)
    )
    for number, result in found:
        write(str(folder / f"result_{number}"), result)
        _report("result", number=number)
    _report("end")


def _calls() -> Iterator[tuple]:
    """Arguments, asked for when there is room for another task."""
    while True:
        _report("next")
        file = _line()
        if file is None:
            return
        arguments = read(file)
        os.unlink(file)
        yield arguments


def _line() -> Any:
    """What QGIS writes next; None at the end. Raises KeyboardInterrupt when it was asked to end."""
    if _asked_to_end:
        # Once more: one that meets Python while it clears up an object is lost.
        raise KeyboardInterrupt
    line = sys.stdin.readline()
    return json.loads(line) if line else None


_asked_to_end: list[bool] = []


def _interrupted(*_: object) -> None:
    _asked_to_end.append(True)
    raise KeyboardInterrupt


def _report(event: str, **values: object) -> None:
    # A closed output must not change what is done.
    with contextlib.suppress(OSError):
        print(json.dumps({"event": event, **values}), flush=True)


def _plain(value: object) -> object:
    """A value of a sentence as JSON has it."""
    if isinstance(value, (tuple, list)):
        return [_plain(part) for part in value]
    return value if isinstance(value, (int, float)) or value is None else str(value)
