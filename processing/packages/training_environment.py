"""The Python that trains networks: one that the user names, or an environment that SemRef makes on request.

torch never comes into QGIS's Python: it is large, and brings a numpy of its own.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import sys
from collections.abc import Generator, Iterator
from pathlib import Path

from qgis.core import QgsApplication, QgsSettings

from ...core.errors import ComponentError
from ..translation import tr
from .install import Answer, Command, Commands, last_error, last_line, pip_variables, python_candidates

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
            raise ComponentError(
                "{python} is no program; choose the Python that trains, or leave it out.", python=python
            )
        return python
    if not is_environment_ready():
        raise ComponentError(
            "Training needs a Python of its own with torch: have SemRef make one under Settings ▸ Options ▸ SemRef "
            "(about 1.5 GB, more with support for graphics cards), or name one in PYTHON."
        )
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
        raise ComponentError(
            "{name} can’t be removed, probably because it is in use; restart QGIS and remove it again.",
            name=error.filename or folder,
        ) from error


# --- making one ---


def making_environment(wheels: str = "", without_graphics_card: bool = False) -> Commands:
    """Makes SemRef's own environment, as ``install.installing`` does: commands out, answers in.

    Args:
        wheels: A folder of wheels to take everything from instead of the package index.
        without_graphics_card: Whether torch comes from its makers' index of builds for processors alone, which are a
            small part of the size on Linux.

    Raises:
        ComponentError: With the reason; nothing of the environment stays then.
    """
    folder = environment_folder()
    remove_environment()
    with _whole(folder):
        base = yield from _base_python()
        title = tr("Making an environment for training…")
        made = yield Command(title, base, ["-m", "venv", str(folder)], str(folder.parent), _APART)
        python = str(environment_python(folder))
        if made.status != 0 or not os.path.isfile(python):
            raise ComponentError(
                "{python} can’t make an environment ({reason}); on Debian and Ubuntu install python3-venv, elsewhere "
                "name another Python with torch.",
                python=base,
                reason=last_line(made.output),
            )
        for arguments in _pip_runs(wheels, without_graphics_card):
            yield from _install(python, folder, arguments)
        title = tr("Checking torch…")
        answer = yield Command(title, python, [str(REQUIREMENTS.parent)], str(folder), _APART)
        if answer.status != 0:
            raise ComponentError(
                "torch was installed, but can’t be used: {reason}; it was removed again.",
                reason=last_line(answer.output),
            )
        (folder / _MARK).write_text(answer.output, encoding="utf-8")


_APART = {"PYTHONHOME": "", "PYTHONPATH": "", "PYTHONDONTWRITEBYTECODE": "1"}
"""QGIS leads its own Python by the first two, and another one astray."""

_PROCESSOR_BUILDS = "https://download.pytorch.org/whl/cpu"
"""torch's builds for processors alone, by its makers; the common index has those for NVIDIA's cards on Linux."""


@contextlib.contextmanager
def _whole(folder: Path) -> Iterator[None]:
    """Removes the folder unless the block ends well."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    done = False
    try:
        yield
        done = True
    finally:
        if not done:
            shutil.rmtree(folder, ignore_errors=True)


def _base_python() -> Generator[Command, Answer, str]:
    """A Python that can make environments: QGIS's own, or one like it."""
    tried = ("", "")
    candidates = python_candidates(sys.executable or "", sys.prefix, sys.version_info[:2], os.name == "nt")
    for path in filter(os.path.isfile, candidates):
        title = tr("Looking for QGIS’s Python…")
        answer = yield Command(title, path, ["-c", "import venv, ensurepip"], os.path.dirname(path), _APART)
        if answer.status == 0:
            return path
        tried = path, last_line(answer.output)
    raise ComponentError(
        "{python} can’t make an environment ({reason}); on Debian and Ubuntu install python3-venv, elsewhere name "
        "another Python with torch.",
        python=tried[0] or ", ".join(candidates),
        reason=tried[1] or "venv",
    )


def _pip_runs(wheels: str, without_graphics_card: bool) -> list[list[str]]:
    """Arguments of each run of pip."""
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
    title = tr("Installing torch and what goes with it; this takes minutes…")
    pip = yield Command(title, python, ["-m", "pip", "install", *options, *arguments], str(folder), variables)
    shutil.rmtree(temporary, ignore_errors=True)
    if pip.status != 0:
        raise ComponentError(
            "The environment for training could not be filled: {reason}.", reason=last_error(pip.output)
        )
