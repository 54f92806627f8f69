"""Make the metadata of a trained model (docs/reference/file_formats.md)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .metrics import intersection_over_union, rates
from .tiles import TileClass


def entries(
    classes: Sequence[TileClass],
    standardization: tuple[np.ndarray, np.ndarray],
    tile_size: int,
    overlap: int,
    pixel_size: float | None,
    architecture: dict,
    validation: tuple[np.ndarray, np.ndarray] | None = None,
    ground: dict | None = None,
    card: dict | None = None,
) -> dict:
    """Return metadata by key: the keys of the Deepness plugin, and SemRef's own.

    Args:
        classes: One class for each output channel.
        standardization: Mean and deviation (3,) of red, green and blue in 0…1.
        tile_size: Edge in pixels.
        overlap: Percent of a tile.
        pixel_size: In m; None to omit the resolution.
        architecture: Encoder and depth, for further training.
        validation: (L, K) pixels of each label and predicted class on validation tiles, and the classes that each
            label allows (partial.py).
        card: Data of the model card (docs/reference/file_formats.md#model-card).
    """
    mean, deviation = standardization
    found: dict = {
        "model_type": "Segmentor",
        "class_names": {str(i): c.name for i, c in enumerate(classes)},
        "class_values": {str(i): c.value for i, c in enumerate(classes)},
        "class_colors": {str(i): c.color for i, c in enumerate(classes)},
        "class_roles": {str(i): c.role for i, c in enumerate(classes)},
        "tile_size": tile_size,
        "tiles_overlap": overlap,
        "standardization_mean": [round(float(m), 6) for m in mean],
        "standardization_std": [round(float(d), 6) for d in deviation],
        "architecture": architecture,
    }
    if pixel_size:
        found["resolution"] = round(100 * pixel_size, 3)
    if validation is not None and validation[0].any():
        confusion, allowed = validation
        iou = intersection_over_union(confusion, allowed)
        found["validation_iou"] = {c.name: round(float(v), 4) for c, v in zip(classes, iou) if np.isfinite(v)}
        shares = rates(confusion[: len(classes)])
        found["validation_confusion"] = [[round(float(v), 4) for v in row] for row in shares]
    if ground:
        found["training_ground"] = ground
    if card:
        found["model_card"] = card
    return found
