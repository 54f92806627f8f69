import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from made_inputs import NORTH, WEST, read_rows, scattered_objects, turned_view, write_raster
from made_models import ground_and_colors, metadata, painted, write_model
from osgeo import gdal
from qgis.core import QgsProcessingException

from semref.core.segmentation.onnx_file import with_metadata
from semref.storage.label_images import stated_biases

LOCALIZE = "semref:localizeimages"
SIZE = 160
NAMES = ["unlabeled", "water", "Building", "bare_land"]
"""Values differ from the model's channels, and one name is spelled differently."""
LABELS = scattered_objects(500, 600, 380, seed=7, background=0)
TO_MODEL = np.array([0, 2, 1, 3], np.uint8)
"""Label of this map → color of made_models; its first class is building."""

CLASSES = ["ground", "building", "water", "bare_land"]


@pytest.fixture(scope="module")
def folder(build_area, tmp_path_factory):
    folder = tmp_path_factory.mktemp("area")
    shutil.copy(build_area(LABELS, NAMES, SIZE, 40), folder / "area.gpkg")
    write_model(folder / "colors.onnx", ground_and_colors(), metadata=metadata(class_names=CLASSES))
    return folder


def photo_of(labels: np.ndarray) -> np.ndarray:
    return np.moveaxis(painted(TO_MODEL[labels]), 2, 0)


@pytest.fixture
def localize(runner, folder, tmp_path):
    """`localize(images, **parameters)` returns a row for each image."""
    given = {"DATABASE": folder / "area.gpkg", "MODEL": folder / "colors.onnx", "METHOD": 2}
    run = runner(LOCALIZE, "IMAGES", **given, OUTPUT=tmp_path / "positions.gpkg")
    return lambda images, **parameters: read_rows(run(images, **parameters)["OUTPUT"])


@pytest.fixture
def jpeg(tmp_path):
    def write(labels: np.ndarray) -> Path:
        plain = write_raster(tmp_path / "a.png", photo_of(labels), transform=None)
        gdal.Translate(str(tmp_path / "a.jpg"), str(plain), format="JPEG")
        return tmp_path / "a.jpg"

    return write


@pytest.mark.slow
@pytest.mark.parametrize("heading", [12, 137])
def test_a_photo_is_found_where_it_was_taken(localize, tmp_path, heading):
    view = turned_view(LABELS, SIZE, 311.4, 207.8, heading)
    (found,) = localize([write_raster(tmp_path / "a.png", photo_of(view), transform=None)])
    assert found["status"] == "fix"
    assert (found["x"], found["y"]) == pytest.approx((WEST + 311.4, NORTH - 207.8), abs=1)
    assert found["heading"] == pytest.approx(heading, abs=0.5)


def test_a_photo_without_a_position_is_labeled_again_and_the_log_says_so(localize, tmp_path, feedback):
    views = turned_view(LABELS, SIZE, 311.4, 207.8, 137), turned_view(LABELS, SIZE, 311.4, 207.8, 137)[:, ::-1]
    paths = [tmp_path / "right.png", tmp_path / "mirrored.png"]
    found = localize([write_raster(path, photo_of(view), transform=None) for path, view in zip(paths, views)])
    assert [row["status"] == "fix" for row in found] == [True, False]
    words = "mirrored.png: no position. The network segments it again, turned and mirrored."
    assert words in feedback.textLog() and "right.png: no position" not in feedback.textLog()


@pytest.mark.parametrize("algorithm", [LOCALIZE, "semref:localizeflight"])
def test_height_and_lens_of_a_photo_set_its_scale_for_the_network(run_algorithm, folder, tmp_path, feedback, algorithm):
    model = write_model(tmp_path / "m.onnx", ground_and_colors(), metadata=metadata(class_names=CLASSES, resolution=50))
    photo = write_raster(tmp_path / "a.png", photo_of(turned_view(LABELS, SIZE, 311.4, 207.8, 0)), transform=None)
    table = tmp_path / "cameras.csv"
    table.write_text("image,focal_length_px,height\na.png,100,100\n", encoding="utf-8")
    parameters = {"DATABASE": str(folder / "area.gpkg"), "MODEL": str(model), "IMAGES": [str(photo)]}
    run_algorithm(algorithm, {**parameters, "ATTITUDE": str(table), "OUTPUT": str(tmp_path / "p.gpkg")}, feedback)
    assert "a.png: the ground sampling distance is 100 cm" in feedback.textLog()
    assert "uses the photo at 50 cm" in feedback.textLog()


def test_photos_without_a_model_get_a_warning(localize, jpeg, tmp_path, feedback):
    photo, words = jpeg(LABELS[:SIZE, :SIZE]), "The images are photos, but no model is selected."
    localize([photo], MODEL=None)
    assert f"{words} Their colors are read as class colors." in feedback.textLog()
    localize([write_raster(tmp_path / "b.png", LABELS[:SIZE, :SIZE], transform=None)], MODEL=None)
    localize([photo])
    assert feedback.textLog().count(words) == 1
    colors = np.random.default_rng(3).integers(0, 255, (3, SIZE, SIZE), np.uint8)
    localize([write_raster(tmp_path / "a.tif", colors, transform=None)], MODEL=None)
    assert feedback.textLog().count(words) == 2


def test_a_photo_that_was_cut_short_is_unreadable_and_one_with_other_warnings_is_not(localize, jpeg):
    photo = jpeg(LABELS)
    content = photo.read_bytes()
    photo.write_bytes(content[:2000])
    for model in ({}, {"MODEL": None}):
        (found,) = localize([photo], **model)
        assert found["status"] == "error"
        assert found["reason"] == f"{photo} is damaged or cut short: Premature end of JPEG file."
    photo.write_bytes(content[:-2] + bytes(9) + content[-2:])
    assert localize([photo])[0]["status"] != "error"


def test_files_of_no_image_get_a_reason_with_a_next_step(localize, jpeg):
    for content, words in ((b"", "is empty (0 bytes). Copy"), (b"my notes", "or HEIC, as JPEG with their camera")):
        for name in ("a.jpg", "a.heic"):
            (photo := jpeg(LABELS).with_name(name)).write_bytes(content)
            assert words in localize([photo.parent])[0]["reason"]
            photo.unlink()


@pytest.mark.parametrize(
    ("names", "words"),
    [
        (["building", "water", "snow"], "was not trained on the database's class bare_land"),
        (None, r"does not name its classes \(metadata key class_names\); choose a model that does"),
    ],
)
def test_a_model_without_the_databases_classes_is_refused(localize, photo, tmp_path, names, words):
    model = write_model(tmp_path / "m.onnx", metadata=metadata(class_names=names))
    with pytest.raises(QgsProcessingException, match=words) as error:
        localize([photo], MODEL=str(model))
    assert "CLASS_TABLE" not in str(error.value) and not (tmp_path / "positions.gpkg").exists()


@pytest.fixture
def off_by(folder, tmp_path):
    """Return a model that states the offset of each class; east and north, m."""

    def make(east, north, **more):
        stated = {name: {"east": east, "north": north, "spread": 0.1, **more} for name in CLASSES[1:]}
        path = tmp_path / "off.onnx"
        path.write_bytes(with_metadata((folder / "colors.onnx").read_bytes(), "class_bias", json.dumps(stated)))
        return str(path)

    return make


@pytest.fixture
def photo(tmp_path):
    labels = turned_view(LABELS, SIZE, 300, 250, 33)
    return write_raster(tmp_path / "photo.tif", photo_of(labels), transform=None)


def position(row):
    return np.array([row["x"], row["y"]])


# Landmarks too far east move the image too far west.


def test_a_models_bias_is_taken_off_and_without_one_the_radius_is_larger(localize, off_by, photo):
    (silent,) = localize([photo])
    (stated,) = localize([photo], MODEL=off_by(2.0, -1.0))
    np.testing.assert_allclose(position(stated) - position(silent), [2.0, -1.0], atol=0.1)
    assert silent["error_95"] > 1 and stated["error_95"] < silent["error_95"]
    assert "class offset" in silent["reason"]


def test_a_bias_of_shadows_turns_with_the_sun(localize, off_by, photo):
    (silent,) = localize([photo])
    (turned,) = localize([photo], MODEL=off_by(0.0, 2.0, sun=180), SUN_DIRECTION=270)
    np.testing.assert_allclose(position(turned) - position(silent), [2.0, 0.0], atol=0.1)
    (unknown,) = localize([photo], MODEL=off_by(0.0, 2.0, sun=180))
    np.testing.assert_allclose(position(unknown), position(silent), atol=0.1)
    assert unknown["error_95"] > silent["error_95"] > turned["error_95"]


def test_a_label_map_carries_the_bias_of_the_network_that_made_it(run_algorithm, localize, off_by, photo, tmp_path):
    labels = str(tmp_path / "labels.tif")
    run_algorithm("semref:segmentimage", {"INPUT": str(photo), "MODEL": off_by(2.0, -1.0), "OUTPUT": labels})
    (from_photo,) = localize([photo], MODEL=off_by(2.0, -1.0), LABELS=str(tmp_path / "kept"))
    kept = str(tmp_path / "kept" / "photo.tif")
    (again,) = localize([kept], MODEL=None)
    # The last digits of the radius vary from run to run.
    assert [again[key] for key in ("x", "y", "error_95")] == pytest.approx(
        [from_photo[key] for key in ("x", "y", "error_95")], rel=1e-12
    )
    assert json.loads(stated_biases(labels)) == json.loads(stated_biases(kept)) != {}
