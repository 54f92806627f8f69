"""EXIF and XMP are read without GDAL, with the values as written."""

import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from semref.core import limits
from semref.core.labels.photo_tags import PhotoTags, photo_tags, read_tags


def entry(tag, kind, count, value):
    return struct.pack("<HHI", tag, kind, count) + value


def tiff(offset=8, xmp=b'<a RelativeAltitude="+52.50"/>'):
    """Return a little-endian TIFF with its directory at an offset: size, XMP, orientation."""
    text = offset + 2 + 4 * 12 + 4
    entries = [
        entry(256, 4, 1, struct.pack("<I", 40)),
        entry(257, 3, 1, struct.pack("<HH", 30, 0)),
        entry(274, 3, 1, struct.pack("<HH", 6, 0)),
        entry(700, 1, len(xmp), struct.pack("<I", text)),
    ]
    return (
        struct.pack("<4sI", b"II*\0", offset).ljust(offset, b"\0")
        + struct.pack("<H", 4)
        + b"".join(entries)
        + bytes(4)
        + xmp
    )


def test_a_tiff_has_size_orientation_and_xmp():
    tags = photo_tags(tiff())
    assert (tags.shape_hw, tags.orientation, tags.number("RelativeAltitude")) == ((30, 40), 6, 52.5)


def test_a_large_tiff_is_read_with_its_directory_after_the_pixels(tmp_path):
    path = tmp_path / "large.tif"
    path.write_bytes(tiff(limits.TAG_BYTES + 1000))
    assert read_tags(str(path)).number("RelativeAltitude") == 52.5


def test_a_photo_that_is_cut_short_while_it_is_read_does_not_end_the_process(tmp_path):
    """A memory-mapped file that is rewritten kills the process, which on board would end the flight."""
    path = tmp_path / "large.tif"
    path.write_bytes(tiff(limits.TAG_BYTES + 1_000_000))
    script = f"""
import os, sys
sys.path.insert(0, {str(Path(__file__).resolve().parents[3])!r})
from core.labels import photo_tags
original = photo_tags._tiff_tags
def cut(data):
    os.truncate({str(path)!r}, 100)
    return original(data)
photo_tags._tiff_tags = cut
print(photo_tags.read_tags({str(path)!r}) == photo_tags.PhotoTags())
"""
    ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=False)
    assert (ended.returncode, ended.stdout) == (0, "True\n")


@pytest.mark.parametrize(
    ("xmp", "value"),
    [
        ('RelativeAltitude="+1.5"', 1.5),
        ("<d:RelativeAltitude> -2 </d:RelativeAltitude>", -2.0),
        ("NoRelativeAltitude='3'", None),
    ],
)
def test_a_property_is_an_attribute_or_an_element(xmp, value):
    assert PhotoTags(xmp=xmp).number("RelativeAltitude") == value


@pytest.mark.parametrize(
    "data", [b"", b"\xff\xd8", b"\xff\xd8\xff\xe1\0\0", b"II*\0", b"MM\0*\xff\xff\xff\xff", b"\x89PNG"]
)
def test_a_file_that_is_no_photo_gives_nothing(data):
    assert photo_tags(data) == PhotoTags()


def test_a_directory_that_points_to_itself_ends():
    data = struct.pack("<4sIH", b"II*\0", 8, 1) + entry(34665, 4, 1, struct.pack("<I", 8)) + bytes(4)
    assert photo_tags(data) == PhotoTags()


def test_random_bytes_are_no_error():
    rng = np.random.default_rng(3)
    for _ in range(2000):
        data = bytearray(tiff())
        for place in rng.integers(0, len(data), 6):
            data[place] = rng.integers(0, 256)
        photo_tags(bytes(data)).number("RelativeAltitude")
