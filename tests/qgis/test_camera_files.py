import struct
from dataclasses import replace
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
    write_text,
)
from made_tiff import image_tiff, tiff
from osgeo import osr

from semref.core.flight.cameras import read_cameras
from semref.processing.layers.localized_image import far_sentence
from semref.processing.messages.camera_messages import camera_read, camera_remark
from semref.storage.photo_position import photo_lon_lat

DJI = 'drone-dji:GimbalRollDegree="+0.00" drone-dji:GimbalPitchDegree="-80.00" drone-dji:GimbalYawDegree="+12.30"'
PIX4D = "<Camera:Roll>4.5</Camera:Roll><Camera:Pitch>-3</Camera:Pitch>"


def label_image(folder: Path, name: str = "IMG_1.png", width: int = 40, height: int = 30) -> str:
    return str(write_raster(folder / name, np.ones((height, width), np.uint8), transform=None))


def photo(path: Path, xmp: str = "", **exif) -> Path:
    """Write a JPEG of 80 × 60 pixels with EXIF items and an XMP packet that has ``xmp`` as attributes or elements."""
    write_photo(path, (80, 60), **exif)
    if xmp:
        attributes, elements = ("", xmp) if xmp.startswith("<") else (xmp, "")
        packet = f"<x:xmpmeta><rdf:RDF><rdf:Description {attributes}>{elements}</rdf:Description></rdf:RDF></x:xmpmeta>"
        body = b"http://ns.adobe.com/xap/1.0/\0" + packet.encode()
        data = path.read_bytes()
        path.write_bytes(data[:2] + b"\xff\xe1" + struct.pack(">H", len(body) + 2) + body + data[2:])
    return path


def table(folder: Path, text: str) -> str:
    return str(write_text(folder / "cameras.csv", text))


def angles(camera) -> tuple:
    return camera.attitude.roll_deg, camera.attitude.pitch_deg


DEWARP = 'drone-dji:DewarpData="2018-03-13;60.2,60.1,-0.13,0.75,-0.269478,0.115681,-0.0000875,-0.000306,-0.0357628"'
"""Values that a Phantom 4 RTK states, for photos of 80 × 60 pixels."""


def test_what_dji_states_of_its_lens_straightens_the_image(tmp_path):
    photo(tmp_path / "IMG_1.jpg", f'{DEWARP} drone-dji:DewarpFlag="0" drone-dji:RelativeAltitude="+40.0"')
    (camera,) = read_cameras([label_image(tmp_path)], "")
    lens = camera.distortion
    assert lens.focal_xy == pytest.approx((60.2 / 80, 60.1 / 80))
    assert lens.center_xy == pytest.approx((-0.13 / 80, 0.75 / 80))
    assert lens.radial == (-0.269478, 0.115681, -0.0357628) and lens.tangential == (-0.0000875, -0.000306)
    # On a label image of half the size.
    way = camera.leveling((30, 40))
    assert way.bent is not None and way.nadir is None and way.shape_hw > (30, 40)
    expected = "focal length 30 px, height 40.0 m, lens distortion up to 16.7 % of the width corrected"
    assert camera_read(camera, (30, 40)) == expected


@pytest.mark.parametrize(
    "xmp",
    [
        f'{DEWARP} drone-dji:DewarpFlag="1"',
        *(f'drone-dji:DewarpData="{data}"' for data in ("", "2018-03-13;60.2,60.1,-0.13")),
        'drone-dji:DewarpData="2018-03-13;60.2,60.1,nan,0,-0.2,0,0,0,0"',
        *(f'drone-dji:DewarpData="{data},0,0,0,0"' for data in ("60,60,0,0,-9", "60,60,0,0,0", "one,two,0,0,0")),
    ],
    ids=["corrected in the camera", "empty", "too short", "no number", "turns back", "bends nothing", "words"],
)
def test_a_photo_that_is_straight_or_states_no_lens_is_left_as_it_is(tmp_path, xmp):
    photo(tmp_path / "IMG_1.jpg", xmp)
    (camera,) = read_cameras([label_image(tmp_path)], "")
    assert camera.distortion is None and camera.leveling((30, 40)) is None


def test_a_focal_length_in_the_table_replaces_the_lens_of_the_photo(tmp_path):
    photo(tmp_path / "IMG_1.jpg", DEWARP)
    (camera,) = read_cameras([label_image(tmp_path)], table(tmp_path, "image,focal_length_px\nIMG_1.png,35\n"))
    assert camera.distortion is None and camera.lens.value == 35


def test_a_lens_of_eight_factors_is_read_too(tmp_path):
    photo(tmp_path / "IMG_1.jpg", 'drone-dji:DewarpDataK6="2024-01-01;60,60,0,0,0.2,0.03,0,0,0,0.4,0.05,0.001"')
    (camera,) = read_cameras([label_image(tmp_path)], "")
    assert camera.distortion.radial == (0.2, 0.03, 0.0, 0.4, 0.05, 0.001)


@pytest.mark.real_data
def test_original_drone_photos_are_read_and_state_no_lens(real_data):
    path = real_data("dji_brighton_beach/DJI_0018.JPG")
    (camera,) = read_cameras([str(path)], "")
    assert camera.distortion is None
    said = camera_read(camera, (2250, 4000))
    assert said == "focal length 2,310 px, height 39.8 m, heading 45.0°, roll 0.0°, pitch 0.1°"


def test_a_table_gives_attitude_focal_length_and_time(tmp_path):
    text = "image,roll,pitch,focal_length_px,time\nIMG_1.png,1.5,-20,35,12.25\n"
    (camera,) = read_cameras([label_image(tmp_path)], table(tmp_path, text))
    assert angles(camera) == (1.5, -20) and camera.time_s == 12.25 and camera.source == "cameras.csv"
    assert camera.lens.focal_length_px((30, 40)) == 35
    assert "roll 1.5°, pitch -20.0° (cameras.csv)" in camera_remark(camera, (30, 40))
    level = replace(camera, attitude=replace(camera.attitude, roll_deg=-0.03, pitch_deg=-0.0))
    assert "roll 0.0°, pitch 0.0°" in camera_remark(level, (30, 40))
    assert camera.leveling((30, 40)).shape_hw != (30, 40)


@pytest.mark.parametrize(
    ("text", "seconds"),
    [("7.5", 7.5), ("1970-01-01T00:01:00.250", 60.25), ("1970-01-01 00:01:00Z", 60), ("1970-01-01T01:01:00+01:00", 60)],
)
def test_times_are_seconds_or_dates(tmp_path, text, seconds):
    (camera,) = read_cameras([label_image(tmp_path)], table(tmp_path, f"image,time\nIMG_1,{text}\n"))
    assert camera.time_s == seconds and camera.attitude is None


def test_the_photo_of_the_same_name_gives_the_gimbal_angles(tmp_path):
    exif = {"DateTimeOriginal": "1970:01:01 00:01:00", "SubSecTime_Original": "50", "FocalLengthIn35mmFilm": "24"}
    photo(tmp_path / "IMG_1.jpg", DJI, **exif)
    (camera,) = read_cameras([label_image(tmp_path)], "")
    assert angles(camera) == pytest.approx((0, 10))
    assert camera.time_s == 60.5 and camera.source == "IMG_1.jpg"
    assert camera.lens.focal_length_px((30, 40)) == pytest.approx(24 / 43.267 * 50, rel=1e-4)
    assert camera.leveling((30, 40)) is not None


def test_pix4ds_roll_has_the_right_side_down(tmp_path):
    path = photo(tmp_path / "IMG_1.jpg", PIX4D)
    (camera,) = read_cameras([str(path)], "")
    assert angles(camera) == (-4.5, -3)


@pytest.mark.parametrize(
    ("focal_length", "width", "remark"),
    [
        ("0", 40, "Not leveled, because IMG_1.jpg contains no focal length."),
        ("24", 30, "the shape that IMG_1.jpg gives"),
    ],
)
def test_without_a_focal_length_of_its_shape_an_image_is_not_leveled_with_a_note(tmp_path, focal_length, width, remark):
    photo(tmp_path / "IMG_1.jpg", DJI, FocalLengthIn35mmFilm=focal_length)
    (camera,) = read_cameras([label_image(tmp_path, width=width)], "")
    assert camera.leveling((30, width)) is None and remark in camera_remark(camera, (30, width))


def test_a_photo_with_an_orientation_tag_gives_no_attitude(tmp_path):
    photo(tmp_path / "IMG_1.jpg", DJI, FocalLengthIn35mmFilm="24", Orientation="6")
    (camera,) = read_cameras([label_image(tmp_path)], "")
    assert camera.attitude is None


def test_the_table_comes_before_the_photo_and_the_photo_fills_its_gaps(tmp_path):
    exif = {"DateTimeOriginal": "1970:01:01 00:01:00", "FocalLengthIn35mmFilm": "24"}
    for number in (1, 2):
        photo(tmp_path / f"IMG_{number}.jpg", DJI, **exif)
    images = [label_image(tmp_path, f"IMG_{number}.png") for number in (1, 2)]
    first, second = read_cameras(images, table(tmp_path, "image,roll,pitch\nIMG_1,0,0\n"))
    assert angles(first) == (0, 0) and first.lens.value == 24 and first.leveling((30, 40)) is None
    assert angles(second) == pytest.approx((0, 10)) and (first.time_s, second.time_s) == (60, 60)
    timed, untimed = read_cameras(images, table(tmp_path, "image,time\nIMG_1,7\n"))
    assert (timed.time_s, untimed.time_s) == (7, None)


SIZE = 160
LABELS = scattered_objects(500, 600, 380, seed=7, background=0)
NAMES = ["unlabeled", "water", "building", "bare_land"]
SAID = "The GPS position of this photo is"


def exif(longitude: float, latitude: float, **more: str) -> dict[str, str]:
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


ODD = {"GPSStatus": "V"}, {"GPSLatitudeRef": "Q"}, {"GPSLongitude": "(181) (0) (0)"}
WITHOUT_SIDE = {name: text for name, text in exif(9.5, 47.1).items() if name != "GPSLatitudeRef"}


@pytest.mark.parametrize("tags", [{}, exif(0, 0), *(exif(9.5, 47.1, **one) for one in ODD), WITHOUT_SIDE])
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
def test_photos_taken_far_away_show_the_distance_and_reason(run_algorithm, database, tmp_path, feedback, algorithm):
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
