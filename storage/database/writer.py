"""Write a new reference database."""

from __future__ import annotations

import contextlib
import re
import sqlite3
from collections.abc import Iterable, Iterator, Sequence
from html import unescape
from pathlib import Path

import numpy as np
from osgeo import gdal, gdal_array, ogr, osr

from ...core.database.model import ReferenceDatabase, Windows
from ...core.labels.class_table import ClassTable
from ...core.labels.overview import HeldOverview
from ...core.steps import Steps
from ..gdal_errors import close, gdal_failures, unwritten_database
from ..label_map_file import set_class_colors
from ..vector_files import leave_wal
from . import schema
from .overview_file import OverviewFile
from .reader import store_checksums
from .rows import BATCH

_TITLES = Path(__file__).resolve().parents[2] / "resources" / "styles" / "columns.qml"
_ALIAS = re.compile('<alias field="([^"]+)" name="([^"]+)"/>')

# Both tables of GeoPackage's schema extension, as GDAL creates and registers them.
_TABLES = (
    "CREATE TABLE gpkg_data_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, name TEXT, title TEXT, "
    "description TEXT, mime_type TEXT, constraint_name TEXT, "
    "CONSTRAINT pk_gdc PRIMARY KEY (table_name, column_name), CONSTRAINT gdc_tn UNIQUE (table_name, name))",
    "CREATE TABLE gpkg_data_column_constraints (constraint_name TEXT NOT NULL, constraint_type TEXT NOT NULL, "
    "value TEXT, min NUMERIC, min_is_inclusive BOOLEAN, max NUMERIC, max_is_inclusive BOOLEAN, description TEXT, "
    "CONSTRAINT gdcc_ntv UNIQUE (constraint_name, constraint_type, value))",
)
_REGISTER = (
    "INSERT INTO gpkg_extensions (table_name, column_name, extension_name, definition, scope) "
    "VALUES (?, NULL, 'gpkg_schema', 'http://www.geopackage.org/spec121/#extension_schema', 'read-write')"
)

_FEATURES_A_STEP = 2000

_OTHER_ROWS = 1000
"""Estimated rows of classes, parameters and styles, for the progress."""


def write_database(  # noqa: PLR0913 - what a file holds; only the plugin has PROJ and styles
    path: str,
    database: ReferenceDatabase,
    longitudes: np.ndarray,
    latitudes: np.ndarray,
    overview: np.ndarray | HeldOverview | OverviewFile,
    styles: dict[str, str],
) -> Steps[None]:
    """Write a database. NaN is written as NULL.

    Args:
        database: The database, with the windows' distinctiveness.
        longitudes: (N,) degrees of the windows' centers.
        latitudes: (N,) degrees of the windows' centers.
        overview: (h, w) uint8 class values, or the object with its parts.

    Raises:
        UnwritableError: GDAL can't write.
    """
    rows_of = {
        schema.WINDOWS: _window_rows(database.windows, longitudes, latitudes),
        schema.REFERENCES: schema.reference_rows(database.references, database.class_table),
        schema.BOUNDS: _bounds_rows(database.references.bounds_px),
        schema.CLASSES: _class_rows(database.class_table),
        schema.PARAMETERS: ((None, row) for row in schema.parameter_texts(database.parameters).items()),
        schema.STYLES: (
            (None, ("", "", table, "geom", table, qml, None, 1, "SemRef", "", None, "now"))
            for table, qml in styles.items()
        ),
    }
    total = len(database.windows) + 2 * len(database.references) + _OTHER_ROWS
    try:
        srs = osr.SpatialReference()
        srs.ImportFromWkt(database.parameters.crs)
        dataset = None
        with gdal_failures() as failures:
            dataset = ogr.GetDriverByName("GPKG").CreateDataSource(path)
        if failures or dataset is None:
            # On a full disk GDAL returns a dataset without tables.
            raise unwritten_database(failures[0] if failures else None)
        for n, _ in enumerate(_write_layers(dataset, srs, rows_of)):
            if n % _FEATURES_A_STEP == 0:
                yield "Writing the database", 0.9 * n / total
        schema.flush(dataset)
        yield "Writing the database", 0.9
        _write_overview(path, database, srs, overview)
        leave_wal(path)
        _write_titles(path)
        store_checksums(path)
        yield "Writing the database", 1.0
    except (RuntimeError, sqlite3.Error) as error:
        raise unwritten_database(error) from None


def _write_layers(
    dataset: ogr.DataSource, srs: osr.SpatialReference, rows_of: dict[str, Iterable[tuple[bytes | None, Sequence]]]
) -> Iterator[None]:
    for name, (_, columns) in schema.LAYERS.items():
        layer = schema.create_layer(dataset, name, srs)
        dataset.StartTransaction()
        for wkb, values in rows_of[name]:
            schema.write_feature(layer, columns, wkb, values)
            yield
        schema.commit(dataset)


def _window_rows(windows: Windows, longitudes: np.ndarray, latitudes: np.ndarray) -> Iterator[tuple[bytes, tuple]]:
    for i in range(len(windows)):
        (x, y), half = windows.centers[i].tolist(), float(windows.sizes[i]) / 2
        values = (
            windows.name(i),
            int(windows.levels[i]),
            float(windows.sizes[i]),
            x,
            y,
            float(longitudes[i]),
            float(latitudes[i]),
            int(windows.counts[i]),
            windows.vectors[i].astype("<f4").tobytes() if windows.described[i] else None,
            float(windows.distinctiveness[i]),
        )
        yield schema.square_wkb(x - half, y - half, x + half, y + half), values


def _bounds_rows(bounds: np.ndarray) -> Iterator[tuple[None, list]]:
    # In the order of the references, so that the fids are equal.
    for first in range(0, len(bounds), BATCH):
        for row in bounds[first : first + BATCH].tolist():
            yield None, row


def _class_rows(table: ClassTable) -> Iterator[tuple[None, tuple]]:
    for c in table:
        hsv = (None if limit is None else " ".join(map(str, limit)) for limit in (c.hsv_min, c.hsv_max))
        yield None, (c.value, c.name, c.color, c.role, c.draw_order, *hsv)


def _write_overview(
    path: str,
    database: ReferenceDatabase,
    srs: osr.SpatialReference,
    overview: np.ndarray | HeldOverview | OverviewFile,
) -> None:
    labels = overview.labels if isinstance(overview, HeldOverview) else overview
    # GDAL's drivers copy datasets; the dataset of an array shares its memory.
    memory = gdal_array.OpenArray(labels) if isinstance(labels, np.ndarray) else labels.dataset()
    memory.SetGeoTransform(database.parameters.overview_frame.geotransform)
    memory.SetProjection(srs.ExportToWkt())
    set_class_colors(memory.GetRasterBand(1), database.class_table)
    options = ["APPEND_SUBDATASET=YES", f"RASTER_TABLE={schema.OVERVIEW}", "TILE_FORMAT=PNG"]
    is_made = False
    with gdal_failures() as failures:
        # GDAL writes its last tables when it closes the file.
        made = gdal.GetDriverByName("GPKG").CreateCopy(path, memory, options=options)
        is_made = made is not None
        close(made)
        del made
    if failures or not is_made:
        raise unwritten_database(failures[0] if failures else None)


def _write_titles(path: str) -> None:
    """Write the English titles of columns into a new database. Raises sqlite3.Error.

    GDAL 3.6 can't write them. QGIS shows titles in the user's language; both come from ``columns.qml``.
    """
    titles = {name: unescape(text) for name, text in _ALIAS.findall(_TITLES.read_text(encoding="utf-8"))}
    tables = ("windows", schema.WINDOW_FIELDS), ("references", schema.REFERENCE_FIELDS)
    rows = [(table, name, titles[name], titles[name]) for table, fields in tables for name, _ in fields]
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        for statement in _TABLES:
            connection.execute(statement)
        connection.executemany(
            "INSERT INTO gpkg_data_columns (table_name, column_name, name, title) VALUES (?, ?, ?, ?)", rows
        )
        connection.executemany(_REGISTER, [("gpkg_data_columns",), ("gpkg_data_column_constraints",)])
