"""Columns of a database have titles: translated in QGIS, and in the file for other programs."""

import pytest
from osgeo import gdal, ogr
from qgis.core import QgsProject, QgsVectorLayer

from semref.processing.layers import styles
from semref.processing.layers.database_layers import add_database_to_map

COLUMNS = {
    "windows": {"name": "Name", "size": "Size (m)", "reference_count": "Landmarks", "vector": "Topology vector"},
    "references": {"class": "Class value", "class_name": "Class", "area": "Area (m²)"},
}


def titles_of(layer: QgsVectorLayer) -> dict[str, str]:
    return {field.name(): layer.attributeAlias(index) for index, field in enumerate(layer.fields())}


@pytest.mark.parametrize("table", COLUMNS)
def test_a_layer_that_is_dropped_on_the_canvas_shows_titles_of_all_columns(database, table):
    layer = QgsVectorLayer(f"{database}|layername={table}", table, "ogr")
    found = titles_of(layer)
    assert found.pop("fid") == ""
    assert all(found.values()) and found.items() >= COLUMNS[table].items()


def test_on_the_map_titles_are_in_the_user_s_language(database, monkeypatch):
    monkeypatch.setattr(styles, "tr", lambda text: f"[{text}]")
    project = QgsProject()
    group = add_database_to_map(database, project)
    layers = {node.name(): node.layer() for node in group.findLayers()}
    assert titles_of(layers["Landmarks"])["area"] == "[Area (m²)]"
    assert titles_of(layers["Windows"])["reference_count"] == "[Landmarks]"


def test_any_program_finds_them_in_the_geopackage_by_its_own_rules(query):
    rows = query("SELECT table_name, column_name, name, title FROM gpkg_data_columns")
    for table, titles in COLUMNS.items():
        found = {column: name for one, column, name, _ in rows if one == table}
        assert found.items() >= titles.items()
        # All columns but the key and the geometry.
        assert {name for (name,) in query(f"SELECT name FROM pragma_table_info('{table}')")} - set(found) == {
            "fid",
            "geom",
        }
    assert all(name == title for *_, name, title in rows)
    registered = query("SELECT table_name FROM gpkg_extensions WHERE extension_name = 'gpkg_schema' ORDER BY 1")
    assert registered == [("gpkg_data_column_constraints",), ("gpkg_data_columns",)]


@pytest.mark.skipif(int(gdal.VersionInfo()) < 3_070_000, reason="GDAL reads them from 3.7 on")
def test_gdal_shows_titles_as_alternative_names(database):
    dataset = ogr.Open(database)
    found = {one.GetName(): one.GetAlternativeName() for one in dataset.GetLayerByName("windows").schema}
    # GDAL ignores a title that differs from the column's name only by capitals.
    titles = {name: title for name, title in COLUMNS["windows"].items() if title.lower() != name}
    assert found.items() >= titles.items() and len(titles) == 3
