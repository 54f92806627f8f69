"""Execute the tasks of QGIS on workers, and report results as lines of JSON.

QGIS writes lines to this process. The first line of a task has ``task`` and ``shared``, the file with the arguments
that all calls share. After each “next”, QGIS writes the file with the arguments of a call, or null at the end. Result N
is written to the file ``result_N`` in the folder of the order. All files are in the format of
``storage.serialization``.
"""

from __future__ import annotations

import json
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ..core.events import report, reporting_errors
from ..storage.serialization import read, write
from .engine import DaskRunner, connect

_INTERRUPTED = 130
"""Exit status."""


def main(arguments: list[str]) -> int:
    """Serve until the input ends, and return the exit status.

    ``arguments``: a JSON file with ``scheduler`` or ``local``, ``labels`` and ``folder``.
    """
    # QGIS ends this process with a signal.
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, _interrupt)
    try:
        return reporting_errors(lambda: _serve(json.loads(Path(arguments[0]).read_text(encoding="utf-8"))))
    except KeyboardInterrupt:
        # Dask takes seconds to close.
        os._exit(_INTERRUPTED)


def _serve(order: dict[str, Any]) -> None:
    with connect(order["scheduler"], order["local"], lambda text: report("info", text=text)) as client:
        runner = DaskRunner(client, order["labels"])
        report("ready")
        while (asked := _line()) is not None:
            _do(asked, runner, Path(order["folder"]))


def _do(asked: dict[str, Any], runner: DaskRunner, folder: Path) -> None:
    for number, result in enumerate(runner(asked["task"], _calls(), read(asked["shared"]))):
        write(str(folder / f"result_{number}"), result)
        report("result", number=number)
    report("end")


def _calls() -> Iterator[tuple]:
    """Yield the arguments of calls, requested when another task can be submitted."""
    while True:
        report("next")
        file = _line()
        if file is None:
            return
        arguments = read(file)
        os.unlink(file)
        yield arguments


def _line() -> Any:
    """Return the next line of QGIS; None at the end. Raises KeyboardInterrupt after a signal."""
    if _asked_to_end:
        # Raise again: Python drops an exception that a signal raises inside a destructor.
        raise KeyboardInterrupt
    line = sys.stdin.readline()
    return json.loads(line) if line else None


_asked_to_end: list[bool] = []


def _interrupt(*_: object) -> None:
    _asked_to_end.append(True)
    raise KeyboardInterrupt
