"""The photo of a raster parameter: a file, a part of it, or another layer that QGIS draws."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransformContext,
    QgsProcessingFeedback,
    QgsProcessingUtils,
    QgsRasterLayer,
    QgsRectangle,
)

from ...core.errors import ImageError, ParameterError
from ..base.algorithm import follow
from ..base.values import Values
from ..translation import tr

if TYPE_CHECKING:
    from ...core.labels.image_source import ImageSource
    from ...storage.images import GdalImage
    from ..layers.areas import DrawnArea
    from ..layers.layer_inputs import RasterLayer


@dataclass(frozen=True)
class SourceImage:
    """An open image.

    Attributes:
        image: The part to use.
        geotransform: GDAL's six numbers of ``image``; None without a georeference.
        crs: CRS of the ground; invalid without one.
    """

    file: GdalImage
    image: ImageSource
    geotransform: tuple[float, ...] | None
    crs: QgsCoordinateReferenceSystem


class PhotoSource:
    """The layer and extent of two parameters, read in the thread of the layers. Raises ImageError.

    ``area``: mask; its extent replaces a missing extent of a layer that must be drawn.
    """

    def __init__(self, values: Values, key: str, extent_key: str, area: DrawnArea | None = None) -> None:
        from ..layers.layer_inputs import raster_layer
        from ..layers.rendering import drawable, needs_drawing

        layer = values.raster(key)
        self._values, self._extent_key, self._area = values, extent_key, area
        self._file: RasterLayer | None = None
        self._layer: QgsRasterLayer | None = None
        if needs_drawing(layer):
            if not values.has(extent_key) and area is None:
                raise ImageError("“{layer}” has no extent of its own. Set an extent.", layer=layer.name())
            self._layer = drawable(layer)
        else:
            self._file = raster_layer(layer)

    def open(self, resolution_m: float | None, feedback: QgsProcessingFeedback) -> SourceImage:
        """Open the photo; draw a layer that is not a file with pixels of that size.

        Raises:
            ImageError: It cannot be read or drawn.
        """
        from ...storage.images import GdalImage

        if self._file is None:
            path, crs = self._draw(resolution_m, feedback)
            file = GdalImage(path)
            return SourceImage(file, file, file.geotransform, crs)
        file, crs = GdalImage(self._file.path), self._file.crs
        if not self._values.has(self._extent_key):
            return SourceImage(file, file, file.geotransform, crs)
        return self._part(file, crs)

    def path(self) -> str:
        """Return the file of the layer. Raises ParameterError if QGIS must draw it, which workers cannot do."""
        if self._file is None:
            raise ParameterError(
                "Workers cannot use this layer, because QGIS draws it. Select a raster file, or leave “Scheduler” "
                "empty."
            )
        return self._file.path

    def file(self, resolution_m: float, feedback: QgsProcessingFeedback) -> str:
        """Return the path of a file with the selected part; a file that was made exists as long as QGIS runs.

        Raises:
            ImageError: It cannot be read or drawn.
        """
        from ...storage.images import GdalImage
        from ...storage.pictures import copy_part

        if self._file is None:
            path, crs = self._draw(resolution_m, feedback)
        elif self._area is None and not self._values.has(self._extent_key):
            return self._file.path
        else:
            window = self._window(GdalImage(self._file.path), self._file.crs)
            path, crs = QgsProcessingUtils.generateTempFilename(f"{_stem(self._file.path)}.tif"), self._file.crs
            copy_part(self._file.path, path, window)
        if self._area is not None:
            self._leave_out(path, crs)
        return path

    def _leave_out(self, path: str, crs: QgsCoordinateReferenceSystem) -> None:
        """Remove everything outside the mask from a file that was made."""
        from ...storage.images import GdalImage
        from ...storage.pictures import keep_only
        from ..layers.areas import area_mask

        file = GdalImage(path)
        mask = area_mask(self._area, crs, file.geotransform, file.shape_hw, self._values.transform_context)
        keep_only(path, mask)

    def _draw(
        self, resolution_m: float | None, feedback: QgsProcessingFeedback
    ) -> tuple[str, QgsCoordinateReferenceSystem]:
        """Draw a layer that is not a file; return (path of a GeoTIFF that exists as long as QGIS runs, its CRS)."""
        if resolution_m is None:
            raise ImageError("“{layer}” has no resolution of its own. Enter a resolution.", layer=self._layer.name())
        return drawn_file(self._layer, self._wanted_extent(), resolution_m, self._values.transform_context, feedback)

    def _wanted_extent(self) -> tuple[QgsRectangle, QgsCoordinateReferenceSystem]:
        if self._area is None or self._values.has(self._extent_key):
            return self._values.extent_as_given(self._extent_key)
        return self._area.extent, self._area.crs

    def apply_mask(self, image: ImageSource, photo: SourceImage, geotransform: Sequence[float] | None) -> ImageSource:
        """Return an image on the photo's ground without everything outside the mask, if there is one.

        Raises:
            ParameterError: No polygon touches the image, or it has no georeference.
        """
        from ...core.labels.image_source import MaskedImage
        from ..layers.areas import area_mask

        if self._area is None:
            return image
        context = self._values.transform_context
        return MaskedImage(image, area_mask(self._area, photo.crs, geotransform, image.shape_hw, context))

    def _part(self, file: GdalImage, crs: QgsCoordinateReferenceSystem) -> SourceImage:
        from ...core.labels.image_source import ImagePart

        left, top, width, height = self._window(file, crs)
        x0, dx, _, y0, _, dy = file.geotransform
        part = ImagePart(file, left, top, (height, width))
        return SourceImage(file, part, (x0 + left * dx, dx, 0.0, y0 + top * dy, 0.0, dy), crs)

    def _window(self, file: GdalImage, crs: QgsCoordinateReferenceSystem) -> tuple[int, int, int, int]:
        """Return (first column, first row, width, height) of the extent or the mask. Raises ImageError."""
        name, transform = self._file.path, file.geotransform
        if transform is None or transform[2] or transform[4] or not crs.isValid():
            raise ImageError(
                "“{image}” has no georeference, or a rotated one, so neither an extent nor a mask can be applied. "
                "Leave both empty.",
                image=name,
            )
        if self._values.has(self._extent_key):
            wanted = self._values.extent(self._extent_key, crs)
        else:
            from ..layers.areas import area_extent

            wanted = area_extent(self._area, crs, self._values.transform_context)
        x0, dx, _, y0, _, dy = transform
        height, width = file.shape_hw
        columns = sorted(((wanted.xMinimum() - x0) / dx, (wanted.xMaximum() - x0) / dx))
        rows = sorted(((wanted.yMinimum() - y0) / dy, (wanted.yMaximum() - y0) / dy))
        (left, right), (top, bottom) = _within(columns, width), _within(rows, height)
        if right <= left or bottom <= top:
            raise ImageError(
                "“{image}” does not overlap the extent or the mask. Set an extent or a mask within the image.",
                image=name,
            )
        return left, top, right - left, bottom - top


def drawn_file(
    layer: QgsRasterLayer,
    ground: tuple[QgsRectangle, QgsCoordinateReferenceSystem],
    resolution_m: float,
    context: QgsCoordinateTransformContext,
    feedback: QgsProcessingFeedback,
) -> tuple[str, QgsCoordinateReferenceSystem]:
    """Draw a layer of ``rendering.drawable``; return a GeoTIFF that exists as long as QGIS runs, and its CRS.

    ``ground``: extent to draw, and its CRS.

    Raises:
        ImageError: It cannot be drawn.
    """
    from ..layers.rendering import draw, plan_drawing

    crs, frame = plan_drawing(layer, *ground, resolution_m, context)
    height, width = frame.shape_hw
    text = tr(
        "Drawing “{layer}” with {width} × {height} pixels of {resolution:g} cm. Check that its provider permits "
        "this use."
    )
    resolution_cm = 100 * resolution_m
    feedback.pushInfo(text.format(layer=layer.name(), width=width, height=height, resolution=resolution_cm))
    path = QgsProcessingUtils.generateTempFilename(f"{_stem(layer.name())}.tif")
    follow(draw(layer, (crs, frame), path, context, feedback.isCanceled), feedback)
    return path, crs


def _stem(name: str) -> str:
    """Return a file name for a layer or a path: letters, digits, “-”, “_” and “.”."""
    stem = os.path.splitext(os.path.basename(name))[0]
    return "".join(letter if letter.isalnum() or letter in "-_." else "_" for letter in stem)[:60] or "layer"


def _within(ends: list[float], length: int) -> tuple[int, int]:
    """Return the first pixel and the one after the last between two positions, on an image of that length."""
    first, last = (min(max(end, -1.0), length + 1.0) for end in ends)
    return max(0, int(first // 1)), min(length, -int(-last // 1))
