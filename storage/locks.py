"""Locks between processes: of a run's own folder while it lives, and of the folders that outputs are moved into."""

from __future__ import annotations

import contextlib
import os
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import IO

try:
    import fcntl
except ImportError:  # Windows, where an open file can't be removed
    fcntl = None

_WAIT_S = 10.0
"""Longest wait for others who move their outputs into the same folder, which takes them milliseconds."""

_LOOK_EVERY_S = 0.01


class TakenError(Exception):
    """Another run took a new folder for the leftover of a dead one; it is to be made again."""


def held(path: Path) -> IO[bytes] | None:
    """Makes a file and keeps it locked while it is open; None where the file system has no locks.

    Raises:
        TakenError: Its folder was cleared away meanwhile.
        OSError: It can't be made.
    """
    try:
        file = path.open("wb")
    except FileNotFoundError:
        raise TakenError from None
    if fcntl is None:
        return file
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        file.close()
        raise TakenError from None
    except OSError:
        # A network share without locks.
        file.close()
        path.unlink(missing_ok=True)
        return None
    if not _is(file, path):
        file.close()
        raise TakenError
    return file


def claimed(path: Path) -> IO[bytes] | None:
    """The lock of a run that is dead, now ours until it is closed; None while the run lives."""
    try:
        if fcntl is None:
            path.unlink()
            return path.open("wb")
        file = path.open("rb+")
    except OSError:
        return None
    with contextlib.suppress(OSError):
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        if _is(file, path):
            return file
    file.close()
    return None


@contextlib.contextmanager
def folders_held(folders: Iterable[Path]) -> Iterator[None]:
    """Keeps other runs from moving outputs into the same folders; where folders can't be locked it holds nobody."""
    opened: list[int] = []
    try:
        # All runs in one order: two that wait for each other would wait for good.
        for folder in sorted({os.path.realpath(folder) for folder in folders}):
            with contextlib.suppress(OSError):
                opened.append(os.open(folder, os.O_RDONLY))
                _wait_for(opened[-1])
        yield
    finally:
        for number in opened:
            os.close(number)


def _wait_for(number: int) -> None:
    if fcntl is None:
        return
    until = time.monotonic() + _WAIT_S
    while True:
        try:
            fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            if time.monotonic() > until:
                return
            time.sleep(_LOOK_EVERY_S)
        else:
            return


def _is(file: IO[bytes], path: Path) -> bool:
    """Whether the open file still has that name."""
    try:
        return os.path.samestat(os.fstat(file.fileno()), os.stat(path))
    except OSError:
        return False
