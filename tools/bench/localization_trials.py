"""Label images cut from a map at known places, localized through a database, and how far off the results are."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Optional

import numpy as np

from bench.rates import share

if TYPE_CHECKING:  # the package is loaded by bench.plugin, after this module may be imported
    from semref.core.landmarks.landmarks import Landmarks
    from semref.core.localization import Localization
    from semref.core.simulation.views import View

SMALLEST_OBJECT_PX = 9.0
LARGEST_TRIES = 20_000
"""Places tried for one view before the map is said to have none like it."""


@dataclass(frozen=True)
class Outcome:
    """One image's result: errors of the place named (NaN without a fix), footprint in map units, what was in view.

    ratio: of the error to the 95 % ellipse in its direction, at most 1 inside; objects: whole ones in view before any
    noise; references: those the localizer used; seconds: processor time.
    """

    status: str
    objects: int
    references: int
    seconds: float
    footprint_m: float
    error_m: float = np.nan
    heading_deg: float = np.nan
    scale: float = np.nan
    ratio: float = np.nan

    @property
    def is_fix(self) -> bool:
        return self.status == "fix"

    def is_right(self, limit_m: float) -> bool:
        return self.is_fix and self.error_m <= limit_m

    @property
    def error_share(self) -> float:
        return self.error_m / self.footprint_m


@dataclass(frozen=True)
class Wanted:
    """What views to draw: scale range, headings (degrees; any if empty), whole objects in view, tilt."""

    scales: tuple = (0.8, 1.25)
    headings_deg: tuple = ()
    objects: tuple = (20, 10**9)
    tilt_deg: float = 0.0
    labeled: float = 0.0


class QueryMap:
    """The label map that images are cut from, with the database they are localized in.

    rows: (first, last) that centers of images come from; the database may be of another date than the labels.
    """

    def __init__(
        self, labels_hw: np.ndarray, database_path: Path, size_px: int, rows: Optional[Sequence[int]] = None
    ) -> None:
        from semref.core.labels.sources import ArrayLabels
        from semref.core.landmarks.landmarks import extract_landmarks
        from semref.core.localizer.localizer import Localizer
        from semref.storage.database.reader import read_database

        database = read_database(str(database_path), with_overview=True)
        parameters = database.parameters
        self.localizer = Localizer(database)
        self.database = database
        self.values = database.class_table.reference_values
        self.size_px = size_px
        self.pixel_size = parameters.pixel_size
        self.origin = parameters.geotransform[0], parameters.geotransform[3]
        self.minimum_area_px = parameters.minimum_area / self.pixel_size**2
        self.labels = ArrayLabels(labels_hw)
        self.objects = extract_landmarks(labels_hw, self.values, self.minimum_area_px)
        height, width = labels_hw.shape
        first, last = rows or (0, height)
        self.extent = 0, -last, width, -first

    def draw(self, wanted: Wanted, rng: np.random.Generator) -> tuple[View, np.ndarray, int]:
        """A view as wanted, its (H, W) labels and how many whole objects it shows; ValueError where there is none."""
        from dataclasses import replace

        from semref.core.simulation.views import PIXELS, cut, random_view

        for _ in range(LARGEST_TRIES):
            view = random_view(rng, self.extent, (self.size_px, self.size_px), wanted.scales)
            if wanted.headings_deg:
                view = replace(view, heading_deg=float(rng.choice(wanted.headings_deg)))
            if wanted.tilt_deg:
                direction = float(rng.uniform(0, 360))
                view = replace(view, tilt_deg=wanted.tilt_deg, tilt_direction_deg=direction)
            if self._count_near(view) < 0.7 * wanted.objects[0]:
                continue
            labels = cut(self.labels, PIXELS, view)
            count = len(self.whole_objects(labels, view.pixel_size))
            if wanted.objects[0] <= count <= wanted.objects[1] and (labels > 0).mean() >= wanted.labeled:
                return view, labels, count
        raise ValueError(f"{LARGEST_TRIES} places of the map have no view with {wanted.objects[0]} objects.")

    def objects_of(self, labels_hw: np.ndarray, scale: float) -> Landmarks:
        """Landmarks of an image, from the smallest that the localizer would look for at that scale."""
        from semref.core.landmarks.landmarks import extract_landmarks

        smallest = max(self.minimum_area_px / scale**2, SMALLEST_OBJECT_PX)
        return extract_landmarks(labels_hw, self.values, smallest)

    def whole_objects(self, labels_hw: np.ndarray, scale: float) -> Landmarks:
        """Those of ``objects_of`` that the image's border doesn't cut."""
        objects = self.objects_of(labels_hw, scale)
        return objects.select(~objects.touches_edge)

    def position(self, view: View) -> tuple[float, float]:
        """Map coordinates of a view's center."""
        return self.origin[0] + view.x * self.pixel_size, self.origin[1] + view.y * self.pixel_size

    def localize(self, view: View, labels_hw: np.ndarray, count: int, method: str) -> Outcome:
        """A label image in, what came of it out."""
        started = time.process_time()
        found = self.localizer.localize(labels_hw, method)
        return self.judge(view, found, found, count, time.process_time() - started)

    def judge(self, view: View, found: Localization, place, count: int, seconds: float) -> Outcome:
        """How far ``place`` (position, heading_deg, pixel_size_m), of a fix, is from where the view really is."""
        from semref.core.evaluation.trial import ellipse_ratio

        footprint = view.width_px * view.pixel_size * self.pixel_size
        known = {"objects": count, "references": found.references, "seconds": seconds, "footprint_m": footprint}
        if found.status != "fix":
            return Outcome(found.status, **known)
        x, y = np.subtract(place.position, self.position(view))
        known["error_m"] = float(np.hypot(x, y))
        if place.heading_deg is not None:
            known["heading_deg"] = abs((place.heading_deg - view.heading_deg + 180) % 360 - 180)
            known["scale"] = abs(place.pixel_size_m / (view.pixel_size * self.pixel_size) - 1)
        if found.covariance is not None and found.covariance.ellipse_95 is not None:
            known["ratio"] = ellipse_ratio(x, y, found.covariance.ellipse_95)
        return Outcome(found.status, **known)

    def _count_near(self, view: View) -> int:
        """Objects in the upright square of the view's size: a quick look before it is cut."""
        away = np.abs(self.objects.centers_xy - (view.x, -view.y)).max(axis=1)
        return int((away < self.size_px * view.pixel_size / 2).sum())


def rate(successes: int, trials: int) -> str:
    """“299/300, 100 % (98–100)”: count, rate and its 95 % interval."""
    return f"{successes}/{trials}, {share(successes, trials)}" if trials else "–"


def accuracy(right: Sequence[Outcome]) -> tuple[str, str]:
    """Median errors of right fixes (position, share of the footprint; heading, scale if told), ellipse's coverage."""
    if not right:
        return "–", "–"
    error, part = (np.median([getattr(outcome, name) for outcome in right]) for name in ("error_m", "error_share"))
    text = f"{error:.2f} m ({100 * part:.3f} %)"
    turned = [outcome for outcome in right if np.isfinite(outcome.heading_deg)]
    if turned:
        heading, scale = (np.median([getattr(o, name) for o in turned]) for name in ("heading_deg", "scale"))
        text += f", {heading:.3f}°, {100 * scale:.3f} %"
    known = [outcome.ratio for outcome in right if np.isfinite(outcome.ratio)]
    return text, rate(sum(ratio <= 1 for ratio in known), len(known))


def milliseconds(outcomes: Sequence[Outcome]) -> str:
    """Median and 95th percentile of the processor time."""
    median, high = 1000 * np.percentile([outcome.seconds for outcome in outcomes], [50, 95])
    return f"{median:.0f}, {high:.0f}"
