"""Import this checkout as the package ``semref``, with any folder name, and its benchmarks; for tools only."""

import importlib.util
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def load_plugin_package() -> None:
    """Make this checkout importable as ``semref``, and its benchmarks as ``benchmarks``.

    The root must not be on the path, because our processing/ would then hide QGIS's.
    """
    for name, folder in (("semref", ROOT), ("benchmarks", ROOT / "benchmarks")):
        if name not in sys.modules:
            places = [str(folder)]
            spec = importlib.util.spec_from_file_location(
                name, folder / "__init__.py", submodule_search_locations=places
            )
            sys.modules[name] = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(sys.modules[name])
