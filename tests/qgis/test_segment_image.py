import cv2
import numpy as np
import pytest
from made_inputs import CLASSES_CSV, NORTH, WEST, read_pixels, scattered_objects, write_raster, write_text
from made_models import metadata, painted, write_model
from osgeo import gdal
from qgis.core import QgsProcessingException, QgsProcessingOutputLayerDefinition, QgsRasterLayer

from semref.storage.label_maps import require_map_grid

SEGMENT = "semref:segmentimage"
LABELS = scattered_objects(170, 230, 60, seed=3, background=0)
"""Classes 1 building, 2 water, 3 bare_land on gray; the network classifies gray as building, the first of equals."""
SEEN = np.where(LABELS == 0, 1, LABELS)


@pytest.fixture
def segment(runner, tmp_path):
    model = write_model(tmp_path / "colors.onnx")
    run = runner(SEGMENT, "INPUT", MODEL=model, OUTPUT=tmp_path / "labels.tif")
    return lambda image, **parameters: run(image, **parameters)["OUTPUT"]


def bands_of(photo_hw3: np.ndarray) -> np.ndarray:
    return np.moveaxis(photo_hw3, 2, 0)


PHOTO = bands_of(painted(LABELS))


def test_an_orthophoto_becomes_a_label_map_on_the_same_ground(segment, tmp_path, feedback):
    image = write_raster(tmp_path / "a.tif", PHOTO, transform=(WEST, 0.5, 0, NORTH, 0, -0.5), crs=25832)
    raster = gdal.Open(segment(image, CONFIDENCE=QgsProcessingOutputLayerDefinition("")))
    np.testing.assert_array_equal(raster.ReadAsArray(), SEEN)
    assert raster.GetGeoTransform() == (WEST, 0.5, 0, NORTH, 0, -0.5)
    assert QgsRasterLayer(str(tmp_path / "labels.tif")).crs().authid() == "EPSG:25832"
    assert "building, water, bare_land. Device: CPU, tiles of 64 × 64 pixels" in feedback.textLog()


def test_the_label_map_has_the_models_classes(segment, tmp_path):
    more = metadata(class_values={"0": 5, "1": 2, "2": 9}, class_colors=["#ff0000", "#0000ff", "#00ff00"])
    model = write_model(tmp_path / "m.onnx", metadata=more)
    raster = gdal.Open(segment(write_raster(tmp_path / "a.tif", PHOTO), MODEL=str(model)))
    np.testing.assert_array_equal(raster.ReadAsArray(), np.array([5, 5, 2, 9])[LABELS])
    assert "5,building,#ff0000,background" in raster.GetMetadataItem("SEMREF_CLASS_TABLE")
    band = raster.GetRasterBand(1)
    assert [band.GetRasterCategoryNames()[n] for n in (2, 5, 9)] == ["water", "building", "bare_land"]
    assert band.GetRasterColorTable().GetColorEntry(9)[:3] == (0, 255, 0)
    assert (tmp_path / "labels.qml").exists()


def test_a_class_table_gives_values_roles_and_colors(segment, tmp_path):
    table = write_text(tmp_path / "classes.csv", CLASSES_CSV.replace("1,building", "40,Building"))
    raster = gdal.Open(segment(write_raster(tmp_path / "a.tif", PHOTO), CLASS_TABLE=str(table)))
    np.testing.assert_array_equal(raster.ReadAsArray(), np.array([40, 40, 2, 3])[LABELS])
    assert "40,Building,#d62728,reference" in raster.GetMetadataItem("SEMREF_CLASS_TABLE")


def test_pixels_without_data_and_transparent_ones_are_unlabeled(segment, tmp_path):
    photo = PHOTO.copy()
    photo[:, 20:90, 30:180] = 7
    photo[0, 100, 100] = 7  # A single band is not enough.
    found = read_pixels(segment(write_raster(tmp_path / "a.tif", photo, nodata=7)))
    assert (found[20:90, 30:180] == 0).all()
    assert found[100, 100] != 0 and (found == 0).sum() == 70 * 150
    alpha = np.full(LABELS.shape, 255, np.uint8)
    alpha[:40, :50] = 0
    rgba, options = np.concatenate([PHOTO, alpha[None]]), ["PHOTOMETRIC=RGB", "ALPHA=YES"]
    path = write_raster(tmp_path / "b.tif", rgba, options=options)
    np.testing.assert_array_equal(read_pixels(segment(path)), np.where(alpha > 0, SEEN, 0))


def test_sixteen_bits_are_stretched(segment, tmp_path, feedback):
    photo = PHOTO.astype(np.uint16) * 10 + 300
    found = read_pixels(segment(write_raster(tmp_path / "a.tif", photo, kind=gdal.GDT_UInt16)))
    np.testing.assert_array_equal(found[LABELS > 0], LABELS[LABELS > 0])
    assert "Stretched to 8 bits from 700–2500" in feedback.textLog()


@pytest.mark.parametrize("by_wavelength", [True, False])
def test_bands_are_found_by_their_wavelength_or_color_interpretation(segment, tmp_path, feedback, by_wavelength):
    order = [PHOTO[::-1], PHOTO[:1]] if by_wavelength else [PHOTO[:1] * 0, PHOTO[::-1]]
    path = write_raster(tmp_path / "a.tif", np.concatenate(order))
    colors = (
        [gdal.GCI_Undefined] * 4
        if by_wavelength
        else [gdal.GCI_Undefined, gdal.GCI_BlueBand, gdal.GCI_GreenBand, gdal.GCI_RedBand]
    )
    raster = gdal.Open(str(path), gdal.GA_Update)
    for number, (length, color) in enumerate(zip((0.4843, 0.5584, 0.6465, 0.8046), colors), start=1):
        band = raster.GetRasterBand(number)
        if by_wavelength:
            band.SetMetadataItem("wavelength", str(length))
            band.SetMetadataItem("wavelength_units", "Micrometers")
        band.SetColorInterpretation(color)
    raster = band = None
    np.testing.assert_array_equal(read_pixels(segment(path)), SEEN)
    assert not by_wavelength or "bands 3, 2, 1" in feedback.textLog()


def test_a_paletted_image_is_seen_in_its_colors(segment, tmp_path):
    palette = {value: painted(np.array([[value]]))[0, 0] for value in range(4)}
    path = write_raster(tmp_path / "a.png", LABELS, palette=palette, transform=None)
    np.testing.assert_array_equal(read_pixels(segment(path)), SEEN)


@pytest.mark.parametrize(("pixel_m", "factor"), [(0.25, 0.5), (1.0, 2.0)])
def test_the_image_is_brought_to_the_models_resolution(segment, tmp_path, pixel_m, factor):
    model = write_model(tmp_path / "m.onnx", metadata=metadata(resolution=50))
    image = write_raster(tmp_path / "a.tif", PHOTO, transform=(WEST, pixel_m, 0, NORTH, 0, -pixel_m))
    raster = gdal.Open(segment(image, MODEL=str(model)))
    assert (raster.RasterXSize, raster.RasterYSize) == (230 * factor, 170 * factor)
    assert raster.GetGeoTransform() == (WEST, 0.5, 0, NORTH, 0, -0.5)
    back = cv2.resize(raster.ReadAsArray(), (230, 170), interpolation=cv2.INTER_NEAREST)
    assert (back == SEEN)[LABELS > 0].mean() > 0.9


def test_a_resampled_label_map_has_square_pixels_as_databases_need_them_and_keeps_holes(segment, tmp_path):
    photo = PHOTO.copy()
    photo[:, :, :100] = 0
    image = write_raster(tmp_path / "a.tif", photo, nodata=0, transform=(WEST, 0.25, 0, NORTH, 0, -0.25))
    path = segment(image, RESOLUTION=37)
    require_map_grid(gdal.Open(path).GetGeoTransform(), path)
    found = read_pixels(segment(image, RESOLUTION=50))
    assert (found[:, :50] == 0).all() and (found[:, 50:] > 0).all()


@pytest.mark.parametrize(("crs", "x", "y", "unit", "down"), [(4326, 8, 60, 1 / 111_320, 2), (3857, 1e6, 8399738, 1, 4)])
def test_degrees_and_units_of_web_maps_are_turned_into_meters(segment, tmp_path, crs, x, y, unit, down):
    model = write_model(tmp_path / "m.onnx", metadata=metadata(resolution=200))
    image = write_raster(tmp_path / "a.tif", PHOTO, crs=crs, transform=(x, unit, 0, y, 0, -unit))
    raster = gdal.Open(segment(image, MODEL=str(model)))
    # At 60° north a degree of longitude is half as long, and so is a unit of web maps.
    assert (raster.RasterXSize, raster.RasterYSize) == pytest.approx((230 / 4, 170 / down), abs=1)


def test_a_label_map_of_many_rows_is_written_whole(segment, tmp_path):
    labels = scattered_objects(900, 70, 60, seed=8, background=2)
    found = read_pixels(segment(write_raster(tmp_path / "a.tif", bands_of(painted(labels)))))
    np.testing.assert_array_equal(found, labels)


def test_a_model_without_class_names_is_refused_with_the_key_that_gives_them(segment, tmp_path):
    model = write_model(tmp_path / "nameless.onnx", metadata=metadata(class_names=None))
    with pytest.raises(QgsProcessingException, match="segment with a class table"):
        segment(write_raster(tmp_path / "a.tif", PHOTO), MODEL=str(model))
