"""Lock files: one run at a time in a folder that can be continued."""

from __future__ import annotations

from pathlib import Path

from qgis.PyQt.QtCore import QLockFile


def take_lock(path: Path) -> QLockFile | None:
    """Make a lock file. Return None if a run of this or another QGIS has it.

    ``unlock`` removes the file, and Qt ignores that of a process that has ended. Where no file can be made, no run is
    excluded.
    """
    lock = QLockFile(str(path))
    lock.setStaleLockTime(0)
    is_free = lock.tryLock(0) or lock.error() != QLockFile.LockError.LockFailedError
    return lock if is_free else None
