import contextlib
import sqlite3
import threading
from pathlib import Path

import pytest
from dock_area import CRS, ORIGIN, logged, messages, rectangles, settle, wait_until
from qgis.core import QgsGeometry, QgsMapRendererSequentialJob, QgsMapSettings, QgsProject, QgsRasterLayer, QgsRectangle
from qgis.PyQt.QtCore import QSize
from qgis.PyQt.QtWidgets import QDialog, QPushButton

from semref.storage.database import undo
from semref.ui.running import correction_run
from semref.ui.running.algorithm_run import AlgorithmRun

SIDE, ACROSS = 20, 6
"""Meters from square to square, and squares along an edge."""


@pytest.fixture
def annotation(qgis_app, tmp_path):
    """A GeoPackage layer of squares of two classes."""
    rows = []
    for number in range(ACROSS * ACROSS):
        left, top = ORIGIN[0] + SIDE * (number % ACROSS) + 3, ORIGIN[1] - SIDE * (number // ACROSS) - 3
        size = 8 + number % 5
        rows.append(((left, top - size, size, size), ("building", "water")[number % 2], 1))
    return rectangles("cover", {"class": "string", "zorder": "integer"}, rows, str(tmp_path / "cover.gpkg"))


@pytest.fixture
def database(annotation, run_algorithm, tmp_path):
    return built_of(annotation, run_algorithm, tmp_path, "area")


def built_of(annotation, run_algorithm, folder: Path, name: str) -> str:
    table = folder / "classes.csv"
    table.write_text("value,name,color,role\n1,building,#ff0000,reference\n2,water,#0000ff,reference\n")
    rasterized = {"INPUT": annotation, "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder", "CLASS_TABLE": str(table)}
    extent = f"{ORIGIN[0]},{ORIGIN[0] + SIDE * ACROSS},{ORIGIN[1] - SIDE * ACROSS},{ORIGIN[1]} [{CRS}]"
    labels = str(folder / f"{name}.tif")
    run_algorithm("semref:rasterizeannotation", {**rasterized, "EXTENT": extent, "PIXEL_SIZE": 0.5, "OUTPUT": labels})
    path = str(folder / f"{name}.gpkg")
    sizes = {"WINDOW_SIZE": 60, "STRIDE": 30, "MINIMUM_AREA": 10}
    run_algorithm("semref:builddatabase", {"LABELS": labels, **sizes, "DATABASE": path})
    return path


def landmarks(path: str) -> list:
    with contextlib.closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as connection:
        rows = connection.execute('SELECT class, round(area, 3), geom FROM "references"').fetchall()
    return sorted(rows)


@pytest.fixture
def box(dock, annotation, database):
    """The lower part of the tab, ready."""
    dock.content.database.file.setFilePath(database)
    settle()
    return dock.content.correct.updating


def correct(annotation) -> None:
    """Two squares become water: one saved, one as it is while somebody edits."""
    for number, is_saved in ((1, True), (3, False)):
        annotation.startEditing()
        annotation.changeAttributeValue(number, annotation.fields().indexOf("class"), "water")
        if is_saved:
            annotation.commitChanges()


def press(dock, box) -> None:
    box.button.click()
    wait_until(lambda: not dock.content.correct.updating.run.running, "the update")
    settle()


@pytest.mark.slow
def test_one_button_makes_the_database_of_a_full_build(dock, iface, box, annotation, database, run_algorithm, tmp_path):
    before = landmarks(database)
    assert box.annotation.currentLayer().id() == annotation.id()
    assert (box.class_field.currentField(), box.priority_field.currentField()) == ("class", "zorder")
    assert box.button.isEnabled() and not box.undo.isVisibleTo(dock)
    dock.content.database.add_to_map.click()
    correct(annotation)
    press(dock, box)
    assert messages(iface) == []
    annotation.commitChanges()
    assert landmarks(database) == landmarks(built_of(annotation, run_algorithm, tmp_path, "rebuilt")) != before
    assert "up to date" in box.state.text_shown
    names = [layer.name() for layer in QgsProject.instance().mapLayers().values()]
    assert sorted(names) == ["Landmarks", "Overview", "Windows", "cover"]
    shown = [f["class"] for f in QgsProject.instance().mapLayersByName("Landmarks")[0].getFeatures()]
    assert sorted(shown) == sorted(row[0] for row in landmarks(database))


def test_the_next_update_rasterizes_only_what_changed(dock, iface, box, annotation, database, run_algorithm, tmp_path):
    run, extents = dock.content.correct.updating.run, []
    start = run._run.start_algorithm
    run._run.start_algorithm = lambda name, what, title: extents.append(what.get("EXTENT")) or start(name, what, title)
    correct(annotation)
    press(dock, box)
    assert "CHANGED" not in run.asked
    annotation.commitChanges()
    annotation.startEditing()
    left, top = ORIGIN[0] + 30, ORIGIN[1] - 50
    annotation.changeGeometry(8, QgsGeometry.fromRect(QgsRectangle(left, top - 14, left + 10, top)))
    annotation.deleteFeature(15)
    press(dock, box)
    assert messages(iface) == [] and "CHANGED" in run.asked and run.asked["CHANGED"].featureCount() == 3
    assert extents[2].width() < extents[0].width() / 2 and extents[2].height() < extents[0].height()
    annotation.commitChanges()
    assert landmarks(database) == landmarks(built_of(annotation, run_algorithm, tmp_path, "rebuilt"))
    box.undo.click()
    wait_until(lambda: not box.undo.isVisibleTo(dock.content.correct), "the undo")
    press(dock, box)
    assert "CHANGED" not in run.asked
    assert landmarks(database) == landmarks(str(tmp_path / "rebuilt.gpkg"))


def test_a_bug_between_the_steps_of_an_update_ends_it_and_is_reported(dock, box, database, monkeypatch):
    monkeypatch.setattr(correction_run.CorrectionRun, "_beside", lambda self, database: {}["nothing"])
    before = Path(database).read_bytes()
    with logged() as reports:
        press(dock, box)
    assert len(reports) == 1 and "KeyError" in reports[0]
    assert box.button.text() == "Rasterize and update the database"
    assert Path(database).read_bytes() == before


def test_an_annotation_of_elsewhere_is_refused_and_nothing_is_written(dock, iface, box, annotation, database):
    other = rectangles("another country", {"class": "string"}, [((0, 0, 10, 10), None)])
    settle()
    before = Path(database).read_bytes()
    box.annotation.setLayer(other)
    press(dock, box)
    wait_until(lambda: messages(iface), "the refusal")
    assert "“another country” does not overlap the map of area.gpkg" in messages(iface)[0]
    assert Path(database).read_bytes() == before and not box.undo.isVisibleTo(dock.content.correct)


def test_a_canceled_update_leaves_the_database_as_it_is(dock, box, annotation, database):
    before = Path(database).read_bytes()
    correct(annotation)
    box.button.click()
    assert box.button.text() == "Cancel"
    box.button.click()
    wait_until(lambda: not dock.content.correct.updating.run.running, "the cancel")
    settle()
    assert Path(database).read_bytes() == before
    assert box.state.text_shown == "Canceled." and box.button.isEnabled()


def test_a_land_cover_layer_may_be_removed_while_it_is_rasterized(dock, iface, box, annotation, database):
    QgsProject.instance().addMapLayer(QgsRasterLayer(database.replace(".gpkg", ".tif"), "Label map"))
    correct(annotation)
    removed = annotation.id()
    project = QgsProject.instance()
    box.run.textChanged.connect(lambda text: text == "Rasterizing polygons" and project.removeMapLayer(removed))
    press(dock, box)
    assert QgsProject.instance().mapLayer(removed) is None
    # Without the layer, the label map cannot be rasterized again.
    assert messages(iface) == [] and "up to date" in box.state.text_shown


def test_an_update_whose_layer_is_removed_before_it_is_read_states_that(dock, iface, box, annotation, database):
    box.button.click()
    QgsProject.instance().removeMapLayer(annotation.id())
    with logged() as reports:
        wait_until(lambda: not box.run.running, "the update")
        settle()
    assert ["for “Land-cover layer”: " in message for message in messages(iface)] == [True] and reports == []


def test_it_is_too_late_to_cancel_while_the_database_is_replaced(dock, box, annotation, database, monkeypatch):
    begun, go_on, replace = threading.Event(), threading.Event(), undo.replace_keeping

    def replace_slowly(*given):
        begun.set()
        go_on.wait(10)
        return replace(*given)

    monkeypatch.setattr(undo, "replace_keeping", replace_slowly)
    before = landmarks(database)
    correct(annotation)
    box.button.click()
    wait_until(begun.is_set, "the last step")
    box.button.click()
    go_on.set()
    wait_until(lambda: not box.run.running, "the update")
    settle()
    assert landmarks(database) != before and "up to date" in box.state.text_shown


def test_layers_of_databases_and_of_places_are_no_annotation(dock, box, annotation, issues):
    dock.content.database.add_to_map.click()
    settle()
    offered = [box.annotation.layer(row) for row in range(box.annotation.count())]
    assert [layer for layer in offered if layer is not None] == [annotation]


def drawn(layer) -> bytes:
    """The layer's own extent as the map shows it."""
    settings = QgsMapSettings()
    settings.setLayers([layer])
    settings.setDestinationCrs(layer.crs())
    settings.setExtent(layer.extent())
    settings.setOutputSize(QSize(120, 120))
    job = QgsMapRendererSequentialJob(settings)
    job.start()
    job.waitForFinished()
    image = job.renderedImage()
    bits = image.constBits()
    bits.setsize(image.sizeInBytes())
    return bytes(bits)


@pytest.mark.slow
def test_an_update_and_its_undo_by_one_button_are_shown_on_the_map(dock, box, annotation, database):
    dock.content.database.add_to_map.click()
    (overview,) = QgsProject.instance().mapLayersByName("Overview")
    before, repainted, rows = drawn(overview), [], landmarks(database)
    overview.repaintRequested.connect(lambda *_: repainted.append(True))
    correct(annotation)
    press(dock, box)
    after = drawn(overview)
    assert after != before and repainted and landmarks(database) != rows
    assert landmarks(database.replace(".gpkg", "_before_update.gpkg")) == rows
    box.undo.click()
    wait_until(lambda: not box.undo.isVisibleTo(dock.content.correct), "the undo")
    settle()
    assert drawn(overview) == before and landmarks(database) == rows
    assert sorted(p.name for p in Path(database).parent.glob("area*.gpkg")) == ["area.gpkg"]


def test_the_map_shows_a_label_map_that_was_rasterized_again(dock, annotation, run_algorithm, tmp_path):
    built_of(annotation, run_algorithm, tmp_path, "area")
    path = str(tmp_path / "area.tif")
    layer = QgsRasterLayer(path, "Label map")
    QgsProject.instance().addMapLayer(layer)
    before, repainted = drawn(layer), []
    layer.repaintRequested.connect(lambda *_: repainted.append(True))
    correct(annotation)
    extent = f"{ORIGIN[0]},{ORIGIN[0] + SIDE * ACROSS},{ORIGIN[1] - SIDE * ACROSS},{ORIGIN[1]} [{CRS}]"
    again = {"INPUT": annotation, "CLASS_FIELD": "class", "CLASS_TABLE": str(tmp_path / "classes.csv")}
    again.update({"EXTENT": extent, "PIXEL_SIZE": 0.5, "OUTPUT": path})
    # As the toolbox does, in another thread.
    run = AlgorithmRun(dock)
    assert run.start_algorithm("semref:rasterizeannotation", again, "Rasterizing")
    wait_until(lambda: not run.running, "the label map")
    settle()
    assert drawn(layer) != before and repainted


def test_a_label_map_that_the_update_made_old_can_be_made_again(dock, iface, box, annotation, database, monkeypatch):
    import processing

    labels = database.replace(".gpkg", ".tif")
    before, asked = Path(labels).read_bytes(), []
    QgsProject.instance().addMapLayer(QgsRasterLayer(labels, "Label map"))
    monkeypatch.setattr(processing, "createAlgorithmDialog", lambda *given: asked.append(given) or QDialog())
    correct(annotation)
    press(dock, box)
    assert messages(iface) == ["The label map “Label map” is now older than the database."]
    (button,) = [b for b in iface.bar.findChildren(QPushButton) if b.text() == "Rasterize it again…"]
    button.click()
    ((name, given),) = asked
    assert name == "semref:rasterizeannotation" and Path(labels).read_bytes() == before
    assert (given["OUTPUT"], given["INPUT"], given["PIXEL_SIZE"]) == (labels, annotation.id(), 0.5)
    dock.content.correct.updating.rasterizing.close()
