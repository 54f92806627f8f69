"""EXIF and XMP are read without GDAL, with the values as written."""

import subprocess
import sys
from pathlib import Path

import pytest
from made_tiff import tiff

from semref.core import limits
from semref.core.labels.photo_tags import PhotoTags, photo_tags, read_tags


def photo(offset=8):
    """Return a TIFF with its directory at an offset: size, orientation, XMP."""
    entries = [(256, 4, (40,)), (257, 3, (30,)), (274, 3, (6,)), (700, 1, b'<a RelativeAltitude="+52.50"/>')]
    return tiff(entries, at=offset)


def test_a_tiff_has_size_orientation_and_xmp():
    tags = photo_tags(photo())
    assert (tags.shape_hw, tags.orientation, tags.number("RelativeAltitude")) == ((30, 40), 6, 52.5)


def test_a_large_tiff_is_read_with_its_directory_after_the_pixels(tmp_path):
    path = tmp_path / "large.tif"
    path.write_bytes(photo(limits.TAG_BYTES + 1000))
    assert read_tags(str(path)).number("RelativeAltitude") == 52.5


def test_a_photo_that_is_cut_short_while_it_is_read_does_not_end_the_process(tmp_path):
    """A memory-mapped file that is rewritten kills the process, which on board would end the flight."""
    path = tmp_path / "large.tif"
    path.write_bytes(photo(limits.TAG_BYTES + 1_000_000))
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
    assert photo_tags(tiff([(34665, 4, (8,))])) == PhotoTags()
