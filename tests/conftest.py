"""Load the repository root as the package `semref`, for any folder name, tools/sample as `sample`, benchmarks."""

import gc
import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
REAL_DATA = Path(os.environ.get("SEMREF_DATA") or ROOT.parent / "shared" / "data")

# `python -m pytest` puts the root on the path, and our processing/ would hide QGIS's.
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != ROOT]
# Inputs shared by several suites.
sys.path.append(str(ROOT / "tests" / "data"))


def load_package(name: str, folder: Path) -> None:
    spec = importlib.util.spec_from_file_location(
        name, folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules[name] = package
    spec.loader.exec_module(package)


load_package("semref", ROOT)
load_package("sample", ROOT / "tools" / "sample")
load_package("benchmarks", ROOT / "benchmarks")


@pytest.fixture(scope="session", autouse=True)
def own_cache_folder(tmp_path_factory):
    """Use an empty cache, without files of another run or another version of the code."""
    os.environ["SEMREF_CACHE"] = str(tmp_path_factory.mktemp("cache"))


@pytest.fixture(scope="session")
def repository() -> Path:
    return ROOT


@pytest.fixture(scope="session")
def sample() -> Path:
    """Return the shipped sample area, read-only; made if it is missing or older than its generator."""
    subprocess.run([sys.executable, "-m", "tools.sample"], cwd=ROOT, check=True)
    return ROOT / "sample"


@pytest.fixture(scope="session")
def real_data():
    """`real_data("osm_belgrade/landuse.shp")` returns that file of the real data, or skips with a reason."""

    def path(name: str) -> Path:
        file = REAL_DATA / name
        if not file.exists():
            pytest.skip(f"real data not here: {file}")
        return file

    return path


@pytest.fixture(scope="session")
def training_python() -> Path:
    """Return the Python of .venv-train or of SEMREF_TRAINING_PYTHON; skip if it is missing."""
    python = Path(os.environ.get("SEMREF_TRAINING_PYTHON") or ROOT / ".venv-train" / "bin" / "python")
    if not python.exists():
        pytest.skip("no Python with torch: run bash tools/training/setup_training.sh")
    return python


@pytest.fixture(scope="session")
def start_qgis(tmp_path_factory):
    """`start_qgis(window=False)` starts QGIS with Processing and our provider in a new profile, once per session."""
    # Imported here, because tests/core runs without QGIS.
    started = []

    def start(window: bool):
        if started:
            pytest.exit("tests/qgis and tests/gui each need a process of their own: use tools/test.sh.", 1)
        home = tmp_path_factory.mktemp("qgis")
        for variable in ("QGIS_CUSTOM_CONFIG_PATH", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"):
            os.environ[variable] = str(home / variable.lower())
        from qgis.core import QgsApplication
        from qgis.PyQt.QtCore import QCoreApplication

        application = QgsApplication([], window)
        QCoreApplication.setOrganizationName("SemRef tests")
        application.initQgis()
        sys.path.append(os.path.join(QgsApplication.pkgDataPath(), "python", "plugins"))
        from processing.core.Processing import Processing

        Processing.initialize()
        register_provider()
        started.append(application)
        return application

    yield start
    for application in started:
        stop_qgis(application)


def stop_qgis(application) -> None:
    """Quit in QGIS's own order; QGIS crashes if Python keeps objects that exitQgis deletes."""
    from qgis.core import QgsApplication, QgsProject

    QgsProject.instance().clear()
    QgsApplication.processingRegistry().removeProvider("semref")
    providers.clear()
    gc.collect()
    application.exitQgis()


providers = []


def register_provider() -> None:
    from qgis.core import QgsApplication

    from semref.processing.provider import register_provider as register

    # The registry owns only the C++ part: keep a reference, so that Python does not delete the algorithms.
    providers[:] = [register(QgsApplication.processingRegistry())]
    if QgsApplication.processingRegistry().providerById("semref") is None:
        pytest.fail("QGIS does not take the provider semref.")


@pytest.fixture
def without_provider(qgis_app):
    """Remove our provider, for tests that load the plugin; register it again afterwards."""
    from qgis.core import QgsApplication

    registry = QgsApplication.processingRegistry()
    registry.removeProvider("semref")
    providers.clear()
    yield registry
    # QGIS crashes if an id is registered twice.
    if registry.providerById("semref") is None:
        register_provider()


@pytest.fixture(scope="session")
def run_algorithm(qgis_app):
    """`run_algorithm("semref:…", parameters, feedback=None)` returns the results of the algorithm as a dict."""

    def run(algorithm_id: str, parameters: dict, feedback=None) -> dict:
        import processing

        given = {name: as_parameter(value) for name, value in parameters.items()}
        return processing.run(algorithm_id, given, feedback=feedback)

    return run


def as_parameter(value):
    """Return the text of a path, which QGIS 3.22 does not take as it is; also of each path in a list."""
    if isinstance(value, list):
        return [as_parameter(one) for one in value]
    return str(value) if isinstance(value, Path) else value


@pytest.fixture
def runner(run_algorithm, feedback):
    """`runner("semref:…", "INPUT", **defaults)` returns `run(input, **parameters)`: the results of the algorithm."""

    def made(algorithm_id: str, *names: str, **defaults):
        def run(*values, **parameters) -> dict:
            return run_algorithm(algorithm_id, {**dict(zip(names, values)), **defaults, **parameters}, feedback)

        return run

    return made


@pytest.fixture
def feedback():
    """Return a feedback; `feedback.textLog()` has all its messages."""
    from qgis.core import QgsProcessingFeedback

    return QgsProcessingFeedback(False)


def pytest_report_header() -> list[str]:
    lines = [f"real data: {REAL_DATA if REAL_DATA.is_dir() else 'not here, its tests skip'}"]
    if not os.environ.get("SEMREF_BLOCK_QGIS"):
        try:
            from osgeo import gdal
            from qgis.core import Qgis
        except ImportError:
            lines.append("QGIS: not here")
        else:
            lines.append(f"QGIS {Qgis.QGIS_VERSION}, GDAL {gdal.__version__}")
    return lines
