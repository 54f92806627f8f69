"""What speaks for a pose: a likelihood ratio for every object of the image and of the map there (DESIGN §3)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .constellation_index import AREA_BIN, AREA_BINS, ConstellationIndex
from .hypotheses import CENTER_NOISE_IN_SIZES, CENTER_NOISE_PX, Query
from .pose import fit_similarity

DISTRACTORS = 0.4
"""Share of an image's objects expected to have nothing to do with the map, at the right place."""

VISIBILITY = 0.5
"""Share of the map's objects in view that is expected to be found in the image."""

AREA_DEVIATION = 0.2
AREA_OUTLIERS = 0.15
AREA_OUTLIER_DEVIATION = 1.0
"""ln area in image against map: a normal distribution, and a wide one for objects that are merged or split."""

ASSUMED_OBJECTS = 3
"""Objects that make a hypothesis can't be evidence for it. Any three of those matched may have made it, so three times
their mean is taken off."""

GATE_IN_NOISE = 3.5
"""A match farther off than this many σ is none."""

NOISE_FACTORS = (0.5, 3.0)
"""How much less or more noise than assumed an image may have; measured from its own residuals."""

REFINEMENTS = 6
ROBUST_REFINEMENTS = 4
"""Rounds of match and fit for one pose. The first ones trust near matches more, to leave wrong ones; the last ones do
not, because with such weights residuals understate the uncertainty."""

LARGEST_OBJECTS = 250
"""Objects of an image used as evidence, largest first. More change nothing but the time."""

MEDIAN_OF_RAYLEIGH = 1.1774
"""Median length of a residual whose two coordinates have a standard deviation of 1."""


@dataclass(frozen=True)
class Evidence:
    """A verified pose: centre and turn, log odds against a chance hit, matched pairs and their noise.

    matched: (m,) objects of the image; objects: (m,) those of the map; deviations: (m,) σ of each match in map units;
    noise_factor: how much of the assumed noise there is; missing: objects of the map that should be seen and aren't;
    considered: objects of the image that could be on the map.
    """

    center: complex
    turn: complex
    log_odds: float
    matched: np.ndarray
    objects: np.ndarray
    deviations: np.ndarray
    noise_factor: float
    missing: int
    considered: int


@dataclass(frozen=True)
class Verifier:
    """What verification needs of catalogue and image; sizes in pixels."""

    index: ConstellationIndex
    width_px: float
    height_px: float
    minimum_area_px: float


def center_noise(log_areas_px: np.ndarray, pixel_size: np.ndarray) -> np.ndarray:
    """Assumed σ of centres in map units, of objects with ln area in pixels."""
    return pixel_size * np.hypot(CENTER_NOISE_PX, CENTER_NOISE_IN_SIZES * np.exp(log_areas_px / 2))


def match_terms(verifier: Verifier, query: Query, distances, objects, deviations, log_scale) -> np.ndarray:
    """(…, n) ln likelihood ratio of every object's nearest match against a random hit at the local density.

    distances, objects, deviations: (…, n); log_scale: ln pixel size, broadcastable. ln DISTRACTORS without a match.
    """
    index = verifier.index
    found = np.maximum(objects, 0)
    position = -0.5 * (distances / deviations) ** 2 - np.log(2 * np.pi * deviations**2 * index.densities[found])
    area = query.log_areas + 2 * log_scale
    off = area - index.log_areas[found]
    seen = (1 - AREA_OUTLIERS) * _normal(off, AREA_DEVIATION) + AREA_OUTLIERS * _normal(off, AREA_OUTLIER_DEVIATION)
    bins = np.clip(((area - AREA_BINS[0]) / AREA_BIN).astype(np.int64), 0, len(AREA_BINS) - 1)
    ratio = np.exp(np.clip(position, -50, 30)) * seen / index.area_densities[query.ranks, bins]
    ratio = np.where((objects >= 0) & (distances <= GATE_IN_NOISE * deviations), ratio, 0)
    return np.log(DISTRACTORS + (1 - DISTRACTORS) * ratio)


def _normal(x: np.ndarray, deviation: float) -> np.ndarray:
    return np.exp(-0.5 * (x / deviation) ** 2) / (np.sqrt(2 * np.pi) * deviation)


def rough_scores(verifier: Verifier, query: Query, centers, turns, gates) -> tuple:
    """Poses (S,) fitted all at once with shrinking gates (map units per pixel of size, (G,)); scores (S,), no misses.

    query: its most telling objects only, all of known class.
    """
    index = verifier.index
    for gate in gates:
        size = np.abs(turns)[:, None]
        distances, objects = index.matcher.match(centers[:, None] + turns[:, None] * query.points, query.ranks)
        off = query.log_areas + 2 * np.log(size) - index.log_areas[np.maximum(objects, 0)]
        near = (distances <= gate * size) & (np.abs(off) < 1.5)
        weights = near / center_noise(query.log_areas, size) ** 2
        fitted = fit_similarity(query.points[None], index.points[np.maximum(objects, 0)], weights)
        enough = near.sum(axis=1) >= 4
        enough &= np.abs(np.log(np.maximum(np.abs(fitted[1]), 1e-12) / size[:, 0])) < 0.3
        centers = np.where(enough, fitted[0], centers)
        turns = np.where(enough, fitted[1], turns)
    size = np.abs(turns)[:, None]
    distances, objects = index.matcher.match(centers[:, None] + turns[:, None] * query.points, query.ranks)
    deviations = 1.5 * center_noise(query.log_areas, size)
    scores = match_terms(verifier, query, distances, objects, deviations, np.log(size)).sum(axis=1)
    return centers, turns, scores


def telling_objects(query: Query, count: int) -> Query:
    """The largest whole objects of known class."""
    usable = np.flatnonzero(query.whole & (query.ranks >= 0))
    largest = np.sort(usable[np.argsort(-query.log_areas[usable], kind="stable")[:count]])
    return query.select(largest)


def verify(verifier: Verifier, query: Query, center: complex, turn: complex) -> Evidence:
    """Refines a pose by match and fit, then weighs it. query: of ``telling_objects``."""
    factor = 2.0
    for number in range(REFINEMENTS):
        distances, objects, deviations = _nearest(verifier, query, center, turn)
        kept = np.flatnonzero(_one_to_one(distances, objects) & (distances <= GATE_IN_NOISE * factor * deviations))
        if len(kept) < 4:
            break
        weights = 1 / deviations[kept] ** 2
        if number < ROBUST_REFINEMENTS:
            weights *= biweight(distances[kept], GATE_IN_NOISE * factor * deviations[kept])
        fitted = fit_similarity(query.points[kept], verifier.index.points[objects[kept]], weights)
        if not 0.7 < abs(fitted[1] / turn) < 1.4:
            break
        center, turn = complex(fitted[0]), complex(fitted[1])
        residuals = np.abs(center + turn * query.points[kept] - verifier.index.points[objects[kept]])
        factor = float(np.clip(np.median(residuals / deviations[kept]) / MEDIAN_OF_RAYLEIGH, *NOISE_FACTORS))
    return weigh(verifier, query, center, turn, factor)


def weigh(verifier: Verifier, query: Query, center: complex, turn: complex, factor: float) -> Evidence:
    """The evidence for a pose as it is."""
    index, size = verifier.index, abs(turn)
    distances, objects, deviations = _nearest(verifier, query, center, turn)
    deviations = factor * deviations
    objects = np.where(_one_to_one(distances, objects), objects, -1)
    terms = match_terms(verifier, query, distances, objects, deviations, np.log(size))
    # Smaller than anything on the map: neither for nor against.
    possible = query.log_areas + 2 * np.log(size) >= np.log(max(index.minimum_area_m2, 1e-12))
    matched = np.flatnonzero((objects >= 0) & (distances <= GATE_IN_NOISE * deviations))
    hit = np.zeros(len(query.points), bool)
    hit[matched] = True
    terms = np.where(possible | hit, terms, 0)
    missing = len(np.setdiff1d(expected_objects(verifier, query, center, turn), objects[matched]))
    assumed = ASSUMED_OBJECTS * max(float(terms[matched].mean()), 0) if len(matched) else 0.0
    log_odds = float(terms.sum() - assumed + missing * np.log(1 - VISIBILITY))
    return Evidence(
        center, turn, log_odds, matched, objects[matched], deviations[matched], factor, missing, int(possible.sum())
    )


def expected_objects(verifier: Verifier, query: Query, center: complex, turn: complex) -> np.ndarray:
    """(M,) objects of the map that an image with this pose should show whole, none smaller than those in ``query``."""
    index, size = verifier.index, abs(turn)
    half = complex(verifier.width_px, verifier.height_px) / 2
    corners = center + turn * np.array([half, -half, half.conjugate(), -half.conjugate()])
    low = complex(corners.real.min(), corners.imag.min())
    found = index.within(low, complex(corners.real.max(), corners.imag.max()))
    found = found[index.whole[found]]
    inside = (index.points[found] - center) / turn
    sizes = np.exp(index.log_areas[found] / 2) / size
    seen = (np.abs(inside.real) < half.real - sizes) & (np.abs(inside.imag) < half.imag - sizes)
    smallest = np.log(max(verifier.minimum_area_px, 1e-12))
    if len(query.points) >= LARGEST_OBJECTS:
        smallest = max(smallest, float(query.log_areas.min()))
    return found[seen & (index.log_areas[found] - 2 * np.log(size) > smallest + AREA_DEVIATION)]


def _nearest(verifier: Verifier, query: Query, center: complex, turn: complex):
    """Distances (n,), objects (n,), assumed deviations (n,) of the image's objects at a pose."""
    places = (center + turn * query.points)[None]
    distances, objects = verifier.index.matcher.match(places, query.ranks)
    return distances[0].astype(np.float64), objects[0], center_noise(query.log_areas, abs(turn))


def _one_to_one(distances: np.ndarray, objects: np.ndarray) -> np.ndarray:
    """(n,) bool: the nearest of the image's objects that share one of the map's."""
    order = np.lexsort((distances, objects))
    best = np.zeros(len(objects), bool)
    best[order[np.concatenate([[True], np.diff(objects[order]) != 0])[: len(order)]]] = True
    return best & (objects >= 0)


def biweight(distances: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Tukey's biweight: 1 at distance 0, falling smoothly to 0 at the end."""
    return np.maximum(1 - (distances / ends) ** 2, 0) ** 2
