"""Outputs are written beside their final place and moved there when they are complete."""

from __future__ import annotations

import contextlib
import os
import tempfile
from pathlib import Path
from typing import Iterator

from ...core.errors import ParameterError

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
        raise ParameterError(f"The folder {folder} does not exist; create it or choose another place for {final.name}.")
    if final.is_dir():
        raise ParameterError(f"{final} is a folder; give a file name.")
    try:
        workplace = tempfile.mkdtemp(prefix=f".{final.stem}.", suffix=".part", dir=folder)
    except PermissionError:
        raise ParameterError(
            f"The folder {folder} can't be written to; choose another place for {final.name}."
        ) from None
    except OSError as error:
        raise ParameterError(f"{final} can't be written: {error.strerror}; choose another place.") from None
    temporary = os.path.join(workplace, final.name)
    try:
        yield temporary
        _move(temporary, final)
    finally:
        _remove(workplace)


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
            raise ParameterError(
                f"{target} can't be replaced; it may be open in this or another program: close or remove it, "
                "or choose another name."
            ) from None


def _remove(workplace: str) -> None:
    with os.scandir(workplace) as entries:
        for entry in entries:
            os.remove(entry.path)
    os.rmdir(workplace)
