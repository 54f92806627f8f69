import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from made_tiff import tiff

from semref.core import limits
from semref.core.geometry.camera import Camera
from semref.core.labels.photo_camera import camera_of, photo_camera
from semref.core.labels.photo_tags import PhotoTags, photo_tags, read_tags

XMP = (
    'drone-dji:RelativeAltitude="+39.80" drone-dji:GimbalYawDegree="-45.00" drone-dji:GimbalRollDegree="+0.00" '
    'drone-dji:GimbalPitchDegree="-90.00"'
)


def entry(tag, kind, count, value):
    return struct.pack(">HHI", tag, kind, count) + value


def exif(model=b"FC300S", focal=(361, 100), film=20):
    head = b"MM\0*" + struct.pack(">I", 8)
    first = 8 + 2 + 2 * 12 + 4
    text, rational = first, first + 16
    directory = rational + 8
    main = struct.pack(">H", 2) + entry(272, 2, len(model) + 1, struct.pack(">I", text))
    main += entry(34665, 4, 1, struct.pack(">I", directory)) + bytes(4)
    own = struct.pack(">H", 2) + entry(37386, 5, 1, struct.pack(">I", rational))
    own += entry(41989, 3, 1, struct.pack(">HH", film, 0)) + bytes(4)
    return head + main + model.ljust(16, b"\0") + struct.pack(">II", *focal) + own


def jpeg(exif_block=None, xmp=XMP, shape_hw=(2250, 4000)):
    def segment(marker, content):
        return bytes([0xFF, marker]) + struct.pack(">H", len(content) + 2) + content

    block = exif() if exif_block is None else exif_block
    parts = [segment(0xE1, b"Exif\0\0" + block), segment(0xE1, b"http://ns.adobe.com/xap/1.0/\0" + xmp.encode())]
    return b"\xff\xd8" + b"".join(parts) + segment(0xC0, b"\x08" + struct.pack(">HH", *shape_hw) + b"\x03")


def test_a_known_camera_gives_pixel_size_and_heading_and_another_one_uses_its_35_mm_focal_length():
    camera = camera_of(photo_tags(jpeg()), "IMG_1.jpg")
    # Focal length 3.61 mm, pixels of 1.5625 µm.
    assert camera.lens.focal_length_px((2250, 4000)) == pytest.approx(3.61 / 0.0015625, rel=1e-6)
    low, high = camera.pixel_sizes((2250, 4000))
    assert low < 39.8 / 2310.4 < high and camera.heading_deg == 315
    # Labels of half the size have pixels of twice the size.
    assert camera.pixel_sizes((1125, 2000))[0] == pytest.approx(2 * low, rel=1e-6)
    camera = camera_of(photo_tags(jpeg(exif(model=b"OTHER"))), "IMG_1.jpg")
    assert camera.lens.kind == "focal_length_35mm" and camera.lens.value == 20
    sizes = b"".join(b"ispe" + bytes(4) + struct.pack(">II", *size) for size in ((512, 512), (4000, 2250)))
    assert camera_of(photo_tags(bytes(4) + b"ftypheic" + sizes + b"Exif\0\0" + exif(b"OTHER")), "").lens == camera.lens


def test_a_rangefinder_counts_first_and_a_zoomed_photo_has_no_focal_length():
    tags = PhotoTags((3000, 4000), "FC330", 1, 3.61, xmp=XMP + ' drone-dji:LRFTargetDistance="80.5"')
    assert camera_of(tags, "").height.meters == pytest.approx(80.5)
    assert camera_of(PhotoTags((3000, 4000), "FC330", 1, 3.61, zoom=2.0), "").lens is None


def test_a_calibrated_focal_length_counts_where_it_is_of_this_resolution():
    for stated, expected in (("2350.5", 2350.5), ("3666.7", 2310.4)):
        tags = PhotoTags((3000, 4000), "FC330", 1, 3.61, xmp=f'drone-dji:CalibratedFocalLength="{stated}"')
        assert camera_of(tags, "").lens.focal_length_px((3000, 4000)) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("altitude", ["+0.00", "-12.5", "nan", "x"])
def test_an_invalid_altitude_is_ignored(altitude):
    assert camera_of(photo_tags(jpeg(xmp=XMP.replace("+39.80", altitude))), "").height is None


def test_the_photo_beside_a_label_image_is_read(tmp_path):
    (tmp_path / "IMG_1.jpg").write_bytes(jpeg())
    assert photo_camera(str(tmp_path / "IMG_1.png")).height.meters == 39.8
    assert photo_camera(str(tmp_path / "IMG_2.png")) == Camera()
    assert read_tags(str(tmp_path)) == PhotoTags()


def test_random_content_of_a_file_is_no_error():
    whole, rng = jpeg(), np.random.default_rng(5)
    for _ in range(3000):
        data = bytearray(whole[: rng.integers(0, len(whole) + 1)])
        for place in rng.integers(0, max(len(data), 1), 6)[: len(data)]:
            data[place] = rng.integers(0, 256)
        camera = camera_of(photo_tags(bytes(data)), "IMG_1.jpg")
        sizes = camera.pixel_sizes((2250, 4000))
        assert sizes is None or 0 < sizes[0] < sizes[1] < np.inf
    for _ in range(1000):
        photo_tags(b"\xff\xd8" + rng.bytes(200))
        photo_tags(b"II*\0" + struct.pack("<I", rng.integers(0, 40)) + rng.bytes(200))


def photo(offset=8):
    """Return a TIFF with its directory at an offset: size, orientation, XMP."""
    entries = [(256, 4, (40,)), (257, 3, (30,)), (274, 3, (6,)), (700, 1, b'<a RelativeAltitude="+52.50"/>')]
    return tiff(entries, at=offset)


def test_a_tiff_has_size_orientation_and_xmp_also_with_its_directory_after_the_pixels(tmp_path):
    tags = photo_tags(photo())
    assert (tags.shape_hw, tags.orientation, tags.number("RelativeAltitude")) == ((30, 40), 6, 52.5)
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


@pytest.mark.parametrize(("xmp", "value"), [('Yaw="+1.5"', 1.5), ("<d:Yaw> -2 </d:Yaw>", -2.0), ("NoYaw='3'", None)])
def test_a_property_is_an_attribute_or_an_element(xmp, value):
    assert PhotoTags(xmp=xmp).number("Yaw") == value


@pytest.mark.parametrize(
    "data", [b"", b"\xff\xd8", b"\xff\xd8\xff\xe1\0\0", b"II*\0", b"MM\0*\xff\xff\xff\xff", b"\x89PNG"]
)
def test_a_file_that_is_no_photo_gives_nothing(data):
    assert photo_tags(data) == PhotoTags()


def test_a_directory_that_points_to_itself_ends():
    assert photo_tags(tiff([(34665, 4, (8,))])) == PhotoTags()
