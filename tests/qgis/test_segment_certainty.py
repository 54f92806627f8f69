import numpy as np
import pytest
from made_inputs import NORTH, WEST, read_pixels, ring, spatial_reference, square, write_layer, write_raster
from made_models import metadata, write_model
from osgeo import gdal, ogr, osr
from qgis.core import QgsProcessingException, QgsRasterLayer
from tile_server import tile_server

SEGMENT = "semref:segmentimage"
PLACE = (WEST, 1.0, 0, NORTH, 0, -1.0)
PHOTO = np.random.default_rng(4).integers(0, 256, (3, 300, 230)).astype(np.uint8)


@pytest.fixture
def segment(runner, tmp_path):
    model = write_model(tmp_path / "colors.onnx")
    return runner(SEGMENT, "INPUT", MODEL=model, OUTPUT=tmp_path / "labels.tif")


@pytest.fixture
def image(tmp_path):
    return write_raster(tmp_path / "image.tif", PHOTO, transform=PLACE)


def certainty(tmp_path) -> dict:
    return {"CONFIDENCE": str(tmp_path / "sure.tif"), "PROBABILITIES": str(tmp_path / "each.tif")}


def test_probabilities_have_a_band_for_each_class_and_fit_the_labels(segment, image, tmp_path):
    found = segment(image, **certainty(tmp_path))
    each, sure, labels = gdal.Open(found["PROBABILITIES"]), gdal.Open(found["CONFIDENCE"]), read_pixels(found["OUTPUT"])
    bands = [each.GetRasterBand(n) for n in (1, 2, 3)]
    assert [band.GetDescription() for band in bands] == ["building", "water", "bare_land"]
    assert {(band.GetNoDataValue(), band.GetUnitType()) for band in [*bands, sure.GetRasterBand(1)]} == {(255, "%")}
    # The softmax of red, blue and green in the network of the tests.
    powers = np.exp((PHOTO[[0, 2, 1]].astype(float) / 255 - 0.5) / 0.5)
    np.testing.assert_allclose(each.ReadAsArray(), 100 * powers / powers.sum(axis=0), atol=0.51)
    own = np.take_along_axis(each.ReadAsArray(), labels[None].astype(int) - 1, axis=0)[0]
    np.testing.assert_array_equal(sure.ReadAsArray(), own)
    assert each.GetGeoTransform() == sure.GetGeoTransform() == PLACE
    assert each.GetProjection() == gdal.Open(found["OUTPUT"]).GetProjection() != ""


def test_certainty_has_a_style_in_percent(segment, image, tmp_path):
    found = segment(image, **certainty(tmp_path))
    for key in ("CONFIDENCE", "PROBABILITIES"):
        layer = QgsRasterLayer(found[key])
        renderer = layer.renderer()
        assert renderer.type() == "singlebandpseudocolor"
        assert [item.label for item in renderer.shader().rasterShaderFunction().colorRampItemList()][-1] == "100 %"


def test_the_class_without_a_name_is_not_shown_first(segment, image, tmp_path):
    more = metadata(class_names=["background", "water", "bare_land"])
    model = write_model(tmp_path / "m.onnx", metadata=more)
    found = segment(image, MODEL=str(model), **certainty(tmp_path))
    assert QgsRasterLayer(found["PROBABILITIES"]).renderer().band() == 2
    labels, sure = read_pixels(found["OUTPUT"]), read_pixels(found["CONFIDENCE"])
    assert (labels == 0).any() and (sure[labels == 0] <= 100).all()


def two_squares(tmp_path, name="mask.gpkg", **options):
    return write_layer(tmp_path / name, [(square(20, 30, 50), "a"), (square(120, 160, 64), "b")], **options)


def in_two_squares() -> np.ndarray:
    inside = np.zeros(PHOTO.shape[1:], bool)
    inside[30:80, 20:70] = inside[160:224, 120:184] = True
    return inside


def test_outside_the_mask_nothing_has_a_label_and_inside_all_is_as_without(segment, image, tmp_path):
    whole = read_pixels(segment(image)["OUTPUT"])
    found = segment(image, MASK=str(two_squares(tmp_path)), **certainty(tmp_path))
    inside = in_two_squares()
    np.testing.assert_array_equal(read_pixels(found["OUTPUT"]), np.where(inside, whole, 0))
    np.testing.assert_array_equal(read_pixels(found["CONFIDENCE"]) == 255, ~inside)


def test_a_mask_with_a_hole_leaves_the_hole_out(segment, image, tmp_path):
    outer, hole = [(0, 0), (100, 0), (100, 100), (0, 100)], [(20, 20), (60, 20), (60, 60), (20, 60)]
    mask = write_layer(tmp_path / "m.gpkg", [(f"POLYGON ({ring(outer)}, {ring(hole)})", "a")])
    found = read_pixels(segment(image, MASK=str(mask))["OUTPUT"])
    wanted = np.zeros(found.shape, bool)
    wanted[:100, :100] = True
    wanted[20:60, 20:60] = False
    np.testing.assert_array_equal(found > 0, wanted)


def test_a_mask_in_degrees_covers_its_ground(segment, image, tmp_path):
    geometry = ogr.CreateGeometryFromWkt(square(20, 30, 50))
    geometry.Transform(osr.CoordinateTransformation(spatial_reference(32632), spatial_reference(4326)))
    mask = write_layer(tmp_path / "m.gpkg", [(geometry.ExportToWkt(), "a")], crs=4326)
    found = read_pixels(segment(image, MASK=str(mask))["OUTPUT"]) > 0
    wanted = np.zeros(found.shape, bool)
    wanted[30:80, 20:70] = True
    assert (found != wanted).sum() <= 4


def test_a_turned_image_is_masked_where_its_ground_is(segment, tmp_path):
    # Columns run north, rows run east.
    turned = write_raster(tmp_path / "turned.tif", PHOTO, transform=(WEST, 0.0, 1.0, NORTH - 300, 1.0, 0.0))
    found = read_pixels(segment(turned, MASK=str(two_squares(tmp_path)))["OUTPUT"]) > 0
    wanted = np.zeros(found.shape, bool)
    # The square at columns 20…70, rows 30…80 from the north: row of the image 20…70, column 300 − 80 … 300 − 30.
    wanted[20:70, 220:230] = True
    wanted[120:184, 76:140] = True
    np.testing.assert_array_equal(found, wanted)


def test_of_map_tiles_the_masks_extent_is_drawn(segment, tmp_path):
    model = write_model(tmp_path / "m.onnx", metadata=metadata(resolution=100))
    with tile_server() as source:
        tiles = QgsRasterLayer(source, "tiles", "wms")
        found = segment(tiles, MODEL=str(model), MASK=str(two_squares(tmp_path)))["OUTPUT"]
    raster = gdal.Open(found)
    assert (raster.RasterXSize, raster.RasterYSize) == (164, 194)
    np.testing.assert_array_equal(raster.ReadAsArray() > 0, in_two_squares()[30:224, 20:184])


@pytest.mark.parametrize(
    ("column", "place", "words"),
    [
        (5_000, PLACE, "The mask and the image do not overlap"),
        (None, PLACE, "The mask and the image do not overlap"),
        (20, None, "no georeference"),
    ],
)
def test_a_mask_beside_the_image_or_of_a_photo_without_a_place_is_refused(segment, tmp_path, column, place, words):
    features = [] if column is None else [(square(column, 0, 50), "a")]
    mask = write_layer(tmp_path / "m.gpkg", features, geometry=ogr.wkbPolygon)
    with pytest.raises(QgsProcessingException, match=words):
        segment(write_raster(tmp_path / "a.tif", PHOTO, transform=place), MASK=str(mask))
