import numpy as np
import pytest
from made_models import metadata, painted, write_model

from semref.core.geometry.camera import Camera, Lens, above_takeoff
from semref.core.labels.class_table import class_table_from_csv
from semref.core.labels.image_source import ArrayImage, Photo
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.photo_labels import PhotoLabels, PhotoReader

LABELS = np.kron(np.random.default_rng(1).integers(1, 4, (5, 7)), np.ones((20, 20), int)).astype(np.uint8)
PHOTO = ArrayImage(painted(LABELS))


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    path = write_model(tmp_path_factory.mktemp("model") / "m.onnx", metadata=metadata(resolution=50))
    return SegmentationModel(str(path), 1)


@pytest.mark.parametrize("pixel_size_m", [None, (0.5, 0.5), (0.25, 0.25), (1.0, 1.0), (0.25, 0.5)])
def test_labels_are_on_the_photos_own_pixels(model, pixel_size_m):
    np.testing.assert_array_equal(PhotoLabels(model, PHOTO, (1, 2, 3), pixel_size_m).found(), LABELS)


def test_the_steps_report_the_share_done(model):
    shares = list(PhotoLabels(model, PHOTO, (1, 2, 3)).steps())
    assert shares == sorted(shares) and shares[-1] == 1


def test_a_model_without_a_temperature_gives_certain_shares_and_the_photo_itself(model):
    found = PhotoLabels(model, PHOTO, (1, 2, 3)).seen().shares
    np.testing.assert_array_equal(found.shares, (LABELS[..., None] == [1, 2, 3]) * 255)
    np.testing.assert_array_equal(found.picture, PHOTO.read(0, 0, 140, 100)[0])


@pytest.mark.parametrize("pixel_size_m", [None, (0.25, 0.25)])
def test_a_model_with_a_temperature_gives_shares_and_the_same_labels(model, tmp_path, pixel_size_m):
    path = write_model(tmp_path / "m.onnx", metadata=metadata(resolution=50, temperature=0.05))
    found = PhotoLabels(SegmentationModel(str(path), 1), PHOTO, (1, 2, 3), pixel_size_m).seen()
    np.testing.assert_array_equal(found.labels_hw, PhotoLabels(model, PHOTO, (1, 2, 3), pixel_size_m).found())
    width, height = np.array(found.shares.shares.shape[1::-1])
    assert (height, width) == ((100, 140) if pixel_size_m is None else (50, 70))
    best = found.shares.shares.argmax(axis=2) + 1
    step = 100 // height
    assert (best == LABELS[step // 2 :: step, step // 2 :: step]).mean() > 0.9


def camera(height_m: float) -> Camera:
    """Return a camera with a focal length of 100 pixels: pixels of PHOTO cover a hundredth of the height."""
    return Camera(lens=Lens("focal_length_px", 100.0), height=above_takeoff(height_m))


def test_height_and_lens_set_the_scale_of_a_photo_for_the_network(model):
    labels = PhotoLabels(model, PHOTO, (1, 2, 3), camera=camera(25.0))
    assert labels.image.shape_hw == (50, 70) and labels.camera_pixel_size_m == pytest.approx(0.25)
    np.testing.assert_array_equal(labels.found(), LABELS)


@pytest.mark.parametrize(
    ("pixel_size_m", "known"),
    [((0.5, 0.5), camera(25.0)), (None, Camera()), (None, camera(9999.0))],
    ids=["a known pixel size", "nothing", "a height that can't be"],
)
def test_a_photo_of_known_pixel_size_or_of_no_believable_height_is_seen_as_it_is(model, pixel_size_m, known):
    labels = PhotoLabels(model, PHOTO, (1, 2, 3), pixel_size_m, known)
    assert labels.image is PHOTO and labels.camera_pixel_size_m is None


def test_a_network_that_states_no_resolution_sees_photos_as_they_are(tmp_path):
    path = write_model(tmp_path / "m.onnx", metadata=metadata())
    labels = PhotoLabels(SegmentationModel(str(path), 1), PHOTO, (1, 2, 3), camera=camera(25.0))
    assert labels.image is PHOTO


TABLE = class_table_from_csv(
    "value,name,color,role\n1,building,#ff0000,reference\n2,water,#0000ff,reference\n3,bare_land,#00ff00,reference\n"
)


def reader_of(model, shape_hw) -> PhotoReader:
    photo = ArrayImage(np.zeros((*shape_hw, 3), np.uint8))
    return PhotoReader(model, TABLE, lambda path: Photo(photo, None))


def test_a_small_photo_can_be_labeled_again_and_a_large_one_not(model):
    seen = reader_of(model, (100, 140))("a.jpg")
    again = seen.look_again()
    np.testing.assert_array_equal(again.labels_hw, seen.labels_hw)
    assert again.look_again is None and again.biases == seen.biases
    tile = model.tile_hw[0]
    assert reader_of(model, (2 * tile, 2 * tile))("a.jpg").look_again is not None
    assert reader_of(model, (8 * tile, 8 * tile))("a.jpg").look_again is None
