"""What a report of a fault needs to say about a QGIS: versions, packages, devices, the last messages, no names."""

from __future__ import annotations

import contextlib
import getpass
import importlib.util
import os
import platform
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from qgis.core import Qgis, QgsProject, QgsSettings
from qgis.PyQt.QtCore import PYQT_VERSION_STR, QT_VERSION_STR, QLocale

from ..version import guide_url, plugin_version
from .components import PACKAGES, Package, components_root, installed_version, is_missing, is_too_old
from .devices import available_devices, chosen_device
from .training_environment import PYTHON_SETTING, is_environment_ready
from .unnamed import unnamed

_PLUGIN = Path(__file__).resolve().parents[2]


def diagnostics(lines: Sequence[str] = ()) -> str:
    """In English, to be pasted into an issue: what runs here, and the last messages.

    Args:
        lines: Of the log, the newest last.
    """
    devices = ", ".join(device.title for device in available_devices())
    told = [
        f"SemRef {plugin_version()}, guide {'as pages' if guide_url().endswith('.html') else 'as text'}",
        f"QGIS {Qgis.QGIS_VERSION}, Qt {QT_VERSION_STR}, PyQt {PYQT_VERSION_STR}, GDAL {_gdal_version()}",
        f"Python {platform.python_version()}, numpy {np.__version__}",
        f"{_system()}, {platform.machine()}, {os.cpu_count()} processors",
        f"Language {_language()}, theme {QgsSettings().value('UI/UITheme', 'default', type=str)}",
        *(f"{package.title}: {_state(package)}" for package in PACKAGES),
        f"Device: {chosen_device()} chosen; there: {devices or 'none'}",
        f"Training: {_training()}",
    ]
    log = unnamed("\n".join(lines), str(_PLUGIN), _private()) if lines else "(none)"
    return "\n".join([*told, "", "Last messages:", log]) + "\n"


def _gdal_version() -> str:
    # Loaded by storage, which reads files; this module has nothing else to do with it.
    return getattr(sys.modules.get("osgeo.gdal"), "__version__", "not loaded yet")


def _system() -> str:
    release = platform.freedesktop_os_release() if hasattr(platform, "freedesktop_os_release") and _is_linux() else {}
    return release.get("PRETTY_NAME", "") or f"{platform.system()} {platform.release()}"


def _is_linux() -> bool:
    return platform.system() == "Linux" and Path("/etc/os-release").is_file()


def _language() -> str:
    settings = QgsSettings()
    chosen = settings.value("locale/userLocale", "", type=str)
    return chosen if settings.value("locale/overrideFlag", False, type=bool) else QLocale.system().name()


def _state(package: Package) -> str:
    if is_too_old(package):
        return f"{installed_version(package)}, too old"
    if is_missing(package):
        return "missing"
    origin = importlib.util.find_spec(package.module).origin or ""
    whose = "installed by SemRef" if origin.startswith(str(components_root())) else "of QGIS or the system"
    return f"{installed_version(package) or 'of unknown version'}, {whose}"


def _training() -> str:
    if QgsSettings().value(PYTHON_SETTING, "", type=str):
        return "another Python was chosen"
    return "its environment is ready" if is_environment_ready() else "no environment"


def _private() -> list[str]:
    """Names of the user, the machine, the project and its layers, and the user's folder."""
    project = QgsProject.instance()
    names = [platform.node(), project.title(), project.baseName(), str(Path.home())]
    # As of a user whom the system does not know, in containers.
    with contextlib.suppress(OSError, KeyError, ImportError):
        names.append(getpass.getuser())
    return [*names, *(layer.name() for layer in project.mapLayers().values() if layer is not None)]
