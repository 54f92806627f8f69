"""Images cut from a map with known truth, localized with the published method, and how the results are judged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from semref.core.sample.pictures import Picture as View
from semref.core.sample.pictures import cut

WINDOW_COUNT = 100
LARGEST_SCALE = 2.0
SEED = 1671


@dataclass(frozen=True)
class Trial:
    """One image's result: `right`, whether the window nearest to its center was matched; error_m, of the position."""

    status: str
    right: bool
    error_m: float
    distance: float
    confidence: float
    references: int

    @property
    def accepted(self) -> bool:
        return self.status == "fix"


class Ground:
    """A label map, its database and windows chosen for trials."""

    def __init__(self, labels_hw: np.ndarray, database_path: Path) -> None:
        from semref.core.localizer.localizer import Localizer
        from semref.storage.database.reader import read_database

        self.labels_hw = labels_hw
        self.database = read_database(str(database_path))
        self.localizer = Localizer(self.database)
        parameters = self.database.parameters
        self.size_px = round(parameters.window_size / parameters.pixel_size)
        self.stride_px = round(parameters.stride / parameters.pixel_size)
        x0, pixel, _, y0, _, _ = parameters.geotransform
        centers = self.database.windows.centers
        self.centers_px = np.column_stack([(centers[:, 0] - x0) / pixel, (y0 - centers[:, 1]) / pixel])
        self.pixel_size = pixel

    def choose_windows(self, count: int = WINDOW_COUNT) -> np.ndarray:
        """Up to `count` windows with a vector around which the largest view lies on the map; always the same ones."""
        height, width = self.labels_hw.shape
        reach = self.size_px / 2 * LARGEST_SCALE
        x, y = self.centers_px.T
        on_map = (x >= reach) & (y >= reach) & (x <= width - reach) & (y <= height - reach)
        eligible = np.flatnonzero(self.database.windows.described & on_map)
        return np.sort(np.random.default_rng(SEED).choice(eligible, min(count, len(eligible)), replace=False))

    def view(
        self, window: int, heading_deg: float = 0.0, scale: float = 1.0, moved_px: Sequence[float] = (0, 0)
    ) -> View:
        column, row = self.centers_px[window] + np.asarray(moved_px)
        name = f"{self.database.windows.names[window]}.png"
        return View(name, "bench", float(column), float(row), heading_deg, scale)

    def cut(self, view: View) -> np.ndarray:
        """The view's labels, as many pixels as a window has."""
        return cut(self.labels_hw, view, self.size_px)

    def try_view(self, view: View) -> Trial:
        return self.judge(view, self.localizer.localize_by_topology_vector(self.cut(view)))

    def try_alone(self, view: View) -> Trial:
        """As `try_view`, but of the window's own picture turned: its corners are lost, 0 comes in their place."""
        half = self.size_px // 2
        column, row = round(view.column) - half, round(view.row) - half
        window = self.labels_hw[row : row + self.size_px, column : column + self.size_px]
        margin = self.size_px
        alone = replace(view, column=self.size_px / 2 + margin, row=self.size_px / 2 + margin)
        picture = cut(np.pad(window, margin), alone, self.size_px)
        return self.judge(view, self.localizer.localize_by_topology_vector(picture))

    def try_with_ground_area(self, view: View) -> Trial:
        """As `try_view`, but the minimum area is measured on the ground, as if the image's scale were known."""
        from semref.core.localizer.localizer import Localizer

        class KnownScale(Localizer):
            def describe(self, labels_hw, window_size):
                return super().describe(labels_hw, window_size * view.scale)

        return self.judge(view, KnownScale(self.database).localize_by_topology_vector(self.cut(view)))

    def judge(self, view: View, result) -> Trial:
        """Compares a localization with where the view really is."""
        away = np.hypot(*(self.centers_px - (view.column, view.row)).T)
        matched = result.window_index
        return Trial(
            result.status,
            matched is not None and away[matched] <= away.min() + 1e-6,
            np.nan if matched is None else float(away[matched]) * self.pixel_size,
            np.nan if result.distance is None else result.distance,
            result.confidence,
            result.references,
        )


def median(trials: Sequence[Trial], name: str) -> float:
    """Median of a figure over the trials that have it."""
    values = np.array([getattr(trial, name) for trial in trials], float)
    return float(np.nanmedian(values)) if np.isfinite(values).any() else np.nan


def count(trials: Sequence[Trial], name: str) -> int:
    return sum(bool(getattr(trial, name)) for trial in trials)
