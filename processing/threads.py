"""Number of threads that the user allows QGIS to use."""

import os

from qgis.core import QgsApplication


def worker_threads() -> int:
    """Return QGIS's setting (Options ▸ Rendering), or all cores if it is not set."""
    chosen = QgsApplication.maxThreads()
    return chosen if chosen > 0 else (os.cpu_count() or 1)
