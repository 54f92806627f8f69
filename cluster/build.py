"""``build``: a label map to a reference database by many workers."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from osgeo import gdal

from ..core.database.build import BuildSettings
from ..core.database.model import ReferenceDatabase
from ..core.database.parts import PartsBuilder
from ..core.errors import ParameterError
from ..core.geometry.frame import MapFrame
from ..core.labels.class_table import ClassTable
from ..core.labels.overview import HeldOverview
from ..storage.database.notes import write_notes
from ..storage.database.overview_file import CACHE_BYTES, OverviewFile, overview_beside
from ..storage.database.styles import plain_styles
from ..storage.database.writer import DatabaseWriter
from ..storage.files import written_beside
from ..storage.map_frames import label_map_frame, longitudes_latitudes
from ..storage.metadata import plugin_metadata
from ..storage.notes import history, raster_source
from ..storage.rasters import GdalLabels, RasterFile, class_table_of_map, class_table_of_values, count_values
from .engine import DaskRunner, connected
from .inputs import Teller, moment_of, plain, require_apart, require_unchanged, seen_by_workers, state

_WRITTEN_FROM = 0.85
"""Share of all that is done when writing begins."""


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
    path = seen_by_workers(options.labels)
    require_apart(path, options.database)
    labels = GdalLabels(path)
    frame, before = label_map_frame(labels, path), state(path)
    table = _table(labels, path, options.reference_classes or "", teller)
    # What is read and written here goes through once: by default GDAL's cache is a share of the machine's memory.
    gdal.SetCacheMax(CACHE_BYTES)
    shape_hw = frame.reduced(settings.overview_factor).shape_hw
    target = str(Path(options.database).absolute())
    with written_beside(target) as temporary, overview_beside(temporary, shape_hw) as overview:
        with overview, connected(options.scheduler, options.local, options.worker_memory, teller.say) as client:
            version = plugin_metadata()["version"]
            builder = PartsBuilder(frame, table, settings, version, DaskRunner(client, path), overview.put)
            _tell_rounding(builder, frame, settings, teller)
            for text, share in builder.steps():
                teller.step(text, _WRITTEN_FROM * share)
        require_unchanged({path: before})
        database = _complete(builder)
        for text, share in _written(temporary, database, overview, before):
            teller.step(text, _WRITTEN_FROM + (1 - _WRITTEN_FROM) * share)
        if not options.without_note:
            moment = moment_of(before)
            made = history(moment, version, _command(options, settings))
            write_notes(temporary, raster_source(path), database.parameters.crs, made, moment)
    windows = database.windows
    return {
        "database": options.database,
        "windows": len(windows),
        "references": len(database.references),
        "windows_without_vector": int((~windows.described).sum()),
    }


def _command(options: Namespace, settings: BuildSettings) -> list[str]:
    """What makes the same database again, wherever it goes to and whoever does it."""
    given = ["build", options.labels]
    if options.reference_classes:
        given += ["--reference-classes", options.reference_classes]
    given += ["--window-size", plain(settings.window_size), "--stride", plain(settings.stride)]
    given += ["--levels", ";".join(map(plain, settings.levels))]
    given += ["--references-per-vector", str(settings.references_per_vector)]
    given += ["--minimum-area", plain(settings.minimum_area), "--map-accuracy", plain(settings.map_accuracy)]
    return given


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
    path: str, database: ReferenceDatabase, overview: HeldOverview | OverviewFile, changed: tuple[int, float]
) -> Iterator[tuple[str, float]]:
    """Writes the GeoPackage, dated by the label map: the same map gives the same bytes."""
    degrees = longitudes_latitudes(database.windows.centers, database.parameters.crs)
    styles = plain_styles(database.class_table)
    yield from DatabaseWriter(path, database, *degrees, overview, styles, moment_of(changed)).steps()
