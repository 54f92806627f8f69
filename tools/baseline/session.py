"""QGIS without a window, with the plugin of any checkout loaded as QGIS loads it."""

from __future__ import annotations

import contextlib
import gc
import importlib.util
import os
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

THREADS = 2
"""The same on every machine; users set it in QGIS's options."""


def load_plugin_package(repository: Path) -> None:
    """Makes a checkout, whatever its folder is called, importable as ``semref``."""
    # Its processing/ would come before QGIS's.
    sys.path[:] = [entry for entry in sys.path if not (Path(entry or ".").resolve() / "metadata.txt").exists()]
    places = [str(repository)]
    spec = importlib.util.spec_from_file_location(
        "semref", repository / "__init__.py", submodule_search_locations=places
    )
    sys.modules["semref"] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(sys.modules["semref"])


@contextlib.contextmanager
def qgis_with_plugin(repository: Path) -> Iterator[None]:
    """QGIS in a fresh profile with Processing and the plugin, as `qgis_process` starts them."""
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    # The answers are in English whatever language the machine speaks.
    os.environ["LC_ALL"] = os.environ["LANGUAGE"] = "C.UTF-8"
    load_plugin_package(repository)
    with tempfile.TemporaryDirectory(prefix="semref-profile-") as home:
        os.environ.setdefault("XDG_RUNTIME_DIR", home)
        for variable in ("QGIS_CUSTOM_CONFIG_PATH", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"):
            os.environ[variable] = os.path.join(home, variable.lower())
        from qgis.core import QgsApplication, QgsProject

        application = QgsApplication([], True)
        application.initQgis()
        application.setMaxThreads(THREADS)
        sys.path.append(os.path.join(QgsApplication.pkgDataPath(), "python", "plugins"))
        from processing.core.Processing import Processing

        Processing.initialize()
        plugin = sys.modules["semref"].classFactory(None)
        plugin.initProcessing()
        yield
        QgsProject.instance().clear()
        plugin.unload()
        del plugin
        gc.collect()
        application.exitQgis()
