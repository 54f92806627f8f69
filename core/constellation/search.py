"""Search of candidates: clusters are fitted, verified, tested with a tilted camera, and the best few returned.

See docs/explanation/method.md#constellation.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from ..geometry.pose import Pose
from ..localization import Prior
from .clusters import Seeds
from .hypotheses import MINIMUM_OBJECTS, SeenLandmarks, query_triangles
from .index import ConstellationIndex
from .lookup import Lookup, allowed_poses, find_seeds
from .settings import Decision, SearchLimits
from .verification import (
    PoseEvidence,
    Verifier,
    gained_by_tilt,
    rough_scores,
    telling_objects,
    verify,
    verify_tilted,
)

ROUGH_GATES = (0.012, 0.006)
"""Largest residuals of matches in the successive rough fits, share of the image's diagonal. Set by hand."""

FEW_OBJECTS = 40
"""Up to this many landmarks a pose is verified from its seed as well as from its rough fit, which may have converged to
wrong matches. Set by hand."""

SAME_PLACE_IN_NOISE = 5.0
"""Poses are at the same place if their landmarks are nearer to each other than this many σ."""

SAME_TILTED_PLACE = 0.04
"""The same for a level and a tilted pose, share of the image's diagonal. Set by hand."""

REPEATED = 0.15
"""A step is a repeat of the map if it moves this share of the landmarks to another of their class … Set by hand."""

REPEAT_REACH = 0.5
"""… and its length is at most this share of their extent. Set by hand."""

COPY_REACH = 1.0
"""Diagonals of the image around a fix where similar ground is searched: two estates built by one plan are next to each
other."""

COPY_AREA_IN_NOISE = 3.0
"""Largest difference of areas between landmarks of such ground, in ``area_deviation``."""


class Round(NamedTuple):
    """Extent of one round of a search: triangles, the cap on their hits, and the poses of each lattice."""

    lookup: Lookup
    cap: int
    seeds: int
    prior: Prior | None = None
    """Additional prior beyond that of the lookup."""

    def mirrored(self) -> Round:
        """Return the same round for the mirrored image."""
        return self._replace(lookup=self.lookup.mirrored())


def rounds(index: ConstellationIndex, query: SeenLandmarks, prior: Prior | None) -> Iterator[Round]:
    """Yield the rounds: some and all triangles of the largest landmarks, then those of more landmarks by caps.

    The later rounds also test more candidates: the map has more places that resemble the image by chance the more
    landmarks it has.
    """
    settings, limits = index.settings, index.settings.limits
    few, many = limits.anchors
    largest = Lookup(index, query, query_triangles(query, settings, few), prior)
    some = largest.every(max(-(-len(largest.triangles) // limits.first_triangles), 1))
    first, second, *others = limits.maximum_hits
    yield Round(some, first, limits.seeds)
    yield Round(largest, second, limits.seeds)
    more = max(limits.thorough_seeds, round(limits.seeds * (len(index) / limits.landmarks_of_few_seeds) ** 0.5))
    wide = largest
    if query.usable_count > few:
        wide = Lookup(index, query, query_triangles(query, settings, many), prior)
    for cap in others:
        yield Round(wide, cap, more)


def search(verifier: Verifier, query: SeenLandmarks, reach: Round) -> tuple[list[PoseEvidence], bool]:
    """Return the best few poses at different places, best first; and whether the search was capped."""
    found, seeds = level_poses(verifier, query, reach)
    return tilted_poses(verifier, query, found, seeds), seeds.capped


def level_poses(verifier: Verifier, query: SeenLandmarks, reach: Round) -> tuple[list[PoseEvidence], Seeds]:
    """Return the best few poses of a level camera at different places, best first; and their clusters."""
    settings = verifier.index.settings
    seeds = find_seeds(reach.lookup, reach.cap, reach.seeds, reach.prior)
    found = Found(query, settings.decision)
    if not len(seeds.centers):
        return [], seeds
    gates = [gate * query.diagonal for gate in ROUGH_GATES]
    rough = query.select(telling_objects(query, settings.limits.rough_objects))
    centers, turns, scores = rough_scores(verifier.index, rough, seeds.centers, seeds.turns, gates)
    telling = query.select(telling_objects(query, settings.limits.largest_objects))
    poses: list[Pose] = []
    for number in _worth_a_trial(query, centers, turns, scores, settings.limits):
        poses.append(Pose(complex(centers[number]), complex(turns[number])))
        seed = Pose(complex(seeds.centers[number]), complex(seeds.turns[number]))
        if len(telling.points) <= FEW_OBJECTS and seed != poses[-1]:
            # The rough fit of few landmarks may have converged to wrong matches.
            poses.append(seed)
    for evidence in verify(verifier, telling, poses):
        found.add(evidence)
    return found.best_first, seeds


def _worth_a_trial(
    query: SeenLandmarks, centers: np.ndarray, turns: np.ndarray, scores: np.ndarray, limits: SearchLimits
) -> list[int]:
    """Return the roughly fitted poses to verify, best first: the best one of each place, close to the best of all.

    Args:
        centers: (S,) complex, map units from the index's origin.
        turns: (S,) complex, heading and pixel size.
        scores: (S,) of the rough fits.
        limits: Largest number, and smallest share of the best score.
    """
    chosen: list[int] = []
    tried: list[np.ndarray] = []
    best = 0.0
    for number in np.argsort(-scores, kind="stable").tolist():
        on_map = centers[number] + turns[number] * query.points
        if tried and (_distances(on_map, np.array(tried)) < 2.0 * abs(turns[number])).any():
            continue
        if tried and scores[number] < limits.rough_share * best:
            break
        best = max(best, float(scores[number]))
        chosen.append(number)
        tried.append(on_map)
        if len(chosen) == limits.verified:
            break
    return chosen


def tilted_poses(
    verifier: Verifier, query: SeenLandmarks, level: list[PoseEvidence], seeds: Seeds
) -> list[PoseEvidence]:
    """Return the best few poses, including those of a possibly tilted camera, best first."""
    settings = verifier.index.settings
    if not level:
        return []
    strongest, telling = level[0], query.select(telling_objects(query, settings.limits.largest_objects))
    if _is_level(verifier, telling, strongest):
        return level
    found = Found(query, settings.decision, level)
    if strongest.log_odds > 0:
        focus = complex(telling.points[strongest.matched].mean()) if len(strongest.matched) else 0j
        (tilted,) = verify_tilted(verifier, telling, [strongest.pose], [focus])
        found.add(tilted)
        if _is_as_good(tilted, strongest, settings.decision):
            return found.best_first
    if not _agrees(strongest, settings.decision):
        some = slice(settings.limits.tilted_verified)
        poses = [Pose(*numbers) for numbers in zip(seeds.centers[some].tolist(), seeds.turns[some].tolist())]
        for evidence in verify_tilted(verifier, telling, poses, seeds.focuses[some].tolist()):
            found.add(evidence)
    return found.best_first


class Found:
    """Poses of an image at different places: only the best one of each place remains.

    Attributes:
        poses: In the order in which they were added.
    """

    def __init__(self, query: SeenLandmarks, decision: Decision, poses: Sequence[PoseEvidence] = ()) -> None:
        self._query, self._decision = query, decision
        self.poses = list(poses)
        self._on_map = np.array([evidence.pose.on_map(query.points) for evidence in poses])
        self._noise = np.array([evidence.noise for evidence in poses])
        self._is_level = np.array([evidence.pose.is_level for evidence in poses], bool)

    @property
    def best_first(self) -> list[PoseEvidence]:
        """The poses in descending order of log odds."""
        return sorted(self.poses, key=lambda evidence: -evidence.log_odds)

    def knows(self, evidence: PoseEvidence) -> bool:
        """Return whether there is a pose at its place."""
        return bool(self._at_its_place(evidence, evidence.pose.on_map(self._query.points)).any())

    def add(self, evidence: PoseEvidence) -> None:
        """Add it unless a better one is at its place; a tilted one must be clearly better."""
        on_map = evidence.pose.on_map(self._query.points)
        same = self._at_its_place(evidence, on_map)
        better = evidence.log_odds - (0 if evidence.pose.is_level else self._decision.tilted_margin)
        if all(better > self.poses[number].log_odds for number in np.flatnonzero(same)):
            others = ~same
            self.poses = [*(other for other, is_other in zip(self.poses, others) if is_other), evidence]
            self._on_map = np.concatenate([self._on_map[others], on_map[None]]) if len(same) else on_map[None]
            self._noise = np.append(self._noise[others], evidence.noise)
            self._is_level = np.append(self._is_level[others], evidence.pose.is_level)

    def _at_its_place(self, evidence: PoseEvidence, on_map: np.ndarray) -> np.ndarray:
        """Return (k,) bool: poses that map the image's landmarks to the same points, within their noise."""
        if not self.poses:
            return np.zeros(0, bool)
        noise = np.maximum(self._noise, evidence.noise)
        size = abs(evidence.pose.turn)
        reach = np.maximum(SAME_PLACE_IN_NOISE * noise, 2.0 * size)
        of_tilt = SAME_TILTED_PLACE * self._query.diagonal * size
        is_level = self._is_level & evidence.pose.is_level
        reach = np.where(is_level, reach, np.maximum(reach, of_tilt))
        return _distances(on_map, self._on_map) < reach


def _distances(on_map: np.ndarray, others: np.ndarray) -> np.ndarray:
    """Return (k,) median distance on the map between an image's landmarks (n,) and those at k other poses (k, n)."""
    ordered = np.sort(np.abs(others - on_map), axis=1)
    count = ordered.shape[1]
    return (ordered[:, (count - 1) // 2] + ordered[:, count // 2]) / 2


def _is_level(verifier: Verifier, telling: SeenLandmarks, evidence: PoseEvidence) -> bool:
    """Return whether a pose is evident, its noise at most the assumed one, and a tilted camera would fit no better.

    A few of an image's landmarks may be too close to each other to show a tilt.
    """
    decision = verifier.index.settings.decision
    if evidence.log_odds < decision.minimum_log_odds or evidence.noise_factor > 1:
        return False
    if len(evidence.matched) <= FEW_OBJECTS and not _agrees(evidence, decision):
        return False
    return gained_by_tilt(verifier, telling, evidence) < decision.tilted_margin


def _is_as_good(tilted: PoseEvidence, level: PoseEvidence, decision: Decision) -> bool:
    """Return whether a tilted pose needs no other: it equals a level one in quality, or explains the image."""
    if tilted.log_odds < max(level.log_odds - decision.tilted_slack, decision.minimum_log_odds):
        return False
    is_level = len(level.matched) > FEW_OBJECTS and tilted.log_odds < level.log_odds + decision.tilted_margin
    return is_level or _agrees(tilted, decision)


def _agrees(evidence: PoseEvidence, decision: Decision) -> bool:
    """Return whether a pose explains the image, so that no other camera needs a test."""
    share = len(evidence.matched) / max(evidence.considered, 1)
    exact = evidence.noise_factor < decision.tilted_noise
    return evidence.log_odds >= decision.minimum_log_odds and exact and share > decision.tilted_share


def with_repeats(verifier: Verifier, query: SeenLandmarks, found: list[PoseEvidence]) -> list[PoseEvidence]:
    """Return the poses, and the best one moved by the steps at which the map repeats itself there, best first."""
    return _with_moved(verifier, query, found, repeats(verifier, query, found[0]))


def with_copies(
    verifier: Verifier, query: SeenLandmarks, found: list[PoseEvidence], prior: Prior | None
) -> list[PoseEvidence]:
    """Return the poses, and the best one moved to similar ground nearby, best first.

    An image may have no triangle in common with its true place, but one with a copy of it by chance, for example with
    the other of two estates built by one plan.
    """
    steps = copies(verifier, query, found[0])
    turns = np.full(len(steps), found[0].pose.turn)
    kept = allowed_poses(verifier.index, found[0].pose.center + np.array(steps, complex), turns, prior)
    return _with_moved(verifier, query, found, [step for step, is_kept in zip(steps, kept) if is_kept])


def _with_moved(
    verifier: Verifier, query: SeenLandmarks, found: list[PoseEvidence], steps: list[complex]
) -> list[PoseEvidence]:
    settings = verifier.index.settings
    best, telling = found[0], query.select(telling_objects(query, settings.limits.largest_objects))
    known = Found(query, settings.decision, found)
    for moved in verify(verifier, telling, [Pose(best.pose.center + step, best.pose.turn) for step in steps]):
        if not known.knows(moved):
            known.add(moved)
    return known.best_first


def repeats(verifier: Verifier, query: SeenLandmarks, evidence: PoseEvidence) -> list[complex]:
    """Return steps that move enough of the matched landmarks to others of their class, most frequent first."""
    index, settings = verifier.index, verifier.index.settings
    points, ranks = index.points[evidence.objects], index.ranks[evidence.objects]
    if len(points) < MINIMUM_OBJECTS:
        return []
    noise = evidence.noise
    steps = (points[:, None] - points[None])[ranks[:, None] == ranks[None]]
    longest = REPEAT_REACH * np.ptp(points.real)
    steps = steps[(np.abs(steps) > SAME_PLACE_IN_NOISE * noise) & (np.abs(steps) < longest)]
    _, first, counts = np.unique(_cells(steps, 2 * noise), return_index=True, return_counts=True)
    order = np.argsort(-counts, kind="stable")[: settings.limits.verified]
    return [complex(steps[first[k]]) for k in order if counts[k] >= REPEATED * len(points)]


def copies(verifier: Verifier, query: SeenLandmarks, evidence: PoseEvidence) -> list[complex]:
    """Return steps that move enough of the matched landmarks to one of their class and area, most frequent first."""
    index, settings = verifier.index, verifier.index.settings
    if len(evidence.objects) < MINIMUM_OBJECTS:
        return []
    largest = np.argsort(-index.log_areas[evidence.objects], kind="stable")[:FEW_OBJECTS]
    matched = evidence.objects[largest]
    points = index.points[matched]
    reach = COPY_REACH * query.diagonal * abs(evidence.pose.turn)
    corner = complex(reach, reach)
    low, high = complex(points.real.min(), points.imag.min()), complex(points.real.max(), points.imag.max())
    around = index.within(low - corner, high + corner)
    alike = index.ranks[matched][:, None] == index.ranks[around]
    areas = index.log_areas[matched][:, None] - index.log_areas[around]
    alike &= np.abs(areas) < COPY_AREA_IN_NOISE * settings.noise.area_deviation
    which, other = np.nonzero(alike)
    steps = index.points[around[other]] - points[which]
    cell = SAME_PLACE_IN_NOISE * evidence.noise
    steps = steps[np.abs(steps) > cell]
    if not len(steps):
        return []
    _, cells, counts = np.unique(_cells(steps, cell), return_inverse=True, return_counts=True)
    enough = np.flatnonzero(counts >= REPEATED * len(points))
    most = enough[np.argsort(-counts[enough], kind="stable")[: settings.limits.verified]]
    return [complex(steps[cells == number].mean()) for number in most]


def _cells(steps: np.ndarray, edge: float) -> np.ndarray:
    """Return (H,) int64 numbers of the square cells of steps (H,) complex, ascending by column, then by row."""
    columns, rows = (np.rint(part / edge).astype(np.int64) for part in (steps.real, steps.imag))
    return columns * (np.ptp(rows) + 1) + rows if len(rows) else columns
