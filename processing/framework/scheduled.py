"""Work that Dask's workers do: ``python -m cluster`` in a process beside QGIS, with QGIS's own Python and packages."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Mapping, Sequence
from contextlib import closing
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any, Callable

from qgis.core import QgsProcessingFeedback
from qgis.PyQt.QtCore import QProcess, QProcessEnvironment

from ...cluster import sentences
from ...core.errors import ParameterError, SemRefError
from ..packages.components import CRYPTOGRAPHY, DASK, require
from ..packages.install import python_candidates
from ..translation import tr
from .base import check_canceled
from .declarations import Text
from .told_process import FAILED, ToldProcess, failure
from .values import Values

if TYPE_CHECKING:
    from ...core.database.model import ReferenceDatabase

__all__ = ["SCHEDULER", "ordered", "require_scheduler", "scheduled", "scheduled_with", "scheduler", "sentences"]
"""The sentences are imported for who words what the process tells."""

SCHEDULER = "SCHEDULER"

_PROGRAM = Path(__file__).resolve().parents[2] / "cluster"
_ASKED_TO_END_MS = 700
_EVENTS = {
    "step": {"text": str, "share": float},
    "info": {"text": str},
    "failed": FAILED,
    "broke": {"reason": str},
    "done": {},
}
"""What cluster/ tells."""

_LOCAL = re.compile(r"local:(\d{1,4})")
_REMOTE = re.compile(r"(tcp|tls|ucx|ws|wss)://[^\s:/]+:\d+/?")


def scheduler() -> Text:
    """Who does the work."""
    return Text(
        SCHEDULER,
        tr("Scheduler"),
        tr(
            "Has the work done by many processes: local:4 starts four on this machine, tcp://ADDRESS:PORT uses the "
            "workers of a Dask scheduler, which read the same files by the same paths. If left out, QGIS does it "
            "itself."
        ),
        optional=True,
        advanced=True,
    )


def require_scheduler(values: Values, others: Sequence[str] = ()) -> None:
    """Raises ParameterError where SCHEDULER can't be what is meant, ComponentError where packages are missing.

    Args:
        values: Of the algorithm.
        others: Keys of what only QGIS can do.
    """
    if not values.has(SCHEDULER):
        return
    given = [key for key in others if values.has(key)]
    if given:
        raise ParameterError("framework.not_scheduled", keys=", ".join(given))
    _workers(values.text(SCHEDULER))
    is_local = _LOCAL.fullmatch(values.text(SCHEDULER).strip())
    require([DASK, CRYPTOGRAPHY] if is_local else [DASK])


def scheduled(
    values: Values, arguments: Sequence[object], feedback: QgsProcessingFeedback, first: float = 0.0
) -> dict[str, Any]:
    """Has a command of ``python -m cluster`` done by the workers of SCHEDULER; returns what came of it.

    Args:
        values: Of the algorithm.
        arguments: The command and its options.
        feedback: Progress is shown up to 100 %.
        first: Percent from which it is.

    Raises:
        SemRefError: It says that it can't go on, or ends without a word.
        Canceled: The user canceled.
    """
    process = QProcess()
    process.setProcessEnvironment(_environment())
    order = [str(_PROGRAM), *map(str, arguments), *_workers(values.text(SCHEDULER)), "--json"]
    process.start(_python(), order)
    if not process.waitForStarted():
        raise SemRefError("cluster.not_started", reason=process.errorString())
    told, result = ToldProcess(process, _EVENTS), None
    try:
        with closing(told.read(feedback)) as events:
            for event in events:
                result = _shown(event, feedback, first) or result
                check_canceled(feedback)
    finally:
        # It clears up what it began, and who asked waits less than a second.
        told.end(_ASKED_TO_END_MS)
    if result is None:
        raise SemRefError("cluster.ended", reason=told.reason or process.errorString())
    return result


def ordered(
    values: Values,
    job: object,
    pieces: Sequence[object],
    feedback: QgsProcessingFeedback,
    database: ReferenceDatabase,
    files: Mapping[str, tuple[int, float]] | None = None,
) -> Any:
    """Has a job done by the workers of SCHEDULER, piece by piece; returns what ``cluster/order.py`` says of it.

    Args:
        values: Of the algorithm.
        job: What is the same for all pieces.
        pieces: What differs.
        feedback: Progress is shown from 0 to 100 %.
        database: As it was read to plan the pieces: workers that find another one refuse.
        files: Others that were read for that, with their ``storage.file_states.state`` before.

    Raises:
        SemRefError: As ``scheduled`` does.
        Canceled: The user canceled.
    """
    from ...storage.carried import read
    from ...storage.file_states import fingerprint

    with TemporaryDirectory(prefix="semref-") as folder:
        found = os.path.join(folder, "found.json")
        content = job, list(pieces), {"database": fingerprint(database), "files": dict(files or {})}
        scheduled_with(values, content, lambda order: ["order", order, "--found", found], feedback)
        return read(found)


def scheduled_with(
    values: Values,
    content: object,
    command: Callable[[str], Sequence[object]],
    feedback: QgsProcessingFeedback,
    first: float = 0.0,
) -> dict[str, Any]:
    """As ``scheduled``, of a command that reads what is written down for it.

    Args:
        values: Of the algorithm.
        content: What is written down, by ``storage.carried``.
        command: Gives the command and its options for the file that holds it.
        feedback: As of ``scheduled``.
        first: As well.
    """
    from ...storage.carried import write

    with TemporaryDirectory(prefix="semref-") as folder:
        order = os.path.join(folder, "order.json")
        write(order, content)
        return scheduled(values, command(order), feedback, first)


def _workers(text: str) -> list[str]:
    """SCHEDULER as options of the command line."""
    text = text.strip()
    local = _LOCAL.fullmatch(text)
    if local and int(local[1]):
        return ["--local", local[1]]
    if not _REMOTE.fullmatch(text):
        raise ParameterError("framework.scheduler", key=SCHEDULER, text=text)
    return ["--scheduler", text]


def _shown(event: dict, feedback: QgsProcessingFeedback, first: float) -> dict[str, Any] | None:
    """Shows an event; the result of the last one. Raises SemRefError for one that tells a failure."""
    kind = event.pop("event")
    if kind == "step":
        feedback.setProgressText(tr(event["text"]))
        feedback.setProgress(first + (100 - first) * event["share"])
    elif kind == "info":
        feedback.pushInfo(event["text"])
    elif kind == "failed":
        raise SemRefError(failure(event, "cluster.ended"))
    elif kind == "broke":
        raise SemRefError("cluster.ended", reason=event["reason"].rstrip("."))
    return event if kind == "done" else None


def _python() -> str:
    candidates = python_candidates(sys.executable or "", sys.prefix, sys.version_info[:2], os.name == "nt")
    return next(filter(os.path.isfile, candidates), "python3")


def _environment() -> QProcessEnvironment:
    """QGIS's own, and its packages: those that SemRef installed lie in its profile."""
    environment = QProcessEnvironment.systemEnvironment()
    environment.insert("PYTHONPATH", os.pathsep.join(path for path in sys.path if os.path.isdir(path)))
    environment.insert("PYTHONIOENCODING", "utf-8")
    environment.insert("PYTHONDONTWRITEBYTECODE", "1")
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        environment.insert(name, "1")
    if os.name == "nt":
        environment.insert("PYTHONUTF8", "1")
    return environment
