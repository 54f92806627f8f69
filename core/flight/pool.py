"""Hypotheses for the pose of the latest image of a flight, each with the evidence of the last images.

See docs/explanation/method.md#flights.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..correlation.class_pyramid import EvidenceLevel, MapPyramid, mirror_level
from ..correlation.refine import ScoredPose
from ..localization import Prior
from .evidence import SeenImage, log_ratios, score_poses
from .motion import Link, LinkSource, as_rows
from .settings import FlightSettings
from .states import as_poses, as_states, turns_of, wrap_angle

OWN_MOST = 12.0
"""Largest ln odds of an image's own best place, so that the flight can outvote it."""

SAME_HEADING_DEG = 20.0
"""Hypotheses at one place with a larger difference of heading are different ones."""

OWN_NOISE = (0.01, 0.01, 0.01)
"""Standard deviations of an image's own best place: share of its edge, radians, ln pixel size."""

OWN_SHARE = 0.1
"""A hypothesis within this share of an image's edge, plus three standard deviations, is at the image's own place."""


@dataclass(frozen=True)
class Pool:
    """n hypotheses for the latest image, with evidence of W images.

    Attributes:
        states: (n, 4) float64: meters east and north of the map's upper left corner, heading in radians clockwise, ln
            pixel size.
        variances: (n, 3) float64: of the position along an axis, m², heading, ln pixel size.
        evidence: (n, W) float64: weighted ln of the likelihood ratio of each image, the latest last.
    """

    states: np.ndarray
    variances: np.ndarray
    evidence: np.ndarray

    @classmethod
    def empty(cls, window: int) -> Pool:
        """Return a pool without hypotheses for ``window`` images."""
        return cls(np.zeros((0, 4)), np.zeros((0, 3)), np.zeros((0, window)))

    def __len__(self) -> int:
        return len(self.states)

    @property
    def totals(self) -> np.ndarray:
        """(n,) sum of the evidence of all images of the window."""
        return self.evidence.sum(axis=1)

    def select(self, which: np.ndarray) -> Pool:
        """Return the hypotheses of a mask (n,) or of indices."""
        return Pool(self.states[which], self.variances[which], self.evidence[which])

    def append(self, other: Pool) -> Pool:
        """Return the hypotheses of this pool, then those of another one."""
        return Pool(*(np.concatenate(pair) for pair in zip(vars(self).values(), vars(other).values())))


def move_states(states: np.ndarray, link: Link, back: bool = False) -> np.ndarray:
    """Return (n, 4) states of the link's second image from those of the first; with ``back`` the reverse."""
    centers, turns = states[:, 0] + 1j * states[:, 1], turns_of(states)
    if back:
        turns = turns / link.ratio
    units = turns / np.abs(turns) if link.in_meters else turns
    centers = centers + (-1 if back else 1) * units * link.step
    turns = turns if back else turns * link.ratio
    return np.column_stack([centers.real, centers.imag, -np.angle(turns), np.log(np.abs(turns))])


def predict(pool: Pool, link: Link) -> Pool:
    """Return the hypotheses for the next image before any look at it, with larger variances and no evidence yet."""
    states, known = pool.states, np.array(link.covariance)
    unit = 1.0 if link.in_meters else np.exp(states[:, 3].copy())
    length = np.abs(link.step) * unit
    variances = pool.variances.copy()
    variances[:, 0] += length**2 * variances[:, 1] / 2 + np.trace(known[:2, :2]) / 2 * unit**2
    if not link.in_meters:
        variances[:, 0] += length**2 * variances[:, 2] / 2
    variances[:, 1] += known[2, 2]
    variances[:, 2] += known[3, 3]
    evidence = np.column_stack([pool.evidence[:, 1:], np.zeros(len(pool))])
    return Pool(move_states(states, link), variances, evidence)


def update(pool: Pool, seen: SeenImage, pyramid: MapPyramid, weight: float, settings: FlightSettings) -> Pool:
    """Return the hypotheses after a look at the image: refined to where it agrees, with its evidence.

    Args:
        pool: Predicted hypotheses.
        weight: Of its evidence, 0 to 1: less new ground gives less new evidence.
    """
    if not len(pool):
        return pool
    evidence, states, variances = pool.evidence.copy(), pool.states.copy(), pool.variances.copy()
    ratios = np.zeros(len(pool))
    if seen.evidence is not None:
        found = score_poses(seen, pyramid, as_poses(states))
        off = as_states(found) - states
        off[:, 2] = wrap_angle(off[:, 2])
        noise = look_noise(seen, states, settings.search_noise)
        total = variances + noise
        far = (off[:, :2] ** 2).sum(axis=1) / total[:, 0] + (off[:, 2:] ** 2 / total[:, 1:]).sum(axis=1)
        ratios = log_ratios(np.array([pose.score for pose in found]), seen, settings) - np.maximum(far - 4, 0) / 2
        ratios = np.maximum(ratios, settings.evidence_curve[2])
        gain = variances / total * np.clip(ratios / 2, 0, 1)[:, None]
        states += np.column_stack([gain[:, 0], gain]) * off
        variances -= gain * variances
    of_own = own_log_ratios(states, variances, seen, settings)
    evidence[:, -1] = weight * ratios + of_own
    if seen.own_state is not None:
        # A hypothesis that kept its drift would lose the next own places, and with them its track.
        near = of_own > 0
        gain = variances[near] / (variances[near] + own_noise(seen))
        off = seen.own_state - states[near]
        off[:, 2] = wrap_angle(off[:, 2])
        states[near] += np.column_stack([gain[:, 0], gain]) * off
        variances[near] *= 1 - gain
    return Pool(states, variances, evidence)


def own_noise(seen: SeenImage) -> np.ndarray:
    """Return (3,) variances of the image's own best place, as those of a pool."""
    size = 0.0 if seen.own_state is None else float(np.exp(seen.own_state[3]))
    return np.array(OWN_NOISE) ** 2 * ((seen.edge_px * size) ** 2, 1, 1)


def look_noise(seen: SeenImage, states: np.ndarray, deviations: tuple[float, float, float]) -> np.ndarray:
    """Return (n, 3) variances of a place from the first look; ``deviations``: its pixels, degrees, ln pixel size."""
    position, heading_deg, size = deviations
    pixel = 1.0 if seen.evidence is None else seen.evidence.pixel[0]
    noise = np.empty((len(states), 3))
    noise[:, 0] = (position * pixel * np.exp(states[:, 3].copy())) ** 2
    noise[:, 1:] = np.radians(heading_deg) ** 2, size**2
    return noise


def own_log_ratios(states: np.ndarray, variances: np.ndarray, seen: SeenImage, settings: FlightSettings) -> np.ndarray:
    """Return (n,) evidence that the image's own best place adds to hypotheses there; 0 for others and without one."""
    lead = own_lead(seen, settings)
    if seen.own_state is None or lead <= 0:
        return np.zeros(len(states))
    reach = OWN_SHARE * seen.edge_px * np.exp(seen.own_state[3]) + 3 * np.sqrt(variances[:, 0])
    return np.where(same_place(states, seen.own_state, reach), lead, 0.0)


def own_lead(seen: SeenImage, settings: FlightSettings) -> float:
    """Return the lead that corresponds to the error probability of the image's own place; ≤ 0 without such a place."""
    offset, slope = settings.risk_curve
    return (min(seen.own_odds, OWN_MOST) - offset) / slope if seen.own_odds > 0 else 0.0


def rival_of(track: Pool, rival: Pool, seen: SeenImage, weight: float, settings: FlightSettings) -> Pool:
    """Return the place of consecutive own fixes that contradict a track, with the evidence against the track.

    Fixes at one place add up. The class areas of an image that support the track count against them.

    Args:
        track: The track, then the hypothesis of the pool at its place, if there is one.
        rival: The place so far, predicted; empty without one.
        weight: Of its fix after another one at the same place; 0 without a fix.
    """
    support, evidence = float(track.evidence[-1, -1]), rival.evidence.copy()
    if seen.own_state is not None and weight > 0 and own_lead(seen, settings) > 0:
        at_own = own_log_ratios(track.states, track.variances, seen, settings) > 0
        if not at_own[0]:
            again = own_log_ratios(rival.states, rival.variances, seen, settings)
            if not again.any():
                evidence, weight = np.zeros((1, settings.window)), 1.0
            evidence[0, -1] = weight * own_lead(seen, settings)
            rival = Pool(seen.own_state[None], np.zeros((1, 3)), evidence)
            # Class areas that agree at the own fix do not support the track.
            support = 0.0 if at_own[-1] else support
    evidence[:, -1] -= support
    found = replace(rival, evidence=evidence)
    return found.select(found.totals > 0)


def new_pool(poses: Sequence[ScoredPose], seen: SeenImage, weight: float, settings: FlightSettings) -> Pool:
    """Return hypotheses at the best places of an image, with the evidence of this image only."""
    states = as_states(poses)
    variances = look_noise(seen, states, settings.search_noise)
    evidence = np.zeros((len(states), settings.window))
    ratios = log_ratios(np.array([pose.score for pose in poses]), seen, settings)
    evidence[:, -1] = weight * ratios + own_log_ratios(states, variances, seen, settings)
    return Pool(states, variances, evidence)


def with_past(pool: Pool, past: Sequence[Past], pyramid: MapPyramid, settings: FlightSettings) -> Pool:
    """Return new hypotheses with the evidence of the images before.

    Args:
        pool: For the latest image.
        past: Earlier images, the latest of them first.
    """
    evidence, states, variances = pool.evidence.copy(), pool.states, pool.variances
    for back, earlier in enumerate(past[: settings.window - 1], 2):
        seen, link, weight = earlier.seen, earlier.link, earlier.weight
        states = move_states(states, link, back=True)
        grown = replace(predict(Pool(states, variances, evidence), link), states=states, evidence=evidence)
        looked = update(grown, seen, pyramid, weight, settings)
        states, variances = looked.states, looked.variances
        evidence[:, -back] = looked.evidence[:, -1]
    return Pool(pool.states, pool.variances, evidence)


def prune(pool: Pool, edge_m: float, count: int, apart: float) -> Pool:
    """Return the best hypotheses, best first, without two at the same place.

    Args:
        edge_m: Edge of the image on the ground.
        apart: Least distance of two hypotheses, as a share of the edge.
    """
    order = np.argsort(-pool.totals, kind="stable")
    kept: list[int] = []
    for n in order:
        if len(kept) == count:
            break
        if not kept or not same_place(pool.states[kept], pool.states[n], apart * edge_m).any():
            kept.append(int(n))
    return pool.select(np.array(kept, int))


def same_place(states: np.ndarray, state: np.ndarray, reach_m: float | np.ndarray) -> np.ndarray:
    """Return (n,) bool: states at about the same place and heading as another one."""
    off = states - state
    near = np.hypot(off[:, 0], off[:, 1]) < reach_m
    return near & (np.abs(wrap_angle(off[:, 2])) < np.radians(SAME_HEADING_DEG))


@dataclass(frozen=True)
class Past:
    """An earlier image of the window.

    Attributes:
        link: To the next image.
        weight: Of its evidence.
    """

    seen: SeenImage
    link: Link
    weight: float

    def mirrored(self) -> Past:
        """Return the image with left and right exchanged, without the prior position, which can't be right then.

        The heading is mirrored like the turns of the links, so that the opponent has as many headings as the flight.
        """
        evidence = None if self.seen.evidence is None else mirror_level(self.seen.evidence)
        known = self.seen.prior
        heading = None if known.heading_deg is None else -known.heading_deg % 360
        prior = replace(known, position=None, radius=None, heading_deg=heading)
        seen = SeenImage(evidence, self.seen.edge_px, self.seen.chance, prior)
        return Past(seen, self.link.mirrored(), self.weight)


NOWHERE = Link(0, 1, (0.0, 0.0), 0.0, 0.0, as_rows(np.eye(4)))
"""Placeholder for the link of the latest image."""


def pack(past: Past) -> dict[str, np.ndarray]:
    """Return an image of the window as arrays by name."""
    seen, link = past.seen, past.link
    arrays = {
        "numbers": np.array([seen.edge_px, *seen.chance, seen.own_odds, past.weight]),
        "sizes": np.array(seen.prior.pixel_size_range or ()),
        "heading": np.array([] if seen.prior.heading_deg is None else [seen.prior.heading_deg]),
        "heading_range": np.array([seen.prior.heading_range_deg]),
        "link": np.array(
            [link.first, link.second, *link.translation, link.turn, link.log_scale, link.in_meters], np.float64
        ),
        "link_covariance": np.array(link.covariance),
        "link_source": np.array(list(LinkSource).index(link.source)),
        "own": np.array([]) if seen.own_state is None else seen.own_state,
    }
    if seen.prior.position is not None and seen.prior.radius is not None:
        arrays["position"] = np.array([*seen.prior.position, seen.prior.radius])
    if seen.evidence is not None:
        arrays.update(evidence=seen.evidence.evidence, known=seen.evidence.known, pixel=np.array(seen.evidence.pixel))
    return arrays


def unpack(arrays: Mapping[str, np.ndarray]) -> Past:
    """Return an image of the window from its arrays, as of ``pack``."""
    edge_px, mean, spread, own_odds, weight = arrays["numbers"].tolist()
    first, second, right, down, turn, log_scale, in_meters = arrays["link"].tolist()
    source, known = list(LinkSource)[int(arrays["link_source"])], as_rows(arrays["link_covariance"])
    link = Link(int(first), int(second), (right, down), turn, log_scale, known, source, bool(in_meters))
    evidence = None
    if "evidence" in arrays:
        evidence = EvidenceLevel(arrays["evidence"], arrays["known"], tuple(arrays["pixel"].tolist()))
    place = arrays["position"].tolist() if "position" in arrays else None
    heading, sizes = arrays["heading"].tolist(), arrays["sizes"].tolist()
    prior = Prior(
        None if place is None else (place[0], place[1]),
        None if place is None else place[2],
        heading[0] if heading else None,
        float(arrays["heading_range"][0]),
        (sizes[0], sizes[1]) if sizes else None,
    )
    own = arrays["own"] if len(arrays["own"]) else None
    return Past(SeenImage(evidence, edge_px, (mean, spread), prior, own, own_odds), link, weight)
