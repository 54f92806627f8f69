"""The one way out: what is written lies beside its place until all of a run is complete, then moves there together.

Told in docs/decisions/outputs.md.
"""

from __future__ import annotations

import contextlib
import errno
import os
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from ..core.errors import ParameterError
from .locks import TakenError, folders_held, held
from .moving import LOCK, SUFFIX, Plan, clear, dismantle, flush, is_moving, is_own, move_all, move_of

SIDECARS = (".aux.xml", ".ovr", "-wal", "-shm", "-journal")
"""What GDAL or SQLite may have beside an output: metadata, pyramids, changes not yet in the database."""

_TRIES = 20
"""Others may take a new folder for a dead run's in the instant before it is locked."""


@dataclass(frozen=True)
class _Staged:
    """One output that waits to be moved.

    Attributes:
        workplace: The folder that it lies in, beside its place.
        final: Its place.
        is_folder: Whether it is a folder.
        lock: Tells others that the run lives, while it is open; None where the system has no locks.
        mark: Name of a file that an older folder must have to be replaced, see ``Batch.folder``.
    """

    workplace: Path
    final: Path
    is_folder: bool
    lock: IO[bytes] | None
    mark: str = ""

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
        _require_free(final, mark)
        final.parent.mkdir(parents=True, exist_ok=True)
        staged = self._stage(final, is_folder=True, mark=mark)
        staged.made.mkdir()
        return str(staged.made)

    def commit(self, *checks: Callable[[], None]) -> None:
        """Moves everything to its place; when one can't be moved, those that were are taken back.

        Args:
            *checks: Called last of all, while no other run moves anything there: what one raises leaves all as it was.

        Raises:
            ParameterError: When an older file can't be replaced.
            OSError: When the disk can't take what was written.
        """
        for staged in self._staged:
            flush(staged.workplace)
        with folders_held(staged.final.parent for staged in self._staged):
            for staged in self._staged:
                if staged.is_folder:
                    # Once more: others may have filled it meanwhile.
                    _require_free(staged.final, staged.mark)
            for check in checks:
                check()
            move_all([_plan(staged) for staged in self._staged])

    def close(self) -> None:
        """Clears away what was not moved, and the older files that were replaced."""
        for staged in self._staged:
            if not is_moving(self._staged[0].workplace):
                dismantle(staged.workplace, staged.lock)
            if staged.lock is not None:
                staged.lock.close()
        self._staged = []

    def _stage(self, final: Path, is_folder: bool, mark: str = "") -> _Staged:
        clear(final.parent)
        try:
            workplace, lock = _workplace(final)
        except PermissionError:
            raise ParameterError("storage.folder_unwritable", folder=final.parent, name=final.name) from None
        except (OSError, TakenError) as error:
            reason = getattr(error, "strerror", None) or os.strerror(errno.EBUSY)
            raise ParameterError("storage.file_unwritable", path=final, reason=reason) from None
        staged = _Staged(workplace, final, is_folder, lock, mark)
        self._staged.append(staged)
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


def _require_free(final: Path, mark: str) -> None:
    """Raises ParameterError unless a folder may be put there, see ``Batch.folder``."""
    if final.exists() and not final.is_dir():
        raise ParameterError("storage.is_file", path=final)
    if final.is_dir() and any(final.iterdir()) and not (mark and (final / mark).is_file()):
        raise ParameterError("storage.folder_not_empty", path=final)


def _plan(staged: _Staged) -> Plan:
    """What an output moves: what belongs to it, older companions that must go, and last itself."""
    final, workplace = staged.final, staged.workplace
    if staged.is_folder:
        return Plan(workplace, (move_of(workplace, final.name),))
    written = [path.name for path in sorted(workplace.iterdir()) if not is_own(path.name) and path != staged.made]
    # What belongs to an older output would be taken for the new one's.
    beside = [final.name + suffix for suffix in SIDECARS]
    gone = [name for name in beside if name not in written and final.with_name(name).exists()]
    # Last, so that whoever sees the file sees what belongs to it, too.
    made = [final.name] if staged.made.exists() else []
    return Plan(workplace, tuple(move_of(workplace, name) for name in [*written, *gone, *made]))


def _workplace(final: Path) -> tuple[Path, IO[bytes] | None]:
    """A new folder beside a place and its lock; raises OSError, and TakenError where others take it each time."""
    # Neither the name nor what is made up stands behind a dot: QGIS takes “.target…” and “.x.gz…” for archives.
    name = final.stem[:40].replace(".", "_")
    for _ in range(_TRIES):
        made = Path(tempfile.mkdtemp(prefix=f".semref-{name}-", suffix=SUFFIX, dir=final.parent))
        try:
            with contextlib.suppress(TakenError):
                return made, held(made / LOCK)
        except OSError:
            dismantle(made)
            raise
    raise TakenError
