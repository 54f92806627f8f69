"""The one way out: what is written lies beside its place until all of a run is complete, then moves there together.

Told in docs/decisions/outputs.md.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from ..core.errors import ParameterError

try:
    import fcntl
except ImportError:  # Windows, where an open file can't be removed
    fcntl = None

SIDECARS = (".aux.xml", ".ovr", "-wal", "-shm", "-journal")
"""What GDAL or SQLite may have beside an output: metadata, pyramids, changes not yet in the database."""

_SUFFIX, _LOCK, _OLDER = ".part", ".lock", ".older"
"""Folders of unfinished outputs are hidden and end so; the file in them is locked while their run lives; what an output
replaces lies there until all are moved."""


@dataclass(frozen=True)
class _Staged:
    """One output that waits to be moved.

    Attributes:
        workplace: The folder that it lies in, beside its place.
        final: Its place.
        is_folder: Whether it is a folder.
    """

    workplace: Path
    final: Path
    is_folder: bool

    @property
    def made(self) -> Path:
        """Where it is written."""
        return self.workplace / self.final.name


class Batch:
    """The outputs of one run: nothing of them is seen before ``commit``, and either all are moved or none.

    On an error or a cancel (any exception that leaves the block) nothing stays, and what was there before is
    untouched. What a run that was killed left behind is cleared away by the next one that writes into the same folder.

    >>> with Batch() as batch:
    ...     path = batch.file("positions.gpkg")  # write to path
    ...     batch.commit()
    """

    def __init__(self) -> None:
        self._staged: list[_Staged] = []
        self._locks: list[IO[bytes]] = []

    def __enter__(self) -> Batch:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def file(self, target: str) -> str:
        """Gives a path to write ``target`` to; files beside it whose names begin with its stem move along.

        Raises:
            ParameterError: When the folder is missing or can't be written to, or ``target`` is a folder.
        """
        final = Path(target)
        if not final.parent.is_dir():
            raise ParameterError("storage.no_folder", folder=final.parent, name=final.name)
        if final.is_dir():
            raise ParameterError("storage.is_folder", path=final)
        return str(self._stage(final, is_folder=False).made)

    def folder(self, target: str, mark: str = "") -> str:
        """Gives a new folder to fill.

        Args:
            target: Its place.
            mark: Name of a file that such folders have; an older one that has it is replaced, as is an empty folder.
                Without a mark only an empty one is.

        Raises:
            ParameterError: For any other ``target`` that exists, and when nothing can be written beside it.
        """
        final = Path(target)
        if final.exists() and not final.is_dir():
            raise ParameterError("storage.is_file", path=final)
        if final.is_dir() and any(final.iterdir()) and not (mark and (final / mark).is_file()):
            raise ParameterError("storage.folder_not_empty", path=final)
        final.parent.mkdir(parents=True, exist_ok=True)
        staged = self._stage(final, is_folder=True)
        staged.made.mkdir()
        return str(staged.made)

    def commit(self) -> None:
        """Moves everything to its place; when one can't be moved, those that were are taken back.

        Raises:
            ParameterError: When an older file can't be replaced.
            OSError: When the disk can't take what was written.
        """
        for staged in self._staged:
            _flush(staged.made)
        done: list[_Replaced] = []
        try:
            for staged in self._staged:
                for source, target in _moves(staged):
                    done.append(_replace(source, target, staged.workplace))
        except BaseException:
            for replaced in reversed(done):
                replaced.take_back()
            raise

    def close(self) -> None:
        """Clears away what was not moved, and the older files that were replaced."""
        for lock in self._locks:
            lock.close()
        for staged in self._staged:
            shutil.rmtree(staged.workplace, ignore_errors=True)
        self._staged, self._locks = [], []

    def _stage(self, final: Path, is_folder: bool) -> _Staged:
        _clear_strays(final.parent)
        try:
            workplace = Path(tempfile.mkdtemp(prefix=f".{final.stem[:40]}.", suffix=_SUFFIX, dir=final.parent))
        except PermissionError:
            raise ParameterError("storage.folder_unwritable", folder=final.parent, name=final.name) from None
        except OSError as error:
            raise ParameterError("storage.file_unwritable", path=final, reason=error.strerror) from None
        staged = _Staged(workplace, final, is_folder)
        self._staged.append(staged)
        lock = _locked(workplace / _LOCK)
        if lock is not None:
            self._locks.append(lock)
        return staged


@contextlib.contextmanager
def written_beside(target: str) -> Iterator[str]:
    """Gives a path to write one file to, which is moved to ``target`` when the block ends well; see Batch."""
    with Batch() as batch:
        yield batch.file(target)
        batch.commit()


@contextlib.contextmanager
def folder_written_beside(target: str, mark: str = "") -> Iterator[str]:
    """Gives a new folder to fill, which is moved to ``target`` when the block ends well; see Batch."""
    with Batch() as batch:
        yield batch.folder(target, mark)
        batch.commit()


@dataclass(frozen=True)
class _Replaced:
    """What a move did: ``older`` is where the file that it replaced lies now, None where there was none."""

    target: Path
    older: Path | None

    def take_back(self) -> None:
        """Puts the older one back; without one the new one goes."""
        if self.older is None or self.target.is_dir():
            _remove(self.target)
        if self.older is not None:
            os.replace(self.older, self.target)


def _moves(staged: _Staged) -> list[tuple[Path | None, Path]]:
    """(file written, its place) of an output and what belongs to it; None: an older companion that must go."""
    final = staged.final
    if staged.is_folder:
        return [(staged.made, final)]
    written = [path for path in sorted(staged.workplace.iterdir()) if path.name != _LOCK and path != staged.made]
    moves: list[tuple[Path | None, Path]] = [(path, final.with_name(path.name)) for path in written]
    # What belongs to an older output would be taken for the new one's.
    names = {path.name for path in written}
    beside = [final.with_name(final.name + suffix) for suffix in SIDECARS]
    moves += [(None, path) for path in beside if path.name not in names and path.exists()]
    # Last, so that whoever sees the file sees what belongs to it, too.
    return [*moves, (staged.made, final)] if staged.made.exists() else moves


def _replace(source: Path | None, target: Path, workplace: Path) -> _Replaced:
    """Moves one file or folder to its place, keeping what it replaces in the workplace until all are moved."""
    older = None
    try:
        if target.exists():
            older = workplace / f"{target.name}{_OLDER}"
            if source is None or target.is_dir():
                os.replace(target, older)
            else:
                # A second name for the older file: at no moment is there none under its own.
                _link(target, older)
        if source is not None:
            os.replace(source, target)
    except PermissionError:
        if older is not None and older.exists() and not target.exists():
            os.replace(older, target)
        raise ParameterError("storage.not_replaceable", path=target) from None
    return _Replaced(target, older)


def _link(path: Path, name: Path) -> None:
    """Gives a file a second name; where the file system has no such links, a copy."""
    try:
        os.link(path, name)
    except (OSError, NotImplementedError, AttributeError):
        shutil.copy2(path, name)


def _flush(path: Path) -> None:
    """Has what was written reach the disk, so that a full one is heard of before anything is moved."""
    files = [path] if path.is_file() else [child for child in path.rglob("*") if child.is_file()]
    for file in files:
        # Windows flushes only files that may be written to.
        with file.open("rb+") as opened:
            os.fsync(opened.fileno())


def _remove(path: Path) -> None:
    if path.is_dir():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def _locked(path: Path) -> IO[bytes] | None:
    """A file that stays open, and locked where the system can; None where it can't be made."""
    try:
        file = path.open("wb")
    except OSError:
        return None
    if fcntl is not None:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            # A network share without locks; such folders are left to the user.
            path.unlink(missing_ok=True)
    return file


def _clear_strays(folder: Path) -> None:
    """Removes unfinished outputs of runs that are dead: their lock is free.

    One that died while it moved its output gets what it had replaced back to its place.
    """
    for stray in folder.glob(f".*{_SUFFIX}"):
        lock = stray / _LOCK
        if not (stray.is_dir() and lock.is_file() and _is_free(lock)):
            continue
        kept = [path for path in stray.iterdir() if path.name != _LOCK]
        if any(not path.name.endswith(_OLDER) for path in kept):
            for path in kept:
                if path.name.endswith(_OLDER):
                    os.replace(path, folder / path.name[: -len(_OLDER)])
        shutil.rmtree(stray, ignore_errors=True)


def _is_free(lock: Path) -> bool:
    """Whether no living run holds a lock."""
    try:
        if fcntl is None:
            lock.unlink()
            return True
        with lock.open("rb") as file:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return True
    except OSError:
        return False
