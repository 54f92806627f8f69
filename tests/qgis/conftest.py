"""Start QGIS without a display."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from made_inputs import write_raster


@pytest.fixture(scope="session")
def qgis_app(start_qgis):
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    return start_qgis(window=False)


@pytest.fixture(scope="session")
def build_area(run_algorithm, tmp_path_factory):
    """`build_area(labels, names, size, stride)` returns the path of a database with three landmark classes.

    Built once a session for the same arguments, to read only; the map is `labels.tif` beside it.
    """
    built: dict[tuple, str] = {}

    def build(labels_hw, names, size: float, stride: float, references: str = "building;water;bare_land") -> str:
        key = (labels_hw.shape, labels_hw.tobytes(), tuple(names), size, stride, references)
        if key not in built:
            folder = tmp_path_factory.mktemp("area")
            parameters = {
                "LABELS": str(write_raster(folder / "labels.tif", labels_hw, names=names)),
                "REFERENCE_CLASSES": references,
                "WINDOW_SIZE": size,
                "STRIDE": stride,
                "MINIMUM_AREA": 30,
                "DATABASE": str(folder / "area.gpkg"),
            }
            built[key] = run_algorithm("semref:builddatabase", parameters)["DATABASE"]
        return built[key]

    return build


@pytest.fixture
def short_wait(monkeypatch):
    """Another program that locks a database is waited for only a moment."""
    from semref.storage import replaceable, vector_files
    from semref.storage.database import connection, undo

    for module in (replaceable, vector_files, connection, undo):
        monkeypatch.setattr(module, "WAIT_S", 0.1)


@pytest.fixture
def small_disk(tmp_path):
    """`small_disk(kilobytes)`: a folder on a disk of that size."""
    mounted = []

    def mount(kilobytes: int) -> Path:
        folder = tmp_path / f"disk{len(mounted)}"
        folder.mkdir()
        command = ["mount", "-t", "tmpfs", "-o", f"size={kilobytes}k", "tmpfs", str(folder)]
        if shutil.which("mount") is None or subprocess.run(command, capture_output=True, check=False).returncode:
            pytest.skip("a disk of its own can't be mounted here")
        mounted.append(folder)
        return folder

    yield mount
    for folder in mounted:
        subprocess.run(["umount", "-l", str(folder)], check=False)
