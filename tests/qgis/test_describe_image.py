import json
from pathlib import Path

import numpy as np
import pytest
from made_inputs import CLASSES_CSV, NAMES, NORTH, WEST, read_rows, scattered_objects, write_raster, write_text
from osgeo import gdal

from semref.core.landmarks.landmarks import extract_landmarks

DESCRIBE = "semref:describeimage"
PIXEL = 2.0
WIDE = scattered_objects(150, 210, 60, seed=7)
"""Labels of a wide image; its centered square has the columns 30 to 180."""

SQUARE = WIDE[:, 30:180]


@pytest.fixture
def describe(run_algorithm, feedback, tmp_path):
    """`describe(image, **parameters)` returns (points as dicts with x and y, the vector file's content, results)."""
    table = str(write_text(tmp_path / "classes.csv", CLASSES_CSV))

    def run(image, **parameters):
        outputs = {"REFERENCES": str(tmp_path / "points.gpkg"), "VECTOR": str(tmp_path / "vector.json")}
        given = {"INPUT": str(image), "CLASS_TABLE": table, "MINIMUM_AREA": 40, **outputs, **parameters}
        results = run_algorithm(DESCRIBE, given, feedback)
        vector = json.loads(Path(results["VECTOR"]).read_text(encoding="utf-8")) if results["VECTOR"] else None
        points = read_rows(results["REFERENCES"])
        for row in points:
            row["x"], row["y"] = row.pop("geometry").GetPoint_2D()
        return points, vector, results

    return run


def test_temporary_points_of_an_image_without_a_crs_have_none(run_algorithm, tmp_path):
    image = write_raster(tmp_path / "image.tif", WIDE, transform=None, names=NAMES)
    table = str(write_text(tmp_path / "classes.csv", CLASSES_CSV))
    given = {"INPUT": str(image), "CLASS_TABLE": table, "MINIMUM_AREA": 40, "REFERENCES": "TEMPORARY_OUTPUT"}
    layer = run_algorithm(DESCRIBE, given)["REFERENCES"]
    assert layer.featureCount() and not layer.crs().isValid()


def expected_objects(labels: np.ndarray, minimum_area_px: float):
    return extract_landmarks(np.ascontiguousarray(labels), (1, 2, 3), minimum_area_px)


def test_points_fall_on_the_objects_of_a_georeferenced_image(describe, tmp_path):
    transform = (WEST, PIXEL, 0, NORTH, 0, -PIXEL)
    found, _, results = describe(write_raster(tmp_path / "image.tif", WIDE, transform=transform, names=NAMES))
    expected = expected_objects(SQUARE, 40 / PIXEL**2)
    assert results["REFERENCE_COUNT"] == len(found) == len(expected) > 10
    for n, row in enumerate(found):
        column, line = (row["x"] - WEST) / PIXEL, (NORTH - row["y"]) / PIXEL
        assert (column, line) == pytest.approx(expected.centers_xy[n] + (30, 0), abs=1e-6)
        assert (row["column"], row["row"]) == pytest.approx((column, line), abs=1e-6)
        assert WIDE[int(line), int(column)] == row["class"]
        assert row["class_name"] == NAMES[row["class"]]
        assert row["area"] == pytest.approx(expected.areas_px[n] * PIXEL**2)
        assert bool(row["touches_edge"]) == expected.touches_edge[n]


def test_points_of_a_turned_image_fall_on_its_objects(describe, tmp_path):
    transform = (WEST, 1.2, 0.9, NORTH, 0.9, -1.2)
    image = write_raster(tmp_path / "turned.tif", WIDE, transform=transform, names=NAMES)
    found, _, _ = describe(image)
    assert len(found) > 10
    for row in found:
        column, line = gdal.ApplyGeoTransform(gdal.InvGeoTransform(transform), row["x"], row["y"])
        assert WIDE[int(line), int(column)] == row["class"]


def test_points_of_an_image_without_georeference_are_pixels_with_y_up(describe, tmp_path):
    found, _, _ = describe(write_raster(tmp_path / "image.png", WIDE, transform=None))
    centers = expected_objects(SQUARE, 40).centers_xy + (30, 0)
    np.testing.assert_allclose([(row["x"], -row["y"]) for row in found], centers, atol=1e-6)


def test_fewer_than_three_landmarks_give_no_vector_with_a_note(describe, tmp_path, feedback):
    labels = np.full((60, 60), 4, np.uint8)
    labels[10:20, 10:20] = labels[40:50, 40:50] = 2
    found, vector, _ = describe(write_raster(tmp_path / "image.png", labels, transform=None))
    assert [(row["column"], row["row"]) for row in found] == [(15, 15), (45, 45)]
    assert vector["vector"] is None and vector["distance_ratios"] is None
    assert "fewer than three landmarks" in feedback.textLog()


def test_with_a_database_the_image_is_described_as_its_windows_are(describe, run_algorithm, tmp_path):
    labels = write_raster(tmp_path / "map.tif", WIDE, names=NAMES)
    sizes = {"WINDOW_SIZE": 150, "STRIDE": 30, "MINIMUM_AREA": 50, "REFERENCES_PER_VECTOR": 7}
    asked = {"LABELS": str(labels), "REFERENCE_CLASSES": "building;water", "DATABASE": str(tmp_path / "area.gpkg")}
    database = run_algorithm("semref:builddatabase", {**asked, **sizes})["DATABASE"]
    window = next(row for row in read_rows(database, "windows") if row["name"] == "30_0")
    image = write_raster(tmp_path / "image.png", SQUARE, transform=None)
    # The database's values override the settings.
    found, vector, _ = describe(image, DATABASE=database, CLASS_TABLE=None, MINIMUM_AREA=1)
    stored = np.frombuffer(bytes.fromhex(window["vector"]), "<f4")
    np.testing.assert_allclose(vector["vector"], stored, rtol=0, atol=1e-7)
    assert {row["class"] for row in found} == {1, 2}


def test_a_label_map_that_carries_its_classes_needs_no_table(describe, tmp_path):
    path = write_raster(tmp_path / "image.tif", WIDE)
    labels = gdal.Open(str(path), gdal.GA_Update)
    labels.SetMetadataItem("SEMREF_CLASS_TABLE", CLASSES_CSV)
    del labels
    assert len(describe(path, CLASS_TABLE=None)[0]) > 10
