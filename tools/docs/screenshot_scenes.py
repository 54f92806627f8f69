"""The scenes of the pictures. Each scene operates the window like a user and takes its pictures.

Each scene begins with the same window, so no scene has to restore it.
"""

import shutil
import tempfile
import traceback
from pathlib import Path

import processing
import qgis.utils
from osgeo import gdal
from qgis.core import QgsFeature, QgsFeatureRequest, QgsGeometry, QgsPointXY, QgsProject, QgsRectangle, QgsVectorLayer
from qgis.PyQt.QtCore import Qt, QTimer
from qgis.PyQt.QtWidgets import QApplication, QTreeView
from screenshot_window import DOCK_WIDTH, WINDOW, Session, failures
from walking import settle, wait_until

LOCALIZE, INSPECT, CORRECT = range(3)
NARROW = 100
"""A width below the dock's minimum, so that the dock becomes as narrow as possible."""

TALL = 1250
"""Height of the window for pictures of the dock only, so that the dock needs no scrolling."""

FILMED = 1120, 760
"""Size of the window in animations, which are shown in full size."""

STEPS, WHILE_RUNNING = (0, 1, 2, 3, 5, 8), 4
"""Number of results to select; number of frames during the run."""

SHOWN_PHOTO, INSPECTED_WINDOW = "photo_02.jpg", "1600_800"


def localized(session: Session) -> None:
    """Localize all photos and select the one to show."""
    session.show_tab(LOCALIZE)
    tab = session.dock.content.localize
    if not session.localized:
        localize(session, "the localization")
        session.localized = True
    names = [finding.name for finding in tab.results.list.findings]
    select(tab, names.index(SHOWN_PHOTO))


def localize(session: Session, what: str) -> None:
    """Press Localize and wait for the results."""
    session.dock.content.localize.localize_button.click()
    wait_for_results(session, what)


def wait_for_results(session: Session, what: str) -> None:
    """Wait for a run. If it has no results, end the session with the text of the message bar."""
    tab = session.dock.content.localize
    wait_until(lambda: not tab.run.running, what)
    session.localized = False
    if not tab.results.list.count():
        raise RuntimeError(f"{what} left no results: {failures()}")


def select(tab, row: int) -> None:
    """Select a result and wait for its image."""
    tab.results.list.setCurrentRow(row)
    wait_until(lambda: tab.results.image.canvas.scene().items(), "the selected image")


def first_fix(session: Session, name: str = "first_fix") -> None:
    """Show the whole window with a found photo and the inputs folded."""
    localized(session)
    session.fold_inputs(True)
    session.take(name)


def flight(session: Session) -> None:
    """Show the flight of the sample on the map with a selected photo."""
    tab = localized_flight(session)
    select(tab, tab.results.list.count() // 2)
    session.take("flight")


def localized_flight(session: Session):
    """Show the results of the flight and the whole track on the map; return the tab."""
    session.show_tab(LOCALIZE)
    tab = session.dock.content.localize
    tab.images.list.show_only([str(Path(session.job["sample"]) / "flight")])
    tab.images.flight.setChecked(True)
    localize(session, "the flight")
    session.fold_inputs(True)
    session.show_everything()
    tab.results.zoom.setChecked(False)
    return tab


def moving_fix(session: Session) -> None:
    """Press Localize and select the results one after the other."""
    session.resize(*FILMED)
    session.show_layers(False)
    session.show_tab(LOCALIZE)
    session.show_everything()
    tab = session.dock.content.localize
    session.frame("first_fix", 1800)
    tab.localize_button.click()
    for _ in range(WHILE_RUNNING):
        settle(0.8)
        if tab.run.running:
            session.frame("first_fix", 500, settled=False)
    wait_for_results(session, "the localization")
    session.fold_inputs(True)
    session.frame("first_fix", 1200)
    for row in STEPS:
        select(tab, row)
        session.frame("first_fix", 1600)


def moving_flight(session: Session) -> None:
    """Show the flight of the sample, image by image along its track."""
    session.resize(*FILMED)
    session.show_layers(False)
    tab = localized_flight(session)
    for row in range(tab.results.list.count()):
        select(tab, row)
        session.frame("flight", 700)


def dock_localize(session: Session) -> None:
    """Show the first tab of the dock."""
    session.resize(WINDOW[0], TALL)
    localized(session)
    session.take("dock_localize", session.dock)


def own_photos(session: Session) -> None:
    """Show three photos in the dock: with a position, with another position in its EXIF, with a small footprint."""
    session.resize(WINDOW[0], TALL)
    session.show_tab(LOCALIZE)
    tab = session.dock.content.localize
    with tempfile.TemporaryDirectory() as folder:
        tab.images.list.show_only(three_photos(Path(session.job["sample"]), Path(folder)))
        localize(session, "the localization")
        select(tab, 1)
        session.take("own_photos", session.dock)


def three_photos(sample: Path, folder: Path) -> list[str]:
    """Create a photo of the sample, one with another position in its EXIF, and a corner of a third."""
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
    """Show a window of the database and similar windows."""
    session.show_everything()
    session.show_tab(INSPECT)
    inspect_window(session)
    session.show_tab(INSPECT)
    session.take("inspect")


def inspect_window(session: Session) -> None:
    session.dock.content.inspect.show_window(INSPECTED_WINDOW)
    wait_until(lambda: session.dock.content.inspect._window is not None, "the inspected window")


def correct(session: Session) -> None:
    """Show the issues of a land-cover layer with a few errors."""
    issues = checked_with_mistakes(session)
    issues.setName("Issues")
    QgsProject.instance().addMapLayer(issues, False)
    QgsProject.instance().layerTreeRoot().insertLayer(0, issues)
    session.show_everything()
    session.show_tab(CORRECT)
    tab = session.dock.content.correct
    tab.layer.setLayer(issues)
    # Overlaps that the priority resolves are information only, and there are many.
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
    """Show a search area on the map."""
    session.show_tab(LOCALIZE)
    session.show_everything()
    extent = session.iface.mapCanvas().extent()
    middle = QgsPointXY(extent.center().x() + 0.1 * extent.width(), extent.center().y())
    session.dock.content.localize.prior.set_circle(middle, QgsPointXY(middle.x() + 0.2 * extent.width(), middle.y()))
    session.take("prior")


def toolbox(session: Session) -> None:
    """Show SemRef's algorithms next to the sample project."""
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
            tree.expandRecursively(index)
            tree.scrollTo(index, QTreeView.ScrollHint.PositionAtTop)
    session.take("toolbox")


def algorithm_dialog(session: Session) -> None:
    sample = Path(session.job["sample"])
    dialog = processing.createAlgorithmDialog(
        "semref:builddatabase", {"LABELS": str(sample / "label_map.tif"), "WINDOW_SIZE": 640, "STRIDE": 160}
    )
    show_dialog(session, dialog, 1000, 720, "build_database")


def models(session: Session) -> None:
    """Show the list of models with their cards."""
    from semref.ui.model_list import ModelsDialog

    show_dialog(session, ModelsDialog(), 960, 520, "models")


def add_model(session: Session) -> None:
    """Show the dialog of a new model with its test picture."""
    from semref.ui.add_model import AddModelDialog

    dialog = AddModelDialog()
    dialog.file.setFilePath(str(Path(qgis.utils.pluginDirectory("semref")) / "models" / "sample_area.onnx"))
    wait_until(lambda: dialog.outputs.value() > 1, "the outputs of the network")
    dialog.classes.item(5, 0).setText("grass")
    dialog.test.click()
    wait_until(lambda: dialog.legend.count() > 0, "the test picture")
    show_dialog(session, dialog, 1100, 680, "add_model")


def model_designer(session: Session) -> None:
    """Show the shipped model in the model designer."""
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
    """Show SemRef's page of the options. The dialog is modal, so a timer takes the picture."""
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
    """Show the scene of the variants: theme, language."""
    first_fix(session, "window")


def all_tabs(session: Session) -> None:
    """Show each tab of the dock in a language, with normal and with minimum width."""
    for width, kind in ((DOCK_WIDTH, "tab"), (NARROW, "narrow")):
        session.resize(WINDOW[0], TALL, width)
        localized(session)
        session.take(f"{kind}_localize", session.dock)
        inspect_window(session)
        session.take(f"{kind}_inspect", session.dock)
        session.show_tab(CORRECT)
        session.take(f"{kind}_correct", session.dock)
    toolbox(session)


def checked_with_mistakes(session: Session) -> QgsVectorLayer:
    """Check a copy of the land cover with typical errors and return the issues."""
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
    issues = str(sample / "issues.gpkg")
    fields = {"CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder", "CLASS_TABLE": str(sample / "classes.csv")}
    processing.run("semref:checkannotation", {"INPUT": layer, **fields, "MINIMUM_AREA": 50, "ISSUES": issues})
    return QgsVectorLayer(issues, "issues", "ogr")


def crossed(feature) -> QgsGeometry:
    """Return a bow tie at the place of the feature."""
    box: QgsRectangle = feature.geometry().boundingBox()
    west, east, south, north = box.xMinimum(), box.xMaximum(), box.yMinimum(), box.yMaximum()
    corners = (west, south), (east, north), (east, south), (west, north), (west, south)
    return QgsGeometry.fromPolygonXY([[QgsPointXY(*corner) for corner in corners]])
