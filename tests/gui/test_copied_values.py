"""What a dialog's values become when they are copied, kept in QGIS's history, and given again."""

import ast
import json
import shlex

import pytest
from dock_area import label_map, write_raster
from qgis.core import Qgis, QgsProcessingFeedback
from qgis.PyQt.QtWidgets import QApplication, QMenu

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
    return {
        "localizeimages": {**images, "OUTPUT": outputs["positions.gpkg"]},
        "builddatabase": {**built, "DATABASE": outputs["built.gpkg"]},
        "decodecolorlabels": {
            "INPUT": labels,
            "CLASS_TABLE": str(table),
            "METHOD": 1,
            "OUTPUT": outputs["decoded.tif"],
        },
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
