import contextlib
import sqlite3
import sys
from pathlib import Path

import pytest
from built_database import LAYERS, columns_of
from full_disks import files_of_at_most
from made_inputs import METRIC_CRS
from osgeo import ogr
from qgis.core import QgsProcessingException, QgsProject, QgsRasterLayer, QgsVectorLayer

from semref.processing.layers import styles
from semref.processing.layers.database_layers import add_database_to_map


@pytest.mark.parametrize("name", LAYERS)
def test_ogr_sees_the_layers_with_their_columns_in_order(database, name):
    source = ogr.Open(database)
    layer = source.GetLayerByName(name)
    assert (layer.GetGeomType(), columns_of(layer)) == LAYERS[name]
    if layer.GetGeomType() != ogr.wkbNone:
        assert layer.GetSpatialRef().GetAuthorityCode(None) == str(METRIC_CRS)


def test_no_file_of_sqlite_stays_beside_the_database(database):
    assert [path.name for path in Path(database).parent.iterdir()] == ["area.gpkg"]
    with contextlib.closing(sqlite3.connect(f"file:{database}?mode=ro", uri=True)) as connection:
        assert connection.execute("PRAGMA journal_mode").fetchone() == ("delete",)
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)


def test_layers_open_as_outlines_by_class_name_and_colored_by_class(database, query):
    windows, references = (QgsVectorLayer(f"{database}|layername={n}", n, "ogr") for n in ("windows", "references"))
    assert windows.renderer().symbol().symbolLayer(0).properties()["style"] == "no"
    shown = references.renderer()
    assert shown.type() == "categorizedSymbol" and shown.classAttribute() == "class"
    labels = [(int(c.value()), c.label()) for c in shown.categories()]
    assert labels == [(1, "building"), (2, "water"), (3, "bare_land")]
    overview = QgsRasterLayer(f"GPKG:{database}:overview", "overview")
    colors = {int(entry.value): entry.color.name() for entry in overview.renderer().classes()}
    assert colors.items() >= dict(query("SELECT value, color FROM classes")).items()


def _rows(path) -> dict[str, int]:
    with contextlib.closing(sqlite3.connect(path)) as connection:
        tables = connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'").fetchall()
        return {name: connection.execute(f'SELECT count(*) FROM "{name}"').fetchone()[0] for (name,) in tables}


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="limits on files as Unix has them")
def test_a_disk_that_is_full_at_the_last_pages_is_reported(build, label_map, database, tmp_path):
    """GDAL writes its last tables when it closes a file; failures there were not reported."""
    size = Path(database).stat().st_size
    for lacking in range(-4096, 7 * 4096, 4096):
        target = tmp_path / f"{lacking}.gpkg"
        with contextlib.suppress(QgsProcessingException):
            with files_of_at_most(size - lacking):
                build(label_map, DATABASE=str(target))
            assert _rows(target) == _rows(database)
    assert not list(tmp_path.glob("*.gpkg*"))[2:], "most of these had no room"


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
        columns = {name for (name,) in query(f"SELECT name FROM pragma_table_info('{table}')")}
        assert columns - set(found) == {"fid", "geom"}
    assert all(name == title for *_, name, title in rows)
    registered = query("SELECT table_name FROM gpkg_extensions WHERE extension_name = 'gpkg_schema' ORDER BY 1")
    assert registered == [("gpkg_data_column_constraints",), ("gpkg_data_columns",)]
