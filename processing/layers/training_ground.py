"""The ground a network learns from, as QGIS knows it: what image, annotation and the wanted extent share."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date
from pathlib import Path
from typing import Callable

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsFeatureRequest,
    QgsRasterLayer,
    QgsRectangle,
)

from ...core.annotation.classes import ClassLookup
from ...core.errors import ParameterError, TrainingError
from ...core.labels.class_table import UNLABELED, ClassTable
from ...storage.label_maps import RasterFile
from ...storage.rasterize import AreaMask
from ...storage.training_ground import WantedGround, frame_of, is_placed, seen_ground
from ..compat import is_metric, is_null, wkt_for_gdal
from .annotation import AnnotationSource
from .areas import DrawnArea, area_mask
from .layer_inputs import RasterLayer, image_layer
from .reference_systems import describe_crs, metric_crs, transformed_box

Placed = tuple[QgsRectangle, QgsCoordinateReferenceSystem]


def require_common_ground(
    image: QgsRasterLayer,
    name: str,
    extent: QgsRectangle,
    crs: QgsCoordinateReferenceSystem,
    context: QgsCoordinateTransformContext,
) -> None:
    """Raises ParameterError where the image and what is called ``name`` show different ground.

    Where one of them has no CRS they are compared later, by their sizes in pixels.
    """
    if not (image.crs().isValid() and crs.isValid()):
        return
    moved = transformed_box(QgsCoordinateTransform(crs, image.crs(), context), extent)
    if moved.isEmpty() or not moved.intersects(image.extent()):
        raise ParameterError(
            "{image} and {labels} show different ground; choose an image and labels of the same place, and check "
            "their CRS and the extent.",
            image=image.name(),
            labels=name,
        )


def classes_on(
    source: AnnotationSource,
    lookup: ClassLookup,
    parts: Sequence[Placed],
    context: QgsCoordinateTransformContext,
    canceled: Callable[[], bool],
) -> set[int]:
    """Values of the classes that an annotation has within the boxes of ``parts``, of two or more only two."""
    shared = source.extent
    for rectangle, crs in parts:
        moved = _moved(rectangle, QgsCoordinateTransform(crs, source.crs, context))
        shared = shared if moved is None else shared.intersect(moved)
    found: set[int] = set()
    if shared.isEmpty():
        return found
    request = QgsFeatureRequest(source.request)
    request.setFilterRect(shared)
    for feature in source.features.getFeatures(request):
        raw = source.raw_class(feature)
        found |= {None if is_null(raw) else lookup.value(raw)} - {None, UNLABELED}
        if len(found) > 1 or canceled():
            break
    return found


def _moved(rectangle: QgsRectangle, transform: QgsCoordinateTransform) -> QgsRectangle | None:
    """None where the CRS can't tell, such as that of a map of the world, or is unknown."""
    moved = transformed_box(transform, rectangle)
    return moved if transform.isValid() and moved.isFinite() and not moved.isNull() else None


def require_two_classes(counts: Sequence[int] | np.ndarray, table: ClassTable) -> None:
    """Raises TrainingError where labels are of one class alone; what is unlabeled counts as unknown.

    Args:
        counts: (256,) pixels, or features, of each value.
    """
    labeled = [entry.name for entry in table if entry.value and counts[entry.value]]
    if len(labeled) == 1:
        raise TrainingError(
            "Only one class ({name}) is labeled, and ground without a label counts as unknown: there is nothing to "
            "tell apart. Label another class, or let ground without a label be a class of its own.",
            name=labeled[0],
        )


def named_layer(layer: QgsRasterLayer) -> RasterLayer:
    """A layer that is no file yet: it stands for the drawing that will be made of it."""
    return RasterLayer(layer.name(), layer.crs(), ())


def opened(path: str, key: str) -> tuple[RasterLayer, QgsRectangle]:
    """A file that was just drawn, and its extent; for the thread that drew it."""
    layer = QgsRasterLayer(path)
    return image_layer(layer, key), layer.extent()


@dataclass(frozen=True)
class TrainingGround:
    """What is to be seen of an image.

    Attributes:
        layer: The image.
        extent: Of the image, in its CRS.
        name: What the image is called.
        labels: What annotation or label map is called.
        pixel_size: Meters; None for the image's own.
        wanted: What the user wants of it, in the image's CRS; an empty one for all.
        drawn: Where labels may be; None for everywhere.
        context: How this project transforms coordinates.
        area: What alone is learned from; None for all.
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
        """In meters, wherever the image has a CRS at all."""
        crs = self.layer.crs
        if not crs.isValid() or is_metric(crs):
            return crs
        return metric_crs(crs, QgsCoordinateReferenceSystem(), self.extent, self.context)

    def image(self, folder: Path) -> RasterFile:
        """The image as it is learned from; ``folder`` takes what describes it. Raises ParameterError, LabelMapError."""
        crs = self.crs
        changed = wkt_for_gdal(crs) if crs != self.layer.crs else ""
        return seen_ground(self.layer.file, WantedGround(changed, self.pixel_size, self._bounds(crs)), folder)

    def mask(self, image: RasterFile) -> AreaMask | None:
        """The pixels that are learned from of what ``image`` gave; None for all. Raises ParameterError."""
        if self.area is None:
            return None
        if not is_placed(image):
            raise ParameterError("The image has no place on the ground that MASK could be laid on; leave MASK out.")
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
            raise ParameterError(
                "{image} and {labels} show different ground; choose an image and labels of the same place, and check "
                "their CRS and the extent.",
                image=self.name,
                labels=self.labels,
            )
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
                "The layer's extent does not fit its CRS {crs}; correct the CRS or choose TARGET_CRS.",
                crs=describe_crs(own),
            )
        return moved

    def told(self, image: RasterFile) -> dict:
        """What the model's metadata tell of the ground it was trained on."""
        found = {"image": self.name, "labels": self.labels, "date": date.today().isoformat()}
        if not is_placed(image):
            return found
        frame = frame_of(image)
        found |= {"crs": self.crs.authid(), "extent": [round(edge, 3) for edge in frame.extent]}
        return found | ({"pixel_size": round(frame.pixel_size, 6)} if is_metric(self.crs) else {})
