"""Start a program of SemRef in a process beside QGIS: ``PYTHON …/semref/program.py training.command JOB.json``.

The plugin's folder may have any name, and its rooms must not hide packages of the same names. This file therefore
loads the folder as the package ``semref`` and removes it from Python's path.
"""

import importlib
import importlib.util
import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent


def load_package() -> None:
    """Make the plugin's folder importable as ``semref``."""
    spec = importlib.util.spec_from_file_location(
        "semref", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules["semref"] = package
    spec.loader.exec_module(package)


if __name__ == "__main__":
    if hasattr(os, "setpgrp"):
        # QGIS ends this process together with all processes that it starts.
        os.setpgrp()
    sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != ROOT]
    load_package()
    sys.exit(importlib.import_module(f"semref.{sys.argv[1]}").main(sys.argv[2:]))
