"""Guess class field, priority field and OpenStreetMap tags of a layer, by one rule for all dialogs."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import islice

from qgis.core import QgsFeatureRequest, QgsVectorLayer

from ...core.labels.openstreetmap import TAG_COLUMNS
from ..compat import is_null

_CLASS_FIELDS = ("class", "fclass", "landcover", "land_cover", "landuse", "klasse", "clase", "classe")
_OFTEN_CLASS_FIELDS = ("type", "code")
_PRIORITY_FIELDS = ("priority", "zorder", "z_order", "draw_order", "layer")
"""Typical names, most likely first."""

BUILDING = "building"
"""Class of a layer of buildings, and OpenStreetMap's field in such layers, which has kinds of buildings."""

_BUILDINGS = re.compile(r"building|house|footprint|geb(ä|ae)ude|edific|b(â|a)timent|建筑", re.IGNORECASE)
_IS_NO_CLASS = re.compile(r"name|.*id|.*name|note|comment|description|source", re.IGNORECASE)
_ANSWERS = {"yes", "no", "true", "false"}

_OSM_KEYS = {BUILDING, "landuse", "natural", "waterway", "leisure", "amenity"}

_READ = 1000
"""Largest number of features that are read."""
_MOST_CLASSES = 64
_FEW_FEATURES = 20
"""Up to this number of features, each may have its own class."""
_NEARLY_AS_MANY = 0.8
"""The first field with this share of the largest number of classes is taken."""


def class_field_of(layer: QgsVectorLayer) -> str:
    """Return the field of the layer's style, or one with a typical name or typical values; otherwise empty.

    Keys and other fields that number the features never count.
    """
    renderer = layer.renderer()
    is_by_class = renderer is not None and renderer.type() == "categorizedSymbol"
    styled = renderer.classAttribute().strip('"') if is_by_class else ""
    if styled in layer.fields().names():
        return styled
    named = named_class_field(layer)
    if named or _is_of_buildings(layer):
        return named
    values = _values_of(layer)
    return next((name for name in _named(values, _OFTEN_CLASS_FIELDS) if _may_be_classes(values[name])), "") or (
        _by_values({name: found for name, found in values.items() if not _IS_NO_CLASS.fullmatch(name)})
    )


def named_class_field(layer: QgsVectorLayer) -> str:
    """Return a field with a typical name, such as “class”; otherwise empty."""
    return _field_of(layer, _CLASS_FIELDS)


def class_of_all(layer: QgsVectorLayer) -> str:
    """Return “building” for a layer of buildings without a class field; otherwise empty."""
    return BUILDING if _is_of_buildings(layer) and not class_field_of(layer) else ""


def priority_field_of(layer: QgsVectorLayer) -> str:
    """Return a numeric field with a typical name of priorities; otherwise empty."""
    return _field_of(layer, _PRIORITY_FIELDS, True)


def has_osm_tags(fields: Sequence[str]) -> bool:
    """Return whether the fields are tags of OpenStreetMap: Geofabrik's field, packed tags, or two common keys."""
    names = {name.casefold() for name in fields}
    if names & {"class", "landcover", "land_cover"}:
        # A layer that already has classes, as from “Classify OpenStreetMap”.
        return False
    return bool(names & {"fclass", *TAG_COLUMNS}) or len(names & _OSM_KEYS) > 1


def _is_of_buildings(layer: QgsVectorLayer) -> bool:
    return bool(_BUILDINGS.search(layer.name())) or bool(_field_of(layer, (BUILDING,)))


def _field_of(layer: QgsVectorLayer, names: tuple[str, ...], is_number: bool = False) -> str:
    fields = [field.name() for field in layer.fields() if not is_number or field.isNumeric()]
    return next(iter(_named(fields, names)), "")


def _named(fields: Sequence[str], names: tuple[str, ...]) -> list[str]:
    by_name = {field.lower(): field for field in fields}
    return [by_name[name] for name in names if name in by_name]


def _values_of(layer: QgsVectorLayer) -> dict[str, list]:
    """Return the first features' values by field, NULL as None. Keys are left out, and numbers of empty layers too."""
    request = QgsFeatureRequest()
    request.setFlags(QgsFeatureRequest.NoGeometry)
    rows = [feature.attributes() for feature in islice(layer.getFeatures(request), _READ)]
    keys = set(layer.primaryKeyAttributes())
    fields = [(n, field) for n, field in enumerate(layer.fields()) if n not in keys and (rows or not field.isNumeric())]
    return {field.name(): [None if is_null(row[n]) else row[n] for row in rows] for n, field in fields}


def _by_values(values: dict[str, list]) -> str:
    """Return the first text field, or field of small numbers, with about the largest number of classes."""
    for kind in (str, int):
        candidates = {name: len(set(found)) for name, found in values.items() if _may_be_classes(found, kind)}
        several = [name for name, count in candidates.items() if count > 1]
        most = max(candidates.values(), default=0)
        for name in several or (candidates if len(candidates) == 1 and kind is str else ()):
            if candidates[name] >= _NEARLY_AS_MANY * most:
                return name
    return ""


def _may_be_classes(column: list, kind: type = object) -> bool:
    """Return whether values may be classes: few different values, each of several features, and not yes and no."""
    found = [value for value in column if value is not None]
    if 2 * len(found) < len(column) or not all(isinstance(value, kind) for value in found):
        return False
    if kind is int and not all(0 <= value <= 255 for value in found):
        return False
    classes = {str(value).casefold() for value in found}
    most = _MOST_CLASSES if len(found) <= _FEW_FEATURES else min(_MOST_CLASSES, len(found) // 2)
    return len(classes) <= most and not (classes and classes <= _ANSWERS)
