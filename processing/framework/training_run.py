"""The folder of a training beside its model: what was cut, and how far it is, so that it can be gone on with."""

from __future__ import annotations

import os
import shutil
from dataclasses import replace
from pathlib import Path

from ...core.errors import ParameterError
from ...training.job import CHECKPOINT, JOB, Job, read_job
from ..translation import tr
from .base import Canceled

_KEYS = {
    "base_model": "BASE_MODEL",
    "encoder": "NETWORK",
    "learn_unlabeled": "UNLABELED",
    "fingerprint": "IMAGE, LABELS, …",
}
"""What the user calls the settings by which two runs differ."""


class CanceledKeeping(Canceled):
    """The user canceled; what was trained so far is kept."""

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self.folder = folder

    def said(self) -> str:
        """What the user is told, in their language."""
        text = tr("Canceled; what was trained is kept in {folder}: run it again with the same output to go on.")
        return text.format(folder=self.folder)


class TrainingRun:
    """The folder ``MODEL.training`` beside a model; ``close`` removes it unless there is something to go on with.

    Attributes:
        folder: Its path.
    """

    def __init__(self, model: str) -> None:
        self.folder = Path(model).with_suffix(".training")

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

    def begin(self, job: Job, resume: bool) -> Job:
        """Makes the folder, or finds an earlier run in it.

        Args:
            job: What is to be trained.
            resume: Whether an earlier run is gone on with; otherwise it is removed.

        Returns:
            The job; of an earlier run it has what is told of its ground.

        Raises:
            ParameterError: The folder is not one of a training, or its run has other settings.
        """
        if self.folder.is_dir() and any(self.folder.iterdir()) and not (self.folder / JOB).is_file():
            raise ParameterError("storage.folder_not_empty", path=self.folder)
        if self.folder.is_dir() and not (resume and self.can_go_on):
            self.clear()
            if self.folder.is_dir():
                raise ParameterError("storage.folder_not_empty", path=self.folder)
        if self.can_go_on:
            job = replace(job, ground=self._same(job).ground)
        self.folder.mkdir(exist_ok=True)
        job.write(self.folder / JOB)
        return job

    def _same(self, job: Job) -> Job:
        """The earlier run, which must have the same settings."""
        try:
            earlier = read_job(self.folder / JOB)
            differing = job.differences(earlier)
        except ValueError:
            raise ParameterError("storage.folder_not_empty", path=self.folder) from None
        if differing:
            settings = tuple(_KEYS.get(name, name) for name in differing)
            raise ParameterError("algorithms.other_training", folder=self.folder, settings=settings)
        return earlier

    def clear(self) -> None:
        """Removes the folder."""
        if (self.folder / JOB).is_file():
            # What is in use stays: a model that is done is not lost for it.
            shutil.rmtree(self.folder, ignore_errors=True)

    def close(self) -> None:
        """Removes the folder unless there is something to go on with."""
        if not self.can_go_on:
            self.clear()


def stamp(path: str) -> list:
    """[path, bytes, time of the last change] by which a file is known again; what is no file by its name alone."""
    try:
        found = os.stat(path)
    except OSError:
        return [path]
    return [path, found.st_size, found.st_mtime_ns]
