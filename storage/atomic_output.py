"""Outputs of one run: written into private folders beside their targets, and renamed when all of them are complete.

See docs/decisions/outputs.md.
"""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
import tempfile
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from ..core.errors import ParameterError, reason_of
from .replaceable import (
    derived_files,
    is_foreign_note,
    is_note,
    not_replaceable,
    require_closed,
    require_replaceable,
    stranger_beside,
)

_OLDER = ".older"
"""Folder in a workplace for companions of the older output while the new ones are renamed."""


@dataclass
class _Staged:
    """One output until it is renamed.

    Attributes:
        workplace: The private folder beside the target in which it is written.
        require_free: Raises ParameterError when the target may not be replaced.
        is_folder: Whether it is a folder.
        replaces_folder: Whether an older folder is replaced.
        identity: Of the workplace when it was made.
    """

    final: Path
    workplace: Path
    require_free: Callable[[], None]
    is_folder: bool = False
    replaces_folder: bool = False
    identity: os.stat_result = field(init=False)

    def __post_init__(self) -> None:
        self.identity = os.lstat(self.workplace)

    @property
    def made(self) -> Path:
        return self.workplace / self.final.name

    def is_ours(self) -> bool:
        """Whether the workplace is still the folder that this run made."""
        with contextlib.suppress(OSError):
            return os.path.samestat(self.identity, os.lstat(self.workplace))
        return False


class Batch:
    """The outputs of one run: nothing of them is seen before ``commit``.

    An error or a cancel before that (any exception that leaves the block) leaves older outputs untouched. Only what the
    run itself made is deleted.

    >>> with Batch() as batch:
    ...     path = batch.file("positions.gpkg")  # write to path
    ...     batch.commit()
    """

    def __init__(self) -> None:
        self._staged: list[_Staged] = []

    def __enter__(self) -> Batch:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def file(self, target: str, suffix: str = "", tables: Collection[str] | None = ()) -> str:
        """Return a path to write ``target`` to. Files that are written beside it move along.

        Args:
            suffix: See ``require_replaceable``.
            tables: See ``require_replaceable``.

        Raises:
            ParameterError: The folder is missing or can't be written to, or ``target`` may not be replaced.
        """
        final = Path(target)
        if not final.parent.is_dir():
            raise ParameterError(
                "The folder {folder} does not exist; create it or choose another place for {name}.",
                folder=final.parent,
                name=final.name,
            )
        return str(self._stage(final, lambda: require_replaceable(target, suffix, tables)).made)

    def folder(self, target: str, replaces: bool = False) -> str:
        """Return a new folder to fill.

        Args:
            target: Its final path, where nothing or an empty folder may be.
            replaces: Whether an older folder is replaced: for folders that nobody but SemRef writes to.

        Raises:
            ParameterError: For any other ``target`` that exists, and when nothing can be written beside it.
        """
        final = Path(target)
        if not replaces:
            require_empty(final)
        final.parent.mkdir(parents=True, exist_ok=True)
        staged = self._stage(final, (lambda: None) if replaces else (lambda: require_empty(final)))
        staged.is_folder, staged.replaces_folder = True, replaces
        staged.made.mkdir()
        return str(staged.made)

    def commit(self, *checks: Callable[[], None]) -> None:
        """Flush all outputs to the disk and rename them, one after the other.

        Args:
            *checks: Called before anything is renamed. What one raises leaves all older outputs as they were.

        Raises:
            ParameterError: An older file can't be replaced. Outputs that were renamed before stay.
            OSError: The disk can't take what was written.
        """
        for staged in self._staged:
            if not staged.is_ours():
                raise ParameterError(
                    "{path} was changed by another program meanwhile; try again.", path=staged.workplace
                )
            _flush(staged.workplace)
        for check in checks:
            check()
        for staged in self._staged:
            staged.require_free()
            if not staged.is_folder:
                require_closed(str(staged.final))
        for staged in self._staged:
            try:
                _rename_folder(staged) if staged.is_folder else _rename_files(staged)
            except OSError as error:
                if error.errno in (errno.ENOSPC, errno.EDQUOT):
                    raise
                raise not_replaceable(staged.final) from None
            _flush_folder(staged.final.parent)

    def close(self) -> None:
        """Remove the private folders with all that was not renamed."""
        for staged in self._staged:
            if staged.is_ours():
                shutil.rmtree(staged.workplace, ignore_errors=True)
        self._staged = []

    def _stage(self, final: Path, require_free: Callable[[], None]) -> _Staged:
        require_free()
        try:
            # Nothing random follows a dot: QGIS takes “.x.gz…” for an archive.
            workplace = tempfile.mkdtemp(prefix=".semref-", suffix=".part", dir=final.parent)
        except PermissionError:
            raise ParameterError(
                "The folder {folder} can't be written to; choose another place for {name}.",
                folder=final.parent,
                name=final.name,
            ) from None
        except OSError as error:
            raise ParameterError(
                "{path} can't be written: {reason}; choose another place.", path=final, reason=reason_of(error)
            ) from None
        self._staged.append(_Staged(final, Path(workplace), require_free))
        return self._staged[-1]


@contextlib.contextmanager
def written_beside(target: str, suffix: str = "", tables: Collection[str] = ()) -> Iterator[str]:
    """Yield a path to write one file to, which is renamed to ``target`` when the block ends without an error."""
    with Batch() as batch:
        yield batch.file(target, suffix, tables)
        batch.commit()


@contextlib.contextmanager
def folder_written_beside(target: str, replaces: bool = False) -> Iterator[str]:
    """Yield a new folder to fill, which is renamed to ``target`` when the block ends without an error."""
    with Batch() as batch:
        yield batch.folder(target, replaces)
        batch.commit()


def require_empty(folder: Path) -> None:
    """Raise ParameterError for what is neither missing nor an empty folder. A link to a folder is not followed."""
    if os.path.islink(folder) or (os.path.exists(folder) and not os.path.isdir(folder)):
        raise ParameterError("{path} is a file or a link; choose a folder.", path=folder)
    if os.path.isdir(folder) and os.listdir(folder):
        raise ParameterError(
            "The folder {path} holds other files, which are left alone; choose a new or empty one.", path=folder
        )


def _rename_folder(staged: _Staged) -> None:
    final, older = staged.final, staged.workplace / _OLDER
    if staged.replaces_folder and os.path.lexists(final):
        os.replace(final, older)
    elif final.is_dir():
        # Refused by the system where others have filled it meanwhile, as is renaming onto a folder that is not empty.
        final.rmdir()
    try:
        os.replace(staged.made, final)
    except OSError:
        if os.path.lexists(older):
            os.replace(older, final)
        raise


def _rename_files(staged: _Staged) -> None:
    """Rename a file and its companions. When one can't be renamed, those of this output go back."""
    final, workplace = staged.final, staged.workplace
    written = sorted(path.name for path in workplace.iterdir() if path != staged.made)
    written = [name for name in written if not is_foreign_note(final.with_name(name))]
    older = [
        name for name in dict.fromkeys((*written, *derived_files(final))) if os.path.lexists(final.with_name(name))
    ]
    for path in map(final.with_name, older):
        # A folder, or a part of another file, belongs to somebody else.
        if (path.is_dir() and not path.is_symlink()) or not (os.path.lexists(final) or is_note(path)):
            raise stranger_beside(final, path)
    (workplace / _OLDER).mkdir()
    aside, renamed = [], []
    made = [final.name] if staged.made.exists() else []
    # An older file is replaced last. A new one comes first: companions alone would be taken for somebody else's.
    names = [*written, *made] if os.path.lexists(final) else [*made, *written]
    try:
        for name in older:
            os.replace(final.with_name(name), workplace / _OLDER / name)
            aside.append(name)
        for name in names:
            os.replace(workplace / name, final.with_name(name))
            renamed.append(name)
    except OSError:
        for name in renamed:
            os.replace(final.with_name(name), workplace / name)
        for name in aside:
            os.replace(workplace / _OLDER / name, final.with_name(name))
        raise


def _flush(folder: Path) -> None:
    """Have what was written reach the disk, so that a full disk is reported before anything is renamed."""
    for path in folder.rglob("*"):
        if path.is_file():
            # Windows flushes only files that are open for writing.
            with path.open("rb+") as file:
                os.fsync(file.fileno())


def _flush_folder(folder: Path) -> None:
    """Have new names reach the disk, where the system can."""
    with contextlib.suppress(OSError):
        number = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(number)
        finally:
            os.close(number)
