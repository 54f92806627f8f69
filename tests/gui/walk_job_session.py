"""Runs inside desktop QGIS (--code): the whole job on the sample area, walk by walk.

SEMREF_SAMPLE names the folder of the sample, which is made there unless it is. SEMREF_WAY: ``mouse``, or ``keys`` for
the keyboard alone: whatever is pressed is reached by Tab or Shift+Tab. Writes for each walk its clicks, or the keys
that were pressed without those of texts, the values that were typed or chosen in dialogs, seconds, and what came of it.
"""

import json
import os
import tempfile
import time
from pathlib import Path

import processing
import qgis.utils
from qgis.core import QgsApplication, QgsFeature, QgsGeometry, QgsProject, QgsVectorLayer
from qgis.PyQt.QtCore import QPoint, Qt, QTimer
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QFileDialog, QLineEdit, QMessageBox
from walked_layers import openstreetmap_layer
from walking import dock, run_button, settle, start, wait_until

SAMPLE = Path(os.environ["SEMREF_SAMPLE"])
DATABASE = str(SAMPLE / "reference_database.gpkg")
WINDOW = {"WINDOW_SIZE": 640, "STRIDE": 160, "MINIMUM_AREA": 50}
BY_KEYS = os.environ["SEMREF_WAY"] == "keys"
MOST_STEPS = 150
counted = {"clicks": 0, "keys": 0, "values": 0}


def press(widget) -> None:
    """As a mouse does it, or the space bar once the focus is there; counted."""
    if BY_KEYS:
        reach(widget)
        key(Qt.Key.Key_Space)
    else:
        counted["clicks"] += 1
        QTest.mouseClick(widget, Qt.MouseButton.LeftButton)
    settle()


def key(pressed) -> None:
    """On what has the focus; counted."""
    counted["keys"] += 1
    QTest.keyClick(QApplication.focusWidget(), pressed)


def reach(widget) -> None:
    """Brings the focus there, the shorter way of Tab and Shift+Tab."""
    window = widget.window()
    # Without a window manager the X server tells when it likes which window is active.
    wait_until(lambda: has_focus_within(window), "the focus")
    chain = focus_chain(QApplication.focusWidget())
    ahead = next(n for n, one in enumerate(chain) if one is widget)
    step = Qt.Key.Key_Tab if ahead <= len(chain) - ahead else Qt.Key.Key_Backtab
    passed = []
    for _ in range(MOST_STEPS):
        passed.append(QApplication.focusWidget())
        if passed[-1] is widget:
            return
        key(step)
    told = [f"{type(one).__name__} {one.objectName()}" for one in (widget, *passed)]
    raise RuntimeError(f"{told[0]} (visible: {widget.isVisible()}) was not reached by {MOST_STEPS} keys: {told[1:]}")


def has_focus_within(window) -> bool:
    """Whether something in the window has the focus; asks for it."""
    if not window.isActiveWindow():
        window.activateWindow()
        settle()
    focused = QApplication.focusWidget()
    if focused is None or focused.window() is not window:
        begin = dock().content.help if window is qgis.utils.iface.mainWindow() else window
        (begin.nextInFocusChain() if begin is window else begin).setFocus(Qt.FocusReason.TabFocusReason)
        settle()
        focused = QApplication.focusWidget()
    return focused is not None and focused.window() is window


def focus_chain(first) -> list:
    """All widgets of the window in the order of Tab, from this one on."""
    chain, widget = [first], first.nextInFocusChain()
    while widget is not first:
        chain.append(widget)
        widget = widget.nextInFocusChain()
    return chain


def type_into(line: QLineEdit, text: str) -> None:
    """As the keyboard does it, into what can be seen; counted as one value."""
    if not line.isVisible():
        raise RuntimeError(f"a hidden line cannot be given {text}")
    counted["values"] += 1
    if BY_KEYS:
        reach(line)
    else:
        line.setFocus()
    line.selectAll()
    QTest.keyClicks(line, text)
    QTest.keyClick(line, Qt.Key.Key_Return)
    settle()


def opened_tab(number: int):
    bar = dock().content.tabs.tabBar()
    if BY_KEYS:
        reach(bar)
        while bar.currentIndex() != number:
            key(Qt.Key.Key_Right if bar.currentIndex() < number else Qt.Key.Key_Left)
    else:
        counted["clicks"] += 1
        QTest.mouseClick(bar, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, bar.tabRect(number).center())
    settle()
    return dock().content


def ran(name: str, given: dict) -> dict:
    """A dialog of the toolbox: opened, filled, run, closed – three clicks; its results."""
    dialog = processing.createAlgorithmDialog(name, given)
    ended = []
    dialog.algorithmFinished.connect(lambda succeeded, results: ended.append((succeeded, results)))
    dialog.show()
    settle(0.5)
    counted["keys" if BY_KEYS else "clicks"] += 2
    counted["values"] += len(given)
    press(run_button(dialog))
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
        counted["values"] += 1
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
    type_into(images.model.lineEdit(), str(Path(qgis.utils.pluginDirectory("semref")) / "models" / "sample_area.onnx"))
    photos = sorted(str(path) for path in (SAMPLE / folder).glob("*.jpg"))[:count]
    with_file_dialog(images.add_files, " ".join(f'"{photo}"' for photo in photos))
    return photos


def localized(tab) -> list:
    press(tab.localize_button)
    wait_until(lambda: not tab.run.running, "the localization")
    settle(0.5)
    rows = tab.results.table.model()
    return [rows.index(row, 4).data() for row in range(rows.rowCount())]


# --- the walks ---


def made(folder: Path) -> dict:
    """The sample, by its menu; its folder is chosen."""
    entry = qgis.utils.plugins["semref"]._entry
    counted.update({"keys" if BY_KEYS else "clicks": 2, "values": 1})
    entry._sample_project().make(SAMPLE)
    wait_until(lambda: QgsProject.instance().fileName() and dock().content.localize.images.paths(), "the sample")
    settle(0.5)
    return {"photos": len(dock().content.localize.images.paths())}


def reopened(folder: Path) -> dict:
    """The sample: its photos are localized, the project saved and closed, QGIS's recent project opened again."""
    iface = qgis.utils.iface
    before = localized(dock().content.localize)
    counted["keys" if BY_KEYS else "clicks"] += 3  # Save, New, Recent.
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

    As docs/guide/own_photos.md tells it.
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
    """The first window, one by name, one picked on the map or the next one, and the image compared with it."""
    tab = opened_tab(1).inspect
    press(tab.after)
    wait_until(lambda: tab.name.text(), "the first window")
    names = [tab.name.text()]
    type_into(tab.name, tab.look_alikes.item(0, 0).text())
    names.append(tab.name.text())
    if BY_KEYS:
        press(tab.after)
    else:
        press(tab.pick)
        canvas = qgis.utils.iface.mapCanvas()
        counted["clicks"] += 1
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
    layer = openstreetmap_layer()
    classes = str(folder / "classified.gpkg")
    ran("semref:classifyopenstreetmap", {"INPUT": layer, "OUTPUT": classes})
    database = str(folder / "own.gpkg")
    of_classes = {"INPUT": classes, "CLASS_FIELD": "class", "PRIORITY_FIELD": "priority", "PIXEL_SIZE": 1}
    outputs = {"build:Reference database": database, "rasterize:Label map": str(folder / "own.tif")}
    sizes = {"WINDOW_SIZE": 200, "STRIDE": 50, "MINIMUM_AREA": 30, "REFERENCE_CLASSES": "building;water"}
    ran("semref:annotationtodatabase", {**of_classes, **sizes, **outputs})
    return {"in_the_dock": dock().content.database.path() == database, "groups": group_names()}


def planned(folder: Path) -> dict:
    """Where it works, what to expect along a line, and the file for the aircraft."""
    report, file = folder / "assessment.html", folder / "area.semref"
    quick = {"DATABASE": DATABASE, "MAP_CORRELATION": False}
    ran(
        "semref:assessdatabase",
        {**quick, "TRIALS": 60, "SPACING": 800, "REPORT": str(report), "OUTPUT": str(folder / "assessed.gpkg")},
    )
    route = QgsVectorLayer("LineString?crs=EPSG:25832", "route", "memory")
    feature, cover = QgsFeature(), QgsVectorLayer(str(SAMPLE / "landcover.shp"), "cover", "ogr").extent()
    ends = cover.xMinimum() + 700, cover.yMinimum() + 700, cover.xMaximum() - 700, cover.yMaximum() - 700
    feature.setGeometry(QgsGeometry.fromWkt("LINESTRING({} {}, {} {})".format(*ends)))
    route.dataProvider().addFeature(feature)
    QgsProject.instance().addMapLayer(route)
    gap = ran(
        "semref:assessroute",
        {**quick, "ROUTE": route, "TRIALS": 2, "REPORT": str(folder / "route.html")},
    )
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
    from processing.gui.BatchAlgorithmDialog import BatchAlgorithmDialog

    builds = QgsApplication.processingRegistry().createAlgorithmById("semref:builddatabase")
    files = [str(folder / f"of_{size}.gpkg") for size in (640, 480)]
    labels = {"LABELS": repr(str(SAMPLE / "label_map.tif"))}
    rows = [
        {
            "PARAMETERS": {**labels, **{k: repr(v) for k, v in WINDOW.items()}, "WINDOW_SIZE": size},
            "OUTPUTS": {"DATABASE": file},
        }
        for size, file in zip(("640", "480"), files)
    ]
    table = folder / "batch.json"
    table.write_text(json.dumps(rows), encoding="utf-8")
    dialog = BatchAlgorithmDialog(builds, qgis.utils.iface.mainWindow())
    dialog.show()
    settle(0.5)
    counted["keys" if BY_KEYS else "clicks"] += 2
    panel = dialog.mainWidget()
    with_file_dialog(panel.btnOpen, str(table))
    listed = panel.tblParameters.rowCount() - 1
    press(run_button(dialog))
    wait_until(lambda: all(map(os.path.exists, files)) and run_button(dialog).isEnabled(), "the batch")
    dialog.close()
    return {"listed": listed, "made": [os.path.getsize(file) > 10_000 for file in files]}


def group_names() -> list:
    root = QgsProject.instance().layerTreeRoot()
    return [node.name() for node in root.children() if hasattr(node, "addGroup")]


WALKS = {
    "sample": made,
    "sample, closed, reopened": reopened,
    "own photos": own_photos,
    "inspect": inspected,
    "own area": own_area,
    "assess, route, export": planned,
    "flight": flown,
    "batch": batch,
}
if BY_KEYS:
    # The table of QGIS's dialog keeps Tab to itself.
    del WALKS["batch"]


def session() -> dict:
    qgis.utils.iface.mainWindow().resize(1280, 900)
    folder = Path(tempfile.mkdtemp(prefix="walks", dir=os.environ["HOME"]))
    seen = {}
    for name, walk in WALKS.items():
        counted.update(clicks=0, keys=0, values=0)
        begun = time.monotonic()
        found = walk(folder)
        seen[name] = {**found, **counted, "seconds": round(time.monotonic() - begun, 1)}
        print(name, seen[name], flush=True)
    return seen


start(session)
