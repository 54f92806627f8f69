import importlib.util
import os
import re
from pathlib import Path

import numpy as np
import pytest
from bad_input import BUILD, DECODE, DESCRIBE, LABELS, LOCALIZE, OUTPUT_NAMES, RASTERIZE, SEGMENT, sentence_of
from made_inputs import read_rows, write_raster, write_text
from made_models import brightest_color, metadata, write_model
from osgeo import gdal
from qgis.core import QgsApplication

from semref.processing.packages import components

NOISE = np.random.default_rng(1).integers(0, 255, (3, 400, 400)).astype(np.uint8)
HUGE = '<VRTDataset rasterXSize="100000" rasterYSize="100000"><VRTRasterBand dataType="Byte" band="1"/></VRTDataset>'


def write(path: Path, pixels, kind=gdal.GDT_Byte) -> Path:
    return write_raster(path, pixels, transform=None, kind=kind)


def cut_short(path: Path, pixels) -> Path:
    content = write(path, pixels).read_bytes()
    path.write_bytes(content[: len(content) // 2])
    return path


BAD_IMAGES = {
    "missing.png": lambda path: None,
    "empty.png": Path.touch,
    "text.png": lambda path: path.write_text("This is no picture."),
    "truncated.png": lambda path: cut_short(path, NOISE[0]),
    "huge.vrt": lambda path: path.write_text(HUGE),
    "color of 16 bits.png": lambda path: write(path, np.full((3, 50, 50), 300, np.uint16), gdal.GDT_UInt16),
    "two bands.png": lambda path: write(path, np.full((2, 50, 50), 1, np.uint8)),
    "float.tif": lambda path: write(path, LABELS, gdal.GDT_Float32),
    "300.png": lambda path: write(path, np.full((50, 50), 300, np.uint16), gdal.GDT_UInt16),
}
if hasattr(os, "mkfifo"):
    # GDAL once waited for it forever.
    BAD_IMAGES["pipe.jpg"] = os.mkfifo


@pytest.mark.parametrize("name", BAD_IMAGES)
def test_a_bad_image_has_a_row_with_one_sentence_that_names_it(run_algorithm, defaults, tmp_path, name):
    BAD_IMAGES[name](tmp_path / name)
    found = run_algorithm(LOCALIZE, {**defaults[LOCALIZE], "IMAGES": [str(tmp_path / name)]})
    (row,) = read_rows(found["OUTPUT"])
    assert row["status"] == "error" and name in sentence_of(ValueError(row["reason"]))


@pytest.mark.parametrize(
    ("algorithm", "key", "pixels", "words"),
    [
        (DECODE, "INPUT", NOISE, "cut.tif"),
        (BUILD, "LABELS", NOISE[0] % 4 + 1, "cut.tif"),
        (SEGMENT, "INPUT", NOISE, "cut.tif is damaged or cut short"),
    ],
)
def test_a_raster_that_is_cut_short_is_refused(refused, tmp_path, algorithm, key, pixels, words):
    path = write_raster(tmp_path / "cut.tif", pixels)
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    assert words in refused(algorithm, **{key: str(path)})


@pytest.mark.parametrize(
    ("shape", "kind", "said"),
    [((3, 9, 9), "UInt16", "UInt16"), ((9, 9), "Byte", "1 band"), ((2, 9, 9), "Byte", "2 band")],
)
def test_an_image_that_is_not_rgb_of_8_bits_cannot_be_decoded(refused, tmp_path, shape, kind, said):
    path = write_raster(tmp_path / "image.tif", np.zeros(shape, np.uint8), kind=getattr(gdal, f"GDT_{kind}"))
    assert said in refused(DECODE, INPUT=str(path))


def test_a_folder_without_images_is_named(refused, tmp_path):
    (tmp_path / "flight").mkdir()
    (tmp_path / "flight" / "notes.txt").write_text("fog")
    assert "flight" in refused(LOCALIZE, IMAGES=[str(tmp_path / "flight")])


@pytest.mark.parametrize(
    ("algorithm", "parameters", "words"),
    [
        *((LOCALIZE, {"IMAGES": images}, "“Images”") for images in ("", ";", [])),
        (LOCALIZE, {"SCALE_MINIMUM": 2, "SCALE_MAXIMUM": 0.5}, "(2)"),
        (DESCRIBE, {"CLASS_TABLE": None}, "class table"),
    ],
)
def test_missing_images_and_classes_and_exchanged_scales_are_refused(refused, algorithm, parameters, words):
    assert words in refused(algorithm, **parameters)


@pytest.mark.parametrize("keys", [["EXTENT"], ["MASK"], ["EXTENT", "MASK"]])
def test_a_part_of_no_layer_is_refused_by_name(refused, good, keys):
    parts = {"EXTENT": "0,10,0,10 [EPSG:32632]", "MASK": str(good / "annotation.gpkg")}
    sentence = refused(LOCALIZE, **{key: parts[key] for key in keys})
    assert "layer to test" in sentence
    assert [key for key in parts if f"“{key.title()} of the test layer”" in sentence] == keys


@pytest.mark.parametrize("algorithm", [SEGMENT, LOCALIZE])
@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"network": brightest_color(external="weights.bin")}, "are in another file, which is missing"),
        ({"network": brightest_color().add("Frobnicate")}, "can't be run by onnxruntime"),
        ({"metadata": metadata(resolution="fine")}, "resolution"),
    ],
)
def test_a_bad_model_is_reported_in_one_sentence(refused, tmp_path, options, words, algorithm):
    """More models: tests/core/segmentation."""
    sentence = refused(algorithm, MODEL=str(write_model(tmp_path / "bad.onnx", **options)))
    assert "bad.onnx" in sentence and words in sentence


def test_a_photo_that_makes_a_network_give_no_numbers_has_no_fix(run_algorithm, defaults, tmp_path):
    model = write_model(tmp_path / "bad.onnx", brightest_color().add("Sqrt"))
    (row,) = read_rows(run_algorithm(LOCALIZE, {**defaults[LOCALIZE], "MODEL": str(model)})["OUTPUT"])
    assert row["status"] == "error" and "not numbers" in row["reason"]


def test_no_speed_is_reported_if_the_network_saw_no_photo(run_algorithm, defaults, feedback, tmp_path):
    parameters = {"MODEL": str(write_model(tmp_path / "m.onnx")), "IMAGES": str(write_text(tmp_path / "a.png", "text"))}
    found = run_algorithm(LOCALIZE, {**defaults[LOCALIZE], **parameters}, feedback)
    assert found["FIX_COUNT"] == 0 and "DEVICE" not in found and "per second" not in feedback.textLog()


@pytest.fixture
def lacking(qgis_app, monkeypatch):
    """`lacking(module)` makes Python find no such module; returns a maker of algorithms by id."""

    def of(module):
        find_spec = importlib.util.find_spec
        monkeypatch.setattr(importlib.util, "find_spec", lambda one, *a: None if one == module else find_spec(one, *a))
        return QgsApplication.processingRegistry().createAlgorithmById

    return of


def test_a_missing_opencv_is_reported_by_every_algorithm(lacking):
    create = lacking("cv2")
    for algorithm in OUTPUT_NAMES:
        possible, reason = create(algorithm).canExecute()
        assert not possible and "pip install" in reason and "opencv-python-headless>=" in reason


def test_a_missing_onnxruntime_is_reported_with_how_to_install_it(lacking):
    create = lacking("onnxruntime")
    possible, reason = create(SEGMENT).canExecute()
    # Which command fits which release: test_components.py.
    assert not possible and re.search('install --no-deps [^“”]*"onnxruntime', reason)
    assert create(LOCALIZE).canExecute() == (True, "")


@pytest.mark.parametrize("name", ["is_missing", "is_too_old"])
@pytest.mark.parametrize("algorithm", ["semref:checkannotation", "semref:repairannotation"])
def test_a_missing_or_old_shapely_is_reported_by_its_algorithms(qgis_app, monkeypatch, name, algorithm):
    monkeypatch.setattr(components, name, lambda package: package is components.SHAPELY)
    create = QgsApplication.processingRegistry().createAlgorithmById
    possible, reason = create(algorithm).canExecute()
    assert not possible and '"shapely>=2' in reason
    assert create(RASTERIZE).canExecute()[0]
