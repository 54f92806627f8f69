"""Probability of success everywhere from single trials: trials nearby, and a regression where there are few.

A logistic regression on the properties of a place gives a first estimate. The trials around the place, weighted by
distance, add to it as more trials (Beta distribution). The reach of trials and the weight of the regression are those
that best predict each trial from all others.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

RIDGE = 1.0
"""Penalty of the regression's standardized coefficients, in trials: keeps it finite if all trials have one result."""

NEWTON_STEPS = 30

REACHES = (0.08, 0.15, 0.25, 0.4)
"""Tested standard deviations of the trials' weights, as shares of the footprint."""

STRENGTHS = (1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 128.0)
"""Tested weights of the regression, in trials."""

MOST_TUNED = 3000
"""Trials that choose reach and strength; limits time and memory."""

WEIGHTS_AT_A_TIME = 2_000_000

QUANTILE_STEPS = 500

LEAST_WEIGHT = 1e-3


@dataclass(frozen=True)
class Chances:
    """Probabilities of P places as Beta distributions.

    Attributes:
        means: (P,).
        weights: (P,) equivalent number of trials: more trials give a narrower distribution.
    """

    means: np.ndarray
    weights: np.ndarray

    def interval(self) -> tuple[np.ndarray, np.ndarray]:
        """Return (P,) low and (P,) high ends of the 95 % interval, which contains the mean."""
        low, high = beta_quantiles(self.means * self.weights, (1 - self.means) * self.weights, (0.025, 0.975))
        # The mean of a skewed distribution may be beyond a quantile.
        return np.minimum(low, self.means), np.maximum(high, self.means)

    def either(self, other: Chances) -> Chances:
        """Return the probability of success if a second method is tried after the first fails.

        It is the Beta distribution with the mean and variance of the product of both failures.
        """
        one, two = 1 - self.means, 1 - other.means
        failure = one * two
        squares = (one**2 + self._variances()) * (two**2 + other._variances())
        variance = np.maximum(squares - failure**2, 1e-9)
        weights = np.maximum(failure * (1 - failure) / variance - 1, 1.0)
        return Chances(1 - failure, weights)

    def averaged(self, count: int) -> Chances:
        """Return the mean of each ``count`` consecutive places."""
        return Chances(self.means.reshape(-1, count).mean(axis=1), self.weights.reshape(-1, count).mean(axis=1))

    def _variances(self) -> np.ndarray:
        return self.means * (1 - self.means) / (self.weights + 1)


@dataclass(frozen=True)
class SuccessModel:
    """A regression on F features of places, and its T trials.

    Attributes:
        centers: (F,) means of the features.
        scales: (F,) standard deviations of the features.
        coefficients: (1 + 2 F,) of the regression: intercept, features, their squares.
        places: (T, 2) map x, y of the trials.
        successes: (T,) 1 for a right fix, otherwise 0.
        reach: Distance over which trials count, m.
        strength: Weight of the regression, in trials.
        left_out: (T,) prediction of each trial from the others; NaN beyond MOST_TUNED.
    """

    centers: np.ndarray
    scales: np.ndarray
    coefficients: np.ndarray
    places: np.ndarray
    successes: np.ndarray
    reach: float
    strength: float
    left_out: np.ndarray

    def guess(self, features: np.ndarray) -> np.ndarray:
        """Return (P,) the regression's probability for features (P, F)."""
        return _logistic(_design((features - self.centers) / self.scales) @ self.coefficients)

    def chances(self, places: np.ndarray, features: np.ndarray) -> Chances:
        """Return probabilities at places (P, 2) with features (P, F)."""
        guess = self.guess(features)
        counts, hits = local_sums(places, self.places, self.reach, self.successes)
        weights = self.strength + counts
        means = (self.strength * guess + hits) / weights
        return Chances(np.clip(means, 1e-4, 1 - 1e-4), weights)


def fit_success(features: np.ndarray, places: np.ndarray, successes: np.ndarray, footprint: float) -> SuccessModel:
    """Return the model of T > 0 trials.

    Args:
        features: (T, F) of the places.
        places: (T, 2) map x, y.
        successes: (T,) bool.
        footprint: Footprint width of an image, m.
    """
    successes = np.asarray(successes, np.float64)
    centers = features.mean(axis=0)
    scales = np.maximum(features.std(axis=0), 1e-9)
    coefficients = _fit_logistic(_design((features - centers) / scales), successes)
    guess = _logistic(_design((features - centers) / scales) @ coefficients)
    tuned = np.linspace(0, len(places) - 1, min(len(places), MOST_TUNED)).astype(int)
    left_out = np.full(len(places), np.nan)
    reach, strength, left_out[tuned] = _tune(guess[tuned], places[tuned], successes[tuned], footprint)
    return SuccessModel(centers, scales, coefficients, places, successes, reach, strength, left_out)


def local_sums(
    places: np.ndarray, trials: np.ndarray, reach: float, values: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return (P,) summed weights of trials (T, 2) around places (P, 2), and (P,) or (P, K) weighted sums of values."""
    counts = np.empty(len(places))
    sums = np.empty((len(places), *values.shape[1:]))
    step = max(WEIGHTS_AT_A_TIME // max(len(trials), 1), 1)
    for first in range(0, len(places), step):
        weights = _weights(places[first : first + step], trials, reach)
        counts[first : first + step] = weights.sum(axis=1)
        sums[first : first + step] = weights @ values
    return counts, sums


def beta_quantiles(alpha: np.ndarray, beta: np.ndarray, shares: tuple[float, ...]) -> tuple[np.ndarray, ...]:
    """Return (P,) quantiles of Beta distributions, by sums of their densities over even steps; shares in 0…1."""
    steps = (np.arange(QUANTILE_STEPS) + 0.5) / QUANTILE_STEPS
    found = [np.empty(len(alpha)) for _ in shares]
    chunk = WEIGHTS_AT_A_TIME // QUANTILE_STEPS
    for first in range(0, len(alpha), chunk):
        part = slice(first, first + chunk)
        logs = (alpha[part, None] - 1) * np.log(steps) + (beta[part, None] - 1) * np.log1p(-steps)
        density = np.exp(logs - logs.max(axis=1, keepdims=True))
        sums = np.cumsum(density, axis=1)
        for number, share in enumerate(shares):
            found[number][part] = steps[(sums < share * sums[:, -1:]).sum(axis=1).clip(max=QUANTILE_STEPS - 1)]
    return tuple(found)


def _weights(places: np.ndarray, trials: np.ndarray, reach: float) -> np.ndarray:
    squared = (places[:, None, 0] - trials[None, :, 0]) ** 2 + (places[:, None, 1] - trials[None, :, 1]) ** 2
    weights = np.exp(-squared / (2 * reach**2))
    weights[weights < LEAST_WEIGHT] = 0
    return weights


def _tune(
    guess: np.ndarray, places: np.ndarray, successes: np.ndarray, footprint: float
) -> tuple[float, float, np.ndarray]:
    """Return the reach and strength that best predict each trial from the others, and these predictions (T,)."""
    best = -math.inf, REACHES[0] * footprint, STRENGTHS[-1], guess
    for share in REACHES:
        reach = share * footprint
        # A trial's own weight is 1.
        counts, hits = local_sums(places, places, reach, successes)
        counts, hits = counts - 1, hits - successes
        for strength in STRENGTHS:
            predicted = np.clip((strength * guess + hits) / (strength + counts), 1e-4, 1 - 1e-4)
            likelihood = float((successes * np.log(predicted) + (1 - successes) * np.log1p(-predicted)).sum())
            if likelihood > best[0] + 1e-9:
                best = likelihood, reach, strength, predicted
    return best[1:]


def _design(standardized: np.ndarray) -> np.ndarray:
    """Return intercept, features and their squares: success need not increase evenly with a feature."""
    # Beyond the range of the trials, squares would grow too much.
    bounded = np.clip(standardized, -3, 3)
    return np.column_stack([np.ones(len(bounded)), bounded, bounded**2])


def _fit_logistic(design: np.ndarray, successes: np.ndarray) -> np.ndarray:
    """Return the penalized maximum likelihood estimate by Newton's method."""
    # Half a success and half a failure: no rate is exactly 0 or 1.
    design = np.vstack([design, design.mean(axis=0), design.mean(axis=0)])
    successes = np.append(successes, [1.0, 0.0])
    counts = np.append(np.ones(len(successes) - 2), [0.5, 0.5])
    penalty = np.full(design.shape[1], RIDGE)
    penalty[0] = 1e-6
    coefficients = np.zeros(design.shape[1])
    for _ in range(NEWTON_STEPS):
        expected = _logistic(design @ coefficients)
        slope = design.T @ (counts * (successes - expected)) - penalty * coefficients
        curvature = (design * (counts * expected * (1 - expected))[:, None]).T @ design + np.diag(penalty + 1e-9)
        step = np.linalg.solve(curvature, slope)
        # Bounded, because large steps may overshoot.
        step *= min(1.0, 5.0 / max(float(np.abs(step).max()), 1e-12))
        coefficients = coefficients + step
        if np.abs(step).max() < 1e-8:
            break
    return coefficients


def _logistic(x: np.ndarray) -> np.ndarray:
    return 1 / (1 + np.exp(-np.clip(x, -30, 30)))
