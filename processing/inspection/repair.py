"""Transfer of a repaired land-cover layer into the original layer, as one step that can be undone."""

from __future__ import annotations

from collections import defaultdict
from typing import NamedTuple

from qgis.core import QgsCoordinateTransform, QgsCoordinateTransformContext, QgsFeature, QgsGeometry, QgsVectorLayer

from ...core.annotation import findings as kinds
from ...core.errors import ParameterError
from ..compat import is_null

REPAIRABLE = (
    kinds.INVALID,
    kinds.NO_GEOMETRY,
    kinds.NO_AREA,
    kinds.THREE_DIMENSIONAL,
    kinds.OVERLAP,
    kinds.DUPLICATE,
    kinds.HIDDEN,
    kinds.GAP,
    kinds.SLIVER,
    kinds.SAME_CLASS_NEIGHBORS,
)
"""Kinds of findings that *Repair land-cover layer* repairs."""

_LEFT_AS_THEY_ARE = (kinds.NO_CLASS, kinds.UNKNOWN_CLASS, kinds.OUTSIDE_CRS)
"""*Repair land-cover layer* leaves such features out; in the user's layer they stay, to be corrected."""

_DECIMALS, _DECIMALS_OF_DEGREES = 3, 8
"""Decimals of equal geometries: reprojection there and back moves them by less."""


class Repaired(NamedTuple):
    """Numbers of features that a repair changed in a layer."""

    changed: int
    added: int
    removed: int


def apply_repair(
    layer: QgsVectorLayer,
    repaired: QgsVectorLayer,
    changes: QgsVectorLayer,
    context: QgsCoordinateTransformContext,
    title: str,
) -> Repaired:
    """Give a land-cover layer the geometries of its repaired copy; unchanged features keep theirs.

    Nothing is saved: the layer is in edit mode afterwards, with one step to undo.

    Args:
        repaired: OUTPUT of *Repair land-cover layer*, with the fields of ``layer``.
        changes: CHANGES of the same run.

    Raises:
        ParameterError: The layer cannot be edited.
    """
    if not layer.isEditable() and not layer.startEditing():
        raise ParameterError(
            "The layer {layer} cannot be edited. Save it as a GeoPackage and select that as the land-cover layer.",
            layer=layer.name(),
        )
    kept = {change["feature_id"] for change in changes.getFeatures() if change["kind"] in _LEFT_AS_THEY_ARE}
    layer.beginEditCommand(title)
    counts = _apply(layer, _pieces(layer, repaired, context), kept)
    layer.endEditCommand()
    layer.triggerRepaint()
    return counts


class _Piece(NamedTuple):
    """One repaired polygon: the attributes of its feature, and a geometry of the layer's kind and CRS."""

    attributes: list
    geometry: QgsGeometry


def _pieces(layer: QgsVectorLayer, repaired: QgsVectorLayer, context: QgsCoordinateTransformContext) -> list[_Piece]:
    transform, pieces = QgsCoordinateTransform(repaired.crs(), layer.crs(), context), []
    for feature in repaired.getFeatures():
        geometry = feature.geometry()
        geometry.transform(transform)
        attributes = feature.attributes()[: len(layer.fields())]
        pieces += [_Piece(attributes, part) for part in geometry.coerceToType(layer.wkbType())]
    return pieces


def _apply(layer: QgsVectorLayer, pieces: list[_Piece], kept: set[int]) -> Repaired:
    """Change, add and remove as few features as possible."""
    decimals = _DECIMALS_OF_DEGREES if layer.crs().isGeographic() else _DECIMALS
    by_shape, by_attributes = defaultdict(list), defaultdict(list)
    for number, piece in enumerate(pieces):
        by_shape[_key(piece.attributes), _shape(piece.geometry, decimals)].append(number)
    to_change = []
    for feature in layer.getFeatures():
        found = by_shape[_key(feature.attributes()), _shape(feature.geometry(), decimals)]
        if found:
            found.pop()
        elif feature.id() not in kept:
            to_change.append(feature)
    for (attributes, _), left in by_shape.items():
        by_attributes[attributes] += left
    removed = []
    for feature in to_change:
        left = by_attributes[_key(feature.attributes())]
        if left:
            layer.changeGeometry(feature.id(), pieces[left.pop(_largest_overlap(feature, pieces, left))].geometry)
        else:
            removed.append(feature.id())
    layer.deleteFeatures(removed)
    to_add = [pieces[number] for left in by_attributes.values() for number in left]
    for piece in to_add:
        feature = QgsFeature(layer.fields())
        feature.setAttributes(piece.attributes)
        for index in layer.primaryKeyAttributes():
            # The layer assigns the number.
            feature.setAttribute(index, None)
        feature.setGeometry(piece.geometry)
        layer.addFeature(feature)
    return Repaired(len(to_change) - len(removed), len(to_add), len(removed))


def _key(attributes: list) -> tuple[str, ...]:
    return tuple("" if is_null(value) else str(value) for value in attributes)


def _shape(geometry: QgsGeometry, decimals: int) -> str:
    """Return the same text for one shape, wherever its rings begin."""
    shape = QgsGeometry(geometry)
    shape.normalize()
    return shape.asWkt(decimals)


def _largest_overlap(feature: QgsFeature, pieces: list[_Piece], numbers: list[int]) -> int:
    box = feature.geometry().boundingBox()
    overlaps = [box.intersect(pieces[number].geometry.boundingBox()).area() for number in numbers]
    return overlaps.index(max(overlaps))
