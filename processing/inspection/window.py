"""One window of a database: its vector ray by ray, what looks like it elsewhere, and an image compared with it."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ...core.database.model import ReferenceDatabase
    from ...core.labels.class_table import ClassTable


@dataclass(frozen=True)
class Ray:
    """One landmark of a topology vector.

    Attributes:
        color: '#rrggbb' of its class.
        length: Distance from the center over the largest distance, 0–1.
        step: Angle to the next landmark over the largest angle, 0–1.
        turn: Radians clockwise from the first, farthest landmark.
        angle_deg: To the next landmark, degrees.
    """

    class_name: str
    color: str
    length: float
    step: float
    turn: float
    angle_deg: float


@dataclass(frozen=True)
class LookAlike:
    """A window with a similar vector; ``distance`` of it, ``center_xy`` in map coordinates, ``size`` in map units."""

    index: int
    name: str
    distance: float
    center_xy: tuple[float, float]
    size: float


@dataclass(frozen=True)
class InspectedWindow:
    """A window, as it is shown.

    Attributes:
        index: Among the database's windows.
        name: First column and row.
        center_xy: Map coordinates.
        size: Edge, map units.
        landmark_count: Of all that lie in it.
        vector: (3·X,) float32; None with fewer than three landmarks.
        rays: Of its vector, the farthest landmark first.
        ends_xy: Map coordinates of the rays' landmarks.
        look_alikes: Nearest vector first.
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
        """Of the rays' landmarks from the center, map units."""
        x, y = self.center_xy
        return tuple(hypot(end_x - x, end_y - y) for end_x, end_y in self.ends_xy)


@dataclass(frozen=True)
class Comparison:
    """An image's vector beside a window's.

    Attributes:
        distance: Of the two vectors.
        confidence: That the published method gives for it.
        rays: Of the image's vector.
        apart: By how much the elements of each of the window's rays differ at most.
    """

    distance: float
    confidence: float
    rays: tuple[Ray, ...]
    apart: tuple[float, ...]


def find_window(database: ReferenceDatabase, name: str) -> int | None:
    """Index of the window of this name, None where there is none."""
    found = np.flatnonzero(database.windows.names == name)
    return int(found[0]) if len(found) else None


def window_at_point(database: ReferenceDatabase, x: float, y: float) -> int | None:
    """Index of the smallest window around map (x, y), of several the one with the nearest center; None without one."""
    from ...core.database.look_alikes import window_at

    index = window_at(database.windows, x, y)
    return None if index < 0 else index


def inspect_window(database: ReferenceDatabase, index: int) -> InspectedWindow:
    """Describes one window of a database."""
    from ...core.database.look_alikes import describe_window

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
    """Describe a window whose vector differs by ``distance`` from the one that is shown."""
    windows = database.windows
    return LookAlike(index, str(windows.names[index]), distance, _center(database, index), float(windows.sizes[index]))


def compare(window: InspectedWindow, vector: np.ndarray, table: ClassTable) -> Comparison | None:
    """Compares an image's vector with a window's; None where one of them has none, or they differ in length."""
    from ...core.windows.topology_vector import vector_confidence, vector_distances

    if window.vector is None or len(vector) != len(window.vector):
        return None
    distance = float(vector_distances(vector, window.vector[None])[0])
    apart = np.abs(np.reshape(vector, (3, -1)) - np.reshape(window.vector, (3, -1))).max(axis=0)
    return Comparison(
        distance, vector_confidence(distance), rays_of(vector, table), tuple(apart[: len(window.rays)].tolist())
    )


def rays_of(vector: np.ndarray, table: ClassTable) -> tuple[Ray, ...]:
    """The rays of a (3·X,) vector. The steps are known but for their largest: they sum up to a whole turn."""
    from ...core.database.look_alikes import vector_rows

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
