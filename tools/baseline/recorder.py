"""What sections record with: runs algorithms, keeps their answers without paths, writes them."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from . import dumps
from .store import plain, write_section

SECONDS = re.compile(r"\b\d[\d.,]*[ \u00a0]s\b")
"""How long something took, in a sentence."""


class Recorder:
    """Values and arrays of one section by name; texts have the folders' names replaced.

    Attributes:
        work: where outputs are written.
        repository: the checkout that is recorded.
        data: the real data's folder.
        quick: whether to record a part only.
    """

    def __init__(self, target: Path, work: Path, repository: Path, data: Path, quick: bool) -> None:
        self.work, self.repository, self.data, self.quick = work, repository, data, quick
        self._target = target
        self._values: dict[str, Any] = {}
        self._arrays: dict[str, np.ndarray] = {}
        self._log: dict[str, list[str]] = {}

    def path(self, name: str) -> str:
        """A file of the work folder; its folder is made."""
        path = self.work / name
        path.parent.mkdir(parents=True, exist_ok=True)
        return str(path)

    def put(self, what: str, value: Any) -> None:
        """Keeps a value: a dict's entries or a list's rows are compared one by one."""
        if what in self._values or what in self._arrays:
            raise ValueError(f"{what} is recorded twice")
        self._values[what] = plain(value, self._without_paths)

    def put_array(self, what: str, array: np.ndarray) -> None:
        """Record an array. The comparison checks each element."""
        self._arrays[what] = array

    def put_layer(self, what: str, path: str) -> list[dict[str, Any]]:
        """Keeps a layer's columns and rows; gives the rows."""
        rows = dumps.layer_rows(path)
        self.put(f"{what}/columns", dumps.fields_of(path))
        self.put(what, rows)
        return rows

    def put_raster(self, what: str, path: str) -> None:
        """Keeps a raster's description and pixels."""
        about, pixels = dumps.raster(path)
        self.put(what, about)
        self.put_array(f"{what}/pixels", pixels)

    def put_database(self, what: str, path: str) -> None:
        """Keeps every table of a reference database and the pixels of its overview."""
        for table, rows in dumps.geopackage_tables(path).items():
            self.put(f"{what}/{table}", rows)
        about, pixels = dumps.raster(f"GPKG:{path}:overview")
        self.put(f"{what}/overview raster", about)
        self.put_array(f"{what}/overview raster/pixels", pixels)

    def run(self, what: str, name: str, parameters: dict[str, Any]) -> dict[str, Any]:
        """Runs `semref:name`, keeps its numbers and what it said; gives its results."""
        import processing
        from qgis.core import QgsProcessingFeedback

        feedback = QgsProcessingFeedback(False)
        started = time.perf_counter()
        results = processing.run(f"semref:{name}", parameters, feedback=feedback)
        print(f"  {what}: semref:{name} {time.perf_counter() - started:.1f} s", flush=True)
        self.put(f"{what}/results", {key: value for key, value in results.items() if key != "CHILD_RESULTS"})
        said = (SECONDS.sub("… s", line) for line in feedback.textLog().splitlines())
        self._log[what] = [line for line in said if line.strip()]
        return results

    def command(self, arguments: Sequence[str]) -> dict[str, Any]:
        """Exit status and output of `python -m core …`, run in the checkout."""
        environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": ""}
        started = time.perf_counter()
        done = subprocess.run(
            [sys.executable, "-m", "core", *arguments],
            cwd=self.repository, env=environment, capture_output=True, text=True, check=False,
        )  # fmt: skip
        print(f"  python -m core {arguments[0]} {time.perf_counter() - started:.1f} s", flush=True)
        return {"status": done.returncode, "out": done.stdout.splitlines(), "err": done.stderr.splitlines()}

    def write(self, section: str) -> int:
        """Writes what was kept as a section and forgets it; gives the number of things."""
        if self._log:
            self.put("log", self._log)
        count = len(self._values) + len(self._arrays)
        write_section(self._target, section, self._values, self._arrays)
        self._values, self._arrays, self._log = {}, {}, {}
        return count

    def _without_paths(self, text: str) -> str:
        for folder, name in ((self.work, "WORK"), (self.repository, "REPOSITORY"), (self.data, "DATA")):
            text = text.replace(str(folder), name)
        return text
