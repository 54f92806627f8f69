"""Label images of photos: what a network sees in them, in the classes of a database."""

from __future__ import annotations

import numpy as np
from qgis.core import QgsProcessingFeedback

from ...core.errors import ImageError, ModelError
from ...core.labels.class_table import ClassTable
from ..algorithms.segment_image import describe
from ..packages.components import ONNXRUNTIME, how_to_install, missing
from ..threads import worker_threads
from .base import check_canceled


class PhotoLabels:
    """Reads photos as label images: ``photo_labels(path)`` gives (H, W) uint8 labels on the photo's own pixels.

    Raises ModelError when the model is unusable or does not know a reference class of ``table``, and Canceled.
    """

    def __init__(self, model_path: str, table: ClassTable, feedback: QgsProcessingFeedback) -> None:
        from ...core.segmentation.model import SegmentationModel

        lacking = missing([ONNXRUNTIME])
        if lacking:
            raise ModelError(how_to_install(lacking))
        self._model = SegmentationModel(model_path, worker_threads())
        self._values = self._model.classes.values_in(table, model_path)
        self._feedback = feedback
        self._is_described = False

    def __call__(self, path: str) -> np.ndarray:
        from ...core.labels.image_files import MAXIMUM_IMAGE_PIXELS
        from ...core.segmentation.tiling import nearest_labels, segment
        from ...storage.images import GdalImage
        from ..exchange.images import resampled_size, stated_crs

        photo = GdalImage(path)
        shape_hw = photo.shape_hw
        if shape_hw[0] * shape_hw[1] > MAXIMUM_IMAGE_PIXELS:
            raise ImageError(
                f"{path} has {shape_hw[1]} × {shape_hw[0]} pixels, more than a query image may have "
                f"({MAXIMUM_IMAGE_PIXELS // 1_000_000} million); cut it to what one photo shows."
            )
        settings = self._model.settings
        size_wh = settings.resolution_m and resampled_size(photo, stated_crs(path), settings.resolution_m)
        if size_wh:
            photo = GdalImage(path, size_wh)
        if not self._is_described:
            describe(self._model, photo, self._feedback)
            self._is_described = True
        found = []
        for _, rows in segment(self._model, photo, self._values, settings.overlap):
            check_canceled(self._feedback)
            found += [] if rows is None else [rows.labels_hw]
        return nearest_labels(np.concatenate(found), shape_hw)
