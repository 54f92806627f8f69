"""The folder of a training beside its model: its tiles and its state, so that it can be continued."""

from __future__ import annotations

import hashlib
import os
import secrets
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from qgis.core import QgsSettings

from ...core.errors import ParameterError
from ...training.job import CHECKPOINT, JOB, Job, read_job
from ..base.algorithm import Canceled
from ..translation import tr
from .chain import take_lock

_SETTING = "semref/trainings/"
_PROOF = "made_by_semref"
"""File in the folder with the secret."""

_LOCK = "running.lock"
"""File in the folder while a QGIS trains."""


class CanceledKeeping(Canceled):
    """The user canceled; the state of the training is stored."""

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self.folder = folder

    def message(self) -> str:
        text = tr(
            "Canceled. The state of the training is saved in {folder}. Run it again with the same output to continue."
        )
        return text.format(folder=self.folder)


class TrainingRun:
    """A folder ``MODEL.training-…`` beside a model; ``close`` removes it unless the training can be continued.

    The user's settings contain its name and a secret that is also in the folder: a folder that SemRef did not make is
    neither used nor removed, whatever its name and its files.
    """

    def __init__(self, model: str, resume: bool) -> None:
        """Make the folder, or find an earlier run to continue.

        Args:
            resume: Whether an earlier run is continued; otherwise it is removed.

        Raises:
            ParameterError: Another training of this model runs in this or another QGIS.
            OSError: The folder cannot be made.
        """
        path = Path(model).absolute()
        self._setting = _SETTING + hashlib.sha256(os.fsencode(path)).hexdigest()
        self._prefix = f"{path.stem}.training-"
        name, _, self._secret = QgsSettings().value(self._setting, "", type=str).rpartition(" ")
        self.folder = path.parent / name
        if self._is_ours:
            self._take_lock(path)
        if not (self._is_ours and resume and self.can_go_on):
            self.clear()
            self.folder = Path(tempfile.mkdtemp(prefix=self._prefix, dir=path.parent))
            self._secret = secrets.token_hex()
            (self.folder / _PROOF).write_text(self._secret, encoding="ascii")
            QgsSettings().setValue(self._setting, f"{self.folder.name} {self._secret}")
            self._take_lock(path)

    def _take_lock(self, model: Path) -> None:
        """Reserve the folder. Raises ParameterError if another training uses it."""
        lock = take_lock(self.folder / _LOCK)
        if lock is None:
            raise ParameterError(
                "Another training of {path} is running. Wait for it, cancel it, or select another output file.",
                path=model,
            )
        self._lock = lock

    @property
    def _is_ours(self) -> bool:
        """Whether SemRef made the folder, for this model and this user."""
        proof = self.folder / _PROOF
        if not self.folder.name.startswith(self._prefix) or self.folder.is_symlink() or not proof.is_file():
            return False
        return proof.read_bytes() == self._secret.encode()

    @property
    def can_go_on(self) -> bool:
        """Whether an epoch was finished."""
        return (self.folder / CHECKPOINT).is_file()

    @property
    def tiles(self) -> Path:
        """Folder of the tiles, once all are cut."""
        return self.folder / "tiles"

    @contextmanager
    def new_tiles(self) -> Iterator[Path]:
        """Yield a folder to cut the tiles into, which then becomes ``tiles``."""
        folder = self.folder / "new_tiles"
        folder.mkdir()
        yield folder
        folder.replace(self.tiles)

    def begin(self, job: Job) -> Job:
        """Store what is to be trained.

        Returns:
            The job; with the description of the ground of an earlier run.

        Raises:
            ParameterError: The earlier run has other settings.
        """
        if self.can_go_on:
            job = replace(job, ground=self._same(job).ground)
        job.write(self.folder / JOB)
        return job

    def _same(self, job: Job) -> Job:
        """Return the earlier run, which must have the same settings."""
        try:
            earlier = read_job(self.folder / JOB)
            differing = job.differences(earlier)
        except ValueError:
            differing = [JOB]
        if differing:
            titles = {
                "base_model": tr("Base model"),
                "encoder": tr("Network"),
                "learn_unlabeled": tr("Ground without a label"),
                "fingerprint": tr("input layers, extent, mask or resolution"),
            }
            settings = tuple(titles.get(name, name) for name in differing)
            raise ParameterError(
                "{folder} contains a canceled training with different settings: {settings}. Use the same settings, "
                "select another output, or turn off “Continue a canceled run”.",
                folder=self.folder,
                settings=settings,
            )
        return earlier

    def clear(self) -> None:
        """Remove the folder, if SemRef made it."""
        if self._is_ours:
            self._lock.unlock()
            # Files in use stay, so that a finished model is not lost.
            shutil.rmtree(self.folder, ignore_errors=True)
            QgsSettings().remove(self._setting)

    def close(self) -> None:
        """Remove the folder unless the training can be continued."""
        self._lock.unlock()
        if not self.can_go_on:
            self.clear()
