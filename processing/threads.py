"""How many threads the user lets QGIS use."""

import os

from qgis.core import QgsApplication


def worker_threads() -> int:
    """QGIS's own setting (Options ▸ Rendering); all cores when it is left to QGIS."""
    chosen = QgsApplication.maxThreads()
    return chosen if chosen > 0 else (os.cpu_count() or 1)
