"""Evaluate a database: seeded queries with known ground truth, localized with one or more methods.

Queries are cut from a label map around windows of the database, get simulated errors, and are compared with the place
of the cut. A query depends on (seed, part, number) only, so that every method gets the same ones and each can be
repeated.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace

import numpy as np

from .. import limits
from ..database.model import ReferenceDatabase
from ..errors import ParameterError
from ..geometry.error_settings import NETWORK_SPREAD, KnownBiases
from ..geometry.frame import MapFrame
from ..labels.sources import LabelSource
from ..localization import Localization, Method
from ..localizer.localizer import Localizer
from ..simulation.conditions import LARGEST_LENS, LARGEST_TILT_DEG, Conditions
from ..simulation.label_errors import spoil_labels
from ..simulation.noise import LabelNoise
from ..simulation.views import View, cut
from .rates import Rate
from .trial import Query, Trial, judge

MAP, MIRRORED, NOISE, SCALING, ROTATION, OFFSET = PARTS = ("map", "mirrored", "noise", "scaling", "rotation", "offset")
"""Parts of an evaluation: images of the map, mirrored images (which can't be right), the grid of noise, the paper's
Tables 4 and 5, and windows shifted step by step."""

SCALES = (2.0, 1.8, 1.5, 1.2, 1.0, 0.8, 0.75, 0.65, 0.6, 0.5)
"""View radius in windows, as in Table 4 of He & Wu 2025."""

ROTATIONS_DEG = tuple(range(0, 360, 30))
"""Rotations of Table 5 of He & Wu 2025."""

OFFSETS = (0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5)
"""Shifts of windows, as shares of the stride."""

SHARED = ("background", "displaced", "shifted", "leaning", "lens", "tilt")
"""Ranges of errors that landmarks of an image have in common, and of its background."""

CLEAN = dict.fromkeys(("offset", "missed", "invented", "misnamed", "ragged", "rotation", *SHARED), (0.0, 0.0))
"""Ranges of a query that shows a window without errors, except for its scale."""

NOISE_LEVELS = (0.0, 20.0, 40.0, 60.0)
"""Levels of the grid of noise: percent of missed landmarks, and of spurious ones."""

GRID_CELLS, MOST_IN_A_CELL = 16, 20
"""Images of a cell of the noise grid: count / GRID_CELLS, at least 2 and at most MOST_IN_A_CELL. So has a step of the
offset."""

TABLE_WINDOWS = 3
"""Windows that are scaled and turned for the two tables."""


@dataclass(frozen=True)
class TrialRanges:
    """Ranges of a trial's values, each (smallest, largest), by the names of the parameters.

    Attributes:
        scale: Ground shown, as a multiple of a window's edge (uniform in its logarithm).
        rotation: Heading, degrees.
        offset: Of the image's center from the nearest window's, as a share of the stride, the larger of both axes.
        missed: Missed landmarks, percent.
        invented: Spurious landmarks, percent of the existing ones.
        misnamed: Mislabeled landmarks, percent.
        ragged: Boundary jitter, standard deviation in m.
        background: Mislabeled regions of other classes, percent.
        displaced: Displacement between map and ground that neighbors share: standard deviation along each axis, m.
        shifted: Class offset of each class of landmarks, m.
        leaning: Displacement of roofs, percent of the distance from the image's center.
        lens: Radial distortion in the corners, percent.
        tilt: Of the camera, degrees.

    Raises:
        ParameterError: A value is impossible.
    """

    scale: tuple[float, float] = (0.8, 1.25)
    rotation: tuple[float, float] = (0.0, 360.0)
    offset: tuple[float, float] = (0.0, 0.5)
    missed: tuple[float, float] = (20.0, 20.0)
    invented: tuple[float, float] = (20.0, 20.0)
    misnamed: tuple[float, float] = (5.0, 5.0)
    ragged: tuple[float, float] = (0.0, 1.0)
    background: tuple[float, float] = (0.0, 0.0)
    displaced: tuple[float, float] = (0.0, 0.0)
    shifted: tuple[float, float] = (0.0, 0.0)
    leaning: tuple[float, float] = (0.0, 0.0)
    lens: tuple[float, float] = (0.0, 0.0)
    tilt: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        limits = {"scale": (0.05, 20.0), "rotation": (-360.0, 360.0), "offset": (0.0, 0.5)}
        limits |= dict.fromkeys(("ragged", "displaced", "shifted"), (0.0, math.inf))
        limits |= {"lens": (0.0, LARGEST_LENS), "tilt": (0.0, LARGEST_TILT_DEG)}
        for field in fields(self):
            low, high = getattr(self, field.name)
            least, most = limits.get(field.name, (0.0, 100.0))
            if not least <= low <= high <= most:
                raise ParameterError(
                    "The range of {setting} is {low:g} to {high:g}. Enter two numbers from {least:g} to {most:g}, the "
                    "smaller one first.",
                    setting=field.name,
                    low=low,
                    high=high,
                    least=least,
                    most=most,
                )


@dataclass(frozen=True)
class WindowQuery(Query):
    """An image around a window of the database.

    Attributes:
        landmarks: Number in the database's window.
        scale: Ground shown, in edges of the window.
        offset: Of the image's center from the window's, as a share of the stride, the larger of both axes.
        shifted: Class offset of each class of landmarks, m.
    """

    window: str = ""
    landmarks: int = 0
    scale: float = 1.0
    offset: float = 0.0
    shifted: float = 0.0


class Evaluation:
    """Plans queries (``trials``, ``noise_grid``, ``moves``, ``tables``) and localizes them one by one (``run``)."""

    def __init__(  # noqa: PLR0913 - what is tried, on which map, with which draws, and what counts as right
        self,
        database: ReferenceDatabase,
        source: LabelSource,
        frame: MapFrame,
        ranges: TrialRanges,
        seed: int,
        minimum_references: int = 3,
        right_within: float | None = None,
    ) -> None:
        """Select the windows that images are taken around.

        Args:
            source: A label map in the database's CRS and classes, with pixels of any size.
            minimum_references: Least landmarks of a window for trials.
            right_within: Largest error of a right position, m; None for RIGHT_SHARE of the footprint.

        Raises:
            ParameterError: No window can be used.
        """
        self._database = database
        self._source = source
        self._ranges = ranges
        self._seed = seed
        self._right_within = right_within
        self.localizer = Localizer(database)
        # Like those of a network that states no class offset.
        self._biases = KnownBiases(class_spread=NETWORK_SPREAD if ranges.shifted[1] > 0 else 0.0)
        self._frame = frame.of_shape(source.shape_hw)
        self._edge = float(database.windows.sizes.min()) if len(database.windows) else 0.0
        self.image_px = min(max(round(self._edge / database.parameters.pixel_size), 1), limits.SIMULATED_EDGE_PX)
        self._windows = self._usable_windows(minimum_references)
        if not len(self._windows):
            raise ParameterError(
                "No window of the database is on the label map and has at least {minimum_references} landmarks. Choose "
                "a label map of the same ground, or a smaller number of landmarks.",
                minimum_references=minimum_references,
            )

    @property
    def tried_windows(self) -> Rate:
        """Windows that images are taken around, of all of their size: the ground that the rates describe."""
        return Rate(len(self._windows), int(np.count_nonzero(self._database.windows.sizes == self._edge)))

    def plan(
        self, methods: list[Method], count: int, mirrored_share: float, is_reported: bool
    ) -> list[tuple[WindowQuery, list[Method]]]:
        """Return the queries with their methods.

        Args:
            methods: The first one is that of the grid of noise.
            count: Images of the map and mirrored ones together.
            mirrored_share: Share of mirrored images, 0…1; at least one image is of the map.
            is_reported: Whether to add the queries of tables and charts.
        """
        mirrored = min(round(count * mirrored_share), count - 1)
        planned = [(query, methods) for query in self.trials(count - mirrored, mirrored)]
        if is_reported:
            a_cell = min(max(count // GRID_CELLS, 2), MOST_IN_A_CELL)
            planned += [(query, methods[:1]) for query in self.noise_grid(a_cell)]
            planned += [(query, methods) for query in self.moves(a_cell)]
            planned += [(query, methods) for query in self.tables()]
        return planned

    def trials(self, count: int, mirrored: int) -> Iterator[WindowQuery]:
        """Yield ``count`` queries of the map, then ``mirrored`` mirrored ones."""
        for part, wanted in ((MAP, count), (MIRRORED, mirrored)):
            for number in range(wanted):
                yield self._draw(part, number)

    def noise_grid(self, count: int) -> Iterator[WindowQuery]:
        """Yield ``count`` queries for each pair of NOISE_LEVELS, missed and spurious, at the same places."""
        for missed in NOISE_LEVELS:
            for invented in NOISE_LEVELS:
                for number in range(count):
                    yield self._draw(NOISE, number, {"missed": (missed, missed), "invented": (invented, invented)})

    def moves(self, count: int) -> Iterator[WindowQuery]:
        """Yield ``count`` windows shifted by each of OFFSETS, without noise, scale or rotation."""
        for offset in OFFSETS:
            for number in range(count):
                yield self._draw(OFFSET, number, {**CLEAN, "scale": (1, 1), "offset": (offset, offset)})

    def tables(self) -> Iterator[WindowQuery]:
        """Yield the paper's Tables 4 and 5: windows without noise, scaled and turned about their centers."""
        for window in self._table_windows():
            for scale in SCALES:
                yield self._draw(SCALING, 0, {**CLEAN, "scale": (scale, scale)}, window)
            for angle in ROTATIONS_DEG:
                yield self._draw(ROTATION, 0, {**CLEAN, "scale": (1, 1), "rotation": (angle, angle)}, window)

    def image(self, query: WindowQuery) -> np.ndarray:
        """Return (H, W) uint8 labels of a query with errors; the errors are drawn before the image is mirrored."""
        rng = self._rng(query.kind, query.number, 1)
        noise = query.noise.in_pixels(query.view.pixel_size)
        donor = self._donor(query, rng) if noise.changes_landmarks else None
        smallest = self._database.parameters.minimum_area / query.view.pixel_size**2
        labels = cut(self._source, self._frame, query.view.plain())
        values = self._database.class_table.reference_values
        labels = spoil_labels(labels, noise, rng, values, donor, smallest)
        return np.ascontiguousarray(labels[:, ::-1]) if query.view.is_mirrored else labels

    def run(self, query: WindowQuery, methods: Sequence[Method]) -> list[Trial]:
        """Localize a query with each of ``methods``, in their order."""
        labels = self.image(query)
        found = [self.localizer.localize(labels, method, biases=self._biases) for method in methods]
        return [self._judge(query, method, one) for method, one in zip(methods, found)]

    def _usable_windows(self, minimum_references: int) -> np.ndarray:
        windows = self._database.windows
        return np.flatnonzero(
            (windows.sizes == self._edge) & (windows.counts >= minimum_references) & self._on_map(self._edge / 2)
        )

    def _on_map(self, reach: float) -> np.ndarray:
        """Return (N,) bool: windows with a square of half edge ``reach`` around their center on the label map."""
        x, y = self._database.windows.centers.T
        left, bottom, right, top = self._frame.extent
        # For a map with another pixel grid than the database's.
        slack = self._frame.pixel_size
        inside = (x - reach >= left - slack) & (x + reach <= right + slack)
        return inside & (y - reach >= bottom - slack) & (y + reach <= top + slack)

    def _table_windows(self) -> np.ndarray:
        """Return TABLE_WINDOWS of the usable windows; if possible with a vector and room for the largest scale."""
        described = self._windows[self._database.windows.described[self._windows]]
        roomy = described[self._on_map(self._edge / 2 * max(SCALES))[described]]
        chosen = next(found for found in (roomy, described, self._windows) if len(found))
        rng = self._rng(SCALING, 0, 0)
        return np.sort(rng.choice(chosen, min(TABLE_WINDOWS, len(chosen)), replace=False))

    def _rng(self, part: str, *numbers: int) -> np.random.Generator:
        return np.random.default_rng([self._seed, PARTS.index(part), *numbers])

    def _draw(self, part: str, number: int, fixed: dict | None = None, window: int | None = None) -> WindowQuery:
        """Return a query with values from the ranges, or from ``fixed`` ones; around ``window`` if given."""
        rng = self._rng(part, number, 0)
        ranges = {**vars(self._ranges), **(fixed or {})}
        window = int(rng.choice(self._windows) if window is None else window)
        scale = float(np.exp(rng.uniform(*np.log(ranges["scale"]))))
        heading = float(rng.uniform(*ranges["rotation"]) % 360)
        offset_xy = _offset(ranges["offset"], rng)
        missed, invented, misnamed, ragged = (
            float(rng.uniform(*ranges[name])) for name in ("missed", "invented", "misnamed", "ragged")
        )
        # Drawn last, so that images are at the same places as without these errors.
        background, displaced, shifted, leaning, lens, tilt = (float(rng.uniform(*ranges[name])) for name in SHARED)
        noise = LabelNoise(missed / 100, invented / 100, misnamed / 100, ragged)
        noise = replace(noise, background=background / 100, displaced=displaced, leaning=leaning / 100)
        windows = self._database.windows
        x, y = windows.centers[window] + self._database.parameters.stride * offset_xy
        values = self._database.class_table.reference_values
        view = self._view(x, y, heading, scale, part == MIRRORED)
        view, noise = Conditions(noise, shifted, lens / 100, tilt).drawn(view, rng, values)
        return WindowQuery(
            view,
            part,
            number,
            noise,
            window=windows.name(window),
            landmarks=int(windows.counts[window]),
            scale=scale,
            offset=float(np.abs(offset_xy).max()),
            shifted=shifted,
        )

    def _view(self, x: float, y: float, heading_deg: float, scale: float, is_mirrored: bool = False) -> View:
        size = self.image_px
        pixel_size = self._edge * scale / size
        return View(float(x), float(y), heading_deg, pixel_size, size, size, is_mirrored=is_mirrored)

    def _donor(self, query: WindowQuery, rng: np.random.Generator) -> np.ndarray:
        """Return labels of another place at the query's scale; its landmarks are the spurious ones."""
        x, y = self._database.windows.centers[rng.choice(self._windows)]
        return cut(self._source, self._frame, self._view(x, y, float(rng.uniform(0, 360)), query.scale))

    def _judge(self, query: WindowQuery, method: Method, result: Localization) -> Trial:
        trial = judge(query, method, result, self._right_within, query.landmarks)
        if result.position is None:
            return trial
        if result.method == Method.TOPOLOGY_VECTOR:
            # It returns only windows, so it is right when it returns the nearest one.
            is_nearest = self._is_nearest(result.window_index, query.view.position)
            trial = replace(trial, is_right=query.can_be_right and trial.is_fix and is_nearest)
        return replace(trial, window=result.window or self._nearest_window(result.position))

    def _is_nearest(self, window: int | None, position: tuple[float, float]) -> bool:
        """Return whether no window of its size has its center nearer to ``position``."""
        windows = self._database.windows
        away = np.hypot(*(windows.centers - position).T)
        return bool(away[window] <= away[windows.sizes == windows.sizes[window]].min() + 1e-6 * self._edge)

    def _nearest_window(self, position: tuple[float, float]) -> str:
        windows = self._database.windows
        return windows.name(np.hypot(*(windows.centers - position).T).argmin())


def _offset(limits: tuple[float, float], rng: np.random.Generator) -> np.ndarray:
    """Return a (2,) offset with its larger axis in ``limits``, uniform over that frame of a square."""
    reach = math.sqrt(rng.uniform(limits[0] ** 2, limits[1] ** 2))
    offset = np.array([reach * rng.choice([-1, 1]), rng.uniform(-reach, reach)])
    return offset[::-1] if rng.random() < 0.5 else offset
