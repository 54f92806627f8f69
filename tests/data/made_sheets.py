"""Settings of a database of one sheet of a label map in memory, which is written beside it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from made_inputs import NORTH, WEST, write_raster

NAMES = ["unlabeled", "building", "water", "bare_land", "field"]


def sheet_settings(folder: Path | str, name: str, labels: np.ndarray, box: tuple[int, int, int, int]) -> dict:
    """What semref:builddatabase is given for a box of the labels: first column and row, last column and row + 1."""
    left, top, right, bottom = box
    transform = (WEST + left, 1.0, 0.0, NORTH - top, 0.0, -1.0)
    piece = np.ascontiguousarray(labels[top:bottom, left:right])
    return {
        "LABELS": str(write_raster(Path(folder) / f"{name}.tif", piece, transform=transform, names=NAMES)),
        "REFERENCE_CLASSES": "building;water;bare_land",
        "MINIMUM_AREA": 30,
        "DATABASE": str(Path(folder) / f"{name}.gpkg"),
    }
