"""Constellation: find an image's position from its landmarks as from stars, or give a reason for no position.

See docs/explanation/method.md#constellation.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..geometry.error_settings import SharedErrors
from ..geometry.pose import Pose, PoseCovariance, heading_of, image_points, turn_of
from ..geometry.shared_errors import LANDMARKS, VIEW, MatchedPoints, refined_pose
from ..landmarks.landmarks import Landmarks
from ..localization import (
    IMAGE_PARTS,
    LEAST_RISK,
    RISK,
    Localization,
    Matches,
    Method,
    Place,
    Prior,
    Status,
    too_few_landmarks,
)
from ..sentences import Sentence
from .decision import Opponents, may_be_a_fix, risk_against, risk_of_best, verdict
from .hypotheses import MINIMUM_OBJECTS, SeenLandmarks, query_triangles
from .index import ConstellationIndex, full_area
from .lookup import Lookup
from .parts import Agreement, Side, empty_side, uneven_side
from .search import (
    SAME_TILTED_PLACE,
    Found,
    Round,
    level_poses,
    rounds,
    search,
    tilted_poses,
    with_copies,
    with_repeats,
)
from .settings import ConstellationSettings
from .verification import MINIMUM_MATCHES, PoseEvidence, Verifier, telling_objects, verify, verify_tilted

SIDE_PIXEL_SIZES = 1.11
"""Largest ratio of pixel sizes between two parts of an image from one camera."""


def localize(  # noqa: PLR0913 - the image, the map, the prior and the settings
    objects: Landmarks,
    size_wh: tuple[float, float],
    index: ConstellationIndex,
    prior: Prior | None = None,
    minimum_area_px: float | None = None,
    allowed_risk: float = RISK,
    errors: SharedErrors | None = None,
    view: np.ndarray | None = None,
) -> Localization:
    """Return position, heading and pixel size of an image from its landmarks, or the reason for no fix. Deterministic.

    Args:
        objects: Landmarks of the whole image.
        size_wh: (width, height) of the image, pixels.
        minimum_area_px: Minimum contour area of the extracted landmarks; by default that of the smallest one.
        errors: Prior knowledge of errors that landmarks share; defaults without it.
        view: As in ``Verifier``.
    """
    settings = index.settings
    query = make_query(objects, index, size_wh)
    count = query.usable_count
    if count < MINIMUM_OBJECTS:
        return _too_few(count, index, False)
    smallest = minimum_area_px if minimum_area_px is not None else float(objects.areas_px.min())
    verifier = Verifier(index, *size_wh, float(full_area(smallest, 1.0)), view=view)
    searched = _search_for(query, verifier, prior, allowed_risk, errors or SharedErrors())
    decided = _decide(objects, query, verifier, searched, allowed_risk)
    if decided.best is None or not decided.is_fix:
        return decided
    best = searched.found[0]
    of_image = _agreement(query, best, settings)
    side = uneven_side(of_image, query.diagonal, settings.decision)
    other = None if side is None else _other_place(query, verifier, best, side)
    if other is None:
        return replace(decided, reason=_remark(of_image, _agreement_of_map(index, best), query.diagonal, settings))
    places = decided.best, _place(index, other, other.pose)
    reason = Sentence("Landmarks agree with the map on one side of the image only; the image may show two places.")
    return replace(decided, status=Status.AMBIGUOUS, reason=reason, confidence=None, alternatives=places)


def matches_at(
    objects: Landmarks, size_wh: tuple[float, float], index: ConstellationIndex, place: Place
) -> Matches | None:
    """Return the landmarks that agree with the map at a candidate of another method, as verified here.

    Args:
        objects: Landmarks of the whole image, at least one.
        size_wh: (width, height) of the image, pixels.
        place: The candidate, with heading and pixel size.

    Returns:
        None if no more agree than by chance.
    """
    settings = index.settings
    query = make_query(objects, index, size_wh)
    telling = query.select(telling_objects(query, settings.limits.largest_objects))
    if len(telling.points) < MINIMUM_MATCHES:
        return None
    verifier = Verifier(index, *size_wh, float(full_area(objects.areas_px.min(), 1.0)))
    pose = Pose(complex(*place.position) - index.origin, turn_of(*place.oriented))
    (evidence,) = verify(verifier, telling, [pose])
    if len(evidence.matched):
        focus = complex(telling.points[evidence.matched].mean())
        (tilted,) = verify_tilted(verifier, telling, [pose], [focus])
        evidence = tilted if tilted.log_odds > evidence.log_odds + settings.decision.tilted_margin else evidence
    return _matches(objects, query, index, evidence) if evidence.log_odds > 0 else None


def make_query(objects: Landmarks, index: ConstellationIndex, size_wh: tuple[float, float]) -> SeenLandmarks:
    """Return an image's landmarks in the form for localization; ``size_wh``: (width, height) of the image, pixels."""
    points = image_points(objects.centers_xy, *size_wh)
    log_areas = np.log(full_area(np.asarray(objects.areas_px, np.float64), 1.0))
    whole = ~np.asarray(objects.touches_edge, bool)
    return SeenLandmarks(points, index.rank_of(objects.classes), log_areas, whole, float(np.hypot(*size_wh)))


def _search_for(
    query: SeenLandmarks, verifier: Verifier, prior: Prior | None, allowed_risk: float, errors: SharedErrors
) -> _Searched:
    """Search round by round, until a candidate is a fix or no round is left."""
    index, settings = verifier.index, verifier.index.settings
    searched = _Searched([], [], False, errors)
    last = len(settings.limits.maximum_hits) - 1
    for number, reach in enumerate(rounds(index, query, prior)):
        if number > 2 and not searched.capped:
            break
        latest, capped = search(verifier, query, reach)
        known = Found(query, settings.decision, searched.found)
        for evidence in latest:
            known.add(evidence)
        searched = replace(searched, found=known.best_first, decoys=[], capped=capped)
        if not searched.found or searched.found[0].log_odds <= 0:
            continue
        searched = replace(searched, found=with_repeats(verifier, query, searched.found))
        is_last = number == last or number > 1 and not capped
        if is_last or may_be_a_fix(searched.opponents(index), allowed_risk, settings.decision):
            searched = replace(searched, decoys=_decoys(verifier, query, reach, searched))
            if risk_of_best(searched.opponents(index), settings.decision) <= allowed_risk:
                searched = replace(searched, found=with_copies(verifier, query, searched.found, prior))
                break
    return searched


def _decoys(verifier: Verifier, query: SeenLandmarks, reach: Round, searched: _Searched) -> list[PoseEvidence]:
    """Return the best few poses of the mirrored image, best first; of tilted cameras only where they could count."""
    mirrored, settings = query.mirrored(), verifier.index.settings
    level, seeds = level_poses(verifier, mirrored, reach.mirrored())
    opponents = replace(searched, decoys=level).opponents(verifier.index)
    strongest = opponents.strongest + settings.decision.tilted_slack
    if risk_against(opponents, strongest, settings.decision) <= LEAST_RISK:
        return level
    return tilted_poses(verifier, mirrored, level, seeds)


@dataclass(frozen=True)
class _Searched:
    """Poses of the image and of its mirror, each best first; ``capped``: the search omitted some."""

    found: list[PoseEvidence]
    decoys: list[PoseEvidence]
    capped: bool
    errors: SharedErrors

    def opponents(self, index: ConstellationIndex) -> Opponents:
        """Return the best candidate, and what it is compared with."""
        runner_up = max((other.log_odds for other in self.found[1:]), default=-np.inf)
        mirror = float(max(self.decoys[0].log_odds, 0.0)) if self.decoys else 0.0
        return Opponents(self.found[0].log_odds, float(runner_up), mirror, len(index), self.capped)


def _decide(
    objects: Landmarks, query: SeenLandmarks, verifier: Verifier, searched: _Searched, allowed_risk: float
) -> Localization:
    index, found, capped = verifier.index, searched.found, searched.capped
    count, settings = query.usable_count, index.settings
    if not found:
        nothing = Sentence("No place on the map has triangles of landmarks like the image's.")
        return Localization(Status.NO_MATCH, Method.CONSTELLATION, count, nothing, search_capped=capped)
    best = found[0]
    pose, covariance = _refined(index, query, best, searched.errors)
    opponents = searched.opponents(index)
    rivals = [other for other in found[1:] if risk_against(opponents, other.log_odds, settings.decision) > allowed_risk]
    status, reason = verdict(opponents, len(rivals), allowed_risk, settings.decision)
    if status is Status.NO_MATCH and count < objects_needed(index):
        status, reason = Status.TOO_FEW_REFERENCES, _too_few(count, index, capped).reason
    # Uncertainty from the image itself; an inaccurate map makes no candidate doubtful.
    open_m = None if covariance is None else float(np.hypot(covariance.part(LANDMARKS), covariance.part(VIEW)))
    flaw = _flaw(verifier, query, best, open_m)
    if status is Status.FIX and flaw is not None:
        status, reason = flaw
    places = (_place(index, best, pose), *(_place(index, evidence, evidence.pose) for evidence in rivals))
    risk = risk_of_best(opponents, settings.decision)
    return Localization(
        status,
        Method.CONSTELLATION,
        count,
        reason,
        best=places[0],
        confidence=1 - risk if status is Status.FIX else None,
        risk=risk,
        is_doubted=status is not Status.FIX and flaw is None,
        alternatives=places if status is Status.AMBIGUOUS else (),
        error_95_m=None if covariance is None else covariance.radius_95,
        covariance=covariance,
        matches=_matches(objects, query, index, best),
        search_capped=capped,
        mirror_log_odds=opponents.mirror,
        runner_up_log_odds=opponents.runner_up,
    )


def _flaw(
    verifier: Verifier, query: SeenLandmarks, best: PoseEvidence, error_95: float | None
) -> tuple[Status, Sentence] | None:
    """Return status and reason of a candidate that is never a fix: it shows two places, or is too inaccurate."""
    index, settings = verifier.index, verifier.index.settings
    of_image = _agreement(query, best, settings)
    if empty_side(of_image, _agreement_of_map(index, best), query.diagonal, settings.decision) is not None:
        return Status.AMBIGUOUS, Sentence(
            "Landmarks agree with the map on one side of the image only; the image may show two places."
        )
    if error_95 is None or error_95 > settings.decision.largest_error * query.diagonal * abs(best.pose.turn):
        return Status.NO_MATCH, Sentence(
            "The landmarks that agree with the map do not determine the position closely enough."
        )
    return None


def _agreement(query: SeenLandmarks, evidence: PoseEvidence, settings: ConstellationSettings) -> Agreement:
    """Return which of the image's landmarks that could be on the map agree with it."""
    telling = telling_objects(query, settings.limits.largest_objects)
    return Agreement(query.points[telling[evidence.possible]], np.isin(evidence.possible, evidence.matched))


def _agreement_of_map(index: ConstellationIndex, evidence: PoseEvidence) -> Agreement:
    """Return which of the map's landmarks that the image should show agree with it."""
    points = evidence.pose.in_image(index.points[evidence.expected])
    return Agreement(points, np.isin(evidence.expected, evidence.objects))


def _other_place(query: SeenLandmarks, verifier: Verifier, best: PoseEvidence, side: Side) -> PoseEvidence | None:
    """Return another place of the disagreeing landmarks on one side, or None.

    One camera most likely took both: at about the same pixel size, less evidence is enough.
    """
    index, settings = verifier.index, verifier.index.settings
    telling = telling_objects(query, settings.limits.largest_objects)
    others = query.select(np.setdiff1d(telling[best.possible], telling[best.matched]))
    others = others.select(np.flatnonzero(side.contains(others.points)))
    thorough = replace(settings.limits, verified=settings.limits.side_verified, rough_share=0.0)
    there = replace(verifier, index=replace(index, settings=replace(settings, limits=thorough)), side=side)
    anywhere = Lookup(there.index, others, query_triangles(others, settings, settings.limits.anchors[0]), None)
    reach = Round(anywhere, settings.limits.maximum_hits[1], settings.limits.thorough_seeds)
    size, ratio = abs(best.pose.turn), SIDE_PIXEL_SIZES
    same_camera = Prior(pixel_size_range=(size / ratio, size * ratio))
    for prior, least in ((same_camera, settings.decision.side_log_odds), (None, settings.decision.minimum_log_odds)):
        found, seeds = level_poses(there, others, reach._replace(prior=prior))
        if found and (found[0].log_odds > 0 or not best.pose.is_level):
            found = tilted_poses(there, others, found, seeds)
        if found and found[0].log_odds >= least:
            moved = float(np.median(np.abs(found[0].pose.on_map(others.points) - best.pose.on_map(others.points))))
            # If it moves less, it is the same ground, seen by a tilted camera or a lens that no pose describes.
            return found[0] if moved > SAME_TILTED_PLACE * query.diagonal * size else None
    return None


def _remark(
    of_image: Agreement, of_map: Agreement, diagonal: float, settings: ConstellationSettings
) -> Sentence | None:
    """Return the part that a fix is not valid for: a side where hardly any landmarks agree, without another place."""
    unknown, unseen = (_counts_of_side(seen, diagonal, settings) for seen in (of_image, of_map))
    if unknown:
        return Sentence(
            "In the {part} of the image only {agree} of {count} landmarks agree with the map. They may be new, outside "
            "the map, or at another place. The position is valid for the rest of the image.",
            **unknown,
        )
    if unseen:
        return Sentence(
            "In the {part} of the image only {agree} of {count} landmarks of the map are visible. They may be hidden "
            "or changed, or it is another place. The position is valid for the rest of the image.",
            **unseen,
        )
    return None


def _counts_of_side(seen: Agreement, diagonal: float, settings: ConstellationSettings) -> dict[str, object]:
    """Return part, agreeing landmarks and all landmarks on the side where hardly any agree; empty without one."""
    side = uneven_side(seen, diagonal, settings.decision)
    if side is None:
        return {}
    held = side.contains(seen.points)
    right, up = side.direction.real, side.direction.imag
    across, along = "right" if right > 0 else "left", "upper" if up > 0 else "lower"
    part = IMAGE_PARTS[across if abs(right) >= abs(up) else along]
    return {"part": part, "agree": int(seen.agree[held].sum()), "count": int(held.sum())}


def _place(index: ConstellationIndex, evidence: PoseEvidence, pose: Pose) -> Place:
    position, turn = pose.center + index.origin, pose.turn
    return Place(
        (float(position.real), float(position.imag)),
        heading_of(turn),
        float(abs(turn)),
        evidence.log_odds,
        len(evidence.matched),
    )


def _matched(query: SeenLandmarks, evidence: PoseEvidence, settings: ConstellationSettings) -> np.ndarray:
    """Return (m,) indices of the matched ones among all landmarks of the image."""
    return telling_objects(query, settings.limits.largest_objects)[evidence.matched]


def _matches(objects: Landmarks, query: SeenLandmarks, index: ConstellationIndex, evidence: PoseEvidence) -> Matches:
    matched = _matched(query, evidence, index.settings)
    seen = evidence.pose.on_map(query.points[matched])
    residuals = np.abs(seen - index.points[evidence.objects])
    seen = seen + index.origin
    return Matches(evidence.objects, objects.centers_xy[matched], np.column_stack([seen.real, seen.imag]), residuals)


def _refined(
    index: ConstellationIndex, query: SeenLandmarks, evidence: PoseEvidence, errors: SharedErrors
) -> tuple[Pose, PoseCovariance | None]:
    """Return the pose with shared errors considered, and its covariance; None with too few matches."""
    if len(evidence.matched) < 3:
        return evidence.pose, None
    points = query.points[_matched(query, evidence, index.settings)]
    classes = index.class_values[index.ranks[evidence.objects]]
    on_map = index.points[evidence.objects]
    matched = MatchedPoints(points, on_map, evidence.deviations, classes, query.diagonal)
    return refined_pose(matched, evidence.pose, errors)


def objects_needed(index: ConstellationIndex) -> int:
    """Return how many landmarks an image needs for a fix on this map, if all are on the map and noise is small."""
    settings = index.settings
    if not len(index):
        return MINIMUM_OBJECTS
    deviation = 0.1 * np.exp(np.median(index.log_areas) / 2)
    each = np.log(0.6 / (2 * np.pi * deviation**2 * np.median(index.densities)))
    return 3 + int(np.ceil(settings.decision.minimum_log_odds / max(float(each), 1.0)))


def _too_few(count: int, index: ConstellationIndex, capped: bool) -> Localization:
    reason = too_few_landmarks(count, max(objects_needed(index) - count, 1), whole=True)
    return Localization(Status.TOO_FEW_REFERENCES, Method.CONSTELLATION, count, reason, search_capped=capped)
