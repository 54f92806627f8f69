"""Metadata of a reference database: title, history and licenses."""

import contextlib
import sqlite3
from pathlib import Path

import numpy as np
import pytest
from made_inputs import NAMES, scattered_objects, square, write_layer, write_raster
from qgis.core import QgsLayerMetadata, QgsProject, QgsProviderRegistry, QgsRasterLayer, QgsVectorLayer

from semref.processing.layers.database_layers import add_database_to_map
from semref.processing.layers.layer_metadata import Note

BUILD, UPDATE, LOCALIZE = "semref:builddatabase", "semref:updatedatabase", "semref:localizeimages"
LABELS = scattered_objects(600, 600, 300, seed=3)
TABLES = "references", "windows"
SOURCES = "Land cover of Erewhon (ODbL 1.0, © OpenStreetMap contributors)"


@pytest.fixture
def label_map(qgis_app, tmp_path) -> Path:
    """Return a label map with a license in QGIS's metadata file, like that of “Rasterize annotation”."""
    path = write_raster(tmp_path / "labels.tif", LABELS, names=NAMES)
    layer, metadata = QgsRasterLayer(str(path), "labels"), QgsLayerMetadata()
    metadata.setTitle("Land cover of Erewhon")
    metadata.setLicenses(["ODbL 1.0"])
    metadata.setRights(["© OpenStreetMap contributors"])
    layer.setMetadata(metadata)
    layer.saveNamedMetadata(str(path.with_suffix(".qmd")))
    return path


@pytest.fixture
def database(run_algorithm, label_map) -> str:
    given = {"LABELS": str(label_map), "REFERENCE_CLASSES": "building;water", "WINDOW_SIZE": 200, "STRIDE": 100}
    return run_algorithm(BUILD, {**given, "DATABASE": str(label_map.with_name("area.gpkg"))})["DATABASE"]


def notes(path: str) -> list[QgsLayerMetadata]:
    return [QgsVectorLayer(f"{path}|layername={table}", table, "ogr").metadata() for table in TABLES]


def test_both_tables_have_title_history_and_licenses(database):
    landmarks, windows = notes(database)
    assert (landmarks.title(), windows.title()) == ("Landmarks", "Windows")
    assert landmarks.abstract() != windows.abstract()
    for metadata in (landmarks, windows):
        assert metadata.rights() == [SOURCES]
        (line,) = metadata.history()
        assert "SemRef" in line and 'processing.run("semref:builddatabase"' in line and "'STRIDE':100" in line


def test_an_update_adds_itself_to_the_history_and_keeps_the_rest(database, label_map, run_algorithm):
    labels = LABELS.copy()
    labels[300:330, 300:330] = 1
    new = write_raster(label_map.with_name("new.tif"), labels, names=NAMES)
    run_algorithm(UPDATE, {"DATABASE": database, "LABELS": str(new), "OUTPUT": database})
    for metadata in notes(database):
        assert ["builddatabase" in line for line in metadata.history()] == [True, False]
        assert "updatedatabase" in metadata.history()[1]
        assert metadata.rights() == [SOURCES]


def history_after(lines: list[str]) -> list[str]:
    """Return the history of a layer with these lines after one more run."""
    metadata = QgsLayerMetadata()
    metadata.setHistory(lines)
    layer = QgsVectorLayer("Point?crs=epsg:2056", "landmarks", "memory")
    note = Note("Landmarks", history=("2026-01-02 03:04 UTC, SemRef 1: processing.run('update')",))
    return note.after(metadata).metadata(layer).history()


def test_the_history_of_many_updates_keeps_the_first_line_and_the_newest_ones(qgis_app):
    lines = ["built"]
    for number in range(120):
        lines = history_after(lines)
        assert len(lines) == (number + 2 if number < 49 else 51)
        # Each line has the number of its run.
        lines[-1] = f"update {number}"
    assert lines[:2] == ["built", "…"]
    assert lines[2:] == [f"update {number}" for number in range(71, 120)]


def test_what_is_made_of_a_database_names_its_sources_once(database, run_algorithm, tmp_path):
    image = write_raster(tmp_path / "image.png", LABELS[100:300, 100:300])
    output = str(tmp_path / "positions.gpkg")
    run_algorithm(LOCALIZE, {"DATABASE": database, "IMAGES": [str(image)], "OUTPUT": output})
    assert QgsVectorLayer(output, "positions", "ogr").metadata().rights() == [SOURCES]


def test_each_table_has_its_metadata_once_and_the_overview_has_them_on_the_map(database, label_map):
    with contextlib.closing(sqlite3.connect(database)) as connection:
        rows = connection.execute(
            "SELECT table_name, count(*) FROM gpkg_metadata_reference r JOIN gpkg_metadata m ON m.id = r.md_file_id "
            "WHERE m.md_standard_uri = 'http://mrcc.com/qgis.dtd' GROUP BY table_name ORDER BY 1"
        ).fetchall()
        texts = [text for (text,) in connection.execute("SELECT metadata FROM gpkg_metadata")]
    # GDAL would write each metadata entry again as its own.
    assert rows == [("references", 1), ("windows", 1)] and sum("builddatabase" in text for text in texts) == 2
    assert sorted(path.name for path in label_map.parent.glob("area*")) == ["area.gpkg"]
    project = QgsProject()
    (overview,) = (n.layer() for n in add_database_to_map(database, project).findLayers() if n.name() == "Overview")
    metadata = overview.metadata()
    assert (metadata.title(), metadata.rights(), len(metadata.history())) == ("Overview", [SOURCES], 1)


def test_a_damaged_note_of_an_input_costs_nothing(run_algorithm, tmp_path):
    path = write_raster(tmp_path / "labels.tif", scattered_objects(400, 400, 150, seed=4), names=NAMES)
    path.with_suffix(".qmd").write_bytes(np.random.default_rng(1).bytes(500))
    given = {"LABELS": str(path), "REFERENCE_CLASSES": "building", "WINDOW_SIZE": 200, "STRIDE": 100}
    database = run_algorithm(BUILD, {**given, "DATABASE": str(tmp_path / "area.gpkg")})["DATABASE"]
    assert [metadata.rights() for metadata in notes(database)] == [[], []]


def test_the_licenses_of_a_geopackage_layer_are_read_from_its_file(run_algorithm, tmp_path):
    features = [(square(10 + 40 * n, 10, 30), name) for n, name in enumerate(("water", "forest"))]
    path = str(write_layer(tmp_path / "annotation.gpkg", features))
    layer = QgsVectorLayer(path, "annotation", "ogr")
    metadata = QgsLayerMetadata()
    metadata.setLicenses(["CC BY 4.0"])
    layer.setMetadata(metadata)
    del layer
    QgsProviderRegistry.instance().saveLayerMetadata("ogr", f"{path}|layername=annotation", metadata)
    output = str(tmp_path / "issues.gpkg")
    run_algorithm("semref:checkannotation", {"INPUT": path, "CLASS_FIELD": "class", "ISSUES": output})
    assert QgsVectorLayer(output, "issues", "ogr").metadata().rights() == ["annotation (CC BY 4.0)"]
