"""Run tests/core without QGIS; SEMREF_BLOCK_QGIS=1 refuses imports of QGIS (tools/pytest_suites.sh)."""

import importlib.abc
import os
import sys

BLOCKED = {"qgis", "osgeo", "processing", "PyQt5", "PyQt6", "PySide2", "PySide6"}


class QgisBlocker(importlib.abc.MetaPathFinder):
    def find_spec(self, fullname, path=None, target=None):
        if fullname.partition(".")[0] in BLOCKED:
            raise ImportError(f"{fullname} was imported, but tests/core runs without QGIS, GDAL and Qt.")
        return None


if os.environ.get("SEMREF_BLOCK_QGIS"):
    sys.meta_path.insert(0, QgisBlocker())
