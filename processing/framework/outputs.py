"""The one way out of an algorithm: rasters, files, folders and layers, each under its name only when it is complete."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Dict, Iterator, Optional, Sequence, Tuple, Union

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsFeatureRenderer,
    QgsFeatureSink,
    QgsFields,
    QgsGeometry,
)

from ...core.errors import ParameterError
from ...storage.files import folder_written_beside, written_beside
from ..compat import make_field

if TYPE_CHECKING:
    from ...core.labels.class_table import ClassTable
    from .values import Values

Schema = Union[Sequence[Tuple[str, str]], QgsFields]
"""(name, kind) of each field, kinds as in ``compat.make_field``; or the fields of another layer."""

_NEW_KEYS = QgsFeatureSink.RegeneratePrimaryKey
"""A key among another layer's fields, which several features may now share, is numbered anew."""


class Outputs:
    """What one run of an algorithm writes.

    Everything is written beside its place and moved there when the block that writes it ends well; layers are
    QGIS's to write. An error or a cancel leaves nothing, and an older file untouched.

    Attributes:
        results: Where each output lies, by key: what the algorithm returns.
    """

    def __init__(self, values: Values) -> None:
        self._values = values
        self.results: Dict[str, Any] = {}

    @contextmanager
    def raster(self, key: str, table: Optional[ClassTable] = None) -> Iterator[str]:
        """Gives a path to write a raster to; with ``table`` it gets the style of a label map."""
        from ..exchange.styles import write_label_map_style

        target = self._values.raster_target(key)
        with written_beside(target) as temporary:
            yield temporary
        if table is not None:
            write_label_map_style(target, table)
        self.results[key] = target

    @contextmanager
    def file(self, key: str) -> Iterator[str]:
        """Gives a path to write a file to."""
        target = self._values.target(key)
        with written_beside(target) as temporary:
            yield temporary
        self.results[key] = target

    def wants(self, key: str) -> bool:
        """Whether an optional output is wanted."""
        return self._values.has(key)

    def text(self, key: str, text: str) -> None:
        """Writes a text in UTF-8."""
        with self.file(key) as temporary, open(temporary, "w", encoding="utf-8") as file:
            file.write(text)

    @contextmanager
    def folder(self, key: str, mark: str = "") -> Iterator[str]:
        """Gives a new folder to fill, an empty path for one that is not wanted.

        ``mark``: the file by which an older one is known that may be replaced.
        """
        target = self._values.text(key)
        if not target:
            yield ""
            return
        with folder_written_beside(target, mark) as temporary:
            yield temporary
        self.results[key] = target

    @contextmanager
    def layer(
        self,
        key: str,
        schema: Schema,
        geometry: Any,
        crs: QgsCoordinateReferenceSystem,
        renderer: Optional[QgsFeatureRenderer] = None,
    ) -> Iterator[Sink]:
        """Gives a sink to fill; one that is not wanted takes features and forgets them.

        Args:
            key: The output.
            schema: Its fields.
            geometry: One of ``compat``'s kinds of geometry.
            crs: What the geometries are in.
            renderer: The style that it comes with.

        Raises:
            ParameterError: When the output can't be made or written.
        """
        from ..exchange.output_style import style_output

        fields = schema if isinstance(schema, QgsFields) else _fields(schema)
        sink = Sink(key, fields)
        destination = sink.open(*self._values.sink_target(key, fields, geometry, crs, _NEW_KEYS))
        if not sink.is_wanted and self._values.raw(key) is not None:
            raise sink.failure()
        yield sink
        sink.close()
        if destination:
            if renderer is not None:
                style_output(destination, renderer, self._values.context)
            self.results[key] = destination


class Sink:
    """A feature sink that says when it can't be written."""

    def __init__(self, name: str, fields: QgsFields) -> None:
        self._name, self._fields = name, fields
        self._sink: Optional[QgsFeatureSink] = None

    def open(self, sink: Optional[QgsFeatureSink], destination: str) -> str:
        """Takes the only reference to QGIS's sink, so that ``close`` closes its file; returns the destination."""
        self._sink = sink
        return destination

    @property
    def is_wanted(self) -> bool:
        """Whether somebody asked for it."""
        return self._sink is not None

    def add(self, geometry: Optional[QgsGeometry], values: Dict[str, Any]) -> None:
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

    def close(self) -> None:
        """Lets go of the file."""
        self._sink = None

    def failure(self) -> ParameterError:
        """That it can't be written."""
        return ParameterError(f"{self._name} can't be written; choose another place, or see whether the disk is full.")


def _fields(schema: Sequence[Tuple[str, str]]) -> QgsFields:
    fields = QgsFields()
    for name, kind in schema:
        fields.append(make_field(name, kind))
    return fields
