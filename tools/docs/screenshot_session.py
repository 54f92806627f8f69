"""Run the scenes of a job inside desktop QGIS (--code).

SEMREF_SCREENSHOTS names the job, a JSON file that make_screenshots.py writes. Its keys are:

- ``tools``: the folder of this file;
- ``pictures``, ``result``: the folder of the pictures, and the JSON file that is written at the end;
- ``scenes``: functions of screenshot_scenes.py, or ``module.function``, each with a suffix for its pictures;
- ``sample``: the folder of the sample project, created here if missing; may be left out;
- others for the scenes.
"""

import importlib
import json
import os
import sys
import traceback
from pathlib import Path

import qgis.utils
from qgis.core import QgsProject
from qgis.PyQt.QtCore import QTimer

messages = []


def run() -> None:
    job = json.loads(Path(os.environ["SEMREF_SCREENSHOTS"]).read_text(encoding="utf-8"))
    result = {"messages": messages}
    try:
        sys.path.append(job["tools"])
        from screenshot_window import Session

        session = Session(job)
        session.open()
        for scene, session.suffix in job["scenes"]:
            print(scene, flush=True)
            session.reset()
            module, _, name = scene.rpartition(".")
            getattr(importlib.import_module(module or "screenshot_scenes"), name)(session)
        result |= {"taken": session.taken, **session.seen}
    except Exception:
        result["error"] = traceback.format_exc()
    Path(job["result"]).write_text(json.dumps(result, indent=1), encoding="utf-8")
    QgsProject.instance().setDirty(False)
    qgis.utils.iface.actionExit().trigger()


def note_exception(kind, value, trace, text, *arguments, **options) -> None:
    """Replace QGIS's dialog, which would wait for a click."""
    messages.append("".join(traceback.format_exception(kind, value, trace)))


qgis.utils.showException = note_exception
# The window is complete only while its event loop runs.
QTimer.singleShot(3000, run)
