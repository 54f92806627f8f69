"""Positions that photos state: reported if they are far from the database's ground, and never used."""

from pathlib import Path

import numpy as np
import pytest
from made_inputs import (
    NORTH,
    WEST,
    read_rows,
    scattered_objects,
    spatial_reference,
    turned_view,
    write_photo,
    write_raster,
)
from made_tiff import image_tiff, tiff
from osgeo import osr

from semref.processing.base.localized_image import far_sentence
from semref.storage.photo_position import photo_lon_lat

SIZE = 160
LABELS = scattered_objects(500, 600, 380, seed=7, background=0)
NAMES = ["unlabeled", "water", "building", "bare_land"]
SAID = "The GPS position of this photo is"


def exif(longitude: float, latitude: float, **more: str) -> dict[str, str]:
    """Return EXIF as cameras write it."""
    found = {}
    for name, value, letters in (("Longitude", longitude, "EW"), ("Latitude", latitude, "NS")):
        whole, rest = divmod(abs(value), 1)
        minutes, rest = divmod(60 * rest, 1)
        found[f"GPS{name}"] = f"({whole:.0f}) ({minutes:.0f}) ({60 * rest:.4f})"
        found[f"GPS{name}Ref"] = letters[value < 0]
    return {**found, **more}


@pytest.mark.parametrize("place", [(9.5213, 47.1401), (-91.9945, 46.8426), (151.2, -33.86), (0.0, 51.4779)])
def test_a_photos_position_is_read_to_a_meter(tmp_path, place):
    assert photo_lon_lat(write_photo(tmp_path / "a.jpg", **exif(*place))) == pytest.approx(place, abs=1e-5)


def test_that_of_a_tiff_is_read_as_well(tmp_path):
    data, place = bytearray(image_tiff(np.ones((1, 1), np.uint8), 1, t34853=(20_000,))), 20_000
    gps = tiff([(1, 2, b"S\0"), (2, 5, (33, 1, 30, 1, 36, 1)), (3, 2, b"W\0"), (4, 5, (70, 1, 15, 1, 0, 1))], at=place)
    data[place : len(gps)] = gps[place:]
    (tmp_path / "a.tif").write_bytes(data)
    assert photo_lon_lat(str(tmp_path / "a.tif")) == pytest.approx((-70.25, -33.51), abs=1e-6)


def test_a_label_image_is_where_the_photo_of_its_name_beside_it_was_taken(tmp_path):
    label_image = write_raster(tmp_path / "a.png", np.ones((24, 32), np.uint8), transform=None)
    assert photo_lon_lat(str(label_image)) is None
    write_photo(tmp_path / "a.JPG", **exif(9.5, 47.1))
    assert photo_lon_lat(str(label_image)) == pytest.approx((9.5, 47.1))


@pytest.mark.parametrize(
    "tags",
    [
        {},
        exif(0, 0),
        exif(9.5, 47.1, GPSStatus="V"),
        exif(9.5, 47.1, GPSLatitudeRef="Q"),
        exif(9.5, 47.1, GPSLongitude="(181) (0) (0)"),
        {name: text for name, text in exif(9.5, 47.1).items() if name != "GPSLatitudeRef"},
    ],
    ids=["none", "0, 0", "void", "no side", "too far", "side missing"],
)
def test_an_impossible_photo_position_is_ignored(tmp_path, tags):
    assert photo_lon_lat(write_photo(tmp_path / "a.jpg", **tags)) is None


@pytest.mark.parametrize(("meters", "said"), [(1_234.0, "1.2 km"), (12_340.0, "12 km"), (8_412_300.0, "8,412 km")])
def test_a_distance_is_shown_with_its_own_accuracy(meters, said):
    assert far_sentence(meters) == f"{SAID} {said} from the ground of the database."


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(LABELS, NAMES, SIZE, 40)


def lon_lat(east: float, north: float) -> tuple[float, float]:
    """Return longitude and latitude of a place so many meters from the upper left corner of the map."""
    to_degrees = osr.CoordinateTransformation(spatial_reference(32632), spatial_reference(4326))
    return to_degrees.TransformPoint(WEST + east, NORTH + north)[:2]


@pytest.mark.slow
@pytest.mark.parametrize("algorithm", ["semref:localizeimages", "semref:localizeflight"])
def test_photos_taken_far_away_show_the_distance_with_their_reason(
    run_algorithm, database, tmp_path, feedback, algorithm
):
    """This applies with and without a position: the user decides about a fix far from the photo's GPS."""
    empty = np.zeros((SIZE, SIZE), np.uint8)
    shown = {"empty": empty, "found": turned_view(LABELS, SIZE, 311.4, 207.8, 40)}
    places = {"here": lon_lat(300, -200), "near": lon_lat(-900, -200), "far": lon_lat(600 + 42_000, -200)}
    images = []
    for kind, labels in shown.items():
        for place, stated in places.items():
            images.append(str(write_raster(tmp_path / f"{kind}_{place}.png", labels, transform=None)))
            write_photo(tmp_path / f"{kind}_{place}.jpg", **exif(*stated))
    images.append(str(write_raster(tmp_path / "empty_silent.png", empty, transform=None)))
    given = {"DATABASE": database, "IMAGES": images, "METHOD": 2, "OUTPUT": str(tmp_path / "positions.gpkg")}
    results = run_algorithm(algorithm, given, feedback)
    rows = read_rows(results["OUTPUT"])
    reasons = {Path(row["image"]).stem: row["reason"] or "" for row in rows}
    status = {Path(row["image"]).stem: row["status"] for row in rows}
    assert {name for name, reason in reasons.items() if SAID in reason} == {"empty_far", "found_far"}
    away = {Path(row["image"]).stem: row["gps_distance"] for row in rows if row["gps_distance"] is not None}
    assert away == {name: pytest.approx(42_000, rel=0.01) for name in ("empty_far", "found_far")}
    for name in ("empty_far", "found_far"):
        assert reasons[name].startswith(f"{SAID} 42 km from the ground of the database.")
        assert f"{name}.png: {SAID} 42 km" in feedback.textLog()
    # GPS does not affect the result.
    assert status["found_far"] == status["found_here"] == "fix" and status["empty_far"] != "fix"
    assert reasons["empty_far"].endswith(reasons["empty_silent"]) and reasons["empty_silent"]
