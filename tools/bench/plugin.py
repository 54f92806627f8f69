"""The plugin in a bare QGIS: loads the repository root as package `semref` and runs its algorithms.

As tests/conftest.py does it, without pytest; benchmarks reach the plugin through this module only.
"""

from __future__ import annotations

import contextlib
import gc
import importlib.util
import os
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def load_package() -> None:
    """Makes `import semref` give the repository root, whatever its folder is called."""
    if "semref" in sys.modules:
        return
    # Our processing/ would come before QGIS's.
    sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != ROOT]
    spec = importlib.util.spec_from_file_location(
        "semref", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules["semref"] = package
    spec.loader.exec_module(package)


@contextlib.contextmanager
def qgis() -> Iterator[None]:
    """QGIS without a display and in a fresh profile, with Processing and our provider; quits in QGIS's own order."""
    load_package()
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    with tempfile.TemporaryDirectory(prefix="semref-bench-qgis-") as home:
        for variable in ("QGIS_CUSTOM_CONFIG_PATH", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"):
            os.environ[variable] = os.path.join(home, variable.lower())
        from qgis.core import QgsApplication, QgsProject

        application = QgsApplication([], False)
        application.initQgis()
        sys.path.append(os.path.join(QgsApplication.pkgDataPath(), "python", "plugins"))
        from processing.core.Processing import Processing

        from semref.processing.provider import SemRefProvider

        Processing.initialize()
        # The registry owns the C++ half only; this name keeps the Python half alive.
        provider = SemRefProvider()
        QgsApplication.processingRegistry().addProvider(provider)
        # After an error its traceback still holds objects of QGIS, and quitting would crash.
        yield
        QgsProject.instance().clear()
        QgsApplication.processingRegistry().removeProvider("semref")
        del provider
        gc.collect()
        application.exitQgis()


@contextlib.contextmanager
def one_thread() -> Iterator[None]:
    """QGIS, and so the plugin, may use one thread."""
    from qgis.core import QgsApplication

    before = QgsApplication.maxThreads()
    QgsApplication.setMaxThreads(1)
    try:
        yield
    finally:
        QgsApplication.setMaxThreads(before)


@dataclass(frozen=True)
class AlgorithmRun:
    """Results of one run of an algorithm and everything it said, line by line."""

    results: dict
    log: tuple[str, ...]


def run_algorithm(name: str, parameters: dict) -> AlgorithmRun:
    """Runs `semref:name` as the toolbox does; raises QgsProcessingException as it does."""
    import processing
    from qgis.core import QgsProcessingFeedback

    feedback = QgsProcessingFeedback(False)
    results = processing.run(f"semref:{name}", parameters, feedback=feedback)
    return AlgorithmRun(results, tuple(line for line in feedback.textLog().splitlines() if line.strip()))
