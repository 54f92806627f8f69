"""Records all sections of a checkout; a section that fails is recorded as failed and does not stop the others."""

from __future__ import annotations

import os
import subprocess
import time
import traceback
from pathlib import Path
from typing import Any

from . import annotation, areas, assessment, fixes, interface, labels, models, onboard
from .recorder import Recorder
from .session import qgis_with_plugin
from .store import MANIFEST, RecordingError, empty_folder, read_manifest, write_json

SECTIONS = {
    "interface": interface.record,
    "labels": labels.record,
    "onboard": onboard.record,
    "annotation": annotation.record,
    "models": models.record,
    "assessment": assessment.record,
    "fixes": fixes.record,
}
"""What is recorded after the areas, by name."""


def record(target: Path, work: Path, repository: Path, data: Path, quick: bool, only: list[str] | None = None) -> int:
    """Write a recording to ``target`` and return the exit status: 1 if a section failed.

    Args:
        target: Folder of the recording.
        work: Folder for the outputs of the algorithms.
        repository: The checkout to record.
        data: Folder of the real data.
        quick: Whether to record only a part.
        only: Sections to record, besides the areas. Other sections of a recording of the same commit are kept.
    """
    unknown = set(only or ()) - set(SECTIONS)
    if unknown:
        raise RecordingError(f"There is no section {', '.join(sorted(unknown))}; there are {', '.join(SECTIONS)}.")
    about = {"quick": quick, "commit": _commit(repository)}
    seconds: dict[str, float] = _kept(target, about) if only else {}
    if not seconds:
        empty_folder(target)
    write_json(target / MANIFEST, {"complete": False})
    recorder = Recorder(target, work, repository, data, quick)
    failed, began = [], time.perf_counter()
    with qgis_with_plugin(repository):
        versions = _versions()
        started = time.perf_counter()
        places = areas.make(recorder)
        recorder.write("areas")
        seconds["areas"] = time.perf_counter() - started
        for name, section in SECTIONS.items():
            if only and name not in only:
                continue
            started = time.perf_counter()
            try:
                section(recorder, places)
            except Exception:
                failed.append(name)
                recorder.put("failed", traceback.format_exc().splitlines())
                traceback.print_exc()
            count = recorder.write(name)
            seconds[name] = time.perf_counter() - started
            print(f"{name}: {count} things, {seconds[name]:.0f} s", flush=True)
        about.update(seconds=seconds, failed=failed, versions=versions)
        write_json(target / MANIFEST, {**about, "complete": True})
    total, processor = time.perf_counter() - began, sum(os.times()[:4])
    print(f"Recorded {repository} in {total:.0f} s ({processor:.0f} s of processor time) into {target}")
    if failed:
        print(f"FAILED: {', '.join(failed)}; what was raised stands in the recording.")
    return 1 if failed else 0


def _kept(target: Path, about: dict[str, Any]) -> dict[str, float]:
    """Return the seconds of the sections of an existing recording of the same commit; otherwise an empty dict."""
    if not (target / MANIFEST).exists():
        return {}
    found = read_manifest(target)
    return found["seconds"] if {**found, **about} == found else {}


def _versions() -> str:
    import cv2
    import numpy as np
    from osgeo import gdal
    from qgis.core import Qgis

    return f"QGIS {Qgis.QGIS_VERSION}, GDAL {gdal.__version__}, OpenCV {cv2.__version__}, numpy {np.__version__}"


def _commit(repository: Path) -> str:
    def git(*arguments: str) -> str:
        done = subprocess.run(["git", "-C", str(repository), *arguments], capture_output=True, text=True, check=False)
        return done.stdout.strip()

    changed = " with changes" if git("status", "--porcelain", "--untracked-files=no") else ""
    return (git("rev-parse", "--short", "HEAD") or "no commit") + changed
