"""Results of the dock's runs stay in the profile for a while, so that they are found again when QGIS was closed."""

from __future__ import annotations

import json
import os
import shutil
import time
from pathlib import Path
from typing import NamedTuple

from qgis.core import QgsApplication

from ...processing.layers.results_file import TABLES

_RESULTS, _LABELS, _ABOUT = "results.gpkg", "labels", "run.json"
_MOST_KEPT = 20
"""Runs; a run of hundreds of photos takes some ten megabytes."""


class KeptRun(NamedTuple):
    """Where a run's results lie, and what they were found with: paths, and the number of images that were listed."""

    folder: str
    database: str
    model: str
    images: int

    @property
    def file(self) -> str:
        """The GeoPackage."""
        return os.path.join(self.folder, _RESULTS)

    @property
    def title(self) -> str:
        """When it began, and where it looked."""
        began = time.strftime("%x %H:%M", time.localtime(os.path.getmtime(os.path.join(self.folder, _ABOUT))))
        return f"{began} · {os.path.splitext(os.path.basename(self.database))[0]} ({self.images})"


def runs_folder() -> Path:
    """In the profile; it may not be there."""
    return Path(QgsApplication.qgisSettingsDirPath()) / "semref" / "runs"


def begin_run(database: str, model: str, images: int) -> KeptRun | None:
    """A new place for a run, the oldest ones making room; None where nothing can be written."""
    folder = runs_folder() / f"{time.time_ns()}"
    about = {"database": database, "model": model, "images": images}
    try:
        folder.mkdir(parents=True)
        (folder / _ABOUT).write_text(json.dumps(about), encoding="utf-8")
    except OSError:
        return None
    return KeptRun(str(folder), database, model, images)


def forget_old_runs() -> None:
    """Removes what is older than the last ones with results; for a background thread.

    Runs that came to nothing do not count, else a few in a row would displace all results.
    """
    kept = kept_runs()[:_MOST_KEPT]
    for folder in _folders() if len(kept) == _MOST_KEPT else []:
        if folder < Path(kept[-1].folder):
            shutil.rmtree(folder, ignore_errors=True)


def kept_runs() -> list[KeptRun]:
    """Those that have results, the last one first."""
    return [run for run in map(_kept, _folders()) if run is not None and os.path.isfile(run.file)]


def _kept(folder: Path) -> KeptRun | None:
    """The run that a folder tells about; None for one that does not tell, as of a run that was ended from outside."""
    try:
        about = json.loads((folder / _ABOUT).read_text(encoding="utf-8"))
        return KeptRun(str(folder), str(about["database"]), str(about["model"]), int(about["images"]))
    except (OSError, ValueError, KeyError, TypeError):
        return None


def destination(run: KeptRun, table: str) -> str:
    """A table of the run's results, as an algorithm's output; ``table``: one of TABLES."""
    if table not in TABLES:
        raise ValueError(table)
    return f"ogr:dbname='{run.file}' table=\"{table}\" (geom)"


def labels_of(file: str) -> str:
    """The folder of label images beside results; empty where there is none."""
    folder = os.path.join(os.path.dirname(file), _LABELS)
    return folder if file and os.path.isdir(folder) else ""


def labels_folder(run: KeptRun) -> str:
    """Where a run writes the photos' label images."""
    return os.path.join(run.folder, _LABELS)


def _folders() -> list[Path]:
    """The last one first."""
    root = runs_folder()
    return sorted((path for path in root.iterdir() if path.is_dir()), reverse=True) if root.is_dir() else []
