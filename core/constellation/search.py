"""The places where an image may lie: clusters are fitted, verified, tried with a tilted camera, the best few kept.

Told in docs/explanation/method.md#constellation.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..geometry.pose import Pose
from ..localization import Prior
from .clusters import Seeds
from .hypotheses import MINIMUM_OBJECTS, SeenLandmarks
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
"""How far a match may be off in the rough fits, one after the other, share of the image's diagonal. Set by hand."""

FEW_OBJECTS = 40
"""Up to so many objects a pose is verified from its seed as well as from its rough fit, which may have settled on wrong
matches. Set by hand."""

SAME_PLACE_IN_NOISE = 5.0
"""Poses whose objects lie nearer to each other than this many σ are the same place."""

SAME_TILTED_PLACE = 0.04
"""The same of a level and a tilted pose, share of the image's diagonal. Set by hand."""

REPEATED = 0.15
"""A step is a repeat of the map if it leads this share of the objects to another of their class … Set by hand."""

REPEAT_REACH = 0.5
"""… and is at most this share of their extent long. Set by hand."""

COPY_REACH = 1.0
"""Diagonals of the image around a fix in which ground is sought that looks the same: two estates built by one plan are
beside each other."""

COPY_AREA_IN_NOISE = 3.0
"""Objects of such ground have the areas of each other within so many ``area_deviation``."""


class Round(NamedTuple):
    """How far one round of a search looks: for these triangles, the cap on their hits, and poses of each lattice."""

    lookup: Lookup
    cap: int
    seeds: int
    prior: Prior | None = None
    """What is known besides what the lookup knows."""

    def mirrored(self) -> Round:
        """As far for the mirrored image."""
        return self._replace(lookup=self.lookup.mirrored())


def rounds(everything: Lookup) -> list[Round]:
    """Return a few triangles from all over the image, then all with caps that rise.

    By chance a map of more landmarks has more places that look like the image, of which more are tried where the first
    rounds brought nothing.
    """
    limits = everything.index.settings.limits
    some = everything.every(max(-(-len(everything.triangles) // limits.first_triangles), 1))
    more = round(limits.seeds * max(len(everything.index) / limits.landmarks_of_few_seeds, 1.0) ** 0.5)
    first, second, *others = limits.maximum_hits
    quick = [Round(some, first, limits.seeds), Round(everything, second, limits.seeds)]
    return quick + [Round(everything, cap, more) for cap in others]


def search(verifier: Verifier, query: SeenLandmarks, reach: Round) -> tuple[list[PoseEvidence], bool]:
    """Return the best few poses at different places, best first; and whether the search was capped."""
    found, seeds = level_poses(verifier, query, reach)
    return tilted_poses(verifier, query, found, seeds), seeds.capped


def level_poses(verifier: Verifier, query: SeenLandmarks, reach: Round) -> tuple[list[PoseEvidence], Seeds]:
    """Return the best few poses of a level camera at different places, best first; and the clusters they come from."""
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
            # The rough fit of few objects may have settled on wrong matches.
            poses.append(seed)
    for evidence in verify(verifier, telling, poses):
        found.add(evidence)
    return found.best_first, seeds


def _worth_a_trial(
    query: SeenLandmarks, centers: np.ndarray, turns: np.ndarray, scores: np.ndarray, limits: SearchLimits
) -> list[int]:
    """Return the roughly fitted poses that are verified, best first: of those at one place the best, none far below the best.

    Args:
        centers: (S,) complex, map units from the index's origin.
        turns: (S,) complex, heading and pixel size.
        scores: (S,) of the rough fits.
        limits: How many, and how far below.
    """
    chosen: list[int] = []
    tried: list[np.ndarray] = []
    best = 0.0
    for number in np.argsort(-scores, kind="stable").tolist():
        on_map = centers[number] + turns[number] * query.points
        if tried and (_distances(on_map, tried) < 2.0 * abs(turns[number])).any():
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
    """Return the best few poses with those of a camera that may be tilted, best first."""
    settings = verifier.index.settings
    if not level:
        return []
    strongest, telling = level[0], query.select(telling_objects(query, settings.limits.largest_objects))
    if _is_level(verifier, telling, strongest):
        return level
    found = Found(query, settings.decision, level)
    if strongest.log_odds > 0:
        focus = complex(telling.points[strongest.matched].mean()) if len(strongest.matched) else 0j
        tilted = verify_tilted(verifier, telling, strongest.pose, focus)
        found.add(tilted)
        if _is_as_good(tilted, strongest, settings.decision):
            return found.best_first
    if not _agrees(strongest, settings.decision):
        for number in range(min(settings.limits.tilted_verified, len(seeds.centers))):
            pose = Pose(complex(seeds.centers[number]), complex(seeds.turns[number]))
            found.add(verify_tilted(verifier, telling, pose, complex(seeds.focuses[number])))
    return found.best_first


class Found:
    """Poses of an image at different places: of those at one place the best stays.

    Attributes:
        poses: In the order in which they came.
    """

    def __init__(self, query: SeenLandmarks, decision: Decision, poses: Sequence[PoseEvidence] = ()) -> None:
        self._query, self._decision = query, decision
        self.poses = list(poses)
        self._on_map = [evidence.pose.on_map(query.points) for evidence in poses]

    @property
    def best_first(self) -> list[PoseEvidence]:
        """The poses, those of most log odds first."""
        return sorted(self.poses, key=lambda evidence: -evidence.log_odds)

    def knows(self, evidence: PoseEvidence) -> bool:
        """Return whether there is a pose at its place."""
        return bool(self._at_its_place(evidence, evidence.pose.on_map(self._query.points)).any())

    def add(self, evidence: PoseEvidence) -> None:
        """Take it in unless a better one is at its place; a tilted one must be clearly better."""
        on_map = evidence.pose.on_map(self._query.points)
        same = self._at_its_place(evidence, on_map)
        better = evidence.log_odds - (0 if evidence.pose.is_level else self._decision.tilted_margin)
        if all(better > self.poses[number].log_odds for number in np.flatnonzero(same)):
            others = np.flatnonzero(~same)
            self.poses = [*(self.poses[number] for number in others), evidence]
            self._on_map = [*(self._on_map[number] for number in others), on_map]

    def _at_its_place(self, evidence: PoseEvidence, on_map: np.ndarray) -> np.ndarray:
        """Return (k,) bool: poses that put the image's objects on the same spots, as far as their noise tells."""
        if not self.poses:
            return np.zeros(0, bool)
        noise = np.maximum([other.noise for other in self.poses], evidence.noise)
        size = abs(evidence.pose.turn)
        reach = np.maximum(SAME_PLACE_IN_NOISE * noise, 2.0 * size)
        of_tilt = SAME_TILTED_PLACE * self._query.diagonal * size
        is_tilted = [not (evidence.pose.is_level and other.pose.is_level) for other in self.poses]
        reach = np.where(is_tilted, np.maximum(reach, of_tilt), reach)
        return _distances(on_map, self._on_map) < reach


def _distances(on_map: np.ndarray, others: list[np.ndarray]) -> np.ndarray:
    """Return (k,) median distance on the map between an image's objects (n,) and the same at each of k other poses."""
    ordered = np.sort(np.abs(np.array(others) - on_map), axis=1)
    count = ordered.shape[1]
    return (ordered[:, (count - 1) // 2] + ordered[:, count // 2]) / 2


def _is_level(verifier: Verifier, telling: SeenLandmarks, evidence: PoseEvidence) -> bool:
    """Return whether a pose is evident, its noise no more than assumed, and its matches have no use for a tilted camera.

    A few of an image's landmarks may lie so near each other that no tilt shows.
    """
    decision = verifier.index.settings.decision
    if evidence.log_odds < decision.minimum_log_odds or evidence.noise_factor > 1:
        return False
    if len(evidence.matched) <= FEW_OBJECTS and not _agrees(evidence, decision):
        return False
    return gained_by_tilt(verifier, telling, evidence) < decision.tilted_margin


def _is_as_good(tilted: PoseEvidence, level: PoseEvidence, decision: Decision) -> bool:
    """Return whether a tilted pose needs no other: it is as good as a level one and no better, or explains the image."""
    if tilted.log_odds < max(level.log_odds - decision.tilted_slack, decision.minimum_log_odds):
        return False
    is_level = len(level.matched) > FEW_OBJECTS and tilted.log_odds < level.log_odds + decision.tilted_margin
    return is_level or _agrees(tilted, decision)


def _agrees(evidence: PoseEvidence, decision: Decision) -> bool:
    """Return whether a pose explains the image, so that no other camera needs a trial."""
    share = len(evidence.matched) / max(evidence.considered, 1)
    exact = evidence.noise_factor < decision.tilted_noise
    return evidence.log_odds >= decision.minimum_log_odds and exact and share > decision.tilted_share


def with_repeats(verifier: Verifier, query: SeenLandmarks, found: list[PoseEvidence]) -> list[PoseEvidence]:
    """Return the poses found, and the best one moved by the steps at which the map repeats itself there, best first."""
    return _with_moved(verifier, query, found, repeats(verifier, query, found[0]))


def with_copies(
    verifier: Verifier, query: SeenLandmarks, found: list[PoseEvidence], prior: Prior | None
) -> list[PoseEvidence]:
    """Return the poses found, and the best one moved to where the map around looks the same, best first.

    An image may have no triangle in common with its place, but by chance one with a copy of that, of two estates built
    by one plan.
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
    """Steps at which enough of the matched objects have another of their class, most frequent first."""
    index, settings = verifier.index, verifier.index.settings
    points, ranks = index.points[evidence.objects], index.ranks[evidence.objects]
    if len(points) < MINIMUM_OBJECTS:
        return []
    noise = evidence.noise
    steps = (points[:, None] - points[None])[ranks[:, None] == ranks[None]]
    longest = REPEAT_REACH * np.ptp(points.real)
    steps = steps[(np.abs(steps) > SAME_PLACE_IN_NOISE * noise) & (np.abs(steps) < longest)]
    cells = np.round(steps / (2 * noise))
    _, first, counts = np.unique(cells, return_index=True, return_counts=True)
    order = np.argsort(-counts, kind="stable")[: settings.limits.verified]
    return [complex(steps[first[k]]) for k in order if counts[k] >= REPEATED * len(points)]


def copies(verifier: Verifier, query: SeenLandmarks, evidence: PoseEvidence) -> list[complex]:
    """Steps at which enough of the matched objects have one of their class and area, most frequent first."""
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
    columns, rows = (np.rint(part / cell).astype(np.int64) for part in (steps.real, steps.imag))
    _, cells, counts = np.unique(columns * (np.ptp(rows) + 1) + rows, return_inverse=True, return_counts=True)
    enough = np.flatnonzero(counts >= REPEATED * len(points))
    most = enough[np.argsort(-counts[enough], kind="stable")[: settings.limits.verified]]
    return [complex(steps[cells == number].mean()) for number in most]
