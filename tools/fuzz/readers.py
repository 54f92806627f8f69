"""The table of readers: valid files of each, how it reads them, and what must be true of the result."""

import contextlib
import gzip
import io
import os
import signal
import socket
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any

import numpy as np
from osgeo import gdal

from semref.core.errors import SemRefError
from semref.core.flight.cameras import read_cameras
from semref.core.flight.logs.files import read_log
from semref.core.flight.motion import links_by_image
from semref.core.flight.odometry import odometry_links, read_odometry
from semref.core.flight.telemetry import log_cameras, log_links
from semref.core.labels import image_files
from semref.core.labels.class_table import class_table_from_csv
from semref.core.onboard.format import digest
from semref.core.onboard.read import read_onboard
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.onnx_file import read_header, with_metadata
from semref.core.segmentation.resampling import at_resolution
from semref.storage.database.reader import read_database, read_stored_database, stored_style
from semref.storage.images import GdalImage
from semref.storage.label_images import read_label_image
from semref.storage.label_maps import GdalLabels, RasterFile, class_table_of_map
from semref.storage.rasters import open_raster, require_own_pixels
from semref.storage.route_files import read_waypoint_file
from semref.storage.text_tables import read_class_table

from .contract import Refused, World, placed, require
from .mutator import changed_text, mutated, npy, zip_of

SAMPLES = Path(__file__).with_name("samples")
KEPT = Path(__file__).resolve().parents[2] / "tests" / "data" / "kept" / "v1"
CLASSES = class_table_from_csv("value,name,color,role\n1,building,#ff0000,reference\n2,water,#0000ff,background\n")
Trial = tuple[Callable[[Random], Any], Callable[[Any], None]]
"""Makes an input from random numbers; reads it and checks the result."""


@dataclass(frozen=True)
class Reader:
    """A reader: its name for the command line, what prepares its trial, and its share of the examples."""

    name: str
    prepare: Callable[[World], Trial]
    share: float = 1.0


def of_files(samples: Path, read: Callable[[str], None], change: Callable[[Random, bytes], bytes] = mutated) -> Any:
    """Return what prepares the trial of a reader of one file.

    Args:
        samples: Folder of valid files and of files that name {secret} or {url} of the world; or one file.
        read: Reads the file at a path and checks the result.
        change: The mutator.
    """

    def prepare(world: World) -> Trial:
        files = []
        for path in sorted(samples.iterdir()) if samples.is_dir() else [samples]:
            data = gzip.decompress(path.read_bytes()) if path.suffix == ".gz" else path.read_bytes()
            data = data.replace(b"{secret}", str(world.secret).encode()).replace(b"{url}", world.url.encode())
            files.append((path.name, data))

        def attempt(made: tuple[str, bytes]) -> None:
            with placed(world.folder / made[0], made[1]) as path:
                read(path)

        for file in files:  # what this imports does not count
            with contextlib.suppress(SemRefError, Refused):
                attempt(file)

        def make(random: Random) -> tuple[str, bytes]:
            name, data = random.choice(files)
            return name, change(random, data)

        return make, attempt

    return prepare


def require_finite(*numbers: Any) -> None:
    require(all(np.isfinite(np.array(some, np.float64)).all() for some in numbers), "a number is not finite")


def check_classes(path: str) -> None:
    table = read_class_table(path)
    require(all(0 <= c.value <= 255 and 0 < len(c.name) <= 255 for c in table), "an invalid class")
    require(not len(table) or class_table_from_csv(table.to_csv()) == table, "it is written differently")


def check_cameras(path: str) -> None:
    for camera in read_cameras(["a.png", "/x/b.png", "c.png"], path):
        require_finite(camera.time_s or 0)
        found = camera.leveling((90, 120))
        if found is not None:
            require_finite(found.homography)
            require(all(1 <= size <= 20_000 for size in found.shape_hw), "the leveled image has an invalid size")


def check_odometry(path: str) -> None:
    links = odometry_links(read_odometry(path), ["a.png", "b.png", "c.png", "d.png"])
    for link in links_by_image(links, 4).values():
        require_finite(link.translation, link.turn, link.log_scale, link.covariance)


def check_route(path: str) -> None:
    for line in read_waypoint_file(path):
        require(line.ndim == 2 and line.shape[1] == 2, "a line without coordinates")
        require((np.abs(line) <= (180, 90)).all(), "a place off the Earth")


def check_flight_log(path: str) -> None:
    found, stems = read_log(path), ["a", "b", "c"]
    require_finite(found.times_s)
    require(len(found.times_s) <= 16 * 200_000, "more entries than the limit")
    require((np.diff(found.times_s) >= 0).all(), "times are not sorted")
    require(found.values.shape == (len(found.times_s), 6), "entries without fields")
    moments = [float(found.times_s[0]) + time for time in range(3)]
    require_finite([camera.heading_deg or 0 for camera in log_cameras(found, stems, moments)])
    log_links(found, stems, moments)


def require_labels(labels: np.ndarray) -> None:
    require(labels.dtype == np.uint8 and labels.ndim == 2 and labels.size > 0, "no labels")


def check_label_image_on_board(path: str) -> None:
    require_labels(image_files.read_label_image(path, CLASSES))


def check_label_map(path: str) -> None:
    labels = GdalLabels(path)
    height, width = labels.shape_hw
    class_table_of_map(labels, RasterFile(path))
    require_finite(labels.dataset.GetGeoTransform(can_return_null=True) or (0,))
    require_labels(labels.read(0, 0, min(width, 512), min(height, 512)))
    require_labels(read_label_image(path, CLASSES))


def check_photo_in_qgis(path: str) -> None:
    image = GdalImage(path)
    height, width = image.shape_hw
    pixels, _ = image.read(0, 0, min(width, 512), min(height, 512))
    require(pixels.dtype == np.uint8 and pixels.shape[2] == 3, "no photo")
    camera = read_cameras([path], "")[0]
    require_finite(camera.time_s or 0)
    level = camera.leveling((height, width)) if height * width < 10**8 else None
    require(level is None or min(level.shape_hw) > 0, "the leveled image has no pixels")


def check_photo_on_board(path: str) -> None:
    photo = image_files.read_photo(path)
    height, width = photo.image.shape_hw
    pixels, _ = photo.image.read(0, 0, width, height)
    require(pixels.shape == (height, width, 3) and pixels.dtype == np.uint8, "no photo")
    size = photo.pixel_size_m
    require(size is None or all(np.isfinite(length) and length > 0 for length in size), f"pixels of {size} m")
    resampled = at_resolution(photo.image, size, 0.5)
    height, width = resampled.shape_hw
    require(min(height, width) > 0, "the resampled photo has no pixels")
    resampled.read(0, 0, min(width, 64), min(height, 64))


def check_side_file(path: str) -> None:
    """Read a valid raster with a file of metadata, overviews or a mask beside it."""
    gdal.SetConfigOption("GDAL_HTTP_TIMEOUT", "1")  # the host never answers
    raster = Path(path.partition(".tif")[0] + ".tif")
    with placed(raster, (SAMPLES / "images" / "class_table.tif").read_bytes()):
        require_own_pixels(str(raster))
        dataset = open_raster(str(raster))
        dataset.GetRasterBand(1).GetMaskFlags()
        # Half the size is read from overviews if there are any.
        dataset.GetRasterBand(1).ReadAsArray(0, 0, 30, 24, 15, 12)


def require_sound(database: Any) -> None:
    """Require what localization relies on."""
    windows, landmarks, parameters = database.windows, database.references, database.parameters
    require_finite(windows.centers, windows.sizes, windows.vectors, landmarks.positions, landmarks.areas_m2)
    x_min, y_min, x_max, y_max = parameters.extent
    slack = parameters.pixel_size
    for places in (windows.centers, landmarks.positions):
        inside = (places >= (x_min - slack, y_min - slack)) & (places <= (x_max + slack, y_max + slack))
        require(inside.all(), "a place off the map")


def check_database(path: str) -> None:
    stored_style(path, "windows")
    require_sound(read_database(path, with_overview=True))
    stored = read_stored_database(path)
    require(len(stored.window_fids) == len(stored.database.windows), "windows without rows")


def check_onboard_file(path: str) -> None:
    onboard = read_onboard(path)
    require_sound(onboard.database)
    require_finite([onboard.position_error, onboard.area_error, onboard.vector_error])
    if onboard.lon_lat is not None:
        longitudes, latitudes = onboard.lon_lat(onboard.database.windows.centers)
        require((np.abs(longitudes) <= 180).all() and (np.abs(latitudes) <= 90).all(), "a place off the Earth")


def with_new_hash(random: Random, data: bytes) -> bytes:
    """Return a changed onboard file with its correct hash."""
    data = mutated(random, data)
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            members = {name: archive.read(name) for name in archive.namelist()}
    except Exception:
        return data
    found = digest({name[:-4]: content for name, content in members.items()})
    return zip_of({**members, "content_hash.npy": npy(found)})


def check_network(path: str) -> None:
    model = SegmentationModel(path, 1)
    height, width = model.tile_hw
    require(len(model.classes.names) == len(model.classes.values), "classes of other channels")
    if height * width <= 1 << 16:
        require_finite(model.scores([np.full((height, width, 3), 90, np.uint8)]))


def with_other_metadata(random: Random, data: bytes) -> bytes:
    """Return a network with one changed text in its metadata, or with changed bytes."""
    if random.randrange(3) == 0:
        return mutated(random, data)
    texts = read_header(data).texts
    key = random.choice(sorted(texts))
    return with_metadata(data, key, changed_text(random, texts[key].encode()).decode("utf-8", "replace"))


def faulty(world: World) -> Trial:
    faults = (
        lambda: {}["missing"],
        lambda: world.secret.read_text(encoding="ascii"),
        lambda: (world.folder / "stray").write_text("x", encoding="ascii"),
        lambda: bytearray(4 << 30),
        lambda: socket.create_connection(world.listener.getsockname()),
    )
    return lambda random: random.randrange(len(faults)), lambda number: faults[number]()


def dying(world: World) -> Trial:
    return lambda random: random.randrange(8), lambda number: number == 5 and os.kill(os.getpid(), signal.SIGKILL)


READERS = (
    Reader("classes", of_files(SAMPLES / "classes", check_classes)),
    Reader("cameras", of_files(SAMPLES / "cameras", check_cameras)),
    Reader("odometry", of_files(SAMPLES / "odometry", check_odometry)),
    Reader("routes", of_files(SAMPLES / "routes", check_route)),
    Reader("logs", of_files(SAMPLES / "logs", check_flight_log)),
    Reader("label_images", of_files(SAMPLES / "images", check_label_image_on_board)),
    Reader("label_maps", of_files(SAMPLES / "images", check_label_map)),
    Reader("photos", of_files(SAMPLES / "images", check_photo_in_qgis)),
    Reader("photos_on_board", of_files(SAMPLES / "images", check_photo_on_board)),
    Reader("side_files", of_files(SAMPLES / "side_files", check_side_file)),
    Reader("databases", of_files(KEPT / "database.gpkg.gz", check_database), 0.1),
    Reader("onboard", of_files(KEPT / "onboard.npz", check_onboard_file, with_new_hash), 0.5),
    Reader("networks", of_files(SAMPLES / "networks", check_network, with_other_metadata), 0.1),
)
FAULTY = (Reader("faulty", faulty), Reader("dying", dying))
"""Faults of each kind, to show that they are found."""
