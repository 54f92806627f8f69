"""Outputs are written beside their final place and moved there when they are complete."""

from __future__ import annotations

import contextlib
import os
import shutil
import tempfile
from pathlib import Path
from typing import Iterator

from ..core.errors import ParameterError

_SIDECARS = ("", ".aux.xml", ".ovr", "-wal", "-shm", "-journal")
"""An output, then what GDAL or SQLite may have beside it: metadata, pyramids, changes not yet in the database."""


@contextlib.contextmanager
def written_beside(target: str) -> Iterator[str]:
    """Gives a path in ``target``'s folder to write to; moves the result to ``target`` when the block ends well.

    On an error or a cancel (any exception) nothing stays and an older ``target`` is untouched. Raises
    ParameterError when the folder is missing or not writable, or ``target`` is a folder.
    """
    final = Path(target)
    folder = final.parent
    if not folder.is_dir():
        raise ParameterError("storage.no_folder", folder=folder, name=final.name)
    if final.is_dir():
        raise ParameterError("storage.is_folder", path=final)
    workplace = _workplace(final)
    temporary = os.path.join(workplace, final.name)
    try:
        yield temporary
        _move(temporary, final)
    finally:
        _remove(workplace)


@contextlib.contextmanager
def folder_written_beside(target: str, mark: str = "") -> Iterator[str]:
    """Gives a new folder beside ``target`` to fill; moves it to ``target`` when the block ends well.

    ``mark``: name of a file that such folders have; an older one that has it is replaced, as is an empty folder;
    without a mark only an empty one is. On an error or a cancel nothing stays and an older ``target`` is untouched.
    Raises ParameterError for any other ``target`` that exists, and when nothing can be written beside it.
    """
    final = Path(target)
    if final.exists() and not final.is_dir():
        raise ParameterError("storage.is_file", path=final)
    if final.is_dir() and any(final.iterdir()) and not (mark and (final / mark).is_file()):
        raise ParameterError("storage.folder_not_empty", path=final)
    final.parent.mkdir(parents=True, exist_ok=True)
    workplace = Path(_workplace(final))
    made = workplace / final.name
    made.mkdir()
    try:
        yield str(made)
        if final.exists():
            final.rename(workplace / f"{final.name}.replaced")
        made.rename(final)
    finally:
        shutil.rmtree(workplace)


def _workplace(final: Path) -> str:
    """A new hidden folder beside ``final``."""
    try:
        return tempfile.mkdtemp(prefix=f".{final.stem}.", suffix=".part", dir=final.parent)
    except PermissionError:
        raise ParameterError("storage.folder_unwritable", folder=final.parent, name=final.name) from None
    except OSError as error:
        raise ParameterError("storage.file_unwritable", path=final, reason=error.strerror) from None


def _move(temporary: str, final: Path) -> None:
    for sidecar in _SIDECARS:
        source, target = temporary + sidecar, f"{final}{sidecar}"
        try:
            if os.path.exists(source):
                os.replace(source, target)
            elif os.path.exists(target):
                # What belongs to an older output would be taken for the new one's.
                os.remove(target)
        except PermissionError:
            raise ParameterError("storage.not_replaceable", path=target) from None


def _remove(workplace: str) -> None:
    with os.scandir(workplace) as entries:
        for entry in entries:
            os.remove(entry.path)
    os.rmdir(workplace)
