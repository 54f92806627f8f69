"""SCHEDULER: Dask workers do tasks, through a process beside QGIS with QGIS's Python and packages."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessingFeedback, QgsProcessingParameterDefinition, QgsProcessingParameterString
from qgis.PyQt.QtCore import QProcess, QProcessEnvironment

from ...core.errors import ParameterError, SemRefError
from ..packages.components import CRYPTOGRAPHY, DASK, require
from ..packages.install import python_candidates
from ..translation import tr
from .algorithm import check_canceled
from .event_process import PROGRAM, EventProcess, failure, python_environment
from .parameters import with_help
from .values import Values

if TYPE_CHECKING:
    from ...core.database.model import ReferenceDatabase

SCHEDULER = "SCHEDULER"

_ASKED_TO_END_MS = 700
_WRITTEN_WITHIN_MS = 5000
_LOCAL = re.compile(r"local:(\d{1,4})")
_REMOTE = re.compile(r"(tcp|tls|ucx|ws|wss)://[^\s:/]+:\d+/?")


def scheduler() -> QgsProcessingParameterDefinition:
    return with_help(
        QgsProcessingParameterString(SCHEDULER, "Scheduler", optional=True),
        "Processes that do the work. local:4 starts four processes on this computer. tcp://ADDRESS:PORT uses the "
        "workers of a Dask scheduler, which must read the same files under the same paths. If not set, QGIS does "
        "the work.",
        advanced=True,
    )


def require_scheduler(values: Values, others: Sequence[str] = ()) -> None:
    """Raises ParameterError for an invalid SCHEDULER, ComponentError if packages are missing.

    Args:
        others: Keys that only QGIS can process.
    """
    if not values.has(SCHEDULER):
        return
    given = [key for key in others if values.has(key)]
    if given:
        titles = ", ".join(f"“{values.title(key)}”" for key in given)
        raise ParameterError("“Scheduler” cannot be used together with {keys}. Leave one of them empty.", keys=titles)
    wanted = _workers(values.text(SCHEDULER))
    require([DASK, CRYPTOGRAPHY] if wanted["local"] else [DASK])


class Workers:
    """The workers of SCHEDULER: a ``core.database.tasks.Runner``."""

    def __init__(self, process: QProcess, folder: str, feedback: QgsProcessingFeedback) -> None:
        self.reports = EventProcess(process)
        self._process, self._folder, self._feedback = process, folder, feedback
        self._events = self.reports.read(feedback)

    def __call__(self, task: str, calls: Iterable[tuple], shared: tuple = ()) -> Iterator[Any]:
        """Yield the result of each call in the order of the calls.

        Raises:
            SemRefError: A task or the process fails, or the process ends.
        """
        from ...storage.serialization import read, write

        common, waiting, given = os.path.join(self._folder, "shared"), iter(calls), 0
        write(common, shared)
        self._send({"task": task, "shared": common})
        while (event := self._next())["event"] != "end":
            if event["event"] == "next":
                call, file = next(waiting, None), None
                if call is not None:
                    file = os.path.join(self._folder, f"call_{given}")
                    write(file, call)
                    given += 1
                self._send(file)
            elif event["event"] == "result":
                # Only files in the folder of this run are read and removed, whatever the process reports.
                file = os.path.join(self._folder, f"result_{int(event['number'])}")
                result = read(file)
                os.unlink(file)
                yield result

    def answers(
        self, task: str, job: object, pieces: Sequence[Any], database: ReferenceDatabase, at_once: int = 1
    ) -> Iterator[Any]:
        """Yield the results of all pieces of a job in their order.

        Args:
            task: A name of ``cluster.task_names``.
            database: Database of the plan: workers refuse another one.
            at_once: Pieces in one task.

        Raises:
            SemRefError: See ``__call__``.
        """
        from ...storage.file_states import fingerprint
        from ...storage.serialization import from_bytes, to_bytes

        calls = ((to_bytes(list(pieces[n : n + at_once])),) for n in range(0, len(pieces), at_once))
        for found in self(task, calls, (to_bytes((job, fingerprint(database))),)):
            yield from from_bytes(found)

    def wait(self) -> None:
        """Wait for the workers; raises as ``__call__`` does."""
        while self._next()["event"] != "ready":
            pass

    def _send(self, value: object) -> None:
        self._process.write(json.dumps(value).encode("ascii") + b"\n")
        self._process.waitForBytesWritten(_WRITTEN_WITHIN_MS)

    def _next(self) -> dict[str, Any]:
        """Return the next event; show messages for the user first."""
        for event in self._events:
            check_canceled(self._feedback)
            if event["event"] == "info":
                self._feedback.pushInfo(event["text"])
            elif event["event"] == "failed":
                raise SemRefError(failure(event))
            elif event["event"] == "broke":
                raise _ended(event["reason"].rstrip("."))
            else:
                return event
        raise _ended(self.reports.reason or self._process.errorString())

    def close(self) -> None:
        """End the process, which cleans up; this takes less than a second."""
        self._events.close()
        self.reports.end(_ASKED_TO_END_MS)


def _ended(reason: str) -> SemRefError:
    return SemRefError("The process of the workers ended ({reason}). Run the algorithm again.", reason=reason)


@contextmanager
def workers(
    values: Values, feedback: QgsProcessingFeedback, files: Mapping[str, tuple[int, float]], labels: str = ""
) -> Iterator[Workers | None]:
    """Yield the workers of SCHEDULER; None if it is not set.

    Args:
        files: Files that workers read, with their ``storage.file_states.state`` before they were read here.
        labels: The label map, for tasks of ``core.database.tasks``.

    Raises:
        SemRefError: There are no workers, or a file was changed.
    """
    from ...storage.file_states import require_unchanged

    if not values.has(SCHEDULER):
        yield None
        return
    process = QProcess()
    process.setProcessEnvironment(_environment())
    with TemporaryDirectory(prefix="semref-") as folder:
        order = os.path.join(folder, "order.json")
        content = {**_workers(values.text(SCHEDULER)), "labels": labels, "folder": folder}
        Path(order).write_text(json.dumps(content), encoding="utf-8")
        process.start(_python(), [str(PROGRAM), "cluster.service", order])
        if not process.waitForStarted():
            raise SemRefError(
                "The process of the workers cannot be started ({reason}). Leave “Scheduler” empty, so that QGIS does "
                "the work.",
                reason=process.errorString(),
            )
        with closing(Workers(process, folder, feedback)) as run:
            run.wait()
            require_unchanged(files)
            yield run
            # Each worker opens them at another time.
            require_unchanged(files)


def with_progress(
    found: Iterator[Any], count: int, feedback: QgsProcessingFeedback, first: float, last: float
) -> Iterator[Any]:
    """Yield the same ``count`` answers and show progress from ``first`` to ``last`` percent."""
    for n, one in enumerate(found, start=1):
        feedback.setProgress(first + (last - first) * n / count)
        yield one


def _workers(text: str) -> dict[str, Any]:
    """Parse SCHEDULER for ``cluster/service.py``."""
    text = text.strip()
    local = _LOCAL.fullmatch(text)
    if local and int(local[1]):
        return {"scheduler": None, "local": int(local[1])}
    if not _REMOTE.fullmatch(text):
        raise ParameterError(
            "“{key}” is “{text}”, which is not a scheduler. Enter local: and a number of processes (local:4), or the "
            "address of a Dask scheduler (tcp://10.0.0.5:8786).",
            key=tr("Scheduler"),
            text=text,
        )
    return {"scheduler": text, "local": None}


def _python() -> str:
    candidates = python_candidates(sys.executable or "", sys.prefix, sys.version_info[:2], os.name == "nt")
    return next(filter(os.path.isfile, candidates), "python3")


def _environment() -> QProcessEnvironment:
    """Return QGIS's environment with its Python path, which includes the packages that SemRef installed."""
    environment = python_environment()
    environment.insert("PYTHONPATH", os.pathsep.join(path for path in sys.path if os.path.isdir(path)))
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        environment.insert(name, "1")
    return environment
