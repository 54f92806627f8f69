import numpy as np
import pytest
from made_inputs import NAMES, NORTH, WEST, read_rows, scattered_objects, turned_view, write_raster
from osgeo import gdal

from semref.core.localization import Method
from semref.core.localizer.localizer import Localizer
from semref.storage.database.reader import read_database

LOCALIZE = "semref:localizeimages"
LABELS = scattered_objects(900, 1000, 1300, seed=5)
SIZE = 300


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(LABELS, NAMES, SIZE, SIZE / 2)


def view(column: float, row: float, heading: float, scale: float = 1.0, labels=LABELS) -> np.ndarray:
    return turned_view(labels, SIZE, column, row, heading, scale)


@pytest.fixture
def localize(run_algorithm, database, tmp_path):
    """`localize(labels, **parameters)` returns the row of the image, and the rows of each other output by its key."""

    def run(labels, **parameters):
        path = write_raster(tmp_path / "photo.png", labels, transform=None)
        outputs = {key: str(tmp_path / f"{key}.gpkg") for key in ("OUTPUT", "FOOTPRINTS", "MATCHES", "ALTERNATIVES")}
        run_algorithm(LOCALIZE, {"DATABASE": database, "IMAGES": [str(path)], **outputs, **parameters})
        found = {key: read_rows(path) for key, path in outputs.items()}
        (row,) = found["OUTPUT"]
        return row, found

    return run


@pytest.mark.slow
@pytest.mark.parametrize(
    ("column", "row", "heading", "scale"),
    [(400, 400, 0, 1.0), (333.3, 517.7, 47, 1.0), (612, 455, 200, 1.2), (501, 380, 312, 0.8)],
)
def test_an_image_between_windows_is_found_with_heading_and_pixel_size(localize, column, row, heading, scale):
    found, others = localize(view(column, row, heading, scale))
    (footprint,) = (one["geometry"] for one in others["FOOTPRINTS"])
    assert found["status"] == "fix" and found["method"] == "constellation"
    assert (found["x"], found["y"]) == pytest.approx((WEST + column, NORTH - row), abs=1.0)
    assert (found["heading"] - heading + 180) % 360 - 180 == pytest.approx(0, abs=0.5)
    assert found["pixel_size"] == pytest.approx(scale, rel=0.01)
    assert 0 < found["error_95"] < 3 and found["log_odds"] > 20.7 and found["confidence"] > 0.9
    assert 0 < found["error_95_minor"] <= found["error_95"] and 0 <= found["error_95_direction"] <= 180
    assert 0 < found["heading_deviation"] < 1 and 0 < found["pixel_size_deviation"] < 0.03
    assert footprint.GetArea() == pytest.approx((SIZE * scale) ** 2, rel=0.02)
    center = footprint.Centroid()
    assert (center.GetX(), center.GetY()) == pytest.approx((found["x"], found["y"]), abs=0.1)


def test_matches_pair_landmarks_of_image_and_map(localize):
    column, row, heading, scale = 612, 455, 200, 1.2
    found, others = localize(view(column, row, heading, scale))
    matches = others["MATCHES"]
    assert [one["number"] for one in matches] == list(range(1, found["inliers"] + 1))
    turn = scale * np.exp(-1j * np.radians(heading))
    for one in matches:
        x, y = one["geometry"].GetPoint_2D()
        assert one["image"] == found["image"] and one["class_name"] == NAMES[one["class"]]
        truth = turn * complex(one["image_column"] - SIZE / 2, SIZE / 2 - one["image_row"])
        assert (x - WEST - column, y - NORTH + row) == pytest.approx((truth.real, truth.imag), abs=3)
        off = np.hypot(one["seen_x"] - x, one["seen_y"] - y)
        assert one["residual"] == pytest.approx(off, abs=1e-6) and off < 3


@pytest.mark.slow
def test_an_ambiguous_image_has_its_possible_places_as_polygons(localize, build_area):
    twins = np.hstack([LABELS[:, :500], LABELS[:, :500]])
    row, others = localize(view(250, 400, 30, labels=twins), DATABASE=build_area(twins, NAMES, SIZE, SIZE / 2))
    places = others["ALTERNATIVES"]
    assert row["status"] == "ambiguous" and row["x"] is None and row["error_95_minor"] is None
    assert sorted(one["geometry"].Centroid().GetX() - WEST for one in places) == pytest.approx([250, 750], abs=1)
    assert [one["rank"] for one in places] == [1, 2]
    assert [one["heading"] for one in places] == pytest.approx([30, 30], abs=0.5)


@pytest.fixture(scope="module")
def town(real_data, run_algorithm, tmp_path_factory):
    """Return a localizer on the buildings of Banepa, Nepal."""
    folder = tmp_path_factory.mktemp("town")
    labels, database = str(folder / "labels.tif"), str(folder / "town.gpkg")
    drawn = {"INPUT": str(real_data("banepa/banepa_buildings.gpkg")), "CLASS": "building", "PIXEL_SIZE": 0.5}
    run_algorithm("semref:rasterizeannotation", {**drawn, "OUTPUT": labels})
    built = {"DATABASE": database, "WINDOW_SIZE": 150, "STRIDE": 40, "MINIMUM_AREA": 12}
    run_algorithm("semref:builddatabase", {"LABELS": labels, "REFERENCE_CLASSES": "building", **built})
    return Localizer(read_database(database, with_overview=True))


@pytest.mark.real_data
@pytest.mark.slow
@pytest.mark.parametrize("tile", [1, 2, 4, 6])
def test_buildings_of_another_continent_are_neither_placed_nor_called_ambiguous(town, real_data, tile):
    labels = gdal.Open(str(real_data(f"dubai_aerial/tile{tile}_label.tif"))).ReadAsArray()
    crops = [
        labels[row : row + 512, column : column + 512]
        for row in range(0, labels.shape[0] - 511, 512)
        for column in range(0, labels.shape[1] - 511, 512)
    ]
    images = [np.where(crop == 1, 1, 2).astype(np.uint8) for crop in crops if (crop == 1).sum() >= 500]
    assert images
    statuses = {town.localize(image, Method.AUTOMATIC).status.key for image in images}
    assert statuses <= {"no_match", "too_few_references"}
