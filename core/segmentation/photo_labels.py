"""The one road from a photo to its label image: for QGIS, the command line on board and the tools."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ..labels.image_source import ImageSource
from .model import SegmentationModel
from .resampling import at_resolution
from .tiling import nearest_labels, segment


class PhotoLabels:
    """A photo's labels on its own pixels, seen by the network at its own resolution.

    Iterate ``steps()``, then take ``labels_hw``. ``image`` is the photo as the network sees it.
    """

    def __init__(
        self,
        model: SegmentationModel,
        photo: ImageSource,
        values: Sequence[int],
        pixel_size_m: tuple[float, float] | None = None,
    ) -> None:
        """Nothing is read yet.

        Args:
            model: The network.
            photo: The photo.
            values: (C,) class value of each of the model's channels.
            pixel_size_m: Ground meters along a row and along a column of a pixel; None where the photo doesn't say.

        Raises:
            ImageError: Nothing is left of the photo at the model's resolution.
        """
        self._model = model
        self._shape_hw = photo.shape_hw
        self._values = values
        self.image = at_resolution(photo, pixel_size_m, model.settings.resolution_m)
        self.labels_hw = np.empty((0, 0), np.uint8)

    def steps(self) -> Iterator[float]:
        """Yields the share done (0…1) tile by tile; raises what ``tiling.segment`` raises."""
        found = []
        for share, rows in segment(self._model, self.image, self._values, self._model.settings.overlap):
            found += [] if rows is None else [rows.labels_hw]
            yield share
        self.labels_hw = nearest_labels(np.concatenate(found), self._shape_hw)

    def found(self) -> np.ndarray:
        """(H, W) uint8 labels, for who needn't follow the steps."""
        for _ in self.steps():
            continue
        return self.labels_hw
