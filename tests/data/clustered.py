"""What the tests of cluster/ share."""

from __future__ import annotations

import signal
import subprocess
from pathlib import Path

import pytest

SETTINGS = ["--window-size", "320", "--stride", "140", "--minimum-area", "40"]


def wait_for(running: subprocess.Popen, words: str) -> None:
    """Until the process says so."""
    for line in running.stderr:
        if words in line:
            return
    pytest.fail(f"It never said “{words}”.")


def lose_a_worker(running: subprocess.Popen, words: str) -> None:
    """Kills a worker once the process says so; the process is to end well nevertheless."""
    psutil = pytest.importorskip("psutil")
    wait_for(running, words)
    workers = []
    for child in psutil.Process(running.pid).children(recursive=True):
        try:
            if "spawn_main" in " ".join(child.cmdline()):
                workers.append(child)
        except psutil.Error:
            # Gone since.
            continue
    assert len(workers) >= 2
    workers[0].send_signal(signal.SIGKILL)
    _, errors = running.communicate(timeout=120)
    assert running.returncode == 0, errors


def require_nothing_after(name: str, running: subprocess.Popen, words: str, folder: Path) -> None:
    """A signal ends the process once it says so, in one sentence, and a folder stays empty."""
    wait_for(running, words)
    running.send_signal(getattr(signal, name))
    _, errors = running.communicate(timeout=60)
    assert running.returncode == 130 and errors.splitlines()[-1] == "cluster: ended; nothing was written."
    assert list(folder.iterdir()) == []
