"""Which field of a layer tells classes or priorities, as far as a look at the layer can tell."""

from __future__ import annotations

from qgis.core import QgsVectorLayer

_CLASS_FIELDS = ("class", "fclass", "landcover", "land_cover", "landuse", "klasse", "clase", "classe", "type", "code")
_PRIORITY_FIELDS = ("priority", "zorder", "z_order", "draw_order", "layer")
"""What people call them, the likeliest first."""


def class_field_of(layer: QgsVectorLayer) -> str:
    """By which the layer's style tells classes apart, else one that is called so; empty for none."""
    renderer = layer.renderer()
    is_by_class = renderer is not None and renderer.type() == "categorizedSymbol"
    styled = renderer.classAttribute().strip('"') if is_by_class else ""
    return styled if styled in layer.fields().names() else _field_of(layer, _CLASS_FIELDS)


def priority_field_of(layer: QgsVectorLayer) -> str:
    """A field of numbers that is called so; empty for none."""
    return _field_of(layer, _PRIORITY_FIELDS, True)


def _field_of(layer: QgsVectorLayer, names: tuple[str, ...], is_number: bool = False) -> str:
    by_name = {field.name().lower(): field for field in layer.fields() if not is_number or field.isNumeric()}
    return next((by_name[name].name() for name in names if name in by_name), "")
