"""The folder of a training beside its model: what was cut, and how far it is, so that it can be gone on with."""

from __future__ import annotations

import hashlib
import os
import secrets
import shutil
import tempfile
from dataclasses import replace
from pathlib import Path

from qgis.core import QgsSettings

from ...core.errors import ParameterError
from ...training.job import CHECKPOINT, JOB, Job, read_job
from ..translation import tr
from .algorithm import Canceled

_KEYS = {
    "base_model": "BASE_MODEL",
    "encoder": "NETWORK",
    "learn_unlabeled": "UNLABELED",
    "fingerprint": "IMAGE, LABELS, …",
}
"""What the user calls the settings by which two runs differ."""


_RUNNING: set[Path] = set()
"""Models that are being trained now."""

_SETTING = "semref/trainings/"
_PROOF = "made_by_semref"
"""A file in the folder that holds the secret."""


class CanceledKeeping(Canceled):
    """The user canceled; what was trained so far is kept."""

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self.folder = folder

    def message(self) -> str:
        """What the user is told, in their language."""
        text = tr("Canceled; what was trained is kept in {folder}: run it again with the same output to go on.")
        return text.format(folder=self.folder)


class TrainingRun:
    """A folder ``MODEL.training-…`` beside a model; ``close`` removes it unless there is something to go on with.

    The user's settings keep its name and a secret that is also in the folder: a folder that SemRef did not make is
    neither used nor removed, whatever its name and its files.
    """

    def __init__(self, model: str, resume: bool) -> None:
        """Makes the folder, or finds an earlier run that can be gone on with.

        Args:
            model: Path of the model.
            resume: Whether an earlier run is gone on with; otherwise it is removed.

        Raises:
            ParameterError: Another training of this model runs in this QGIS.
            OSError: The folder can't be made.
        """
        self._model = path = Path(model).absolute()
        if path in _RUNNING:
            raise ParameterError(
                "{path} is being trained already; wait for that training, cancel it, or choose another file.", path=path
            )
        self._setting = _SETTING + hashlib.sha256(os.fsencode(path)).hexdigest()
        self._prefix = f"{path.stem}.training-"
        name, _, self._secret = QgsSettings().value(self._setting, "", type=str).rpartition(" ")
        self.folder = path.parent / name
        if not (self._is_ours and resume and self.can_go_on):
            self.clear()
            self.folder = Path(tempfile.mkdtemp(prefix=self._prefix, dir=path.parent))
            self._secret = secrets.token_hex()
            (self.folder / _PROOF).write_text(self._secret, encoding="ascii")
            QgsSettings().setValue(self._setting, f"{self.folder.name} {self._secret}")
        _RUNNING.add(path)

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
    def labels(self) -> Path:
        """Where labels are burnt on the image's pixels."""
        return self.folder / "labels.tif"

    @property
    def tiles(self) -> Path:
        """The tiles, once all are cut."""
        return self.folder / "tiles"

    @property
    def new_tiles(self) -> Path:
        """Where tiles are being cut."""
        return self.folder / "new_tiles"

    @property
    def has_tiles(self) -> bool:
        """Whether all tiles are cut."""
        return self.tiles.is_dir()

    def keep_tiles(self) -> None:
        """Says that all tiles are cut."""
        self.new_tiles.replace(self.tiles)

    def begin(self, job: Job) -> Job:
        """Keeps what is to be trained.

        Returns:
            The job; of an earlier run it has what is told of its ground.

        Raises:
            ParameterError: The earlier run has other settings.
        """
        if self.can_go_on:
            job = replace(job, ground=self._same(job).ground)
        job.write(self.folder / JOB)
        return job

    def _same(self, job: Job) -> Job:
        """The earlier run, which must have the same settings."""
        try:
            earlier = read_job(self.folder / JOB)
            differing = job.differences(earlier)
        except ValueError:
            differing = [JOB]
        if differing:
            settings = tuple(_KEYS.get(name, name) for name in differing)
            raise ParameterError(
                "{folder} holds a canceled training with another {settings}; give the same again, choose another "
                "OUTPUT, or turn RESUME off to begin anew.",
                folder=self.folder,
                settings=settings,
            )
        return earlier

    def clear(self) -> None:
        """Removes the folder, if SemRef made it."""
        if self._is_ours:
            # What is in use stays: a model that is done is not lost for it.
            shutil.rmtree(self.folder, ignore_errors=True)
            QgsSettings().remove(self._setting)

    def close(self) -> None:
        """Removes the folder unless there is something to go on with."""
        _RUNNING.discard(self._model)
        if not self.can_go_on:
            self.clear()


def stamp(path: str) -> list:
    """[path, bytes, time of the last change] by which a file is known again; what is no file by its name alone."""
    try:
        found = os.stat(path)
    except OSError:
        return [path]
    return [path, found.st_size, found.st_mtime_ns]
