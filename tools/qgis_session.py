"""Start QGIS without a window, with Processing and this checkout as the package ``semref``; for tools only."""

import contextlib
import gc
import os
import sys
import tempfile
from collections.abc import Iterator

from plugin_package import ROOT, load_plugin_package

__all__ = ["ROOT", "load_plugin_package", "qgis_session"]


@contextlib.contextmanager
def qgis_session() -> Iterator[object]:
    """Start a QgsApplication with a new profile, and yield SemRef's registered provider."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    with tempfile.TemporaryDirectory(prefix="semref-profile-") as home:
        for variable in ("QGIS_CUSTOM_CONFIG_PATH", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"):
            os.environ[variable] = os.path.join(home, variable.lower())
        os.environ.setdefault("XDG_RUNTIME_DIR", home)
        from qgis.core import QgsApplication, QgsProject

        # Map images need the fonts and widgets of the GUI application.
        application = QgsApplication([], True)
        application.initQgis()
        sys.path.append(os.path.join(QgsApplication.pkgDataPath(), "python", "plugins"))
        from processing.core.Processing import Processing

        Processing.initialize()
        load_plugin_package()
        from semref.processing.provider import register_provider

        provider = register_provider(QgsApplication.processingRegistry())
        # Not in a finally: after an error the traceback still holds QGIS objects, and quitting would crash.
        yield provider
        QgsProject.instance().clear()
        QgsApplication.processingRegistry().removeProvider("semref")
        del provider
        gc.collect()
        application.exitQgis()
