"""Python packages that QGIS doesn't bring everywhere: which, what for, where SemRef keeps its own, what to type.

SemRef installs into the user profile: one folder for each package and version of Python and numpy, which binaries
depend on. These folders come last on Python's path: what QGIS or the system has counts first.
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

import qgis.utils
from qgis.core import QgsApplication

from ...core.errors import ComponentError
from ..translation import tr


@dataclass(frozen=True)
class Package:
    """A Python package: its name on screen, in code and in pip's index."""

    title: str
    module: str
    pip_name: str
    newest_part: str = ""
    """A module in it that versions too old for SemRef lack."""
    limits: str = ""
    """Versions that tests passed with (tools/test_newest.sh), and so the ones that pip may take."""
    limits_before_numpy_2: str = ""
    """The same with numpy 1, where it differs."""
    other_names: tuple[str, ...] = ()
    """Names under which the same module is packaged, too."""
    comes_with: tuple[str, ...] = ()
    """Other packages that it needs and QGIS may lack, by pip's names; they lie in its folder."""

    @property
    def folder(self) -> Path:
        """Where SemRef installs it for the running Python and numpy."""
        return components_folder() / self.pip_name

    @property
    def needed_module(self) -> str:
        """A module that is there when the package is there and new enough."""
        return f"{self.module}.{self.newest_part}" if self.newest_part else self.module

    def requirement(self, numpy_version: str) -> str:
        """What pip is asked for where it may choose, such as ``opencv-python-headless>=4.5,<4.12``."""
        return self.pip_name + self.tested(numpy_version)

    def tested(self, numpy_version: str) -> str:
        """The versions that tests passed with, such as ``>=4.5,<4.12``."""
        return (_numpy_1(numpy_version) and self.limits_before_numpy_2) or self.limits

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


def numpy_version() -> str:
    """Return the version of QGIS's numpy without loading it, which would take a third of the plugin's start."""
    loaded = sys.modules.get("numpy")
    if loaded is None:
        try:
            return importlib.metadata.version("numpy")
        except importlib.metadata.PackageNotFoundError:
            import numpy as loaded
    return loaded.__version__


def _numpy_1(version: str) -> bool:
    return int(version.partition(".")[0]) < 2


OPENCV = Package(
    title="OpenCV",
    module="cv2",
    pip_name="opencv-python-headless",
    limits=">=4.10,<5.1",
    # 4.12 asks for numpy 2.
    limits_before_numpy_2=">=4.5,<4.12",
    other_names=("opencv-python", "opencv-contrib-python", "opencv-contrib-python-headless", "opencv"),
)
PILLOW = Package(title="Pillow", module="PIL", pip_name="pillow", limits=">=9.1,<14")
SHAPELY = Package(
    title="Shapely",
    module="shapely",
    pip_name="shapely",
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
    # From 1.19 its wheels work with numpy 1 and 2.
    limits=">=1.19,<1.32",
    other_names=("onnxruntime-gpu", "onnxruntime-directml", "onnxruntime-openvino"),
)
ONNXRUNTIME_VARIANTS = tuple(
    replace(ONNXRUNTIME, title=title, pip_name=name, other_names=())
    for name, title in (
        ("onnxruntime-gpu", "ONNX Runtime, CUDA"),
        ("onnxruntime-directml", "ONNX Runtime, DirectML"),
        ("onnxruntime-openvino", "ONNX Runtime, OpenVINO"),
    )
)
"""The same module with more devices (core/segmentation/devices.py)."""

DASK = Package(
    title="Dask",
    module="distributed",
    pip_name="distributed",
    limits=">=2024.8,<2027",
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
    limits=">=38,<51",
    comes_with=("cffi", "pycparser", "typing_extensions"),
)

PACKAGES = (OPENCV, PILLOW, SHAPELY, ONNXRUNTIME, DASK, CRYPTOGRAPHY)
NEEDED = (OPENCV, PILLOW)
"""Nothing works without them."""
OPTIONAL = (DASK, CRYPTOGRAPHY)
"""Not suggested: nothing but SCHEDULER needs them."""


def purpose(package: Package) -> str:
    """What the package is for, in the user's language."""
    return {
        OPENCV: tr("Everything: label maps, databases, localization"),
        PILLOW: tr("Everything: images, and what cameras write into photos"),
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


def origin(package: Package) -> str:
    """The file that Python imports; empty where there is none, as after its removal from the disk."""
    found = importlib.util.find_spec(package.module)
    return "" if found is None else found.origin or ""


def is_own(package: Package) -> bool:
    """Whether Python imports a package that SemRef installed."""
    return origin(package).startswith(str(components_root()))


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
    return components_root() / components_key(sys.version_info, numpy_version())


def add_components_to_path() -> None:
    """Appends what SemRef installed to Python's path, the newest first; nothing where nothing is installed."""
    # One that is being installed begins with a dot.
    folders = [folder for folder in components_folder().glob("[!.]*") if folder.is_dir()]
    newest_first = sorted(folders, key=lambda folder: folder.stat().st_mtime, reverse=True)
    sys.path.extend(folder for folder in map(str, newest_first) if folder not in sys.path)
    importlib.invalidate_caches()


def remove_components() -> None:
    """Removes all that SemRef installed, for other versions of Python and numpy too; raises ComponentError."""
    root = components_root()
    if not root.exists():
        return
    try:
        shutil.rmtree(root)
    except OSError as error:
        raise ComponentError(
            "{name} can’t be removed, probably because it is in use; restart QGIS and remove it again.",
            name=error.filename or root,
        ) from error
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
        raise ComponentError(
            "SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef.",
            packages=", ".join(package.title for package in lacking),
        )
    raise ComponentError(
        "SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef, or by typing "
        "{commands}.",
        packages=", ".join(package.pip_name for package in lacking),
        commands=f"“{install_command(lacking)}”",
    )


def install_command(packages: list[Package]) -> str:
    """A command for pip that installs packages without SemRef."""
    # Without dependencies: pip must not replace QGIS's numpy.
    asked = (name for package in packages for name in package.asked(numpy_version()))
    requirements = ("'" + text + "'" if '"' in text else f'"{text}"' for text in asked)
    python = os.path.join(sys.prefix, "bin", "python3")
    # pip refuses to install beside the distribution's packages unless it is told to; --user leaves those alone.
    managed = os.path.isfile(os.path.join(sysconfig.get_path("stdlib"), "EXTERNALLY-MANAGED"))
    options = ["--user", "--break-system-packages"] if managed and sys.prefix == sys.base_prefix else []
    program = python if os.path.isfile(python) else "python3"
    return " ".join([program, "-m pip install --no-deps", *options, *requirements])


def how_to_get_pip() -> str:
    """What to do where QGIS's Python has no pip, as the end of a sentence."""
    if os.name == "nt":
        return tr("add the package python3-pip with OSGeo4W’s setup")
    # Debian and Ubuntu have no ensurepip.
    command = "sudo apt install python3-pip" if shutil.which("apt") else "python3 -m ensurepip --user"
    return tr("install it with “{command}”").format(command=command)
