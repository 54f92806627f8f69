"""Write the outputs of a run into private folders beside their targets, and rename them when all are complete.

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

from ..core.errors import ParameterError, UnwritableError, reason_of
from .replaceable import (
    derived_files,
    is_foreign_note,
    is_note,
    not_replaceable,
    require_closed,
    require_replaceable,
    stranger_beside,
)
from .vector_files import no_place

FULL_BYTES = 100_000
"""A disk with less space is full: other files may still fit."""

_OLDER = ".older"
"""Folder in a workplace for the older output and its companions while the new files are renamed."""


@dataclass
class _Staged:
    """An output that is not renamed yet.

    Attributes:
        workplace: Private folder beside the target for writing.
        require_free: Function that raises ParameterError if the target may not be replaced.
        keeps_older: Whether the workplace has the only copy of an older output.
    """

    final: Path
    workplace: Path
    require_free: Callable[[], None]
    is_folder: bool = False
    replaces_folder: bool = False
    keeps_older: bool = False
    identity: os.stat_result = field(init=False)

    def __post_init__(self) -> None:
        self.identity = os.lstat(self.workplace)

    @property
    def made(self) -> Path:
        return self.workplace / self.final.name

    def is_ours(self) -> bool:
        """Whether the workplace is still the folder of this run."""
        with contextlib.suppress(OSError):
            return os.path.samestat(self.identity, os.lstat(self.workplace))
        return False


class Batch:
    """The outputs of one run, which appear at their targets on ``commit``.

    If an exception leaves the block before that (an error or a cancel), older outputs are unchanged. Only files of this
    run are deleted.

    >>> with Batch() as batch:
    ...     path = batch.file("positions.gpkg")  # write to path
    ...     batch.commit()
    """

    def __init__(self) -> None:
        self._staged: list[_Staged] = []

    def __enter__(self) -> Batch:
        return self

    def __exit__(self, _kind: object, error: BaseException | None, _trace: object) -> None:
        is_unwritten = isinstance(error, UnwritableError) or getattr(error, "errno", None) == errno.ENOSPC
        full = self._full_target() if is_unwritten else None
        self.close()
        if full is not None:
            # GDAL's message is technical, and names the file in the workplace; Python's may name no file.
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(full)) from None

    def _full_target(self) -> Path | None:
        """Return an output whose disk is full; None without one."""
        for staged in self._staged:
            with contextlib.suppress(OSError):
                if shutil.disk_usage(staged.workplace).free < FULL_BYTES:
                    return staged.final
        return None

    def file(self, target: str, suffix: str = "", tables: Collection[str] | None = ()) -> str:
        """Return a path to write ``target`` to. Files beside this path are renamed as well.

        Args:
            suffix: See ``require_replaceable``.
            tables: See ``require_replaceable``.

        Raises:
            ParameterError: The folder is missing or read-only, or ``target`` may not be replaced.
        """
        return str(self._stage(Path(target), lambda: require_replaceable(target, suffix, tables)).made)

    def folder(self, target: str, replaces: bool = False) -> str:
        """Return a new folder to fill.

        Args:
            target: Its final path, which must be free or an empty folder.
            replaces: Whether to replace an older folder; only for folders that only SemRef writes to.

        Raises:
            ParameterError: ``target`` exists, or the folder around it is read-only.
        """
        final = Path(target)
        if not replaces:
            require_empty(final)
        make_folder(final.parent)
        staged = self._stage(final, (lambda: None) if replaces else (lambda: require_empty(final)))
        staged.is_folder, staged.replaces_folder = True, replaces
        staged.made.mkdir()
        return str(staged.made)

    def commit(self, *checks: Callable[[], None]) -> None:
        """Flush all outputs to the disk and rename them, one after the other.

        Args:
            *checks: Called before renaming. If one raises an error, all older outputs are unchanged.

        Raises:
            ParameterError: An older file can't be replaced. Outputs that were renamed before remain.
            OSError: The disk is full.
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
                if staged.keeps_older:
                    raise ParameterError(
                        "{path} can't be replaced, and its older files can't be renamed back. They are in {folder}; "
                        "move them back.",
                        path=staged.final,
                        folder=staged.workplace / _OLDER,
                    ) from None
                if error.errno in (errno.ENOSPC, errno.EDQUOT):
                    raise
                raise not_replaceable(staged.final) from None
            _flush_folder(staged.final.parent)

    def close(self) -> None:
        """Remove the private folders with all files that were not renamed.

        A folder with an older output that could not be renamed back is kept.
        """
        for staged in self._staged:
            if staged.is_ours() and not staged.keeps_older:
                shutil.rmtree(staged.workplace, ignore_errors=True)
        self._staged = []

    def _stage(self, final: Path, require_free: Callable[[], None]) -> _Staged:
        require_free()
        try:
            # No random letters after a dot: QGIS treats “.x.gz…” as an archive.
            workplace = tempfile.mkdtemp(prefix=".semref-", suffix=".part", dir=final.parent)
        except PermissionError:
            raise ParameterError(
                "The folder {folder} can't be written to; choose another place for {name}.",
                folder=final.parent,
                name=final.name,
            ) from None
        except OSError as error:
            raise no_place(final, reason_of(error)) from None
        self._staged.append(_Staged(final, Path(workplace), require_free))
        return self._staged[-1]


@contextlib.contextmanager
def written_beside(target: str, suffix: str = "", tables: Collection[str] = ()) -> Iterator[str]:
    """Yield a path for one file, which is renamed to ``target`` if the block ends without an error."""
    with Batch() as batch:
        yield batch.file(target, suffix, tables)
        batch.commit()


@contextlib.contextmanager
def folder_written_beside(target: str, replaces: bool = False) -> Iterator[str]:
    """Yield a new folder, which is renamed to ``target`` if the block ends without an error."""
    with Batch() as batch:
        yield batch.folder(target, replaces)
        batch.commit()


def make_folder(folder: Path) -> None:
    """Make a folder and those around it, unless they exist. Raises ParameterError."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise no_place(folder, reason_of(error)) from None


def require_empty(folder: Path) -> None:
    """Raise ParameterError unless a path is free or an empty folder. A link to a folder is refused."""
    if os.path.islink(folder) or (os.path.exists(folder) and not os.path.isdir(folder)):
        raise ParameterError("{path} is a file or a link; choose a folder.", path=folder)
    if os.path.isdir(folder) and os.listdir(folder):
        raise ParameterError(
            "The folder {path} holds other files, which are left alone; choose a new or empty one.", path=folder
        )


def _rename_folder(staged: _Staged) -> None:
    final, older = staged.final, staged.workplace / _OLDER
    try:
        if staged.replaces_folder and os.path.lexists(final):
            staged.keeps_older = True
            os.replace(final, older)
        elif final.is_dir():
            # The system refuses this if the folder is no longer empty, and refuses to rename onto such a folder.
            final.rmdir()
        os.replace(staged.made, final)
    except OSError:
        if os.path.lexists(older):
            os.replace(older, final)
        staged.keeps_older = False
        raise
    staged.keeps_older = False


def _rename_files(staged: _Staged) -> None:
    """Rename a file and its companions. If this fails for one of them, rename all back."""
    final, workplace = staged.final, staged.workplace
    written = sorted(path.name for path in workplace.iterdir() if path != staged.made)
    written = [name for name in written if not is_foreign_note(final.with_name(name))]
    older = [
        name for name in dict.fromkeys((*written, *derived_files(final))) if os.path.lexists(final.with_name(name))
    ]
    for path in map(final.with_name, older):
        # A folder, or a part of another file, is not ours.
        if (path.is_dir() and not path.is_symlink()) or not (os.path.lexists(final) or is_note(path)):
            raise stranger_beside(final, path)
    (workplace / _OLDER).mkdir()
    aside, renamed = [], []
    made = [final.name] if staged.made.exists() else []
    # Replace an older file last. Rename a new file first: companions without it would look like foreign files.
    names = [*written, *made] if os.path.lexists(final) else [*made, *written]
    staged.keeps_older = bool(older)
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
        staged.keeps_older = False
        raise
    staged.keeps_older = False


def _flush(folder: Path) -> None:
    """Flush all files to the disk, so that a full disk is reported before renaming."""
    for path in folder.rglob("*"):
        if path.is_file():
            # Windows flushes only files that are open for writing.
            with path.open("rb+") as file:
                os.fsync(file.fileno())


def _flush_folder(folder: Path) -> None:
    """Flush new names to the disk, if the system can."""
    with contextlib.suppress(OSError):
        number = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(number)
        finally:
            os.close(number)
