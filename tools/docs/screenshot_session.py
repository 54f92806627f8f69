"""Run the scenes of a job inside desktop QGIS (--code).

SEMREF_SCREENSHOTS names the job, a JSON file that make_screenshots.py writes. Its keys are:

- ``tools``: the folder of this file;
- ``pictures``: the folder of the pictures;
- ``scenes``: functions of screenshot_scenes.py, or ``module.function``, each with a suffix for its pictures;
- ``sample``: the folder of the sample project, created here if missing; may be left out;
- others for the scenes.
"""

import importlib
import json
import os
import sys
from pathlib import Path

from walking import start


def take_pictures() -> dict:
    job = json.loads(Path(os.environ["SEMREF_SCREENSHOTS"]).read_text(encoding="utf-8"))
    sys.path.append(job["tools"])
    from screenshot_window import Session

    session = Session(job)
    session.open()
    for scene, session.suffix in job["scenes"]:
        print(scene, flush=True)
        session.reset()
        module, _, name = scene.rpartition(".")
        getattr(importlib.import_module(module or "screenshot_scenes"), name)(session)
    return {"taken": session.taken, **session.seen}


start(take_pictures)
