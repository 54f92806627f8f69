"""What “Set up an area” reads before it starts: map, photos and imagery, and the sizes that follow from them."""

from __future__ import annotations

import hashlib
import math
import os
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsCsException,
    QgsPointXY,
    QgsProcessingFeedback,
    QgsRectangle,
)

from ...core.area_plan import FEW_LANDMARKS, AreaPlan, MeasuredLandmarks, plan_area
from ...core.errors import ParameterError, SemRefError
from ...core.labels.class_colors import is_usual_landmark
from ...core.labels.openstreetmap import Rules
from ...core.labels.photo_camera import photo_camera
from ...core.tables import stem_of
from ...storage.photo_position import photo_lon_lat
from ...storage.rasters import image_files, open_raster
from ..base.algorithm import check_canceled, each
from ..layers.guess_fields import BUILDING
from ..layers.layer_inputs import stated_pixel_size_m
from ..layers.reference_systems import WGS84, metric_crs, transformed_box, transformed_point
from ..messages.numbers import LocalTemplate
from ..translation import tr
from .area_map import AreaMap

RATIO = 0.75
"""Height to width of a typical photo, where no photo is known."""

LEAST_MARGIN_M, MARGIN_PHOTOS = 300.0, 3.0
"""Ground around the photos' GPS positions that the database covers: at least this, or this number of photo widths."""

_VIEW_DEG = 2 * math.degrees(math.atan(0.5))
"""Field of view of a camera whose height is the ground width of its photos."""

_WIDTHS_READ = 2000

LEAST_OF_FLIGHT, USUAL_GAP_S = 3, 20.0
"""Photos are one flight if there are at least so many, and half of them are taken at most so long after the one before.
Longer gaps, as for a change of batteries, do no harm: the flight begins again there."""


@dataclass(frozen=True)
class AreaPhotos:
    """Photos and the ground that a typical one shows.

    Attributes:
        size_m: (width, height) of the ground, m.
        unknown: Photos without height, lens or georeference.
        places: (longitude, latitude) of photos with a GPS position, degrees.
        is_assumed: Whether the size follows from the pixels of the imagery.
        pixel_m: Pixel size of a typical photo; None without photos.
        is_flight: Whether their times show that they are one flight.
    """

    files: Sequence[str]
    size_m: tuple[float, float]
    unknown: Sequence[str] = ()
    places: Sequence[tuple[float, float]] = ()
    is_assumed: bool = False
    pixel_m: float | None = None
    is_flight: bool = False


def read_photos(
    paths: Sequence[str],
    width_m: float | None,
    imagery_pixel_m: float | None,
    whole_map: QgsRectangle,
    feedback: QgsProcessingFeedback,
) -> AreaPhotos:
    """Read sizes and GPS positions of photos.

    Args:
        paths: Files and folders; may be empty if ``width_m`` is known.
        width_m: Ground width of a typical photo; None if unknown.
        imagery_pixel_m: Pixel size of the imagery, which photos without camera data are assumed to have.
        whole_map: In degrees. Photos with a GPS position outside do not count for the ground width, unless all are.

    Raises:
        ParameterError: The ground width is unknown.
        SemRefError: A folder has no images, or no photo can be read.
    """
    files = image_files(list(paths))
    shapes: dict[str, tuple[int, int]] = {}
    sizes: dict[str, float | None] = {}
    places: dict[str, tuple[float, float]] = {}
    times_s: list[float | None] = []
    faults = []
    for path in files:
        check_canceled(feedback)
        try:
            raster = open_raster(path)
        except SemRefError as error:
            # Localizing reports it as the reason of this photo.
            faults.append(error)
            continue
        shapes[path] = raster.RasterYSize, raster.RasterXSize
        camera = photo_camera(path)
        times_s.append(camera.time_s)
        stated = stated_pixel_size_m(path)
        sizes[path] = camera.pixel_size(shapes[path]) if stated is None else stated[0]
        place = photo_lon_lat(path)
        if place is not None:
            places[path] = place
    if faults and not shapes:
        raise faults[0]
    elsewhere = {path for path, place in places.items() if not whole_map.contains(QgsPointXY(*place))}
    counted = sizes.keys() - elsewhere or sizes.keys()
    known = [size * shapes[path][1] for path, size in sizes.items() if size and path in counted]
    is_assumed = width_m is None and not known
    if is_assumed and not (imagery_pixel_m and shapes):
        raise ParameterError(
            "The photos do not state the height of the camera, so their ground width is unknown. Enter the ground "
            "width of a typical photo in m."
            if files
            else "Select photos, or enter the ground width of a typical photo in m."
        )
    typical_m = width_m or median(known or [imagery_pixel_m * width for _, width in shapes.values()])
    ratio = median([height / width for height, width in shapes.values()]) if shapes else RATIO
    unknown = [path for path, size in sizes.items() if not size]
    pixel_m = typical_m / median([width for _, width in shapes.values()]) if shapes else None
    size_m = typical_m, typical_m * ratio
    return AreaPhotos(files, size_m, unknown, list(places.values()), is_assumed, pixel_m, _is_flight(times_s))


def _is_flight(times_s: Sequence[float | None]) -> bool:
    known = sorted(time_s for time_s in times_s if time_s is not None)
    gaps = [later - earlier for earlier, later in zip(known, known[1:])]
    return len(known) == len(times_s) >= LEAST_OF_FLIGHT and median(gaps) <= USUAL_GAP_S


@dataclass(frozen=True)
class AreaSetup:
    """What was read, and the sizes that follow from it.

    Attributes:
        crs: Metric CRS of the database.
        extent: Ground of the database in ``crs``.
        reference: Names of the landmark classes.
        digest: Identifies the polygons in the extent.
        warnings: One sentence for each reason why it may not work.
    """

    photos: AreaPhotos
    plan: AreaPlan
    crs: QgsCoordinateReferenceSystem
    extent: QgsRectangle
    classes: frozenset[str]
    reference: tuple[str, ...]
    digest: str
    warnings: tuple[str, ...]

    def summary(self, minutes: float) -> str:
        """Return one sentence for the user, before anything starts."""
        plan = self.plan
        photos = len(self.photos.files)
        counted = tr("1 photo.") if photos == 1 else tr("{photos} photos.").format(photos=photos)
        text = tr(
            "Window {window:g} m, pixels of {pixel:g} m, {landmarks} polygons of at least {area:g} m² "
            "({classes}), about {per_photo} in a typical photo. {training}, database about {size:g} MB."
        )
        training = tr("No training")
        if minutes:
            training = LocalTemplate(tr("Training about {minutes:g} minutes")).format(minutes=minutes)
        numbers = LocalTemplate(text).format(
            window=plan.window_m,
            pixel=plan.pixel_size_m,
            area=plan.minimum_area_m2,
            landmarks=plan.landmarks,
            classes=", ".join(self.reference),
            per_photo=plan.per_photo,
            training=training,
            # Two digits, but never as 1.7e+02.
            size=float(f"{plan.megabytes:.2g}"),
        )
        return f"{counted} {numbers}"


def read_area(
    area: AreaMap,
    photos: AreaPhotos,
    given: tuple[QgsRectangle, QgsCoordinateReferenceSystem],
    rules: Rules,
    known: Sequence[str],
    imagery_pixel_m: float | None,
    context: QgsCoordinateTransformContext,
    feedback: QgsProcessingFeedback,
) -> AreaSetup:
    """Read the map within its extent and return the sizes.

    Args:
        given: The user's extent, empty without one, and its CRS.
        known: Classes of the model; empty for a model that is trained on the map's classes.
        imagery_pixel_m: Pixel size of the imagery for training, m; None without imagery.

    Raises:
        ParameterError: No landmark is in the extent, or all photos are outside the map.
        AnnotationError: The map has no CRS.
    """
    crs = metric_crs(area.crs, QgsCoordinateReferenceSystem(), area.extent, context)
    extent, warnings = _extent(area, photos, given, crs, context)
    to_metric = QgsCoordinateTransform(area.crs, crs, context)
    names = {name.casefold() for name in known}
    classes: set[str] = set()
    areas, widths, centers, sha = [], [], [], hashlib.sha256()
    back = transformed_box(QgsCoordinateTransform(crs, area.crs, context), extent)
    for name, geometry in each(area.polygons(back, rules), feedback):
        if not name or geometry.isEmpty():
            continue
        sha.update(name.encode() + b"\0" + geometry.asWkb().data())
        classes.add(name)
        if not is_usual_landmark(name) or (names and name.casefold() not in names):
            continue
        try:
            geometry.transform(to_metric)
        except QgsCsException:
            continue
        areas.append(geometry.area())
        centers.append(geometry.boundingBox().center())
        if len(widths) < _WIDTHS_READ and BUILDING in name.casefold():
            _, _, _, width, height = geometry.orientedMinimumBoundingBox()
            widths.append(min(width, height))
    if not areas:
        raise _nothing_found(area.name, classes, known)
    points = np.array([(point.x(), point.y()) for point in centers])
    bounds = extent.xMinimum(), extent.yMinimum(), extent.xMaximum(), extent.yMaximum()
    landmarks = MeasuredLandmarks(np.array(areas), np.array(widths), points, bounds)
    plan = plan_area(landmarks, photos.size_m, imagery_pixel_m)
    warnings += _warnings(photos, plan, extent)
    reference = tuple(
        sorted(name for name in classes if is_usual_landmark(name) and (not names or name.casefold() in names))
    )
    return AreaSetup(photos, plan, crs, extent, frozenset(classes), reference, sha.hexdigest(), tuple(warnings))


def _warnings(photos: AreaPhotos, plan: AreaPlan, extent: QgsRectangle) -> list[str]:
    """Return one sentence for each reason why the photos may get no position."""
    warnings = []
    if photos.is_assumed:
        text = tr("The photos have no camera data. Their pixels are assumed to be as large as those of the imagery.")
        warnings.append(text)
    if photos.size_m[0] > max(extent.width(), extent.height()):
        text = tr(
            "A typical photo shows {width:.0f} m of ground, more than the map. Check the ground width of a photo."
        )
        warnings.append(text.format(width=photos.size_m[0]))
    if plan.per_photo < FEW_LANDMARKS:
        text = tr(
            "Landmarks in a typical photo: about {count}. With fewer than {least}, many photos get no position. Fly "
            "higher, or use a map with more buildings."
        )
        warnings.append(text.format(count=plan.per_photo, least=FEW_LANDMARKS))
    return warnings


def _nothing_found(name: str, classes: set[str], known: Sequence[str]) -> ParameterError:
    if not classes:
        return ParameterError(
            "“{layer}” has no polygon with a class in the extent. Check the extent, the CRS and the class field.",
            layer=name,
        )
    if known:
        return ParameterError(
            "“{layer}” has no landmarks of the model in the extent. Its classes are {classes}, those of the model are "
            "{known}. Choose another model, or train one.",
            layer=name,
            classes=sorted(classes),
            known=list(known),
        )
    return ParameterError(
        "“{layer}” has no landmarks in the extent, only {classes}. Choose a map with buildings, water or bare land.",
        layer=name,
        classes=sorted(classes),
    )


def _extent(
    area: AreaMap,
    photos: AreaPhotos,
    given: tuple[QgsRectangle, QgsCoordinateReferenceSystem],
    crs: QgsCoordinateReferenceSystem,
    context: QgsCoordinateTransformContext,
) -> tuple[QgsRectangle, list[str]]:
    """Return the ground of the database in ``crs``, and warnings about photos outside the map."""
    whole = transformed_box(QgsCoordinateTransform(area.crs, crs, context), area.extent)
    if not given[0].isEmpty():
        wanted = transformed_box(QgsCoordinateTransform(given[1], crs, context), given[0])
        extent = wanted.intersect(whole)
        if extent.isEmpty():
            raise ParameterError("“{layer}” and the extent do not overlap. Choose another extent.", layer=area.name)
        return extent, []
    to_map = QgsCoordinateTransform(QgsCoordinateReferenceSystem(WGS84), crs, context)
    found = (transformed_point(to_map, QgsPointXY(*place)) for place in photos.places)
    points = [point for point in found if point is not None]
    if not points:
        return whole, []
    inside = [point for point in points if whole.contains(point)]
    if not inside and len(points) == len(photos.files):
        raise ParameterError(
            "All photos with a GPS position were taken outside “{layer}”. Choose a map of the place of the photos.",
            layer=area.name,
        )
    text = tr("Photos with a GPS position outside the map: {count} of {all}.")
    outside = len(points) - len(inside)
    warnings = [text.format(count=outside, all=len(points))] if outside else []
    if not inside:
        return whole, warnings
    extent = QgsRectangle(inside[0], inside[0])
    for point in inside:
        extent.include(point)
    extent.grow(max(LEAST_MARGIN_M, MARGIN_PHOTOS * photos.size_m[0]))
    return extent.intersect(whole), warnings


def camera_table(photos: AreaPhotos) -> str:
    """Return a camera table (CSV) that gives photos without camera data the ground width of a typical photo."""
    # A field of view, because photos of one name in several folders or formats share a row, but not their pixels.
    lens = f"{photos.size_m[0]:.6g},{_VIEW_DEG:.8g}"
    # One row for each stem. The suffix stays: without it, reading would take the end of “a.b” for one.
    files = {stem_of(path): os.path.basename(path).replace('"', '""') for path in photos.unknown}
    return "\n".join(["image,height,field_of_view", *(f'"{files[stem]}",{lens}' for stem in sorted(files)), ""])
