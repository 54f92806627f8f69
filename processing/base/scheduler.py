"""SCHEDULER: tasks that Dask's workers do, through a process beside QGIS that has QGIS's own Python and packages."""

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
from .event_process import FAILED, EventProcess, failure, python_environment
from .parameters import with_help
from .values import Values

if TYPE_CHECKING:
    from ...core.database.model import ReferenceDatabase

__all__ = ["SCHEDULER", "Workers", "with_progress", "require_scheduler", "scheduler", "workers"]

SCHEDULER = "SCHEDULER"

_PROGRAM = Path(__file__).resolve().parents[2] / "cluster"
_ASKED_TO_END_MS = 700
_WRITTEN_WITHIN_MS = 5000
_EVENTS = {
    "ready": {},
    "info": {"text": str},
    "next": {},
    "result": {"number": int},
    "end": {},
    "failed": FAILED,
    "broke": {"reason": str},
}
"""What cluster/service.py reports."""

_LOCAL = re.compile(r"local:(\d{1,4})")
_REMOTE = re.compile(r"(tcp|tls|ucx|ws|wss)://[^\s:/]+:\d+/?")


def scheduler() -> QgsProcessingParameterDefinition:
    """Who does the work."""
    return with_help(
        QgsProcessingParameterString(SCHEDULER, tr("Scheduler"), optional=True),
        tr(
            "Has the work done by many processes: local:4 starts four on this machine, tcp://ADDRESS:PORT uses the "
            "workers of a Dask scheduler, which read the same files by the same paths. If left out, QGIS does it "
            "itself."
        ),
        advanced=True,
    )


def require_scheduler(values: Values, others: Sequence[str] = ()) -> None:
    """Raises ParameterError where SCHEDULER can't be what is meant, ComponentError where packages are missing.

    Args:
        others: Keys of what only QGIS can do.
    """
    if not values.has(SCHEDULER):
        return
    given = [key for key in others if values.has(key)]
    if given:
        raise ParameterError(
            "{keys} can't be used together with SCHEDULER; leave them or SCHEDULER out.", keys=", ".join(given)
        )
    _workers(values.text(SCHEDULER))
    is_local = _LOCAL.fullmatch(values.text(SCHEDULER).strip())
    require([DASK, CRYPTOGRAPHY] if is_local else [DASK])


class Workers:
    """Those of SCHEDULER: a ``core.database.tasks.Runner``."""

    def __init__(self, process: QProcess, folder: str, feedback: QgsProcessingFeedback) -> None:
        """Nothing is asked yet.

        Args:
            process: Was started.
            folder: Of files that go to and fro.
            feedback: Takes what the process reports.
        """
        self.reports = EventProcess(process, _EVENTS)
        self._process, self._folder, self._feedback = process, folder, feedback
        self._events = self.reports.read(feedback)

    def __call__(self, task: str, calls: Iterable[tuple], shared: tuple = ()) -> Iterator[tuple[int, Any]]:
        """Yields the number of a call and what it gave, as they are done.

        Raises:
            SemRefError: A task or the process reports a failure, or the process ends without a word.
            Canceled: The user canceled.
        """
        return self._run(task, calls, shared, False)

    def in_order(self, task: str, calls: Iterable[tuple], shared: tuple = ()) -> Iterator[Any]:
        """Yields what calls gave, in their order; raises as ``__call__`` does."""
        return (result for _, result in self._run(task, calls, shared, True))

    def answers(
        self, task: str, job: object, pieces: Sequence[Any], database: ReferenceDatabase, at_once: int = 1
    ) -> Iterator[Any]:
        """Yields what workers found of each piece of a job, in their order.

        Args:
            task: One of ``cluster.task_names``.
            job: What is the same for all pieces.
            pieces: What differs.
            database: By which pieces were planned: workers that read another one refuse.
            at_once: Pieces of one task.

        Raises:
            SemRefError: As of ``__call__``.
            Canceled: The user canceled.
        """
        from ...storage.file_states import fingerprint
        from ...storage.serialization import from_bytes, to_bytes

        calls = ((to_bytes(list(pieces[n : n + at_once])),) for n in range(0, len(pieces), at_once))
        for found in self.in_order(task, calls, (to_bytes((job, fingerprint(database))),)):
            yield from from_bytes(found)

    def wait(self) -> None:
        """Until there are workers; raises as ``__call__`` does."""
        while self._next()["event"] != "ready":
            pass

    def _run(self, task: str, calls: Iterable[tuple], shared: tuple, in_order: bool) -> Iterator[tuple[int, Any]]:
        from ...storage.serialization import read, write

        common, waiting, given = os.path.join(self._folder, "shared"), iter(calls), 0
        write(common, shared)
        self._tell({"task": task, "shared": common, "in_order": in_order})
        while (event := self._next())["event"] != "end":
            if event["event"] == "next":
                call, file = next(waiting, None), None
                if call is not None:
                    file = os.path.join(self._folder, f"call_{given}")
                    write(file, call)
                    given += 1
                self._tell(file)
            elif event["event"] == "result":
                # Only a file of this run's own folder is read and removed, whatever the process reports.
                file = os.path.join(self._folder, f"result_{event['number']}")
                result = read(file)
                os.unlink(file)
                yield event["number"], result

    def _tell(self, value: object) -> None:
        self._process.write(json.dumps(value).encode("ascii") + b"\n")
        self._process.waitForBytesWritten(_WRITTEN_WITHIN_MS)

    def _next(self) -> dict[str, Any]:
        """The next event; one that is for the user is shown before."""
        for event in self._events:
            check_canceled(self._feedback)
            if event["event"] == "info":
                self._feedback.pushInfo(event["text"])
            elif event["event"] == "failed":
                raise SemRefError(failure(event))
            elif event["event"] == "broke":
                raise SemRefError(
                    "The process that does the work ended ({reason}); start it again.",
                    reason=event["reason"].rstrip("."),
                )
            else:
                return event
        raise SemRefError(
            "The process that does the work ended ({reason}); start it again.",
            reason=self.reports.reason or self._process.errorString(),
        )

    def close(self) -> None:
        """End the process: it clears up what it began, and who asked waits less than a second."""
        self._events.close()
        self.reports.end(_ASKED_TO_END_MS)


@contextmanager
def workers(
    values: Values, feedback: QgsProcessingFeedback, files: Mapping[str, tuple[int, float]], labels: str = ""
) -> Iterator[Workers | None]:
    """Those of SCHEDULER; None where it is not given.

    Args:
        feedback: Takes what the process reports.
        files: That workers read, with their ``storage.file_states.state`` before they were read here.
        labels: The label map, for tasks of ``core.database.tasks``.

    Raises:
        SemRefError: There are no workers, or a file changed meanwhile.
        Canceled: The user canceled.
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
        process.start(_python(), [str(_PROGRAM), order])
        if not process.waitForStarted():
            raise SemRefError("Workers can't be started here ({reason}).", reason=process.errorString())
        with closing(Workers(process, folder, feedback)) as run:
            run.wait()
            require_unchanged(files)
            yield run
            # Workers open them each at its time.
            require_unchanged(files)


def with_progress(
    found: Iterator[Any], count: int, feedback: QgsProcessingFeedback, first: float, last: float
) -> Iterator[Any]:
    """The same ``count`` answers, with progress from ``first`` to ``last`` percent."""
    for n, one in enumerate(found, start=1):
        feedback.setProgress(first + (last - first) * n / count)
        yield one


def _workers(text: str) -> dict[str, Any]:
    """SCHEDULER as ``cluster/service.py`` has it."""
    text = text.strip()
    local = _LOCAL.fullmatch(text)
    if local and int(local[1]):
        return {"scheduler": None, "local": int(local[1])}
    if not _REMOTE.fullmatch(text):
        raise ParameterError(
            "{key} is “{text}”; give local: and a number of processes, such as local:4, or the address of a "
            "scheduler, such as tcp://10.0.0.5:8786.",
            key=SCHEDULER,
            text=text,
        )
    return {"scheduler": text, "local": None}


def _python() -> str:
    candidates = python_candidates(sys.executable or "", sys.prefix, sys.version_info[:2], os.name == "nt")
    return next(filter(os.path.isfile, candidates), "python3")


def _environment() -> QProcessEnvironment:
    """QGIS's own, and its packages: those that SemRef installed lie in its profile."""
    environment = python_environment()
    environment.insert("PYTHONPATH", os.pathsep.join(path for path in sys.path if os.path.isdir(path)))
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        environment.insert(name, "1")
    return environment
