"""Helpers for scripts in desktop QGIS (--code) that act like a user: waiting, the dock, the end of a script.

The script calls ``start(session)``; what the session returns, or the error that ended it, is written as JSON.
"""

import json
import os
import sys
import time
import traceback
from pathlib import Path

import qgis.utils
from qgis.core import QgsApplication, QgsProject, QgsSettings
from qgis.PyQt.QtCore import QCoreApplication, QEvent, QTimer
from qgis.PyQt.QtWidgets import QDockWidget

LIMIT_S = 600
"""Time limit of one step; making the sample took more than 300 s on a busy machine."""
LOADED_AFTER_MS = 2500
"""The window is complete only when its event loop runs."""

messages = []


def settle(seconds: float = 0.3) -> None:
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QCoreApplication.processEvents()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        time.sleep(0.01)


def wait_until(condition, what: str) -> None:
    end = time.monotonic() + LIMIT_S
    while not condition():
        if time.monotonic() > end:
            raise RuntimeError(f"{what} did not come within {LIMIT_S} s\n{_what_stands_still()}")
        settle(0.05)


def _what_stands_still() -> str:
    """Return Python errors, tasks with their status, and the place of each Python thread."""
    tasks = [f"task {one.description()!r}: status {int(one.status())}" for one in QgsApplication.taskManager().tasks()]
    threads = ["".join(traceback.format_stack(frame)) for frame in sys._current_frames().values()]
    return "\n\n".join([*messages, *tasks, *threads])


def dock():
    return qgis.utils.iface.mainWindow().findChild(QDockWidget, "SemRefDock")


def start(session) -> None:
    """Run the steps when the window is ready, write results and Python errors, and quit QGIS."""

    def run() -> None:
        try:
            result = session()
        except Exception:
            result = {"error": traceback.format_exc()}
        result["messages"] = messages
        Path(os.environ["SEMREF_DESKTOP_RESULT"]).write_text(json.dumps(result, indent=1), encoding="utf-8")
        # Discard changes, because nobody can answer the question.
        QgsSettings().setValue("app/askToSaveMemoryLayers", False)
        QgsSettings().setValue("qgis/askToSaveProjectChanges", False)
        QgsProject.instance().clear()
        qgis.utils.iface.actionExit().trigger()

    qgis.utils.showException = _note_exception
    QTimer.singleShot(LOADED_AFTER_MS, run)


def _note_exception(kind, value, trace, text, *arguments, **options) -> None:
    """Replace QGIS's dialog, which would wait for a click."""
    messages.append("".join(traceback.format_exception(kind, value, trace)))
