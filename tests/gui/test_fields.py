import ast
import json
import shlex

import pytest
from dock_area import label_map, write_raster
from qgis.core import (
    Qgis,
    QgsApplication,
    QgsCategorizedSymbolRenderer,
    QgsProcessingContext,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingFeedback,
    QgsProject,
    QgsVectorFileWriter,
    QgsVectorLayer,
)
from qgis.PyQt.QtWidgets import QApplication, QDialog, QMenu, QToolButton, QVBoxLayout

from semref.processing.layers.database_layers import OPENED


@pytest.fixture
def wrapper_in(plugin):
    """`wrapper_in(kind, algorithm, key)` makes a parameter's widget as the dialog of that class does."""
    from processing.gui.wrappers import WidgetWrapperFactory

    kept = []

    def make(kind: str, algorithm: str, key: str):
        dialog = type(kind, (QDialog,), {})()
        made = QgsApplication.processingRegistry().createAlgorithmById(algorithm)
        wrapper = WidgetWrapperFactory.create_wrapper(made.parameterDefinition(key), dialog)
        QVBoxLayout(dialog).addWidget(wrapper.createWrappedWidget(QgsProcessingContext()))
        dialog.show()
        kept.append((dialog, made, wrapper))
        return wrapper

    yield make
    for dialog, _, _ in kept:
        dialog.close()
    kept.clear()


def test_a_dialog_begins_with_the_docks_database_and_opens_what_it_builds_and_a_batch_does_not(wrapper_in, dock, area):
    dock.content.database.file.setFilePath(area.database)
    for dialog, database, ticked in (("AlgorithmDialog", area.database, True), ("BatchAlgorithmDialog", "", False)):
        assert (wrapper_in(dialog, "semref:assessdatabase", "DATABASE").parameterValue() or "") == database
        assert wrapper_in(dialog, "semref:builddatabase", "OPEN_OUTPUT").parameterValue() is ticked


def test_a_database_that_was_opened_is_the_docks_choice_also_in_a_dock_that_was_never_shown(plugin, iface, area):
    OPENED.database.emit(area.database)
    iface.tool_bar_actions[0].trigger()
    dock = iface.docks[0]
    assert dock.content.database.path() == area.database
    emitted = []
    dock.content.database.changed.connect(lambda: emitted.append(True))
    OPENED.database.emit(area.database)
    assert emitted == [True]


def test_a_class_table_can_be_edited_where_it_is_asked_for(wrapper_in, plugin):
    for dialog in ("AlgorithmDialog", "BatchAlgorithmDialog"):
        wrapper = wrapper_in(dialog, "semref:rasterizeannotation", "CLASS_TABLE")
        (button,) = wrapper.wrappedWidget().findChildren(QToolButton, "SemRefEditClassTable")
        assert button.accessibleName() == "Edit class table"


WITH_A_CLASS = ["rasterizeannotation", "checkannotation", "repairannotation", "classtable", "trainmodel"]


@pytest.fixture
def polygons(qgis_app, tmp_path):
    """`polygons(fields)` gives a layer of the project with these fields, written “name:type”."""

    def make(*fields: str):
        columns = "&".join(f"field={field}" for field in fields)
        layer = QgsVectorLayer(f"Polygon?crs=epsg:2056&{columns}", "-".join(fields).replace(":", " "), "memory")
        QgsProject.instance().addMapLayer(layer)
        return layer

    yield make
    QgsProject.instance().clear()


@pytest.fixture
def dialog_of(open_dialog):
    """`dialog_of(id, parameters)` opens QGIS's own dialog of an algorithm; gives the wrappers of its parameters."""
    return lambda name, **given: open_dialog(name, given).mainWidget().wrappers


def set_value(wrapper, value) -> None:
    context = QgsProcessingContext()
    context.setProject(QgsProject.instance())
    wrapper.setParameterValue(value, context)


@pytest.mark.slow
@pytest.mark.parametrize("algorithm", WITH_A_CLASS)
def test_a_dialog_begins_with_the_class_field_and_not_with_the_first_one(dialog_of, polygons, algorithm):
    layer = polygons("id:integer", "name:string", "Class:string", "zorder:integer")
    wrappers = dialog_of(algorithm)
    key = wrappers["CLASS_FIELD"].parameterDefinition().parentLayerParameterName()
    set_value(wrappers[key], layer.id())
    assert wrappers["CLASS_FIELD"].parameterValue() == "Class"
    assert "PRIORITY_FIELD" not in wrappers or wrappers["PRIORITY_FIELD"].parameterValue() == "zorder"


def test_the_class_field_follows_the_layer_and_its_style_and_a_layer_without_one_shows_none(dialog_of, polygons):
    first, second, third = (polygons("id:integer", name) for name in ("class:string", "cover:string", "n:integer"))
    second.setRenderer(QgsCategorizedSymbolRenderer("cover", []))
    wrappers = dialog_of("rasterizeannotation")
    for layer, field in ((first, "class"), (second, "cover"), (third, None), (first, "class")):
        set_value(wrappers["INPUT"], layer.id())
        assert wrappers["CLASS_FIELD"].parameterValue() == field


@pytest.mark.slow
@pytest.mark.parametrize("algorithm", [*WITH_A_CLASS, "annotationtodatabase", "correctiontodatabase"])
def test_a_layer_of_buildings_needs_no_class_field_in_any_dialog(dialog_of, polygons, algorithm):
    buildings, cover = polygons("osm_id:integer", "building:string"), polygons("osm_id:integer", "class:string")
    wrappers = dialog_of(algorithm, INPUT=cover.id())
    field, of_all = wrappers["CLASS_FIELD"], wrappers["CLASS"]
    assert (field.parameterValue(), of_all.parameterValue()) == ("class", None)
    set_value(wrappers["INPUT"], buildings.id())
    assert (field.parameterValue(), of_all.parameterValue()) == (None, "building")
    assert not field.wrappedWidget().isEnabled()
    set_value(of_all, "")
    assert field.wrappedWidget().isEnabled()


def test_a_class_field_that_is_given_or_chosen_stays(dialog_of, polygons):
    layer = polygons("id:integer", "class:string", "kind:string")
    wrappers = dialog_of("rasterizeannotation", INPUT=layer.id(), CLASS_FIELD="kind")
    assert wrappers["CLASS_FIELD"].parameterValue() == "kind"
    # The same layer with its selected features only.
    set_value(wrappers["INPUT"], QgsProcessingFeatureSourceDefinition(layer.id(), True))
    assert wrappers["CLASS_FIELD"].parameterValue() == "kind"


def test_the_class_field_of_a_file_that_is_no_layer_yet(dialog_of, polygons, tmp_path):
    path = str(tmp_path / "annotation.gpkg")
    options = QgsVectorFileWriter.SaveVectorOptions()
    context = QgsProject.instance().transformContext()
    QgsVectorFileWriter.writeAsVectorFormatV3(polygons("id:integer", "class:string"), path, context, options)
    wrappers = dialog_of("rasterizeannotation", INPUT=path)
    assert wrappers["CLASS_FIELD"].parameterValue() == "class"
    emitted = []
    wrappers["CLASS_FIELD"].widgetValueHasChanged.connect(lambda *_: emitted.append(True))
    set_value(wrappers["CLASS_FIELD"], "id")
    set_value(wrappers["INPUT"], path)
    assert wrappers["CLASS_FIELD"].parameterValue() == "id" and emitted == [True]


WAYS = {"python": "Copy as Python Command", "json": "Copy as JSON", "terminal": "Copy as qgis_process Command"}
"""Entries of the menu *Advanced*, of dialogs from QGIS 3.26 on; 3.22 keeps the Python command in its history."""


def copied(dialog) -> dict:
    """The dialog's values as each of QGIS's copies has them; those that this QGIS has."""
    from processing.tools import dataobjects

    texts = {}
    for menu in dialog.findChildren(QMenu):
        menu.aboutToShow.emit()
        for action in menu.actions():
            for way, title in WAYS.items():
                if action.text().replace("&", "") == title:
                    action.trigger()
                    texts[way] = QApplication.clipboard().text()
    assert set(texts) == (set(WAYS) if Qgis.QGIS_VERSION_INT >= 32600 else set()), list(texts)
    if not texts:
        context = dataobjects.createContext(QgsProcessingFeedback())
        texts["python"] = dialog.algorithm().asPythonCommand(dialog.createProcessingParameters(), context)
    command = texts["python"]
    found = {"python": ast.literal_eval(command[command.index("{") : command.rindex("}") + 1])}
    if "json" in texts:
        found["json"] = json.loads(texts["json"])["inputs"]
        found["terminal"] = dict(word.lstrip("-").partition("=")[::2] for word in shlex.split(texts["terminal"])[3:])
    return found


def as_a_word(value) -> str:
    """Return a value as an argument of `qgis_process`."""
    value = value[0] if isinstance(value, list) else value
    return str(value).lower() if isinstance(value, bool) else f"{value:g}" if isinstance(value, float) else str(value)


@pytest.fixture
def given(area, tmp_path):
    """`given[id]`: values of a dialog with SemRef's own widgets, all of them files that exist."""
    model, table = tmp_path / "own.onnx", tmp_path / "classes.csv"
    model.write_bytes(b"a model")
    table.write_text("value,name,color,role\n1,building,#ff0000,reference\n")
    labels = write_raster(tmp_path / "labels.tif", label_map(), True)
    outputs = {name: str(tmp_path / name) for name in ("positions.gpkg", "built.gpkg", "decoded.tif")}
    images = {"DATABASE": area.database, "IMAGES": [labels], "MODEL": str(model)}
    built = {"LABELS": labels, "WINDOW_SIZE": 200.0, "OPEN_OUTPUT": False}
    decoded = {"INPUT": labels, "CLASS_TABLE": str(table), "METHOD": 1}
    return {
        "localizeimages": {**images, "OUTPUT": outputs["positions.gpkg"]},
        "builddatabase": {**built, "DATABASE": outputs["built.gpkg"]},
        "decodecolorlabels": {**decoded, "OUTPUT": outputs["decoded.tif"]},
    }


@pytest.mark.parametrize("name", ["localizeimages", "builddatabase", "decodecolorlabels"])
def test_what_was_given_to_a_dialog_is_what_is_copied_from_it(open_dialog, given, name):
    found = copied(open_dialog(name, given[name]))
    for way in ("python", "json"):
        if way in found:
            assert {key: found[way].get(key) for key in given[name]} == given[name], way
    if "terminal" in found:
        expected = {key: as_a_word(value) for key, value in given[name].items()}
        assert {key: found["terminal"].get(key) for key in expected} == expected


@pytest.mark.parametrize("name", ["localizeimages", "builddatabase", "decodecolorlabels"])
def test_a_dialog_that_is_opened_again_from_the_history_has_the_same_values(open_dialog, given, name):
    first = copied(open_dialog(name, given[name]))
    assert copied(open_dialog(name, first["python"])) == first


def test_an_empty_optional_file_is_copied_as_nothing(open_dialog, given):
    left_out = {key: value for key, value in given["localizeimages"].items() if key != "MODEL"}
    found = copied(open_dialog("localizeimages", left_out))
    assert found["python"].get("MODEL") in ("", None)
    if "json" in found:
        assert found["json"].get("MODEL") in ("", None)
