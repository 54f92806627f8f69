"""Disks of a chosen size, which root can mount in memory."""

from __future__ import annotations

import contextlib
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path


def can_mount(folder: Path) -> bool:
    """Whether a disk can be mounted here."""
    folder.mkdir(parents=True, exist_ok=True)
    try:
        with disk(folder, 64):
            return True
    except OSError:
        return False


@contextlib.contextmanager
def disk(folder: Path, kilobytes: int) -> Iterator[None]:
    """Has a folder be an empty disk of its own; raises OSError where that can't be."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    _mount("-t", "tmpfs", "-o", f"size={max(kilobytes, 4)}k", "tmpfs", str(folder))
    try:
        yield
    finally:
        subprocess.run(["umount", "-l", str(folder)], check=False, capture_output=True)


def make_read_only(folder: Path) -> None:
    """Lets nobody write to a disk, root included."""
    _mount("-o", "remount,ro", str(folder))


def _mount(*arguments: str) -> None:
    try:
        done = subprocess.run(["mount", *arguments], capture_output=True, check=False, text=True)
    except FileNotFoundError as error:
        raise OSError("there is no mount") from error
    if done.returncode:
        raise OSError(done.stderr.strip())
