"""Write a new reference database."""

from __future__ import annotations

import contextlib
import re
import sqlite3
from collections.abc import Iterator
from dataclasses import fields
from html import unescape
from pathlib import Path

import numpy as np
from osgeo import gdal, gdal_array, ogr, osr

from ...core.database.model import ReferenceDatabase
from ...core.errors import DatabaseError
from ...core.labels.overview import HeldOverview
from ..gdal_errors import close, gdal_failure, gdal_failures
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


class DatabaseWriter:
    """Writer of a database. Iterate ``steps()`` to the end."""

    def __init__(  # noqa: PLR0913 - what a file holds; only the plugin has PROJ and styles
        self,
        path: str,
        database: ReferenceDatabase,
        longitudes: np.ndarray,
        latitudes: np.ndarray,
        overview: np.ndarray | HeldOverview | OverviewFile,
        styles: dict[str, str],
    ) -> None:
        """Prepare without writing. NaN is written as NULL.

        Args:
            database: The database, with the windows' distinctiveness.
            longitudes: (N,) degrees of the windows' centers.
            latitudes: (N,) degrees of the windows' centers.
            overview: (h, w) uint8 class values, or the object with its parts.
        """
        self._path = path
        self._database = database
        self._longitudes = longitudes
        self._latitudes = latitudes
        self._overview = overview.labels if isinstance(overview, HeldOverview) else overview
        self._styles = styles

    def steps(self) -> Iterator[tuple[str, float]]:
        """Yield (current step, share done 0…1).

        Raises:
            DatabaseError: GDAL can't write.
        """
        try:
            for share in self._write():
                yield "Writing the database", share
        except (RuntimeError, sqlite3.Error) as error:
            raise DatabaseError("The database can't be written: {reason}.", reason=gdal_failure(error)) from None

    def _write(self) -> Iterator[float]:
        database, srs = self._database, osr.SpatialReference()
        srs.ImportFromWkt(database.parameters.crs)
        dataset = ogr.GetDriverByName("GPKG").CreateDataSource(self._path)
        if dataset is None:
            raise DatabaseError("The database can't be written: {reason}.", reason=gdal_failure())
        total = len(database.windows) + 2 * len(database.references) + _OTHER_ROWS
        for n, done in enumerate(self._write_layers(dataset, srs)):
            if n % _FEATURES_A_STEP == 0:
                yield 0.9 * done / total
        schema.close(dataset)
        yield 0.9
        self._write_overview(srs)
        leave_wal(self._path)
        _write_titles(self._path)
        store_checksums(self._path)
        yield 1.0

    def _write_layers(self, dataset: ogr.DataSource, srs: osr.SpatialReference) -> Iterator[int]:
        done = 0
        rows_of = {
            schema.WINDOWS: self._window_rows,
            schema.REFERENCES: self._reference_rows,
            schema.BOUNDS: self._bounds_rows,
            schema.CLASSES: self._class_rows,
            schema.PARAMETERS: self._parameter_rows,
            schema.STYLES: self._style_rows,
        }
        for name, (_, columns) in schema.LAYERS.items():
            layer = schema.create_layer(dataset, name, srs)
            rows = rows_of[name]()
            dataset.StartTransaction()
            for wkb, values in rows:
                schema.write_feature(layer, columns, wkb, values)
                done += 1
                yield done
            dataset.CommitTransaction()

    def _window_rows(self) -> Iterator[tuple[bytes, tuple]]:
        windows = self._database.windows
        for i in range(len(windows)):
            (x, y), half = windows.centers[i].tolist(), float(windows.sizes[i]) / 2
            vector = windows.vectors[i].astype("<f4").tobytes() if windows.described[i] else None
            values = (
                windows.name(i),
                int(windows.levels[i]),
                float(windows.sizes[i]),
                x,
                y,
                float(self._longitudes[i]),
                float(self._latitudes[i]),
                int(windows.counts[i]),
                vector,
                float(windows.distinctiveness[i]),
            )
            yield schema.square_wkb(x - half, y - half, x + half, y + half), values

    def _reference_rows(self) -> Iterator[tuple[bytes, tuple]]:
        return schema.reference_rows(self._database.references, self._database.class_table)

    def _bounds_rows(self) -> Iterator[tuple[None, tuple]]:
        # In the order of the references, so that the fids are equal.
        bounds = self._database.references.bounds_px
        for first in range(0, len(bounds), BATCH):
            for row in bounds[first : first + BATCH].tolist():
                yield None, tuple(row)

    def _class_rows(self) -> Iterator[tuple[None, tuple]]:
        for c in self._database.class_table:
            hsv = (None if limit is None else " ".join(map(str, limit)) for limit in (c.hsv_min, c.hsv_max))
            yield None, (c.value, c.name, c.color, c.role, c.draw_order, *hsv)

    def _parameter_rows(self) -> Iterator[tuple[None, tuple]]:
        parameters = self._database.parameters
        for item in fields(parameters):
            yield None, (item.name, schema.parameter_text(parameters, item.name))

    def _style_rows(self) -> Iterator[tuple[None, tuple]]:
        for table, qml in self._styles.items():
            yield None, ("", "", table, "geom", table, qml, None, 1, "SemRef", "", None, "now")

    def _write_overview(self, srs: osr.SpatialReference) -> None:
        # GDAL's drivers copy datasets; the dataset of an array shares its memory.
        held = isinstance(self._overview, np.ndarray)
        memory = gdal_array.OpenArray(self._overview) if held else self._overview.dataset()
        memory.SetGeoTransform(self._database.parameters.overview_frame.geotransform)
        memory.SetProjection(srs.ExportToWkt())
        band = memory.GetRasterBand(1)
        set_class_colors(band, self._database.class_table)
        options = ["APPEND_SUBDATASET=YES", f"RASTER_TABLE={schema.OVERVIEW}", "TILE_FORMAT=PNG"]
        is_made = False
        with gdal_failures() as failures:
            # GDAL writes its last tables when it closes the file.
            made = gdal.GetDriverByName("GPKG").CreateCopy(self._path, memory, options=options)
            is_made = made is not None
            close(made)
            del made
        if failures or not is_made:
            raise DatabaseError(
                "The overview can't be written: {reason}.", reason=failures[0] if failures else gdal_failure()
            )


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
