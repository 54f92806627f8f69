"""This checkout, whatever its folder is called, as the package ``semref``; for tools only."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def load_plugin_package() -> None:
    """Makes this checkout importable as ``semref``."""
    if "semref" not in sys.modules:
        spec = importlib.util.spec_from_file_location(
            "semref", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
        )
        sys.modules["semref"] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(sys.modules["semref"])
