"""Python packages that some QGIS lack: their purpose, SemRef's own installation, and commands to install them.

SemRef installs into the user profile: one folder for each package and version of Python and numpy, because binaries
depend on them. These folders are last on Python's path, so packages of QGIS or the system are used first.
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
from dataclasses import dataclass
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
    """A module in it that too old versions lack."""
    limits: str = ""
    """Versions that passed the tests (tools/test_newest.sh) and that pip may install."""
    limits_before_numpy_2: str = ""
    """Versions for numpy 1, where they differ."""
    other_names: tuple[str, ...] = ()
    """Other names of packages with this module."""
    comes_with: tuple[str, ...] = ()
    """Other packages that it needs and QGIS may lack, by pip's names; they are in its folder."""

    @property
    def folder(self) -> Path:
        """Folder of SemRef's installation for the running Python and numpy."""
        return components_folder() / self.pip_name

    @property
    def needed_module(self) -> str:
        """A module that exists if the package is installed and new enough."""
        return f"{self.module}.{self.newest_part}" if self.newest_part else self.module

    def requirement(self, numpy_version: str) -> str:
        """Return pip's requirement of a range of versions, such as ``opencv-python-headless>=4.5,<4.12``."""
        return self.pip_name + ((_numpy_1(numpy_version) and self.limits_before_numpy_2) or self.limits)

    def asked(self, numpy_version: str) -> list[str]:
        """Return pip's requirements of a range of versions: the package and what comes with it."""
        pinned = (line.partition(" --hash")[0] for line in self.pinned(numpy_version))
        others = [re.sub(r"==\S+", "", line) for line in pinned if not line.startswith(f"{self.pip_name}==")]
        return [self.requirement(numpy_version), *dict.fromkeys(others)]

    def pinned(self, numpy_version: str) -> list[str]:
        """Return the versions to install from the index, with the hashes of their wheels: lines for pip."""
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
    # 4.12 needs numpy 2.
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
# Its wheels require flatbuffers, protobuf, sympy, …, but a network is read and run without them.
ONNXRUNTIME = Package(
    title="ONNX Runtime",
    module="onnxruntime",
    pip_name="onnxruntime",
    # From 1.19 its wheels work with numpy 1 and 2.
    limits=">=1.19,<1.32",
    other_names=("onnxruntime-gpu", "onnxruntime-directml", "onnxruntime-openvino"),
)
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
"""Not suggested, because only SCHEDULER needs them."""


def purpose(package: Package) -> str:
    return {
        OPENCV: tr("Everything: label maps, databases, localization"),
        PILLOW: tr("Everything: images and their metadata (EXIF)"),
        SHAPELY: tr("Checking and repairing land-cover layers"),
        ONNXRUNTIME: tr("Segmenting photos with a network"),
        DASK: tr("Running algorithms on several processes or computers"),
        CRYPTOGRAPHY: tr("Dask on this computer: protects its processes from other users"),
    }[package]


def is_missing(package: Package) -> bool:
    spec = importlib.util.find_spec(package.module)
    return spec is None or is_too_old(package)


def is_too_old(package: Package) -> bool:
    """Return whether the installed version is too old for SemRef."""
    spec = importlib.util.find_spec(package.module)
    if spec is None or not package.newest_part:
        return False
    # Without importing the package, unlike importlib.util.find_spec.
    return PathFinder.find_spec(package.needed_module, spec.submodule_search_locations) is None


def installed_version(package: Package) -> str:
    """Return a version such as ``4.11.0.86``; empty if it is missing or unknown, as in some systems' packages."""
    names = (package.pip_name, *package.other_names)
    found = (entry.version for name in names for entry in importlib.metadata.distributions(name=name))
    version = next(found, "") or str(getattr(sys.modules.get(package.module), "__version__", ""))
    # Some builds, as Debian's Shapely, do not contain their version.
    return "" if "unknown" in version else version


def origin(package: Package) -> str:
    """Return the file that Python imports; empty without one, for example after its removal."""
    found = importlib.util.find_spec(package.module)
    return "" if found is None else found.origin or ""


def is_own(package: Package) -> bool:
    """Return whether Python imports a package that SemRef installed."""
    return origin(package).startswith(str(components_root()))


def missing(packages: Iterable[Package] = PACKAGES) -> list[Package]:
    return [package for package in packages if is_missing(package)]


# --- SemRef's own folder ---


def components_root() -> Path:
    """Return the folder of all packages that SemRef installed, for all versions of Python and numpy of this profile."""
    return Path(QgsApplication.qgisSettingsDirPath()) / "python" / "semref_components"


def components_key(python_version: tuple, numpy_version: str) -> str:
    """Return a name such as ``cp311-numpy1.24``."""
    return f"cp{python_version[0]}{python_version[1]}-numpy{'.'.join(numpy_version.split('.')[:2])}"


def components_folder() -> Path:
    """Return the folder of the packages that SemRef installed for the running Python and numpy."""
    return components_root() / components_key(sys.version_info, numpy_version())


def add_components_to_path() -> None:
    """Append SemRef's installed packages to Python's path."""
    # The folder of a running installation starts with a dot.
    folders = [str(folder) for folder in sorted(components_folder().glob("[!.]*")) if folder.is_dir()]
    sys.path.extend(folder for folder in folders if folder not in sys.path)
    importlib.invalidate_caches()


def remove_components() -> None:
    """Remove everything that SemRef installed, also for other versions of Python and numpy. Raises ComponentError."""
    root = components_root()
    remove_folder(root)
    sys.path[:] = [entry for entry in sys.path if not entry.startswith(str(root))]
    importlib.invalidate_caches()


def remove_folder(folder: Path, first: str = "") -> None:
    """Remove a folder, if it exists; ``first``: its file to remove first. Raises ComponentError."""
    if not folder.exists():
        return
    try:
        if first:
            (folder / first).unlink(missing_ok=True)
        shutil.rmtree(folder)
    except OSError as error:
        raise ComponentError(
            "{name} cannot be removed, probably because it is in use. Restart QGIS and remove it again.",
            name=error.filename or folder,
        ) from error


# --- what to type ---


def require(packages: Iterable[Package]) -> None:
    """Raises ComponentError with instructions if packages are missing."""
    lacking = missing(packages)
    if not lacking:
        return
    if qgis.utils.iface is not None:
        # Short and without the < of a command, because QGIS shows it as HTML. The options show the command, too.
        raise ComponentError(
            "SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef.",
            packages=", ".join(package.title for package in lacking),
        )
    raise ComponentError(
        "SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef, or run {commands}.",
        packages=", ".join(package.pip_name for package in lacking),
        commands=f"“{install_command(lacking)}”",
    )


def install_command(packages: list[Package]) -> str:
    """Return the pip command that installs packages without SemRef."""
    # Without dependencies, because pip must not replace QGIS's numpy.
    asked = (name for package in packages for name in package.asked(numpy_version()))
    requirements = ("'" + text + "'" if '"' in text else f'"{text}"' for text in asked)
    python = os.path.join(sys.prefix, "bin", "python3")
    # pip refuses to install beside the distribution's packages without this option; --user leaves those unchanged.
    managed = os.path.isfile(os.path.join(sysconfig.get_path("stdlib"), "EXTERNALLY-MANAGED"))
    options = ["--user", "--break-system-packages"] if managed and sys.prefix == sys.base_prefix else []
    program = python if os.path.isfile(python) else "python3"
    return " ".join([program, "-m pip install --no-deps", *options, *requirements])


def how_to_get_pip() -> str:
    """Return how to install pip for QGIS's Python, as the end of a sentence."""
    if os.name == "nt":
        return tr("add the package python3-pip in the OSGeo4W setup")
    # Debian and Ubuntu lack ensurepip.
    command = "sudo apt install python3-pip" if shutil.which("apt") else "python3 -m ensurepip --user"
    return tr("install it with “{command}”").format(command=command)
