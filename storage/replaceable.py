"""Check that an output replaces only an older output of the same kind, never another file of the user."""

from __future__ import annotations

import contextlib
import os
import sqlite3
import stat
from collections.abc import Collection
from pathlib import Path

from ..core.errors import ParameterError, reason_of
from .vector_files import WAIT_S, no_place

_SQLITE, _TIFF, _ZIP, _MARKUP, _JSON, _PDF, _SHAPEFILE, _FLATGEOBUF = range(1, 9)
_FOREIGN = -1
_UNKNOWN = 0

_STARTS = {
    b"SQLite format 3\0": _SQLITE,
    b"II*\0": _TIFF,
    b"II+\0": _TIFF,
    b"MM\0*": _TIFF,
    b"MM\0+": _TIFF,
    b"PK\x03\x04": _ZIP,
    b"<": _MARKUP,
    b"{": _JSON,
    b"[": _JSON,
    b"%PDF": _PDF,
    b"\0\0\x27\x0a": _SHAPEFILE,
    b"fgb\x03": _FLATGEOBUF,
    b"\x89PNG": _FOREIGN,
    b"\xff\xd8\xff": _FOREIGN,
    b"#!": _FOREIGN,
    b"\x7fELF": _FOREIGN,
}
"""Kind of a file by its first bytes, without leading white space for text files."""

_KINDS = {
    ".gpkg": _SQLITE,
    ".sqlite": _SQLITE,
    ".db": _SQLITE,
    ".tif": _TIFF,
    ".tiff": _TIFF,
    ".npz": _ZIP,
    ".html": _MARKUP,
    ".kml": _MARKUP,
    ".gml": _MARKUP,
    ".gpx": _MARKUP,
    ".json": _JSON,
    ".geojson": _JSON,
    ".pdf": _PDF,
    ".shp": _SHAPEFILE,
    ".fgb": _FLATGEOBUF,
    ".csv": _UNKNOWN,
    ".txt": _UNKNOWN,
    ".onnx": _UNKNOWN,
}
"""Kind of an output by its suffix; unknown for text and for formats without fixed first bytes."""

_OF_A_LAYER = ("layer_styles",)
_OF_GEOPACKAGE = ("gpkg_", "rtree_", "sqlite_")

_DERIVED = (".aux.xml", ".ovr", ".msk")
"""Suffixes of files that GDAL writes beside a raster, and applies to any raster of this name."""

_OF_SHAPEFILE = (".dbf", ".shx", ".prj", ".cpg")
_DERIVED_OF_SHAPEFILE = (".qix", ".sbn", ".sbx")

_JOURNALS = ("-wal", "-journal", "-shm")

_NOTES = (".qml", ".qmd")
"""Suffixes of QGIS's style and metadata files. A shapefile and a raster with the same stem share them."""

MARK_OF_NOTE = "<!-- Written by SemRef, which replaces this file. -->"
"""XML comment in each style and metadata file that SemRef writes. QGIS removes it when a user saves the file."""

_LONGEST_NOTE = 4 << 20


def require_replaceable(path: str, suffix: str = "", tables: Collection[str] | None = ()) -> None:
    """Raise ParameterError unless a target is free or an older output of the same kind.

    Args:
        suffix: Usual suffix of such outputs, which gives the kind of file; empty for the suffix of ``path``.
        tables: Layers that an older GeoPackage may have; empty for one layer with the name of the file, None if the run
            keeps all layers.

    Raises:
        ParameterError: The target is a folder, not a regular file, another kind of file, or has other layers; or its
            folder is missing; or the target is free and parts of another file have its name.
    """
    final = Path(path)
    try:
        mode = os.stat(final).st_mode
        if stat.S_ISDIR(mode):
            raise ParameterError("{path} is a folder; give a file name.", path=final)
        if not stat.S_ISREG(mode):
            raise ParameterError(
                "{path} exists and is another kind of file, which would be lost; choose another name.", path=final
            )
        with final.open("rb") as file:
            head = file.read(256)
    except (FileNotFoundError, NotADirectoryError):
        if not final.parent.is_dir():
            raise ParameterError(
                "The folder {folder} does not exist; create it or choose another place for {name}.",
                folder=final.parent,
                name=final.name,
            ) from None
        # Free, or a broken link, which is replaced.
        _require_no_orphans(final)
        return
    except OSError as error:
        raise no_place(final, reason_of(error)) from None
    if not head:
        return
    wanted = _KINDS.get((suffix or final.suffix).lower())
    found = next((kind for start, kind in _STARTS.items() if _text(head).startswith(start)), _UNKNOWN)
    if wanted is not None and found != wanted:
        raise ParameterError(
            "{path} exists and is another kind of file, which would be lost; choose another name.", path=final
        )
    if found == _SQLITE and tables is not None:
        _require_tables(final, tables or (final.stem,))


def _text(head: bytes) -> bytes:
    return head if head.startswith(b"\0") else head.lstrip(b"\xef\xbb\xbf \t\r\n") or head


def _require_tables(path: Path, tables: Collection[str]) -> None:
    try:
        with contextlib.closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", uri=True)) as connection:
            rows = connection.execute("SELECT name FROM sqlite_master WHERE type IN ('table', 'view')").fetchall()
    except sqlite3.Error as error:
        if "locked" in str(error):
            raise not_replaceable(path) from None
        raise ParameterError(
            "{path} exists and can't be read ({reason}), so SemRef does not replace it; remove it or choose another "
            "name.",
            path=path,
            reason=str(error),
        ) from None
    names = {name for (name,) in rows if not name.startswith(_OF_GEOPACKAGE)}
    others = sorted(names - {*_OF_A_LAYER, *tables})
    if others:
        raise ParameterError(
            "{path} holds other layers ({layers}), which would be lost; choose another file, or add to it by “Save to "
            "GeoPackage”.",
            path=path,
            layers=", ".join(others[:5]),
        )


def _require_no_orphans(final: Path) -> None:
    """Raise ParameterError for files that programs would treat as parts of the new file."""
    beside = [f"{final.name}{end}" for end in (*_DERIVED, *_JOURNALS)]
    if final.suffix.lower() == ".shp":
        beside += [f"{final.stem}{end}" for end in (*_OF_SHAPEFILE, *_DERIVED_OF_SHAPEFILE)]
    for name in beside:
        if os.path.lexists(final.with_name(name)):
            raise stranger_beside(final, final.with_name(name))


def stranger_beside(final: Path, path: Path) -> ParameterError:
    """Return the error for a file that programs would treat as a part of a new file."""
    return ParameterError(
        "{path} would be taken for a part of the new {name}, but belongs to another file; remove it or choose another "
        "name.",
        path=path,
        name=final.name,
    )


def not_replaceable(path: str | Path) -> ParameterError:
    """Return the error for a file that is open."""
    return ParameterError(
        "{path} can't be replaced; it may be open in this or another program: close or remove it, or choose another "
        "name.",
        path=path,
    )


def derived_files(final: Path) -> list[str]:
    """Return names of files that GDAL writes beside a file and would apply to a newer file of the same name."""
    beside = [f"{final.name}{end}" for end in _DERIVED]
    if final.suffix.lower() == ".shp":
        beside += [f"{final.stem}{end}" for end in _DERIVED_OF_SHAPEFILE]
    return beside


def is_note(path: Path) -> bool:
    """Whether QGIS would read a file as style or metadata of each layer with the same stem."""
    return path.suffix.lower() in _NOTES


def is_foreign_note(path: Path) -> bool:
    """Whether a path is a style or metadata file that SemRef did not write."""
    if not is_note(path) or not os.path.lexists(path):
        return False
    try:
        if not stat.S_ISREG(os.lstat(path).st_mode):
            return True
        with path.open("rb") as file:
            return MARK_OF_NOTE.encode() not in file.read(_LONGEST_NOTE)
    except OSError:
        return True


def require_closed(path: str) -> None:
    """Write the journal of a GeoPackage into it, so that it is not applied to a newer file of the same name.

    Raises:
        ParameterError: Another program writes to the file or has it open for writing.
    """
    if _KINDS.get(Path(path).suffix.lower()) != _SQLITE:
        return
    in_use = not_replaceable(path)
    if os.path.isfile(path) and not os.path.islink(path) and os.path.getsize(path):
        try:
            with contextlib.closing(sqlite3.connect(path, timeout=WAIT_S, isolation_level=None)) as connection:
                # Rolls back the changes of a killed program; fails while another program writes.
                connection.execute("BEGIN IMMEDIATE")
                connection.execute("ROLLBACK")
                # The first mode ends WAL mode, the second removes the journal.
                for mode in ("PERSIST", "DELETE"):
                    connection.execute(f"PRAGMA journal_mode={mode}").fetchone()
        except sqlite3.Error as error:
            # For other errors, a journal beside the file decides.
            if "locked" in str(error):
                raise in_use from None
    if any(os.path.lexists(path + end) for end in _JOURNALS):
        raise in_use
