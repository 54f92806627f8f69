"""Predict where a database will localize: success, error and reasons at given places, from trials and a model of them.

Callers plan trials, run them one by one (``run``, and ``run_correlation`` for those without a fix) and show progress.
Then ``estimate`` gives the result. A trial depends on (seed, number) only.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import cast

import cv2
import numpy as np

from ..constellation.matching import center_noise
from ..database.model import ReferenceDatabase
from ..evaluation.trial import Query, Trial
from ..localization import Status
from ..localizer.localizer import Localizer
from ..simulation.conditions import Conditions
from .images import ImageSimulator
from .model import SuccessModel, fit_success, local_sums

WRONG = "wrong_fix"
REASONS = (Status.TOO_FEW_REFERENCES.key, Status.AMBIGUOUS.key, Status.NO_MATCH.key, WRONG)
"""Reasons for no right fix."""

HEADINGS_DEG = (0.0, 30.0, 60.0)
"""Headings at which a place's landmarks are counted; a square is the same every 90°."""

TEXTURE_STEPS = 16
"""Pixels across a footprint for the comparison of class areas in a place's texture."""

ERROR_STRENGTH = 2.0
"""Weight of the median error of all fixes in a place's expected error, in right fixes nearby."""

MOST_PARTS = 45_000
"""Squares are computed in 3 × 3 parts, because landmarks may be on one side only; in fewer parts for many squares."""

CORRELATED_SHARE = 8
"""Map correlation takes about a second per image, so it is used for at most this part of the trials."""

LOCAL_FIXES = 0.5
"""Least weight of right fixes nearby for an expected error."""


@dataclass(frozen=True)
class PlaceQuery(Query):
    """An image to simulate, drawn for the place of that number."""

    place: int = 0


@dataclass(frozen=True)
class Estimates:
    """Expectations at P places, each (P,).

    Attributes:
        success: Probability of a right fix.
        low: Lower end of its 95 % interval.
        high: Upper end of its 95 % interval.
        error: Expected (median) error, m; NaN where hardly any image has a fix.
        trials: Simulated for the place itself.
        landmarks: Whole landmarks in view.
        classes: Classes with a landmark in view.
        look_alikes: Share of the trials nearby that were refused because another place or the mirrored image matches
            almost as well.
        wrong: Share of the trials nearby with a wrong fix.
        reasons: Of REASONS, the most frequent reason nearby for no right fix, '' if all trials succeed.
    """

    success: np.ndarray
    low: np.ndarray
    high: np.ndarray
    error: np.ndarray
    trials: np.ndarray
    landmarks: np.ndarray
    classes: np.ndarray
    look_alikes: np.ndarray
    wrong: np.ndarray
    reasons: tuple[str, ...]

    def part(self, chosen: np.ndarray) -> Estimates:
        """Return the estimates of some places, by their numbers."""
        arrays = {name: getattr(self, name)[chosen] for name in vars(self) if name != "reasons"}
        return Estimates(**arrays, reasons=tuple(self.reasons[n] for n in np.asarray(chosen).tolist()))


class Assessment:
    """Assessment of a database for one footprint and assumed errors."""

    def __init__(  # noqa: PLR0913 - what is assessed, and the five choices that the form offers
        self,
        database: ReferenceDatabase,
        localizer: Localizer,
        footprint: float,
        conditions: Conditions,
        seed: int,
        correlation: bool = False,
    ) -> None:
        """Prepare the data that all trials share.

        Args:
            footprint: Footprint width of the images, m.
            correlation: Use landmarks, then map correlation, as the method “automatic” does; needs the overview.

        Raises:
            ParameterError: The footprint is invalid.
            DatabaseError: The database has no landmarks.
        """
        self.simulator = ImageSimulator(localizer, database, footprint, conditions.biases)
        self.conditions = conditions
        self.footprint = footprint
        self.correlation = correlation
        self.database = database
        self.localizer = localizer
        self.seed = seed
        self._texture = _texture(database, footprint)
        self.model: SuccessModel | None = None
        """Of the last estimate, for landmarks only."""

    def plan(self, places: np.ndarray, spread: float, count: int) -> list[PlaceQuery]:
        """Return ``count`` trials, evenly distributed over squares of edge ``spread`` around places (P, 2)."""
        rng = np.random.default_rng([self.seed, 0, round(1000 * self.footprint)])
        whole, rest = divmod(count, max(len(places), 1))
        chosen = np.concatenate([np.tile(np.arange(len(places)), whole), rng.permutation(len(places))[:rest]])
        offsets = rng.uniform(-spread / 2, spread / 2, (len(chosen), 2))
        headings = rng.uniform(0, 360, len(chosen))
        centers = places[chosen] + offsets
        values = self.database.class_table.reference_values
        queries = []
        for number, (place, (x, y), heading) in enumerate(zip(chosen.tolist(), centers.tolist(), headings.tolist())):
            view, noise = self.conditions.drawn(self.simulator.view(x, y, heading), rng, values)
            queries.append(PlaceQuery(view, number=number, noise=noise, place=place))
        return queries

    def run(self, query: PlaceQuery) -> Trial:
        """Localize a simulated image by its landmarks."""
        return self.simulator.constellation(query, np.random.default_rng([self.seed, 1, query.number]))

    def run_correlation(self, query: PlaceQuery) -> Trial:
        """Localize a simulated image by map correlation; takes seconds on a large map."""
        return self.simulator.correlation(query, np.random.default_rng([self.seed, 2, query.number]))

    def estimate(
        self,
        places: np.ndarray,
        trials: Sequence[Trial],
        correlated: dict[int, Trial] | None = None,
        spread: float = 0.0,
    ) -> Estimates:
        """Return the expectations after trials.

        Args:
            places: (P, 2) map x, y
            trials: By landmarks, one for each planned query.
            correlated: By map correlation, by their number in ``trials``.
            spread: Edge of the squares around the places over which estimates are averaged; 0 for the places only.
        """
        correlated = correlated or {}
        centers = _centers(trials)
        parts, count = _parts(places, spread)
        features, landmarks, classes = self.features(parts)
        trial_features = self.features(centers)[0]
        self.model = fit_success(trial_features, centers, _right(trials), self.footprint)
        chances = self.model.chances(parts, features)
        if correlated:
            chosen = np.array(list(correlated))
            right = _right(correlated.values())
            second = fit_success(trial_features[chosen], centers[chosen], right, self.footprint)
            chances = chances.either(second.chances(parts, features))
        chances = chances.averaged(count)
        low, high = chances.interval()
        reach = max(2 * self.model.reach, spread / 2)
        shares, reasons = _causes_near(places, trials, reach)
        return Estimates(
            chances.means,
            low,
            high,
            _errors_near(places, [*trials, *correlated.values()], reach),
            np.bincount([cast(PlaceQuery, trial.query).place for trial in trials], minlength=len(places))[
                : len(places)
            ],
            landmarks.reshape(-1, count).mean(axis=1),
            classes.reshape(-1, count).max(axis=1),
            shares[:, REASONS.index(Status.AMBIGUOUS.key)],
            shares[:, REASONS.index(WRONG)],
            reasons,
        )

    def features(self, places: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the properties of places.

        Args:
            places: (P, 2) map x, y

        Returns:
            (P, F) numbers that make places comparable, (P,) whole landmarks in view, (P,) their classes. The numbers:
            ln(1 + landmarks), ln(1 + evidence if all were found), standard deviation of ln area, share of the most
            frequent class, share of the ground with labels, texture of class areas.
        """
        index = self.localizer.index
        pixel, references = self.simulator.pixel, self.database.references
        log_areas_px = index.log_areas - 2 * math.log(pixel)
        chance = 2 * math.pi * center_noise(log_areas_px, pixel, index.settings.noise) ** 2 * index.densities
        distractors = index.settings.noise.rough_distractors
        gains = np.log(distractors + (1 - distractors) / np.maximum(chance, 1e-12))
        numbers, landmarks, classes = [], np.empty(len(places)), np.empty(len(places))
        for n, (x, y) in enumerate(places.tolist()):
            views = [self.simulator.view(x, y, heading) for heading in HEADINGS_DEG]
            seen = np.concatenate([self.simulator.whole_landmarks(view)[0] for view in views])
            landmarks[n] = len(seen) / len(views)
            names, counts = np.unique(references.classes[seen], return_counts=True)
            classes[n] = len(names)
            evidence = float(gains[seen].sum()) / len(views)
            spread = float(index.log_areas[seen].std()) if len(seen) else 0.0
            commonest = float(counts.max() / counts.sum()) if len(seen) else 1.0
            numbers.append((math.log1p(landmarks[n]), math.log1p(max(evidence, 0)), spread, commonest))
        return np.column_stack([np.array(numbers).reshape(-1, 4), self._texture.at(places)]), landmarks, classes


def to_correlate(seed: int, trials: Sequence[Trial], most: int) -> list[int]:
    """Return the numbers, in ``trials``, of ``most`` evenly spread ones without a fix, for map correlation.

    Args:
        trials: By landmarks, in the order of the plan.
        most: Number of trials.
    """
    failed = [n for n, trial in enumerate(trials) if not trial.is_fix]
    order = np.random.default_rng([seed, 3]).permutation(len(failed))[:most]
    return [failed[n] for n in np.sort(order)]


def _centers(trials: Sequence[Trial]) -> np.ndarray:
    """Return (T, 2) map x, y of the images' centers."""
    return np.array([trial.query.view.position for trial in trials]).reshape(-1, 2)


def _right(trials: Iterable[Trial]) -> np.ndarray:
    """Return (T,) bool: right fixes."""
    return np.array([trial.is_right for trial in trials], bool)


def _causes_near(places: np.ndarray, trials: Sequence[Trial], reach: float) -> tuple[np.ndarray, tuple[str, ...]]:
    """Return (P, R) shares of failed trials near places (P, 2) by REASONS, and the most frequent reason of each."""
    causes = np.array([[_cause(trial) == reason for reason in REASONS] for trial in trials], float)
    counts, sums = local_sums(places, _centers(trials), reach, causes)
    shares = sums / np.maximum(counts, 1e-9)[:, None]
    return shares, tuple(REASONS[row.argmax()] if row.max() > 0 else "" for row in shares)


def _cause(trial: Trial) -> str:
    """Return one of REASONS, '' for a right fix."""
    if trial.is_fix:
        return "" if trial.is_right else WRONG
    return trial.status.key


def _errors_near(places: np.ndarray, trials: Sequence[Trial], reach: float) -> np.ndarray:
    """Return (P,) expected errors: the mean logarithm of right fixes nearby, weighted with that of all; NaN without."""
    right = [trial for trial in trials if trial.is_right]
    if not right:
        return np.full(len(places), np.nan)
    logs = np.log([max(trial.error or 0.0, 1e-6) for trial in right])
    counts, sums = local_sums(places, _centers(right), reach, logs)
    expected = np.exp((sums + ERROR_STRENGTH * np.median(logs)) / (counts + ERROR_STRENGTH))
    return np.where(counts >= LOCAL_FIXES, expected, np.nan)


def _parts(places: np.ndarray, spread: float) -> tuple[np.ndarray, int]:
    """Return (P · n, 2) centers of the n parts of squares of edge ``spread`` around places (P, 2), and n."""
    edge = next(k for k in (3, 2, 1) if k == 1 or spread > 0 and k * k * len(places) <= MOST_PARTS)
    steps = ((np.arange(edge) + 0.5) / edge - 0.5) * spread
    offsets = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(1, -1, 2)
    return (places[:, None] + offsets).reshape(-1, 2), edge * edge


@dataclass(frozen=True)
class _Texture:
    """Labeled share and texture of the ground around every place.

    Attributes:
        labeled: (h, w) share of the footprint with labels.
        texture: (h, w) as of ``_texture``.
        origin: Map (x, y) of the upper left corner.
        pixel: Edge of a pixel, m.
    """

    labeled: np.ndarray
    texture: np.ndarray
    origin: tuple[float, float]
    pixel: float

    def at(self, places: np.ndarray) -> np.ndarray:
        """Return (P, 2) labeled share and texture around places (P, 2)."""
        columns = np.floor((places[:, 0] - self.origin[0]) / self.pixel).astype(int)
        rows = np.floor((self.origin[1] - places[:, 1]) / self.pixel).astype(int)
        height, width = self.labeled.shape
        rows, columns = np.clip(rows, 0, height - 1), np.clip(columns, 0, width - 1)
        return np.column_stack([self.labeled[rows, columns], self.texture[rows, columns]])


def _texture(database: ReferenceDatabase, footprint: float) -> _Texture:
    """Return labeled share and texture of footprints everywhere; zeros for a database without overview.

    Texture is the standard deviation of the classes' areas in TEXTURE_STEPS² parts, summed over classes.
    """
    parameters = database.parameters
    frame = parameters.overview_frame
    if database.overview is None:
        return _Texture(np.zeros((1, 1)), np.zeros((1, 1)), frame.origin, footprint)
    overview = database.overview
    step = max(footprint / TEXTURE_STEPS / frame.pixel_size, 1.0)
    size = tuple(max(round(length / step), 1) for length in overview.shape[::-1])
    labeled, variance = np.zeros(size[::-1], np.float32), np.zeros(size[::-1], np.float32)
    window = max(round(footprint / (frame.pixel_size * overview.shape[1] / size[0])), 1)
    for value in np.unique(overview):
        if value:
            table = np.zeros(256, np.uint8)
            table[value] = 255
            share = cv2.resize(cv2.LUT(overview, table), size, interpolation=cv2.INTER_AREA).astype(np.float32) / 255
            # The map has no ground beyond its edge.
            mean, square = (
                cv2.boxFilter(image, -1, (window, window), borderType=cv2.BORDER_CONSTANT)
                for image in (share, share**2)
            )
            labeled += mean
            variance += np.maximum(square - mean**2, 0)
    coarse = frame.pixel_size * overview.shape[1] / size[0]
    return _Texture(labeled, np.sqrt(variance), frame.origin, coarse)
