"""Runs inside desktop QGIS (--code) with an older SemRef: today's walks, and other ways where these did not exist.

SEMREF_WALKS names the script of today's walks, which is imported.
"""

import os
import sys
import time
from pathlib import Path

import processing
import qgis.utils
from qgis.core import QgsProject
from qgis.PyQt.QtCore import Qt, QTimer
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QFileDialog, QLineEdit
from walked_layers import cover_with_database, openstreetmap_layer
from walking import dock, settle, start, wait_until

sys.path.append(str(Path(os.environ["SEMREF_WALKS"]).parent))
import walk_job_session as today
from walk_job_session import SAMPLE, counted, group_names, localized, opened_tab, press, ran, type_into


def reopened_by_file(folder: Path) -> dict:
    """Results came back with a project only where they had been saved to a file: the menu beside *Keep results*."""
    before = localized(dock().content.localize)
    counted["clicks"] += 1  # The arrow of the menu; its entry opens the dialog.
    with_save_dialog(dock().content.localize.results.save.trigger, str(folder / "results.gpkg"))
    counted["clicks"] += 3  # Save, New, Recent.
    iface = qgis.utils.iface
    iface.actionSaveProject().trigger()
    iface.newProject(False)
    settle(1.0)
    iface.addProject(str(SAMPLE / "semref_sample.qgz"))
    settle(2.0)
    return {"before": len(before), "after": dock().content.localize.results.table.model().rowCount()}


def with_save_dialog(ask, text: str) -> None:
    def answer() -> None:
        dialog = QApplication.activeModalWidget()
        if not isinstance(dialog, QFileDialog):
            QTimer.singleShot(200, answer)
            return
        line = dialog.findChild(QLineEdit, "fileNameEdit")
        line.setText(text)
        QTest.keyClick(line, Qt.Key.Key_Return)

    counted["values"] += 1
    counted["clicks"] += 1
    QTimer.singleShot(300, answer)
    ask()


def inspected_twice(folder: Path) -> dict:
    """The first press of the arrow only had the database read; the second one showed a window."""
    tab = opened_tab(1).inspect
    counted["clicks"] -= 1  # Today's walk opens the tab, too.
    press(tab.after)
    wait_until(lambda: tab._database is not None, "the database")
    return today.inspected(folder)


def area_by_field_calculator(folder: Path) -> dict:
    """Tags become classes and priorities by two formulas of QGIS's own; the database is put into dock and map."""
    qgis.utils.iface.newProject(False)
    layer = openstreetmap_layer()
    classes, both = str(folder / "classes.gpkg"), str(folder / "both.gpkg")
    named = "CASE WHEN \"building\" IS NOT NULL THEN 'building' WHEN \"natural\" = 'water' THEN 'water' END"
    above = "CASE WHEN \"class\" = 'building' THEN 2 ELSE 1 END"
    calculator = "native:fieldcalculator"
    text = {"FIELD_NAME": "class", "FIELD_TYPE": 2, "FIELD_LENGTH": 20, "FORMULA": named, "OUTPUT": classes}
    ran(calculator, {"INPUT": layer, **text})
    ran(calculator, {"INPUT": classes, "FIELD_NAME": "priority", "FIELD_TYPE": 1, "FORMULA": above, "OUTPUT": both})
    database = str(folder / "own.gpkg")
    of_classes = {"INPUT": both, "CLASS_FIELD": "class", "PRIORITY_FIELD": "priority", "PIXEL_SIZE": 1}
    outputs = {"build:Reference database": database, "rasterize:Label map": str(folder / "own.tif")}
    sizes = {"WINDOW_SIZE": 200, "STRIDE": 50, "MINIMUM_AREA": 30, "REFERENCE_CLASSES": "building;water"}
    ran("semref:annotationtodatabase", {**of_classes, **sizes, **outputs})
    opened_tab(0)
    type_into(dock().content.database.file.lineEdit(), database)
    press(dock().content.database.add_to_map)
    return {"in_the_dock": dock().content.database.path() == database, "groups": group_names()}


def corrected_by_model(folder: Path) -> dict:
    """From the check's layer on: gone through, mended, and the model that rasterizes and updates, as the guide told."""
    qgis.utils.iface.newProject(False)
    cover, same, labels, database = cover_with_database(folder, "EPSG:25832")
    dock().content.database.file.setFilePath(database)
    dock().content.tabs.setCurrentIndex(2)
    begun = time.monotonic()
    counted.update(clicks=0, values=0)
    issues = processing.run("semref:checkannotation", {**same, "MINIMUM_AREA": 5, "ISSUES": "memory:issues"})["ISSUES"]
    QgsProject.instance().addMapLayer(issues)
    settle(0.5)
    tab = dock().content.correct
    if tab.layer.currentLayer() is not issues:
        counted["values"] += 1
        tab.layer.setLayer(issues)
        settle()
    places = tab.places.rowCount()
    press(tab.after)
    cover.startEditing()
    cover.deleteFeature(cover.featureCount())  # The pond, which came last.
    for _ in range(places):
        press(tab.done)
    given = {**same, "LABELS": labels, "DATABASE": database}
    outputs = {"rasterize:Corrected label map": str(folder / "new.tif"), "update:Updated database": database}
    results = ran("semref:correctiontodatabase", {**given, **outputs})
    cover.commitChanges()
    return {"places": places, "results": sorted(results), "took": round(time.monotonic() - begun, 1)}


today.WALKS.update(
    {
        "inspect": inspected_twice,
        "sample, closed, reopened": reopened_by_file,
        "own area": area_by_field_calculator,
        "correct": corrected_by_model,
    }
)
start(today.session)
