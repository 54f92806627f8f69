"""Runs inside desktop QGIS (--code): goes the ways of a newcomer with mouse and keys, and writes what came of it."""

import os
import tempfile
import time
from pathlib import Path

import qgis.utils
from dock_area import CRS, label_map, write_raster
from qgis.core import QgsApplication, QgsProject
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest
from walked_layers import cover_with_database
from walking import dock, run_button, settle, start, wait_until

clicks = 0


def click(widget) -> None:
    """As a mouse does it; counted."""
    global clicks
    clicks += 1
    QTest.mouseClick(widget, Qt.MouseButton.LeftButton)
    settle()


def type_on(widget) -> None:
    """As the space bar does it once Tab has brought the focus there; counted."""
    global clicks
    clicks += 1
    widget.setFocus()
    QTest.keyClick(widget, Qt.Key.Key_Space)
    settle()


def groups() -> list:
    root = QgsProject.instance().layerTreeRoot()
    return [[node.name(), [layer.name() for layer in node.children()]] for node in root.children()]


def built_from_the_toolbox(folder: Path, press) -> dict:
    """The dialog of *Build reference database* is filled; then its button, and the dock's."""
    global clicks
    import processing

    QgsProject.instance().clear()
    database, clicks = str(folder / "built.gpkg"), 0
    sizes = {"WINDOW_SIZE": 200, "STRIDE": 50, "MINIMUM_AREA": 20, "REFERENCE_CLASSES": "1;2;3"}
    labels = write_raster(folder / "labels.tif", label_map(), True)
    dialog = processing.createAlgorithmDialog("semref:builddatabase", {"LABELS": labels, **sizes, "DATABASE": database})
    ended = []
    dialog.algorithmFinished.connect(lambda succeeded, results: ended.append(succeeded))
    dialog.show()
    settle(1.0)
    press(run_button(dialog))
    wait_until(lambda: ended, "the database")
    settle(1.0)
    dialog.close()
    dock().setUserVisible(True)
    settle()
    assess = processing.createAlgorithmDialog("semref:assessdatabase")
    assess.show()
    settle()
    offered = assess.mainWidget().wrappers["DATABASE"].parameterValue()
    assess.close()
    return {
        "clicks": clicks,
        "succeeded": ended,
        "groups": groups(),
        "in_the_dock": dock().content.database.path() == database,
        "in_a_dialog": offered == database,
    }


def batch_and_model(folder: Path) -> dict:
    """What the same parameters look like in a batch and in the model designer."""
    from processing.gui.BatchAlgorithmDialog import BatchAlgorithmDialog
    from processing.modeler.ModelerDialog import ModelerDialog
    from processing.modeler.ModelerParametersDialog import ModelerParametersDialog

    from semref.ui.fields.known_button import KnownButton

    registry = QgsApplication.processingRegistry()
    batch = BatchAlgorithmDialog(registry.createAlgorithmById("semref:assessdatabase"), qgis.utils.iface.mainWindow())
    batch.show()
    settle()
    in_batch = len(batch.findChildren(KnownButton))
    batch.close()
    designer = ModelerDialog()
    designer.loadModel(str(Path(qgis.utils.pluginDirectory("semref")) / "models" / "annotation_to_database.model3"))
    child = ModelerParametersDialog(registry.createAlgorithmById("semref:assessdatabase"), designer.model())
    child.show()
    settle()
    in_designer = len(child.findChildren(KnownButton))
    child.close()
    designer.close()
    return {"in_batch": in_batch, "in_designer": in_designer}


def corrected(folder: Path, press) -> dict:
    """Checked, gone through, mended and brought into the database, from the check's layer on."""
    global clicks
    import processing

    QgsProject.instance().clear()
    cover, same, labels, database = cover_with_database(folder, CRS)
    dock().choose_database(database)
    dock().content.tabs.setCurrentIndex(2)
    clicks, begun = 0, time.monotonic()
    issues = processing.run("semref:checkannotation", {**same, "MINIMUM_AREA": 5, "ISSUES": "memory:issues"})["ISSUES"]
    QgsProject.instance().addMapLayer(issues)
    settle(0.5)
    tab = dock().content.correct
    is_chosen = tab.layer.currentLayer() is issues
    places = tab.places.rowCount()
    press(tab.after)
    cover.startEditing()
    cover.deleteFeature(cover.featureCount())  # The pond, which came last.
    while tab.places.rowCount():
        press(tab.done)
    press(tab.updating.button)
    wait_until(lambda: not tab.run.running, "the update")
    settle(0.5)
    cover.commitChanges()
    has_undo, state = tab.updating.undo.isVisibleTo(tab), tab.updating.state.text_shown
    return {
        "clicks": clicks,
        "places": places,
        "is_chosen": is_chosen,
        "has_undo": has_undo,
        "state": state,
        "left": tab.places.rowCount(),
        "seconds": round(time.monotonic() - begun, 1),
    }


def session() -> dict:
    folder = Path(tempfile.mkdtemp(prefix="walks", dir=os.environ["HOME"]))
    places = {}
    for name in ("mouse", "keys", "corrected_mouse", "corrected_keys"):
        places[name] = folder / name
        places[name].mkdir()
    return {
        "build_mouse": built_from_the_toolbox(places["mouse"], click),
        "build_keys": built_from_the_toolbox(places["keys"], type_on),
        "forms": batch_and_model(folder),
        "correct_mouse": corrected(places["corrected_mouse"], click),
        "correct_keys": corrected(places["corrected_keys"], type_on),
    }


start(session)
