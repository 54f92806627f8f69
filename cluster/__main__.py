"""Start the process that runs SemRef's tasks with Dask: ``PYTHON …/semref/cluster ORDER``, see ``service.py``.

The plugin's folder may have any name, and its rooms must not hide packages of the same names. This file therefore
loads the folder as the package ``semref`` and removes it from Python's path.
"""

import importlib
import importlib.util
import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def load_package() -> None:
    """Make the plugin's folder importable as ``semref``."""
    spec = importlib.util.spec_from_file_location(
        "semref", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules["semref"] = package
    spec.loader.exec_module(package)


if __name__ == "__main__":
    sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() not in (ROOT, ROOT / "cluster")]
    load_package()
    service = importlib.import_module("semref.cluster.service")
    code = service.main(sys.argv[1])
    if code == service.INTERRUPTED:
        # Dask takes seconds to close.
        os._exit(code)
    sys.exit(code)
