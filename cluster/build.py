"""``build``: a label map to a reference database by many workers."""

from __future__ import annotations

import tempfile
from argparse import Namespace
from collections.abc import Iterator
from datetime import datetime, timezone
from pathlib import Path
from typing import Any, Callable, Protocol

import numpy as np
from osgeo import gdal

from ..core.database.build import BuildSettings
from ..core.database.model import ReferenceDatabase
from ..core.database.parts import PartsBuilder
from ..core.errors import LabelMapError, ParameterError
from ..core.geometry.frame import MapFrame
from ..core.labels.class_table import ClassTable
from ..storage.database.styles import plain_styles
from ..storage.database.writer import DatabaseWriter
from ..storage.files import written_beside
from ..storage.map_frames import label_map_frame, longitudes_latitudes
from ..storage.metadata import plugin_metadata
from ..storage.rasters import GdalLabels, RasterFile, class_table_of_map, class_table_of_values, count_values
from .engine import DaskRunner, connected

_WRITTEN_FROM = 0.85
"""Share of all that is done when writing begins."""

_HELD_OVERVIEW = 256 << 20
"""Bytes of an overview that is held in memory; a larger one lies in a file without a name until it is written."""


class Teller(Protocol):
    """Takes what is being done."""

    def step(self, text: str, share: float) -> None:
        """What is being done, and how much of all is (0…1)."""

    def say(self, text: str) -> None:
        """Anything else worth a line."""


def build(options: Namespace, teller: Teller) -> dict[str, Any]:
    """Builds the database that the command line asks for.

    Args:
        options: Of the command line.
        teller: Takes what is being done.

    Returns:
        What came of it, by name.

    Raises:
        SemRefError: Anything that the user can mend.
    """
    settings = _settings(options)
    path = options.labels if options.labels.startswith("/vsi") else str(Path(options.labels).absolute())
    if Path(path).exists() and Path(options.database).exists() and Path(path).samefile(options.database):
        raise ParameterError("cluster.output_is_input", path=path)
    labels = GdalLabels(path)
    frame, state = label_map_frame(labels, path), _state(path)
    table = _table(labels, path, options.reference_classes, teller)
    with written_beside(str(Path(options.database).absolute())) as temporary:
        overview = _Overview(frame.reduced(settings.overview_factor).shape_hw, Path(temporary).parent)
        with connected(options.scheduler, options.local, options.worker_memory, teller.say) as client:
            version = plugin_metadata()["version"]
            builder = PartsBuilder(frame, table, settings, version, DaskRunner(client, path), overview.put)
            _tell_rounding(builder, frame, settings, teller)
            for text, share in builder.steps():
                teller.step(text, _WRITTEN_FROM * share)
        if _state(path) != state:
            raise LabelMapError("cluster.map_changed", path=path)
        database = _complete(builder)
        for text, share in _written(temporary, database, overview.labels, state):
            teller.step(text, _WRITTEN_FROM + (1 - _WRITTEN_FROM) * share)
        del overview
    windows = database.windows
    return {
        "database": options.database,
        "windows": len(windows),
        "references": len(database.references),
        "windows_without_vector": int((~windows.described).sum()),
    }


def _settings(options: Namespace) -> BuildSettings:
    try:
        levels = tuple(float(part) for part in options.levels.split(";") if part.strip())
    except ValueError:
        raise ParameterError("cluster.not_a_number", option="--levels", text=options.levels) from None
    if options.stride > options.window_size:
        raise ParameterError("cluster.stride_above_size", stride=options.stride, size=options.window_size)
    return BuildSettings(
        options.window_size,
        options.stride,
        options.minimum_area,
        levels or (1.0,),
        options.references_per_vector,
        map_accuracy=options.map_accuracy,
    )


def _table(labels: GdalLabels, path: str, chosen: str, teller: Teller) -> ClassTable:
    """The map's class table with the asked reference classes."""
    table = class_table_of_map(labels, RasterFile(path))
    if table is None:
        teller.say("The label map brings no class names; its classes are named by their values.")
        table = class_table_of_values(count_values(labels, lambda: False))
    names = [part.strip() for part in chosen.split(";") if part.strip()]
    return (table.with_references(names) if names else table).require_references()


def _state(path: str) -> tuple[int, float]:
    """(bytes, time of the last change) of the label map, as GDAL knows them; zeros for what is no file."""
    found = gdal.VSIStatL(path)
    return (found.size, found.mtime) if found is not None else (0, 0)


def _tell_rounding(builder: PartsBuilder, frame: MapFrame, settings: BuildSettings, teller: Teller) -> None:
    for level, grid in zip(settings.levels, builder.grids):
        size, stride = grid.size * frame.pixel_size, grid.stride * frame.pixel_size
        asked = settings.window_size * level, settings.stride * level
        if abs(size - asked[0]) > 1e-9 * size or abs(stride - asked[1]) > 1e-9 * stride:
            teller.say(f"Windows are whole pixels: window size {size:g}, stride {stride:g}.")


def _complete(builder: PartsBuilder) -> ReferenceDatabase:
    if builder.database is None:
        raise RuntimeError
    return builder.database


def _written(
    path: str, database: ReferenceDatabase, overview: np.ndarray, state: tuple[int, float]
) -> Iterator[tuple[str, float]]:
    """Writes the GeoPackage, dated by the label map: the same map gives the same bytes."""
    degrees = longitudes_latitudes(database.windows.centers, database.parameters.crs)
    moment = datetime.fromtimestamp(state[1], timezone.utc).strftime("%Y-%m-%dT%H:%M:%S.000Z")
    styles = plain_styles(database.class_table)
    yield from DatabaseWriter(path, database, *degrees, overview, styles, moment).steps()


class _Overview:
    """The overview while its pieces come in."""

    def __init__(self, shape_hw: tuple[int, int], folder: Path) -> None:
        if shape_hw[0] * shape_hw[1] <= _HELD_OVERVIEW:
            self.labels = np.zeros(shape_hw, np.uint8)
        else:
            with tempfile.TemporaryFile(dir=folder) as file:
                self.labels = np.memmap(file, np.uint8, "w+", shape=shape_hw)

    @property
    def put(self) -> Callable[[int, int, np.ndarray], None]:
        """Takes a piece."""
        labels = self.labels

        def put(column: int, row: int, piece: np.ndarray) -> None:
            labels[row : row + piece.shape[0], column : column + piece.shape[1]] = piece

        return put
