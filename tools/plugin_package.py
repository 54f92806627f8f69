"""This checkout, whatever its folder is called, as the package ``semref``, and its benchmarks; for tools only."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def load_plugin_package() -> None:
    """Makes this checkout importable as ``semref``, and its benchmarks as ``benchmarks``.

    The root itself must not be on the path: our processing/ would come before QGIS's.
    """
    for name, folder in (("semref", ROOT), ("benchmarks", ROOT / "benchmarks")):
        if name not in sys.modules:
            places = [str(folder)]
            spec = importlib.util.spec_from_file_location(
                name, folder / "__init__.py", submodule_search_locations=places
            )
            sys.modules[name] = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(sys.modules[name])
