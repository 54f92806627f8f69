"""Databases of neighboring or overlapping ground as one: what each tells where another one knows it better.

All functions take the parts from the oldest to the newest. The rules stand in docs/method.md#databases-in-parts.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Sequence
from dataclasses import astuple, fields, replace
from typing import TypeVar

import numpy as np

from ..errors import DatabaseError
from ..sentences.sentence import Sentence
from .model import MapLandmarks, ReferenceDatabase, Windows
from .parameters import BuildParameters

NamedParameters = tuple[str, BuildParameters]
"""What a part is called in what is said, and what it was built with."""

_Rows = TypeVar("_Rows", Windows, MapLandmarks)

_SAME_LENGTH = 1e-9
"""Share by which lengths that went through a file may differ."""

_OFF_PIXELS = 1e-3
"""Pixels by which rounding of large map coordinates may move a part at most."""

_MOST_OVERVIEW = 1 << 31
"""Pixels of a common overview: all of it is held in memory."""

_SETTINGS = {
    name: Sentence(f"database.setting_{name}")
    for name in ("window_size", "stride", "levels", "references_per_vector", "minimum_area", "overview_factor")
}
"""What all parts must have been built with alike."""


def joined_parameters(parts: Sequence[NamedParameters]) -> BuildParameters:
    """What the map of all parts together would be built with: the smallest rectangle that holds them.

    Args:
        parts: In one CRS, at least one.

    Raises:
        DatabaseError: They were built differently, or don't lie on one grid.
    """
    (first, known), newest = parts[0], parts[-1][1]
    for name, own in parts[1:]:
        _require_alike(name, own, first, known)
    pixel = known.pixel_size
    corners = np.array([own.frame.origin for _, own in parts])
    # To the last bit those of a part, as the map of all would have them.
    left, top = float(corners[:, 0].min()), float(corners[:, 1].max())
    first_px = (corners - (left, top)) / (pixel, -pixel)
    _require_on_grid(parts, first_px, known.overview_factor)
    sizes = np.array([(own.map_width_px, own.map_height_px) for _, own in parts])
    width, height = (np.rint(first_px).astype(np.int64) + sizes).max(axis=0).tolist()
    if (width // known.overview_factor) * (height // known.overview_factor) > _MOST_OVERVIEW:
        raise DatabaseError("database.parts_too_far", width=width, height=height)
    return replace(
        known,
        geotransform=(left, pixel, 0.0, top, 0.0, -pixel),
        map_width_px=width,
        map_height_px=height,
        map_hash=hashlib.sha256("".join(repr(astuple(own)) for _, own in parts).encode()).hexdigest(),
        plugin_version=newest.plugin_version,
        block_hashes=(),
        map_accuracy=max(own.map_accuracy for _, own in parts),
    )


def joined_database(parts: Sequence[ReferenceDatabase], source: str | None) -> ReferenceDatabase:
    """All parts as one database, without its overview and without the windows' distinctiveness.

    Where parts built from one map overlap by more than their landmarks are long, the landmarks are those of the
    database of the whole map, in its order.

    Args:
        parts: In one CRS, at least one, with their sources and the bounds of their landmarks.
        source: What all are read from.

    Raises:
        DatabaseError: They don't belong together.
    """
    first, named = parts[0], [(part.source or "", part.parameters) for part in parts]
    for (name, parameters), part in zip(named, parts):
        if part.class_table.digest() != first.class_table.digest():
            raise DatabaseError("database.parts_other_classes", source=name, other=first.source)
        if part.references.bounds_px is None:
            raise DatabaseError("database.parts_without_bounds", source=name, plugin_version=parameters.plugin_version)
    parameters = joined_parameters(named)
    grounds = _grounds([part.parameters for part in parts], parameters)
    windows = _ordered_windows(_stacked(list(_windows(parts, grounds, parameters.pixel_size))))
    landmarks = _ordered_landmarks(_stacked(list(_landmarks(parts, grounds))))
    return ReferenceDatabase(windows, landmarks, parts[-1].class_table, parameters, source)


def joined_overview(
    parts: Sequence[BuildParameters], overviews: Sequence[np.ndarray], parameters: BuildParameters
) -> np.ndarray:
    """(h, w) uint8, 0 where no part is.

    Args:
        parts: What each was built with.
        overviews: Of each.
        parameters: Of ``joined_parameters``.
    """
    factor, found = parameters.overview_factor, np.zeros(parameters.overview_frame.shape_hw, np.uint8)
    first = _grounds(parts, parameters)[:, :2] // factor
    # Last pixels that are not whole blocks of a part give way to whole ones of any other.
    whole = [(own.map_height_px // factor, own.map_width_px // factor) for own in parts]
    for shapes in ([overview.shape for overview in overviews], whole):
        for (column, row), (height, width), overview in zip(first.tolist(), shapes, overviews):
            found[row : row + height, column : column + width] = overview[:height, :width]
    return found


def cut_landmarks(database: ReferenceDatabase, parts: Sequence[BuildParameters]) -> int:
    """How many landmarks of a joined database are pieces that go on in another part, whole in none.

    Args:
        database: Of ``joined_database``.
        parts: What each was built with.
    """
    grounds = _grounds(parts, database.parameters)
    bounds = database.references.required_bounds
    cut = np.zeros(len(bounds), bool)
    for number in range(len(grounds)):
        cut |= _inside(bounds, grounds[number]) & _is_cut(bounds, number, grounds)
    return int((cut & database.references.touches_edge).sum())


def _require_alike(name: str, own: BuildParameters, other: str, known: BuildParameters) -> None:
    if abs(own.pixel_size - known.pixel_size) > _SAME_LENGTH * known.pixel_size:
        raise DatabaseError(
            "database.parts_other_pixel_size",
            source=name,
            pixel_size=own.pixel_size,
            other=other,
            known=known.pixel_size,
        )
    for setting, called in _SETTINGS.items():
        one, two = (np.atleast_1d(getattr(of, setting)) for of in (own, known))
        if one.shape != two.shape or (np.abs(one - two) > _SAME_LENGTH * np.abs(two)).any():
            values = ("; ".join(f"{value:g}" for value in found) for found in (one, two))
            raise DatabaseError(
                "database.parts_other_setting",
                setting=called,
                source=name,
                value=next(values),
                other=other,
                known=next(values),
            )


def _require_on_grid(parts: Sequence[NamedParameters], first_px: np.ndarray, factor: int) -> None:
    away = first_px - first_px[0]
    off = np.abs(away - np.rint(away / factor) * factor).max(axis=1)
    worst = int(off.argmax())
    if off[worst] > _OFF_PIXELS:
        columns, rows = np.abs(away[worst]).tolist()
        raise DatabaseError(
            "database.parts_off_grid",
            source=parts[worst][0],
            other=parts[0][0],
            columns=columns,
            rows=rows,
            factor=factor,
            length=factor * parts[0][1].pixel_size,
        )


def _grounds(parts: Sequence[BuildParameters], parameters: BuildParameters) -> np.ndarray:
    """(K, 4) int64 first column, first row, last column + 1, last row + 1 of each part on the common map."""
    first = parameters.frame.to_pixels(np.array([own.frame.origin for own in parts]))
    first_px = np.rint(first).astype(np.int64)
    return np.column_stack([first_px, first_px + [(own.map_width_px, own.map_height_px) for own in parts]])


def _landmarks(parts: Sequence[ReferenceDatabase], grounds: np.ndarray) -> Iterator[MapLandmarks]:
    """Of each part those that it tells."""
    for number, part in enumerate(parts):
        bounds = part.references.required_bounds + np.tile(grounds[number, :2], 2)
        cut = _is_cut(bounds, number, grounds)
        gone = np.zeros(len(bounds), bool)
        for other in _meeting(number, grounds):
            told = _inside(bounds, grounds[other]) & ~_is_cut(bounds, other, grounds)
            # What is cut gives way to every part that shows its ground whole, what is whole to a newer one alone.
            gone |= told if other > number else told & cut
        yield _chosen(replace(part.references, bounds_px=bounds), ~gone)


def _windows(parts: Sequence[ReferenceDatabase], grounds: np.ndarray, pixel_size: float) -> Iterator[Windows]:
    """Of each part those that no newer part covers."""
    for number, part in enumerate(parts):
        first = part.windows.first_pixels + grounds[number, :2]
        bounds = np.column_stack([first, first + np.rint(part.windows.sizes / pixel_size).astype(np.int64)[:, None]])
        gone = np.zeros(len(bounds), bool)
        for other in _meeting(number, grounds):
            if other > number:
                gone |= _inside(bounds, grounds[other])
        yield _chosen(replace(part.windows, first_pixels=first, distinctiveness=None), ~gone)


def _meeting(number: int, grounds: np.ndarray) -> list[int]:
    """The other parts that a part overlaps or lies beside, corner to corner as well."""
    left, top, right, bottom = grounds[number]
    meets = (grounds[:, 0] <= right) & (grounds[:, 2] >= left) & (grounds[:, 1] <= bottom) & (grounds[:, 3] >= top)
    return [other for other in np.flatnonzero(meets).tolist() if other != number]


def _inside(bounds: np.ndarray, ground: np.ndarray) -> np.ndarray:
    """(N,) bool: which bounds lie in a part's ground."""
    return (bounds[:, :2] >= ground[:2]).all(axis=1) & (bounds[:, 2:] <= ground[2:]).all(axis=1)


def _is_cut(bounds: np.ndarray, number: int, grounds: np.ndarray) -> np.ndarray:
    """(N,) bool: which bounds touch a part's edge where another part goes on, so that a landmark may, too."""
    found = np.zeros(len(bounds), bool)
    for other in _meeting(number, grounds):
        for axis, along in ((0, 1), (1, 0)):
            # Landmarks are 8-connected: one may go on beyond a corner.
            beside = (bounds[:, along] - 1 < grounds[other, along + 2]) & (
                bounds[:, along + 2] + 1 > grounds[other, along]
            )
            first, end = grounds[number, axis], grounds[number, axis + 2]
            if grounds[other, axis] < first <= grounds[other, axis + 2]:
                found |= beside & (bounds[:, axis] <= first)
            if grounds[other, axis] <= end < grounds[other, axis + 2]:
                found |= beside & (bounds[:, axis + 2] >= end)
    return found


def _chosen(items: _Rows, chosen: np.ndarray) -> _Rows:
    """Those of some windows or landmarks that a mask, or an order, picks."""
    arrays = {item.name: getattr(items, item.name) for item in fields(items)}
    return replace(items, **{name: array[chosen] for name, array in arrays.items() if array is not None})


def _stacked(items: Sequence[_Rows]) -> _Rows:
    """Windows, or landmarks, of all parts one after the other."""
    names = [item.name for item in fields(items[0]) if getattr(items[0], item.name) is not None]
    return replace(items[0], **{name: np.concatenate([getattr(one, name) for one in items]) for name in names})


def _ordered_landmarks(landmarks: MapLandmarks) -> MapLandmarks:
    """In the order in which a map's landmarks are found."""
    left, top = landmarks.required_bounds[:, 0], landmarks.required_bounds[:, 1]
    return _chosen(landmarks, np.lexsort((landmarks.positions[:, 0], left, top, landmarks.classes)))


def _ordered_windows(windows: Windows) -> Windows:
    columns, rows = windows.first_pixels.T
    return _chosen(windows, np.lexsort((columns, rows, windows.levels)))
