"""The training ground in QGIS: the intersection of image, labels and the wanted extent."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date
from pathlib import Path

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsRasterLayer,
    QgsRectangle,
)

from ...core.errors import ParameterError, TrainingError
from ...core.labels.class_table import ClassTable
from ...storage.label_maps import RasterFile
from ...storage.rasterize import AreaMask
from ...storage.training_ground import frame_of, is_placed, prepare_image
from ..compat import is_metric, wkt_for_gdal
from .areas import DrawnArea, area_mask
from .layer_inputs import RasterLayer, raster_layer
from .reference_systems import describe_crs, metric_crs, transformed_box

Placed = tuple[QgsRectangle, QgsCoordinateReferenceSystem]


def require_common_ground(
    image: QgsRasterLayer,
    name: str,
    extent: QgsRectangle,
    crs: QgsCoordinateReferenceSystem,
    context: QgsCoordinateTransformContext,
) -> None:
    """Raise ParameterError if the image and the labels ``name`` do not overlap.

    If one of them has no CRS, their sizes in pixels are compared later.
    """
    if not (image.crs().isValid() and crs.isValid()):
        return
    moved = transformed_box(QgsCoordinateTransform(crs, image.crs(), context), extent)
    if moved.isEmpty() or not moved.intersects(image.extent()):
        raise _no_overlap(image.name(), name)


def _no_overlap(image: str, labels: str) -> ParameterError:
    return ParameterError(
        "{image} and {labels} don't overlap. Choose an image and labels of the same place, and check their CRS and the "
        "extent.",
        image=image,
        labels=labels,
    )


def require_two_classes(counts: Sequence[int] | np.ndarray, table: ClassTable) -> None:
    """Raise TrainingError if only one class is labeled. Unlabeled ground counts as unknown.

    Args:
        counts: (256,) pixels per value.
    """
    labeled = [entry.name for entry in table if entry.value and counts[entry.value]]
    if len(labeled) == 1:
        raise TrainingError(
            "Only one class ({name}) is labeled, and unlabeled ground counts as unknown, so the network can't learn to "
            "distinguish classes. Label another class, or treat unlabeled ground as a class.",
            name=labeled[0],
        )


def named_layer(layer: QgsRasterLayer) -> RasterLayer:
    """Return a placeholder for a layer that will be drawn into a file."""
    return RasterLayer(layer.name(), layer.crs(), ())


def open_drawing(path: str) -> tuple[RasterLayer, QgsRectangle]:
    """Return a drawn file and its extent, in the thread that drew it."""
    layer = QgsRasterLayer(path)
    return raster_layer(layer), layer.extent()


@dataclass(frozen=True)
class TrainingGround:
    """The part of an image for training, and how to resample it.

    Attributes:
        extent: Extent of the image in its CRS.
        labels: Name of the land-cover layer or label map.
        pixel_size: In m; None for the image's own.
        wanted: Extent that the user chose, in the image's CRS; empty for all.
        drawn: Extent of the labels; None for no limit.
        area: Area that training is limited to; None for no limit.
    """

    layer: RasterLayer
    extent: QgsRectangle
    name: str
    labels: str
    pixel_size: float | None
    wanted: QgsRectangle
    drawn: Placed | None
    context: QgsCoordinateTransformContext
    area: DrawnArea | None = None

    @property
    def crs(self) -> QgsCoordinateReferenceSystem:
        """CRS in meters; invalid if the image has no CRS."""
        crs = self.layer.crs
        return metric_crs(crs, QgsCoordinateReferenceSystem(), self.extent, self.context) if crs.isValid() else crs

    def image(self, folder: Path) -> RasterFile:
        """Return the prepared image, with its VRT in ``folder``. Raises SemRefError."""
        if self.drawn is not None:
            # Otherwise an image without georeference does not overlap them, for no reason that the user sees.
            frame_of(self.layer.file)
        if (self.pixel_size or self._parts()) and not is_placed(self.layer.file):
            raise ParameterError(
                "“{image}” has no georeference, so an extent, a resolution and a mask cannot be applied. Leave them "
                "empty.",
                image=self.name,
            )
        crs = self.crs
        changed = wkt_for_gdal(crs) if crs != self.layer.crs else ""
        return prepare_image(self.layer.file, folder, changed, self.pixel_size, self._bounds(crs))

    def mask(self, image: RasterFile) -> AreaMask | None:
        """Return the mask of the training area on the prepared image; None for all. Raises ParameterError."""
        if self.area is None:
            return None
        frame = frame_of(image)
        return area_mask(self.area, self.crs, frame.geotransform, frame.shape_hw, self.context)

    def _bounds(self, crs: QgsCoordinateReferenceSystem) -> tuple[float, float, float, float] | None:
        parts = [self._in(crs, rectangle, own) for rectangle, own in self._parts()]
        if not parts:
            return None
        shared = self._in(crs, self.extent, self.layer.crs)
        for part in parts:
            shared = shared.intersect(part)
        if shared.isEmpty():
            raise _no_overlap(self.name, self.labels)
        return shared.xMinimum(), shared.yMinimum(), shared.xMaximum(), shared.yMaximum()

    def _parts(self) -> list[Placed]:
        parts = [] if self.wanted.isEmpty() else [(self.wanted, self.layer.crs)]
        parts += [] if self.area is None else [(self.area.extent, self.area.crs)]
        return parts + ([] if self.drawn is None else [self.drawn])

    def _in(
        self, crs: QgsCoordinateReferenceSystem, rectangle: QgsRectangle, own: QgsCoordinateReferenceSystem
    ) -> QgsRectangle:
        moved = transformed_box(QgsCoordinateTransform(own, crs, self.context), rectangle)
        if moved.isNull():
            raise ParameterError(
                "The layer's extent does not fit its CRS {crs}. Correct the CRS of the layer, or choose a target CRS.",
                crs=describe_crs(own),
            )
        return moved

    def metadata(self, image: RasterFile) -> dict:
        """Return the entries about the training ground for the model's metadata."""
        found = {"image": self.name, "labels": self.labels, "date": date.today().isoformat()}
        if not is_placed(image):
            return found
        frame = frame_of(image)
        found |= {"crs": self.crs.authid(), "extent": [round(edge, 3) for edge in frame.extent]}
        return found | ({"pixel_size": round(frame.pixel_size, 6)} if is_metric(self.crs) else {})
