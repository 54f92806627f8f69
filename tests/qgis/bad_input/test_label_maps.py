"""Unusable label maps and values are refused by name."""

from __future__ import annotations

import numpy as np
import pytest
from bad_input import BUILD, LABELS
from made_inputs import NORTH, WEST, write_raster
from osgeo import gdal


@pytest.mark.parametrize(
    ("crs", "transform", "said"),
    [
        (4326, (9.5, 0.00001, 0, 47.2, 0, -0.00001), "EPSG:4326"),
        (2263, (985000, 1, 0, 200000, 0, -1), "EPSG:2263"),
        (None, (WEST, 1, 0, NORTH, 0, -1), "coordinate reference system"),
        (32632, (WEST, 1, 0.2, NORTH, 0.2, -1), "rotated"),
        (32632, (WEST, 1, 0, NORTH, 0, 1), "mirrored"),
        (32632, (WEST, 1, 0, NORTH, 0, -2), "1 × 2"),
    ],
)
def test_a_label_map_that_is_not_metric_north_up_and_square_is_refused(refused, tmp_path, crs, transform, said):
    labels = write_raster(tmp_path / "labels.tif", LABELS, crs=crs, transform=transform)
    sentence = refused(BUILD, LABELS=str(labels))
    assert said in sentence and "labels.tif" in sentence


@pytest.mark.parametrize("kind", ["Float32", "Float64", "CInt16"])
def test_a_label_map_that_is_not_of_whole_numbers_is_refused(refused, tmp_path, kind):
    labels = write_raster(tmp_path / "labels.tif", LABELS, kind=gdal.GetDataTypeByName(kind))
    assert kind in refused(BUILD, LABELS=str(labels))


def test_a_label_map_of_several_bands_is_refused(refused, tmp_path):
    labels = write_raster(tmp_path / "labels.tif", np.stack([LABELS] * 3))
    assert "3 bands" in refused(BUILD, LABELS=str(labels))


@pytest.mark.parametrize(("value", "kind"), [(256, gdal.GDT_UInt16), (70000, gdal.GDT_Int32), (-1, gdal.GDT_Int16)])
def test_a_label_map_with_a_value_that_is_no_class_value_is_refused_with_it(refused, tmp_path, value, kind):
    labels = LABELS.astype(np.int32)
    labels[100, 100] = value
    sentence = refused(BUILD, LABELS=str(write_raster(tmp_path / "labels.tif", labels, kind=kind)))
    assert f" {value}" in sentence and "255" in sentence


def test_a_truncated_label_map_is_refused(refused, tmp_path):
    big = np.random.default_rng(1).integers(1, 5, (600, 600)).astype(np.uint8)
    labels = write_raster(tmp_path / "labels.tif", big)
    content = labels.read_bytes()
    labels.write_bytes(content[: len(content) // 2])
    assert "labels.tif" in refused(BUILD, LABELS=str(labels), WINDOW_SIZE=100)


@pytest.mark.parametrize("key", ["WINDOW_SIZE", "STRIDE"])
@pytest.mark.parametrize("value", [0, -5, "wide"])
def test_a_window_or_stride_that_is_no_length_is_refused_by_name(refused, key, value):
    assert key in refused(BUILD, **{key: value})


def test_a_map_without_reference_class_is_refused_with_its_classes(refused):
    sentence = refused(BUILD, REFERENCE_CLASSES="")
    assert "Reference classes" in sentence and "1 building" in sentence


def test_an_unknown_reference_class_is_named_with_the_classes_there_are(refused):
    sentence = refused(BUILD, REFERENCE_CLASSES="building;lighthouse")
    assert "“lighthouse”" in sentence and "1 building" in sentence
