"""Extent, CRS and file format of the label map."""

import pytest
from made_inputs import NAMES, NORTH, WEST, read_pixels, rectangle, square, write_layer
from osgeo import gdal, ogr
from qgis.core import QgsProcessingFeatureSourceDefinition, QgsRasterLayer, QgsVectorLayer


def test_the_grid_is_aligned_to_multiples_of_the_pixel_size(rasterize, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(rectangle(1.3, 2.6, 9.9, 4.2), "field")])
    raster = gdal.Open(rasterize(layer, PIXEL_SIZE=2)["OUTPUT"])
    assert raster.GetGeoTransform() == (WEST, 2, 0, NORTH - 2, 0, -2)
    assert (raster.RasterXSize, raster.RasterYSize) == (6, 3)


def test_an_extent_in_another_crs_is_brought_to_the_maps(rasterize, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 4000), "field")])
    raster = gdal.Open(rasterize(layer, EXTENT="9.67,9.68,47.11,47.12 [EPSG:4326]", PIXEL_SIZE=10)["OUTPUT"])
    assert 70 < raster.RasterXSize < 90
    assert 105 < raster.RasterYSize < 125


def test_an_extent_around_or_beside_the_polygons_is_unlabeled_there_with_a_warning(rasterize, tmp_path, feedback):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 10), "field")])
    results = rasterize(layer, EXTENT=f"{WEST - 10},{WEST + 10},{NORTH - 10},{NORTH} [EPSG:32632]")
    made = read_pixels(results["OUTPUT"])
    assert results["LABELED_FRACTION"] == 0.5
    assert (made[:, :10] == 0).all() and (made[:, 10:] == 1).all()
    results = rasterize(layer, EXTENT=f"{WEST + 100},{WEST + 110},{NORTH - 10},{NORTH} [EPSG:32632]")
    assert results["LABELED_FRACTION"] == 0 and "no polygon is in the extent" in feedback.textLog()


def test_degrees_become_the_utm_zone_of_the_middle_with_a_note(rasterize, tmp_path, feedback):
    degrees = "POLYGON ((9.5 47.0, 9.52 47.0, 9.52 47.01, 9.5 47.01, 9.5 47.0))"
    layer = write_layer(tmp_path / "a.gpkg", [(degrees, "field")], crs=4326)
    results = rasterize(layer, PIXEL_SIZE=10)
    assert QgsRasterLayer(results["OUTPUT"]).crs().authid() == "EPSG:32632"
    # 0.02° of longitude at 47° are 1521 m, 0.01° of latitude 1112 m; the rest is convergence of the meridians.
    labeled = (read_pixels(results["OUTPUT"]) == 1).sum() * 100
    assert labeled == pytest.approx(1521 * 1112, rel=0.01)
    assert "EPSG:4326" in feedback.textLog() and "EPSG:32632" in feedback.textLog()


@pytest.mark.parametrize(("longitude", "latitude", "zone"), [(151.2, -33.9, "EPSG:32756"), (179.9, 10.0, "EPSG:32660")])
def test_the_utm_zone_is_right_on_both_halves_of_the_earth(rasterize, tmp_path, longitude, latitude, zone):
    east, north = longitude + 0.01, latitude + 0.01
    degrees = f"POLYGON (({longitude} {latitude}, {east} {latitude}, {east} {north}, {longitude} {latitude}))"
    layer = write_layer(tmp_path / "a.gpkg", [(degrees, "field")], crs=4326)
    assert QgsRasterLayer(rasterize(layer, PIXEL_SIZE=10)["OUTPUT"]).crs().authid() == zone


def test_a_crs_in_feet_becomes_meters_with_a_note(rasterize, tmp_path, feedback):
    # EPSG:2263 is New York Long Island in US survey feet; 1000 ft are 304.8 m.
    feet = "POLYGON ((985000 200000, 986000 200000, 986000 201000, 985000 201000, 985000 200000))"
    results = rasterize(write_layer(tmp_path / "a.gpkg", [(feet, "field")], crs=2263))
    assert QgsRasterLayer(results["OUTPUT"]).crs().authid() == "EPSG:32618"
    assert (read_pixels(results["OUTPUT"]) == 1).sum() == pytest.approx(304.8**2, rel=0.01)
    assert "EPSG:2263" in feedback.textLog()


def test_selected_features_and_what_is_being_edited_are_burnt_as_the_canvas_shows_them(labels, tmp_path, project):
    path = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 4), "field"), (square(4, 0, 4), "water")])
    layer = QgsVectorLayer(str(path), "annotation", "ogr")
    project.addMapLayer(layer)
    layer.selectByExpression("class = 'water'")
    made = labels(QgsProcessingFeatureSourceDefinition(layer.id(), selectedFeaturesOnly=True))
    assert made.shape == (4, 4) and (made == 1).all()
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
