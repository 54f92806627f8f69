"""Diagnostics for a bug report: versions, packages, settings, and the last messages."""

from __future__ import annotations

import os
import platform
import re
import sys
from collections.abc import Sequence

import numpy as np
from qgis.core import Qgis, QgsApplication, QgsSettings
from qgis.PyQt.QtCore import PYQT_VERSION_STR, QT_VERSION_STR, QSysInfo

from ..version import plugin_version
from .components import PACKAGES, Package, installed_version, is_missing, is_own, is_too_old
from .devices import available_devices, chosen_device
from .training_environment import PYTHON_SETTING, is_environment_ready


def diagnostics(lines: Sequence[str] = ()) -> str:
    """Return versions, settings and the last messages, in English, to paste into an issue.

    Args:
        lines: Lines of the log, the newest last.
    """
    # Loaded by storage; this module does not need it.
    gdal = getattr(sys.modules.get("osgeo.gdal"), "__version__", "not loaded yet")
    devices = ", ".join(device.title for device in available_devices())
    theme = QgsSettings().value("UI/UITheme", "default", type=str)
    report = [
        f"SemRef {plugin_version()}",
        f"QGIS {Qgis.QGIS_VERSION}, Qt {QT_VERSION_STR}, PyQt {PYQT_VERSION_STR}, GDAL {gdal}",
        f"Python {platform.python_version()}, numpy {np.__version__}",
        f"{QSysInfo.prettyProductName()}, {platform.machine()}, {os.cpu_count()} processors",
        f"Language {QgsApplication.locale()}, theme {theme}",
        *(f"{package.title}: {_state(package)}" for package in PACKAGES),
        f"Device: {chosen_device()} chosen; there: {devices or 'none'}",
        f"Training: {_training()}",
        "",
        "Last messages:",
        *(lines or ["(none)"]),
    ]
    return without_home("\n".join(report) + "\n", os.path.expanduser("~"))


def without_home(text: str, home: str) -> str:
    """Replace the user's home folder by ~, with any kind of slashes."""
    names = re.split(r"[/\\]+", home.rstrip("/\\"))
    pattern = r"[/\\]+".join(map(re.escape, names))
    return re.sub(rf"(?<![\w.~-]){pattern}(?![\w-])", "~", text, flags=re.IGNORECASE) if any(names) else text


def _state(package: Package) -> str:
    if is_too_old(package):
        return f"{installed_version(package)}, too old"
    if is_missing(package):
        return "missing"
    whose = "installed by SemRef" if is_own(package) else "of QGIS or the system"
    return f"{installed_version(package) or 'of unknown version'}, {whose}"


def _training() -> str:
    if QgsSettings().value(PYTHON_SETTING, "", type=str):
        return "another Python was chosen"
    return "its environment is ready" if is_environment_ready() else "no environment"
