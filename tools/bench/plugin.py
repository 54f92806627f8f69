"""The plugin in QGIS, as benchmarks reach it; QGIS itself is started by tools/qgis_session.py."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import dataclass

from qgis_session import load_plugin_package as load_package
from qgis_session import qgis_session as qgis

__all__ = ("AlgorithmRun", "load_package", "one_thread", "qgis", "run_algorithm")


@contextlib.contextmanager
def one_thread() -> Iterator[None]:
    """QGIS, and so the plugin, may use one thread."""
    from qgis.core import QgsApplication

    before = QgsApplication.maxThreads()
    QgsApplication.setMaxThreads(1)
    try:
        yield
    finally:
        QgsApplication.setMaxThreads(before)


@dataclass(frozen=True)
class AlgorithmRun:
    """Results of one run of an algorithm and everything it said, line by line."""

    results: dict
    log: tuple[str, ...]


def run_algorithm(name: str, parameters: dict) -> AlgorithmRun:
    """Runs `semref:name` as the toolbox does; raises QgsProcessingException as it does."""
    import processing
    from qgis.core import QgsProcessingFeedback

    feedback = QgsProcessingFeedback(False)
    results = processing.run(f"semref:{name}", parameters, feedback=feedback)
    return AlgorithmRun(results, tuple(line for line in feedback.textLog().splitlines() if line.strip()))
