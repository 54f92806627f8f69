"""Cameras from CSV files, EXIF and XMP; each mistake in a CSV is one sentence with its line."""

import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from made_inputs import write_photo, write_raster, write_text

from semref.core.flight.cameras import read_cameras
from semref.processing.messages.camera_messages import camera_read, camera_remark

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
    assert lens.focal_xy == pytest.approx((60.2 / 80, 60.1 / 80)) and lens.center_xy == pytest.approx(
        (-0.13 / 80, 0.75 / 80)
    )
    assert lens.radial == (-0.269478, 0.115681, -0.0357628) and lens.tangential == (-0.0000875, -0.000306)
    # On a label image of half the size.
    way = camera.leveling((30, 40))
    assert way.bent is not None and way.nadir is None and way.shape_hw > (30, 40)
    told = "focal length 30 px, height 40.0 m, lens distortion up to 16.7 % of the width corrected"
    assert camera_read(camera, (30, 40)) == told


@pytest.mark.parametrize(
    "xmp",
    [
        f'{DEWARP} drone-dji:DewarpFlag="1"',
        'drone-dji:DewarpData=""',
        'drone-dji:DewarpData="2018-03-13;60.2,60.1,-0.13"',
        'drone-dji:DewarpData="2018-03-13;60.2,60.1,nan,0,-0.2,0,0,0,0"',
        'drone-dji:DewarpData="60,60,0,0,-9,0,0,0,0"',
        'drone-dji:DewarpData="60,60,0,0,0,0,0,0,0"',
        'drone-dji:DewarpData="one,two,0,0,0,0,0,0,0"',
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
    assert said == "focal length 2310 px, height 39.8 m, heading 45.0°, roll 0.0°, pitch 0.1°"


# --- CSV ---


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


# --- photos ---


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


def test_tags_that_are_no_text_are_no_fault_of_the_program(tmp_path):
    """GDAL returns bytes for text that is not UTF-8."""
    path = photo(tmp_path / "IMG_1.jpg", xmp="<x GimbalRollDegree='1' GimbalPitchDegree='-80'/>")
    data = path.read_bytes()
    path.write_bytes(data.replace(b"Gimbal", b"\xff\xfe\xfdmbal"))
    assert read_cameras([str(path)], "")[0].attitude is None
