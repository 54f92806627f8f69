"""Python packages that QGIS doesn't bring everywhere: which, what for, where SemRef keeps its own, what to type.

SemRef's own lie in the user profile, a folder for each package under one for Python's and numpy's version, because
their binaries fit those alone. They come last on Python's path: what QGIS or the system has counts first.
"""

from __future__ import annotations

import importlib.metadata
import importlib.util
import os
import re
import shutil
import sys
import sysconfig
from collections.abc import Iterable
from dataclasses import dataclass, replace
from importlib.machinery import PathFinder
from pathlib import Path

import numpy as np
import qgis.utils
from qgis.core import QgsApplication

from ...core.errors import ComponentError
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
    """Versions that tests passed with (tools/test_newest.sh), and so the ones that pip may take."""
    limits_before_numpy_2: str = ""
    other_names: tuple[str, ...] = ()
    """Names under which the same module is packaged, too."""
    own_folder: str = ""
    """Of those that SemRef installed; that of its module where this is empty."""
    comes_with: tuple[str, ...] = ()
    """Other packages that it needs and QGIS may lack, by pip's names; they lie in its folder."""

    @property
    def folder(self) -> Path:
        """Where SemRef installs it for the running Python and numpy."""
        return components_folder() / (self.own_folder or self.module)

    @property
    def needed_module(self) -> str:
        """A module that is there when the package is there and new enough."""
        return f"{self.module}.{self.newest_part}" if self.newest_part else self.module

    def requirement(self, numpy_version: str) -> str:
        """What pip is asked for where it may choose, such as ``opencv-python-headless>=4.5,<4.12``."""
        return self.pip_name + self.tested(numpy_version)

    def tested(self, numpy_version: str) -> str:
        """The versions that tests passed with, such as ``>=4.5,<4.12``."""
        return self.limits_before_numpy_2 if _numpy_1(numpy_version) else self.limits

    def asked(self, numpy_version: str) -> list[str]:
        """What pip is asked for where it may choose: the package, and what comes with it."""
        pinned = (line.partition(" --hash")[0] for line in self.pinned(numpy_version))
        others = [re.sub(r"==\S+", "", line) for line in pinned if not line.startswith(f"{self.pip_name}==")]
        return [self.requirement(numpy_version), *dict.fromkeys(others)]

    def pinned(self, numpy_version: str) -> list[str]:
        """The versions that are installed from the index, with the hashes of their wheels: lines for pip."""
        file = Path(__file__).parent / f"wheels_numpy{1 if _numpy_1(numpy_version) else 2}.txt"
        lines = file.read_text(encoding="ascii").splitlines()
        starts = tuple(f"{name}==" for name in (self.pip_name, *self.comes_with))
        return [line for line in lines if line.startswith(starts)]


def _numpy_1(version: str) -> bool:
    return int(version.partition(".")[0]) < 2


OPENCV = Package(
    title="OpenCV",
    module="cv2",
    pip_name="opencv-python-headless",
    debian="python3-opencv",
    fedora="python3-opencv",
    arch="python-opencv",
    conda="opencv",
    limits=">=4.10,<5.1",
    # 4.12 asks for numpy 2.
    limits_before_numpy_2=">=4.5,<4.12",
    other_names=("opencv-python", "opencv-contrib-python", "opencv-contrib-python-headless", "opencv"),
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
    limits=">=2.0.5,<2.3",
    limits_before_numpy_2=">=2,<2.3",
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
    limits=">=1.19,<1.32",
    limits_before_numpy_2=">=1.19,<1.32",
    other_names=("onnxruntime-gpu", "onnxruntime-directml", "onnxruntime-openvino"),
)
ONNXRUNTIME_VARIANTS = tuple(
    replace(
        ONNXRUNTIME,
        title=title,
        pip_name=name,
        **dict.fromkeys(("debian", "fedora", "arch", "conda"), ""),
        other_names=(),
        own_folder=name,
    )
    for name, title in (
        ("onnxruntime-gpu", "ONNX Runtime, CUDA"),
        ("onnxruntime-directml", "ONNX Runtime, DirectML"),
        ("onnxruntime-openvino", "ONNX Runtime, OpenVINO"),
    )
)
"""The same module with more devices (core/segmentation/devices.py); a folder of its own keeps what runs from being
replaced, and the newest one comes first."""

DASK = Package(
    title="Dask",
    module="distributed",
    pip_name="distributed",
    debian="python3-distributed",
    fedora="python3-distributed",
    arch="python-distributed",
    conda="distributed",
    limits=">=2024.8,<2027",
    limits_before_numpy_2=">=2024.8,<2027",
    comes_with=(
        *("dask", "click", "cloudpickle", "fsspec", "importlib_metadata", "jinja2", "locket", "markupsafe", "msgpack"),
        *("packaging", "partd", "psutil", "pyyaml", "sortedcontainers", "tblib", "toolz", "tornado", "urllib3"),
        *("zict", "zipp"),
    ),
)
CRYPTOGRAPHY = Package(
    title="cryptography",
    module="cryptography",
    pip_name="cryptography",
    debian="python3-cryptography",
    fedora="python3-cryptography",
    arch="python-cryptography",
    conda="cryptography",
    limits=">=38,<51",
    limits_before_numpy_2=">=38,<51",
    comes_with=("cffi", "pycparser", "typing_extensions"),
)

PACKAGES = (OPENCV, SHAPELY, ONNXRUNTIME, DASK, CRYPTOGRAPHY)
OPTIONAL = (DASK, CRYPTOGRAPHY)
"""Not suggested: nothing but SCHEDULER needs them."""


def purpose(package: Package) -> str:
    """What the package is for, in the user's language."""
    return {
        OPENCV: tr("Everything: label maps, databases, localization"),
        SHAPELY: tr("Checking and repairing annotations"),
        ONNXRUNTIME: tr("Segmenting photos with a network"),
        DASK: tr("Building databases and label maps by many processes or machines"),
        CRYPTOGRAPHY: tr("Dask on this machine: keeps other users out of its processes"),
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


def installed_version(package: Package) -> str:
    """Such as ``4.11.0.86``; empty where it is missing or does not tell, as some systems' packages do not."""
    names = (package.pip_name, *package.other_names)
    found = (entry.version for name in names for entry in importlib.metadata.distributions(name=name))
    version = next(found, "") or str(getattr(sys.modules.get(package.module), "__version__", ""))
    # What a build does not know about itself, as Debian's Shapely.
    return "" if "unknown" in version else version


def is_tested(version: str, limits: str) -> bool:
    """Whether a version lies within limits such as ``>=4.5,<4.12``."""
    lowest, highest = (_numbers(limit.lstrip("<>=")) for limit in limits.split(","))
    return lowest <= _numbers(version) < highest


def _numbers(version: str) -> tuple[int, ...]:
    return tuple(int(number) for number in re.findall(r"\d+", version.partition("+")[0]))


def missing(packages: Iterable[Package] = PACKAGES) -> list[Package]:
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
    variants = [package.folder for package in ONNXRUNTIME_VARIANTS if package.folder.is_dir()]
    newest_first = sorted(variants, key=lambda folder: folder.stat().st_mtime, reverse=True)
    for folder in map(str, (*newest_first, *(package.folder for package in PACKAGES))):
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


def require(packages: Iterable[Package]) -> None:
    """Raises ComponentError, which says how to install them, where packages are missing."""
    lacking = missing(packages)
    if not lacking:
        return
    if qgis.utils.iface is not None:
        # Short, and without the < of a command: QGIS shows it as HTML. The options have the command as well.
        raise ComponentError("packages.needed_in_window", packages=", ".join(package.title for package in lacking))
    commands = dict.fromkeys([install_command(lacking), _pip_install(lacking)])
    raise ComponentError(
        "packages.needed",
        packages=", ".join(package.pip_name for package in lacking),
        commands=" / ".join(f"“{command}”" for command in commands),
    )


def install_command(packages: list[Package]) -> str:
    """What installs packages without SemRef: the system's package manager for what it has, pip for the rest."""
    manager = _package_manager()
    if manager not in _INSTALL:
        return _pip_install(packages)
    lacking = set() if manager == "conda" else lacking_in_release(_os_release())
    there = [package for package in packages if package.module not in lacking and getattr(package, manager)]
    others = [package for package in packages if package not in there]
    commands = [" ".join([_INSTALL[manager], *(getattr(package, manager) for package in there)])] if there else []
    return " && ".join(commands + ([_pip_install(others)] if others else []))


def _pip_install(packages: list[Package]) -> str:
    # Without dependencies: pip must not replace QGIS's numpy.
    asked = (name for package in packages for name in package.asked(np.__version__))
    requirements = ("'" + text + "'" if '"' in text else f'"{text}"' for text in asked)
    python = os.path.join(sys.prefix, "bin", "python3")
    # pip refuses to install beside the distribution's packages unless it is told to; --user leaves those alone.
    managed = os.path.isfile(os.path.join(sysconfig.get_path("stdlib"), "EXTERNALLY-MANAGED"))
    options = ["--user", "--break-system-packages"] if managed and sys.prefix == sys.base_prefix else []
    program = python if os.path.isfile(python) else "python3"
    return " ".join([program, "-m pip install --no-deps", *options, *requirements])


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


_LACKING = {
    **dict.fromkeys(("focal", "jammy", "bullseye", "bookworm"), ("shapely", "onnxruntime")),
    "noble": ("onnxruntime",),
}
"""By code name of a release of Debian or Ubuntu: what it does not have, or too old (Shapely before 2)."""

_ENTERPRISE = ("rhel", "centos", "rocky", "almalinux", "ol")
"""IDs of systems like Fedora whose own archives have none of the packages."""


def _package_manager() -> str:
    """A key of _INSTALL, or nothing."""
    if (Path(sys.prefix) / "conda-meta").is_dir():
        return "conda"
    return system_family(_os_release())


def _os_release() -> str:
    release = Path("/etc/os-release")
    return release.read_text(encoding="utf-8") if release.is_file() else ""


def _release_fields(os_release: str) -> dict[str, str]:
    lines = (line.split("=", 1) for line in os_release.splitlines() if "=" in line)
    return {name: text.strip().strip("\"'") for name, text in lines}


def lacking_in_release(os_release: str) -> set[str]:
    """Modules that the archive of a release does not have in a version for SemRef, from the text of /etc/os-release."""
    fields = _release_fields(os_release)
    if fields.get("ID") in _ENTERPRISE:
        return {package.module for package in PACKAGES}
    # Of a system made from Ubuntu or Debian, such as Mint, first the name of what it was made from.
    names = (fields.get(key, "") for key in ("UBUNTU_CODENAME", "DEBIAN_CODENAME", "VERSION_CODENAME"))
    return set(_LACKING.get(next(filter(None, names), ""), ()))


def system_family(os_release: str) -> str:
    """debian, fedora, arch or nothing, from the text of /etc/os-release."""
    fields = _release_fields(os_release)
    names = f"{fields.get('ID', '')} {fields.get('ID_LIKE', '')}".split()
    return next((name for name in names if name in ("debian", "fedora", "arch")), "")
