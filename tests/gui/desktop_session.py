"""Runs inside desktop QGIS (--code): loads and unloads the plugin, and returns what it saw."""

import os
import time
from collections import Counter

import qgis.utils
from qgis.core import (
    QgsApplication,
    QgsFeature,
    QgsGeometry,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProject,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QCoreApplication, QMimeData, QPoint, QPointF, Qt, QTimer, QUrl
from qgis.PyQt.QtGui import QDragEnterEvent, QDropEvent
from qgis.PyQt.QtWidgets import QApplication, QDockWidget, QToolBar
from walking import settle, start

ROUNDS = 5
DROP_S = 3
BATCH_S = 3
PLUGIN = "semref"
BOW_TIE = "POLYGON((0 0, 20 20, 20 0, 0 20, 0 0))"
logged = []
SQUARE = "POLYGON((100 0, 120 0, 120 20, 100 20, 100 0))"


def window_parts() -> Counter:
    """What a user can reach in QGIS's window, counted."""
    window = qgis.utils.iface.mainWindow()
    parts = Counter(f"dock {dock.objectName()}" for dock in window.findChildren(QDockWidget))
    for bar in window.findChildren(QToolBar):
        parts.update(f"tool bar {bar.objectName()}: {action.text()}" for action in bar.actions())
    parts.update(menu_entries(window.menuBar()))
    parts["items on the canvas"] = len(qgis.utils.iface.mapCanvas().scene().items())
    return parts


def menu_entries(menu, path: str = "menu"):
    for action in menu.actions():
        entry = f"{path}/{action.text()}"
        yield entry
        if action.menu():
            yield from menu_entries(action.menu(), entry)


def provider():
    return QgsApplication.processingRegistry().providerById(PLUGIN)


def one_round() -> dict:
    before = window_parts()
    loaded = qgis.utils.loadPlugin(PLUGIN) and qgis.utils.startPlugin(PLUGIN)
    settle()
    algorithms = [algorithm.id() for algorithm in provider().algorithms()] if provider() else []
    added = sorted((window_parts() - before).elements())
    unloaded = qgis.utils.unloadPlugin(PLUGIN)
    settle()
    left = sorted((window_parts() - before).elements())
    if provider():
        left.append("provider")
    return {"loaded": loaded, "unloaded": unloaded, "algorithms": algorithms, "added": added, "left": left}


def check_annotation() -> dict:
    """Shapely at work beside QGIS's own GEOS, which desktop QGIS lets it use."""
    layer = QgsVectorLayer("Polygon?crs=EPSG:32632&field=class:string", "cover", "memory")
    for wkt in BOW_TIE, SQUARE:
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromWkt(wkt))
        feature["class"] = "building"
        layer.dataProvider().addFeature(feature)
    context = QgsProcessingContext()
    parameters = {"INPUT": layer, "CLASS_FIELD": "class"}
    registry = QgsApplication.processingRegistry()
    checked = registry.createAlgorithmById("semref:checkannotation")
    found, _ = checked.run({**parameters, "ISSUES": "memory:"}, context, QgsProcessingFeedback())
    issues = context.takeResultLayer(found["ISSUES"])
    repaired, _ = registry.createAlgorithmById("semref:repairannotation").run(
        {**parameters, "OUTPUT": "memory:"}, context, QgsProcessingFeedback()
    )
    clean = context.takeResultLayer(repaired["OUTPUT"])
    return {
        "kinds": sorted({issue["kind"] for issue in issues.getFeatures()}),
        "area": sum(feature.geometry().area() for feature in clean.getFeatures()),
    }


def dropped(path: str) -> dict:
    """Drops a file on QGIS's window: the windows that ask something, and the layers that came."""
    window, asked = qgis.utils.iface.mainWindow(), []

    def close_question() -> None:
        dialog = QApplication.activeModalWidget()
        if dialog is not None:
            asked.append(dialog.windowTitle())
            dialog.close()

    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(path)])
    how = Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    QApplication.sendEvent(window, QDragEnterEvent(QPoint(5, 5), *how))
    QApplication.sendEvent(window, QDropEvent(QPointF(5, 5), *how))
    closer = QTimer()
    closer.timeout.connect(close_question)
    closer.start(300)
    end = time.monotonic() + DROP_S
    while time.monotonic() < end:
        QCoreApplication.processEvents()
    closer.stop()
    layers = sorted(layer.name() for layer in QgsProject.instance().mapLayers().values())
    QgsProject.instance().clear()
    return {"asked": asked, "layers": layers}


def failed_batch() -> int:
    """Runs a batch whose row fails; the number of tasks that are still active some seconds later."""
    from processing.gui.BatchAlgorithmDialog import BatchAlgorithmDialog

    dialog = BatchAlgorithmDialog(provider().algorithm("rasterizeannotation").create(), qgis.utils.iface.mainWindow())
    row = {"INPUT": "missing.gpkg", "OUTPUT": "TEMPORARY_OUTPUT"}, True
    dialog.mainWidget().batchRowCount = lambda: 1
    dialog.mainWidget().parametersForRow = lambda *_, **__: row
    dialog.runAlgorithm()
    dialog.close()
    settle(BATCH_S)
    return QgsApplication.taskManager().countActiveTasks()


def session() -> dict:
    QgsApplication.messageLog().messageReceived[str, str, "Qgis::MessageLevel"].connect(
        lambda text, tag, level: logged.append(text)
    )
    qgis.utils.updateAvailablePlugins()
    rounds = [one_round() for _ in range(ROUNDS)]
    # The plugin stays loaded while QGIS quits, as it does for a user.
    stays = qgis.utils.loadPlugin(PLUGIN) and qgis.utils.startPlugin(PLUGIN)
    settle()
    database, other = os.environ["SEMREF_DATABASE"], os.environ["SEMREF_OTHER"]
    drops = {"database": dropped(database), "other": dropped(other)}
    seen = {"logged": logged, "rounds": rounds, "stays": stays, "check": check_annotation(), "drops": drops}
    return {**seen, "tasks": failed_batch()}


start(session)
