"""Processes that SemRef starts beside QGIS end without touching others."""

import os
import sys
import time

import pytest
from qgis.PyQt.QtCore import QProcess

from semref.processing.base.event_process import EventProcess

pytestmark = pytest.mark.skipif(os.name == "nt", reason="Windows has no process groups")


class Ended:
    """A process that ended after its state was read, so that it has no number any more."""

    def state(self):
        return QProcess.ProcessState.Running

    def processId(self):
        return 0

    def kill(self):
        pass

    def waitForFinished(self, _within_ms):
        return False


def test_a_process_that_ended_meanwhile_does_not_end_qgis(monkeypatch):
    killed = []
    monkeypatch.setattr(os, "killpg", lambda *which: killed.append(which))
    EventProcess(Ended()).end()
    assert killed == []


def test_a_process_ends_with_those_that_it_started(tmp_path):
    code = "import os, subprocess, time; os.setpgrp(); child = subprocess.Popen(['sleep', '600']); "
    code += "open('child', 'w').write(str(child.pid)); os.rename('child', 'ready'); time.sleep(600)"
    process = QProcess()
    process.setWorkingDirectory(str(tmp_path))
    process.start(sys.executable, ["-c", code])
    assert process.waitForStarted(10_000)
    until = time.monotonic() + 20
    while not (tmp_path / "ready").exists() and time.monotonic() < until:
        time.sleep(0.05)
    child = int((tmp_path / "ready").read_text())
    EventProcess(process).end()
    assert process.state() == QProcess.ProcessState.NotRunning
    assert not is_running(child)


def is_running(number):
    for _ in range(40):
        try:
            with open(f"/proc/{number}/stat", encoding="ascii") as file:
                if file.read().rpartition(")")[2].split()[0] == "Z":
                    return False
        except FileNotFoundError:
            return False
        time.sleep(0.05)
    return True
