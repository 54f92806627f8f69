"""Run algorithms one after the other into a folder, so that a canceled chain can be continued."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsApplication,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
)
from qgis.PyQt.QtCore import QLockFile

from ...core.errors import ParameterError
from ...storage.atomic_output import written_beside
from ..base.algorithm import Canceled
from ..base.destinations import require_outputs_apart
from ..translation import tr

RECORD = "semref_setup.json"
"""File of the folder that records which inputs each file was made from."""

_LOCK = "semref_setup.lock"
"""File of the folder during a run."""


class CanceledInFolder(Canceled):
    """The user canceled; complete files remain in the folder."""

    def message(self) -> str:
        return tr("Canceled. Complete files remain in the folder. Run it again with the same values to continue.")


@dataclass(frozen=True)
class Step:
    """One algorithm of the chain.

    Attributes:
        algorithm: Its id in SemRef.
        files: Names of its files in the folder; the first one shows that it was run.
    """

    algorithm: str
    values: dict[str, Any]
    files: tuple[str, ...]
    text: str

    def require_possible(self, context: QgsProcessingContext) -> None:
        """Raise ParameterError for an output that would be refused when the step starts."""
        require_outputs_apart(self._new(), self.values, context, {})

    def run(self, values: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
        """Run the algorithm; ``values`` replace or add parameters.

        Raises:
            QgsProcessingException: What the algorithm raises.
        """
        try:
            self._new().run({**self.values, **values}, context, feedback, {}, False)
        except QgsProcessingException:
            if feedback.isCanceled():
                raise CanceledInFolder from None
            raise

    def _new(self) -> QgsProcessingAlgorithm:
        return QgsApplication.processingRegistry().createAlgorithmById(f"semref:{self.algorithm}")


class Record:
    """Which files of the folder this algorithm made, and from which inputs; stored in the folder.

    Files without an entry belong to the user and are never replaced. As a context manager, it keeps other runs out of
    the folder.
    """

    def __init__(self, folder: Path, inputs: Sequence[Any]) -> None:
        """Read the record. Raises ParameterError for a foreign file of that name, and if a run uses the folder."""
        self._folder, self._inputs = folder, inputs
        self._made: dict[str, list] = {}
        self._lock = take_lock(folder / _LOCK)
        if self._lock is None:
            raise ParameterError(
                "Another run of “Set up an area” is using {folder}. Wait for it, cancel it, or choose another folder.",
                folder=folder,
            )
        if (folder / RECORD).exists():
            try:
                self._made = dict(json.loads((folder / RECORD).read_text(encoding="utf-8"))["made"])
            except (OSError, ValueError, KeyError, TypeError):
                raise _foreign(folder / RECORD) from None

    def __enter__(self) -> Record:
        return self

    def __exit__(self, *_: object) -> None:
        self._lock.unlock()

    def require_own(self, name: str) -> None:
        """Raise ParameterError for a file that exists and that this algorithm did not make as it is."""
        path = self._folder / name
        if os.path.lexists(path) and self._made.get(name, [None])[0] != _state(path):
            raise _foreign(path)

    def require_free(self, step: Step) -> None:
        """Raise ParameterError if a file of a step exists, unless ``has`` would return True."""
        for name in step.files:
            self.require_own(name)
            if os.path.lexists(self._folder / name) and not self.has(step):
                raise _foreign(self._folder / name)

    def has(self, step: Step) -> bool:
        """Return whether all files of a step were made from the same inputs and have not changed since."""
        wanted = self._key(step)
        return all(self._made.get(name) == [_state(self._folder / name), wanted] for name in step.files)

    def add(self, step: Step) -> None:
        for name in step.files:
            self._made[name] = [_state(self._folder / name), self._key(step)]
        self._save()

    def write(self, name: str, text: str) -> None:
        """Write a small file. Raises ParameterError if another one exists that this algorithm did not make."""
        self.require_own(name)
        with written_beside(str(self._folder / name)) as path:
            Path(path).write_text(text, encoding="utf-8")
        self._made[name] = [_state(self._folder / name), ""]
        self._save()

    def _save(self) -> None:
        with written_beside(str(self._folder / RECORD)) as path:
            Path(path).write_text(json.dumps({"made": self._made}, indent=1), encoding="utf-8")

    def _key(self, step: Step) -> str:
        # Layer, extent and CRS are not JSON; the inputs identify them.
        text = json.dumps([step.algorithm, step.values, self._inputs], sort_keys=True, default=lambda _: "")
        return hashlib.sha256(text.encode()).hexdigest()


def _state(path: Path) -> list:
    """Return size and time of a file; None without one."""
    found = os.lstat(path) if os.path.lexists(path) else None
    return [found.st_size, found.st_mtime_ns] if found else [None]


def _foreign(path: Path) -> ParameterError:
    return ParameterError(
        "{path} exists and was not made by a run with the same values. Choose another folder, or remove the file.",
        path=path,
    )


def take_lock(path: Path) -> QLockFile | None:
    """Make a lock file. Return None if a run of this or another QGIS has it.

    ``unlock`` removes the file, and Qt ignores that of a process that has ended. Where no file can be made, no run is
    excluded.
    """
    lock = QLockFile(str(path))
    lock.setStaleLockTime(0)
    is_free = lock.tryLock(0) or lock.error() != QLockFile.LockError.LockFailedError
    return lock if is_free else None
