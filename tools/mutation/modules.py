"""Which modules are mutated, and which tests have to notice."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Module:
    """One that is mutated.

    Attributes:
        path: Of its source.
        tests: Files that have to notice, the quickest first.
        libraries: What these load besides, in the process that runs are forked from.
    """

    path: str
    tests: tuple[str, ...]
    libraries: tuple[str, ...] = ()


def _mirrored(name: str) -> Module:
    """A module of core with the one test file that mirrors it."""
    room, module = name.split("/")
    return Module(f"core/{name}.py", (f"tests/core/{room}/test_{module}.py",))


MODULES = (
    *map(_mirrored, ("landmarks/landmarks", "landmarks/regions", "landmarks/joining")),
    *map(_mirrored, ("windows/topology_vector", "windows/matching")),
    *map(_mirrored, ("constellation/verification", "constellation/decision")),
    *(
        Module(
            f"core/constellation/{name}.py",
            ("tests/core/constellation/test_search.py", "tests/core/constellation/test_solver.py"),
        )
        for name in ("search", "solver")
    ),
    *map(_mirrored, ("correlation/decision", "localizer/combined")),
    *map(_mirrored, ("labels/class_table", "onboard/format")),
    Module("core/onboard/read.py", ("tests/core/onboard/test_read.py", "tests/core/onboard/test_signature.py")),
    Module("core/onboard/write.py", ("tests/core/onboard/test_write.py", "tests/core/onboard/test_signature.py")),
    Module(
        "storage/database/reader.py",
        ("tests/qgis/test_kept_files.py", "tests/qgis/test_hostile_databases.py"),
        ("osgeo.gdal", "osgeo.ogr", "osgeo.osr"),
    ),
)
