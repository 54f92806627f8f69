import pytest
from dock_area import CRS, messages, rectangles, rubber_bands, settle, wait_until
from qgis.core import (
    QgsApplication,
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsGeometry,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProject,
    QgsRectangle,
    QgsSettings,
    QgsVectorFileWriter,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QApplication, QMessageBox

from semref.ui.running.background import shut_down
from semref.ui.tabs.correct.places_table import PlaceRow, PlacesTable
from semref.ui.tabs.correct.tab import CorrectTab
from semref.ui.widgets.database_box import DatabaseBox
from semref.ui.widgets.messages import Messages

SPECK_M = 0.1


@pytest.fixture
def tab(iface):
    iface.canvas.setDestinationCrs(QgsCoordinateReferenceSystem(CRS))
    QgsSettings().remove("semref/correct")
    tab = CorrectTab(iface.canvas, DatabaseBox(), Messages(iface.bar))
    tab.open.setChecked(False)
    yield tab
    shut_down(tab)
    tab.shut_down()
    tab.deleteLater()
    QgsProject.instance().clear()


@pytest.fixture
def add_layer(qgis_app):
    """`add_layer(name)` adds a polygon layer with one speck and one square of 100 m."""

    def add(name: str):
        squares = [((550000, 5420000, size, size), "invalid", f"{size} m") for size in (SPECK_M, 100.0)]
        return rectangles(name, {"kind": "string", "message": "string"}, squares)

    return add


@pytest.mark.parametrize("others", [[], ["A land cover"], ["Z land cover"]])
def test_other_layers_may_be_removed_and_none_takes_the_place_of_the_layer(tab, iface, add_layer, others):
    layers = [add_layer(name) for name in ("B land cover", *others)]
    issues = add_layer("issues")
    tab.layer.setLayer(issues)
    tab.places.selectRow(1)
    QgsProject.instance().removeMapLayer(layers[0].id())
    assert tab.layer.currentLayer() == issues
    assert tab.text.text() == "invalid geometry · 100.0 m · 550050, 5420050"
    assert tab.progress.text() == "0 of 2 done" and not tab.progress.isHidden()
    QgsProject.instance().removeMapLayer(issues.id())
    assert tab.layer.currentLayer() is None
    assert tab.places.rowCount() == 0 and rubber_bands(iface, "Polygon") == []
    tab.done.click()
    assert tab.progress.isHidden()


def test_the_list_has_the_words_of_each_kind_and_nothing_of_a_file_is_taken_for_markup(tab, add_layer):
    issues = add_layer("issues")
    provider = issues.dataProvider()
    first, second = (feature.id() for feature in issues.getFeatures())
    provider.changeAttributeValues({first: {0: "outside_crs", 1: "<b>far</b> away"}, second: {0: "kind_of_tomorrow"}})
    tab.layer.setLayer(None)
    tab.layer.setLayer(issues)
    assert [tab.places.item(row, 1).text() for row in range(2)] == ["outside the area of the CRS", "kind of tomorrow"]
    tab.places.selectRow(0)
    assert tab.text.text() == "outside the area of the CRS · <b>far</b> away · 550000, 5420000"
    assert tab.text.textFormat() == Qt.TextFormat.PlainText


def test_what_is_left_out_of_the_lists_is_forgotten_with_its_layer(tab, add_layer):
    """Otherwise a new layer at the address of the deleted one would be hidden."""
    # Neither places nor an annotation, and both at once.
    cover = rectangles("cover", {"class": "string"}, [])
    issues = add_layer("issues")
    wait_until(lambda: tab.layer.exceptedLayerList() and tab.updating.annotation.exceptedLayerList(), "the lists")
    QgsProject.instance().removeMapLayers([cover.id(), issues.id()])
    assert (tab.layer.exceptedLayerList(), tab.updating.annotation.exceptedLayerList()) == ([], [])


def test_a_speck_is_shown_with_the_ground_around_it(tab, iface, add_layer):
    tab.layer.setLayer(add_layer("issues"))
    tab.places.selectRow(0)
    assert iface.canvas.scale() == pytest.approx(500)
    assert iface.canvas.extent().center().x() == pytest.approx(550000 + SPECK_M / 2, abs=0.01)
    tab.places.selectRow(1)
    assert iface.canvas.scale() > 500


def test_information_can_be_left_out_and_what_is_done_is_kept(tab):
    fields = {"kind": "string", "severity": "string", "message": "string"}
    severities = enumerate(("information", "error", "information", "warning"))
    rows = [((550000, 5420000, 100 + n, 100), "overlap", severity, str(n)) for n, severity in severities]
    layer = rectangles("issues", fields, rows)
    tab.layer.setLayer(layer)
    tab.places.selectRow(0)
    tab.done.click()
    assert tab.progress.text() == "1 of 4 done"
    tab.problems.click()
    shown = [tab.places.item(row, 2).text() for row in range(tab.places.rowCount())]
    assert shown == ["1", "3"] and tab.progress.text() == "0 of 2 done"
    tab.problems.click()
    assert tab.places.rowCount() == 4 and tab.progress.text() == "1 of 4 done"


def test_only_layers_of_places_are_offered_and_one_that_comes_is_chosen(tab, add_layer):
    cover = rectangles("land cover", {"class": "string"}, [])
    settle()
    assert [tab.layer.layer(row) for row in range(tab.layer.count())] == [None]
    found = add_layer("issues")
    settle()
    assert tab.layer.currentLayer() == found
    assert [tab.layer.layer(row) for row in range(tab.layer.count())] == [None, found]
    assert tab.updating.annotation.currentLayer() == cover
    assert tab.updating.class_field.currentField() == "class"


def listed(tab) -> list[str]:
    return [tab.places.item(row, 1).text() for row in range(tab.places.rowCount())]


def test_an_annotator_goes_through_the_places_and_marks_what_is_done(dock, iface, issues):
    tab = dock.content.correct
    tab.open.setChecked(False)
    assert listed(tab) == ["overlap", "gap between neighbors", "sliver"]
    tab.after.click()
    assert "Here is a overlap." in tab.text.text()
    assert iface.canvas.extent().contains(next(issues.getFeatures()).geometry().boundingBox())
    (mark,) = rubber_bands(iface, "Polygon")
    assert mark.area() == pytest.approx(100)
    tab.done.click()
    assert "Here is a gap." in tab.text.text()
    assert (tab.progress.value(), tab.progress.maximum()) == (1, 3)
    tab.open.setChecked(True)
    assert listed(tab) == ["gap between neighbors", "sliver"]


def test_what_is_done_is_remembered_in_the_project_and_not_in_the_table(dock, issues):
    fields = issues.fields().names()
    dock.content.correct.open.setChecked(False)
    dock.content.correct.places.selectRow(2)
    dock.content.correct.done.click()
    dock.content.correct.layer.setLayer(None)
    dock.content.correct.layer.setLayer(issues)
    assert dock.content.correct.progress.value() == 1
    assert issues.fields().names() == fields


@pytest.mark.slow
def test_a_list_of_many_places_is_filled_without_holding_up_qgis(dock, iface, issues, monkeypatch):
    from semref.ui.tabs.correct import tab

    monkeypatch.setattr(tab, "_FILL_S", 0.02)
    features = []
    for number in range(20_000):
        feature = QgsFeature(issues.fields())
        feature.setGeometry(QgsGeometry.fromRect(QgsRectangle(number, 0, number + 1, 1)))
        feature.setAttributes(["gap", "warning", "A gap.", 1.0])
        features.append(feature)
    issues.dataProvider().addFeatures(features)
    dock.content.correct.open.setChecked(False)
    dock.content.correct.layer.setLayer(None)
    dock.content.correct.layer.setLayer(issues)
    places = dock.content.correct.places
    assert 0 < places.rowCount() < 20_003
    places.selectRow(1)
    dock.content.correct.done.click()
    wait_until(lambda: places.rowCount() == 20_003, "the whole list")
    assert (dock.content.correct.progress.value(), dock.content.correct.progress.maximum()) == (1, 20_003)
    assert places.selectionModel().selectedRows()[0].row() == 2
    # Removed halfway.
    dock.content.correct.open.setChecked(True)
    assert 0 < places.rowCount() < 20_003
    QgsProject.instance().removeMapLayer(issues.id())
    settle()
    assert places.rowCount() == 0


def test_severities_are_shown_and_read_aloud(dock, issues):
    places = dock.content.correct.places
    assert not places.isColumnHidden(0) and not places.item(0, 0).icon().isNull()
    assert places.item(0, 0).data(Qt.ItemDataRole.AccessibleTextRole) == "Warning"


def test_places_have_two_lines_of_whatever_font_and_are_selected_from_right_to_left(qgis_app):
    table = PlacesTable()
    table.setLayoutDirection(Qt.LayoutDirection.RightToLeft)
    table.resize(300, 200)
    table.show()
    font = table.font()
    font.setPointSizeF(2 * font.pointSizeF())
    table.setFont(font)
    for number in range(3):
        table.add(PlaceRow(number, "error", ["overlap", "two claim it", "1.0"]))
    QApplication.processEvents()
    assert table.rowHeight(2) >= 2 * table.fontMetrics().lineSpacing()
    table.selectRow(1)
    assert table.selected_row() == 1
    table.deleteLater()


SQUARES = ("550000 5420000 550020 5420020", "550015 5420000 550040 5420020", "550060 5420000 550080 5420020")
BOW_TIE = "MULTIPOLYGON(((550100 5420000, 550120 5420020, 550120 5420000, 550100 5420020, 550100 5420000)))"


@pytest.fixture
def annotation(qgis_app, tmp_path):
    """A GeoPackage of two buildings that overlap, one in order, one that crosses itself, and one without a class."""
    made = QgsVectorLayer(f"MultiPolygon?crs={CRS}&field=class:string&field=note:string", "cover", "memory")
    shapes = [QgsGeometry.fromRect(QgsRectangle(*map(float, square.split()))) for square in SQUARES]
    shapes += [QgsGeometry.fromWkt(BOW_TIE), QgsGeometry.fromRect(QgsRectangle(550200, 5420000, 550210, 5420010))]
    for number, shape in enumerate(shapes):
        feature = QgsFeature(made.fields())
        feature.setGeometry(QgsGeometry(shape))
        feature.setAttributes([None if number == 4 else ("building", "water")[number % 2], f"number {number}"])
        made.dataProvider().addFeature(feature)
    path = str(tmp_path / "cover.gpkg")
    options = QgsVectorFileWriter.SaveVectorOptions()
    QgsVectorFileWriter.writeAsVectorFormatV3(made, path, QgsProject.instance().transformContext(), options)
    layer = QgsVectorLayer(f"{path}|layername=cover", "cover", "ogr")
    QgsProject.instance().addMapLayer(layer)
    return layer


@pytest.fixture
def found(annotation, run_algorithm):
    context = QgsProcessingContext()
    checked = QgsApplication.processingRegistry().createAlgorithmById("semref:checkannotation")
    parameters = {"INPUT": annotation, "CLASS_FIELD": "class", "MINIMUM_AREA": 1, "ISSUES": "memory:"}
    results, worked = checked.run(parameters, context, QgsProcessingFeedback())
    assert worked
    layer = context.takeResultLayer(results["ISSUES"])
    QgsProject.instance().addMapLayer(layer)
    return layer


def shapes(layer) -> list:
    return sorted((f["note"], str(f["class"]), f.geometry().asWkt(1)) for f in layer.getFeatures())


def press_repair(tab, monkeypatch, answer: str) -> list[str]:
    asked = []
    answered = getattr(QMessageBox.StandardButton, answer)
    monkeypatch.setattr(QMessageBox, "question", lambda *said: asked.append(said[2]) or answered)
    tab.repair.click()
    wait_until(lambda: not tab.repair.run.running, "the repair")
    settle()
    return asked


def test_repair_all_edits_the_annotation_in_one_step_that_can_be_undone(dock, annotation, found, monkeypatch):
    tab = dock.content.correct
    settle()
    before = shapes(annotation)
    tab.layer.setLayer(found)
    tab.kind.setCurrentIndex(0)
    kinds = sorted(feature["kind"] for feature in found.getFeatures())
    assert kinds == ["invalid", "no_class", "overlap"]
    assert tab.repair.text() == "Repair all (2)…"
    (question,) = press_repair(tab, monkeypatch, "No")
    assert "Repair 2 places in “cover” (invalid geometry: 1, overlap: 1)?" in question and not annotation.isEditable()
    press_repair(tab, monkeypatch, "Yes")
    after = shapes(annotation)
    assert annotation.isEditable() and annotation.undoStack().count() == 1
    assert "1 added" in tab.text.text() and "0 removed" in tab.text.text() and "Ctrl+Z" in tab.text.text()
    assert {note for note, *_ in set(before) & set(after)} >= {"number 2", "number 4"}
    assert all(f.geometry().isGeosValid() for f in annotation.getFeatures())
    total = sum(f.geometry().area() for f in annotation.getFeatures())
    assert total == pytest.approx(40 * 20 + 20 * 20 + 200 + 100)
    assert listed(tab) == ["no class"] and tab.repair.text() == "Repair all…" and not tab.repair.isEnabled()
    annotation.undoStack().undo()
    assert shapes(annotation) == before
    assert sorted(listed(tab)) == ["invalid geometry", "no class", "overlap"] and tab.text.text() == ""
    annotation.undoStack().redo()
    assert annotation.commitChanges() and shapes(annotation) == after
    assert listed(tab) == ["no class"]


def test_a_layer_that_can_t_be_edited_is_reported_and_not_repaired(dock, iface, annotation, found, monkeypatch):
    settle()
    annotation.setReadOnly(True)
    dock.content.correct.layer.setLayer(found)
    press_repair(dock.content.correct, monkeypatch, "Yes")
    assert ["The layer cover cannot be edited" in text for text in messages(iface)] == [True]


@pytest.fixture
def repairing(dock, annotation, found, monkeypatch):
    """The tab while it repairs the land-cover layer, which is in edit mode."""
    settle()
    annotation.startEditing()
    dock.content.correct.layer.setLayer(found)
    monkeypatch.setattr(QMessageBox, "question", lambda *_: QMessageBox.StandardButton.Yes)
    dock.content.correct.repair.click()
    assert dock.content.correct.repair.run.running
    return dock.content.correct


def end_of_repair(tab) -> None:
    wait_until(lambda: not tab.repair.run.running, "the end of the repair")
    settle()


def test_a_polygon_that_is_drawn_during_a_repair_stays(repairing, annotation):
    drawn = QgsFeature(annotation.fields())
    drawn.setAttributes([None, "building", "new"])
    drawn.setGeometry(QgsGeometry.fromRect(QgsRectangle(551000, 5420000, 551010, 5420010)))
    annotation.addFeature(drawn)
    edited = shapes(annotation)
    end_of_repair(repairing)
    assert shapes(annotation) == edited and "new" in {note for note, *_ in edited}
    assert "“cover” was edited during the repair" in repairing.text.text()


def test_a_land_cover_layer_may_be_removed_during_its_repair(repairing, annotation):
    QgsProject.instance().removeMapLayer(annotation.id())
    end_of_repair(repairing)
    assert repairing.text.text() == "Canceled." and repairing.repair.text() == "Repair all (2)…"


def test_removing_the_places_cancels_their_repair(repairing, annotation, found):
    before = shapes(annotation)
    QgsProject.instance().removeMapLayer(found.id())
    end_of_repair(repairing)
    assert shapes(annotation) == before and repairing.repair.text() == "Repair all…"


def test_places_are_listed_by_kind_with_their_number(dock, issues):
    tab = dock.content.correct
    second = QgsFeature(next(issues.getFeatures()))
    issues.dataProvider().addFeature(second)
    tab.layer.setLayer(None)
    tab.layer.setLayer(issues)
    offered = [tab.kind.itemText(row) for row in range(tab.kind.count())]
    assert offered == ["All kinds (4)", "overlap (2)", "gap between neighbors (1)", "sliver (1)"]
    tab.kind.setCurrentIndex(1)
    tab.kind.activated.emit(1)
    assert listed(tab) == ["overlap", "overlap"] and tab.progress.text() == "0 of 2 done"
    tab.places.selectRow(0)
    tab.done.click()
    assert listed(tab) == ["overlap"] and tab.kind.currentData() == "overlap"


def test_places_of_one_kind_differ_by_size_and_position(dock):
    fields = {"annotated_class": "string", "predicted_class": "string", "area": "double"}
    rows = [((550000 + 50 * number, 0, 10, 10), "building", "other", 100.0) for number in range(22)]
    rectangles("disagreements", fields, rows)
    places = dock.content.correct.places
    rows = {tuple(places.item(row, column).text() for column in (1, 2)) for row in range(places.rowCount())}
    assert len(rows) == 22
    assert dock.content.correct.kind.itemText(1) == "building → other (22)"
