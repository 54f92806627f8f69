"""`python -m cluster` in a process of its own, which has GDAL and Dask and no QGIS."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from built_database import NAMES
from made_inputs import scattered_objects, write_raster

ROOT = Path(__file__).resolve().parents[3]
HERE = Path(__file__).resolve().parent


def pytest_collection_modifyitems(items):
    """As of tests/core: on a newer QGIS (tools/test_in_root.sh) what is slow here and has no QGIS in it is left out."""
    if os.environ.get("SEMREF_QUICK_CORE") != "yes":
        return
    for item in items:
        if HERE in Path(item.path).parents and item.get_closest_marker("slow"):
            item.add_marker(pytest.mark.skip(reason="slow and without QGIS: it runs on the machine's own"))


@pytest.fixture(scope="session")
def cluster():
    """`cluster("build", …)` gives the finished process; `cluster.start(…)` one that runs."""
    pytest.importorskip("distributed", reason="Dask is not here (tools/requirements-dev.txt)")

    def start(*arguments, python=sys.executable):
        # What imports qgis would find nothing.
        environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "PYTHONUNBUFFERED": "1"}
        return subprocess.Popen(
            [python, "-m", "cluster", *map(str, arguments)],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=environment,
        )

    def run(*arguments, **options):
        process = start(*arguments, **options)
        try:
            output, errors = process.communicate(timeout=120)
        except subprocess.TimeoutExpired:
            process.kill()
            raise
        return subprocess.CompletedProcess(process.args, process.returncode, output, errors)

    run.start = start
    return run


@pytest.fixture(scope="session")
def label_map(tmp_path_factory):
    """Some tiles of a map, with landmarks on every seam."""
    labels = scattered_objects(1700, 1500, 2500, seed=8)
    labels[500:540, 100:1400] = 2
    labels[200:1600, 1010:1040] = 1
    return write_raster(tmp_path_factory.mktemp("map") / "labels.tif", labels, names=NAMES)
