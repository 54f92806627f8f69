"""What files hold, so that two states of a folder can be compared: what a date alone changes counts for nothing."""

from __future__ import annotations

import contextlib
import hashlib
import re
import sqlite3
import zipfile
from pathlib import Path

_VOLATILE = ("last_change", "update_time", "timestamp")
"""Columns of a GeoPackage that hold when it was written."""

_MOMENT = re.compile(rb"\d{4}-\d\d-\d\d[T ]\d\d:\d\d(:\d\d(\.\d+)?)?(Z|\+00:00)?|\b\d+(\.\d+)? ?(s|ms)\b")
"""Dates and durations in reports."""

_MADE_UP = re.compile(
    r"\w{3} \w{3} +\d+ \d\d:\d\d:\d\d \d{4}|\{[0-9a-f]{8}-[0-9a-f-]{27}\}"
    r"|(?:<history>.*?</history>(?:\s|\\n)*)+|<elevation.*?</elevation>",
    re.DOTALL,
)
"""When QGIS put a style into a GeoPackage, its keys of rules and colors of profiles, and the calls, with their
times, that made a layer."""

_TEXTS = (".html", ".json", ".qml", ".qmd", ".csv", ".txt")

State = dict[str, str]
"""Digest of each file by its path."""


def state(folder: Path) -> State:
    """What lies in a folder and can be seen: without what is hidden."""
    return {str(path.relative_to(folder)): digest(path) for path in sorted(folder.rglob("*")) if _is_seen(path, folder)}


def strays(folder: Path) -> list[str]:
    """What lies in a folder and is none of the user's."""
    hidden = [str(path.relative_to(folder)) for path in folder.rglob(".*")]
    return hidden + [str(path.relative_to(folder)) for path in folder.rglob("*-journal")]


def digest(path: Path) -> str:
    """Of what a file holds; raises sqlite3.Error for a GeoPackage that is not whole."""
    if path.suffix == ".gpkg":
        return _database_digest(path)
    data = path.read_bytes()
    if path.suffix == ".npz" and zipfile.is_zipfile(path):
        data = _without_export_date(path)
    if path.suffix == ".qmd":
        data = _MADE_UP.sub("", data.decode("utf-8")).encode()
    return hashlib.sha256(_MOMENT.sub(b"", data) if path.suffix in _TEXTS else data).hexdigest()


def _without_export_date(path: Path) -> bytes:
    """What an onboard file holds but its export date and what is computed with it."""
    with zipfile.ZipFile(path) as file:
        members = sorted(set(file.namelist()) - {"content_hash.npy", "signature.npy"})
        return b"".join(
            _MOMENT.sub(b"", file.read(name)) if name == "header.npy" else file.read(name) for name in members
        )


def _is_seen(path: Path, folder: Path) -> bool:
    return path.is_file() and not any(part.startswith(".") for part in path.relative_to(folder).parts)


def differing(one: State, other: State) -> list[str]:
    """Files that are not the same in both, and of a GeoPackage the tables that aren't."""
    found = []
    for path in sorted(one.keys() | other.keys()):
        parts = [set(state.get(path, "").split()) for state in (one, other)]
        tables = {part.partition("=")[0] for part in parts[0] ^ parts[1] if "=" in part}
        found += [f"{path} ({', '.join(sorted(tables))})" if tables else path] if parts[0] != parts[1] else []
    return found


def _database_digest(path: Path) -> str:
    """``table=digest`` of each table, apart by spaces."""
    found = []
    with contextlib.closing(sqlite3.connect(f"{path.as_uri()}?mode=ro", uri=True)) as connection:
        if connection.execute("PRAGMA integrity_check").fetchone() != ("ok",):
            raise sqlite3.DatabaseError(f"{path} is damaged")
        tables = connection.execute("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name").fetchall()
        for (table,) in tables:
            if table.startswith("rtree_"):
                continue
            cursor, rows = connection.execute(f'SELECT * FROM "{table}"'), hashlib.sha256()
            kept = [n for n, column in enumerate(cursor.description) if column[0] not in _VOLATILE]
            for row in cursor:
                rows.update(_MADE_UP.sub("", repr([row[n] for n in kept])).encode())
            found.append(f"{table}={rows.hexdigest()}")
    return " ".join(found)
