"""Images: label maps, label images and photos, by OpenCV on board and by GDAL in QGIS."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path
from random import Random
from typing import Any, Callable

import cv2
import numpy as np

from ..contract import World, require
from ..door import Door, Placed, Tools
from ..mutations import WHOLE, mutated_bytes, word

_PNG = b"\x89PNG\r\n\x1a\n"
_SUFFIXES = {"png": ".png", "tif": ".tif", "jpg": ".jpg"}
EDGE = 24


def pictures() -> dict[str, list[bytes]]:
    """Small images of each kind, as cameras, OpenCV and GDAL write them."""
    random = np.random.default_rng(5)
    labels = random.integers(0, 5, (EDGE, EDGE + 6), np.uint8)
    colors = random.integers(0, 256, (EDGE, EDGE + 6, 3), np.uint8)
    alpha = np.dstack([colors, labels * 50])
    found: dict[str, list[bytes]] = {"png": [], "tif": [], "jpg": []}
    for image in (labels, colors, alpha, labels.astype(np.uint16)):
        found["png"].append(cv2.imencode(".png", image)[1].tobytes())
        found["tif"].append(cv2.imencode(".tiff", image)[1].tobytes())
    found["png"].append(paletted_png(labels))
    for image in (labels, colors):
        found["jpg"].append(with_exif(cv2.imencode(".jpg", image)[1].tobytes()))
    return found


def with_gdal(world: World) -> dict[str, list[bytes]]:
    """The same, and GeoTIFFs with what GDAL and SemRef put into them."""
    from osgeo import gdal

    found = pictures()
    labels = np.random.default_rng(6).integers(0, 5, (EDGE, EDGE + 6), np.uint8)
    table = "value,name,color,role\n1,building,#ff0000,reference\n2,water,#0000ff,background\n"
    for options, kind in (
        (["TILED=YES", "COMPRESS=DEFLATE"], gdal.GDT_Byte),
        ([], gdal.GDT_Int16),
        ([], gdal.GDT_Float32),
    ):
        memory = gdal.GetDriverByName("MEM").Create("", labels.shape[1], labels.shape[0], 1, kind)
        memory.SetGeoTransform((600000.0, 1.0, 0.0, 5200000.0, 0.0, -1.0))
        memory.SetProjection('LOCAL_CS["x",UNIT["metre",1]]')
        memory.SetMetadataItem("SEMREF_CLASS_TABLE", table)
        memory.GetRasterBand(1).WriteArray(labels)
        memory.GetRasterBand(1).SetNoDataValue(9)
        path = str(world.folder / "corpus.tif")
        gdal.GetDriverByName("GTiff").CreateCopy(path, memory, options=options)
        found["tif"].append(Path(path).read_bytes())
        Path(path).unlink()
    for left in world.folder.glob("corpus*"):
        left.unlink()
    return found


def paletted_png(labels: np.ndarray) -> bytes:
    rows = b"".join(b"\0" + row.tobytes() for row in labels)
    header = struct.pack(">IIBBBBB", labels.shape[1], labels.shape[0], 8, 3, 0, 0, 0)
    palette = bytes(range(15))
    parts = [(b"IHDR", header), (b"PLTE", palette), (b"IDAT", zlib.compress(rows)), (b"IEND", b"")]
    return _PNG + b"".join(_chunk(*part) for part in parts)


def _chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def with_exif(jpeg: bytes) -> bytes:
    """A JPEG that tells its camera: EXIF and DJI's XMP."""
    entries = [(0x0112, 3, 1, 1), (0x9003, 2, 20, 80), (0xA405, 3, 1, 24)]
    ifd = struct.pack("<H", len(entries)) + b"".join(struct.pack("<HHII", *entry) for entry in entries) + bytes(4)
    tiff = (b"II*\0\x08\0\0\0" + ifd).ljust(80, b"\0") + b"2025:06:30 14:05:09\0"
    angles = b'drone-dji:GimbalRollDegree="+0.50" drone-dji:GimbalPitchDegree="-80.10"'
    xmp = b"<x:xmpmeta><rdf:Description " + angles + b"/></x:xmpmeta>"
    parts = [b"Exif\0\0" + tiff, b"http://ns.adobe.com/xap/1.0/\0" + xmp]
    return jpeg[:2] + b"".join(b"\xff\xe1" + struct.pack(">H", len(part) + 2) + part for part in parts) + jpeg[2:]


def mutated_png(random: Random, data: bytes) -> bytes:
    """Chunks changed, with right checksums: what gets past the first look."""
    parts, place = [], len(_PNG)
    while place + 12 <= len(data):
        length, name = struct.unpack_from(">I4s", data, place)
        parts.append([name, data[place + 8 : place + 8 + length]])
        place += 12 + length
    for _ in range(random.choice((1, 1, 2, 3))):
        part, kind = random.choice(parts), random.randrange(6)
        if kind == 0:
            part[1] = mutated_bytes(random, part[1])
        elif kind == 1 and part[0] == b"IHDR":
            # As many pixels as a query image may have take a second to be made.
            most = (20_000, 19_999) if random.random() < 0.01 else (30, 31)
            width, height = (random.choice((0, 1, 30, 24, 65536, 2**31 - 1, *most)) for _ in range(2))
            code = (random.choice((1, 2, 4, 8, 16, 3)), random.choice((0, 2, 3, 4, 6, 1)), 0, 0, random.randrange(2))
            part[1] = struct.pack(">IIBBBBB", width, height, *code)
        elif kind == 2 and part[0] == b"IDAT":
            part[1] = zlib.compress(mutated_bytes(random, b"\0" * 900))
        elif kind == 3:
            parts.insert(random.randrange(len(parts) + 1), list(random.choice(parts)))
        elif kind == 4:
            texts = word(random).encode("utf-8", "replace")
            name = random.choice((b"tRNS", b"PLTE", b"gAMA", b"iCCP", b"tEXt", b"eXIf", b"acTL", b"zTXt"))
            parts.insert(1, [name, texts if random.random() < 0.5 else random.randbytes(random.randrange(40))])
        elif len(parts) > 1:
            parts.remove(part)
    return _PNG + b"".join(_chunk(*part) for part in parts)


_TAGS = (256, 257, 258, 259, 262, 273, 277, 278, 279, 284, 317, 320, 322, 323, 324, 325, 338, 339, 33550, 33922, 34264)
_TAGS += (34735, 34736, 42112, 42113, 34665, 330)


def mutated_tiff(random: Random, data: bytes) -> bytes:
    """Entries of the first directory changed: tag, kind, count, value; and values that lie elsewhere."""
    found, order = bytearray(data), "<" if data[:2] == b"II" else ">"
    (first,) = struct.unpack_from(order + "I", found, 4)
    (count,) = struct.unpack_from(order + "H", found, first)
    for _ in range(random.choice((1, 1, 2, 3))):
        place = first + 2 + 12 * random.randrange(count)
        tag, kind, length, value = struct.unpack_from(order + "HHII", found, place)
        what = random.randrange(6)
        if what == 0:
            tag = random.choice(_TAGS)
        elif what == 1:
            kind = random.choice((0, 1, 2, 3, 4, 5, 11, 12, 13, 16, 99))
        elif what == 2:
            length = random.choice((*WHOLE[:18], 16, 6)) & 0xFFFFFFFF
        elif what == 3:
            value = random.choice((*WHOLE[:18], first, len(found), len(found) - 1)) & 0xFFFFFFFF
        elif what == 4 and kind == 12 and value + 8 * length <= len(found) and length:
            number = random.choice((float("nan"), float("inf"), 1e308, -1e308, 1e-320, 0.0, -1.0, 1e9, 90.0))
            struct.pack_into(order + "d", found, value + 8 * random.randrange(length), number)
        else:
            struct.pack_into(order + "H", found, first, random.choice((0, 1, count - 1, count + 1, 65535)))
        struct.pack_into(order + "HHII", found, place, tag, kind, length, value)
    return bytes(found)


def picture_maker(found: dict[str, list[bytes]], world: World) -> Callable[[Random], Any]:
    """(suffix, content): mostly of one kind, changed so that it is still known as what it is."""
    vrt = (
        '<VRTDataset rasterXSize="2" rasterYSize="2"><VRTRasterBand dataType="Byte" band="1"><SimpleSource>'
        f'<SourceFilename relativeToVRT="0">{world.secret}</SourceFilename><SourceBand>1</SourceBand></SimpleSource>'
        "</VRTRasterBand></VRTDataset>"
    ).encode()
    foreign = [vrt, vrt.replace(str(world.secret).encode(), b"/vsicurl/" + world.url.encode()), b"", b"GIF89a", b"BM"]
    foreign += [f"<GDAL_WMS><Service name='TMS'><ServerUrl>{world.url}</ServerUrl></Service></GDAL_WMS>".encode()]

    def make(random: Random) -> Any:
        kind = random.choice(("png", "tif", "tif", "jpg"))
        data = random.choice(found[kind])
        roll = random.random()
        if roll < 0.02:
            return _SUFFIXES[kind], random.choice(foreign)
        if roll < 0.65 and kind != "jpg":
            data = mutated_png(random, data) if kind == "png" else mutated_tiff(random, data)
        if roll > 0.55 or kind == "jpg":
            data = mutated_bytes(random, data, foreign[:2], 3)
        return _SUFFIXES[random.choice(list(_SUFFIXES))] if random.random() < 0.03 else _SUFFIXES[kind], data

    return make


def _places(world: World) -> dict[str, Placed]:
    return {suffix: Placed(world.folder, f"image{suffix}") for suffix in _SUFFIXES.values()}


def _classes() -> Any:
    from semref.core.labels.class_table import class_table_from_csv

    return class_table_from_csv("value,name,color,role\n1,building,#ff0000,reference\n2,water,#0000ff,background\n")


def require_labels(labels: np.ndarray) -> None:
    require(labels.dtype == np.uint8 and labels.ndim == 2 and labels.size > 0, "no labels")


def labels_on_board(world: World) -> Tools:
    from semref.core.labels.image_files import read_label_image

    places, table = _places(world), _classes()

    def attempt(made: Any) -> None:
        with places[made[0]](made[1]) as path:
            require_labels(read_label_image(path, table))

    return picture_maker(pictures(), world), attempt


def photos_on_board(world: World) -> Tools:
    from semref.core.labels.image_files import read_photo
    from semref.core.segmentation.resampling import at_resolution

    places = _places(world)

    def attempt(made: Any) -> None:
        with places[made[0]](made[1]) as path:
            photo = read_photo(path)
        height, width = photo.image.shape_hw
        pixels, has_data = photo.image.read(0, 0, width, height)
        require(pixels.shape == (height, width, 3) and pixels.dtype == np.uint8, "no photo")
        require(has_data is None or has_data.shape == (height, width), "no mask")
        size = photo.pixel_size_m
        require(size is None or all(np.isfinite(length) and length > 0 for length in size), f"pixels of {size} m")
        seen = at_resolution(photo.image, size, 0.5)
        height, width = seen.shape_hw
        require(height > 0 and width > 0, "nothing of the photo is left")
        seen.read(0, 0, min(width, 64), min(height, 64))

    return picture_maker(with_gdal(world), world), attempt


def label_maps(world: World) -> Tools:
    from semref.storage.rasters import GdalLabels, RasterFile, class_table_of_map

    places = _places(world)

    def attempt(made: Any) -> None:
        with places[made[0]](made[1]) as path:
            labels = GdalLabels(path)
            height, width = labels.shape_hw
            require(height > 0 and width > 0, "a map without pixels")
            class_table_of_map(labels, RasterFile(path))
            transform = labels.dataset.GetGeoTransform(can_return_null=True)
            require(transform is None or np.isfinite(transform).all(), "a georeference that is none")
            require_labels(labels.read(0, 0, min(width, 512), min(height, 512)))

    return picture_maker(with_gdal(world), world), attempt


def label_images(world: World) -> Tools:
    from semref.storage.label_images import read_label_image

    places, table = _places(world), _classes()

    def attempt(made: Any) -> None:
        with places[made[0]](made[1]) as path:
            require_labels(read_label_image(path, table))

    return picture_maker(with_gdal(world), world), attempt


def photos(world: World) -> Tools:
    from semref.core.flight.cameras import read_cameras
    from semref.storage.images import GdalImage

    places = _places(world)

    def attempt(made: Any) -> None:
        with places[made[0]](made[1]) as path:
            image = GdalImage(path)
            height, width = image.shape_hw
            pixels, has_data = image.read(0, 0, min(width, 512), min(height, 512))
            require(pixels.dtype == np.uint8 and pixels.shape[2] == 3, "no photo")
            camera = read_cameras([path], "")[0]
            require(camera.time_s is None or np.isfinite(camera.time_s), "a time that is none")
            level = camera.leveling((height, width)) if height * width < 10**8 else None
            require(level is None or min(level.shape_hw) > 0, "a leveled image without pixels")

    return picture_maker(with_gdal(world), world), attempt


DOORS = (
    Door("labels_on_board", "label images on board (PNG, TIFF, JPEG)", labels_on_board, 30_000, 10_000),
    Door("photos_on_board", "photos on board, with GeoTIFF's tags", photos_on_board, 30_000, 10_000),
    Door("label_maps", "label maps: GeoTIFF with tags, georeference, class table", label_maps, 15_000, 10_000),
    Door("label_images", "label images and colored ones in QGIS", label_images, 10_000, 10_000),
    Door("photos", "photos in QGIS, with EXIF and XMP", photos, 10_000, 10_000),
)
