"""Clip a database to the area that an aircraft needs, accurate to a pixel of the overview."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace
from typing import TypeVar

import cv2
import numpy as np

from ..database.model import MapLandmarks, ReferenceDatabase, Windows
from ..database.parameters import BuildParameters
from ..errors import DatabaseError
from ..labels.class_table import UNLABELED

_SHIFT = 4
"""Corners of an area are rounded to 1/16 of a pixel of the overview."""

_Rows = TypeVar("_Rows", Windows, MapLandmarks)


def area_mask(rings: Sequence[np.ndarray], parameters: BuildParameters) -> np.ndarray:
    """Return (h, w) bool on the overview's grid: pixels of an area.

    Args:
        rings: Outer and inner rings of its polygons, without overlap, (n, 2) map coordinates, on the map or near it.
    """
    frame = parameters.overview_frame
    mask = np.zeros(frame.shape_hw, np.uint8)
    # OpenCV's coordinates begin at the center of the first pixel.
    corners = [frame.to_pixels(ring) - 0.5 for ring in rings]
    cv2.fillPoly(mask, [np.rint(ring * 2**_SHIFT).astype(np.int32) for ring in corners], 1, shift=_SHIFT)
    return mask > 0


def clip_database(database: ReferenceDatabase, mask: np.ndarray) -> ReferenceDatabase:
    """Return the landmarks in an area, the windows centered in it, and the overview without labels outside it.

    Args:
        mask: Of ``area_mask``.

    Raises:
        DatabaseError: The area contains no landmark.
    """
    references, windows = database.references, database.windows
    kept = _in(mask, references.positions, database.parameters)
    if not kept.any():
        raise DatabaseError("The area contains no landmark. Choose another area or a larger distance around it.")
    centered = _in(mask, windows.centers, database.parameters)
    overview = database.overview
    return replace(
        database,
        references=_select(references, kept),
        windows=_select(windows, centered),
        overview=None if overview is None else np.where(mask, overview, np.uint8(UNLABELED)),
    )


def _in(mask: np.ndarray, points_xy: np.ndarray, parameters: BuildParameters) -> np.ndarray:
    """Return (N,) bool: whether the pixel of a point belongs to the area."""
    pixels = parameters.overview_frame.to_pixels(points_xy).astype(np.intp)
    columns, rows = np.clip(pixels, 0, np.array(mask.shape)[::-1] - 1).T
    return mask[rows, columns]


def _select(items: _Rows, chosen: np.ndarray) -> _Rows:
    """Return the windows or landmarks of a mask."""
    arrays = {item.name: getattr(items, item.name) for item in fields(items)}
    return replace(items, **{name: array[chosen] for name, array in arrays.items() if array is not None})
