from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from made_inputs import read_pixels, square, write_layer, write_text
from osgeo import ogr
from qgis.core import QgsRasterLayer
from qgis.PyQt.QtGui import QColor
from rasterized import category_names, stored_table, styled_layer

from semref.processing.layers import annotation


def test_ground_without_a_polygon_is_transparent_in_any_program(rasterize, tmp_path, classes_csv):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 4), "building"), (square(12, 0, 4), "water")])
    made = QgsRasterLayer(rasterize(layer, CLASS_TABLE=classes_csv)["OUTPUT"], "map")
    drawn = made.renderer().block(1, made.extent(), made.width(), made.height())
    alphas = [QColor.fromRgba(drawn.color(drawn.height() // 2, column)).alpha() for column in range(made.width())]
    assert alphas == [255] * 4 + [0] * 8 + [255] * 4


def test_a_class_table_gives_values_to_text_in_any_case_and_is_written_into_the_map(rasterize, tmp_path, classes_csv):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 4), "Building"), (square(4, 0, 4), " water ")])
    results = rasterize(layer, CLASS_TABLE=classes_csv)
    np.testing.assert_array_equal(read_pixels(results["OUTPUT"])[0], [1] * 4 + [2] * 4)
    assert results["CLASS_COUNT"] == 2
    assert "1,building,#d62728,reference" in stored_table(results["OUTPUT"])
    assert "4,field,#2ca02c,background" in stored_table(results["OUTPUT"])


def test_without_table_and_style_text_classes_are_numbered_by_name_and_numbers_stay(rasterize, labels, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 4), "water"), (square(4, 0, 4), "building")])
    results = rasterize(layer)
    np.testing.assert_array_equal(read_pixels(results["OUTPUT"])[0], [2] * 4 + [1] * 4)
    assert category_names(results["OUTPUT"]) == ["unlabeled", "building", "water"]
    layer = write_layer(tmp_path / "b.gpkg", [(square(0, 0, 4), 7), (square(4, 0, 4), 200)], [("class", "integer")])
    np.testing.assert_array_equal(labels(layer)[0], [7] * 4 + [200] * 4)


def test_a_categorized_style_gives_values_labels_and_colors_below_a_table(rasterize, labels, tmp_path, classes_csv):
    path = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 4), "w"), (square(4, 0, 4), "b")])
    results = rasterize(styled_layer(path, [("b", "Buildings", "#ff0000"), ("w", "Water", "#0000ff")]))
    np.testing.assert_array_equal(read_pixels(results["OUTPUT"])[0], [2] * 4 + [1] * 4)
    table = stored_table(results["OUTPUT"])
    assert "1,Buildings,#ff0000" in table and "2,Water,#0000ff" in table
    layer = styled_layer(
        write_layer(tmp_path / "b.gpkg", [(square(0, 0, 4), "water")]), [("water", "Wasser", "#0000ff")]
    )
    assert (labels(layer, CLASS_TABLE=classes_csv) == 2).all()


def test_other_values_of_a_style_stay_unlabeled_with_a_note(labels, tmp_path, feedback):
    path = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 4), "w"), (square(4, 0, 4), "unknown")])
    made = labels(styled_layer(path, [("w", "Water", "#0000ff"), ("", "all other values", "#cccccc")]))
    np.testing.assert_array_equal(made[0], [1] * 4)
    assert "Left unlabeled, no category in the layer's style: 1 feature." in feedback.textLog()


NAMES = ["Grünland", "reka č", "šuma"]


def shapefile_in(encoding: str, folder: Path, cpg: str = "", code_page: int = 0) -> Path:
    """Write a shapefile with NAMES as classes; a .cpg file or a code-page byte states its ``encoding``."""
    features = [(square(10 * n, 0, 10), f"name_{n}" + " " * 20) for n in range(len(NAMES))]
    layer = write_layer(folder / "a.shp", features, geometry=ogr.wkbPolygon)
    table = (folder / "a.dbf").read_bytes()
    for n, name in enumerate(NAMES):
        encoded = name.encode(encoding).ljust(12)
        table = table.replace(f"name_{n}".encode().ljust(12), encoded)
    (folder / "a.dbf").write_bytes(table[:29] + bytes([code_page]) + table[30:])
    (folder / "a.cpg").unlink(missing_ok=True)
    if cpg:
        (folder / "a.cpg").write_text(cpg)
    return layer


@pytest.mark.parametrize(
    ("encoding", "cpg"),
    [("cp1250", "1250"), ("cp1250", "CP1250"), ("cp1250", ""), ("iso8859-2", "ISO-8859-2"), ("utf-8", "UTF-8")],
)
def test_names_in_a_shapefile_with_a_known_encoding_survive(rasterize, tmp_path, encoding, cpg):
    output = rasterize(shapefile_in(encoding, tmp_path, cpg, code_page=0 if cpg else 0xC8))["OUTPUT"]
    assert category_names(output)[1:] == NAMES
    assert [line.split(",")[1] for line in stored_table(output).splitlines()[1:]] == NAMES


TWO = [(square(0, 0, 4), "building"), (square(12, 0, 4), "building")]


@pytest.mark.parametrize("asked", [{"OTHER_GROUND": True}, {}])
def test_ground_around_a_single_class_becomes_other_also_without_being_asked(rasterize, tmp_path, feedback, asked):
    results = rasterize(write_layer(tmp_path / "a.gpkg", TWO), **asked)
    np.testing.assert_array_equal(read_pixels(results["OUTPUT"])[0], [1] * 4 + [2] * 8 + [1] * 4)
    assert category_names(results["OUTPUT"])[1:3] == ["building", "other"] and results["LABELED_FRACTION"] == 1
    assert asked or "Ground without a polygon becomes class “other”" in feedback.textLog()


def test_ground_beyond_the_polygons_stays_unlabeled(rasterize, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", TWO)
    alone, wide = rasterize(layer, OTHER_GROUND=True)["OUTPUT"], tmp_path / "wide.tif"
    source = ogr.Open(str(layer))
    left, _, _, top = source.GetLayer(0).GetExtent()
    extent = f"{left - 3},{left + 16},{top - 4},{top}"
    results = rasterize(layer, OTHER_GROUND=True, EXTENT=extent, OUTPUT=str(wide))
    np.testing.assert_array_equal(read_pixels(results["OUTPUT"])[0], [0] * 3 + list(read_pixels(alone)[0]))


def test_the_map_of_such_a_table_is_made_again_without_being_asked(rasterize, tmp_path):
    """So a corrected annotation keeps it: it is rasterized with the table of the database."""
    first = rasterize(write_layer(tmp_path / "a.gpkg", TWO), OTHER_GROUND=True)["OUTPUT"]
    table = write_text(tmp_path / "again.csv", stored_table(first))
    corrected = write_layer(tmp_path / "b.gpkg", [*TWO, (square(5, 0, 4), "building")])
    again = rasterize(corrected, CLASS_TABLE=str(table), OUTPUT=str(tmp_path / "again.tif"))["OUTPUT"]
    np.testing.assert_array_equal(read_pixels(again)[0], [1] * 4 + [2] + [1] * 4 + [2] * 3 + [1] * 4)


def test_changes_of_features_are_in_the_users_language(qgis_app, monkeypatch):
    monkeypatch.setattr(annotation, "tr", lambda text: f"«{text}»")
    numbers = {field.name: 2 for field in fields(annotation.AnnotationCounts) if field.type == "int"}
    said = annotation.AnnotationCounts(**numbers).sentences()
    # Repaired parts and features of several parts are counted with the others.
    assert len(said) == len(numbers) - 2
    assert all(sentence.startswith("«") and "«2 features»" in sentence for _, sentence in said)
