"""The training environment: a Python that the user selects, or an environment that SemRef makes on request.

torch is never installed into QGIS's Python: it is large, and needs a numpy of its own.
"""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Generator
from contextlib import ExitStack
from pathlib import Path

from qgis.core import QgsApplication, QgsSettings

from ...core.errors import ComponentError
from ..translation import tr
from .components import remove_folder
from .install import Answer, Command, Commands, last_error, last_line, pip_variables, python_candidates

PYTHON_SETTING = "semref/options/training_python"
_ROOT = Path(__file__).resolve().parents[2]
REQUIREMENTS = _ROOT / "training" / "requirements.txt"

_MARK = "semref_ready.txt"
"""File in a complete environment."""


def environment_folder() -> Path:
    """Return the folder of SemRef's training environment in the user profile."""
    return Path(QgsApplication.qgisSettingsDirPath()) / "python" / "semref_training"


def environment_python(folder: Path) -> Path:
    return folder / "Scripts" / "python.exe" if os.name == "nt" else folder / "bin" / "python"


def is_environment_ready() -> bool:
    """Return whether SemRef's training environment is complete."""
    return (environment_folder() / _MARK).is_file()


def training_python(asked: str = "") -> str:
    """Return the Python for training: the given one, otherwise that of the options, otherwise SemRef's environment.

    Raises:
        ComponentError: Training is not possible.
    """
    python = asked or QgsSettings().value(PYTHON_SETTING, "", type=str)
    if python:
        if not shutil.which(python):
            raise ComponentError(
                "{python} is not executable. Select the Python of the training environment, or leave the field empty.",
                python=python,
            )
        return python
    if not is_environment_ready():
        raise ComponentError(
            "Training needs a Python with torch. Install the training environment under Settings ▸ Options ▸ SemRef "
            "(about 1.5 GB, more with support for graphics cards), or select a Python with torch."
        )
    return str(environment_python(environment_folder()))


def remove_environment() -> None:
    """Remove SemRef's training environment. Raises ComponentError."""
    remove_folder(environment_folder(), _MARK)


# --- making one ---


def making_environment(wheels: str = "", without_graphics_card: bool = False) -> Commands:
    """Make SemRef's training environment; yield commands and receive answers as ``install.installing`` does.

    Args:
        wheels: A folder of wheels to use instead of the package index.
        without_graphics_card: Whether to install torch's builds for processors only, which are much smaller on Linux.

    Raises:
        ComponentError: With the reason; nothing is left behind.
    """
    folder = environment_folder()
    remove_environment()
    folder.parent.mkdir(parents=True, exist_ok=True)
    with ExitStack() as incomplete:
        incomplete.callback(shutil.rmtree, folder, ignore_errors=True)
        base = yield from _base_python()
        title = tr("Making the training environment…")
        made = yield Command(title, base, ["-m", "venv", str(folder)], str(folder.parent), _APART)
        python = str(environment_python(folder))
        if made.status != 0 or not os.path.isfile(python):
            raise _no_environment(base, last_line(made.output))
        for arguments in _pip_runs(wheels, without_graphics_card):
            yield from _install(python, folder, arguments)
        title = tr("Checking torch…")
        answer = yield Command(title, python, [str(_ROOT / "program.py"), "training.command"], str(folder), _APART)
        if answer.status != 0:
            raise ComponentError(
                "torch was installed, but does not work: {reason}. It was removed again.",
                reason=last_line(answer.output),
            )
        (folder / _MARK).write_text(answer.output, encoding="utf-8")
        incomplete.pop_all()


_APART = {"PYTHONHOME": "", "PYTHONPATH": "", "PYTHONDONTWRITEBYTECODE": "1"}
"""QGIS's Python needs the first two; they would mislead another Python."""

_PROCESSOR_BUILDS = "https://download.pytorch.org/whl/cpu"
"""Index of torch's builds for processors only; the public index has builds for NVIDIA cards on Linux."""


def _base_python() -> Generator[Command, Answer, str]:
    """Return a Python that can make environments: QGIS's own, or one like it."""
    tried = ("", "")
    candidates = python_candidates(sys.executable or "", sys.prefix, sys.version_info[:2], os.name == "nt")
    for path in filter(os.path.isfile, candidates):
        title = tr("Searching for the Python of QGIS…")
        answer = yield Command(title, path, ["-c", "import venv, ensurepip"], os.path.dirname(path), _APART)
        if answer.status == 0:
            return path
        tried = path, last_line(answer.output)
    raise _no_environment(tried[0] or ", ".join(candidates), tried[1] or "venv")


def _no_environment(python: str, reason: str) -> ComponentError:
    return ComponentError(
        "{python} cannot make an environment ({reason}). Install python3-venv on Debian and Ubuntu, or select another "
        "Python with torch.",
        python=python,
        reason=reason,
    )


def _pip_runs(wheels: str, without_graphics_card: bool) -> list[list[str]]:
    if wheels:
        return [["--no-index", "--find-links", wheels, "--requirement", str(REQUIREMENTS)]]
    everything = ["--requirement", str(REQUIREMENTS)]
    if not without_graphics_card:
        return [everything]
    torch = [line for line in REQUIREMENTS.read_text(encoding="utf-8").splitlines() if line.startswith("torch")]
    return [["--index-url", _PROCESSOR_BUILDS, *torch], everything]


def _install(python: str, folder: Path, arguments: list[str]) -> Commands:
    temporary = folder / "tmp"
    temporary.mkdir(exist_ok=True)
    variables = {**_APART, **pip_variables(str(temporary))}
    options = ["--only-binary=:all:", "--no-input", "--disable-pip-version-check", "--progress-bar=off"]
    title = tr("Installing torch and its packages, which takes some minutes…")
    pip = yield Command(title, python, ["-m", "pip", "install", *options, *arguments], str(folder), variables)
    shutil.rmtree(temporary, ignore_errors=True)
    if pip.status != 0:
        raise ComponentError(
            "The packages of the training environment could not be installed: {reason}.", reason=last_error(pip.output)
        )
