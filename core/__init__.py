"""Core of SemRef: from labels through landmarks and vectors to positions, without QGIS.

It needs numpy, OpenCV and Pillow; checks of land-cover layers also need shapely, and photos onnxruntime. Pixel
coordinates are (column, row) floats with (0.5, 0.5) at the center of the first pixel.

The names in ``__all__`` are the public Python API. They are in ``api``, which loads when one of them is first used:

    >>> from semref.core import localize, open_database
    >>> database = open_database("area.npz")
    >>> for image in localize(["a.jpg", "b.jpg"], database, model="landcover.onnx"):
    ...     print(image.status, image.position, image.error_95_m, image.risk)
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .api import (
        build_database,
        evaluate,
        localize,
        localize_flight,
        open_database,
        read_class_table,
        save_database,
        segment,
    )

__all__ = [
    "build_database",
    "evaluate",
    "localize",
    "localize_flight",
    "open_database",
    "read_class_table",
    "save_database",
    "segment",
]


def __getattr__(name: str) -> Any:  # noqa: ANN401 - a function
    """Load the API at its first use, so that QGIS starts without numpy and an aircraft without unused packages."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(".api", __name__), name)
