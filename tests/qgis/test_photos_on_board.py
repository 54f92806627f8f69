import json

import numpy as np
import pytest
from made_inputs import CLASSES_CSV, NORTH, WEST, scattered_objects, write_raster
from made_models import brightest_color, metadata, painted, write_model
from qgis.core import QgsProcessingFeedback

from semref.core.geometry.error_settings import NETWORK_SPREAD
from semref.core.labels.class_table import class_table_from_csv
from semref.core.onboard.image_records import label_reader
from semref.core.segmentation.onnx_file import with_metadata
from semref.processing.inspection.image import photo_rgba
from semref.processing.jobs.photo_labels import PhotoLabelReader
from semref.storage.images import GdalImage

TABLE = class_table_from_csv(CLASSES_CSV)
NOISE = np.random.default_rng(6).normal(0, 25, (150, 190, 3))
PHOTO = np.clip(painted(scattered_objects(150, 190, 70, seed=6, background=0)) + NOISE, 0, 255).astype(np.uint8)
BANDS = np.moveaxis(PHOTO, 2, 0)
HOLE = np.full((1, *PHOTO.shape[:2]), 255, np.uint8)
HOLE[:, 30:90, 50:120] = 0


def meters(size, turn=0.0):
    return WEST, size, turn, NORTH, turn, -size


def with_fourth_band(path, band, *options):
    return write_raster(path, np.concatenate([BANDS, band]), transform=meters(0.31), options=options)


PHOTOS = {
    "meters, shrunk": lambda path: write_raster(path, BANDS, transform=meters(0.31)),
    "meters, grown": lambda path: write_raster(path, BANDS, transform=meters(0.8)),
    "turned": lambda path: write_raster(path, BANDS, transform=meters(0.2, 0.1)),
    "degrees": lambda path: write_raster(path, BANDS, crs=4326, transform=(8, 3e-6, 0, 60, 0, -2e-6)),
    "feet": lambda path: write_raster(path, BANDS, crs=2263, transform=(1e6, 1, 0, 2e5, 0, -1)),
    "the model's resolution": lambda path: write_raster(path, BANDS, transform=meters(0.51)),
    "no CRS": lambda path: write_raster(path, BANDS, crs=None, transform=meters(0.2)),
    "no georeference": lambda path: write_raster(path, BANDS, transform=None),
    "nodata": lambda path: write_raster(path, BANDS * (HOLE > 0), nodata=0, transform=meters(0.31)),
    "transparent": lambda path: with_fourth_band(path, HOLE, "PHOTOMETRIC=RGB", "ALPHA=YES"),
    "half transparent": lambda path: with_fourth_band(path, HOLE // 2, "PHOTOMETRIC=RGB", "ALPHA=YES"),
    "near infrared": lambda path: with_fourth_band(path, HOLE, "PHOTOMETRIC=RGB", "ALPHA=UNSPECIFIED"),
    "gray": lambda path: write_raster(path, BANDS[0], transform=meters(0.31)),
    "PNG": lambda path: write_raster(path.with_suffix(".png"), BANDS, transform=None),
}


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    path = tmp_path_factory.mktemp("model") / "m.onnx"
    return str(write_model(path, brightest_color(3), metadata=metadata(resolution=50, temperature=0.2)))


@pytest.mark.slow
@pytest.mark.parametrize("name", PHOTOS)
def test_a_photo_has_the_same_labels_and_shares_in_qgis_and_on_board(qgis_app, model, tmp_path, name, monkeypatch):
    path = str(PHOTOS[name](tmp_path / "photo.tif"))
    reader, read, opened = PhotoLabelReader(model, TABLE, QgsProcessingFeedback(False)), GdalImage.read, []
    seen, on_board = reader(path), label_reader(model, 1, TABLE)(path)
    assert seen.labels_hw.shape == PHOTO.shape[:2]
    assert len(np.unique(seen.labels_hw)) >= (1 if name == "gray" else 3)
    # A photo is read once for labels and motion.
    monkeypatch.setattr(GdalImage, "read", lambda self, *window: opened.append(window) or read(self, *window))
    again = reader(path, with_pixels=True)
    pixels, has_data = again.pixels
    assert opened == [(0, 0, PHOTO.shape[1], PHOTO.shape[0])]
    assert pixels.shape == PHOTO.shape and (has_data is None or has_data.shape == PHOTO.shape[:2])
    for other in (on_board, again):
        np.testing.assert_array_equal(other.labels_hw, seen.labels_hw)
        np.testing.assert_array_equal(other.shares.shares, seen.shares.shares)


def test_what_a_model_states_of_its_classes_is_known_in_qgis_as_on_board(qgis_app, model, tmp_path):
    path = tmp_path / "off.onnx"
    stated = json.dumps({"building": {"east": 0.5, "spread": 0.2, "sun": 120}})
    with open(model, "rb") as file:
        path.write_bytes(with_metadata(file.read(), "class_bias", stated))
    photo = str(PHOTOS["PNG"](tmp_path / "photo.png"))
    known = label_reader(str(path), 1, TABLE)(photo).biases
    assert known == PhotoLabelReader(str(path), TABLE, QgsProcessingFeedback(False))(photo).biases
    (bias,) = known.class_biases
    assert (bias.east, bias.spread, bias.sun_deg) == (0.5, 0.2, 120.0) and known.class_spread == NETWORK_SPREAD


HALVES = np.zeros((3, 300, 401), np.uint8)
HALVES[0, :, :200], HALVES[2, :, 200:] = 200, 100


@pytest.mark.parametrize(("longest", "shape"), [(1600, (300, 401)), (401, (300, 401)), (100, (60, 80)), (1, (1, 1))])
def test_a_photo_is_shown_no_larger_than_asked(qgis_app, tmp_path, longest, shape):
    shown = photo_rgba(str(write_raster(tmp_path / "a.png", HALVES, transform=None)), longest)
    assert shown.shape == (*shape, 4) and shown.dtype == np.uint8 and (shown[..., 3] == 255).all()
    if shape[1] > 1:
        height, width = shape
        assert shown[height // 2, width // 4].tolist() == [200, 0, 0, 255]
        assert shown[height // 2, 3 * width // 4].tolist() == [0, 0, 100, 255]


def test_a_photo_of_16_bits_is_shown_stretched_when_reduced(qgis_app, tmp_path):
    shown = photo_rgba(str(write_raster(tmp_path / "a.tif", HALVES.astype(np.uint16) * 20, transform=None)), 100)
    assert shown.shape == (60, 80, 4) and shown[30, 20, 0] > 200 and shown[30, 60, 0] < 50


@pytest.mark.real_data
def test_an_original_of_a_drone_is_shown(qgis_app, real_data):
    shown = photo_rgba(str(real_data("dji_brighton_beach/DJI_0018.JPG")), 1600)
    assert max(shown.shape[:2]) <= 1600 and shown[..., :3].std() > 10
