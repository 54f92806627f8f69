"""semref:georeferenceimages: georeference images that have a position."""

from __future__ import annotations

import os
from functools import partial
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING, Callable

from qgis.core import (
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterMultipleLayers,
)

from ...core.errors import ImageError, SemRefError, UnwritableError
from ...core.localization import Status
from ...core.named_files import named_file
from ...core.sentences import legible
from ..base import parameters
from ..base.algorithm import LOCALIZATION, Declared, SemRefAlgorithm, cancelable, check_canceled
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import SOURCE_FILE, SOURCE_POINT, SOURCE_POLYGON, wkt_for_gdal
from ..jobs.image_results import unique_names
from ..layers.results_file import GEOTIFF, MOSAIC, MOSAIC_FILE, WORLD_FILE
from ..messages.sentences import worded
from ..translation import tr

if TYPE_CHECKING:
    import numpy as np

    from ...storage.georeferencing import ControlPoint
    from ..layers.positions import PositionRow

LEAST_MATCHES = 4
"""Landmarks that are needed as control points; with fewer, the corners of the computed footprint are used."""


class GeoreferenceImages(SemRefAlgorithm):
    ID = "georeferenceimages"
    TITLE = "Georeference images"
    GROUP = LOCALIZATION
    TAGS = ("georeference", "geotiff", "world file", "georeferencer", "ground control points", "gcp", "points", "lay")
    SUMMARY = (
        "Georeferences images with the positions of “Localize images”: as GeoTIFFs, as one mosaic, with world files, "
        "or with control points for the Georeferencer.\n\nImages without a position are left out, and so are likely "
        "positions and positions of “Published method”, which have no heading. The original images are not changed."
    )

    POSITIONS = "POSITIONS"
    FORMAT = "FORMAT"
    FOOTPRINTS = "FOOTPRINTS"
    MATCHES = "MATCHES"
    IMAGE_COUNT = "IMAGE_COUNT"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterFeatureSource(self.POSITIONS, "Positions", types=[SOURCE_POINT]),
                "Positions layer of “Localize images”, with all its columns.",
            ),
            with_help(
                QgsProcessingParameterEnum(
                    self.FORMAT,
                    "Format",
                    options=(
                        tr("GeoTIFF"),
                        tr("World file"),
                        tr("Control points (.points)"),
                        tr("Mosaic (one GeoTIFF)"),
                    ),
                    defaultValue=GEOTIFF,
                ),
                "GeoTIFF: the image is rotated to north up, with transparent borders. World file: a copy of the "
                "image with unchanged pixels, a world file and the CRS. Control points: a copy of the image and a "
                ".points file, which the Georeferencer opens with it. Mosaic: all images in one GeoTIFF, for example "
                "to train a model.",
            ),
            with_help(
                QgsProcessingParameterFeatureSource(
                    self.FOOTPRINTS, "Footprints", types=[SOURCE_POLYGON], optional=True
                ),
                "Footprints layer of the same run. Needed for images that were taken with a tilted camera.",
            ),
            with_help(
                QgsProcessingParameterFeatureSource(self.MATCHES, "Matches", types=[SOURCE_POINT], optional=True),
                "Matches layer of the same run. The matching landmarks become control points with their "
                "residuals. Without it, with fewer than four landmarks or with map correlation, the corners, "
                "edges and center of the footprint become control points.",
            ),
            with_help(
                QgsProcessingParameterMultipleLayers(self.IMAGES, "Images", layerType=SOURCE_FILE, optional=True),
                "The images or their folder. Needed if the images are not in the folder of the positions layer.",
                advanced=True,
            ),
            parameters.resolution("Pixel size of the mosaic. If not set, the median of the images."),
            with_help(
                QgsProcessingParameterFolderDestination(self.OUTPUT, "Folder for georeferenced images"),
                "A new or empty folder.",
            ),
            QgsProcessingOutputNumber(self.IMAGE_COUNT, "Number of images"),
        )

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ..layers.positions import read_matches, read_positions

        positions = values.source(self.POSITIONS)
        found = read_positions(positions, values.source(self.FOOTPRINTS))
        placed = [image for image in found if image.has_place]
        points = read_matches(values.source(self.MATCHES), positions, placed)
        file_of, crs_wkt = self._files(values), wkt_for_gdal(positions.sourceCrs())
        kind, written = values.choice(self.FORMAT), 0
        names = unique_names([image.path for image in placed], ".tif" if kind == GEOTIFF else "")
        mosaic: list[tuple[str, np.ndarray]] = []
        write = partial(_add, mosaic) if kind == MOSAIC else partial(_write, kind)
        with outputs.folder(self.OUTPUT) as folder:
            for n, image in enumerate(found):
                check_canceled(feedback)
                name = legible(os.path.basename(image.path))
                feedback.setProgressText(name)
                refusal = _why_not(image)
                if not refusal:
                    target = str(Path(folder) / names[image.path])
                    arguments = image, target, crs_wkt, points.get(image.path, []), feedback
                    try:
                        cancelable(write, file_of(image.path), *arguments, feedback=feedback)
                        written += 1
                    except UnwritableError:
                        # An error of one image must not stop the others; a full disk must.
                        check_canceled(feedback)
                        raise
                    except SemRefError as error:
                        check_canceled(feedback)
                        refusal = worded(error)
                if refusal:
                    feedback.pushWarning(tr("{image} was left out. {reason}").format(image=name, reason=refusal))
                feedback.setProgress((50 if kind == MOSAIC else 100) * (n + 1) / len(found))
            if mosaic:
                feedback.setProgressText(MOSAIC_FILE)
                resolution_cm = values.optional_number(self.RESOLUTION)
                sizes = [image.pixel_size for image in placed]
                pixel_m = median(sizes) if resolution_cm is None else resolution_cm / 100
                write_mosaic = partial(_write_mosaic, mosaic, str(Path(folder) / MOSAIC_FILE), crs_wkt, pixel_m)
                cancelable(write_mosaic, feedback, feedback=feedback)
        text = tr("{written} of {images} images are georeferenced.")
        feedback.pushInfo(text.format(written=written, images=len(found)))
        return {self.IMAGE_COUNT: written}

    def _files(self, values: Values) -> Callable[[str], str]:
        """Return a function from the path in a row to its file; it raises ImageError for files elsewhere."""
        from ...storage.rasters import image_files
        from ..layers.positions import folder_of

        chosen = image_files(values.files(self.IMAGES))
        by_name = {**{os.path.basename(path): path for path in chosen}, **{path: path for path in chosen}}
        folder = folder_of(values.vector(self.POSITIONS))

        def file_of(path: str) -> str:
            found = by_name.get(path) or by_name.get(os.path.basename(path))
            # A temporary layer is from this session: the user chose its images.
            found = found or (path if folder is None else named_file(path, [folder]))
            if not found:
                raise ImageError(
                    "The positions layer contains {path}, which is not in the folder of the layer. Select the image "
                    "or its folder as “Images”.",
                    path=path,
                )
            return found

        return file_of


def _why_not(image: PositionRow) -> str:
    """Return why an image cannot be georeferenced; empty if it can."""
    if image.position is None:
        return tr("It has no position.")
    if image.status == Status.LIKELY:
        return tr("Its position is only likely. To use it, localize with a larger “Maximum error probability”.")
    if not image.has_place:
        return tr("Its position has no heading and pixel size, because it was computed by “Published method”.")
    if image.was_leveled and image.ground is None:
        return tr("The camera was tilted. Select the footprints layer of the same run as well.")
    return ""


def _corners(file: str, image: PositionRow) -> np.ndarray:
    """Return the corners of an image on the ground. Raises ImageError."""
    from ...storage.rasters import open_raster

    if not os.path.isfile(file):
        raise ImageError(
            "The image {path} does not exist. Select the folder that contains it now as “Images”.", path=file
        )
    raster = open_raster(file)
    return image.corners((raster.RasterYSize, raster.RasterXSize))


def _add(mosaic: list[tuple[str, np.ndarray]], file: str, image: PositionRow, *_: object) -> None:
    """Add one image to those of the mosaic. Raises ImageError."""
    from ...storage.rasters import open_raster

    corners = _corners(file, image)
    if mosaic and open_raster(file).RasterCount != open_raster(mosaic[0][0]).RasterCount:
        raise ImageError("{path} has other bands than the first image of the mosaic.", path=file)
    mosaic.append((file, corners))


def _write_mosaic(
    mosaic: list[tuple[str, np.ndarray]], target: str, crs_wkt: str, pixel_m: float, feedback: QgsProcessingFeedback
) -> None:
    from ...storage.georeferencing import write_mosaic

    def going_on(share: float) -> bool:
        feedback.setProgress(50 + 50 * share)
        return not feedback.isCanceled()

    try:
        write_mosaic(mosaic, target, crs_wkt, pixel_m, going_on)
    except UnwritableError:
        check_canceled(feedback)
        raise


def _write(
    kind: int,
    file: str,
    image: PositionRow,
    target: str,
    crs_wkt: str,
    points: list[ControlPoint],
    feedback: QgsProcessingFeedback,
) -> None:
    """Write one image in a format other than the mosaic. Raises SemRefError."""
    from ...storage.georeferencing import corner_points, write_geotiff, write_points, write_world_file
    from ...storage.rasters import require_whole_raster

    corners = _corners(file, image)
    if kind == GEOTIFF:
        write_geotiff(file, target, crs_wkt, corners, lambda: not feedback.isCanceled())
    elif kind == WORLD_FILE:
        write_world_file(file, target, crs_wkt, corners)
    else:
        is_by_landmarks = len(points) >= LEAST_MATCHES and not image.is_by_areas
        write_points(file, target, crs_wkt, points if is_by_landmarks else corner_points(file, corners))
    require_whole_raster(target, os.path.basename(target))
