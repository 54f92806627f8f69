import io
import struct

import numpy as np
import pytest
from made_tiff import tiff

from semref.core import limits
from semref.core.labels.tiff import NODATA, BoundedFile, nodata_of, pixel_size_m, read_directory

SHAPE_HW = (100, 200)
METERS = (1024, 0, 1, 1), (3076, 0, 1, 9001)
DEGREES = (1024, 0, 1, 2), (2054, 0, 1, 9102)


def tags_of(data):
    return read_directory(BoundedFile(io.BytesIO(data)))


def georeferenced(keys, *placing, order="<"):
    directory = (1, 1, 0, len(keys), *(number for key in keys for number in key))
    return tags_of(tiff([*placing, (34735, 3, directory)], order))


def scaled(x, y=None, top=0.0):
    return (33550, 12, (x, y or x, 0.0)), (33922, 12, (0.0, 0.0, 0.0, 8.0, top, 0.0))


@pytest.mark.parametrize("order", ["<", ">"])
def test_meters_are_meters(order):
    assert pixel_size_m(georeferenced(METERS, *scaled(0.25, 0.5), order=order), SHAPE_HW) == (0.25, 0.5)


def test_pixels_in_feet_in_degrees_and_of_a_turned_image_are_turned_into_meters():
    feet = georeferenced(((1024, 0, 1, 1), (3076, 0, 1, 9002)), *scaled(10.0))
    assert pixel_size_m(feet, SHAPE_HW) == pytest.approx((3.048, 3.048))
    matrix = (0.3, -0.4, 0, 0, 0.8, 0.6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1)
    assert pixel_size_m(georeferenced(METERS, (34264, 12, matrix)), SHAPE_HW) == pytest.approx(
        (np.hypot(0.3, 0.8), np.hypot(0.4, 0.6))
    )
    found = pixel_size_m(georeferenced(DEGREES, *scaled(1e-6, top=60 + 50e-6)), SHAPE_HW)
    # Lengths of a degree at 60° on WGS 84, from the table of the National Geospatial-Intelligence Agency.
    assert found == pytest.approx((55_800e-6, 111_412e-6), rel=1e-5)


@pytest.mark.parametrize(
    "tags",
    [
        tags_of(tiff([])),
        georeferenced(METERS),
        georeferenced((), *scaled(1.0)),
        georeferenced(METERS, *scaled(0.0)),
        georeferenced(((1024, 0, 1, 3),), *scaled(1.0)),
        georeferenced(((1024, 0, 1, 1), (3076, 0, 1, 9036)), *scaled(1.0)),
        georeferenced(((1024, 0, 1, 2), (2054, 0, 1, 9105)), *scaled(1.0)),
        georeferenced(METERS, (33550, 12, (1.0, 1.0, 0.0))),
    ],
)
def test_missing_units_are_not_guessed(tags):
    assert pixel_size_m(tags, SHAPE_HW) is None


@pytest.mark.parametrize(("text", "wanted"), [(b"255\0", 255.0), (b"-9999 \0", -9999.0), (b"none\0", None)])
def test_nodata_is_a_number_or_nothing(text, wanted):
    assert nodata_of(tags_of(tiff([(NODATA, 2, text)]))) == wanted


def test_of_a_file_that_ends_too_early_nothing_is_guessed():
    data = tiff([(33550, 12, (1.0, 1.0, 0.0))])
    for length in range(8, len(data)):
        assert tags_of(data[:length]).get(33550) is None


def test_tags_that_all_claim_the_whole_file_are_not_kept():
    """65,535 tags of 4 MB would be 262 GB."""
    content = bytes(limits.TAG_BYTES)
    count = 1000
    entries = b"".join(struct.pack("<HHII", 1000 + n, 7, len(content) // 2, 20_000) for n in range(count))
    tags = tags_of(struct.pack("<4sIH", b"II*\0", 8, count) + entries + bytes(4) + content)
    assert sum(len(tags[tag]) for tag in tags) <= 2 * limits.TAG_BYTES
