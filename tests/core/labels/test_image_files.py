import os
import re
import struct
import time
import zlib
from pathlib import Path
from unittest.mock import Mock

import cv2
import numpy as np
import pytest
from made_tiff import image_tiff
from onboard_area import TABLE
from PIL import Image
from PIL.PngImagePlugin import PngImageFile

from semref.core import limits
from semref.core.errors import ImageError
from semref.core.labels import image_files
from semref.core.labels.image_files import read_label_image, read_photo
from semref.core.labels.tiff import NODATA

LABELS = np.random.default_rng(7).integers(1, 5, (100, 100)).astype(np.uint8)
PALETTE = tuple(np.random.default_rng(2).integers(0, 65536, 768).tolist())
HALF_BYTES = LABELS[:, 0::2] << 4 | LABELS[:, 1::2]


@pytest.fixture
def image(tmp_path):
    """`image(name, content)` writes pixels, or the bytes of a file, and returns the path."""

    def write(name, content=LABELS):
        if isinstance(content, bytes):
            (tmp_path / name).write_bytes(content)
        else:
            cv2.imwrite(str(tmp_path / name), content)
        return str(tmp_path / name)

    return write


def labels_of(path):
    return read_label_image(path, TABLE)


def photo_of(path):
    photo = read_photo(path).image
    return photo.read(0, 0, *photo.shape_hw[::-1])


@pytest.mark.parametrize("bits", [8, 4])
def test_a_palette_of_a_png_is_not_taken_for_colors(tmp_path, bits):
    paletted = Image.fromarray(LABELS, "P")
    paletted.putpalette(np.random.default_rng(2).integers(0, 256, 3 * 2**bits).tolist())
    paletted.save(tmp_path / "paletted.png", bits=bits, transparency=0)
    np.testing.assert_array_equal(labels_of(str(tmp_path / "paletted.png")), LABELS)


@pytest.mark.parametrize(
    ("name", "content"),
    [
        *((name, LABELS) for name in ("gray.png", "gray.tif")),
        ("colors.png", np.array([(0, 0, 0), *(c.rgb[::-1] for c in TABLE)], np.uint8)[LABELS]),
        ("sixteen_bits.png", LABELS.astype(np.uint16)),
        ("palette.tif", image_tiff(LABELS, 3, t320=PALETTE)),
        ("palette_of_4_bits.tif", image_tiff(HALF_BYTES, 3, t256=(100,), t258=(4,), t320=(0,) * 48)),
    ],
)
def test_gray_and_palettes_are_class_values_and_colors_are_decoded_by_the_class_table(image, name, content):
    np.testing.assert_array_equal(labels_of(image(name, content)), LABELS)


@pytest.mark.parametrize("data", [b"", b"GIF89a", b"\x89PNG\r\n\x1a\n", b"II*\0\xff\xff\xff\xff", b"\xff\xd8\xff"])
def test_what_is_no_image_is_refused(image, data):
    path = image("x.png", data)
    with pytest.raises(ImageError, match=re.escape(path)):
        labels_of(path)
    with pytest.raises(ImageError):
        read_photo(path)


def test_a_photo_is_red_first_and_has_no_data_where_it_is_transparent(image):
    pixels = np.random.default_rng(1).integers(0, 256, (20, 30, 4), np.uint8)
    pixels[::2, ::3, 3] = 0
    photo, has_data = photo_of(image("photo.png", pixels))
    np.testing.assert_array_equal(has_data, pixels[..., 3] > 0)
    np.testing.assert_array_equal(photo, np.where(has_data[..., None], pixels[..., 2::-1], 0))


def test_a_photo_with_damaged_tags_is_refused(image):
    """The tag points beyond the end of the file."""
    data = bytearray(Path(image("photo.tif", np.zeros((20, 30, 3), np.uint8))).read_bytes())
    (first,) = struct.unpack_from("<I", data, 4)
    struct.pack_into("<HHII", data, first + 2, NODATA, 2, 900, len(data))
    with pytest.raises(ImageError, match="damaged"):
        read_photo(image("photo.tif", bytes(data)))


def png_of(*chunks) -> bytes:
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", length) + name + content + struct.pack(">I", zlib.crc32(name + content))
        for name, content, length in chunks
    )


def header(width, height) -> tuple:
    return b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0), 13


@pytest.mark.parametrize("read", [labels_of, read_photo])
@pytest.mark.parametrize(("size", "said"), [(60_000, "60000 × 60000"), (19_000, "damaged")])
def test_a_png_that_claims_too_much_is_refused_before_it_is_decoded(image, monkeypatch, read, size, said):
    # Decoding allocates gigabytes for the pixels first.
    monkeypatch.setattr(PngImageFile, "load", lambda _: pytest.fail("it is decoded"))
    with pytest.raises(ImageError, match=said):
        read(image("claims.png", png_of(header(size, size), (b"IDAT", b"x" * 20, 20))))


@pytest.mark.parametrize(
    "data",
    [
        png_of(header(30, 24), (b"IDAT", b"x" * 20, 0x49444154)),
        png_of(header(30, 24), *[(b"abCd", b"", 0)] * 500_000),
        png_of(header(4000, 4000), *[(b"IDAT", b"x", 1)] * 500_000),
    ],
    ids=["a chunk longer than the file", "chunks before the pixels", "chunks of one byte"],
)
def test_a_png_with_hostile_chunks_is_refused_at_once(image, data):
    path, began = image("chunks.png", data), time.process_time()
    with pytest.raises(ImageError, match="damaged"):
        read_photo(path)
    assert time.process_time() - began < 2


@pytest.mark.parametrize(("name", "suffix"), [("a.png", ".jpg"), ("a.jpg", ".tif"), ("a.tif", ".png")])
def test_a_picture_under_the_name_of_another_kind_is_refused(image, tmp_path, name, suffix):
    path = str(tmp_path / f"renamed{suffix}")
    os.rename(image(name), path)
    for read in (labels_of, read_photo):
        with pytest.raises(ImageError, match="Change the suffix"):
            read(path)


@pytest.mark.parametrize("orientation", range(1, 9))
def test_a_tiff_is_read_in_pixel_order_with_any_orientation(image, orientation):
    path = image("turned.tif", image_tiff(LABELS[:40], 1, t274=(orientation,)))
    np.testing.assert_array_equal(labels_of(path), LABELS[:40])
    np.testing.assert_array_equal(photo_of(path)[0][..., 0], LABELS[:40])


@pytest.mark.parametrize("bits", [1, 2, 4])
def test_gray_of_fewer_bits_has_its_own_values(image, bits):
    labels = LABELS[:, :96] % 2**bits
    rows = np.packbits(np.unpackbits(labels[..., None], axis=2)[..., -bits:].reshape(100, -1), axis=1)
    head = b"IHDR", struct.pack(">IIBBBBB", 96, 100, bits, 0, 0, 0, 0), 13
    content = zlib.compress(b"".join(b"\0" + row.tobytes() for row in rows))
    data = png_of(head, (b"IDAT", content, len(content)), (b"IEND", b"", 0))
    np.testing.assert_array_equal(labels_of(image("gray.png", data)), labels)


def test_nodata_is_unlabeled_in_a_label_image_and_hidden_in_a_gray_photo(image):
    path = image("labels.tif", image_tiff(LABELS, 1, t42113=b"3\0"))
    np.testing.assert_array_equal(labels_of(path), np.where(LABELS == 3, 0, LABELS))
    photo, has_data = photo_of(path)
    np.testing.assert_array_equal(has_data, LABELS != 3)
    np.testing.assert_array_equal(photo, np.repeat(np.where(LABELS == 3, 0, LABELS)[..., None], 3, axis=2))


def test_a_photo_has_no_data_where_all_its_bands_are_nodata(image):
    pixels = np.random.default_rng(1).integers(1, 4, (20, 30, 3)).astype(np.uint8)
    pixels[5:9, 4:20] = 7
    pixels[0, 0] = 7, 7, 1
    photo, has_data = photo_of(image("photo.tif", image_tiff(pixels, 2, t42113=b"7\0")))
    expected = ~(pixels == 7).all(axis=2)
    np.testing.assert_array_equal(has_data, expected)
    np.testing.assert_array_equal(photo, np.where(expected[..., None], pixels, 0))


@pytest.mark.parametrize("hides", [True, False])
def test_a_fourth_band_of_a_tiff_hides_pixels_only_as_opacity(image, hides):
    pixels = np.random.default_rng(1).integers(1, 256, (20, 30, 4)).astype(np.uint8)
    pixels[3, 4:9, 3] = 0
    photo, has_data = photo_of(image("photo.tif", image_tiff(pixels, 2, t338=(2 if hides else 0,))))
    has_data = np.ones((20, 30), bool) if has_data is None else has_data
    np.testing.assert_array_equal(has_data, pixels[..., 3] > 0 if hides else True)
    np.testing.assert_array_equal(photo[has_data], pixels[has_data][:, :3])


@pytest.mark.parametrize(
    ("read", "name", "pixels", "said"),
    [
        *((read, "deep.png", np.zeros((9, 9, 3), np.uint16), "uint16") for read in (labels_of, read_photo)),
        (labels_of, "float.tif", np.zeros((9, 9), np.float32), "float32"),
        (labels_of, "signed.tif", np.full((9, 9), -3, np.int16), "-3"),
        (labels_of, "large.png", np.full((9, 9), 300, np.uint16), "has the value 300"),
    ],
)
def test_labels_that_are_neither_values_nor_colors_and_photos_of_16_bits_are_refused(image, read, name, pixels, said):
    with pytest.raises(ImageError, match=said):
        read(image(name, pixels))


def test_gray_with_opacity_is_no_label_image_and_a_first_chunk_that_is_another_is_damage(tmp_path):
    Image.fromarray(LABELS).convert("LA").save(tmp_path / "x.png")
    with pytest.raises(ImageError, match="two bands|opacity|2 bands"):
        labels_of(str(tmp_path / "x.png"))
    data = bytearray((tmp_path / "x.png").read_bytes())
    data[12:16] = b"IDAT"
    (tmp_path / "x.png").write_bytes(data)
    with pytest.raises(ImageError, match="damaged"):
        labels_of(str(tmp_path / "x.png"))


def test_an_image_of_too_many_pixels_or_bytes_is_refused(image, monkeypatch):
    path = image("gray.png")
    monkeypatch.setattr(limits, "IMAGE_PIXELS", LABELS.size - 1)
    with pytest.raises(ImageError, match="100 × 100"):
        labels_of(path)
    monkeypatch.setattr(limits, "IMAGE_BYTES", 10)
    with pytest.raises(ImageError, match="MB"):
        labels_of(path)


def test_what_the_decoder_stumbles_over_is_refused(image, monkeypatch):
    path = image("gray.jpg")
    monkeypatch.setattr(image_files.cv2, "imdecode", Mock(side_effect=cv2.error("too odd")))
    with pytest.raises(ImageError, match=re.escape(path)):
        labels_of(path)


@pytest.mark.parametrize("name", ["missing.png", "nu\0ll.png", "folder.png"])
def test_a_path_that_is_no_file_is_refused_in_a_sentence(tmp_path, name):
    (tmp_path / "folder.png").mkdir()
    with pytest.raises(ImageError, match="png"):
        labels_of(str(tmp_path / name))


def test_a_folder_means_all_its_images(tmp_path, monkeypatch):
    for name in ("b.PNG", "a.tif", ".hidden.png", "notes.txt"):
        (tmp_path / name).write_bytes(b"")
    (tmp_path / "empty").mkdir()
    tif, png = str(tmp_path / "a.tif"), str(tmp_path / "b.PNG")
    assert image_files.image_files([str(tmp_path), "other.xyz"]) == [tif, png, "other.xyz"]
    with pytest.raises(ImageError, match="empty"):
        image_files.image_files([str(tmp_path / "empty")])
    monkeypatch.setattr(image_files.os, "listdir", Mock(side_effect=PermissionError(13, "Permission denied")))
    with pytest.raises(ImageError, match="Permission denied"):
        image_files.image_files([str(tmp_path)])
