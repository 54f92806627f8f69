"""Writing a whole reference database."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from dataclasses import fields

import numpy as np
from osgeo import gdal, gdal_array, ogr, osr

from ...core.database.model import ReferenceDatabase
from ...core.errors import DatabaseError
from ...core.labels.overview import HeldOverview
from ..gdal_errors import close, gdal_failure, gdal_failures
from ..label_map_file import set_class_colors
from ..vector_files import leave_wal
from . import schema
from .batches import BATCH
from .overview_file import OverviewFile
from .reader import store_checksums
from .titles import tell_titles

_FEATURES_A_STEP = 2000

_OTHER_ROWS = 1000
"""At most, of classes, parameters and styles."""


class DatabaseWriter:
    """Writes a database to ``path`` (a temporary one); iterate ``steps()`` to the end."""

    def __init__(  # noqa: PLR0913 - what a file holds; only the plugin has PROJ and styles
        self,
        path: str,
        database: ReferenceDatabase,
        longitudes: np.ndarray,
        latitudes: np.ndarray,
        overview: np.ndarray | HeldOverview | OverviewFile,
        styles: dict[str, str],
    ) -> None:
        """Makes the writer.

        Args:
            path: The new file.
            database: With the windows' distinctiveness, NaN is written as NULL.
            longitudes: (N,) degrees, of the windows' centers; NaN is written as NULL.
            latitudes: (N,) degrees, as well.
            overview: (h, w) uint8, or what took its pieces.
            styles: QML by table.
        """
        self._path = path
        self._database = database
        self._longitudes = longitudes
        self._latitudes = latitudes
        self._overview = overview.labels if isinstance(overview, HeldOverview) else overview
        self._styles = styles

    def steps(self) -> Iterator[tuple[str, float]]:
        """Yields (what is being done, share done 0…1).

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
        tell_titles(self._path)
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
        # In the references' order, and so with their fids.
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
        # GDAL's drivers copy from datasets only; one of an array shares its memory.
        held = isinstance(self._overview, np.ndarray)
        memory = gdal_array.OpenArray(self._overview) if held else self._overview.dataset()
        memory.SetGeoTransform(self._database.parameters.overview_frame.geotransform)
        memory.SetProjection(srs.ExportToWkt())
        band = memory.GetRasterBand(1)
        set_class_colors(band, self._database.class_table)
        options = ["APPEND_SUBDATASET=YES", f"RASTER_TABLE={schema.OVERVIEW}", "TILE_FORMAT=PNG"]
        is_made = False
        with gdal_failures() as failures:
            # GDAL writes its last tables when it lets go of the file.
            made = gdal.GetDriverByName("GPKG").CreateCopy(self._path, memory, options=options)
            is_made = made is not None
            close(made)
            del made
        if failures or not is_made:
            raise DatabaseError(
                "The overview can't be written: {reason}.", reason=failures[0] if failures else gdal_failure()
            )
