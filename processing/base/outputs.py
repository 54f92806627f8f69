"""Outputs of an algorithm: rasters, files, folders and layers that get their names only when they are complete."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, replace
from typing import Any, Callable, Union

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsFeatureSink,
    QgsFields,
    QgsGeometry,
    QgsProcessingContext,
)

from ...core.errors import ParameterError, UnwritableError
from ...core.labels.class_table import ClassTable
from ...storage.atomic_output import Batch
from ...storage.replaceable import require_closed
from ...storage.vector_files import content_digest, copy_geopackage, feature_count, lacks_spatial_index
from ..compat import make_field
from ..layers.database_layers import OPENED, open_when_done
from ..layers.layer_metadata import Note, save_in_database
from ..layers.output_style import Look, raster_style_when_loaded, style_in_file, style_in_memory, style_when_loaded
from . import parameters
from .destinations import Destination
from .values import Values

Schema = Union[Sequence[tuple[str, str]], QgsFields]
"""(name, kind) of each field, with kinds of ``compat.make_field``; or the fields of another layer."""

_NEW_KEYS = QgsFeatureSink.RegeneratePrimaryKey
"""A key in the fields of another layer is numbered again, because several features may share it."""


class Outputs:
    """Everything that one run of an algorithm writes.

    Each output is written beside its target, closed, opened again and counted; ``commit`` renames all of them at the
    end. An error or a cancel leaves nothing behind and does not change older files.

    Attributes:
        results: Final path of each output, by key: the result of the algorithm.
    """

    def __init__(self, values: Values, note: Note) -> None:
        """Prepare to write; ``note``: history and sources of the outputs."""
        self._values, self._note_of_run = values, note
        self._batch = Batch()
        self._layers: list[_Layer] = []
        self._copies: dict[str, str] = {}
        self._checks: list[Callable[[], None]] = []
        self._opened: list[str] = []
        self._rasters: list[str] = []
        self.results: dict[str, Any] = {}

    def __enter__(self) -> Outputs:
        return self

    def __exit__(self, *error: Any) -> None:
        self._batch.__exit__(*error)

    def commit(self) -> None:
        """Rename everything to its target and let QGIS load it from there."""
        self._batch.commit(*self._checks)
        for layer in self._layers:
            layer.announce(self._values.context)
        for path in self._rasters:
            OPENED.raster.emit(path)
        for key in self._opened:
            open_when_done(self.results[key], key, self._values.context)

    def require(self, check: Callable[[], None]) -> None:
        """Call ``check`` before anything is renamed; it may raise."""
        self._checks.append(check)

    @contextmanager
    def raster(self, key: str, write_style: Callable[[str], str] | None = None) -> Iterator[str]:
        """Yield a path to write a raster to; ``write_style`` writes its style and returns the path of it."""
        from ...storage.rasters import require_whole_raster

        target = self._values.raster_target(key)
        temporary = self._batch.file(target, *self._values.replaces(key))
        yield temporary
        require_whole_raster(temporary, target)
        if write_style is not None:
            raster_style_when_loaded(target, write_style(temporary), self._values.context)
        self.results[key] = target
        self._rasters.append(target)

    def label_map(self, key: str, table: ClassTable) -> AbstractContextManager[str]:
        """Yield a path to write a label map to, which gets its style."""
        from ..layers.class_styles import write_label_map_style

        return self.raster(key, lambda path: write_label_map_style(path, table, self._note(key)))

    def _note(self, key: str) -> Note:
        title, abstract = self._values.title_and_help(key)
        return replace(self._note_of_run, title=title, abstract=abstract)

    @contextmanager
    def file(self, key: str) -> Iterator[str]:
        """Yield a path to write a file to."""
        target = self._values.target(key)
        temporary = self._batch.file(target, *self._values.replaces(key))
        yield temporary
        if not os.path.isfile(temporary):
            raise _unwritable(target)
        self.results[key] = target

    @contextmanager
    def database(self, key: str) -> Iterator[str]:
        """Yield a path to write a reference database to, which gets its metadata; QGIS opens it if the user wants that.

        Raises:
            UnwritableError: The metadata cannot be written.
        """
        with self.file(key) as temporary:
            yield temporary
            if not save_in_database(temporary, self._note(key)):
                raise _unwritable(self._values.target(key))
        if self._values.switch(parameters.OPEN_OUTPUT):
            self._opened.append(key)

    def text(self, key: str, text: str) -> None:
        """Write a text in UTF-8."""
        with self.file(key) as temporary, open(temporary, "w", encoding="utf-8") as file:
            file.write(text)

    @contextmanager
    def folder(self, key: str) -> Iterator[str]:
        """Yield a new folder to fill; an empty path if the folder is not selected."""
        target = self._values.text(key)
        if not target:
            yield ""
            return
        yield self._batch.folder(target)
        self.results[key] = target

    @contextmanager
    def layer(
        self, key: str, schema: Schema, geometry: Any, crs: QgsCoordinateReferenceSystem, style: str = "", **look: Any
    ) -> Iterator[FeatureSink]:
        """Yield a sink to fill; a sink that is not selected ignores its features.

        Args:
            geometry: A kind of geometry of ``compat``.
            style: Its file in ``resources/styles``; columns get their titles without a style, too.
            **look: Further attributes of ``Look``.

        Raises:
            ParameterError, UnwritableError: The output cannot be made, or is incomplete.
        """
        fields = schema if isinstance(schema, QgsFields) else _fields(schema)
        wanted = self._values.destination(key)
        beside = self._beside(wanted)
        title = self._values.title(key)
        sink = FeatureSink(title, fields)
        # ``sink`` has the only reference to QGIS's sink: when it is released, the file is closed.
        written = sink.open(*self._values.sink(key, beside, fields, geometry, crs, _NEW_KEYS))
        if not sink.is_wanted and self._values.raw(key) is not None:
            raise _unwritable(title)
        try:
            yield sink
        finally:
            # Before the file is removed after an error: GDAL would report a broken disk.
            sink.close()
        if not written:
            return
        given = Look(style, note=self._note(key), **look)
        if beside:
            if not style_in_file(written, given):
                raise _unwritable(title)
            sink.require_all_in(written, wanted.has_index)
        else:
            style_in_memory(written, crs, given, self._values.context)
        final = _final_source(written, wanted) if beside else written
        self._layers.append(_Layer(written, final, given))
        self.results[key] = final

    def _beside(self, wanted: Destination) -> str:
        """Return where a layer is written until ``commit``, in QGIS's form; empty without a file."""
        if not wanted.path:
            return ""
        if wanted.is_table:
            return wanted.in_file(self._database_beside(wanted.path))
        return self._batch.file(wanted.path)

    def _database_beside(self, path: str) -> str:
        """Return the copy of a database that gets the layers of this run."""
        if path not in self._copies:
            self._copies[path] = self._batch.file(path, tables=None)
            before = _digest(path)
            if before:
                copy_geopackage(path, self._copies[path])
            self.require(lambda: _require_unchanged(path, before))
        return self._copies[path]


def _digest(path: str) -> bytes:
    """Return the digest of a database; empty without one. Raises ParameterError if others are writing to it."""
    if not os.path.exists(path):
        return b""
    require_closed(path)
    return content_digest(path)


def _require_unchanged(path: str, before: bytes) -> None:
    """Raises ParameterError if others have made, written to or removed a database since it was copied."""
    if _digest(path) != before:
        raise ParameterError(
            "{path} was changed by another program during the run. Run the algorithm again.", path=path
        )


def _final_source(written: str, wanted: Destination) -> str:
    """Return the final source of a layer in QGIS's form: “path” or “path|layername=…”."""
    _, _, rest = written.partition("|")
    return f"{wanted.path}|{rest}" if rest else wanted.path


@dataclass(frozen=True)
class _Layer:
    """A layer that was written.

    Attributes:
        written: Where it was written, in QGIS's form.
    """

    written: str
    final: str
    look: Look

    def announce(self, context: QgsProcessingContext) -> None:
        """Let QGIS load it from its final source."""
        if self.written != self.final and context.willLoadLayerOnCompletion(self.written):
            waiting = context.layersToLoadOnCompletion()
            waiting[self.final] = waiting.pop(self.written)
            context.setLayersToLoadOnCompletion(waiting)
        style_when_loaded(self.final, self.look, context)


class FeatureSink:
    """A feature sink that raises if it cannot be written."""

    def __init__(self, name: str, fields: QgsFields) -> None:
        self._name, self._fields = name, fields
        self._sink: QgsFeatureSink | None = None
        self._count = 0

    def open(self, sink: QgsFeatureSink | None, destination: str) -> str:
        """Take the only reference to QGIS's sink, so that ``close`` closes its file; return the destination."""
        self._sink = sink
        return destination

    @property
    def is_wanted(self) -> bool:
        """Whether the output is selected."""
        return self._sink is not None

    def add(self, geometry: QgsGeometry | None, values: dict[str, Any]) -> None:
        """Add a feature; fields without a value (or None) are NULL."""
        feature = QgsFeature(self._fields)
        if geometry is not None:
            feature.setGeometry(geometry)
        for name, value in values.items():
            if value is not None:
                feature[name] = value
        self._add(feature)

    def add_row(self, geometry: QgsGeometry, attributes: Sequence[Any]) -> None:
        """Add a feature with the value of each field."""
        feature = QgsFeature(self._fields)
        feature.setGeometry(geometry)
        feature.setAttributes(list(attributes))
        self._add(feature)

    def _add(self, feature: QgsFeature) -> None:
        if self._sink is not None and not self._sink.addFeature(feature, QgsFeatureSink.FastInsert):
            raise _unwritable(self._name)
        self._count += 1

    def require_all_in(self, written: str, with_index: bool) -> None:
        """Open the file and count its features. Raises UnwritableError if some are missing."""
        path, _, rest = written.partition("|")
        name = rest.partition("layername=")[2].partition("|")[0]
        if (with_index and lacks_spatial_index(path)) or feature_count(path, name) != self._count:
            raise _unwritable(self._name)

    def close(self) -> None:
        """Release the file."""
        self._sink = None


def _unwritable(name: str) -> UnwritableError:
    return UnwritableError(
        "{name} cannot be written. Choose another folder or a GeoPackage (.gpkg), or check whether the disk is full.",
        name=name,
    )


def _fields(schema: Sequence[tuple[str, str]]) -> QgsFields:
    fields = QgsFields()
    for name, kind in schema:
        fields.append(make_field(name, kind))
    return fields
