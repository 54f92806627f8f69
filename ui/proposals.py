"""First values of dialogs that the dock opens: orthophoto and land-cover layer of the project."""

from __future__ import annotations

import os

from qgis.core import QgsMapLayer, QgsProject, QgsVectorLayer

from ..core.errors import ClassTableError, ParameterError
from ..processing.algorithms.train_model import SOMETHING_ELSE
from ..processing.compat import POLYGON_GEOMETRY
from ..processing.inspection.models import base_model, new_model_file
from ..processing.layers.database_layers import database_file
from ..processing.layers.guess_fields import class_field_of, class_of_all, named_class_field, priority_field_of
from ..storage.text_tables import CLASSES_FILE, read_class_table
from .fields.resolution import proposed_resolution_cm
from .layer_files import layer_file, photo_layer

_MOST_READ = 100_000


def annotation_at_hand(project: QgsProject) -> dict[str, str]:
    """Return INPUT, CLASS_FIELD or CLASS, PRIORITY_FIELD and CLASS_TABLE where the project leaves no choice.

    INPUT is the only polygon layer, or the only one with a field such as ``class``. QGIS would take the selected layer.
    """
    layers = [layer for layer in project.mapLayers().values() if _may_be_annotation(layer)]
    named = [layer for layer in layers if named_class_field(layer)]
    layer = _only(named) or _only(layers)
    if layer is None:
        return {}
    found = {
        "INPUT": layer.id(),
        "CLASS_FIELD": class_field_of(layer),
        "CLASS": class_of_all(layer),
        "PRIORITY_FIELD": priority_field_of(layer),
        "CLASS_TABLE": _table_beside(layer),
    }
    return {key: value for key, value in found.items() if value}


def training_at_hand(project: QgsProject, model: str = "") -> dict[str, object]:
    """Return values for *Train model*: the land-cover layer, IMAGE, BASE_MODEL, UNLABELED, RESOLUTION and OUTPUT.

    Args:
        model: Model of the dock. It becomes the base if it fits; otherwise the only fitting one of the models folder.
    """
    found = annotation_at_hand(project)
    names = _class_names(project, found)
    more: dict[str, object] = {"OUTPUT": new_model_file("model")}
    if len(names) == 1:
        # A network needs two classes: all other ground becomes “other”.
        more["UNLABELED"] = SOMETHING_ELSE
    photo = photo_layer(project)
    if photo is None:
        return {**found, **more}
    here = {photo.name(), os.path.basename(layer_file(photo))}
    base = base_model(model, here, lambda: names)
    resolution = proposed_resolution_cm(project.mapLayer(found.get("INPUT", "")), found, photo)
    more["OUTPUT"] = new_model_file(os.path.splitext(os.path.basename(layer_file(photo)))[0])
    more.update({key: value for key, value in (("BASE_MODEL", base), ("RESOLUTION", resolution)) if value})
    return {"IMAGE": photo.id(), **found, **more}


def _class_names(project: QgsProject, found: dict[str, str]) -> set[str]:
    """Return the layer's class names in lower case: from CLASS, from the class table, or from the text field."""
    if "CLASS" in found:
        return {found["CLASS"]}
    if "CLASS_TABLE" in found:
        try:
            return {one.name.casefold() for one in read_class_table(found["CLASS_TABLE"]) if one.value}
        except (ClassTableError, ParameterError):
            return set()
    layer = project.mapLayer(found.get("INPUT", ""))
    field = found.get("CLASS_FIELD", "")
    # Reading a large layer would delay the dialog.
    if layer is None or layer.featureCount() > _MOST_READ:
        return set()
    texts = (one.name() for one in layer.fields() if not one.isNumeric() and one.typeName() != "Date")
    if field not in texts:
        return set()
    values = layer.uniqueValues(layer.fields().indexOf(field))
    return {str(value).casefold() for value in values if isinstance(value, str)}


def _may_be_annotation(layer: QgsMapLayer) -> bool:
    if not isinstance(layer, QgsVectorLayer) or layer.geometryType() != POLYGON_GEOMETRY:
        return False
    return not database_file(layer)


def _table_beside(layer: QgsVectorLayer) -> str:
    file = layer_file(layer)
    table = os.path.join(os.path.dirname(file), CLASSES_FILE)
    return table if file and os.path.isfile(table) else ""


def _only(candidates: list):
    return candidates[0] if len(candidates) == 1 else None
