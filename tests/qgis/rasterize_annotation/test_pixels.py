import numpy as np
import pytest
from made_inputs import NAMES, NORTH, WEST, polygon, read_pixels, rectangle, ring, square, write_layer
from osgeo import gdal, ogr
from qgis.core import QgsProcessingFeatureSourceDefinition, QgsRasterLayer, QgsVectorLayer

from semref.processing.layers.annotation import request_of
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
    outer, inner = [(0, 0), (10, 0), (10, 10), (0, 10)], [(3, 3), (6, 3), (6, 6), (3, 6)]
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
    assert ogr.CreateGeometryFromWkt(solid).Is3D()
    made = labels(write_layer(tmp_path / "a.gpkg", [(flat, "a"), (solid, "b")]))
    assert (made[2:6, 2:6] == 2).all() and (made == 2).sum() == 16
    assert "Heights (Z) left out: 1 feature." in feedback.textLog()


def test_curved_polygons_are_burnt_with_their_arcs(labels, tmp_path):
    around = [(50, 0), (100, 50), (50, 100), (0, 50), (50, 0)]
    arcs = ", ".join(f"{WEST + x} {NORTH - y}" for x, y in around)
    circle = f"CURVEPOLYGON (CIRCULARSTRING ({arcs}))"
    made = labels(write_layer(tmp_path / "a.gpkg", [(circle, "water")], geometry=ogr.wkbCurvePolygon))
    assert (made == 1).sum() == pytest.approx(np.pi * 50**2, rel=0.005)


def test_the_grid_is_aligned_to_multiples_of_the_pixel_size(rasterize, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(rectangle(1.3, 2.6, 9.9, 4.2), "field")])
    raster = gdal.Open(rasterize(layer, PIXEL_SIZE=2)["OUTPUT"])
    assert raster.GetGeoTransform() == (WEST, 2, 0, NORTH - 2, 0, -2)
    assert (raster.RasterXSize, raster.RasterYSize) == (6, 3)


def test_an_extent_in_another_crs_is_brought_to_the_maps(rasterize, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 4000), "field")])
    raster = gdal.Open(rasterize(layer, EXTENT="9.67,9.68,47.11,47.12 [EPSG:4326]", PIXEL_SIZE=10)["OUTPUT"])
    assert 70 < raster.RasterXSize < 90 and 105 < raster.RasterYSize < 125


def test_an_extent_around_or_beside_the_polygons_is_unlabeled_there_with_a_warning(rasterize, tmp_path, feedback):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 10), "field")])
    results = rasterize(layer, EXTENT=f"{WEST - 10},{WEST + 10},{NORTH - 10},{NORTH} [EPSG:32632]")
    made = read_pixels(results["OUTPUT"])
    assert results["LABELED_FRACTION"] == 0.5 and (made[:, :10] == 0).all() and (made[:, 10:] == 1).all()
    results = rasterize(layer, EXTENT=f"{WEST + 100},{WEST + 110},{NORTH - 10},{NORTH} [EPSG:32632]")
    assert results["LABELED_FRACTION"] == 0 and "no polygon is in the extent" in feedback.textLog()


def test_degrees_become_the_utm_zone_of_the_middle_with_a_note(rasterize, tmp_path, feedback):
    degrees = "POLYGON ((9.5 47.0, 9.52 47.0, 9.52 47.01, 9.5 47.01, 9.5 47.0))"
    results = rasterize(write_layer(tmp_path / "a.gpkg", [(degrees, "field")], crs=4326), PIXEL_SIZE=10)
    assert QgsRasterLayer(results["OUTPUT"]).crs().authid() == "EPSG:32632"
    # 0.02° of longitude at 47° are 1521 m, 0.01° of latitude 1112 m; the rest is convergence of the meridians.
    assert (read_pixels(results["OUTPUT"]) == 1).sum() * 100 == pytest.approx(1521 * 1112, rel=0.01)
    assert "EPSG:4326" in feedback.textLog() and "EPSG:32632" in feedback.textLog()


@pytest.mark.parametrize(("longitude", "latitude", "zone"), [(151.2, -33.9, "EPSG:32756"), (179.9, 10.0, "EPSG:32660")])
def test_the_utm_zone_is_right_on_both_halves_of_the_earth(rasterize, tmp_path, longitude, latitude, zone):
    east, north = longitude + 0.01, latitude + 0.01
    degrees = f"POLYGON (({longitude} {latitude}, {east} {latitude}, {east} {north}, {longitude} {latitude}))"
    layer = write_layer(tmp_path / "a.gpkg", [(degrees, "field")], crs=4326)
    assert QgsRasterLayer(rasterize(layer, PIXEL_SIZE=10)["OUTPUT"]).crs().authid() == zone


# New York Long Island in US survey feet, and web maps at 60° north, where a unit is half a meter on the ground.
@pytest.mark.parametrize(("crs", "x", "y", "edge_m"), [(2263, 985000, 2e5, 304.8), (3857, 1e6, 8399738, 500)])
def test_units_that_are_no_meters_become_meters_with_a_note(rasterize, tmp_path, feedback, crs, x, y, edge_m):
    square_of_1000 = f"POLYGON (({x} {y}, {x + 1e3} {y}, {x + 1e3} {y + 1e3}, {x} {y + 1e3}, {x} {y}))"
    results = rasterize(write_layer(tmp_path / "a.gpkg", [(square_of_1000, "field")], crs=crs))
    assert (read_pixels(results["OUTPUT"]) == 1).sum() == pytest.approx(edge_m**2, rel=0.01)
    assert f"EPSG:{crs}" in feedback.textLog() and "UTM zone" in feedback.textLog()


def test_selected_and_filtered_features_up_to_a_limit_and_edits_are_burnt(labels, tmp_path, project):
    path = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 4), "field"), (square(4, 0, 4), "water")])
    layer = QgsVectorLayer(str(path), "annotation", "ogr")
    project.addMapLayer(layer)
    assert labels(QgsProcessingFeatureSourceDefinition(layer.id(), False, 1)).shape == (4, 4)
    layer.selectByExpression("class = 'water'")
    selected = QgsProcessingFeatureSourceDefinition(layer.id(), selectedFeaturesOnly=True)
    assert labels(selected).tolist() == [[1] * 4] * 4
    selected.filterExpression = "class = 'field'"
    assert list(layer.getFeatures(request_of(layer, selected))) == []
    layer.startEditing()
    layer.deleteFeature(2)
    assert labels(layer).shape == (4, 4)
    layer.rollBack()


def test_the_label_map_is_a_tiled_deflated_byte_geotiff_with_colors_and_names(rasterize, tmp_path, classes_csv):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 10), "building"), (square(10, 10, 10), "field")])
    results = rasterize(layer, CLASS_TABLE=classes_csv)
    assert (results["CLASS_COUNT"], results["LABELED_FRACTION"]) == (2, 0.5)
    raster = gdal.Open(results["OUTPUT"])
    raster.GetMetadata()
    band = raster.GetRasterBand(1)
    assert (raster.GetDriver().ShortName, raster.RasterCount, band.DataType) == ("GTiff", 1, gdal.GDT_Byte)
    assert raster.GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE") == "DEFLATE"
    assert band.GetBlockSize() == [256, 256]
    assert band.GetRasterColorTable().GetColorEntry(1) == (0xD6, 0x27, 0x28, 255)
    assert band.GetRasterCategoryNames() == NAMES
    layer = QgsRasterLayer(results["OUTPUT"])
    shown = {entry.value: (entry.label, entry.color.name()) for entry in layer.renderer().classes()}
    assert (shown[1], shown[4]) == (("building", "#d62728"), ("field", "#2ca02c"))


@pytest.mark.parametrize("exceptions", [True, False])
def test_it_does_not_matter_whether_gdal_raises(labels, tmp_path, exceptions):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 4), "field")])
    before = [module.GetUseExceptions() for module in (gdal, ogr)]
    try:
        for module in (gdal, ogr):
            (module.UseExceptions if exceptions else module.DontUseExceptions)()
        assert (labels(layer) == 1).all()
        assert [module.GetUseExceptions() for module in (gdal, ogr)] == [exceptions] * 2
    finally:
        # GDAL keeps a stack of those who raise: last in, first out.
        for module, raised in reversed(list(zip((gdal, ogr), before))):
            (module.UseExceptions if raised else module.DontUseExceptions)()
