"""The one way out of an algorithm: rasters, files, folders and layers, each under its name only when it is complete."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Callable, Union

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsFeatureSink,
    QgsFields,
    QgsGeometry,
    QgsProcessingContext,
)

from ...core.errors import ParameterError
from ...storage.atomic_output import Batch
from ...storage.replaceable import require_closed
from ...storage.vector_files import content_digest, copy_database, feature_count, lacks_spatial_index
from ..compat import make_field
from ..layers.database_layers import OPENED, open_when_done
from ..layers.layer_metadata import Note, save_in_database
from ..layers.output_style import Look, raster_style_when_loaded, style_in_file, style_in_memory, style_when_loaded
from . import parameters

if TYPE_CHECKING:
    from ...core.labels.class_table import ClassTable
    from .destinations import Destination
    from .values import Values

Schema = Union[Sequence[tuple[str, str]], QgsFields]
"""(name, kind) of each field, kinds as in ``compat.make_field``; or the fields of another layer."""

_NEW_KEYS = QgsFeatureSink.RegeneratePrimaryKey
"""A key among another layer's fields, which several features may now share, is numbered anew."""


class Outputs:
    """What one run of an algorithm writes.

    Everything is written beside its target, closed, opened again and counted; ``commit`` renames all of it when the
    algorithm is done. An error or a cancel leaves nothing, and older files untouched.

    Attributes:
        results: Where each output will lie, by key: what the algorithm returns.
    """

    def __init__(self, values: Values, note: Note) -> None:
        """Nothing is written yet; ``note``: history and sources of what the run will write."""
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

    def __exit__(self, *_: object) -> None:
        self._batch.close()

    def commit(self) -> None:
        """Renames everything to its target and lets QGIS load it from there."""
        self._batch.commit(*self._checks)
        for layer in self._layers:
            layer.announce(self._values.context)
        for path in self._rasters:
            OPENED.raster.emit(path)
        for key in self._opened:
            open_when_done(self.results[key], self._values.raw(parameters.LABELS), key, self._values.context)

    def require(self, check: Callable[[], None]) -> None:
        """Has ``check`` called before anything is renamed; it may raise."""
        self._checks.append(check)

    @contextmanager
    def raster(self, key: str, write_style: Callable[[str], str] | None = None) -> Iterator[str]:
        """Gives a path to write a raster to; ``write_style`` writes what it looks like beside it and returns it."""
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
        """Gives a path to write a label map to, which gets its style."""
        from ..layers.class_styles import write_label_map_style

        return self.raster(key, lambda path: write_label_map_style(path, table, self._note(key)))

    def _note(self, key: str) -> Note:
        """What an output tells about itself."""
        title, abstract = self._values.title_and_help(key)
        return replace(self._note_of_run, title=title, abstract=abstract)

    @contextmanager
    def file(self, key: str) -> Iterator[str]:
        """Gives a path to write a file to."""
        target = self._values.target(key)
        temporary = self._batch.file(target, *self._values.replaces(key))
        yield temporary
        if not os.path.isfile(temporary):
            raise ParameterError(
                "{name} can't be written; choose another place, or see whether the disk is full.", name=target
            )
        self.results[key] = target

    @contextmanager
    def database(self, key: str) -> Iterator[str]:
        """Gives a path to write a reference database to, which gets its note; QGIS opens it where the user wants that.

        Raises:
            ParameterError: The disk can't take the note.
        """
        with self.file(key) as temporary:
            yield temporary
            if not save_in_database(temporary, self._note(key)):
                raise ParameterError(
                    "{name} can't be written; choose another place, or see whether the disk is full.", name=key
                )
        if self._values.switch(parameters.OPEN_OUTPUT):
            self._opened.append(key)

    def wants(self, key: str) -> bool:
        """Whether an optional output is wanted."""
        return self._values.has(key)

    def text(self, key: str, text: str) -> None:
        """Writes a text in UTF-8."""
        with self.file(key) as temporary, open(temporary, "w", encoding="utf-8") as file:
            file.write(text)

    @contextmanager
    def folder(self, key: str) -> Iterator[str]:
        """Gives a new folder to fill, an empty path for one that is not wanted."""
        target = self._values.text(key)
        if not target:
            yield ""
            return
        yield self._batch.folder(target)
        self.results[key] = target

    @contextmanager
    def layer(
        self,
        key: str,
        schema: Schema,
        geometry: Any,
        crs: QgsCoordinateReferenceSystem,
        style: str = "",
        **look: Any,
    ) -> Iterator[FeatureSink]:
        """Gives a sink to fill; one that is not wanted takes features and forgets them.

        Args:
            geometry: One of ``compat``'s kinds of geometry.
            crs: What the geometries are in.
            style: Its file in ``resources/styles``; columns get their titles without one as well.
            **look: Further attributes of ``Look``.

        Raises:
            ParameterError: When the output can't be made, or does not hold all that was given to it.
        """
        fields = schema if isinstance(schema, QgsFields) else _fields(schema)
        wanted = self._values.destination(key)
        beside = self._beside(wanted)
        sink = FeatureSink(key, fields)
        # The only reference to QGIS's sink is the one in ``sink``: when that goes, the file is closed.
        written = sink.open(*self._values.sink(key, beside, fields, geometry, crs, _NEW_KEYS))
        if not sink.is_wanted and self._values.raw(key) is not None:
            raise sink.failure()
        yield sink
        sink.close()
        if not written:
            return
        given = Look(style, note=self._note(key), **look)
        if beside:
            if not style_in_file(written, given):
                raise sink.failure()
            sink.require_all_in(written, wanted.has_index)
        else:
            style_in_memory(written, given, self._values.context)
        final = _final_source(written, wanted) if beside else written
        self._layers.append(_Layer(written, final, given))
        self.results[key] = final

    def _beside(self, wanted: Destination) -> str:
        """Where a layer is written until ``commit``, as QGIS states it; empty where it goes into no file."""
        if not wanted.path:
            return ""
        if wanted.is_table:
            return wanted.in_file(self._database_beside(wanted.path))
        return self._batch.file(wanted.path)

    def _database_beside(self, path: str) -> str:
        """A copy of a database to add layers to, one for all of a run."""
        if path not in self._copies:
            self._copies[path] = self._batch.file(path, tables=None)
            if os.path.exists(path):
                require_closed(path)
                before = content_digest(path)
                copy_database(path, self._copies[path])
                self.require(lambda: _require_unchanged(path, before))
        return self._copies[path]


def _require_unchanged(path: str, before: bytes) -> None:
    """Raises ParameterError where others have written to a database since its copy was made."""
    require_closed(path)
    if content_digest(path) != before:
        raise ParameterError("{path} was changed by another program meanwhile; try again.", path=path)


def _final_source(written: str, wanted: Destination) -> str:
    """Where a layer will lie, as QGIS knows it: “path” or “path|layername=…”."""
    _, _, rest = written.partition("|")
    return f"{wanted.path}|{rest}" if rest else wanted.path


@dataclass(frozen=True)
class _Layer:
    """A layer that was written.

    Attributes:
        written: Where it was written, as QGIS knows it.
        final: Where it lies after the move.
        look: Its style.
    """

    written: str
    final: str
    look: Look

    def announce(self, context: QgsProcessingContext) -> None:
        """Lets QGIS load it from its final place."""
        if self.written != self.final and context.willLoadLayerOnCompletion(self.written):
            waiting = context.layersToLoadOnCompletion()
            waiting[self.final] = waiting.pop(self.written)
            context.setLayersToLoadOnCompletion(waiting)
        style_when_loaded(self.final, self.look, context)


class FeatureSink:
    """A feature sink that says when it can't be written."""

    def __init__(self, name: str, fields: QgsFields) -> None:
        self._name, self._fields = name, fields
        self._sink: QgsFeatureSink | None = None
        self._count = 0

    def open(self, sink: QgsFeatureSink | None, destination: str) -> str:
        """Takes the only reference to QGIS's sink, so that ``close`` closes its file; returns the destination."""
        self._sink = sink
        return destination

    @property
    def is_wanted(self) -> bool:
        """Whether somebody asked for it."""
        return self._sink is not None

    def add(self, geometry: QgsGeometry | None, values: dict[str, Any]) -> None:
        """Adds a feature; fields without a value (or None) are NULL."""
        feature = QgsFeature(self._fields)
        if geometry is not None:
            feature.setGeometry(geometry)
        for name, value in values.items():
            if value is not None:
                feature[name] = value
        self._add(feature)

    def add_row(self, geometry: QgsGeometry, attributes: Sequence[Any]) -> None:
        """Adds a feature with the value of each field."""
        feature = QgsFeature(self._fields)
        feature.setGeometry(geometry)
        feature.setAttributes(list(attributes))
        self._add(feature)

    def _add(self, feature: QgsFeature) -> None:
        if self._sink is not None and not self._sink.addFeature(feature, QgsFeatureSink.FastInsert):
            raise self.failure()
        self._count += 1

    def require_all_in(self, written: str, with_index: bool) -> None:
        """Opens what was written and counts it. Raises ParameterError where something is missing."""
        path, _, rest = written.partition("|")
        if with_index and lacks_spatial_index(path):
            raise self.failure()
        if feature_count(path, rest.partition("layername=")[2].partition("|")[0]) != self._count:
            raise self.failure()

    def close(self) -> None:
        """Lets go of the file."""
        self._sink = None

    def failure(self) -> ParameterError:
        """That it can't be written."""
        return ParameterError(
            "{name} can't be written; choose another place, or see whether the disk is full.", name=self._name
        )


def _fields(schema: Sequence[tuple[str, str]]) -> QgsFields:
    fields = QgsFields()
    for name, kind in schema:
        fields.append(make_field(name, kind))
    return fields
