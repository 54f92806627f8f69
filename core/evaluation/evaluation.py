"""How well a database localizes: seeded queries with known truth, tried with one method or several.

Queries are cut from a label map around windows of the database, spoilt, and judged against where they were cut.
A query is made from (seed, part, number) alone, so every method sees the same ones and any of them can be repeated.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Iterator, List, Optional, Sequence, Tuple

import numpy as np

from ..database.model import ReferenceDatabase
from ..errors import ParameterError
from ..geometry.frame import MapFrame
from ..geometry.pose import PoseUncertainty
from ..labels.sources import LabelSource
from ..localizer.localizer import FIX, TOPOLOGY_VECTOR, Localization, Localizer
from ..simulation.views import LabelNoise, ObjectNoise, View, cut_view, spoil_label_objects, spoil_labels

MAP, MIRRORED, NOISE, SCALING, ROTATION, OFFSET = PARTS = ("map", "mirrored", "noise", "scaling", "rotation", "offset")
"""Parts of an evaluation: images of the map, mirrored ones that can't be right, the grid of noise, the paper's
Tables 4 and 5, and windows moved step by step."""

SCALES = (2.0, 1.8, 1.5, 1.2, 1.0, 0.8, 0.75, 0.65, 0.6, 0.5)
"""View radius in windows, as in Table 4 of He & Wu 2025."""

ROTATIONS_DEG = tuple(range(0, 360, 30))
"""As in Table 5 of He & Wu 2025."""

OFFSETS = (0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5)
"""Steps by which windows are moved, as shares of the stride."""

CLEAN = dict.fromkeys(("offset", "missed", "invented", "misnamed", "ragged", "rotation"), (0.0, 0.0))
"""Ranges of a query that shows a window as it is, but for its scale."""

NOISE_LEVELS = (0.0, 20.0, 40.0, 60.0)
"""Percent of objects missed, and of objects invented, of the grid of noise."""

TABLE_WINDOWS = 3
"""Windows that are scaled and turned for the two tables."""

LARGEST_IMAGE_PX = 2000
"""Edge of a query; larger windows are shown with larger pixels."""

RIGHT_SHARE = 0.02
"""A position counts as right within this share of the ground's edge, unless told otherwise."""

SMALLEST_AXIS = 1e-6
"""Axes of an ellipse, map units, are taken to be at least so long."""


@dataclass(frozen=True)
class TrialRanges:
    """What a trial draws its values from, each (smallest, largest).

    scale: ground shown, as a multiple of a window's edge (uniform in its logarithm); rotation: heading, degrees;
    offset: of the image's center from the nearest window's, as a share of the stride, the larger of both axes;
    missed, invented, misnamed: percent of the objects; ragged: standard deviation of the edges' displacement, map
    units.
    Raises ParameterError for values that can't be.
    """

    scale: Tuple[float, float] = (0.8, 1.25)
    rotation: Tuple[float, float] = (0.0, 360.0)
    offset: Tuple[float, float] = (0.0, 0.5)
    missed: Tuple[float, float] = (20.0, 20.0)
    invented: Tuple[float, float] = (20.0, 20.0)
    misnamed: Tuple[float, float] = (5.0, 5.0)
    ragged: Tuple[float, float] = (0.0, 1.0)

    def __post_init__(self) -> None:
        limits = {"scale": (0.05, 20.0), "rotation": (-360.0, 360.0), "offset": (0.0, 0.5), "ragged": (0.0, math.inf)}
        for field in fields(self):
            low, high = getattr(self, field.name)
            least, most = limits.get(field.name, (0.0, 100.0))
            if not least <= low <= high <= most:
                raise ParameterError(
                    f"{field.name.upper()} goes from {low:g} to {high:g}; give two numbers from {least:g} to {most:g}, "
                    "the smaller one first."
                )


@dataclass(frozen=True)
class Query:
    """One image to be localized, before it is cut: what it shows and how it is spoilt.

    position: map coordinates of its center; scale: ground shown in windows; offset: share of the stride;
    view: in pixels of the label map; ragged: map units; window: name of the window it was drawn around, which has
    so many ``landmarks`` in the database.
    """

    part: str
    number: int
    window: str
    landmarks: int
    position: Tuple[float, float]
    heading_deg: float
    scale: float
    offset: float
    noise: ObjectNoise
    ragged: float
    view: View


@dataclass(frozen=True)
class Outcome:
    """What came of a query with a method. Without a position errors are None; scale_error is relative.

    right: a fix at the right place (for topology vectors: the window nearest to the image's center);
    window: that was matched, else the window nearest to the position found;
    ellipse_ratio: error in units of the 95 % ellipse, or circle, that was told; at most 1 inside.
    """

    query: Query
    method: str
    result: Localization
    right: bool = False
    error: Optional[float] = None
    heading_error_deg: Optional[float] = None
    scale_error: Optional[float] = None
    ellipse_ratio: Optional[float] = None
    window: Optional[str] = None

    @property
    def is_fix(self) -> bool:
        return self.result.status == FIX


class Evaluation:
    """Plans queries (``trials``, ``noise_grid``, ``moves``, ``tables``) and tries them one by one (``run``)."""

    def __init__(
        self,
        database: ReferenceDatabase,
        source: LabelSource,
        frame: MapFrame,
        ranges: TrialRanges,
        seed: int,
        minimum_references: int = 3,
        right_within: Optional[float] = None,
    ) -> None:
        """source, frame: a label map in the database's CRS and classes, its pixels of any size.

        minimum_references: a window has to have so many for trials to lie around it; right_within: map units,
        None for RIGHT_SHARE of the ground's edge. Raises ParameterError when no window will do.
        """
        self._database = database
        self._source = source
        self._ranges = ranges
        self._seed = seed
        self._right_within = right_within
        self.localizer = Localizer(database)
        self._frame = frame.of_shape(source.shape_hw)
        self._edge = float(database.windows.sizes.min()) if len(database.windows) else 0.0
        self.image_px = min(max(round(self._edge / database.parameters.pixel_size), 1), LARGEST_IMAGE_PX)
        self._windows = self._usable_windows(minimum_references)
        if not len(self._windows):
            raise ParameterError(
                f"No window of the database lies on LABELS and has {minimum_references} landmarks or more; choose the "
                "label map of the same ground, or a smaller MINIMUM_REFERENCES."
            )

    def trials(self, count: int, mirrored: int) -> Iterator[Query]:
        """``count`` queries of the map, then ``mirrored`` mirrored ones."""
        for part, wanted in ((MAP, count), (MIRRORED, mirrored)):
            for number in range(wanted):
                yield self._draw(part, number)

    def noise_grid(self, count: int) -> Iterator[Query]:
        """``count`` queries for each pair of NOISE_LEVELS, missed and invented; the same places for every pair."""
        for missed in NOISE_LEVELS:
            for invented in NOISE_LEVELS:
                for number in range(count):
                    yield self._draw(NOISE, number, {"missed": (missed, missed), "invented": (invented, invented)})

    def moves(self, count: int) -> Iterator[Query]:
        """``count`` windows moved by each of OFFSETS, without noise, neither scaled nor turned."""
        for offset in OFFSETS:
            for number in range(count):
                yield self._draw(OFFSET, number, {**CLEAN, "scale": (1, 1), "offset": (offset, offset)})

    def tables(self) -> Iterator[Query]:
        """The paper's Tables 4 and 5: windows without noise, scaled and turned about their centers."""
        for window in self._table_windows():
            for scale in SCALES:
                yield self._draw(SCALING, 0, {**CLEAN, "scale": (scale, scale)}, window)
            for angle in ROTATIONS_DEG:
                yield self._draw(ROTATION, 0, {**CLEAN, "scale": (1, 1), "rotation": (angle, angle)}, window)

    def image(self, query: Query) -> np.ndarray:
        """(H, W) uint8 labels of a query, spoilt."""
        rng = self._rng(query.part, query.number, 1)
        labels = cut_view(self._source, query.view)
        values = self._database.class_table.reference_values
        pixel_size = self._edge * query.scale / self.image_px
        if query.noise != ObjectNoise():
            smallest = self._database.parameters.minimum_area / pixel_size**2
            labels = spoil_label_objects(labels, query.noise, rng, values, self._donor(query, rng), smallest)
        labels = spoil_labels(labels, LabelNoise(ragged_px=query.ragged / pixel_size), rng, values)
        return np.ascontiguousarray(labels[:, ::-1]) if query.part == MIRRORED else labels

    def run(self, query: Query, methods: Sequence[str]) -> List[Outcome]:
        """The query tried with each of ``methods``, in their order."""
        labels = self.image(query)
        return [self._judge(query, method, self.localizer.localize(labels, method)) for method in methods]

    def _usable_windows(self, minimum_references: int) -> np.ndarray:
        windows = self._database.windows
        return np.flatnonzero(
            (windows.sizes == self._edge) & (windows.counts >= minimum_references) & self._on_map(self._edge / 2)
        )

    def _on_map(self, reach: float) -> np.ndarray:
        """(N,) bool: windows around whose center a square of half edge ``reach`` lies on the label map."""
        x, y = self._database.windows.centers.T
        left, bottom, right, top = self._frame.extent
        # For a map whose pixels lie otherwise than the database's.
        slack = self._frame.pixel_size
        inside = (x - reach >= left - slack) & (x + reach <= right + slack)
        return inside & (y - reach >= bottom - slack) & (y + reach <= top + slack)

    def _table_windows(self) -> np.ndarray:
        """TABLE_WINDOWS of the usable ones; if possible with a vector and with room for the largest scale."""
        described = self._windows[self._database.windows.described[self._windows]]
        roomy = described[self._on_map(self._edge / 2 * max(SCALES))[described]]
        chosen = next(found for found in (roomy, described, self._windows) if len(found))
        rng = self._rng(SCALING, 0, 0)
        return np.sort(rng.choice(chosen, min(TABLE_WINDOWS, len(chosen)), replace=False))

    def _rng(self, *key) -> np.random.Generator:
        part, *numbers = key
        return np.random.default_rng([self._seed, PARTS.index(part), *numbers])

    def _draw(self, part: str, number: int, fixed: Optional[dict] = None, window: Optional[int] = None) -> Query:
        """A query with values drawn from the ranges, those ``fixed`` from theirs; around ``window`` if given."""
        rng = self._rng(part, number, 0)
        ranges = {**vars(self._ranges), **(fixed or {})}
        window = int(rng.choice(self._windows) if window is None else window)
        scale = float(np.exp(rng.uniform(*np.log(ranges["scale"]))))
        heading = float(rng.uniform(*ranges["rotation"]) % 360)
        offset_xy = _offset(ranges["offset"], rng)
        missed, invented, misnamed, ragged = (
            float(rng.uniform(*ranges[name])) for name in ("missed", "invented", "misnamed", "ragged")
        )
        windows = self._database.windows
        x, y = windows.centers[window] + self._database.parameters.stride * offset_xy
        return Query(
            part,
            number,
            windows.name(window),
            int(windows.counts[window]),
            (float(x), float(y)),
            heading,
            scale,
            float(np.abs(offset_xy).max()),
            ObjectNoise(missed / 100, invented / 100, misnamed / 100),
            ragged,
            self._view(x, y, heading, scale),
        )

    def _view(self, x: float, y: float, heading_deg: float, scale: float) -> View:
        column, row = self._frame.to_pixels((x, y)).tolist()
        map_px_per_px = self._edge * scale / self.image_px / self._frame.pixel_size
        return View(column, row, heading_deg, map_px_per_px, self.image_px, self.image_px)

    def _donor(self, query: Query, rng: np.random.Generator) -> np.ndarray:
        """Labels of another place at the query's scale, whose objects are invented."""
        x, y = self._database.windows.centers[rng.choice(self._windows)]
        return cut_view(self._source, self._view(x, y, float(rng.uniform(0, 360)), query.scale))

    def _judge(self, query: Query, method: str, result: Localization) -> Outcome:
        if result.position is None:
            return Outcome(query, method, result)
        x, y = result.position[0] - query.position[0], result.position[1] - query.position[1]
        error = math.hypot(x, y)
        edge = self._edge * query.scale
        if result.method == TOPOLOGY_VECTOR:
            place_right = self._is_nearest(result.window_index, query.position)
        else:
            place_right = error <= (RIGHT_SHARE * edge if self._right_within is None else self._right_within)
        known = {"window": result.window or self._nearest_window(result.position)}
        if result.heading_deg is not None:
            known["heading_error_deg"] = abs((result.heading_deg - query.heading_deg + 180) % 360 - 180)
            known["scale_error"] = abs(result.pixel_size_m * self.image_px / edge - 1)
        if result.uncertainty is not None:
            known["ellipse_ratio"] = ellipse_ratio(x, y, result.uncertainty)
        elif result.error_95_m:
            known["ellipse_ratio"] = error / result.error_95_m
        right = query.part != MIRRORED and result.status == FIX and place_right
        return Outcome(query, method, result, right, error, **known)

    def _is_nearest(self, window: int, position: Tuple[float, float]) -> bool:
        """Whether no window of its size has its center nearer to ``position``."""
        windows = self._database.windows
        away = np.hypot(*(windows.centers - position).T)
        return bool(away[window] <= away[windows.sizes == windows.sizes[window]].min() + 1e-6 * self._edge)

    def _nearest_window(self, position: Tuple[float, float]) -> str:
        windows = self._database.windows
        return windows.name(np.hypot(*(windows.centers - position).T).argmin())


def _offset(limits: Tuple[float, float], rng: np.random.Generator) -> np.ndarray:
    """(2,) offset whose larger axis lies in ``limits``, uniform over that frame of a square."""
    reach = math.sqrt(rng.uniform(limits[0] ** 2, limits[1] ** 2))
    offset = np.array([reach * rng.choice([-1, 1]), rng.uniform(-reach, reach)])
    return offset[::-1] if rng.random() < 0.5 else offset


def ellipse_ratio(x: float, y: float, uncertainty: PoseUncertainty) -> float:
    """Length of an error (x, y), map units, in units of the 95 % ellipse in its direction; at most 1 inside."""
    along = complex(x, y) * np.exp(-1j * np.radians(90 - uncertainty.orientation_deg))
    # Objects without any noise give an ellipse without extent.
    major, minor = max(uncertainty.semi_major, SMALLEST_AXIS), max(uncertainty.semi_minor, SMALLEST_AXIS)
    return float(np.hypot(along.real / major, along.imag / minor))
