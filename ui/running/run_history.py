"""Keep the results of the last runs in the profile, so that they are available after QGIS was closed."""

from __future__ import annotations

import json
import os
import shutil
import time
from pathlib import Path
from typing import NamedTuple

from qgis.core import QgsApplication, QgsProcessingUtils

from ...processing.layers.results_file import LABELS_FOLDER

_RESULTS, _ABOUT = "results.gpkg", "run.json"
_MOST_KEPT = 20
"""Number of runs. A run of hundreds of photos takes some ten megabytes."""


class RunRecord(NamedTuple):
    """Folder of a run, paths of its database and model, and its number of images."""

    folder: str
    database: str
    model: str
    images: int

    @property
    def file(self) -> str:
        """GeoPackage of the results."""
        return os.path.join(self.folder, _RESULTS)

    @property
    def labels(self) -> str:
        """Folder for the label images of photos."""
        return os.path.join(self.folder, LABELS_FOLDER)

    @property
    def title(self) -> str:
        """Start time, database and number of images."""
        began = time.strftime("%x %H:%M", time.localtime(os.path.getmtime(os.path.join(self.folder, _ABOUT))))
        return f"{began} · {os.path.splitext(os.path.basename(self.database))[0]} ({self.images})"


def runs_folder() -> Path:
    """Return the folder of all runs in the profile; it may not exist."""
    return Path(QgsApplication.qgisSettingsDirPath()) / "semref" / "runs"


def begin_run(database: str, model: str, images: int) -> RunRecord:
    """Create the folder of a new run, in the profile if possible, otherwise among QGIS's temporary files."""
    folder = runs_folder() / f"{time.time_ns()}"
    about = {"database": database, "model": model, "images": images}
    try:
        # QGIS can't write tables to a file with an apostrophe in its path.
        if "'" in str(folder):
            raise OSError
        folder.mkdir(parents=True)
        (folder / _ABOUT).write_text(json.dumps(about), encoding="utf-8")
    except OSError:
        folder = Path(QgsProcessingUtils.generateTempFilename("run"))
        folder.mkdir(parents=True)
    return RunRecord(str(folder), database, model, images)


def forget_old_runs() -> None:
    """Delete runs that are older than the last ones with results. For a background thread.

    Runs without results do not count, so they never displace results.
    """
    kept = run_records()[:_MOST_KEPT]
    for folder in _folders() if len(kept) == _MOST_KEPT else []:
        if folder < Path(kept[-1].folder) and _read_record(folder) is not None:
            shutil.rmtree(folder, ignore_errors=True)


def run_records() -> list[RunRecord]:
    """Return the runs with results, the latest first."""
    return [run for run in map(_read_record, _folders()) if run is not None and os.path.isfile(run.file)]


def _read_record(folder: Path) -> RunRecord | None:
    """Return the run of a folder; None without a readable run.json, as after a crash."""
    try:
        about = json.loads((folder / _ABOUT).read_text(encoding="utf-8"))
        return RunRecord(str(folder), str(about["database"]), str(about["model"]), int(about["images"]))
    except (OSError, ValueError, KeyError, TypeError):
        return None


def labels_of(file: str) -> str:
    """Return the folder of label images next to results; empty without one."""
    folder = os.path.join(os.path.dirname(file), LABELS_FOLDER)
    return folder if file and os.path.isdir(folder) else ""


def _folders() -> list[Path]:
    """Return the folders of all runs, the latest first."""
    root = runs_folder()
    return sorted((path for path in root.iterdir() if path.is_dir()), reverse=True) if root.is_dir() else []
