from types import SimpleNamespace

import numpy as np
import pytest
from dock_area import (
    AUTOMATIC,
    CONSTELLATION,
    CRS,
    CUT,
    ORIGIN,
    STRIDE,
    WINDOW,
    choose_method,
    corners,
    cut_extent,
    label_map,
    localize,
    logged,
    messages,
    results_of,
    rubber_bands,
    shown_center,
    shown_outline,
    start,
    wait_until,
    write_raster,
)
from qgis.core import QgsApplication, QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsPointXY, QgsProject
from qgis.gui import QgsRubberBand
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QFileDialog

from semref.core.localization import Status
from semref.processing.layers.localized_image import ERROR
from semref.ui.canvas.marks import AMBER, RED, RIM
from semref.ui.findings import status_text
from semref.ui.running import localization_run
from semref.ui.widgets.controls import sign_icon


def test_an_empty_dock_shows_what_to_do(dock, area, tab):
    assert tab.state.text() == "Choose a database and add images."
    assert tab.results.image.canvas._text == "The selected image appears here."
    dock.content.database.file.setFilePath(area.database)
    assert tab.state.text() == "Add images."
    assert not tab.localize_button.isEnabled()
    tab.images.list.add([area.image])
    assert tab.state.text() == "Ready to localize."
    assert tab.localize_button.isEnabled()


def test_an_image_cut_from_a_window_is_found_there_and_its_position_can_be_copied(dock, area, tab):
    localize(dock, area.database, [area.image])
    assert results_of(dock) == [("on_window.tif", "Unverified match")]
    assert tab.results.list.selected().window == "150_250"
    assert tab.state.text() == "The image has a position."
    details = tab.results.details.toPlainText()
    assert "x, y: 400250.00, 5399650.00 (EPSG:25832)" in details and "lat, lon: 48.7" in details
    tab.results.copy.click()
    latitude, longitude = QgsApplication.clipboard().text().split(", ")
    assert longitude.startswith("7.6") and latitude.startswith("48.7")
    assert tab.state.text_shown == f"Copied: {latitude}, {longitude} (lat, lon)"


@pytest.mark.slow
def test_the_hit_is_outlined_and_its_center_marked_in_any_crs_of_the_canvas(dock, iface, area):
    localize(dock, area.database, [area.image])
    assert corners(shown_outline(iface)) == pytest.approx(corners(cut_extent()), abs=1e-6)
    assert shown_center(iface).x() == pytest.approx(cut_extent().center().x(), abs=1e-3)
    assert shown_center(iface).y() == pytest.approx(cut_extent().center().y())
    mercator = QgsCoordinateReferenceSystem("EPSG:3857")
    iface.canvas.setDestinationCrs(mercator)
    transform = QgsCoordinateTransform(QgsCoordinateReferenceSystem(CRS), mercator, QgsProject.instance())
    expected = transform.transformBoundingBox(cut_extent())
    assert corners(shown_outline(iface)) == pytest.approx(corners(expected), abs=0.5)


@pytest.mark.slow
def test_an_unreadable_image_has_a_row_with_its_reason_and_no_outline(dock, iface, area, tab):
    localize(dock, area.database, [area.image, area.unreadable])
    tab.results.list.setCurrentRow(1)
    assert results_of(dock)[1] == ("broken.tif", "Unreadable")
    assert "broken.tif is not an image" in tab.results.details.toPlainText()
    assert (shown_outline(iface), shown_center(iface)) == (None, None)
    assert not tab.results.copy.isEnabled()
    assert messages(iface) == []


def test_cancel_ends_the_run_without_results(dock, iface, area, slow, tab):
    start(dock, area.database, [area.image])
    assert tab.localize_button.text() == "Cancel"
    wait_until(lambda: tab.progress.value() > 0, "progress")
    tab.localize_button.click()
    wait_until(lambda: not tab.run.running, "the end of the run")
    assert tab.state.text() == "Canceled."
    assert tab.localize_button.text() == "Localize"
    assert (results_of(dock), messages(iface)) == ([], [])


@pytest.mark.slow
def test_results_are_saved_to_a_file_and_its_positions_join_the_project(dock, area, tab, tmp_path, monkeypatch):
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "flown"), ""))
    assert not tab.results.save.isEnabled()
    localize(dock, area.database, [area.image, area.unreadable])
    tab.results.save.click()
    (layer,) = QgsProject.instance().mapLayers().values()
    assert [feature["status"] for feature in layer.getFeatures()] == ["fix", "error"]
    assert layer.source().startswith(str(tmp_path / "flown.gpkg"))


def test_every_status_has_words(qgis_app):
    def words(status, is_verified=True):
        given = {"status": status, "is_verified": is_verified, "is_by_flight": False, "speaks_against": ""}
        return status_text(SimpleNamespace(**given))

    for status in (*(status.key for status in Status), ERROR):
        assert words(status) != status
    assert "nverified" in words(Status.FIX, is_verified=False)


def test_the_dock_accepts_positions_that_are_wrong_in_one_of_a_hundred(dock, area, tab, monkeypatch):
    asked = []
    monkeypatch.setattr(tab.run, "start_algorithm", lambda name, parameters, title: asked.append(parameters))
    start(dock, area.database, [area.image])
    tab.run.start(area.database, [area.image], AUTOMATIC, {"RISK": 0.2}, True)
    assert [parameters["RISK"] for parameters in asked] == [0.01, 0.2]


def test_a_likely_position_is_amber_and_counted_apart(dock, iface, area, tab, monkeypatch, tmp_path):
    column, row = CUT
    small = write_raster(tmp_path / "small.tif", label_map()[row : row + 100, column : column + 100], False)
    choose_method(dock, CONSTELLATION)
    results = tab.results.list
    localize(dock, area.database, [small, area.image])
    # Between the error probabilities of both images, whatever the calibration is.
    risks = [1 - finding.confidence for finding in tab._findings]
    assert risks[0] > 10 * risks[1]
    monkeypatch.setattr(localization_run, "SHOWN_RISK", float(np.sqrt(np.prod(risks))))
    localize(dock, area.database, [])
    assert [status for _, status in results_of(dock)] == ["Likely position", "Position"]
    assert tab.state.text() == "1 of 2 images has a position. Likely positions: 1."
    finding = results.selected()
    assert finding.is_likely and finding.error_95 > 0 and finding.reason
    assert (finding.x, finding.y) == pytest.approx((ORIGIN[0] + column + 50, ORIGIN[1] - row - 50), abs=3)
    text = tab.results.details.toPlainText()
    assert "small.tif: Likely position, error probability " in text and "95 % radius" in text
    first, second = (results.item(n) for n in range(2))
    assert first.text().startswith("small.tif · Likely position · error ") and " ± " in first.text()
    assert first.data(Qt.ItemDataRole.BackgroundRole) is not None
    assert second.data(Qt.ItemDataRole.BackgroundRole) is None
    assert first.icon().pixmap(16).toImage() == sign_icon("likely").pixmap(16).toImage() and not first.icon().isNull()

    def colors():
        bands = [item for item in iface.canvas.scene().items() if isinstance(item, QgsRubberBand)]
        return {band.strokeColor().name() for band in bands if band.numberOfVertices()} - {RIM.name()}

    assert colors() == {AMBER.name()} and shown_center(iface).x() == pytest.approx(finding.x, abs=1e-3)
    results.setCurrentRow(1)
    assert colors() == {RED.name()}


def test_the_heading_arrow_points_where_the_top_of_the_image_is(dock, iface, area):
    choose_method(dock, AUTOMATIC)
    localize(dock, area.database, [area.image])
    (arrow,) = rubber_bands(iface, "Line")
    center, top = cut_extent().center(), cut_extent().yMaximum()
    box = arrow.boundingBox()
    assert (box.center().x(), box.yMaximum()) == pytest.approx((center.x(), top), abs=0.5)


@pytest.mark.slow
@pytest.mark.parametrize(("away_m", "fixes"), [(0, 1), (250, 0)])
def test_only_the_circle_drawn_on_the_map_is_searched(dock, area, away_m, fixes, tab):
    choose_method(dock, CONSTELLATION)
    middle = cut_extent().center()
    middle = QgsPointXY(middle.x() + away_m, middle.y())
    tab.prior.set_circle(middle, QgsPointXY(middle.x() + 60, middle.y()))
    assert tab.prior.text.text_shown == "Search area: radius 60 m"
    localize(dock, area.database, [area.image])
    assert tab.state.text() == ("The image has a position." if fixes else "The image has no position.")
    tab.prior.clear.click()
    assert tab.prior.parameters() == {}


@pytest.fixture
def show_in(iface):
    canvas = iface.mapCanvas()
    before = canvas.mapSettings().destinationCrs()
    yield canvas.setDestinationCrs
    canvas.setDestinationCrs(before)


@pytest.mark.slow
def test_circles_in_custom_crs_are_measured_in_meters_and_without_crs_in_units_of_the_database(dock, tab, show_in):
    globe = QgsCoordinateReferenceSystem.fromProj("+proj=ortho +lat_0=48 +lon_0=8 +datum=WGS84")
    assert globe.isValid() and not globe.authid()
    show_in(globe)
    # Outside of the area of the CRS.
    tab.prior.set_circle(QgsPointXY(9e6, 9e6), QgsPointXY(9.1e6, 9e6))
    assert tab.prior.parameters() == {}
    tab.prior.set_circle(QgsPointXY(0, 0), QgsPointXY(60, 0))
    assert tab.prior.parameters()["PRIOR_RADIUS"] == pytest.approx(60, abs=0.1)
    show_in(QgsCoordinateReferenceSystem())
    tab.prior.set_circle(QgsPointXY(400100, 5399900), QgsPointXY(400160, 5399900))
    assert tab.prior.parameters() == {"PRIOR_POINT": "400100.0,5399900.0 []", "PRIOR_RADIUS": 60}
    saved = tab.prior.circle
    tab.prior.forget()
    tab.prior.restore(saved)
    assert tab.prior.circle == saved


def test_a_circle_drawn_in_degrees_is_round_on_the_ground(dock, iface, tab, show_in):
    show_in(QgsCoordinateReferenceSystem("EPSG:4326"))
    tab.prior.set_circle(QgsPointXY(9.5, 60), QgsPointXY(9.51, 60))
    drawn = shown_outline(iface)
    assert drawn.xMaximum() == pytest.approx(9.51, abs=1e-4)
    # At 60° north, a degree of longitude is half as long as one of latitude.
    assert drawn.width() / drawn.height() == pytest.approx(2, rel=0.02)


@pytest.mark.slow
def test_an_image_is_laid_on_the_map_where_it_was_taken(dock, area, tab):
    choose_method(dock, AUTOMATIC)
    localize(dock, area.database, [area.image])
    tab.results.drape.click()
    wait_until(QgsProject.instance().mapLayers, "the layer")
    (layer,) = QgsProject.instance().mapLayers().values()
    assert corners(layer.extent()) == pytest.approx(corners(cut_extent()), abs=1.0)
    assert layer.opacity() == pytest.approx(0.6)


@pytest.mark.slow
def test_the_places_where_an_ambiguous_image_may_lie_are_outlined(dock, iface, run_algorithm, area, tmp_path):
    labels = label_map()
    twins = np.hstack([labels[:, :300], labels[:, :300]])
    sizes = {"WINDOW_SIZE": WINDOW, "STRIDE": STRIDE, "MINIMUM_AREA": 20, "REFERENCE_CLASSES": "1;2;3"}
    parameters = {"LABELS": write_raster(tmp_path / "twins.tif", twins, True), "DATABASE": str(tmp_path / "twins.gpkg")}
    run_algorithm("semref:builddatabase", {**parameters, **sizes})
    image = write_raster(tmp_path / "image.tif", twins[200:400, 50:250], False)
    choose_method(dock, CONSTELLATION)
    localize(dock, parameters["DATABASE"], [image])
    assert results_of(dock)[0][1] == "No position: ambiguous"
    (places,) = rubber_bands(iface, "Polygon")
    lefts = sorted(part.boundingBox().xMinimum() - ORIGIN[0] for part in places.asGeometryCollection())
    assert lefts == pytest.approx([50, 350], abs=2)
    assert shown_center(iface) is None
    assert iface.canvas.extent().contains(places.boundingBox())


def test_a_key_goes_from_image_to_image(dock, iface, area, tab):
    localize(dock, area.database, [area.image, area.unreadable])
    iface.window.activateWindow()
    tab.results.list.setFocus()
    wait_until(tab.results.list.hasFocus, "the focus")
    names = []
    for key in (Qt.Key.Key_Down, Qt.Key.Key_Down, Qt.Key.Key_Up):
        QTest.keyClick(tab.results.list, key, Qt.KeyboardModifier.AltModifier)
        names.append(tab.results.list.selected().name)
    assert names == ["broken.tif", "on_window.tif", "broken.tif"]
    tab.results.after.click()
    assert tab.results.list.selected().name == "on_window.tif"


def test_messages_of_a_run_are_in_the_log_panel_and_a_hidden_dock_reports_the_result(dock, iface, area, tab):
    with logged() as texts:
        start(dock, area.database, [area.image])
        dock.close()
        wait_until(lambda: not tab.run.running, "the end of the run")
    assert any("on_window.tif: 400250.0" in text for text in texts)
    assert messages(iface) == ["The image has a position."]
