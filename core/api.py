"""The public Python API: eight functions for work without QGIS, exported by ``semref.core``.

GeoPackages and georeferenced rasters need GDAL, which ``core`` does not use. So ``open_database`` opens the onboard
file that *Export for onboard use* or ``save_database`` wrote, and ``build_database`` takes labels as an array. All
functions raise ``core.errors.SemRefError`` with a message for the user.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Union

import numpy as np

from .database.build import BuildSettings, build_from_labels
from .database.model import ReferenceDatabase
from .evaluation.evaluation import Evaluation, TrialRanges
from .evaluation.summary import MethodSummary, summarize
from .flight.cameras import read_cameras
from .flight.flight import localize_flight as localize_images_of_flight
from .flight.model import FlightImage
from .flight.pixel_features import features_of
from .flight.pixel_links import PixelLinks
from .flight.settings import FLIGHT
from .geometry.camera import Camera
from .geometry.frame import MapFrame
from .labels.class_shares import SeenLabels
from .labels.class_table import ClassTable, class_table_from_csv
from .labels.image_files import read_label_image, read_photo
from .labels.image_source import ArrayImage, Photo
from .labels.sources import ArrayLabels
from .localization import RISK, Localization, Method, Prior
from .localizer.localizer import Localizer
from .localizer.search import Search
from .localizer.settings import LOCALIZER
from .onboard.read import read_onboard
from .onboard.write import write_onboard
from .pipeline import LabelReader, Pipeline

Image = Union[str, np.ndarray]
"""Path of a file, or pixels: (H, W) uint8 labels, or with a model (H, W, 3) uint8 colors, red first."""

WINDOW_PX, STRIDE_PX = 512, 128
"""Default edge and stride of a window, pixels of the label map."""

BUILT_BY = "semref.core"
"""Version text that built databases have instead of the plugin's version."""


def read_class_table(path: str) -> ClassTable:
    """Read a class table (CSV: value, name, color, role).

    Args:
        path: Path of the file.

    Raises:
        ClassTableError: The file is not a class table.
        OSError: The file can't be read.
    """
    with open(path, encoding="utf-8-sig") as file:
        return class_table_from_csv(file.read(), path)


def build_database(  # noqa: PLR0913 - a map, where it is, and what is wanted of it
    labels_hw: np.ndarray,
    table: ClassTable,
    pixel_size: float,
    origin: tuple[float, float] = (0.0, 0.0),
    crs: str = "",
    settings: BuildSettings | None = None,
) -> ReferenceDatabase:
    """Build a reference database from a label map in memory.

    Args:
        labels_hw: (H, W) uint8 class values, north up, 0 = unknown.
        table: Classes of the map, with the landmark classes.
        pixel_size: Edge of a pixel, map units.
        origin: Map (x, y) of the upper left corner.
        crs: WKT of a metric CRS; "" if it does not matter.
        settings: Windows and smallest landmark; the default is windows of 512 pixels and landmarks of 16 pixels².

    Returns:
        The database with its overview, which map correlation and flights need.

    Raises:
        LabelMapError: The map has no landmark.
        WindowError: The windows do not fit the map.
    """
    settings = settings or BuildSettings(WINDOW_PX * pixel_size, STRIDE_PX * pixel_size, 16 * pixel_size**2)
    frame = MapFrame.at(origin, pixel_size, crs=crs)
    return build_from_labels(ArrayLabels(labels_hw), frame, table, settings, BUILT_BY)


def open_database(path: str, key_file: str | None = None) -> ReferenceDatabase:
    """Open an onboard file (.npz).

    Args:
        path: Path of the file.
        key_file: File of the key that the file must be signed with; None to accept any file.

    Raises:
        DatabaseError: The file is damaged, is not an onboard file, or is not signed with the key.
    """
    return read_onboard(path, key_file=key_file).database


def save_database(database: ReferenceDatabase, path: str) -> None:
    """Write a database as an onboard file, without longitude and latitude, which only QGIS can compute.

    Args:
        path: Path of the file (.npz).

    Raises:
        DatabaseError: The format cannot store the database.
    """
    write_onboard(path, database, None)


def segment(photo: Image, model: str, table: ClassTable | None = None) -> np.ndarray:
    """Label a photo with a segmentation network.

    Args:
        photo: Path of a PNG, JPEG or TIFF file, or (H, W, 3) uint8, red first.
        model: Path of the network (.onnx).
        table: Classes of the labels; None for the network's own.

    Returns:
        (H, W) uint8 class values on the pixels of the photo.

    Raises:
        ImageError: The photo can't be used.
        ModelError: The network can't be used, or lacks a landmark class of the table.
    """
    from .segmentation.model import SegmentationModel
    from .segmentation.photo_labels import PhotoLabels

    network = SegmentationModel(model, 1)
    values = network.classes.values if table is None else network.classes.values_in(table, model)
    opened = _photo(photo)
    return PhotoLabels(network, opened.image, values, opened.pixel_size_m).found()


def localize(  # noqa: PLR0913 - what is known of the images
    images: Sequence[Image],
    database: ReferenceDatabase,
    model: str | None = None,
    method: str = Method.AUTOMATIC.key,
    prior: Prior | None = None,
    cameras: str = "",
    risk: float = RISK,
    sun_deg: float | None = None,
) -> list[Localization]:
    """Localize images independently of each other. All images of one call share the search index.

    Args:
        images: Label images; photos if ``model`` is given.
        database: The database to search.
        model: Path of the segmentation network (.onnx) for photos.
        method: "automatic", "constellation", "map correlation" or "topology vector".
        prior: What is known of all images.
        cameras: Path of a camera table (CSV); EXIF and XMP of the files are read without it, too.
        risk: Maximum error probability of a fix.
        sun_deg: Direction of the sun, clockwise from grid north; for a model with class offsets that turn with it.

    Returns:
        One result for each image, in order: ``status``, ``position``, ``error_95_m``, ``risk``, ``reason``, … A likely
        position (``is_likely``) has a ``position`` and no ``fix``.

    Raises:
        SemRefError: A file can't be used.
        ValueError: The method does not exist, or an array is not an image.
    """
    search = Search(_method(method), prior or Prior())
    pipeline, known = _prepared(images, database, model, search, cameras, risk, sun_deg)
    return [pipeline.run(name, camera).localization for name, camera in known]


def localize_flight(  # noqa: PLR0913 - as of ``localize``
    images: Sequence[Image],
    database: ReferenceDatabase,
    model: str | None = None,
    prior: Prior | None = None,
    cameras: str = "",
    risk: float = RISK,
    sun_deg: float | None = None,
) -> list[Localization]:
    """Localize the images of one flight together; the overlap of consecutive images gives the motion.

    Args:
        images: In the order of the flight, as for ``localize``.
        database: A database with an overview.
        model: As for ``localize``.
        prior: As for ``localize``.
        cameras: As for ``localize``.
        risk: Maximum error probability of a track.
        sun_deg: As for ``localize``.

    Returns:
        One result for each image, in order.

    Raises:
        DatabaseError: The database has no overview.
        SemRefError: A file can't be used.
    """
    search = Search(Method.AUTOMATIC, prior or Prior())
    pipeline, known = _prepared(images, database, model, search, cameras, risk, sun_deg)
    pipeline = replace(pipeline, looks_again=False)
    results, flown, pixels = [], [], PixelLinks()
    for name, camera in known:
        result = pipeline.run(name, camera, with_pixels=True)
        seen = result.seen
        image = FlightImage.of(name, result, camera.time_s)
        flown.append(replace(image, is_apart=pixels.add(features_of(seen.labels_hw, seen.pixels, result.leveling))))
        results.append(replace(result, seen=replace(seen, pixels=None)))
    settings = replace(FLIGHT, allowed_risk=risk)
    poses = localize_images_of_flight(flown, pixels.links, pipeline.localizer, settings)
    return [result.as_taken(pose.localization()) for result, pose in zip(results, poses)]


def evaluate(
    database: ReferenceDatabase,
    labels_hw: np.ndarray,
    method: str = Method.AUTOMATIC.key,
    count: int = 100,
    seed: int = 1,
) -> MethodSummary:
    """Localize simulated images of known position, cut from a label map and degraded, and summarize the results.

    Args:
        database: The database to test.
        labels_hw: (H, W) uint8 labels of the same ground as the database's map; their date may differ.
        method: As for ``localize``.
        count: Number of images; every tenth is mirrored, so that any fix of it is wrong.
        seed: The same seed repeats the result.

    Returns:
        Rates of right and wrong fixes, of fixes of mirrored images, and errors.

    Raises:
        ValueError: The shape of the labels differs from that of the database's map.
        ParameterError: No window has enough landmarks.
    """
    frame = database.parameters.frame
    if labels_hw.shape != frame.shape_hw:
        raise ValueError(f"the labels have the shape {labels_hw.shape}, the database's map has {frame.shape_hw}")
    evaluation = Evaluation(database, ArrayLabels(labels_hw), frame, TrialRanges(), seed)
    mirrored = count // 10
    trials = []
    for query in evaluation.trials(count - mirrored, mirrored):
        trials += evaluation.run(query, [_method(method)])
    return summarize(trials, method)


def _prepared(  # noqa: PLR0913 - what is known of the images
    images: Sequence[Image],
    database: ReferenceDatabase,
    model: str | None,
    search: Search,
    cameras: str,
    risk: float,
    sun_deg: float | None,
) -> tuple[Pipeline, list[tuple[str, Camera]]]:
    """Return the pipeline for images, and (name, camera) of each; the name of an array is its number."""
    names = [image if isinstance(image, str) else f"image {number}" for number, image in enumerate(images)]
    arrays = {name: image for name, image in zip(names, images) if not isinstance(image, str)}
    of_files = iter(read_cameras([name for name in names if name not in arrays], cameras))
    known = [(name, Camera() if name in arrays else next(of_files)) for name in names]
    localizer = Localizer(database, replace(LOCALIZER, allowed_risk=risk), sun_deg)
    localizer.check(search.method, search.known)
    return Pipeline(localizer, search, _reader(database.class_table, model, arrays)), known


def _method(key: str) -> Method:
    found = {method.key: method for method in Method}
    if key not in found:
        raise ValueError(f"there is no method “{key}”; the methods are {', '.join(found)}")
    return found[key]


def _reader(table: ClassTable, model: str | None, arrays: dict[str, np.ndarray]) -> LabelReader:
    if not model:

        def read(path: str, camera: Camera | None = None, with_pixels: bool = False) -> SeenLabels:
            labels_hw = arrays[path] if path in arrays else read_label_image(path, table)
            if labels_hw.ndim != 2:
                raise ValueError(f"{path} has the shape {labels_hw.shape}; labels are (H, W), photos need a model")
            return SeenLabels(labels_hw)

        return read
    # Only photos need onnxruntime.
    from .segmentation.model import SegmentationModel
    from .segmentation.photo_labels import PhotoReader

    return PhotoReader(SegmentationModel(model, 1), table, lambda path: _photo(arrays.get(path, path)))


def _photo(image: Image) -> Photo:
    return read_photo(image) if isinstance(image, str) else Photo(ArrayImage(image), None)
