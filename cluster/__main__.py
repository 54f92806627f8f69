"""``python -m cluster`` from the plugin's folder, or ``PYTHON …/semref/cluster``: see command_line.py.

The plugin's folder may be called anything, and its rooms must not come before packages of the same names: so this file
makes it the package ``semref`` and takes its own folder off Python's path.
"""

import importlib
import importlib.util
import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def load_package() -> None:
    """Makes the plugin's folder importable as ``semref``."""
    spec = importlib.util.spec_from_file_location(
        "semref", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules["semref"] = package
    spec.loader.exec_module(package)


if __name__ == "__main__":
    sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() not in (ROOT, ROOT / "cluster")]
    load_package()
    lines = importlib.import_module("semref.cluster.command_line")
    code = lines.main(sys.argv[1:])
    if code == lines.INTERRUPTED:
        # Files are cleared away and it was said; Dask's own farewells take seconds.
        os._exit(code)
    sys.exit(code)
