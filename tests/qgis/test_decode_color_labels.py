import numpy as np
import pytest
from made_inputs import CLASSES_CSV, NORTH, WEST, read_pixels, scattered_objects, write_raster, write_text
from osgeo import gdal
from qgis.core import QgsRasterLayer

from semref.processing.algorithms import decode_color_labels

DECODE = "semref:decodecolorlabels"
HSV_RANGES, NEAREST_COLOR = 0, 1
COLORS = {1: (0xD6, 0x27, 0x28), 2: (0x1F, 0x77, 0xB4), 3: (0xBC, 0xBD, 0x22), 4: (0x2C, 0xA0, 0x2C)}
"""Red, green, blue of CLASSES_CSV."""

RED_CSV = "value,name,color,role,draw_order,hsv_min,hsv_max\n7,roof,#ff0000,reference,,170 100 100,10 255 255\n"
"""Class table with a hue range that wraps around from 180 to 0."""

LABELS = scattered_objects(90, 130, 25, seed=3)


@pytest.fixture
def decode(run_algorithm, feedback, tmp_path):
    """`decode(image, class_table_text, **parameters)` returns the path of the label map."""

    def run(image, table=CLASSES_CSV, **parameters):
        table = write_text(tmp_path / "classes.csv", table)
        defaults = {"METHOD": NEAREST_COLOR, "OUTPUT": str(tmp_path / "labels.tif"), "CLASS_TABLE": str(table)}
        return run_algorithm(DECODE, {"INPUT": image, **defaults, **parameters}, feedback)["OUTPUT"]

    return run


def painted(labels: np.ndarray) -> np.ndarray:
    palette = np.zeros((256, 3), np.uint8)
    for value, color in COLORS.items():
        palette[value] = color
    return np.moveaxis(palette[labels], 2, 0)


def test_exact_colors_give_back_the_labels_with_a_palette_a_fourth_band_and_in_slices(decode, tmp_path, monkeypatch):
    image = write_raster(tmp_path / "a.png", painted(LABELS), transform=None)
    np.testing.assert_array_equal(read_pixels(decode(image)), LABELS)
    opaque = np.concatenate([painted(LABELS), np.full((1, *LABELS.shape), 255, np.uint8)])
    monkeypatch.setattr(decode_color_labels, "ROWS_PIXELS", 7 * LABELS.shape[1])
    np.testing.assert_array_equal(read_pixels(decode(write_raster(tmp_path / "a.tif", opaque))), LABELS)
    shuffled = np.zeros(256, np.uint8)
    shuffled[:5] = (9, 40, 3, 200, 17)
    palette = {shuffled[value]: color for value, color in COLORS.items()}
    image = write_raster(tmp_path / "a.png", shuffled[LABELS], palette=palette, transform=None)
    np.testing.assert_array_equal(read_pixels(decode(image)), LABELS)


def test_colors_outside_all_hsv_ranges_are_unlabeled_and_reported(decode, tmp_path, feedback):
    red_and_blue = np.zeros((3, 4, 4), np.uint8)
    red_and_blue[0, :, :1] = 255
    red_and_blue[2, :, 1:] = 255
    image = write_raster(tmp_path / "a.png", red_and_blue, transform=None)
    found = read_pixels(decode(image, RED_CSV, METHOD=HSV_RANGES))
    np.testing.assert_array_equal(found[0], [7, 0, 0, 0])
    assert "75.0%" in feedback.textLog()


def test_the_label_map_has_the_place_of_the_image_and_the_classes_of_the_table(decode, tmp_path):
    image = write_raster(tmp_path / "a.tif", painted(LABELS), transform=(WEST, 0.5, 0, NORTH, 0, -0.5), crs=25832)
    raster = gdal.Open(decode(image))
    assert raster.GetGeoTransform() == (WEST, 0.5, 0, NORTH, 0, -0.5)
    assert QgsRasterLayer(str(tmp_path / "labels.tif")).crs().authid() == "EPSG:25832"
    assert raster.GetMetadataItem("SEMREF_CLASS_TABLE").startswith("value,name,color,role")
    assert raster.GetRasterBand(1).GetRasterColorTable().GetColorEntry(2)[:3] == COLORS[2]
