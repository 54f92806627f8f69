"""Label images and photos read without GDAL: class values, colors and no data."""

from __future__ import annotations

import os
import re
import struct
import time
import zlib
from pathlib import Path

import cv2
import numpy as np
import pytest
from made_tiff import image_tiff
from PIL import Image
from PIL.PngImagePlugin import PngImageFile

from semref.core import limits
from semref.core.errors import ImageError, LabelMapError
from semref.core.labels import image_files
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.image_files import read_label_image, read_photo
from semref.core.labels.tiff import NODATA

TABLE = ClassTable(
    (
        LandCoverClass(1, "building", "#ff0000", "reference"),
        LandCoverClass(2, "water", "#0000ff", "reference"),
        LandCoverClass(3, "bare_land", "#ffff00", "reference"),
        LandCoverClass(4, "field", "#00ff00"),
    )
)
LABELS = np.random.default_rng(7).integers(1, 5, (100, 100)).astype(np.uint8)


@pytest.fixture
def image(tmp_path):
    def write(name, labels=LABELS):
        cv2.imwrite(str(tmp_path / name), labels)
        return str(tmp_path / name)

    return write


@pytest.mark.parametrize("bits", [8, 4])
def test_a_palette_of_a_png_is_not_taken_for_colors(tmp_path, bits):
    paletted = Image.fromarray(LABELS, "P")
    paletted.putpalette(np.random.default_rng(2).integers(0, 256, 3 * 2**bits).tolist())
    paletted.save(tmp_path / "paletted.png", bits=bits, transparency=0)
    np.testing.assert_array_equal(read_label_image(str(tmp_path / "paletted.png"), TABLE), LABELS)


def test_colors_are_decoded_by_the_class_table(image):
    colors = np.zeros((256, 3), np.uint8)
    for c in TABLE:
        colors[c.value] = c.rgb[::-1]
    np.testing.assert_array_equal(read_label_image(image("colors.png", colors[LABELS]), TABLE), LABELS)


@pytest.mark.parametrize("name", ["gray.png", "gray.tif"])
def test_gray_values_are_class_values(image, name):
    np.testing.assert_array_equal(read_label_image(image(name), TABLE), LABELS)


def test_sixteen_bits_will_do_when_the_values_fit(image):
    np.testing.assert_array_equal(read_label_image(image("deep.png", LABELS.astype(np.uint16)), TABLE), LABELS)
    with pytest.raises(LabelMapError, match="has the value 300"):
        read_label_image(image("deep.png", np.full((9, 9), 300, np.uint16)), TABLE)


@pytest.mark.parametrize("data", [b"", b"GIF89a", b"\x89PNG\r\n\x1a\n", b"II*\0\xff\xff\xff\xff", b"\xff\xd8\xff"])
def test_what_is_no_image_is_refused(tmp_path, data):
    (tmp_path / "x.png").write_bytes(data)
    with pytest.raises(LabelMapError, match=re.escape(str(tmp_path / "x.png"))):
        read_label_image(str(tmp_path / "x.png"), TABLE)
    with pytest.raises(ImageError):
        read_photo(str(tmp_path / "x.png"))


def test_a_photo_is_red_first_and_has_no_data_where_it_is_transparent(image):
    pixels = np.random.default_rng(1).integers(0, 256, (20, 30, 4), np.uint8)
    pixels[::2, ::3, 3] = 0
    photo, has_data = read_photo(image("photo.png", pixels)).image.read(0, 0, 30, 20)
    np.testing.assert_array_equal(has_data, pixels[..., 3] > 0)
    np.testing.assert_array_equal(photo, np.where(has_data[..., None], pixels[..., 2::-1], 0))


def test_a_photo_with_damaged_tags_is_refused(image, tmp_path):
    """The tag points beyond the end of the file."""
    path = tmp_path / "photo.tif"
    data = bytearray(Path(image("photo.tif", np.zeros((20, 30, 3), np.uint8))).read_bytes())
    (first,) = struct.unpack_from("<I", data, 4)
    struct.pack_into("<HHII", data, first + 2, NODATA, 2, 900, len(data))
    path.write_bytes(data)
    with pytest.raises(ImageError, match="damaged"):
        read_photo(str(path))


@pytest.fixture
def no_decoding(monkeypatch):
    """Fail if anything is decoded: decoding allocates gigabytes for the pixels first."""

    def load(_):
        raise AssertionError("it is decoded")

    monkeypatch.setattr(PngImageFile, "load", load)


def png_of(*chunks) -> bytes:
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", length) + name + content + struct.pack(">I", zlib.crc32(name + content))
        for name, content, length in chunks
    )


def header(width, height) -> tuple:
    return b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0), 13


@pytest.mark.parametrize("read", [lambda path: read_label_image(path, TABLE), read_photo])
@pytest.mark.parametrize(
    ("data", "said"),
    [
        (png_of(header(60_000, 60_000), (b"IDAT", b"x" * 20, 20)), "60000 × 60000"),
        (png_of(header(19_000, 19_000), (b"IDAT", b"x" * 20, 20)), "damaged"),
    ],
)
def test_a_png_that_claims_too_much_is_refused_before_it_is_decoded(tmp_path, no_decoding, read, data, said):
    (tmp_path / "claims.png").write_bytes(data)
    with pytest.raises((ImageError, LabelMapError), match=said):
        read(str(tmp_path / "claims.png"))


@pytest.mark.parametrize(
    "data",
    [
        png_of(header(30, 24), (b"IDAT", b"x" * 20, 0x49444154)),
        png_of(header(30, 24), *[(b"abCd", b"", 0)] * 500_000),
        png_of(header(4000, 4000), *[(b"IDAT", b"x", 1)] * 500_000),
    ],
    ids=["a chunk longer than the file", "chunks before the pixels", "chunks of one byte"],
)
def test_a_png_with_hostile_chunks_is_refused_at_once(tmp_path, data):
    (tmp_path / "chunks.png").write_bytes(data)
    began = time.process_time()
    with pytest.raises(ImageError, match="damaged"):
        read_photo(str(tmp_path / "chunks.png"))
    assert time.process_time() - began < 2


@pytest.mark.parametrize(("name", "suffix"), [("a.png", ".jpg"), ("a.jpg", ".tif"), ("a.tif", ".png")])
def test_a_picture_under_the_name_of_another_kind_is_refused(image, tmp_path, name, suffix):
    path = str(tmp_path / f"renamed{suffix}")
    os.rename(image(name), path)
    for read in (lambda path: read_label_image(path, TABLE), read_photo):
        with pytest.raises((ImageError, LabelMapError), match="Change the suffix"):
            read(path)


def test_a_palette_of_a_tiff_is_not_taken_for_colors(tmp_path):
    palette = tuple(np.random.default_rng(2).integers(0, 65536, 768).tolist())
    (tmp_path / "paletted.tif").write_bytes(image_tiff(LABELS, 3, t320=palette))
    np.testing.assert_array_equal(read_label_image(str(tmp_path / "paletted.tif"), TABLE), LABELS)


def test_a_palette_of_fewer_bits_is_read_too(tmp_path):
    packed = LABELS[:, 0::2] << 4 | LABELS[:, 1::2]
    data = image_tiff(packed, 3, t256=(LABELS.shape[1],), t258=(4,), t320=(0,) * 48)
    (tmp_path / "paletted.tif").write_bytes(data)
    np.testing.assert_array_equal(read_label_image(str(tmp_path / "paletted.tif"), TABLE), LABELS)


@pytest.mark.parametrize("orientation", range(1, 9))
def test_a_tiff_is_read_in_pixel_order_with_any_orientation(tmp_path, orientation):
    (tmp_path / "turned.tif").write_bytes(image_tiff(LABELS[:40], 1, t274=(orientation,)))
    np.testing.assert_array_equal(read_label_image(str(tmp_path / "turned.tif"), TABLE), LABELS[:40])
    photo, _ = read_photo(str(tmp_path / "turned.tif")).image.read(0, 0, 100, 40)
    np.testing.assert_array_equal(photo[..., 0], LABELS[:40])


@pytest.mark.parametrize("bits", [1, 2, 4])
def test_gray_of_fewer_bits_has_its_own_values(tmp_path, bits):
    labels = LABELS[:, :96] % 2**bits
    rows = np.packbits(np.unpackbits(labels[..., None], axis=2)[..., -bits:].reshape(100, -1), axis=1)
    head = b"IHDR", struct.pack(">IIBBBBB", 96, 100, bits, 0, 0, 0, 0), 13
    content = zlib.compress(b"".join(b"\0" + row.tobytes() for row in rows))
    (tmp_path / "gray.png").write_bytes(png_of(head, (b"IDAT", content, len(content)), (b"IEND", b"", 0)))
    np.testing.assert_array_equal(read_label_image(str(tmp_path / "gray.png"), TABLE), labels)


def test_nodata_of_a_label_image_is_unlabeled(tmp_path):
    (tmp_path / "labels.tif").write_bytes(image_tiff(LABELS, 1, t42113=b"3\0"))
    np.testing.assert_array_equal(
        read_label_image(str(tmp_path / "labels.tif"), TABLE), np.where(LABELS == 3, 0, LABELS)
    )


def test_a_photo_has_no_data_where_all_its_bands_are_nodata(tmp_path):
    pixels = np.random.default_rng(1).integers(1, 4, (20, 30, 3)).astype(np.uint8)
    pixels[5:9, 4:20] = 7
    pixels[0, 0] = 7, 7, 1
    (tmp_path / "photo.tif").write_bytes(image_tiff(pixels, 2, t42113=b"7\0"))
    photo, has_data = read_photo(str(tmp_path / "photo.tif")).image.read(0, 0, 30, 20)
    expected = ~(pixels == 7).all(axis=2)
    np.testing.assert_array_equal(has_data, expected)
    np.testing.assert_array_equal(photo, np.where(expected[..., None], pixels, 0))


def test_a_gray_photo_with_nodata_is_gray_where_it_has_data(tmp_path):
    (tmp_path / "photo.tif").write_bytes(image_tiff(LABELS, 1, t42113=b"2\0"))
    photo, has_data = read_photo(str(tmp_path / "photo.tif")).image.read(0, 0, 100, 100)
    np.testing.assert_array_equal(has_data, LABELS != 2)
    np.testing.assert_array_equal(photo, np.repeat(np.where(LABELS == 2, 0, LABELS)[..., None], 3, axis=2))


def test_colors_of_a_half_transparent_tiff_are_as_they_were_written(tmp_path):
    pixels = np.random.default_rng(1).integers(1, 256, (20, 30, 4)).astype(np.uint8)
    pixels[3, 4:9, 3] = 0
    (tmp_path / "photo.tif").write_bytes(image_tiff(pixels, 2, t338=(2,)))
    photo, has_data = read_photo(str(tmp_path / "photo.tif")).image.read(0, 0, 30, 20)
    np.testing.assert_array_equal(has_data, pixels[..., 3] > 0)
    np.testing.assert_array_equal(photo[has_data], pixels[has_data][:, :3])


def test_a_fourth_band_that_is_no_opacity_hides_nothing(tmp_path):
    pixels = np.random.default_rng(1).integers(0, 256, (20, 30, 4)).astype(np.uint8)
    (tmp_path / "photo.tif").write_bytes(image_tiff(pixels, 2, t338=(0,)))
    photo, has_data = read_photo(str(tmp_path / "photo.tif")).image.read(0, 0, 30, 20)
    assert has_data is None or has_data.all()
    np.testing.assert_array_equal(photo, pixels[..., :3])


@pytest.mark.parametrize(
    ("name", "pixels", "said"),
    [
        ("deep.png", np.zeros((9, 9, 3), np.uint16), "uint16"),
        ("float.tif", np.zeros((9, 9), np.float32), "float32"),
        ("signed.tif", np.full((9, 9), -3, np.int16), "-3"),
    ],
)
def test_labels_that_are_neither_values_nor_colors_are_refused(image, name, pixels, said):
    with pytest.raises(LabelMapError, match=said):
        read_label_image(image(name, pixels), TABLE)


def test_a_photo_of_more_than_8_bits_is_refused(image):
    with pytest.raises(ImageError, match="uint16"):
        read_photo(image("deep.png", np.zeros((9, 9, 3), np.uint16)))


def test_gray_with_opacity_is_no_label_image_and_a_first_chunk_that_is_another_is_damage(tmp_path):
    Image.fromarray(LABELS).convert("LA").save(tmp_path / "x.png")
    with pytest.raises(LabelMapError, match="two bands|opacity|2 bands"):
        read_label_image(str(tmp_path / "x.png"), TABLE)
    data = bytearray((tmp_path / "x.png").read_bytes())
    data[12:16] = b"IDAT"
    (tmp_path / "x.png").write_bytes(data)
    with pytest.raises(LabelMapError, match="damaged"):
        read_label_image(str(tmp_path / "x.png"), TABLE)


def test_an_image_of_too_many_pixels_or_bytes_is_refused(image, monkeypatch):
    path = image("gray.png")
    monkeypatch.setattr(limits, "IMAGE_PIXELS", LABELS.size - 1)
    with pytest.raises(LabelMapError, match="100 × 100"):
        read_label_image(path, TABLE)
    monkeypatch.setattr(limits, "IMAGE_BYTES", 10)
    with pytest.raises(LabelMapError, match="MB"):
        read_label_image(path, TABLE)


def test_what_the_decoder_stumbles_over_is_refused(image, monkeypatch):
    def fails(*_):
        raise cv2.error("too odd")

    path = image("gray.jpg")
    monkeypatch.setattr(image_files.cv2, "imdecode", fails)
    with pytest.raises(LabelMapError, match=re.escape(path)):
        read_label_image(path, TABLE)


@pytest.mark.parametrize("name", ["missing.png", "nu\0ll.png", "folder.png"])
def test_a_path_that_is_no_file_is_refused_in_a_sentence(tmp_path, name):
    (tmp_path / "folder.png").mkdir()
    with pytest.raises(LabelMapError, match="png"):
        read_label_image(str(tmp_path / name), TABLE)


def test_a_folder_means_all_its_images(tmp_path, monkeypatch):
    for name in ("b.PNG", "a.tif", ".hidden.png", "notes.txt"):
        (tmp_path / name).write_bytes(b"")
    (tmp_path / "empty").mkdir()
    assert image_files.image_files([str(tmp_path), "other.xyz"]) == [
        str(tmp_path / "a.tif"),
        str(tmp_path / "b.PNG"),
        "other.xyz",
    ]
    with pytest.raises(LabelMapError, match="empty"):
        image_files.image_files([str(tmp_path / "empty")])

    def refused(_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(image_files.os, "listdir", refused)
    with pytest.raises(LabelMapError, match="Permission denied"):
        image_files.image_files([str(tmp_path)])
