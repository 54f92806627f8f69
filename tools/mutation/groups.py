"""Which modules are mutated, and which tests have to notice."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Group:
    """Modules that one row of the table tells of.

    Attributes:
        name: What they do.
        modules: Their paths, each with the test files that mirror it, the quickest first.
        selection: What pytest selects by.
        libraries: What the tests load besides, in the process that runs are forked from.
    """

    name: str
    modules: tuple[tuple[str, tuple[str, ...]], ...]
    selection: tuple[str, ...] = ("-m", "not slow")
    libraries: tuple[str, ...] = ()


def _mirrored(*names: str) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Modules of core with the one test file that mirrors each."""
    return tuple((f"core/{name}.py", (_mirror(name),)) for name in names)


def _mirror(name: str) -> str:
    room, module = name.split("/")
    return f"tests/core/{room}/test_{module}.py"


GROUPS = (
    Group("landmarks", _mirrored("landmarks/landmarks", "landmarks/regions", "landmarks/joining")),
    Group("topology vectors", _mirrored("windows/topology_vector")),
    Group("matching of vectors", _mirrored("windows/matching")),
    Group("verification of poses", _mirrored("constellation/verification")),
    Group("class tables", _mirrored("labels/class_table")),
    Group("onboard files", _mirrored("onboard/format", "onboard/read", "onboard/write")),
    Group(
        "databases",
        (("storage/database/reader.py", ("tests/qgis/test_kept_files.py", "tests/qgis/test_hostile_databases.py")),),
        libraries=("osgeo.gdal", "osgeo.ogr", "osgeo.osr"),
    ),
    Group(
        "decisions",
        (
            *_mirrored("correlation/decision", "localizer/combined"),
            ("core/constellation/solver.py", (_mirror("constellation/solver"),)),
        ),
    ),
)
