"""Which pixels polygons burn, in which order, and what happens to messy geometry."""

import numpy as np
import pytest
from made_inputs import NORTH, WEST, polygon, ring, square, write_layer
from osgeo import gdal, ogr

from semref.storage import rasterize


def random_polygons(seed: int, count: int, size: float):
    random = np.random.default_rng(seed)
    for _ in range(count):
        center = random.uniform(0, size, 2)
        angles = np.sort(random.uniform(0, 2 * np.pi, random.integers(3, 9)))
        radii = random.uniform(2, size / 4, len(angles))
        corners = center + np.column_stack([np.cos(angles), np.sin(angles)]) * radii[:, None]
        yield corners.tolist()


@pytest.mark.parametrize("pixel_size", [0.7, 1.0, 3.0])
def test_valid_polygons_burn_as_gdal_burns_them_on_the_tap_grid(labels, tmp_path, pixel_size):
    features = [(polygon(corners), n % 5 + 1) for n, corners in enumerate(random_polygons(1, 60, 200))]
    features = [f for f in features if ogr.CreateGeometryFromWkt(f[0]).IsValid()]
    layer = write_layer(tmp_path / "annotation.gpkg", features, [("class", "integer")])
    made = labels(layer, PIXEL_SIZE=pixel_size)
    options = gdal.RasterizeOptions(
        attribute="class", xRes=pixel_size, yRes=pixel_size, targetAlignedPixels=True, outputType=gdal.GDT_Byte
    )
    gdal.Rasterize(str(tmp_path / "gdal.tif"), str(layer), options=options)
    expected = gdal.Open(str(tmp_path / "gdal.tif"))
    transform = gdal.Open(str(tmp_path / "labels.tif")).GetGeoTransform()
    assert len(features) > 40
    np.testing.assert_allclose(transform, expected.GetGeoTransform(), rtol=0, atol=1e-6)
    np.testing.assert_array_equal(made, expected.ReadAsArray())


def test_a_map_of_several_strips_equals_one_burnt_at_once(labels, tmp_path, monkeypatch):
    features = [(polygon(corners), n % 5 + 1) for n, corners in enumerate(random_polygons(2, 60, 700))]
    layer = write_layer(tmp_path / "annotation.gpkg", features, [("class", "integer")])
    at_once = labels(layer)
    monkeypatch.setattr(rasterize, "STRIP_PIXELS", 1)
    strips = labels(layer, OUTPUT=str(tmp_path / "strips.tif"))
    assert len(strips) > 2 * 256
    np.testing.assert_array_equal(strips, at_once)


def test_the_higher_priority_is_on_top_and_ties_keep_feature_order(labels, tmp_path, classes_csv):
    layer = write_layer(
        tmp_path / "a.gpkg",
        [
            (square(0, 0, 4), "building", 2.5),
            (square(1, 0, 4), "water", -3),
            (square(2, 0, 4), "field", None),
            (square(3, 0, 4), "bare_land", 2.5),
        ],
        [("class", "text"), ("zorder", "real")],
    )
    made = labels(layer, CLASS_TABLE=classes_csv, PRIORITY_FIELD="zorder")
    np.testing.assert_array_equal(made[0], [1, 1, 1, 3, 3, 3, 3])


def test_holes_stay_unlabeled_and_overlapping_parts_of_one_multipolygon_are_one_area(labels, tmp_path, feedback):
    outer = [(0, 0), (10, 0), (10, 10), (0, 10)]
    inner = [(3, 3), (6, 3), (6, 6), (3, 6)]
    shapes = [(f"POLYGON ({ring(outer)}, {ring(inner)})", "field"), (square(10, 0, 10), "water")]
    made = labels(write_layer(tmp_path / "a.gpkg", shapes))
    assert (made == 0).sum() == 9 and (made[3:6, 3:6] == 0).all()
    parts = ", ".join(f"({ring([(x, 0), (x + 6, 0), (x + 6, 6), (x, 6)])})" for x in (0, 3))
    made = labels(write_layer(tmp_path / "b.gpkg", [(f"MULTIPOLYGON ({parts})", "field")]))
    np.testing.assert_array_equal(made, np.ones((6, 9)))
    assert "Used: 1 feature, 1 of them multipart." in feedback.textLog()


def test_a_bow_tie_is_repaired_to_both_its_wings_and_counted(labels, tmp_path, feedback):
    bow_tie = polygon([(0, 0), (20, 20), (20, 0), (0, 20)])
    made = labels(write_layer(tmp_path / "a.gpkg", [(bow_tie, "field")]))
    assert made[10, 1] == made[10, 18] == 1
    assert made[1, 10] == made[18, 10] == 2  # other
    assert "Repaired invalid geometry: 1 feature" in feedback.textLog()


@pytest.mark.parametrize(
    ("skipped", "message"),
    [
        ([("POLYGON EMPTY", "field"), (None, "field")], "Skipped, without geometry: 2 features."),
        ([(polygon([(2, 2), (8, 8), (5, 5)]), "field")], "Skipped, without area: 1 feature."),
        ([(square(2, 2, 3), None), (square(6, 6, 3), "  ")], "Skipped, class is NULL: 2 features."),
    ],
)
def test_polygons_without_shape_area_or_class_are_skipped_and_counted(labels, tmp_path, feedback, skipped, message):
    made = labels(write_layer(tmp_path / "a.gpkg", [(square(0, 0, 10), "field"), *skipped]))
    assert (made == 1).all() and message in feedback.textLog() and "Used: 1 feature" in feedback.textLog()


def test_heights_are_left_out_and_counted(labels, tmp_path, feedback):
    flat, solid = square(0, 0, 10), "POLYGON Z " + square(2, 2, 4)[8:].replace(",", " 7,").replace("))", " 7))")
    layer = write_layer(tmp_path / "a.gpkg", [(flat, "a"), (solid, "b")])
    assert ogr.CreateGeometryFromWkt(solid).Is3D()
    made = labels(layer)
    assert (made[2:6, 2:6] == 2).all()
    assert (made == 2).sum() == 16
    assert "Heights (Z) left out: 1 feature." in feedback.textLog()


def test_curved_polygons_are_burnt_with_their_arcs(labels, tmp_path):
    around = [(50, 0), (100, 50), (50, 100), (0, 50), (50, 0)]
    arcs = ", ".join(f"{WEST + x} {NORTH - y}" for x, y in around)
    circle = f"CURVEPOLYGON (CIRCULARSTRING ({arcs}))"
    made = labels(write_layer(tmp_path / "a.gpkg", [(circle, "water")], geometry=ogr.wkbCurvePolygon))
    assert (made == 1).sum() == pytest.approx(np.pi * 50**2, rel=0.005)
