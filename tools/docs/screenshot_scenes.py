"""What the guide's pictures show: each scene brings the window there as a user would, and takes its picture.

Each may come after any other.
"""

from __future__ import annotations

import shutil
import tempfile
import traceback
from contextlib import contextmanager
from pathlib import Path

import qgis.utils
from osgeo import gdal
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
from qgis.PyQt.QtCore import Qt, QTimer
from qgis.PyQt.QtWidgets import QApplication, QTreeView
from screenshot_window import DOCK_WIDTH, WINDOW, Session, failures, settle, wait_until

LOCALIZE, INSPECT, CORRECT = range(3)
NARROW = 100
"""A width less than the dock takes: it gets as narrow as it can be."""

TALL = 1250
"""Height of the window for pictures of the dock alone, so that nothing in it has to be scrolled."""

FILMED = 1120, 760
"""Size of the window in moving pictures, which are shown as they are."""

STEPS, WHILE_RUNNING = (0, 1, 2, 3, 5, 8), 4
"""Results that are stepped through; most frames while the run is going."""

SHOWN_PHOTO, INSPECTED_WINDOW = "photo_02.jpg", "1600_800"


def localized(session: Session) -> None:
    """All photos localized, the shown one selected."""
    session.show_tab(LOCALIZE)
    dock = session.dock
    if not session.localized:
        dock.content.localize.localize_button.click()
        wait_for_results(dock.content.localize, "the localization")
        session.localized = True
    table = dock.content.localize.results.table
    for row in range(table.model().rowCount()):
        index = table.model().index(row, 0)
        if index.data() == SHOWN_PHOTO:
            table.selectRow(row)
    wait_until(lambda: dock.content.localize.results.image.canvas.scene().items(), "the selected image")


def wait_for_results(tab, what: str) -> None:
    """Waits for a run; one that leaves nothing ends the session with what the message bar says."""
    wait_until(lambda: not tab.run.running, what)
    if not tab.results.table.model().rowCount():
        raise RuntimeError(f"{what} left no results: {failures()}")


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


def flight(session: Session) -> None:
    """The sample's flight on the map, one of its photos chosen."""
    with localized_flight(session) as tab:
        tab.results.table.selectRow(tab.results.table.model().rowCount() // 2)
        wait_until(lambda: tab.results.image.canvas.scene().items(), "the selected image")
        session.take("flight")


@contextmanager
def localized_flight(session: Session):
    """The tab with the flight's results and the whole track on the map; as before behind it."""
    session.show_tab(LOCALIZE)
    content = session.dock.content
    tab = content.localize
    listed = tab.images.paths()
    tab.images.list.show_only([str(Path(session.job["sample"]) / "flight")])
    tab.images.flight.setChecked(True)
    tab.localize_button.click()
    wait_for_results(tab, "the flight")
    session.localized = False
    boxes = content.database, tab.images
    for box in boxes:
        box.setCollapsed(True)
    session.show_everything()
    zooms = tab.results.zoom.isChecked()
    tab.results.zoom.setChecked(False)
    yield tab
    tab.results.zoom.setChecked(zooms)
    for box in boxes:
        box.setCollapsed(False)
    tab.images.flight.setChecked(False)
    tab.images.list.show_only(listed)


def moving_fix(session: Session) -> None:
    """From photos to positions: press Localize, and step through what comes."""
    session.resize(*FILMED)
    session.show_layers(False)
    session.show_tab(LOCALIZE)
    session.show_everything()
    content = session.dock.content
    tab = content.localize
    session.frame("first_fix", 1800)
    tab.localize_button.click()
    for _ in range(WHILE_RUNNING):
        settle(0.8)
        if tab.run.running:
            session.frame("first_fix", 500, settled=False)
    wait_for_results(tab, "the localization")
    session.localized = True
    boxes = content.database, tab.images
    for box in boxes:
        box.setCollapsed(True)
    session.frame("first_fix", 1200)
    for row in STEPS:
        tab.results.table.selectRow(row)
        wait_until(lambda: tab.results.image.canvas.scene().items(), "the selected image")
        session.frame("first_fix", 1600)
    for box in boxes:
        box.setCollapsed(False)
    session.show_layers(True)
    session.resize(*WINDOW)


def moving_flight(session: Session) -> None:
    """The sample's flight, image by image along its track."""
    session.resize(*FILMED)
    session.show_layers(False)
    with localized_flight(session) as tab:
        for row in range(tab.results.table.model().rowCount()):
            tab.results.table.selectRow(row)
            wait_until(lambda: tab.results.image.canvas.scene().items(), "the selected image")
            session.frame("flight", 700)
    session.show_layers(True)
    session.resize(*WINDOW)


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


def own_photos(session: Session) -> None:
    """Three photos in the dock: found, said to be taken elsewhere, and too small a piece of ground."""
    session.resize(WINDOW[0], TALL)
    session.show_tab(LOCALIZE)
    tab = session.dock.content.localize
    listed = tab.images.paths()
    with tempfile.TemporaryDirectory() as folder:
        tab.images.list.show_only(three_photos(Path(session.job["sample"]), Path(folder)))
        tab.localize_button.click()
        wait_for_results(tab, "the localization")
        session.localized = False
        tab.results.table.selectRow(1)
        wait_until(lambda: tab.results.image.canvas.scene().items(), "the selected image")
        session.take("own_photos", session.dock)
        tab.images.list.show_only(listed)
    session.resize(*WINDOW)


def three_photos(sample: Path, folder: Path) -> list[str]:
    """A photo of the sample; another with a position of elsewhere in its EXIF; a corner of a third."""
    made = [folder / name for name in ("DJI_0041.jpg", "DJI_0042.jpg", "DJI_0043.jpg")]
    sources = sorted((sample / "photos").glob("*.jpg"))
    shutil.copy(sources[1], made[0])
    elsewhere = gdal.Translate("", str(sources[2]), format="MEM")
    where = {"Latitude": "(52) (31) (12)", "LatitudeRef": "N", "Longitude": "(13) (24) (36)", "LongitudeRef": "E"}
    elsewhere.SetMetadata({f"EXIF_GPS{key}": value for key, value in where.items()})
    gdal.GetDriverByName("JPEG").CreateCopy(str(made[1]), elsewhere, options=["WRITE_EXIF_METADATA=YES"])
    gdal.Translate(str(made[2]), str(sources[3]), format="JPEG", srcWin=[200, 200, 160, 160])
    return [str(path) for path in made]


def inspect(session: Session) -> None:
    """A window of the database, with what looks like it."""
    session.show_everything()
    session.show_tab(INSPECT)
    session.dock.content.inspect.show_window(INSPECTED_WINDOW)
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
    tab.problems.setChecked(True)
    severities = [feature["severity"] for feature in issues.getFeatures()]
    to_mend = len(severities) - severities.count("information")
    tab.open.setChecked(False)
    wait_until(lambda: tab.places.rowCount() == to_mend, "the list of issues")
    tab.places.selectRow(0)
    tab.done.click()
    tab.done.click()
    kinds = [tab.places.item(row, 1).text() for row in range(tab.places.rowCount())]
    tab.places.selectRow(kinds.index("unknown class"))
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


def models(session: Session) -> None:
    """The models at hand with their cards."""
    from semref.processing.inspection.models import choose_models_folder
    from semref.ui.model_list import ModelsDialog

    choose_models_folder(session.job["models"])
    dialog = ModelsDialog()
    show_dialog(session, dialog, 960, 520, "models")


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
        session.dock.content.inspect.show_window(INSPECTED_WINDOW)
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
