"""Unusable label maps and values are refused by name."""

import numpy as np
import pytest
from bad_input import BUILD, LABELS
from made_inputs import NORTH, WEST, write_raster
from osgeo import gdal


def with_value(value: int) -> np.ndarray:
    labels = LABELS.astype(np.int32)
    labels[100, 100] = value
    return labels


@pytest.mark.parametrize(
    ("pixels", "options", "words"),
    [
        (LABELS, {"crs": 4326, "transform": (9.5, 0.00001, 0, 47.2, 0, -0.00001)}, ["EPSG:4326"]),
        (LABELS, {"crs": 2263, "transform": (985000, 1, 0, 200000, 0, -1)}, ["EPSG:2263"]),
        (LABELS, {"crs": None}, ["coordinate reference system"]),
        (LABELS, {"transform": (WEST, 1, 0.2, NORTH, 0.2, -1)}, ["rotated"]),
        (LABELS, {"transform": (WEST, 1, 0, NORTH, 0, 1)}, ["mirrored"]),
        (LABELS, {"transform": (WEST, 1, 0, NORTH, 0, -2)}, ["1 × 2"]),
        (LABELS, {"kind": gdal.GDT_Float32}, ["Float32"]),
        (LABELS, {"kind": gdal.GDT_Float64}, ["Float64"]),
        (LABELS, {"kind": gdal.GDT_CInt16}, ["CInt16"]),
        (np.stack([LABELS] * 3), {}, ["3 bands"]),
        (with_value(256), {"kind": gdal.GDT_UInt16}, [" 256", "255"]),
        (with_value(70000), {"kind": gdal.GDT_Int32}, [" 70000", "255"]),
        (with_value(-1), {"kind": gdal.GDT_Int16}, [" -1", "255"]),
    ],
)
def test_a_label_map_is_metric_north_up_square_and_of_class_values(refused, tmp_path, pixels, options, words):
    sentence = refused(BUILD, LABELS=str(write_raster(tmp_path / "labels.tif", pixels, **options)))
    assert [word for word in ["labels.tif", *words] if word not in sentence] == []


@pytest.mark.parametrize("key", ["WINDOW_SIZE", "STRIDE"])
@pytest.mark.parametrize("value", [0, -5, "wide"])
def test_a_window_or_stride_that_is_no_length_is_refused_by_name(refused, key, value):
    assert key in refused(BUILD, **{key: value})


@pytest.mark.parametrize(("classes", "words"), [("", "Reference classes"), ("building;lighthouse", "“lighthouse”")])
def test_missing_and_unknown_reference_classes_are_refused_with_those_of_the_map(refused, classes, words):
    sentence = refused(BUILD, REFERENCE_CLASSES=classes)
    assert words in sentence and "1 building" in sentence
