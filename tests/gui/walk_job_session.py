"""Runs inside desktop QGIS (--code): the whole job, way by way, and what came of each.

SEMREF_SAMPLE names an empty folder for the sample. The mouse presses what it presses, but for one way by the space bar.
"""

import json
import os
import tempfile
from pathlib import Path

import processing
import qgis.utils
from dock_area import CRS, label_map, write_raster
from processing.gui.BatchAlgorithmDialog import BatchAlgorithmDialog
from qgis.core import QgsApplication, QgsFeature, QgsGeometry, QgsProject, QgsVectorLayer
from qgis.PyQt.QtCore import QPoint, Qt, QTimer
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QFileDialog, QLineEdit, QMessageBox
from walking import dock, run_button, settle, start, wait_until

SAMPLE = Path(os.environ["SEMREF_SAMPLE"])
DATABASE = str(SAMPLE / "reference_database.gpkg")
PLUGIN = Path(qgis.utils.pluginDirectory("semref"))


def press(widget) -> None:
    QTest.mouseClick(widget, Qt.MouseButton.LeftButton)
    settle()


def press_space(widget) -> None:
    """As once Tab has brought the focus there."""
    widget.setFocus()
    QTest.keyClick(widget, Qt.Key.Key_Space)
    settle()


def type_into(line: QLineEdit, text: str) -> None:
    """As the keyboard does it, into what can be seen."""
    if not line.isVisible():
        raise RuntimeError(f"a hidden line cannot be given {text}")
    line.setFocus()
    line.selectAll()
    QTest.keyClicks(line, text)
    QTest.keyClick(line, Qt.Key.Key_Return)
    settle()


def opened_tab(number: int):
    bar = dock().content.tabs.tabBar()
    QTest.mouseClick(bar, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, bar.tabRect(number).center())
    settle()
    return dock().content


def ran(name: str, given: dict, by=press) -> dict:
    """A dialog of the toolbox: opened, filled, run, closed; its results."""
    dialog = processing.createAlgorithmDialog(name, given)
    ended = []
    dialog.algorithmFinished.connect(lambda succeeded, results: ended.append((succeeded, results)))
    dialog.show()
    settle(0.5)
    by(run_button(dialog))
    wait_until(lambda: ended, name)
    settle(0.5)
    dialog.close()
    succeeded, results = ended[0]
    if not succeeded:
        raise RuntimeError(f"{name} failed: {dialog.htmlLog() if hasattr(dialog, 'htmlLog') else results}")
    return results


def with_file_dialog(button, text: str) -> None:
    """Presses a button that asks for files, types their names into the dialog that comes, and presses Return."""

    def answer() -> None:
        dialog = QApplication.activeModalWidget()
        if not isinstance(dialog, QFileDialog):
            QTimer.singleShot(200, answer)
            return
        line = dialog.findChild(QLineEdit, "fileNameEdit")
        line.setText(text)
        QTest.keyClick(line, Qt.Key.Key_Return)
        QTimer.singleShot(500, agree)

    def agree() -> None:
        # Newer versions of QGIS ask before they open the table of a batch in the older format.
        question = QApplication.activeModalWidget()
        if isinstance(question, QMessageBox):
            QTest.keyClick(question.button(QMessageBox.StandardButton.Yes), Qt.Key.Key_Space)

    QTimer.singleShot(300, answer)
    press(button)


def choose(content, folder: str, count: int) -> list:
    """Names the database and the model in the dock and chooses the first images of a folder of the sample."""
    images = content.localize.images
    type_into(content.database.file.lineEdit(), DATABASE)
    type_into(images.model.lineEdit(), str(PLUGIN / "models" / "sample_area.onnx"))
    photos = sorted(str(path) for path in (SAMPLE / folder).glob("*.jpg"))[:count]
    with_file_dialog(images.add_files, " ".join(f'"{photo}"' for photo in photos))
    return photos


def localized(tab) -> list:
    press(tab.localize_button)
    wait_until(lambda: not tab.run.running, "the localization")
    settle(0.5)
    rows = tab.results.table.model()
    return [rows.index(row, 4).data() for row in range(rows.rowCount())]


def groups() -> list:
    root = QgsProject.instance().layerTreeRoot()
    nodes = [node for node in root.children() if hasattr(node, "addGroup")]
    return [[node.name(), [layer.name() for layer in node.children()]] for node in nodes]


def add_polygon(layer: QgsVectorLayer, corners: list, field: str, value: str) -> None:
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromWkt("POLYGON(({}))".format(", ".join(f"{x} {y}" for x, y in corners))))
    feature[field] = value
    layer.dataProvider().addFeature(feature)


def added(layer: QgsVectorLayer) -> QgsVectorLayer:
    layer.updateExtents()
    QgsProject.instance().addMapLayer(layer)
    return layer


# --- the ways ---


def sample(folder: Path) -> dict:
    """Made by its menu, its photos localized; the project is saved and closed, and opened again."""
    iface = qgis.utils.iface
    qgis.utils.plugins["semref"]._entry._sample_project().make(SAMPLE)
    wait_until(lambda: QgsProject.instance().fileName() and dock().content.localize.images.paths(), "the sample")
    settle(0.5)
    before = localized(dock().content.localize)
    iface.actionSaveProject().trigger()
    iface.newProject(False)
    settle(1.0)
    emptied = dock().content.localize.results.table.model().rowCount()
    iface.addProject(str(SAMPLE / "semref_sample.qgz"))
    settle(1.0)
    rows = dock().content.localize.results.table.model().rowCount()
    return {"before": len(before), "emptied": emptied, "after": rows}


def own_photos(folder: Path) -> dict:
    """An empty project: database and model are named, files chosen in QGIS's dialog, localized, laid on the map.

    Follow docs/tutorials/own_area_and_photos.md.
    """
    qgis.utils.iface.newProject(False)
    content = opened_tab(0)
    tab = content.localize
    choose(content, "photos", 3)
    listed = len(tab.images.paths())
    statuses = localized(tab)
    press(tab.results.drape)
    wait_until(lambda: QgsProject.instance().mapLayers(), "the image on the map")
    return {"listed": listed, "statuses": statuses, "layers": len(QgsProject.instance().mapLayers())}


def inspected(folder: Path) -> dict:
    """The first window, one by name, one picked on the map, and the image compared with it."""
    tab = opened_tab(1).inspect
    press(tab.after)
    wait_until(lambda: tab.name.text(), "the first window")
    names = [tab.name.text()]
    type_into(tab.name, tab.look_alikes.item(0, 0).text())
    names.append(tab.name.text())
    press(tab.pick)
    canvas = qgis.utils.iface.mapCanvas()
    aside = QPoint(canvas.width() // 2, canvas.height() // 4)
    QTest.mouseClick(canvas.viewport(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, aside)
    settle(1.0)
    names.append(tab.name.text())
    wait_until(tab.compare.isEnabled, "the image's vector")
    press(tab.compare)
    compared = not tab.numbers.isColumnHidden(3)
    press(tab.compare)
    return {"names": names, "compared": compared, "rows": tab.numbers.rowCount()}


def own_area(folder: Path) -> dict:
    """A layer as QuickOSM makes it: classified, and by the model into a database, which is then the dock's."""
    qgis.utils.iface.newProject(False)
    layer = QgsVectorLayer("Polygon?crs=EPSG:25832&field=building:string&field=natural:string", "osm", "memory")
    for number in range(200):
        x, y, size = 500_000 + 40 * (number % 20), 5_400_000 + 40 * (number // 20), 8 + number % 7
        corners = [(x, y), (x + size, y), (x + size, y + size), (x, y + size), (x, y)]
        add_polygon(layer, corners, *(("building", "yes") if number % 9 else ("natural", "water")))
    classes = str(folder / "classified.gpkg")
    ran("semref:classifyopenstreetmap", {"INPUT": added(layer), "OUTPUT": classes})
    database = str(folder / "own.gpkg")
    of_classes = {"INPUT": classes, "CLASS_FIELD": "class", "PRIORITY_FIELD": "priority", "PIXEL_SIZE": 1}
    outputs = {"build:Reference database": database, "rasterize:Label map": str(folder / "own.tif")}
    sizes = {"WINDOW_SIZE": 200, "STRIDE": 50, "MINIMUM_AREA": 30, "REFERENCE_CLASSES": "building;water"}
    ran("semref:annotationtodatabase", {**of_classes, **sizes, **outputs})
    return {"in_the_dock": dock().content.database.path() == database, "groups": groups()}


def planned(folder: Path) -> dict:
    """Where it works, what to expect along a line, and the file for the aircraft."""
    report, file = folder / "assessment.html", folder / "area.semref"
    quick = {"DATABASE": DATABASE, "MAP_CORRELATION": False}
    outputs = {"REPORT": str(report), "OUTPUT": str(folder / "assessed.gpkg")}
    ran("semref:assessdatabase", {**quick, "TRIALS": 60, "SPACING": 800, **outputs})
    route = QgsVectorLayer("LineString?crs=EPSG:25832", "route", "memory")
    feature, cover = QgsFeature(), QgsVectorLayer(str(SAMPLE / "landcover.shp"), "cover", "ogr").extent()
    ends = cover.xMinimum() + 700, cover.yMinimum() + 700, cover.xMaximum() - 700, cover.yMaximum() - 700
    feature.setGeometry(QgsGeometry.fromWkt("LINESTRING({} {}, {} {})".format(*ends)))
    route.dataProvider().addFeature(feature)
    gap = ran("semref:assessroute", {**quick, "ROUTE": added(route), "TRIALS": 2, "REPORT": str(folder / "route.html")})
    ran("semref:exportonboard", {"DATABASE": DATABASE, "OUTPUT": str(file)})
    return {"report": report.stat().st_size, "gap": gap["LONGEST_GAP"], "file": file.stat().st_size}


def flown(folder: Path) -> dict:
    """The images of the sample's flight, ticked as one flight, in the dock."""
    qgis.utils.iface.newProject(False)
    content = opened_tab(0)
    tab = content.localize
    photos = choose(content, "flight", 6)
    press(tab.images.flight)
    return {"is_flight": tab.images.is_flight(), "listed": len(photos), "statuses": localized(tab)}


def batch(folder: Path) -> dict:
    """Two databases of one label map: the table of a batch is opened from its file, and run."""
    builds = QgsApplication.processingRegistry().createAlgorithmById("semref:builddatabase")
    files = [str(folder / f"of_{size}.gpkg") for size in (640, 480)]
    same = {"LABELS": repr(str(SAMPLE / "label_map.tif")), "STRIDE": "160", "MINIMUM_AREA": "50"}
    rows = [
        {"PARAMETERS": {**same, "WINDOW_SIZE": size}, "OUTPUTS": {"DATABASE": file}}
        for size, file in zip(("640", "480"), files)
    ]
    table = folder / "batch.json"
    table.write_text(json.dumps(rows), encoding="utf-8")
    dialog = BatchAlgorithmDialog(builds, qgis.utils.iface.mainWindow())
    dialog.show()
    settle(0.5)
    panel = dialog.mainWidget()
    with_file_dialog(panel.btnOpen, str(table))
    listed = panel.tblParameters.rowCount() - 1
    press(run_button(dialog))
    wait_until(lambda: all(map(os.path.exists, files)) and run_button(dialog).isEnabled(), "the batch")
    dialog.close()
    return {"listed": listed, "made": [os.path.getsize(file) > 10_000 for file in files]}


def built_by_keys(folder: Path) -> dict:
    """A database by its dialog of the toolbox, which is then on the map, in the dock, and offered by other dialogs."""
    QgsProject.instance().clear()
    database = str(folder / "built.gpkg")
    sizes = {"WINDOW_SIZE": 200, "STRIDE": 50, "MINIMUM_AREA": 20, "REFERENCE_CLASSES": "1;2;3"}
    labels = write_raster(folder / "labels.tif", label_map(), True)
    ran("semref:builddatabase", {"LABELS": labels, **sizes, "DATABASE": database}, press_space)
    dock().setUserVisible(True)
    settle()
    assess = processing.createAlgorithmDialog("semref:assessdatabase")
    assess.show()
    settle()
    offered = assess.mainWidget().wrappers["DATABASE"].parameterValue()
    assess.close()
    in_the_dock = dock().content.database.path() == database
    return {"groups": groups(), "in_the_dock": in_the_dock, "in_a_dialog": offered == database}


def corrected(folder: Path) -> dict:
    """Check, correct and update a layer of 144 houses and a pond that overlaps one of them."""
    QgsProject.instance().clear()
    cover = QgsVectorLayer(f"Polygon?crs={CRS}&field=class:string", "cover", "memory")
    squares = [(x, y, "building") for x in range(0, 240, 20) for y in range(0, 240, 20)]
    for x, y, name in [*squares, (3, 3, "water")]:
        left, bottom, size = 400_000 + x, 5_400_000 + y, 5 + (x + 3 * y) / 20 % 7
        corners = [(left, bottom), (left + size, bottom), (left + size, bottom + size), (left, bottom)]
        add_polygon(cover, corners, "class", name)
    table = folder / "classes.csv"
    table.write_text("value,name,color,role\n1,building,#ff0000,reference\n2,water,#0000ff,reference\n")
    same = {"INPUT": added(cover), "CLASS_FIELD": "class", "CLASS_TABLE": str(table)}
    labels, database = str(folder / "cover.tif"), str(folder / "cover.gpkg")
    processing.run("semref:rasterizeannotation", {**same, "PIXEL_SIZE": 0.5, "OUTPUT": labels})
    sizes = {"WINDOW_SIZE": 100, "STRIDE": 50, "MINIMUM_AREA": 5, "DATABASE": database}
    processing.run("semref:builddatabase", {"LABELS": labels, **sizes})
    dock().choose_database(database)
    dock().content.tabs.setCurrentIndex(2)
    issues = processing.run("semref:checkannotation", {**same, "MINIMUM_AREA": 5, "ISSUES": "memory:issues"})["ISSUES"]
    QgsProject.instance().addMapLayer(issues)
    settle(0.5)
    tab = dock().content.correct
    seen = {"is_chosen": tab.layer.currentLayer() is issues, "places": tab.places.rowCount()}
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
    return {**seen, "has_undo": has_undo, "state": state, "left": tab.places.rowCount()}


WAYS = (sample, own_photos, inspected, own_area, planned, flown, batch, built_by_keys, corrected)


def session() -> dict:
    qgis.utils.iface.mainWindow().resize(1280, 900)
    folder, seen = Path(tempfile.mkdtemp(prefix="walks", dir=os.environ["HOME"])), {}
    for way in WAYS:
        (folder / way.__name__).mkdir()
        seen[way.__name__] = way(folder / way.__name__)
        print(way.__name__, seen[way.__name__], flush=True)
    return seen


start(session)
