"""What was measured on what: machine, versions, state of the code, date."""

from __future__ import annotations

import datetime
import os
import platform
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def footer(command: str, area: str, load_before: float) -> str:
    """Markdown that says how the figures above it came about."""
    return (
        f"*{area} `{command}` on {datetime.date.today().isoformat()}, {revision()}. {hardware()}, "
        f"load before the run {load_before:.1f}; {versions()}.*"
    )


def load() -> float:
    """How many processes wanted to run in the last minute."""
    return os.getloadavg()[0]


def hardware() -> str:
    memory_gib = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return f"{_processor()}, {os.cpu_count()} cores, {memory_gib:.0f} GiB, {_system()}"


def versions() -> str:
    import cv2
    import numpy
    from osgeo import gdal
    from qgis.core import Qgis

    qgis = Qgis.QGIS_VERSION.split("-")[0]
    gdal_release = gdal.VersionInfo("RELEASE_NAME")
    return (
        f"QGIS {qgis}, GDAL {gdal_release}, numpy {numpy.__version__}, OpenCV {cv2.__version__}, "
        f"Python {platform.python_version()}"
    )


def revision() -> str:
    """The commit of the plugin's code, and whether shipped code was changed since."""
    commit = _git("rev-parse", "--short", "HEAD")
    changed = _git("status", "--porcelain", "--", "core", "storage", "processing")
    return f"commit {commit or 'unknown'}{' with changes' if changed else ''}"


def _git(*arguments: str) -> str:
    command = ["git", "-C", str(ROOT), *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()


def _processor() -> str:
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


def _system() -> str:
    try:
        return platform.freedesktop_os_release()["PRETTY_NAME"]
    except (OSError, KeyError, AttributeError):
        return platform.platform()
