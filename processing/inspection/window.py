"""One window of a database: the rays of its vector, similar windows, and the comparison with an image."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot

import numpy as np

from ...core.database.look_alikes import describe_window, vector_rows, window_at
from ...core.database.model import ReferenceDatabase
from ...core.labels.class_table import ClassTable
from ...core.windows.topology_vector import vector_confidence, vector_distances


@dataclass(frozen=True)
class Ray:
    """One landmark of a topology vector.

    Attributes:
        color: '#rrggbb' of its class.
        length: Distance from the center over the largest distance, 0–1.
        step: Angle to the next landmark over the largest angle, 0–1.
        turn: Angle clockwise from the first, farthest landmark, radians.
        angle_deg: Angle to the next landmark, degrees.
    """

    class_name: str
    color: str
    length: float
    step: float
    turn: float
    angle_deg: float


@dataclass(frozen=True)
class LookAlike:
    """A window with a similar vector: ``distance`` of the vectors, ``center_xy`` and ``size`` in map units."""

    index: int
    name: str
    distance: float
    center_xy: tuple[float, float]
    size: float


@dataclass(frozen=True)
class InspectedWindow:
    """A window for display.

    Attributes:
        name: First column and row.
        center_xy: Map coordinates.
        size: Edge length, map units.
        vector: (3·X,) float32; None with fewer than three landmarks.
        rays: Rays of its vector, the farthest landmark first.
        ends_xy: Map coordinates of the rays' landmarks.
        look_alikes: Similar windows, the nearest vector first.
    """

    index: int
    name: str
    center_xy: tuple[float, float]
    size: float
    landmark_count: int
    vector: np.ndarray | None
    rays: tuple[Ray, ...]
    ends_xy: tuple[tuple[float, float], ...]
    look_alikes: tuple[LookAlike, ...]

    @property
    def distances(self) -> tuple[float, ...]:
        """Distances of the rays' landmarks from the center, map units."""
        x, y = self.center_xy
        return tuple(hypot(end_x - x, end_y - y) for end_x, end_y in self.ends_xy)


@dataclass(frozen=True)
class Comparison:
    """The comparison of an image's vector with a window's.

    Attributes:
        confidence: Confidence of the published method for this distance.
        apart: Largest difference of the elements of each ray of the window.
    """

    distance: float
    confidence: float
    rays: tuple[Ray, ...]
    apart: tuple[float, ...]


def find_window(database: ReferenceDatabase, name: str) -> int | None:
    """Return the index of the window with this name; None without one."""
    found = np.flatnonzero(database.windows.names == name)
    return int(found[0]) if len(found) else None


def window_at_point(database: ReferenceDatabase, x: float, y: float) -> int | None:
    """Return the index of the smallest window around map (x, y), then with the nearest center; None without one."""
    index = window_at(database.windows, x, y)
    return None if index < 0 else index


def inspect_window(database: ReferenceDatabase, index: int) -> InspectedWindow:
    windows, found = database.windows, describe_window(database, index)
    vector = windows.vectors[index] if windows.described[index] else None
    look_alikes = tuple(
        look_alike(database, int(n), float(distance)) for n, distance in zip(found.look_alikes, found.distances)
    )
    return InspectedWindow(
        index,
        str(windows.names[index]),
        _center(database, index),
        float(windows.sizes[index]),
        int(windows.counts[index]),
        vector,
        () if vector is None else rays_of(vector, database.class_table),
        tuple(map(tuple, database.references.positions[found.objects].tolist())),
        look_alikes,
    )


def look_alike(database: ReferenceDatabase, index: int, distance: float) -> LookAlike:
    """Describe a window with a vector that differs by ``distance`` from the displayed one."""
    windows = database.windows
    return LookAlike(index, str(windows.names[index]), distance, _center(database, index), float(windows.sizes[index]))


def compare(window: InspectedWindow, vector: np.ndarray, table: ClassTable) -> Comparison | None:
    """Compare an image's vector with a window's; None if one is missing, or they differ in length."""
    if window.vector is None or len(vector) != len(window.vector):
        return None
    distance = float(vector_distances(vector, window.vector[None])[0])
    apart = np.abs(np.reshape(vector, (3, -1)) - np.reshape(window.vector, (3, -1))).max(axis=0)
    return Comparison(
        distance, vector_confidence(distance), rays_of(vector, table), tuple(apart[: len(window.rays)].tolist())
    )


def rays_of(vector: np.ndarray, table: ClassTable) -> tuple[Ray, ...]:
    """Return the rays of a (3·X,) vector. Its steps are relative to the largest one: together they are a whole turn."""
    classes = table.references
    lengths, steps, ranks = vector_rows(vector)
    total = max(float(steps.sum()), np.finfo(np.float32).tiny)
    turns = 2 * np.pi * (np.cumsum(steps) - steps) / total
    rays = []
    for length, step, turn, rank in zip(lengths.tolist(), steps.tolist(), turns.tolist(), ranks.tolist()):
        entry = classes[min(max(round(rank * len(classes)), 1), len(classes)) - 1]
        rays.append(Ray(entry.name, entry.color, length, step, turn, 360 * step / total))
    return tuple(rays)


def _center(database: ReferenceDatabase, index: int) -> tuple[float, float]:
    return tuple(database.windows.centers[index].tolist())
