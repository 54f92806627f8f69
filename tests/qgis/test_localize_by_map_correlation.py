import shutil

import cv2
import numpy as np
import pytest
from edited_database import edit
from made_inputs import NORTH, WEST, read_rows, turned_view, write_raster

LOCALIZE = "semref:localizeimages"
NAMES = ["unlabeled", "building", "water", "forest", "field"]
SIZE = 400


def landscape(seed: int) -> np.ndarray:
    noise = np.random.default_rng(seed).normal(size=(1400, 1600)).astype(np.float32)
    fields = [cv2.GaussianBlur(noise, (0, 0), sigma) for sigma in (8, 25, 60)]
    height = sum(field / field.std() for field in fields)
    return np.digitize(height, np.quantile(height, (0.15, 0.5, 0.8))).astype(np.uint8) + 1


LABELS = landscape(3)


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(LABELS, NAMES, SIZE, SIZE / 2, "building;water")


@pytest.fixture
def localize(run_algorithm, database, tmp_path, feedback):
    def run(labels, **parameters):
        path = write_raster(tmp_path / "photo.png", labels, transform=None)
        given = {"DATABASE": database, "IMAGES": [str(path)], "METHOD": 3, "OUTPUT": str(tmp_path / "positions.gpkg")}
        (row,) = read_rows(run_algorithm(LOCALIZE, {**given, **parameters}, feedback)["OUTPUT"])
        return row

    return run


@pytest.mark.parametrize(
    ("column", "row", "heading"), [pytest.param(700, 600, 0, marks=pytest.mark.slow), (851.5, 733, 140)]
)
def test_an_image_is_found_by_its_areas(localize, column, row, heading):
    labels = turned_view(LABELS, SIZE, column, row, heading)
    # A tenth of the pixels are wrong, so no landmark is complete.
    wrong = np.random.default_rng(1).random(labels.shape) < 0.1
    labels[wrong] = 4
    found = localize(labels)
    assert found["status"] == "fix" and found["method"] == "map correlation"
    assert (found["x"], found["y"]) == pytest.approx((WEST + column, NORTH - row), abs=8)
    assert (found["heading"] - heading + 180) % 360 - 180 == pytest.approx(0, abs=1)
    assert found["pixel_size"] == pytest.approx(1, rel=0.02)
    assert found["error_95"] > 0 and found["window"] is None


def test_automatic_reports_that_without_overview_only_the_constellation_is_used(localize, database, tmp_path, feedback):
    path = str(shutil.copy(database, tmp_path / "old.gpkg"))
    edit(path, "DELETE FROM gpkg_contents WHERE table_name = 'overview'", "DROP TABLE overview")
    found = localize(LABELS[300 : 300 + SIZE, 400 : 400 + SIZE].copy(), METHOD=0, DATABASE=path)
    assert found["status"] == "fix" and found["method"] == "constellation"
    said = feedback.textLog()
    assert "“Automatic” uses only the constellation of landmarks, not map correlation: " in said and "overview" in said
