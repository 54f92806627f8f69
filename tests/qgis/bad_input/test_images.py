"""A bad image is reported in its row, or refused if it is the only one."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from bad_input import DECODE, DESCRIBE, LABELS, LOCALIZE, sentence_of
from made_inputs import write_raster
from osgeo import gdal, ogr


def reason_of(run_algorithm, defaults, path) -> str:
    parameters = {**defaults[LOCALIZE], "IMAGES": [str(path)]}
    source = ogr.Open(run_algorithm(LOCALIZE, parameters)["OUTPUT"])
    (row,) = list(source.GetLayer(0))
    assert row["status"] == "error"
    return sentence_of(ValueError(row["reason"]))


def truncated_png(path: Path) -> Path:
    noise = np.random.default_rng(1).integers(0, 255, (200, 200)).astype(np.uint8)
    content = write_raster(path, noise, transform=None).read_bytes()
    path.write_bytes(content[: len(content) // 2])
    return path


@pytest.fixture(params=["missing", "empty", "text", "truncated", "huge", "16-bit color", "two bands", "float", "300"])
def bad_image(request, tmp_path):
    path = tmp_path / "bad.png"
    if request.param == "empty":
        path.touch()
    elif request.param == "text":
        path.write_text("This is no picture.")
    elif request.param == "truncated":
        truncated_png(path)
    elif request.param == "huge":
        path = tmp_path / "bad.vrt"
        path.write_text(
            '<VRTDataset rasterXSize="100000" rasterYSize="100000">'
            '<VRTRasterBand dataType="Byte" band="1"/></VRTDataset>'
        )
    elif request.param == "16-bit color":
        write_raster(path, np.full((3, 50, 50), 300, np.uint16), transform=None, kind=gdal.GDT_UInt16)
    elif request.param == "two bands":
        write_raster(path, np.full((2, 50, 50), 1, np.uint8), transform=None)
    elif request.param == "float":
        path = write_raster(tmp_path / "bad.tif", LABELS, kind=gdal.GDT_Float32)
    elif request.param == "300":
        write_raster(path, np.full((50, 50), 300, np.uint16), transform=None, kind=gdal.GDT_UInt16)
    return path


def test_a_bad_image_has_a_row_with_one_sentence_that_names_it(run_algorithm, defaults, bad_image):
    assert bad_image.name in reason_of(run_algorithm, defaults, bad_image)


def test_a_truncated_image_cannot_be_decoded(refused, tmp_path):
    noise = np.random.default_rng(1).integers(0, 255, (3, 200, 200)).astype(np.uint8)
    path = write_raster(tmp_path / "cut.png", noise, transform=None)
    path.write_bytes(path.read_bytes()[:60_000])
    assert "cut.png" in refused(DECODE, INPUT=str(path))


@pytest.mark.parametrize(
    ("pixels", "kind", "said"),
    [
        (np.zeros((3, 9, 9), np.uint16), gdal.GDT_UInt16, "UInt16"),
        (np.zeros((9, 9), np.uint8), gdal.GDT_Byte, "1 band"),
        (np.zeros((2, 9, 9), np.uint8), gdal.GDT_Byte, "2 band"),
    ],
)
def test_an_image_that_is_not_rgb_of_8_bits_cannot_be_decoded(refused, tmp_path, pixels, kind, said):
    path = write_raster(tmp_path / "image.tif", pixels, kind=kind)
    assert said in refused(DECODE, INPUT=str(path))


def test_a_folder_without_images_is_named(refused, tmp_path):
    (tmp_path / "flight").mkdir()
    (tmp_path / "flight" / "notes.txt").write_text("fog")
    assert "flight" in refused(LOCALIZE, IMAGES=[str(tmp_path / "flight")])


@pytest.mark.parametrize("images", ["", ";", []])
def test_no_images_at_all_are_refused(refused, images):
    assert "“Images”" in refused(LOCALIZE, IMAGES=images)


@pytest.mark.parametrize("keys", [["EXTENT"], ["MASK"], ["EXTENT", "MASK"]])
def test_a_part_of_no_layer_is_refused_by_name(refused, good, keys):
    parts = {"EXTENT": "0,10,0,10 [EPSG:32632]", "MASK": str(good / "annotation.gpkg")}
    sentence = refused(LOCALIZE, **{key: parts[key] for key in keys})
    assert "layer to test" in sentence
    assert [key for key in parts if f"“{key.title()} of the test layer”" in sentence] == keys


def test_scales_the_wrong_way_round_are_refused(refused):
    assert "(2)" in refused(LOCALIZE, SCALE_MINIMUM=2, SCALE_MAXIMUM=0.5)


def test_an_image_without_classes_of_its_own_needs_a_table(refused):
    assert "class table" in refused(DESCRIBE, CLASS_TABLE=None)
