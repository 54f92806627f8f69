"""Poses as rows: meters east and north of the map's upper left corner, heading in radians, ln pixel size."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..correlation.refine import ScoredPose
from ..localization import Place


def turns_of(states: np.ndarray) -> np.ndarray:
    """Return (n,) complex turns of states."""
    return np.exp(states[:, 3] - 1j * states[:, 2])


def as_poses(states: np.ndarray) -> list[ScoredPose]:
    """Return states as poses of map correlation."""
    return [
        ScoredPose(float(x), float(-y), float(np.degrees(heading) % 360), float(np.exp(size)))
        for x, y, heading, size in states
    ]


def as_states(poses: Sequence[ScoredPose]) -> np.ndarray:
    """Return (n, 4) states of poses."""
    rows = [(pose.x, -pose.y, np.radians(pose.heading_deg), np.log(pose.pixel_size_m)) for pose in poses]
    return np.array(rows, np.float64).reshape(-1, 4)


def state_of(place: Place, origin: tuple[float, float]) -> np.ndarray:
    """Return the (4,) state of a place with heading and pixel size."""
    heading_deg, size = place.oriented
    x, y = np.subtract(place.position, origin)
    return np.array([x, y, np.radians(heading_deg), np.log(size)])


def wrap_angle(difference: np.ndarray) -> np.ndarray:
    """Return angles in radians from −π to π."""
    return (difference + np.pi) % (2 * np.pi) - np.pi


def place_of(state: np.ndarray, origin: tuple[float, float]) -> Place:
    """Return a state as a place on the map."""
    x, y, heading, size = (float(value) for value in state)
    return Place((origin[0] + x, origin[1] + y), float(np.degrees(heading) % 360), float(np.exp(size)))
