"""Runs tests against mutants, each in a process of its own that starts with the libraries loaded."""

from __future__ import annotations

import importlib
import importlib.machinery
import os
import resource
import signal
import sys
from pathlib import Path

from .operators import Mutant

LIBRARIES = ("numpy", "cv2", "shapely", "pytest", "_pytest.assertion.rewrite")
PATIENCE = 4
"""A mutant that takes so many times as long as the module itself runs for ever: that is noticed as well."""

MOST_MEMORY = 6 << 30


def load(libraries: tuple[str, ...]) -> None:
    """Loads once what every run needs."""
    for name in (*LIBRARIES, *libraries):
        importlib.import_module(name)
    sys.modules["cv2"].setNumThreads(1)
    importlib.import_module("_pytest.config").get_config()


def run(tests: list[str], path: Path, mutant: Mutant | None, seconds: float | None, log: Path) -> tuple[int, float]:
    """Runs tests with a mutant in the place of its module.

    Args:
        tests: Files, and what pytest selects by.
        path: Of the module's source.
        mutant: None for the module as it is.
        seconds: Of computing that it may take; None for as many as it likes.
        log: What the tests print.

    Returns:
        Exit status, 0 where all tests pass, and seconds of computing.
    """
    started = os.times()
    child = os.fork()
    if not child:
        _run_here(tests, path, mutant, seconds, log)
    _, status = os.waitpid(child, 0)
    ended = os.times()
    taken = ended.children_user - started.children_user + ended.children_system - started.children_system
    return status, taken


def _run_here(tests: list[str], path: Path, mutant: Mutant | None, seconds: float | None, log: Path) -> None:
    """The child's part: it ends without tidying up."""
    status = 70
    try:
        import pytest

        file = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(file, 1)
        os.dup2(file, 2)
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
        if seconds is not None:
            resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
            # What sleeps computes nothing.
            signal.alarm(int(10 * seconds) + 60)
        if mutant is not None:
            _put(path, mutant.source)
        status = int(pytest.main(["-q", "-x", "-p", "no:cacheprovider", *tests]))
        sys.stdout.flush()
    finally:
        os._exit(status)


def _put(path: Path, source: str) -> None:
    """Whoever imports the module of that path gets this source."""
    original = importlib.machinery.SourceFileLoader.get_code

    def get_code(loader: importlib.machinery.SourceFileLoader, name: str) -> object:
        if Path(loader.path) == path:
            return compile(source, str(path), "exec")
        return original(loader, name)

    importlib.machinery.SourceFileLoader.get_code = get_code


def patience(seconds: float) -> float:
    """Seconds that a mutant may take where the module itself takes so many."""
    return PATIENCE * seconds + 5
