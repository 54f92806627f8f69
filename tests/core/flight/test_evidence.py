from dataclasses import replace

import numpy as np
import pytest
from made_flights import FEW, FRAME

from semref.core.correlation import places
from semref.core.correlation.class_pyramid import MapPyramid
from semref.core.correlation.decision import risk_of_peaks, worth_of_outlines
from semref.core.correlation.refine import ScoredPose
from semref.core.correlation.settings import CORRELATION
from semref.core.flight.evidence import best_poses, log_ratios, prepare_image, random_poses, score_poses
from semref.core.flight.model import FlightImage
from semref.core.flight.tracker import APART
from semref.core.labels.class_shares import FULL, ClassShares
from semref.core.localization import CorrelationPeaks, Localization, Method, Place, Prior, Status, log_odds_of
from semref.core.simulation.views import View, cut


@pytest.fixture(scope="module")
def seen(flown, localizer):
    image = flown.images[2]
    return prepare_image(image, localizer.pyramid, image.prior, FEW)


@pytest.fixture(scope="module")
def truth(flown):
    view = flown.views[2]
    x, y = view.x - FRAME.origin[0], FRAME.origin[1] - view.y
    return ScoredPose(x, y, view.heading_deg, view.pixel_size)


def test_an_image_agrees_at_its_place_and_not_at_random_ones(seen, truth, localizer):
    beside = ScoredPose(truth.x + 12, truth.y - 9, truth.heading_deg + 3, truth.pixel_size_m)
    (here,) = score_poses(seen, localizer.pyramid, [beside])
    others = score_poses(seen, localizer.pyramid, random_poses(localizer.pyramid, seen.prior, 50))
    assert np.hypot(here.x - truth.x, here.y - truth.y) < 12
    worths = log_ratios(np.array([here.score, *(pose.score for pose in others)]), seen, FEW)
    assert worths[0] > 2 and np.median(worths[1:]) < -1
    assert worths.max() <= FEW.evidence_curve[3] and worths.min() >= FEW.evidence_curve[2]


def test_the_best_places_have_the_right_one_among_them_and_are_apart(seen, truth, localizer):
    found = best_poses(seen, localizer.pyramid, 20, APART)
    away = [np.hypot(pose.x - truth.x, pose.y - truth.y) for pose in found]
    assert min(away) < 25
    points = np.array([(pose.x, pose.y) for pose in found])
    gaps = np.hypot(*(points[:, None] - points).transpose(2, 0, 1))
    assert gaps[~np.eye(len(points), dtype=bool)].min() > 0.9 * APART * 288


def test_on_a_large_map_the_best_places_are_chosen_at_larger_pixels_first(seen, truth, localizer, monkeypatch):
    whole = localizer.pyramid
    large = MapPyramid(whole.labels, whole.frame, replace(CORRELATION, most_at_once=0))
    chosen = []
    choose = places._wide_peaks
    monkeypatch.setattr(places, "_wide_peaks", lambda *asked: chosen.append(asked) or choose(*asked))
    found = best_poses(seen, large, 20, APART)
    assert len(chosen) == 1
    assert min(np.hypot(pose.x - truth.x, pose.y - truth.y) for pose in found) < 25


def test_on_a_map_that_is_too_large_for_an_image_there_are_no_best_places(seen, localizer):
    whole = localizer.pyramid
    large = MapPyramid(whole.labels, whole.frame, replace(CORRELATION, most_at_once=0, most_comparisons=1))
    assert best_poses(seen, large, 20, APART) == []


def towns(rng):
    """Return (420, 480) uint8 labels of two towns, in which a quarter of the area is houses, in empty country."""
    labels = np.full(FRAME.shape_hw, 2, np.uint8)
    for top, left in ((40, 40), (280, 340)):
        houses = np.where(rng.random((25, 25)) < 0.25, 1, 2)
        labels[top : top + 100, left : left + 100] = np.kron(houses, np.ones((4, 4), int))
    return labels


def test_on_a_map_of_few_buildings_an_image_of_a_town_is_no_evidence_for_another_town():
    pyramid, rng = MapPyramid(towns(np.random.default_rng(1)), FRAME), np.random.default_rng(2)
    prior = Prior(pixel_size_range=(3.0, 5.0))
    ratios = []
    for number in range(8):
        here = FRAME.to_map(np.array([[90.0, 90.0]]))[0]
        image = cut(towns(np.random.default_rng(10 + number)), FRAME, View(*here, 0.0, 4.0, 80, 80))
        seen = prepare_image(FlightImage("a", image), pyramid, prior, FEW)
        elsewhere = [ScoredPose(*(4 * rng.uniform([360, 300], [420, 360])), 0.0, 4.0) for _ in range(20)]
        ratios += list(log_ratios(np.array([p.score for p in score_poses(seen, pyramid, elsewhere)]), seen, FEW))
    # A likelihood ratio is 1 on average where its place is wrong.
    assert np.mean(np.exp(ratios)) < 2


def test_an_image_of_one_class_is_no_evidence(localizer, flown):
    image = FlightImage("a", np.full((96, 96), 2, np.uint8))
    flat = prepare_image(image, localizer.pyramid, flown.images[0].prior, FEW)
    assert flat.evidence is None
    assert best_poses(flat, localizer.pyramid, 20, APART) == []


def test_outlines_of_overlapping_photos_do_not_add_up(flown, localizer):
    image = flown.images[2]
    alone = Localization(Status.NO_MATCH, Method.MAP_CORRELATION, best=Place(FRAME.origin, 0.0, 1.0), risk=1e-3)
    peaks = CorrelationPeaks(0.5, 0.3, 0.3, outlines=6.0)
    without = log_odds_of(alone.risk) - worth_of_outlines(6.0)
    for own, odds in ((alone, log_odds_of(alone.risk)), (replace(alone, peaks=peaks), without)):
        seen = prepare_image(replace(image, own=own), localizer.pyramid, image.prior, FEW)
        assert seen.own_odds == pytest.approx(odds)
    # Log odds are bounded: many outlines take nothing from what the labels show.
    labels = CorrelationPeaks(0.7, 0.3, 0.3, 20.0)
    many = replace(alone, risk=1e-12, peaks=replace(labels, outlines=30.0, runner_up_outlines=0.0))
    seen = prepare_image(replace(image, own=many), localizer.pyramid, image.prior, FEW)
    assert seen.own_odds == pytest.approx(log_odds_of(risk_of_peaks(labels)))


def test_shares_of_classes_are_compared_instead_of_the_labels(flown, localizer, truth):
    labels = flown.images[2].labels_hw
    values = np.arange(1, 6, dtype=np.uint8)
    shares = ClassShares(values, ((labels[..., None] == values) * FULL).astype(np.uint8))
    wrong = FlightImage("a", np.roll(labels, 48, 1), shares=shares)
    prior = flown.images[2].prior
    scores = []
    for image in (wrong, replace(wrong, shares=None)):
        seen = prepare_image(image, localizer.pyramid, prior, FEW)
        scores.append(score_poses(seen, localizer.pyramid, [truth])[0].score)
    assert scores[0] > 0.4 > scores[1] + 0.2
