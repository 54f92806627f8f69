"""The Python that trains networks: one that the user names, or an environment that SemRef makes on request.

torch never comes into QGIS's Python: it is large, and brings a numpy of its own.
"""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

from qgis.core import QgsApplication, QgsSettings

from ...core.errors import ComponentError

PYTHON_SETTING = "semref/options/training_python"
REQUIREMENTS = Path(__file__).resolve().parents[2] / "training" / "requirements.txt"

_MARK = "semref_ready.txt"
"""In an environment that was made to its end."""


def environment_folder() -> Path:
    """Where SemRef's own environment lies, in the user profile."""
    return Path(QgsApplication.qgisSettingsDirPath()) / "python" / "semref_training"


def environment_python(folder: Path) -> Path:
    """The Python of an environment."""
    return folder / "Scripts" / "python.exe" if os.name == "nt" else folder / "bin" / "python"


def is_environment_ready() -> bool:
    """Whether SemRef's own environment was made."""
    return (environment_folder() / _MARK).is_file()


def training_python(asked: str = "") -> str:
    """The Python to train with: the one asked for, else that of the options, else SemRef's own environment's.

    Raises:
        ComponentError: There is none.
    """
    python = asked or QgsSettings().value(PYTHON_SETTING, "", type=str)
    if python:
        if not shutil.which(python):
            raise ComponentError("packages.no_such_python", python=python)
        return python
    if not is_environment_ready():
        raise ComponentError("packages.no_training_python")
    return str(environment_python(environment_folder()))


def remove_environment() -> None:
    """Removes SemRef's own environment; raises ComponentError."""
    folder = environment_folder()
    if not folder.exists():
        return
    try:
        (folder / _MARK).unlink(missing_ok=True)
        shutil.rmtree(folder)
    except OSError as error:
        raise ComponentError("packages.not_removed", name=error.filename or folder) from error


def mark_ready(version: str) -> None:
    """Says that the environment is whole."""
    (environment_folder() / _MARK).write_text(f"torch {version}, Python {sys.version}\n", encoding="utf-8")
