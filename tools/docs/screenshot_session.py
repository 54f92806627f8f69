"""Runs inside desktop QGIS (--code): brings the window into each scene of a job as a user would, and takes its picture.

SEMREF_SCREENSHOTS names the job, a JSON file that make_screenshots.py writes: ``sample`` (folder of the sample
project, made here when it is missing), ``pictures`` (folder), ``scenes`` (names of functions of this file, each with
the pictures' suffix) and ``result`` (JSON, written at the end).
"""

import json
import os
import time
import traceback
from pathlib import Path

import qgis.utils
from qgis.core import (
    QgsApplication,
    QgsFeature,
    QgsFeatureRequest,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProject,
    QgsRectangle,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QCoreApplication, QPoint, QRect, Qt, QTimer
from qgis.PyQt.QtGui import QGuiApplication
from qgis.PyQt.QtWidgets import QApplication, QDockWidget, QToolBar, QTreeView

LOCALIZE, INSPECT, CORRECT = range(3)
WINDOW = 1280, 900
"""Size of QGIS's window, in device-independent pixels."""

DOCK_WIDTH, NARROW = 400, 100
"""The second is less than the dock takes: it gets as narrow as it can be."""

TALL = 1250
"""Height of the window for pictures of the dock alone, so that nothing in it has to be scrolled."""

SHOWN_PHOTO, INSPECTED_WINDOW = "photo_02.jpg", "1600_800"
LIMIT_S = 300
# Toolbars that SemRef's users do not need; they would fill the window with rows of icons.
KEPT_TOOLBARS = ("mFileToolBar", "mMapNavToolBar", "mAttributesToolBar", "mPluginToolBar")

messages = []


class Session:
    """The window and the dock, ready on the sample project."""

    def __init__(self, job: dict) -> None:
        self.job = job
        self.iface = qgis.utils.iface
        self.window = self.iface.mainWindow()
        self.plugin = qgis.utils.plugins["semref"]
        self.dock = self.window.findChild(QDockWidget, "SemRefDock")
        self.toolbox = self.window.findChild(QDockWidget, "ProcessingToolbox")
        self.suffix = ""
        self.localized = False
        self.taken = []

    def open(self) -> None:
        for bar in self.window.findChildren(QToolBar):
            if bar.parent() is self.window:
                bar.setVisible(bar.objectName() in KEPT_TOOLBARS)
        for name in ("Browser", "LayerOrder", "ProcessingToolbox"):
            dock = self.window.findChild(QDockWidget, name)
            if dock is not None:
                dock.hide()
        self.window.showNormal()
        self.resize(*WINDOW)
        self.plugin._entry._sample_project().make(Path(self.job["sample"]))
        wait_until(lambda: self.is_open() or failures(), "the sample project")
        if failures():
            raise RuntimeError(f"the sample project could not be made: {failures()}")
        self.iface.messageBar().clearWidgets()
        self.resize(*WINDOW)
        self.show_everything()

    def is_open(self) -> bool:
        """As the sample project leaves it: with the images in the dock."""
        return bool(QgsProject.instance().fileName()) and bool(self.dock.content.localize.images.paths())

    def resize(self, width: int, height: int, dock_width: int = DOCK_WIDTH) -> None:
        self.window.setGeometry(0, 0, width, height)
        settle(0.2)
        self.window.resizeDocks([self.dock], [dock_width], Qt.Orientation.Horizontal)
        layers = self.window.findChild(QDockWidget, "Layers")
        self.window.resizeDocks([layers], [190], Qt.Orientation.Horizontal)
        settle(0.3)

    def show_tab(self, tab: int) -> None:
        self.toolbox.hide()
        self.dock.setUserVisible(True)
        self.dock.content.tabs.setCurrentIndex(tab)
        settle(0.2)

    def show_everything(self) -> None:
        """The whole sample, nothing marked on it."""
        self.dock.content.localize.results.table.clearSelection()
        self.dock.content.inspect.use(None)
        self.iface.mapCanvas().setReferencedExtent(QgsProject.instance().viewSettings().defaultViewExtent())
        self.iface.mapCanvas().refresh()

    def layer(self, position_from_top: int):
        return QgsProject.instance().layerTreeRoot().findLayers()[position_from_top]

    # --- pictures ---

    def take(self, name: str, *widgets) -> None:
        """A picture of the screen where these widgets are; of the whole window without any."""
        self.iface.mapCanvas().waitWhileRendering()
        settle(1.0)
        # QGIS tells of every task that took a while.
        self.iface.messageBar().clearWidgets()
        settle(0.5)
        area = QRect()
        for widget in widgets or (self.window,):
            area = area.united(QRect(widget.mapToGlobal(QPoint(0, 0)), widget.size()))
        screen = QGuiApplication.primaryScreen()
        picture = screen.grabWindow(0, area.x(), area.y(), area.width(), area.height())
        file = Path(self.job["pictures"]) / f"{name}{self.suffix}.png"
        if picture.isNull() or not picture.save(str(file)):
            raise RuntimeError(f"{file} could not be written")
        self.taken.append(file.name)


# --- scenes: each may come after any other ---


def localized(session: Session) -> None:
    """All photos localized, the shown one selected."""
    session.show_tab(LOCALIZE)
    dock = session.dock
    if not session.localized:
        dock.content.localize.localize_button.click()
        wait_until(lambda: not dock.content.localize.run.running, "the localization")
        session.localized = True
    table = dock.content.localize.results.table
    for row in range(table.model().rowCount()):
        index = table.model().index(row, 0)
        if index.data() == SHOWN_PHOTO:
            table.selectRow(row)
    wait_until(lambda: dock.content.localize.results.image.canvas.scene().items(), "the selected image")


def first_fix(session: Session) -> None:
    """The whole window with a hit."""
    with_results_in_view(session, "first_fix")


def with_results_in_view(session: Session, name: str) -> None:
    """The whole window; what was chosen is folded away, as who looks at results does."""
    localized(session)
    boxes = session.dock.content.database, session.dock.content.localize.images
    for box in boxes:
        box.setCollapsed(True)
    session.take(name)
    for box in boxes:
        box.setCollapsed(False)


def dock_localize(session: Session) -> None:
    """The dock's first tab alone."""
    session.resize(WINDOW[0], TALL)
    localized(session)
    session.take("dock_localize", session.dock)
    session.resize(*WINDOW)


def narrow(session: Session) -> None:
    """The dock as narrow as it gets."""
    session.resize(WINDOW[0], TALL, NARROW)
    localized(session)
    session.take("narrow_localize", session.dock)
    session.resize(*WINDOW)


def inspect(session: Session) -> None:
    """A window of the database, with what looks like it."""
    session.show_everything()
    session.dock.inspect_window(INSPECTED_WINDOW)
    wait_until(lambda: session.dock.content.inspect._window is not None, "the inspected window")
    session.show_tab(INSPECT)
    session.take("inspect")


def correct(session: Session) -> None:
    """The findings of a check of an annotation with a few mistakes."""
    issues = checked_with_mistakes(session)
    issues.setName("Issues")
    QgsProject.instance().addMapLayer(issues, False)
    QgsProject.instance().layerTreeRoot().insertLayer(0, issues)
    session.show_everything()
    session.show_tab(CORRECT)
    tab = session.dock.content.correct
    tab.layer.setLayer(issues)
    # What the priority decides is information, and there is much of it.
    tab.mend.setChecked(True)
    severities = [feature["severity"] for feature in issues.getFeatures()]
    to_mend = len(severities) - severities.count("information")
    wait_until(lambda: tab.places.rowCount() == to_mend, "the list of issues")
    tab.places.selectRow(0)
    tab.done.click()
    tab.done.click()
    kinds = [tab.places.item(row, 0).text() for row in range(tab.places.rowCount())]
    tab.places.selectRow(kinds.index("unknown_class"))
    session.take("correct")
    QgsProject.instance().removeMapLayer(issues.id())


def prior(session: Session) -> None:
    """A circle drawn on the map."""
    session.show_tab(LOCALIZE)
    session.show_everything()
    extent = session.iface.mapCanvas().extent()
    middle = QgsPointXY(extent.center().x() + 0.1 * extent.width(), extent.center().y())
    session.dock.content.localize.prior.set_circle(middle, QgsPointXY(middle.x() + 0.2 * extent.width(), middle.y()))
    session.take("prior")
    session.dock.content.localize.prior.forget()


def toolbox(session: Session) -> None:
    """SemRef's algorithms beside the sample project."""
    session.show_everything()
    session.dock.setUserVisible(False)
    session.toolbox.show()
    session.window.resizeDocks([session.toolbox], [DOCK_WIDTH], Qt.Orientation.Horizontal)
    tree = next(view for view in session.toolbox.findChildren(QTreeView) if view.isVisible())
    tree.collapseAll()
    model = tree.model()
    for row in range(model.rowCount()):
        index = model.index(row, 0)
        if index.data() == "SemRef":
            expand(tree, index)
            tree.scrollTo(index, QTreeView.ScrollHint.PositionAtTop)
    session.take("toolbox")
    session.toolbox.hide()


def expand(tree, index) -> None:
    tree.expand(index)
    for row in range(tree.model().rowCount(index)):
        expand(tree, tree.model().index(row, 0, index))


def algorithm_dialog(session: Session) -> None:
    import processing

    sample = Path(session.job["sample"])
    dialog = processing.createAlgorithmDialog(
        "semref:builddatabase", {"LABELS": str(sample / "label_map.tif"), "WINDOW_SIZE": 640, "STRIDE": 160}
    )
    show_dialog(session, dialog, 1000, 720, "build_database")


def train_model(session: Session) -> None:
    """The dialog that makes a network of the sample's orthophoto and polygons."""
    import processing

    sample = Path(session.job["sample"])
    annotation = {"INPUT": str(sample / "landcover.shp"), "CLASS_FIELD": "class"}
    given = {"IMAGE": str(sample / "orthophoto.tif"), **annotation, "CLASS_TABLE": str(sample / "classes.csv")}
    dialog = processing.createAlgorithmDialog("semref:trainmodel", {**given, "MINUTES": 10})
    show_dialog(session, dialog, 1000, 760, "train_model")


def model_designer(session: Session) -> None:
    """The model that ships, opened in the model designer."""
    from processing.modeler.ModelerDialog import ModelerDialog

    designer = ModelerDialog()
    designer.loadModel(str(Path(qgis.utils.pluginDirectory("semref")) / "models" / "annotation_to_database.model3"))
    show_dialog(session, designer, 1420, 640, "model_designer")


def show_dialog(session: Session, dialog, width: int, height: int, name: str) -> None:
    dialog.show()
    dialog.setGeometry(0, 0, width, height)
    dialog.raise_()
    session.take(name, dialog)
    dialog.close()
    dialog.deleteLater()


def options(session: Session) -> None:
    """SemRef's page of the options; the dialog waits for its user, so the picture is taken by a timer."""
    failed = []

    def take() -> None:
        dialog = QApplication.activeModalWidget()
        try:
            dialog.setGeometry(0, 0, 980, 520)
            session.take("options", dialog)
        except Exception:
            failed.append(traceback.format_exc())
        dialog.close()

    QTimer.singleShot(1500, take)
    session.iface.showOptionsDialog(session.window, "SemRefOptions")
    if failed:
        raise RuntimeError(failed[0])


def whole_window(session: Session) -> None:
    """For the variants: theme, language."""
    with_results_in_view(session, "window")


def all_tabs(session: Session) -> None:
    """For looking at the dock in a language: each tab alone, as wide as usual and as narrow as it gets."""
    for width, kind in ((DOCK_WIDTH, "tab"), (NARROW, "narrow")):
        session.resize(WINDOW[0], TALL, width)
        localized(session)
        session.take(f"{kind}_localize", session.dock)
        session.dock.inspect_window(INSPECTED_WINDOW)
        wait_until(lambda: session.dock.content.inspect._window is not None, "the inspected window")
        session.take(f"{kind}_inspect", session.dock)
        session.show_tab(CORRECT)
        session.take(f"{kind}_correct", session.dock)
    toolbox(session)


def checked_with_mistakes(session: Session) -> QgsVectorLayer:
    """Issues of a copy of the land cover into which typical mistakes were put."""
    sample = Path(session.job["sample"])
    cover = QgsVectorLayer(str(sample / "landcover.shp"), "landcover", "ogr")
    layer = cover.materialize(QgsFeatureRequest())
    layer.startEditing()
    features = [feature for feature in layer.getFeatures() if feature["class"] == "building"][:40]
    layer.changeAttributeValue(features[3].id(), layer.fields().indexOf("class"), "buildng")
    layer.changeGeometry(features[8].id(), crossed(features[8]))
    double = QgsFeature(features[12])
    double["class"] = "water"
    layer.addFeature(double)
    layer.commitChanges()
    registry = QgsApplication.processingRegistry()
    context = QgsProcessingContext()
    issues = str(sample / "issues.gpkg")
    _, ok = registry.createAlgorithmById("semref:checkannotation").run(
        {
            "INPUT": layer,
            "CLASS_FIELD": "class",
            "PRIORITY_FIELD": "zorder",
            "CLASS_TABLE": str(sample / "classes.csv"),
            "MINIMUM_AREA": 50,
            "ISSUES": issues,
        },
        context,
        QgsProcessingFeedback(),
    )
    if not ok:
        raise RuntimeError("the annotation could not be checked")
    return QgsVectorLayer(issues, "issues", "ogr")


def crossed(feature) -> QgsGeometry:
    """A bow tie where the feature is."""
    box: QgsRectangle = feature.geometry().boundingBox()
    corners = (
        (box.xMinimum(), box.yMinimum()),
        (box.xMaximum(), box.yMaximum()),
        (box.xMaximum(), box.yMinimum()),
        (box.xMinimum(), box.yMaximum()),
    )
    return QgsGeometry.fromPolygonXY([[QgsPointXY(x, y) for x, y in (*corners, corners[0])]])


# --- running ---


def settle(seconds: float) -> None:
    """Lets the window do what it has to for a while."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QCoreApplication.processEvents()
        time.sleep(0.01)


def wait_until(condition, what: str) -> None:
    end = time.monotonic() + LIMIT_S
    while not condition():
        if time.monotonic() > end:
            raise RuntimeError(f"{what} did not come within {LIMIT_S} s")
        settle(0.1)


def failures() -> list:
    """What the message bar says at its reddest."""
    return [item.text() for item in qgis.utils.iface.messageBar().items() if int(item.level()) == 2]


def run() -> None:
    job = json.loads(Path(os.environ["SEMREF_SCREENSHOTS"]).read_text(encoding="utf-8"))
    session = None
    result = {}
    try:
        session = Session(job)
        session.open()
        for scene, suffix in job["scenes"]:
            session.suffix = suffix
            print(scene, flush=True)
            globals()[scene](session)
    except Exception:
        result["error"] = traceback.format_exc()
    result["taken"] = session.taken if session else []
    result["messages"] = messages
    Path(job["result"]).write_text(json.dumps(result, indent=1), encoding="utf-8")
    QgsProject.instance().setDirty(False)
    qgis.utils.iface.actionExit().trigger()


def note_exception(kind, value, trace, text, *arguments, **options) -> None:
    """In place of QGIS's dialog, which would wait for a click."""
    messages.append("".join(traceback.format_exception(kind, value, trace)))


qgis.utils.showException = note_exception
# The window is complete only when its event loop runs.
QTimer.singleShot(3000, run)
