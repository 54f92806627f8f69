"""Two QGIS read a database while a third updates it in place: what they find is of one state, or they say so."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

from . import children
from .content import differing, state
from .trials import Plan, Row
from .writers import runner

NAME = "updatedatabase in place, read by two"
_READERS = ("localizeimages", "describeimage", "exportonboard")
"""The last one writes all of a database into a file of its own."""


def row(provider: Any, folder: Path, plan: Plan) -> Row:
    """Reads and updates side by side, as often as there are kills a writer."""
    return read_while_updated(provider, folder, max(3, plan.kills // 2))


def read_while_updated(provider: Any, folder: Path, times: int) -> Row:
    """Each reader reads ``times`` times while the database is updated in place without a pause."""
    run, at, shared = runner(provider), folder / "inputs", folder / "shared"
    shutil.rmtree(shared, ignore_errors=True)
    shared.mkdir()
    area = shared / "area.gpkg"
    shutil.copy(at / "old" / "area.gpkg", area)
    update = {"DATABASE": str(area), "OUTPUT": str(area)}
    labels = [str(at / "new" / "corrected.tif"), str(at / "old" / "labels.tif")]
    known: dict[str, list] = {name: [] for name in _READERS}
    for label in labels:
        run("updatedatabase", {**update, "LABELS": label})
        for name in _READERS:
            known[name].append(_read(run, name, at, area, shared / "known"))
    found = Row(NAME)

    def updates() -> int:
        done = 0
        while not (shared / "enough").exists():
            run("updatedatabase", {**update, "LABELS": labels[done % 2]})
            done += 1
        return done

    updating = children.start(updates, shared)
    reading = [_start_reader(run, name, at, area, shared, times) for name in _READERS]
    endings = [children.wait(*child, shared) for child in reading]
    (shared / "enough").touch()
    ended = children.wait(*updating, shared)
    found.expect(ended.how == "done", f"updates: {ended.how}: {ended.text[-600:]}")
    found.counts["updates meanwhile"] = ended.told or 0
    for name, ending in zip(_READERS, endings):
        found.expect(ending.how == "done", f"{name}: {ending.how}: {ending.text[-600:]}")
        for what in ending.told or ():
            found.counts["refused reads" if isinstance(what, str) else "whole reads"] = (
                found.counts.get("refused reads" if isinstance(what, str) else "whole reads", 0) + 1
            )
            is_known = isinstance(what, str) or what in known[name]
            apart = [] if is_known else min((differing(what, state) for state in known[name]), key=len)
            found.expect(is_known, f"{name}: a result of neither state; other than the nearest: {apart}")
    return found


def _start_reader(run: Any, name: str, at: Path, area: Path, shared: Path, times: int) -> tuple[int, int]:
    def reads() -> list:
        from qgis.core import QgsProcessingException

        results: list = []
        for _ in range(times):
            try:
                results.append(_read(run, name, at, area, shared / name))
            except QgsProcessingException as error:
                results.append(str(error))
        return results

    return children.start(reads, shared)


def _read(run: Any, name: str, at: Path, area: Path, out: Path) -> dict[str, str]:
    """State of what a reader writes."""
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir()
    parameters = {
        "localizeimages": {"IMAGES": [str(at / "new" / "images")], "METHOD": 2, "OUTPUT": str(out / "positions.gpkg")},
        "describeimage": {"INPUT": str(at / "new" / "images" / "0.png"), "REFERENCES": str(out / "landmarks.gpkg")},
        "exportonboard": {"OUTPUT": str(out / "area.npz"), "OVERVIEW": True},
    }[name]
    run(name, {"DATABASE": str(area), **parameters})
    return state(out)
