"""THE database schema: a reference database as one GeoPackage, written and read.

Told in docs/file-formats.md#reference-database.
"""

from __future__ import annotations

import contextlib
import csv
import io
import json
import os
import sqlite3
import struct
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Iterator, List, Optional, Sequence, Tuple

import numpy as np
from osgeo import gdal, gdal_array, ogr, osr

from ..core.database.model import FORMAT_VERSION, BuildParameters, MapLandmarks, ReferenceDatabase, Windows
from ..core.errors import DatabaseError
from ..core.labels.class_table import ClassTable, class_table_from_csv
from .gdal_errors import gdal_failure, gdal_failures
from .label_map_file import set_class_colors

WINDOWS, REFERENCES, BOUNDS, OVERVIEW, CLASSES, PARAMETERS, STYLES = (
    "windows",
    "references",
    "reference_bounds",
    "overview",
    "classes",
    "parameters",
    "layer_styles",
)

_CLASS_COLUMNS = ("value", "name", "color", "role", "draw_order", "hsv_min", "hsv_max")
_FEATURES_A_STEP = 2000

_INTEGER, _REAL, _TEXT, _BLOB, _BOOLEAN = "integer", "real", "text", "blob", "boolean"
_WINDOW_FIELDS = (
    ("name", _TEXT),
    ("level", _INTEGER),
    ("size", _REAL),
    ("center_x", _REAL),
    ("center_y", _REAL),
    ("longitude", _REAL),
    ("latitude", _REAL),
    ("reference_count", _INTEGER),
    ("vector", _BLOB),
    ("distinctiveness", _REAL),
)
REFERENCE_FIELDS = (("class", _INTEGER), ("class_name", _TEXT), ("area", _REAL), ("touches_edge", _BOOLEAN))
BOUNDS_FIELDS = (
    ("first_column", _INTEGER),
    ("first_row", _INTEGER),
    ("end_column", _INTEGER),
    ("end_row", _INTEGER),
)
_STYLE_FIELDS = (
    ("f_table_catalog", _TEXT),
    ("f_table_schema", _TEXT),
    ("f_table_name", _TEXT),
    ("f_geometry_column", _TEXT),
    ("styleName", _TEXT),
    ("styleQML", _TEXT),
    ("styleSLD", _TEXT),
    ("useAsDefault", _BOOLEAN),
    ("description", _TEXT),
    ("owner", _TEXT),
    ("ui", _TEXT),
    ("update_time", "datetime"),
)


# --- writing ---


class DatabaseWriter:
    """Writes a database to ``path`` (a temporary one); iterate ``steps()`` to the end.

    longitudes, latitudes, distinctiveness: (N,) of the windows, NaN as NULL; overview: (h, w) uint8;
    styles: QML by table. Raises DatabaseError when GDAL can't write.
    """

    def __init__(
        self,
        path: str,
        database: ReferenceDatabase,
        longitudes: np.ndarray,
        latitudes: np.ndarray,
        distinctiveness: np.ndarray,
        overview: np.ndarray,
        styles: dict,
    ) -> None:
        self._path = path
        self._database = database
        self._longitudes = longitudes
        self._latitudes = latitudes
        self._distinctiveness = distinctiveness
        self._overview = overview
        self._styles = styles

    def steps(self) -> Iterator[Tuple[str, float]]:
        """Yields (what is being done, share done 0…1)."""
        try:
            for share in self._write():
                yield "Writing the database", share
        except RuntimeError as error:
            raise DatabaseError(f"The database can't be written: {gdal_failure(error)}.") from None

    def _write(self) -> Iterator[float]:
        database, srs = self._database, osr.SpatialReference()
        srs.ImportFromWkt(database.parameters.crs)
        dataset = ogr.GetDriverByName("GPKG").CreateDataSource(self._path)
        if dataset is None:
            raise DatabaseError(f"The database can't be written: {gdal_failure()}.")
        total = len(database.windows) + len(database.references)
        for n, done in enumerate(self._write_layers(dataset, srs)):
            if n % _FEATURES_A_STEP == 0:
                yield 0.9 * done / total
        close(dataset)
        yield 0.9
        self._write_overview(srs)
        leave_wal(self._path)
        yield 1.0

    def _write_layers(self, dataset: ogr.DataSource, srs: osr.SpatialReference) -> Iterator[int]:
        done = 0
        for name, srs_or_none, geometry, schema, rows in (
            (WINDOWS, srs, ogr.wkbPolygon, _WINDOW_FIELDS, self._window_rows()),
            (REFERENCES, srs, ogr.wkbPoint, REFERENCE_FIELDS, self._reference_rows()),
            (BOUNDS, None, ogr.wkbNone, BOUNDS_FIELDS, self._bounds_rows()),
            (CLASSES, None, ogr.wkbNone, _class_schema(), self._class_rows()),
            (PARAMETERS, None, ogr.wkbNone, (("key", _TEXT), ("value", _TEXT)), self._parameter_rows()),
            (STYLES, None, ogr.wkbNone, _STYLE_FIELDS, self._style_rows()),
        ):
            layer = dataset.CreateLayer(name, srs_or_none, geometry, ["FID=id" if name == STYLES else "FID=fid"])
            if layer is None:
                raise DatabaseError(f"The layer {name} can't be written: {gdal_failure()}.")
            for field_name, kind in schema:
                layer.CreateField(_field_definition(field_name, kind))
            dataset.StartTransaction()
            for wkb, values in rows:
                write_feature(layer, schema, wkb, values)
                done += 1
                yield done
            dataset.CommitTransaction()

    def _window_rows(self) -> Iterator[Tuple[bytes, tuple]]:
        windows = self._database.windows
        for i in range(len(windows)):
            (x, y), half = windows.centers[i].tolist(), float(windows.sizes[i]) / 2
            vector = windows.vectors[i].astype("<f4").tobytes() if windows.described[i] else None
            values = (
                str(windows.names[i]),
                int(windows.levels[i]),
                float(windows.sizes[i]),
                x,
                y,
                float(self._longitudes[i]),
                float(self._latitudes[i]),
                int(windows.counts[i]),
                vector,
                float(self._distinctiveness[i]),
            )
            yield _square_wkb(x - half, y - half, x + half, y + half), values

    def _reference_rows(self) -> Iterator[Tuple[bytes, tuple]]:
        return reference_rows(self._database.references, self._database.class_table)

    def _bounds_rows(self) -> Iterator[Tuple[None, tuple]]:
        # In the references' order, and so with their fids.
        for bounds in self._database.references.bounds_px.tolist():
            yield None, tuple(bounds)

    def _class_rows(self) -> Iterator[Tuple[None, tuple]]:
        for c in self._database.class_table:
            hsv = (None if limit is None else " ".join(map(str, limit)) for limit in (c.hsv_min, c.hsv_max))
            yield None, (c.value, c.name, c.color, c.role, c.draw_order, *hsv)

    def _parameter_rows(self) -> Iterator[Tuple[None, tuple]]:
        parameters = self._database.parameters
        for item in fields(parameters):
            yield None, (item.name, parameter_text(parameters, item.name))

    def _style_rows(self) -> Iterator[Tuple[None, tuple]]:
        for table, qml in self._styles.items():
            yield None, ("", "", table, "geom", table, qml, None, 1, "SemRef", "", None, "now")

    def _write_overview(self, srs: osr.SpatialReference) -> None:
        # Shares the array's memory, as GDAL's drivers copy from datasets only.
        memory = gdal_array.OpenArray(self._overview)
        memory.SetGeoTransform(self._database.parameters.overview_frame.geotransform)
        memory.SetProjection(srs.ExportToWkt())
        band = memory.GetRasterBand(1)
        set_class_colors(band, self._database.class_table)
        options = ["APPEND_SUBDATASET=YES", f"RASTER_TABLE={OVERVIEW}", "TILE_FORMAT=PNG"]
        written = gdal.GetDriverByName("GPKG").CreateCopy(self._path, memory, options=options)
        if written is None:
            raise DatabaseError(f"The overview can't be written: {gdal_failure()}.")
        close(written)


def reference_rows(references: MapLandmarks, table: ClassTable) -> Iterator[Tuple[bytes, tuple]]:
    """Geometry (WKB) and column values of each reference."""
    names = {c.value: c.name for c in table}
    for i in range(len(references)):
        x, y = references.positions[i].tolist()
        value = int(references.classes[i])
        values = value, names[value], float(references.areas_m2[i]), int(references.touches_edge[i])
        yield struct.pack("<BIdd", 1, ogr.wkbPoint, x, y), values


def parameter_text(parameters: BuildParameters, name: str) -> str:
    """A build parameter as it stands in the table ``parameters``."""
    return json.dumps(getattr(parameters, name))


def _field_definition(name: str, kind: str) -> ogr.FieldDefn:
    types = {_INTEGER: ogr.OFTInteger, _REAL: ogr.OFTReal, _TEXT: ogr.OFTString, _BLOB: ogr.OFTBinary}
    types.update({_BOOLEAN: ogr.OFTInteger, "datetime": ogr.OFTDateTime})
    definition = ogr.FieldDefn(name, types[kind])
    if kind == _BOOLEAN:
        definition.SetSubType(ogr.OFSTBoolean)
    return definition


def _class_schema() -> Tuple[Tuple[str, str], ...]:
    kinds = {"value": _INTEGER, "draw_order": _REAL}
    return tuple((name, kinds.get(name, _TEXT)) for name in _CLASS_COLUMNS)


def write_feature(
    layer: ogr.Layer,
    schema: Sequence[Tuple[str, str]],
    wkb: Optional[bytes],
    values: Sequence,
    fid: Optional[int] = None,
) -> int:
    """Adds a feature and gives its fid."""
    feature = ogr.Feature(layer.GetLayerDefn())
    if fid is not None:
        feature.SetFID(fid)
    for index, ((_, kind), value) in enumerate(zip(schema, values)):
        if value is None or (kind == _REAL and not np.isfinite(value)):
            continue
        if kind == _BLOB:
            feature.SetFieldBinaryFromHexString(index, value.hex())
        elif kind == "datetime":
            now = np.datetime64("now").astype(object)
            feature.SetField(index, now.year, now.month, now.day, now.hour, now.minute, float(now.second), 100)
        else:
            feature.SetField(index, value)
    if wkb is not None:
        feature.SetGeometryDirectly(ogr.CreateGeometryFromWkb(wkb))
    if layer.CreateFeature(feature) != ogr.OGRERR_NONE:
        raise DatabaseError(f"The database can't be written: {gdal_failure()}.")
    return feature.GetFID()


def _square_wkb(left: float, bottom: float, right: float, top: float) -> bytes:
    ring = (left, bottom, right, bottom, right, top, left, top, left, bottom)
    return struct.pack("<BIII10d", 1, ogr.wkbPolygon, 1, 5, *ring)


def close(dataset) -> None:
    """Writes what waits; raises DatabaseError when that fails."""
    gdal.ErrorReset()
    dataset.FlushCache()
    if gdal.GetLastErrorType() >= gdal.CE_Failure:
        raise DatabaseError(f"The database can't be written: {gdal_failure()}.")


def copy_database(path: str, target: str) -> None:
    """Copies a database as it is, changes that still wait beside it included."""
    with contextlib.closing(_connect(path)) as source, contextlib.closing(sqlite3.connect(target)) as copy:
        source.backup(copy)


def leave_wal(path: str) -> None:
    """No -wal and -shm beside the finished file."""
    with contextlib.closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        connection.execute("PRAGMA journal_mode=DELETE")


# --- reading ---

_JSON_TYPES = {"str": str, "int": int, "float": (int, float), "tuple": list}
"""What JSON makes of the types of BuildParameters."""


def read_database(path: str, with_overview: bool = False) -> ReferenceDatabase:
    """Reads a reference database. Raises DatabaseError for files that are missing, foreign, truncated or too new."""
    if not os.path.isfile(path):
        raise DatabaseError(f"There is no database {path}; build one or choose another file.")
    try:
        with contextlib.closing(_connect(path)) as connection:
            _check_is_ours(connection, path)
            parameters = _read_parameters(connection, path)
            table = class_table_from_csv(_class_csv(connection), f"the class table of {path}")
            windows = _read_windows(connection, parameters.references_per_vector, path)
            references = _read_references(connection)
    except (sqlite3.Error, TypeError, ValueError, IndexError, struct.error) as error:
        raise DatabaseError(
            f"{path} is damaged or cut short ({error}); build it again or fetch another copy."
        ) from None
    overview = read_overview(path) if with_overview else None
    return ReferenceDatabase(windows, references, table, parameters, path, overview)


def read_overview(path: str) -> np.ndarray:
    """(h, w) uint8 class values. Raises DatabaseError for a database that has none."""
    # Left as it is where GDAL raises.
    overview = None
    with gdal_failures() as failures:
        dataset = gdal.OpenEx(f"GPKG:{path}:{OVERVIEW}", gdal.OF_RASTER)
        overview = None if dataset is None else dataset.GetRasterBand(1).ReadAsArray()
    if overview is None:
        reason = gdal_failure(failures[0] if failures else None)
        raise DatabaseError(f"{path} has no overview that can be read ({reason}); build it again.")
    return overview


def _connect(path: str) -> sqlite3.Connection:
    with open(path, "rb") as file:
        header = file.read(100)
    if not header.startswith(b"SQLite format 3\0"):
        raise DatabaseError(f"{path} is not a GeoPackage; choose a database made by “Build reference database”.")
    # SQLite notices missing pages only when it comes to them.
    page_size, pages = struct.unpack_from(">16xH10xI", header.ljust(100, b"\0"))
    if os.path.getsize(path) < pages * (page_size if page_size > 1 else 65536):
        raise ValueError("its end is missing")
    wal = Path(path + "-wal")
    # Without changes in waiting the file is read as it is, so that read-only places work and no -shm appears.
    quiet = "" if wal.exists() and wal.stat().st_size else "&immutable=1"
    return sqlite3.connect(f"{Path(path).resolve().as_uri()}?mode=ro{quiet}", uri=True)


def _check_is_ours(connection: sqlite3.Connection, path: str) -> None:
    found = {row[0] for row in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    missing = [name for name in (WINDOWS, REFERENCES, CLASSES, PARAMETERS) if name not in found]
    if missing:
        raise DatabaseError(
            f"{path} is not a SemRef reference database (it lacks {', '.join(missing)}); "
            "choose one made by “Build reference database”."
        )


def _read_parameters(connection: sqlite3.Connection, path: str) -> BuildParameters:
    stored = dict(connection.execute("SELECT key, value FROM parameters"))
    try:
        values = {key: json.loads(value) for key, value in stored.items()}
        # A newer version may have parameters that this one does not know, so its number is looked at first.
        if values["format_version"] > FORMAT_VERSION:
            raise DatabaseError(
                f"{path} has format version {values['format_version']}, newer than this SemRef reads "
                f"({FORMAT_VERSION}); update the plugin."
            )
        # Databases of older versions have no block hashes.
        values.setdefault("block_hashes", [])
        known = {item.name: values[item.name] for item in fields(BuildParameters)}
        for item in fields(BuildParameters):
            if not isinstance(known[item.name], _JSON_TYPES[item.type]):
                raise TypeError(f"{item.name} (it is {known[item.name]!r})")
    except (KeyError, ValueError, TypeError) as error:
        raise DatabaseError(f"{path} has no readable parameter {error}; build it again.") from None
    for name in ("geotransform", "levels", "block_hashes"):
        known[name] = tuple(known[name])
    return BuildParameters(**known)


def _class_csv(connection: sqlite3.Connection) -> str:
    rows = connection.execute("SELECT value, name, color, role, draw_order, hsv_min, hsv_max FROM classes").fetchall()
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow(_CLASS_COLUMNS)
    writer.writerows(["" if cell is None else cell for cell in row] for row in rows)
    return text.getvalue()


def _read_windows(connection: sqlite3.Connection, references_per_vector: int, path: str) -> Windows:
    rows = connection.execute(
        "SELECT name, level, size, center_x, center_y, reference_count, vector FROM windows ORDER BY fid"
    ).fetchall()
    names, levels, sizes, xs, ys, counts, blobs = zip(*rows) if rows else ((),) * 7
    length = 3 * references_per_vector
    if any(blob is not None and len(blob) != 4 * length for blob in blobs):
        raise DatabaseError(f"{path} has vectors that are not {length} numbers long; build it again.")
    places = np.array([sizes, xs, ys], np.float64)
    if not np.isfinite(places).all():
        raise ValueError("a window has no place or size")
    vectors = np.zeros((len(rows), length), np.float32)
    for i, blob in enumerate(blobs):
        if blob is not None:
            vectors[i] = np.frombuffer(blob, "<f4")
    return Windows(
        np.array(names, dtype=str),
        np.array(levels, np.int64),
        places[0],
        places[1:].T.copy(),
        np.array(counts, np.int64),
        vectors,
        np.array([blob is not None for blob in blobs], bool),
    )


def _read_references(connection: sqlite3.Connection) -> MapLandmarks:
    rows = connection.execute('SELECT geom, class, area, touches_edge FROM "references" ORDER BY fid').fetchall()
    blobs, classes, areas, touches = zip(*rows) if rows else ((),) * 4
    return MapLandmarks(
        _points(blobs), np.array(classes, np.uint8), np.array(areas, np.float64), np.array(touches, bool)
    )


def _points(blobs: Sequence[bytes]) -> np.ndarray:
    """GeoPackage point blobs (8-byte header without envelope, then WKB) → (N, 2)."""
    found: List[Tuple[float, float]] = []
    for blob in blobs:
        order = "<" if blob[8] else ">"
        found.append(struct.unpack_from(f"{order}dd", blob, 13))
    return np.array(found, np.float64).reshape(-1, 2)


@dataclass(frozen=True)
class StoredDatabase:
    """A database as an update needs it.

    database: with the references' bounds, None when the file has none; distinctiveness: (N,) of its windows, NaN for
    NULL; window_fids, reference_fids: of its windows and references, in their order.
    """

    database: ReferenceDatabase
    distinctiveness: np.ndarray
    window_fids: Tuple[int, ...]
    reference_fids: Tuple[int, ...]


def read_stored_database(path: str) -> StoredDatabase:
    """Reads what ``read_database`` reads and what an update needs besides; raises DatabaseError as that does."""
    database = read_database(path)
    try:
        with contextlib.closing(_connect(path)) as connection:
            windows = connection.execute("SELECT fid, distinctiveness FROM windows ORDER BY fid").fetchall()
            fids = connection.execute('SELECT fid FROM "references" ORDER BY fid').fetchall()
            bounds = _read_bounds(connection)
    except (sqlite3.Error, ValueError) as error:
        raise DatabaseError(
            f"{path} is damaged or cut short ({error}); build it again or fetch another copy."
        ) from None
    if bounds is not None and len(bounds) != len(fids):
        raise DatabaseError(f"{path} has {len(fids)} landmarks and bounds of {len(bounds)}; build it again.")
    database = replace(database, references=replace(database.references, bounds_px=bounds))
    distinctiveness = np.array([np.nan if value is None else value for _, value in windows], np.float64)
    return StoredDatabase(database, distinctiveness, tuple(fid for fid, _ in windows), tuple(fid for (fid,) in fids))


def _read_bounds(connection: sqlite3.Connection) -> Optional[np.ndarray]:
    """(N, 4) int64 bounds of the references in the order of their fids; None in databases of older versions."""
    found = connection.execute("SELECT count(*) FROM sqlite_master WHERE name = ?", (BOUNDS,)).fetchone()
    if not found[0]:
        return None
    rows = connection.execute(
        'SELECT first_column, first_row, end_column, end_row FROM reference_bounds AS b JOIN "references" AS r '
        "ON r.fid = b.fid ORDER BY b.fid"
    ).fetchall()
    return np.array(rows, np.int64).reshape(-1, 4)


def stored_style(path: str, table: str) -> Optional[str]:
    """QML of the style of one table of a database, None when it has none."""
    try:
        with contextlib.closing(_connect(path)) as connection:
            row = connection.execute("SELECT styleQML FROM layer_styles WHERE f_table_name = ?", (table,)).fetchone()
    except (sqlite3.Error, ValueError):
        return None
    return row[0] if row else None
