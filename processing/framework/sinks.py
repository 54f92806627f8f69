"""Vector outputs of algorithms."""

from __future__ import annotations

from typing import Any, Dict, Optional, Sequence, Tuple, Union

from qgis.core import QgsFeature, QgsFeatureSink, QgsFields, QgsGeometry

from ...core.errors import ParameterError
from ..compat import make_field

Schema = Union[Sequence[Tuple[str, str]], QgsFields]
"""(name, kind) of each field, kinds as in ``compat.make_field``; or the fields of another layer."""

_NEW_KEYS = QgsFeatureSink.RegeneratePrimaryKey
"""A key among another layer's fields, which several features may now share, is numbered anew."""


class Sink:
    """A feature sink that says when it can't be written. ``destination`` is what the algorithm returns."""

    def __init__(self, algorithm, parameters, name: str, context, schema: Schema, geometry, crs) -> None:
        """Raises ParameterError when the output can't be made; ``is_wanted`` is False for one that was left out."""
        self._name = name
        self._fields = schema if isinstance(schema, QgsFields) else _fields(schema)
        made = algorithm.parameterAsSink(parameters, name, context, self._fields, geometry, crs, _NEW_KEYS)
        self._sink, self.destination = made
        if self._sink is None and parameters.get(name) is not None:
            raise self._failure()

    @property
    def is_wanted(self) -> bool:
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
        if not self._sink.addFeature(feature, QgsFeatureSink.FastInsert):
            raise self._failure()

    def close(self) -> str:
        """Lets go of the file; returns the destination."""
        self._sink = None
        return self.destination

    def _failure(self) -> ParameterError:
        return ParameterError(f"{self._name} can't be written; choose another place, or see whether the disk is full.")


def _fields(schema: Sequence[Tuple[str, str]]) -> QgsFields:
    fields = QgsFields()
    for name, kind in schema:
        fields.append(make_field(name, kind))
    return fields
