"""Read and write results: one JSON file per study. docs/benchmarks.md is written from them.

A file has a title, its runs (command, date, commit, machine), notes, and tables of cells as text. ``scenario`` is the
scenario that repeats the study. ``code`` gives the last commit with the code of a study if the code was removed.
"""

from __future__ import annotations

import datetime
import json
import os
import platform
import re
import subprocess
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
FOLDER = Path(__file__).with_name("results")

Table = dict[str, list]


def load(name: str) -> dict[str, Any]:
    """Return a study; empty if there is no file."""
    path = FOLDER / f"{name}.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


def names() -> list[str]:
    return sorted(path.stem for path in FOLDER.glob("*.json"))


def save(scenario: str, title: str, command: str, notes: Sequence[str], tables: Sequence[Table]) -> Path:
    """Write a new study, with one line per row for readable diffs."""
    study = {"title": title, "scenario": scenario, "runs": [run_now(command)], "notes": notes, "tables": tables}
    path = FOLDER / f"{scenario.replace('.', '_')}.json"
    path.write_text(as_text(study), encoding="utf-8")
    return path


def as_text(study: dict[str, Any]) -> str:
    """Return a study as JSON with a line for each row."""

    def flat(value: object) -> str:
        return json.dumps(value, ensure_ascii=False)

    def lines(values: Iterable[object]) -> str:
        return ",\n".join(flat(value) for value in values)

    parts = [f'"{key}": {flat(study[key])},' for key in ("title", "scenario", "code") if key in study]
    parts += [f'"{key}": [{lines(study[key])}],' for key in ("runs", "notes")]
    tables = [f'{{"columns": {flat(one["columns"])},\n"rows": [\n{lines(one["rows"])}]}}' for one in study["tables"]]
    return "\n".join(["{", *parts, f'"tables": [{",".join(tables)}]}}']) + "\n"


def rows_of(table: Table, wanted: Sequence[str] = ()) -> list[list[str]]:
    """Return the rows with first two cells that match the start of an expression, in the order of the expressions."""
    if not wanted:
        return table["rows"]
    chosen = []
    for expression in wanted:
        chosen += [row for row in table["rows"] if re.match(expression, " | ".join(row[:2]))]
    return chosen


def cell(name: str, row: str, column: str, table: int = 0) -> str:
    """Return a cell; “–” if the study does not have it."""
    tables = load(name).get("tables", [])
    if table < len(tables) and column in tables[table]["columns"]:
        found = rows_of(tables[table], [row])
        if found:
            return found[0][tables[table]["columns"].index(column)].replace("**", "")
    return "–"


# --- display ---


def rate(successes: int, trials: int) -> str:
    """Return count, share and its 95 % interval, as in “299/300, 100 % (98–100)”; “–” without trials."""
    from semref.core.evaluation.rates import wilson

    if not trials:
        return "–"
    digits = sum(trials > most for most in (500, 5000))
    low, high = wilson(successes, trials)
    share, low, high = (f"{100 * part:.{digits}f}" for part in (successes / trials, low, high))
    return f"{successes}/{trials}, {share} % ({low}–{high})"


def size(count: float) -> str:
    """Return bytes as text, such as “33.1 kB” (thousands)."""
    for unit in ("B", "kB", "MB"):
        if count < 1000:
            return f"{count:.0f} {unit}" if unit == "B" else f"{count:.1f} {unit}"
        count /= 1000
    return f"{count:.2f} GB"


def markdown(columns: Sequence[object], rows: Sequence[Sequence[object]]) -> str:
    """Return a Markdown table."""
    lines = [columns, ["---"] * len(columns), *rows]
    return "\n".join(f"|{'|'.join(str(cell) for cell in line)}|" for line in lines)


# --- what a figure was measured with ---


def run_now(command: str) -> dict[str, Any]:
    """Return command, date, commit, machine and versions of the current measurement."""
    return {
        "command": command,
        "date": datetime.date.today().isoformat(),
        "commit": revision(),
        "machine": hardware(),
        "load": round(os.getloadavg()[0], 1),
        "versions": versions(),
    }


def revision() -> str:
    """Return the commit of the plugin's code, and whether shipped code has changed since."""
    commit = _git("rev-parse", "--short", "HEAD")
    changed = _git("status", "--porcelain", "--", "core", "storage", "processing")
    return f"{commit or 'unknown'}{' with changes' if changed else ''}"


def _git(*arguments: str) -> str:
    command = ["git", "-C", str(ROOT), *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()


def hardware() -> str:
    lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    processor = next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")
    memory_gib = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return f"{processor or platform.machine()}, {os.cpu_count()} cores, {memory_gib:.0f} GiB"


def versions() -> str:
    import cv2
    import numpy
    from osgeo import gdal
    from qgis.core import Qgis

    return (
        f"QGIS {Qgis.QGIS_VERSION.split('-')[0]}, GDAL {gdal.VersionInfo('RELEASE_NAME')}, numpy {numpy.__version__}, "
        f"OpenCV {cv2.__version__}, Python {platform.python_version()}"
    )


def footer(command: str) -> str:
    """Return the same as a line of Markdown, for pages with tables of other tools."""
    run = run_now(command)
    return f"*`{command}` on {run['date']}, commit {run['commit']}. {run['machine']}; {run['versions']}.*"


def write_section(path: Path, name: str, body: str) -> None:
    """Replace the text between ``<!-- bench:name -->`` and ``<!-- /bench:name -->`` in a page.

    Raises:
        ValueError: The page does not have both markers.
    """
    begin, end = f"<!-- bench:{name} -->", f"<!-- /bench:{name} -->"
    text = path.read_text(encoding="utf-8")
    before, found, rest = text.partition(begin)
    _, closed, after = rest.partition(end)
    if not found or not closed:
        raise ValueError(f"{path.name} needs the markers {begin} and {end}.")
    path.write_text(f"{before}{begin}\n\n{body.strip()}\n\n{end}{after}", encoding="utf-8")
