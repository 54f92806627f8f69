"""Python packages that QGIS doesn't bring everywhere: which, what for, where SemRef keeps its own, what to type.

SemRef's own lie in the user profile, a folder for each package under one for Python's and numpy's version, because
their binaries fit those alone. They come last on Python's path: what QGIS or the system has counts first.
"""

from __future__ import annotations

import importlib.util
import os
import shutil
import sys
from dataclasses import dataclass
from importlib.machinery import PathFinder
from pathlib import Path
from typing import Iterable, List

import numpy as np
from qgis.core import QgsApplication

from ...core.errors import ComponentError
from ...core.sentences import Sentence
from ..translation import tr


@dataclass(frozen=True)
class Package:
    """A Python package: what it is called in code, by pip, and by those who package for a system."""

    title: str
    module: str
    pip_name: str
    debian: str
    fedora: str
    arch: str
    conda: str
    newest_part: str = ""
    """A module in it that versions too old for SemRef lack."""
    limits: str = ""
    limits_before_numpy_2: str = ""

    @property
    def needed_module(self) -> str:
        """A module that is there when the package is there and new enough."""
        return f"{self.module}.{self.newest_part}" if self.newest_part else self.module

    def requirement(self, numpy_version: str) -> str:
        """What pip is asked for, such as ``opencv-python-headless<4.12``."""
        before_2 = int(numpy_version.partition(".")[0]) < 2
        return self.pip_name + (self.limits_before_numpy_2 if before_2 else self.limits)


OPENCV = Package(
    title="OpenCV",
    module="cv2",
    pip_name="opencv-python-headless",
    debian="python3-opencv",
    fedora="python3-opencv",
    arch="python-opencv",
    conda="opencv",
    limits=">=4.10",
    # 4.12 asks for numpy 2.
    limits_before_numpy_2="<4.12",
)
SHAPELY = Package(
    title="Shapely",
    module="shapely",
    pip_name="shapely",
    debian="python3-shapely",
    fedora="python3-shapely",
    arch="python-shapely",
    conda="shapely",
    newest_part="constructive",
    # From 2.0.5 its wheels work with numpy 1 and 2.
    limits=">=2.0.5",
    limits_before_numpy_2=">=2",
)
# Its wheels ask pip for flatbuffers, protobuf, sympy, … too; a network is read and run without them.
ONNXRUNTIME = Package(
    title="ONNX Runtime",
    module="onnxruntime",
    pip_name="onnxruntime",
    debian="python3-onnxruntime",
    fedora="python3-onnxruntime",
    arch="python-onnxruntime",
    conda="onnxruntime",
    # From 1.19 its wheels work with numpy 1 and 2.
    limits=">=1.19",
)
PACKAGES = (OPENCV, SHAPELY, ONNXRUNTIME)


def purpose(package: Package) -> str:
    """What the package is for, in the user's language."""
    return {
        OPENCV: tr("Everything: label maps, databases, localization"),
        SHAPELY: tr("Checking and repairing annotations, making the sample project"),
        ONNXRUNTIME: tr("Segmenting photos with a network"),
    }[package]


def is_missing(package: Package) -> bool:
    spec = importlib.util.find_spec(package.module)
    return spec is None or is_too_old(package)


def is_too_old(package: Package) -> bool:
    """Whether the package is there in a version that SemRef can't use."""
    spec = importlib.util.find_spec(package.module)
    if spec is None or not package.newest_part:
        return False
    # Without importing the package, unlike importlib.util.find_spec.
    return PathFinder.find_spec(package.needed_module, spec.submodule_search_locations) is None


def missing(packages: Iterable[Package] = PACKAGES) -> List[Package]:
    return [package for package in packages if is_missing(package)]


# --- SemRef's own folder ---


def components_root() -> Path:
    """Holds the packages that SemRef installed, for all versions of Python and numpy that this profile has seen."""
    return Path(QgsApplication.qgisSettingsDirPath()) / "python" / "semref_components"


def components_key(python_version: tuple, numpy_version: str) -> str:
    """Such as ``cp311-numpy1.24``."""
    return f"cp{python_version[0]}{python_version[1]}-numpy{'.'.join(numpy_version.split('.')[:2])}"


def components_folder() -> Path:
    """Holds a folder for each package that SemRef installed for the running Python and numpy."""
    return components_root() / components_key(sys.version_info, np.__version__)


def add_components_to_path() -> None:
    """Appends what SemRef installed to Python's path; nothing where nothing is installed."""
    for package in PACKAGES:
        folder = str(components_folder() / package.module)
        if os.path.isdir(folder) and folder not in sys.path:
            sys.path.append(folder)
    importlib.invalidate_caches()


def remove_components() -> None:
    """Removes all that SemRef installed, for other versions of Python and numpy too; raises ComponentError."""
    root = components_root()
    if not root.exists():
        return
    try:
        shutil.rmtree(root)
    except OSError as error:
        raise ComponentError("packages.not_removed", name=error.filename or root) from error
    sys.path[:] = [entry for entry in sys.path if not entry.startswith(str(root))]
    importlib.invalidate_caches()


# --- what to type ---


def how_to_install(packages: List[Package]) -> Sentence:
    """What algorithms say that lack packages."""
    commands = dict.fromkeys([install_command(packages), _pip_install(packages)])
    return Sentence(
        "packages.needed",
        packages=", ".join(package.pip_name for package in packages),
        commands=" / ".join(f"“{command}”" for command in commands),
    )


def install_command(packages: List[Package]) -> str:
    """What installs packages without SemRef: the system's package manager where it is known, else pip."""
    manager = _package_manager()
    if manager in _INSTALL:
        return " ".join([_INSTALL[manager], *(getattr(package, manager) for package in packages)])
    return _pip_install(packages)


def _pip_install(packages: List[Package]) -> str:
    # Without dependencies: pip must not replace QGIS's numpy.
    requirements = (f'"{package.requirement(np.__version__)}"' for package in packages)
    return " ".join(["python3 -m pip install --no-deps", *requirements])


def how_to_get_pip() -> str:
    """What to do where QGIS's Python has no pip, as the end of a sentence."""
    manager = _package_manager()
    if manager in _INSTALL:
        name = "python-pip" if manager == "arch" else "pip" if manager == "conda" else "python3-pip"
        return tr("install it with “{command}”").format(command=f"{_INSTALL[manager]} {name}")
    if os.name == "nt":
        return tr("add the package python3-pip with OSGeo4W’s setup")
    return tr("install it with “{command}”").format(command="python3 -m ensurepip --user")


_INSTALL = {
    "conda": "conda install -c conda-forge",
    "debian": "sudo apt install",
    "fedora": "sudo dnf install",
    "arch": "sudo pacman -S",
}


def _package_manager() -> str:
    """A key of _INSTALL, or nothing."""
    if (Path(sys.prefix) / "conda-meta").is_dir():
        return "conda"
    release = Path("/etc/os-release")
    return system_family(release.read_text(encoding="utf-8")) if release.is_file() else ""


def system_family(os_release: str) -> str:
    """debian, fedora, arch or nothing, from the text of /etc/os-release."""
    fields = dict(line.split("=", 1) for line in os_release.splitlines() if "=" in line)
    names = f"{fields.get('ID', '')} {fields.get('ID_LIKE', '')}".replace('"', "").split()
    return next((name for name in names if name in ("debian", "fedora", "arch")), "")
