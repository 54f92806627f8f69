"""Checks of every database from any file: positions on the map, sizes, classes and counts."""

from __future__ import annotations

import numpy as np

from .. import limits
from ..labels.class_table import ClassTable
from .model import MapLandmarks, Windows
from .parameters import BuildParameters

_OFF_MAP_PX = 1.0
"""Pixels by which rounding may move a landmark beyond the map's edge."""


def require_sound(windows: Windows, landmarks: MapLandmarks, parameters: BuildParameters, table: ClassTable) -> None:
    """Raise ValueError for a database that SemRef can't have built.

    Args:
        parameters: Checked before.
    """
    _require_sound_windows(windows, parameters)
    _require_sound_landmarks(landmarks, parameters, table)


def _require_sound_windows(windows: Windows, parameters: BuildParameters) -> None:
    if len(windows) > limits.WINDOWS:
        raise ValueError(f"it has {len(windows)} windows")
    _require_on_map(windows.centers, "a window", parameters)
    _require(
        (windows.levels >= 1) & (windows.levels <= len(parameters.levels)), "a window has a level that does not exist"
    )
    _require(
        (windows.counts >= 0) & (windows.counts < limits.COUNTED), "a window has an impossible number of landmarks"
    )
    width, height = parameters.map_width_px, parameters.map_height_px
    _require(
        (windows.sizes > 0) & (windows.sizes < (min(width, height) + 1) * parameters.pixel_size),
        "a window has an impossible size",
    )
    _require(np.abs(windows.vectors) < limits.VECTOR_ELEMENT, "a vector has values that are not valid numbers")
    if windows.distinctiveness is not None:
        found = windows.distinctiveness[~np.isnan(windows.distinctiveness)]
        _require((found >= 0) & (found < np.inf), "a window has an impossible distinctiveness")


def _require_sound_landmarks(landmarks: MapLandmarks, parameters: BuildParameters, table: ClassTable) -> None:
    if len(landmarks) > limits.LANDMARKS:
        raise ValueError(f"it has {len(landmarks)} landmarks")
    _require_on_map(landmarks.positions, "a landmark", parameters)
    _require((landmarks.areas_m2 > 0) & (landmarks.areas_m2 < limits.AREA_M2), "a landmark has an impossible area")
    _require(np.isin(landmarks.classes, table.reference_values), "a landmark has a class that is not a reference class")


def _require_on_map(places_xy: np.ndarray, what: str, parameters: BuildParameters) -> None:
    """Raise ValueError unless all (N, 2) points are on the label map; NaN is not."""
    x_min, y_min, x_max, y_max = parameters.extent
    slack = _OFF_MAP_PX * parameters.pixel_size
    lowest, highest = np.array([x_min - slack, y_min - slack]), np.array([x_max + slack, y_max + slack])
    inside = ((places_xy >= lowest) & (places_xy <= highest)).all(axis=1)
    if not inside.all():
        x, y = places_xy[np.argmin(inside)].tolist()
        raise ValueError(f"{what} at {x:g}, {y:g} is outside the map")


def _require(holds: np.ndarray, otherwise: str) -> None:
    if not holds.all():
        raise ValueError(otherwise)
