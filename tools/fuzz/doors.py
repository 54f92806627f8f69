"""The ways in: what makes an input of each from a sample, and what must hold for what its reader gives."""

from __future__ import annotations

import contextlib
import gzip
import hashlib
import io
import json
import math
import os
import signal
import socket
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any

import cv2
import numpy as np

from .contract import Broken, Placed, World, require
from .mutations import (
    mutated_bytes,
    mutated_database,
    mutated_png,
    mutated_text,
    mutated_tiff,
    mutated_zip,
    word,
)

ROOT = Path(__file__).resolve().parents[2]
KEPT = ROOT / "tests" / "data" / "kept" / "v1" / "database.gpkg.gz"
Tools = tuple[Callable[[Random], Any], Callable[[Any], Any]]
"""Makes an input; gives it to the door, and looks at what comes out."""


@dataclass(frozen=True)
class Door:
    """A way in: a name for the command line, what comes in, what prepares it, and its share of the examples."""

    name: str
    title: str
    prepare: Callable[[World], Tools]
    share: float = 1.0


def _finite(*numbers: Any) -> None:
    require(all(np.isfinite(np.array(some, np.float64)).all() for some in numbers), "a number that is none")


def _text_file(world: World, name: str, text: str, words: tuple[str, ...], read: Callable[[str], None]) -> Tools:
    placed = Placed(world.folder, name)

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            read(path)

    return lambda random: mutated_text(random, text, words), attempt


# --- tables and texts ---

CLASSES = (
    "value,name,color,role,draw_order,hsv_min,hsv_max\n1,building,#e31a1c,reference,,173 100 60,7 255 255\n"
    "2,bare_land,#a02db4,reference,2,139 60 60,155 255 255\n4,forest,#1f8b30,background,,,\n"
)
CAMERAS = (
    "image,roll,pitch,field_of_view,time\na.png,-1.2,9.5,73.7,2025-06-30T14:05:09.250\n"
    "b.png,0.4,10.1,73.7,2025-06-30T14:05:11.250\n"
)
ODOMETRY = (
    "image,dx_m,dy_m,dheading_deg,sigma_m,sigma_heading_deg,scale,sigma_scale\na.png,0,0,0,,,,\n"
    "b.png,1.5,98.2,-3.1,2.0,0.5,1.01,0.01\nc.png,,,,,,,\nd.png,-4,101,2.5,2,0.5,,\n"
)
_ITEMS = [{"command": 22, "params": [15, 0, 0, None, 47.1, 9.5, 50]}, {"landCoordinate": [47.1, 9.5, 0]}]
PLAN = json.dumps({"fileType": "Plan", "mission": {"items": [{"type": "SimpleItem", **item} for item in _ITEMS]}})
WAYPOINTS = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47.1\t9.5\t0\t1\n1\t0\t3\t16\t0\t0\t0\t0\t47.2\t9.5\t50\t1\n"
GPX = (
    '<?xml version="1.0"?><gpx version="1.1" creator="x"><rte><rtept lat="47.1" lon="9.5"/><rtept lat="47.2" '
    'lon="9.6"/></rte></gpx>'
)
ENTITIES = '<!DOCTYPE x [<!ENTITY a "aaaaaa"><!ENTITY b "&a;&a;&a;&a;"><!ENTITY c SYSTEM "file:///etc/passwd">]>'


def class_tables(world: World) -> Tools:
    from semref.core.labels.class_table import class_table_from_csv
    from semref.storage.text_tables import read_class_table

    def read(path: str) -> None:
        table = read_class_table(path)
        require(all(0 <= c.value <= 255 and 0 < len(c.name) <= 255 for c in table), "a class that can't be")
        require(not len(table) or class_table_from_csv(table.to_csv()) == table, "it is written as something else")

    return _text_file(world, "classes.csv", CLASSES, ("value", "name", "color", "hsv_min", "181 0 0"), read)


def camera_tables(world: World) -> Tools:
    from semref.core.flight.cameras import read_cameras

    def read(path: str) -> None:
        for camera in read_cameras(["a.png", "/x/b.png", "c.png"], path):
            _finite(camera.time_s or 0)
            found = camera.leveling((90, 120))
            if found is not None:
                _finite(found.homography)
                require(all(1 <= size <= 20_000 for size in found.shape_hw), "a leveled image that can't be")

    words = ("roll", "focal_length_px", "focal_length_35mm", "field_of_view", "89.9", "1e-300", "A.PNG", "a.png")
    return _text_file(world, "cameras.csv", CAMERAS, words, read)


def odometry_tables(world: World) -> Tools:
    from semref.core.flight.links import links_by_image
    from semref.core.flight.odometry import odometry_links, read_odometry

    names = ["a.png", "b.png", "c.png", "d.png"]

    def read(path: str) -> None:
        for link in links_by_image(odometry_links(read_odometry(path), names), len(names)).values():
            _finite(link.translation, link.turn, link.log_scale, link.covariance)

    return _text_file(world, "odometry.csv", ODOMETRY, ("image", "dx_m", "sigma_m", "a.png"), read)


def routes(world: World) -> Tools:
    from semref.storage.route_files import read_waypoint_file

    samples = {"route.plan": PLAN, "route.waypoints": WAYPOINTS, "route.gpx": GPX}
    places = {name: Placed(world.folder, name) for name in samples}

    def attempt(made: tuple[str, bytes]) -> None:
        with places[made[0]](made[1]) as path:
            for line in read_waypoint_file(path):
                require(line.ndim == 2 and line.shape[1] == 2, "no line")
                _finite(line)
                require((np.abs(line) <= (180, 90)).all(), "a place off the Earth")

    def make(random: Random) -> tuple[str, bytes]:
        name = random.choice(sorted(samples))
        return name, mutated_text(random, samples[name], (ENTITIES, "&b;", "&c;", "16", "22", "QGC WPL 110"))

    return make, attempt


def build_parameters(world: World) -> Tools:
    from semref.core.database.parameters import build_parameters as read
    from semref.core.errors import DatabaseError
    from semref.core.values import read_json

    numbers = {"map_width_px": 400, "map_height_px": 320, "pixel_size": 2.0, "window_size": 120.0, "stride": 40.0}
    numbers |= {"references_per_vector": 10, "minimum_area": 28.0, "overview_factor": 4, "format_version": 1}
    texts = {"crs": 'PROJCS["x"]', "map_hash": "ab" * 32, "class_table_hash": "cd" * 32, "plugin_version": "1.2.3"}
    lists = {
        "geotransform": [6e5, 2.0, 0.0, 52e5, 0.0, -2.0],
        "levels": [1.0, 2.0],
        "block_hashes": ["0123456789abcdef"],
    }
    good = json.dumps({**numbers, **texts, **lists})

    def attempt(data: bytes) -> None:
        try:
            found = read(read_json(data.decode("utf-8", "replace")), "x.gpkg")
        except (KeyError, ValueError, TypeError) as error:
            # What the two readers of files catch around it.
            reason = str(error)[:200].replace("\n", " ")
            raise DatabaseError(
                "{path} is damaged or cut short ({reason}); build it again or fetch another copy.",
                path="x",
                reason=reason,
            ) from None
        _finite(found.geotransform, found.levels, found.pixel_size, found.stride, found.extent)
        require(all(length > 0 for length in found.overview_frame.shape_hw), "an overview without pixels")

    return lambda random: mutated_text(random, good), attempt


def keys(world: World) -> Tools:
    from semref.core.onboard.signature import is_signed_with, read_key, signature

    placed, right = Placed(world.folder, "fleet.key"), bytes(range(32))
    files = {"header": b"x" * 40, "windows_rows": b"y" * 30}
    signed = signature(files, right)

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            key = read_key(path)
        # HMAC fills keys up with zeros.
        require(is_signed_with(files, signed, key) == (key.rstrip(b"\0") == right), "another key signs as well")

    return lambda random: mutated_bytes(random, right), attempt


# --- images ---

_SUFFIXES = {"png": ".png", "tif": ".tif", "jpg": ".jpg"}


def pictures(world: World) -> dict[str, list[bytes]]:
    """Small images of each kind, as OpenCV and GDAL write them."""
    from osgeo import gdal

    random = np.random.default_rng(5)
    labels, colors = random.integers(0, 5, (24, 30), np.uint8), random.integers(0, 256, (24, 30, 3), np.uint8)
    found: dict[str, list[bytes]] = {
        "png": [],
        "tif": [],
        "jpg": [with_exif(cv2.imencode(".jpg", colors)[1].tobytes())],
    }
    for image in (labels, colors, labels.astype(np.uint16)):
        found["png"].append(cv2.imencode(".png", image)[1].tobytes())
        found["tif"].append(cv2.imencode(".tiff", image)[1].tobytes())
    memory = gdal.GetDriverByName("MEM").Create("", 30, 24, 1)
    memory.SetGeoTransform((600000.0, 1.0, 0.0, 5200000.0, 0.0, -1.0))
    memory.SetProjection('LOCAL_CS["x",UNIT["metre",1]]')
    memory.SetMetadataItem("SEMREF_CLASS_TABLE", "value,name,color,role\n1,building,#ff0000,reference\n")
    memory.GetRasterBand(1).WriteArray(labels)
    path = world.folder / "corpus.tif"
    gdal.GetDriverByName("GTiff").CreateCopy(str(path), memory, options=["COMPRESS=DEFLATE"])
    found["tif"].append(path.read_bytes())
    path.unlink()
    return found


def with_exif(jpeg: bytes) -> bytes:
    """A JPEG that states its camera: EXIF and DJI's XMP."""
    entries = [(0x0112, 3, 1, 1), (0x9003, 2, 20, 80), (0xA405, 3, 1, 24)]
    ifd = struct.pack("<H", len(entries)) + b"".join(struct.pack("<HHII", *entry) for entry in entries) + bytes(4)
    tiff = (b"II*\0\x08\0\0\0" + ifd).ljust(80, b"\0") + b"2025:06:30 14:05:09\0"
    angles = b'drone-dji:GimbalRollDegree="+0.50" drone-dji:GimbalPitchDegree="-80.10"'
    parts = [
        b"Exif\0\0" + tiff,
        b"http://ns.adobe.com/xap/1.0/\0<x:xmpmeta><rdf:Description " + angles + b"/></x:xmpmeta>",
    ]
    return jpeg[:2] + b"".join(b"\xff\xe1" + struct.pack(">H", len(part) + 2) + part for part in parts) + jpeg[2:]


def _images(world: World, read: Callable[[str], None]) -> Tools:
    """Images of all kinds, also such as name a file outside or a host."""
    found = pictures(world)
    places = {suffix: Placed(world.folder, f"image{suffix}") for suffix in _SUFFIXES.values()}
    vrt = (
        '<VRTDataset rasterXSize="2" rasterYSize="2"><VRTRasterBand dataType="Byte" band="1"><SimpleSource>'
        f'<SourceFilename relativeToVRT="0">{world.secret}</SourceFilename><SourceBand>1</SourceBand></SimpleSource>'
        "</VRTRasterBand></VRTDataset>"
    ).encode()
    foreign = [vrt, vrt.replace(str(world.secret).encode(), b"/vsicurl/" + world.url.encode()), b"", b"GIF89a"]
    foreign.append(f"<GDAL_WMS><Service name='TMS'><ServerUrl>{world.url}</ServerUrl></Service></GDAL_WMS>".encode())

    def make(random: Random) -> tuple[str, bytes]:
        kind = random.choice(("png", "tif", "jpg"))
        data, roll = random.choice(found[kind]), random.randrange(20)
        if roll == 0:
            data = random.choice(foreign)
        elif roll < 12 and kind != "jpg":
            data = mutated_png(random, data) if kind == "png" else mutated_tiff(random, data)
        else:
            data = mutated_bytes(random, data, foreign[:2], 3)
        return _SUFFIXES[kind if roll else random.choice(sorted(_SUFFIXES))], data

    def attempt(made: tuple[str, bytes]) -> None:
        with places[made[0]](made[1]) as path:
            read(path)

    world.forget()
    return make, attempt


def _require_labels(labels: np.ndarray) -> None:
    require(labels.dtype == np.uint8 and labels.ndim == 2 and labels.size > 0, "no labels")


def label_images_on_board(world: World) -> Tools:
    from semref.core.labels.class_table import class_table_from_csv
    from semref.core.labels.image_files import read_label_image

    table = class_table_from_csv("value,name,color,role\n1,building,#ff0000,reference\n2,water,#0000ff,background\n")
    return _images(world, lambda path: _require_labels(read_label_image(path, table)))


def label_maps(world: World) -> Tools:
    from semref.core.labels.class_table import class_table_from_csv
    from semref.storage.label_images import read_label_image
    from semref.storage.label_maps import GdalLabels, RasterFile, class_table_of_map

    table = class_table_from_csv("value,name,color,role\n1,building,#ff0000,reference\n2,water,#0000ff,background\n")

    def read(path: str) -> None:
        labels = GdalLabels(path)
        height, width = labels.shape_hw
        require(height > 0 and width > 0, "a map without pixels")
        class_table_of_map(labels, RasterFile(path))
        _finite(labels.dataset.GetGeoTransform(can_return_null=True) or (0,))
        _require_labels(labels.read(0, 0, min(width, 512), min(height, 512)))
        _require_labels(read_label_image(path, table))

    return _images(world, read)


def photos(world: World) -> Tools:
    from semref.core.flight.cameras import read_cameras
    from semref.storage.images import GdalImage

    def read(path: str) -> None:
        image = GdalImage(path)
        height, width = image.shape_hw
        pixels, _ = image.read(0, 0, min(width, 512), min(height, 512))
        require(pixels.dtype == np.uint8 and pixels.shape[2] == 3, "no photo")
        camera = read_cameras([path], "")[0]
        _finite(camera.time_s or 0)
        level = camera.leveling((height, width)) if height * width < 10**8 else None
        require(level is None or min(level.shape_hw) > 0, "a leveled image without pixels")

    return _images(world, read)


def photos_on_board(world: World) -> Tools:
    from semref.core.labels.image_files import read_photo
    from semref.core.segmentation.resampling import at_resolution

    def read(path: str) -> None:
        photo = read_photo(path)
        height, width = photo.image.shape_hw
        pixels, _ = photo.image.read(0, 0, width, height)
        require(pixels.shape == (height, width, 3) and pixels.dtype == np.uint8, "no photo")
        size = photo.pixel_size_m
        require(size is None or all(np.isfinite(length) and length > 0 for length in size), f"pixels of {size} m")
        seen = at_resolution(photo.image, size, 0.5)
        require(min(seen.shape_hw) > 0, "nothing of the photo is left")
        seen.read(0, 0, min(seen.shape_hw[1], 64), min(seen.shape_hw[0], 64))

    return _images(world, read)


# --- databases, onboard files, flights ---

TABLES = ("windows", "references", "reference_bounds", "classes", "parameters", "layer_styles", "overview")
TABLES += ("gpkg_contents", "gpkg_geometry_columns", "gpkg_spatial_ref_sys", "gpkg_tile_matrix_set")


def require_sound(database: Any) -> None:
    """What localization relies on."""
    windows, landmarks, parameters = database.windows, database.references, database.parameters
    _finite(windows.centers, windows.sizes, windows.vectors, landmarks.positions, landmarks.areas_m2)
    x_min, y_min, x_max, y_max = parameters.extent
    slack = parameters.pixel_size
    for places in (windows.centers, landmarks.positions):
        inside = (places >= (x_min - slack, y_min - slack)) & (places <= (x_max + slack, y_max + slack))
        require(inside.all(), "a place off the map")


def databases(world: World) -> Tools:
    from semref.storage.database.reader import read_database, read_stored_database, stored_style

    placed, good = Placed(world.folder, "area.gpkg"), gzip.decompress(KEPT.read_bytes())

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            stored_style(path, "windows")
            require_sound(read_database(path, with_overview=True))
            stored = read_stored_database(path)
            require(len(stored.window_fids) == len(stored.database.windows), "windows without rows")

    return lambda random: mutated_database(random, good, TABLES), attempt


def onboard_files(world: World) -> Tools:
    from onboard_blobs import build_blobs, linear

    from semref.core.geometry.lon_lat import fit_lon_lat
    from semref.core.onboard.read import read_onboard
    from semref.core.onboard.write import write_onboard

    database, path = build_blobs(), str(world.folder / "made.npz")
    write_onboard(path, database, fit_lon_lat(linear, database.parameters.extent))
    whole, placed = Path(path).read_bytes(), Placed(world.folder, "area.npz")
    os.unlink(path)
    world.forget()

    def attempt(data: bytes) -> None:
        with placed(resealed(data)) as place:
            onboard = read_onboard(place)
        require_sound(onboard.database)
        _finite([onboard.position_error, onboard.area_error, onboard.vector_error])
        if onboard.lon_lat is not None:
            longitudes, latitudes = onboard.lon_lat(onboard.database.windows.centers)
            _finite(longitudes, latitudes)
            require((np.abs(longitudes) <= 180).all() and (np.abs(latitudes) <= 90).all(), "a place off the Earth")

    return lambda random: mutated_zip(random, whole), attempt


def resealed(data: bytes) -> bytes:
    """An onboard file with the right hash of its content, as its maker could write it."""
    import zipfile

    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            members = {name: archive.read(name) for name in archive.namelist()}
    except Exception:
        return data
    content = hashlib.sha256(b"".join(members[name] for name in sorted(members) if name != "content_hash.npy"))
    file = io.BytesIO()
    np.save(file, np.frombuffer(content.digest(), np.uint8))
    members["content_hash.npy"] = file.getvalue()
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        for name, member in members.items():
            archive.writestr(name, member)
    return file.getvalue()


def flight_states(world: World) -> Tools:
    from onboard_blobs import MAP, build_blobs

    from semref.core.errors import ParameterError
    from semref.core.flight.model import FlightImage
    from semref.core.flight.tracker import FlightTracker
    from semref.core.localizer.localizer import Localizer
    from semref.core.onboard.state_file import StateFile

    localizer = Localizer(build_blobs())
    tracker = FlightTracker(localizer)
    tracker.add(FlightImage("a.png", np.ascontiguousarray(MAP[100:160, 100:160])))
    file = io.BytesIO()
    np.savez(file, **tracker.state())
    good, placed, key = file.getvalue(), Placed(world.folder, "flight.npz"), b"a key of the fuzzer"

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            try:
                StateFile(path, key).read()
            except ParameterError:
                pass
            else:
                require(False, "a state was used that nobody signed")

    return lambda random: mutated_zip(random, good), attempt


SRT = (
    "1\n00:00:00,000 --> 00:00:00,033\n[rel_alt: 55.5 abs_alt: 90.1] [gb_yaw: -12.5 gb_pitch: -90 gb_roll: 0]\n\n"
    "2\n00:00:00,033 --> 00:00:00,066\nF/2.8, SS 206, GPS (9.5, 47.1, 15), D 2.8m, H 6.0m, H.S 0.0m/s\n\n"
)
GEO = "EPSG:4326\na.png 9.5 47.1 400 12.5 0 0\nb.png 9.5 47.1 400 nan\n# c\n"


def logs(world: World) -> Tools:
    from semref.core.flight.logs.files import read_log
    from semref.core.flight.telemetry import log_cameras, log_links

    placed, stems, times = Placed(world.folder, "flight.log"), ["a", "b", "c"], [0.0, 1.0, 2.0]
    binary = [_ulog(), b"\xa3\x95\x80" + struct.pack("<BB4s16s64s", 128, 89, b"FMT", b"BBnNZ", b"Type,Length,Name")]
    tokens = [b"\xa3\x95\x80", b"ULog\x01\x12\x35", b"\xfd\x09", b"\xfe\x1c", b"\xff" * 8, b" --> ", b"[" * 60_000]

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            found = read_log(path)
        _finite(found.times_s)
        require((np.diff(found.times_s) >= 0).all(), "times without order")
        require(found.values.shape == (len(found.times_s), 6), "entries without fields")
        moments = [float(found.times_s[0]) + time for time in times]
        for camera in log_cameras(found, stems, moments):
            require(camera.heading_deg is None or math.isfinite(camera.heading_deg), "a heading that is none")
        log_links(found, stems, moments)

    def make(random: Random) -> bytes:
        if random.randrange(2):
            return mutated_text(random, random.choice((SRT, GEO)), ("-->", "[" * 60_000, "rel_alt:"))
        return mutated_bytes(random, random.choice(binary), tokens, 8)

    return make, attempt


def _ulog() -> bytes:
    def message(kind: str, content: bytes) -> bytes:
        return struct.pack("<HB", len(content), ord(kind)) + content

    data = b"ULog\x01\x12\x35\x01" + bytes(8) + message("F", b"vehicle_attitude:uint64_t timestamp;float[4] q;")
    data += message("A", b"\0" + struct.pack("<H", 0) + b"vehicle_attitude")
    return data + b"".join(message("D", struct.pack("<HQ4f", 0, 10**5 * n, 0.7, 0, 0, 0.7)) for n in range(20))


# --- networks ---


def networks(world: World) -> Tools:
    from made_models import brightest_color, metadata, writer

    from semref.core.segmentation.model import SegmentationModel

    shapes = {"input_shape": (1, 3, "h", "w"), "output_shape": (1, "c", "h", "w")}
    texts = {key: str(text) for key, text in metadata(tile_size=16).items()}
    samples = [writer.model_bytes(brightest_color(external=way), metadata=texts, **shapes) for way in ("", "w")]
    placed = Placed(world.folder, "model.onnx")

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            model = SegmentationModel(path, 1)
            height, width = model.tile_hw
            require(len(model.classes.names) == len(model.classes.values), "classes for other channels")
            if height * width > 1 << 16:
                return
            scores = model.scores([np.full((height, width, 3), 90, np.uint8)])
        _finite(scores)

    def make(random: Random) -> bytes:
        if random.randrange(3) == 0:
            return mutated_bytes(random, random.choice(samples), [b"../x", b"location", b"/etc/passwd"], 3)
        changed = dict(texts)
        key = random.choice(sorted(changed))
        changed[key] = mutated_text(random, changed[key]).decode("utf-8", "replace").replace("\0", "")
        return writer.model_bytes(brightest_color(), metadata=changed, **shapes)

    return make, attempt


# --- the program on board, and what is planted in a watched folder ---


def on_board(world: World) -> Tools:
    """Arguments of the command line, and names and kinds of files in a watched folder."""
    import onboard_area

    from semref.core.errors import ParameterError
    from semref.core.onboard.command_line import main

    area = world.folder.parent / "area"
    area.mkdir()
    onboard_area.write_area(str(area / "area.npz"))
    cv2.imwrite(str(area / "image.png"), onboard_area.NOTHING[:40, :40])
    (area / "broken.png").write_bytes(b"\x89PNG\r\n\x1a\nbroken")
    (area / "fleet.key").write_bytes(bytes(range(32)))
    watched = world.folder / "watched"
    watched.mkdir()
    world.forget()
    database = ["--database", str(area / "area.npz")]
    base = [
        ["info", str(area / "area.npz"), "--json"],
        ["localize", str(area / "image.png"), *database, "--json", "--near", "1", "2", "3"],
        ["localize", str(area / "broken.png"), *database, "--method", "topology-vector"],
        ["watch", str(watched), "--once", *database],
    ]
    options = (
        "--json",
        "--model",
        "--method",
        "--near",
        "--threads",
        "--require-signature",
        "--",
        "-",
        "udp:99999",
        "-h",
    )

    def make(random: Random) -> tuple[list[str], list[tuple]]:
        arguments = list(random.choice(base))
        for _ in range(random.randint(0, 2)):
            place = random.randrange(1, len(arguments) + 1)
            new = random.choice((word(random), random.choice(options), str(area / "fleet.key")))
            arguments[place : place + random.randrange(2)] = [new.replace("\0", "")[:50_000]]
        files = []
        for _ in range(random.randint(0, 3)):
            name = word(random).encode("utf-8", "replace").replace(b"/", b"_").replace(b"\0", b"")[:200]
            files.append((name + random.choice((b".png", b".jpg", b".tif", b"")), random.randrange(6)))
        return arguments, files

    def attempt(made: tuple[list[str], list[tuple]]) -> None:
        arguments, files = made
        if "watch" in arguments and "--once" not in arguments:
            arguments = [*arguments, "--once"]
        placed = [os.path.join(os.fsencode(watched), name) for name, _ in files]
        try:
            for path, (_, kind) in zip(placed, files):
                with contextlib.suppress(OSError, ValueError):
                    plant(path, kind, (area / "image.png").read_bytes())
            code = _run(main, arguments)
        finally:
            for path in placed:
                with contextlib.suppress(OSError):
                    os.rmdir(path) if os.path.isdir(path) and not os.path.islink(path) else os.unlink(path)
        if code in (2, 3):
            raise ParameterError("There is no folder {folder}; create it or watch another one.", folder="refused")

    return make, attempt


def plant(path: bytes, kind: int, picture: bytes) -> None:
    """A link to itself, a FIFO, a folder, a link to a device, a picture, or a file that is not a picture."""
    if kind == 0:
        os.symlink(os.path.basename(path), path)
    elif kind == 1:
        os.mkfifo(path)
    elif kind == 2:
        os.mkdir(path)
    elif kind == 3:
        os.symlink(b"/dev/zero", path)
    else:
        Path(os.fsdecode(path)).write_bytes(picture if kind == 4 else b"no picture")


def _run(main: Callable[[list[str]], int], arguments: list[str]) -> int:
    """Run the command line in this process; raise Broken at a fault or if it prints an invalid number."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            code: Any = main(arguments)
        except SystemExit as ended:
            code = ended.code
    require(code in (0, 1, 2, 3, 130), f"exit code {code}")
    said = err.getvalue()
    require("Traceback" not in said and '"fault"' not in said, f"a fault: {said[-1500:]}")

    def refuse(name: str) -> None:
        raise Broken(f"a result that is {name}")

    for line in (
        out.getvalue().split("\n") if code in (0, 1) and "--json" in arguments and "-h" not in arguments else ()
    ):
        if line.startswith("{"):
            json.loads(line, parse_constant=refuse)
    return int(code)


# --- faults of each kind, to show that they are found ---


def faulty(world: World) -> Tools:
    def attempt(number: int) -> None:
        faults = (
            lambda: {}["missing"],
            lambda: world.secret.read_text(encoding="ascii"),
            lambda: (world.folder / "stray").write_text("x", encoding="ascii"),
            lambda: bytearray(4 << 30),
            lambda: socket.create_connection(world.listener.getsockname()),
        )
        faults[number]()

    return lambda random: random.randrange(5), attempt


def dying(world: World) -> Tools:
    def attempt(number: int) -> None:
        if number == 5:
            os.kill(os.getpid(), signal.SIGKILL)

    return lambda random: random.randrange(8), attempt


DOORS = (
    Door("classes", "class tables (CSV)", class_tables),
    Door("cameras", "camera tables: attitude, lens, time (CSV)", camera_tables),
    Door("odometry", "odometry tables (CSV)", odometry_tables),
    Door("routes", "routes: `.plan`, `.waypoints`, GPX", routes),
    Door("parameters", "parameters of a database (JSON)", build_parameters),
    Door("keys", "key files, signatures", keys),
    Door("label_images", "label images on board (PNG, TIFF, JPEG)", label_images_on_board),
    Door("label_maps", "label maps and label images in QGIS", label_maps),
    Door("photos", "photos in QGIS, with EXIF and XMP", photos),
    Door("photos_on_board", "photos on board", photos_on_board),
    Door("databases", "reference databases: rows, schema, bytes", databases, 0.1),
    Door("onboard", "onboard files: zip, arrays, header, area", onboard_files, 0.5),
    Door("flight_state", "what `watch --flight` keeps of a flight", flight_states, 0.1),
    Door("logs", "flight logs: `.bin`, `.ulg`, `.SRT`, `geo.txt`", logs),
    Door("networks", "networks: ONNX files and their metadata", networks, 0.1),
    Door("on_board", "arguments of `semref`, and files planted in a watched folder", on_board, 0.1),
)
FAULTY = (Door("faulty", "made to be found", faulty), Door("dying", "made to die", dying))
