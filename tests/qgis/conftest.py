"""Start QGIS without a display."""

import os
import shutil
import subprocess
import sysconfig
from pathlib import Path

import numpy as np
import pytest
from bad_input import BUILD, LABELS, WINDOWS
from edited_database import kept_database
from listening import listening
from made_inputs import CLASSES_CSV, NAMES, square, write_layer, write_raster, write_text
from made_models import write_model
from qgis.core import QgsApplication

from semref.storage.database.reader import store_checksums


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
            labels = str(write_raster(folder / "labels.tif", labels_hw, names=names))
            sizes = {"WINDOW_SIZE": size, "STRIDE": stride, "MINIMUM_AREA": 30}
            parameters = {"LABELS": labels, "REFERENCE_CLASSES": references, **sizes}
            built[key] = run_algorithm(BUILD, {**parameters, "DATABASE": str(folder / "area.gpkg")})["DATABASE"]
        return built[key]

    return build


@pytest.fixture(scope="session")
def good(run_algorithm, tmp_path_factory):
    """Return a folder with one valid input of each kind."""
    folder = tmp_path_factory.mktemp("good")
    features = [(square(0, 0, 100), "field", 1), (square(10, 10, 20), "building", 2)]
    write_layer(folder / "annotation.gpkg", features, [("class", "text"), ("zorder", "integer")])
    write_text(folder / "classes.csv", CLASSES_CSV)
    write_raster(folder / "labels.tif", LABELS, names=NAMES)
    write_raster(folder / "photo.png", LABELS[:100, :100], transform=None)
    write_raster(folder / "color.png", np.zeros((3, 20, 20), np.uint8), transform=None)
    write_model(folder / "colors.onnx")
    run_algorithm(BUILD, {"LABELS": str(folder / "labels.tif"), **WINDOWS, "DATABASE": str(folder / "area.gpkg")})
    return folder


@pytest.fixture
def given(good, tmp_path):
    """Return a copy of these in a separate folder."""
    shutil.copytree(good, tmp_path / "given")
    return tmp_path / "given"


@pytest.fixture
def provider(qgis_app):
    return QgsApplication.processingRegistry().providerById("semref")


@pytest.fixture
def path(tmp_path) -> str:
    """Return a database of format 1 with checksums."""
    path = kept_database(tmp_path / "maps" / "area.gpkg")
    store_checksums(path)
    return path


@pytest.fixture
def classes_csv(tmp_path):
    return str(write_text(tmp_path / "classes.csv", CLASSES_CSV))


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


@pytest.fixture
def host():
    """Return a web server that records requests; ``name()`` is a new raster on it."""
    with listening() as server:
        yield server


@pytest.fixture
def create(qgis_app):
    # Keep the algorithm: its parameters and outputs are deleted with it.
    return lambda name: QgsApplication.processingRegistry().createAlgorithmById(f"semref:{name}")


@pytest.fixture(scope="session")
def start_qgis_process(tmp_path_factory):
    """`start_qgis_process(install)` has the plugin put into a folder of plugins, and returns a function.

    It takes the arguments of qgis_process, runs it in a new profile and returns its output.
    """
    # Debian 12's wrapper qgis_process passes on an option that its own qgis_process.bin does not support.
    program = shutil.which("qgis_process.bin") or shutil.which("qgis_process")
    if program is None:
        pytest.skip("qgis_process is not installed")

    def start(install):
        home = tmp_path_factory.mktemp("home")
        plugins = home / ".local" / "share" / "QGIS" / "QGIS3" / "profiles" / "default" / "python" / "plugins"
        plugins.mkdir(parents=True)
        install(plugins)
        environment = {
            "PATH": os.environ["PATH"],
            "LANG": "C.UTF-8",
            "HOME": str(home),
            "XDG_RUNTIME_DIR": str(tmp_path_factory.mktemp("runtime")),
            "QT_QPA_PLATFORM": "offscreen",
            "PYTHONDONTWRITEBYTECODE": "1",
            # OpenCV of a virtual environment, if there is one: qgis_process runs the system's Python.
            "PYTHONPATH": sysconfig.get_path("purelib"),
        }

        def call(*arguments: str) -> str:
            command, options = [program, *arguments], {"env": environment, "cwd": home, "timeout": 600}
            done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
            assert done.returncode == 0, f"{command} exits {done.returncode}:\n{done.stdout}\n{done.stderr}"
            assert "Traceback" not in done.stderr, done.stderr
            return done.stdout

        call("plugins", "enable", "processing")
        call("plugins", "enable", "semref")
        return call

    return start
