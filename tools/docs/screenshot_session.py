"""Take the pictures of a job inside desktop QGIS (--code).

SEMREF_SCREENSHOTS names the job, a JSON file that make_screenshots.py writes. Its keys are:

- ``tools``: the folder of this file;
- ``sample``: the folder of the sample project, created here if missing;
- ``pictures``: the folder of the pictures;
- ``scenes``: names of functions of ``module``, each with a suffix for its pictures;
- ``palette``, ``reverse``: the look of the session;
- ``result``: the JSON file that is written at the end.
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
    session = None
    result = {}
    try:
        sys.path.append(job["tools"])
        scenes = importlib.import_module(job["module"])
        from screenshot_window import Session

        session = Session(job)
        session.open()
        for scene, suffix in job["scenes"]:
            session.suffix = suffix
            print(scene, flush=True)
            getattr(scenes, scene)(session)
    except Exception:
        result["error"] = traceback.format_exc()
    result["taken"] = session.taken if session else []
    result["messages"] = messages
    Path(job["result"]).write_text(json.dumps(result, indent=1), encoding="utf-8")
    QgsProject.instance().setDirty(False)
    qgis.utils.iface.actionExit().trigger()


def note_exception(kind, value, trace, text, *arguments, **options) -> None:
    """Replace QGIS's dialog, which would wait for a click."""
    messages.append("".join(traceback.format_exception(kind, value, trace)))


qgis.utils.showException = note_exception
# The window is complete only while its event loop runs.
QTimer.singleShot(3000, run)
