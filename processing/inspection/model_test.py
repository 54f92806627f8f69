"""Test picture of a model: the middle of an image beside its labels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...core.labels.image_source import ImagePart
from ...core.segmentation.devices import CPU
from ...core.segmentation.network_facts import NetworkFacts
from ..jobs.photo_labels import open_model, open_photo_file
from ..threads import worker_threads

if TYPE_CHECKING:
    import numpy as np

EDGE_PX = 512
"""Largest edge of the test picture, at the resolution of the network: one tile."""

NO_CLASS, NO_CLASS_GRAY = "#bdbdbd", 0xBD


@dataclass(frozen=True)
class ModelTest:
    """A test picture.

    Attributes:
        pixels_hw3: (H, W, 3) uint8, red first.
        labels_hw3: (H, W, 3) uint8, its labels in the colors of the classes.
        classes: (name, color, share of the pixels) of each class; the name is empty for pixels without a class.
    """

    pixels_hw3: np.ndarray
    labels_hw3: np.ndarray
    classes: tuple[tuple[str, str, float], ...]


def look_at_network(path: str) -> tuple[int, NetworkFacts]:
    """Return the number of outputs of an ONNX file, and what its metadata state. Raises SemRefError."""
    from ...core.segmentation.foreign_network import stated_facts
    from ...core.segmentation.network import OnnxNetwork

    network = OnnxNetwork(path, worker_threads(), CPU.key)
    return network.channels, stated_facts(network)


def labels_of_picture(model_path: str, image_path: str) -> ModelTest:
    """Label the middle of an image with a model. Raises SemRefError."""
    import numpy as np

    from ...core.segmentation.photo_labels import PhotoLabels

    model, photo = open_model(model_path), open_photo_file(image_path)
    resolution_m = model.settings.resolution_m or 1.0
    enlarged = [1.0, 1.0] if photo.pixel_size_m is None else [resolution_m / size for size in photo.pixel_size_m[::-1]]
    shape_hw = photo.image.shape_hw
    height, width = (max(1, min(size, round(EDGE_PX * factor))) for size, factor in zip(shape_hw, enlarged))
    row, column = (shape_hw[0] - height) // 2, (shape_hw[1] - width) // 2
    part = ImagePart(photo.image, column, row, (height, width))
    labels = PhotoLabels(model, part, model.classes.values, photo.pixel_size_m)
    found = labels.found()
    pixels, _ = part.read(0, 0, width, height)
    counts = np.bincount(found.ravel(), minlength=256)
    palette = np.full((256, 3), NO_CLASS_GRAY, np.uint8)
    for one in model.classes.table:
        palette[one.value] = one.rgb
    shown = [(one.name, one.color, one.value) for one in model.classes.table]
    shown += [("", NO_CLASS, 0)] if counts[0] else []
    classes = tuple((name, color, float(counts[value] / found.size)) for name, color, value in shown)
    return ModelTest(pixels, palette[found], classes)
