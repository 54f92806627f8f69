import numpy as np
import pytest

from semref.core.constellation import search, verification
from semref.core.constellation.index import build_index
from semref.core.constellation.settings import CONSTELLATION
from semref.core.constellation.verification import PoseEvidence
from semref.core.database.model import MapLandmarks
from semref.core.geometry.pose import Pose
from semref.core.localization import Prior

EDGE = 640
SEEN = (900.0, 1100.0, 70.0, 1.1)
"""East and north of the origin, heading and pixel size of a cut."""
STEP = (900.0, 40.0)


def evidence_at(pose, log_odds=100.0, count=10, considered=12, noise_factor=1.0, deviation=1.0):
    matched, deviations = np.arange(count), np.full(count, deviation)
    return PoseEvidence(pose, log_odds, matched, matched, deviations, noise_factor, matched, np.arange(considered))


LEVEL = Pose(100 + 50j, 1 + 0j)
TILTED = Pose(100 + 50j, 1 + 0j, 0.001 + 0j)


def test_of_poses_at_one_place_the_best_stays_and_a_tilted_one_must_be_clearly_better(cut):
    query = cut(*SEEN).query
    far = evidence_at(Pose(LEVEL.center + 500, LEVEL.turn), 40.0)
    level, better = evidence_at(LEVEL, 100.0), evidence_at(LEVEL, 101.0)
    found = search.Found(query, CONSTELLATION.decision)
    for one, left in ((level, [level]), (far, [level, far]), (better, [far, better]), (level, [far, better])):
        found.add(one)
        assert [id(pose) for pose in found.poses] == [id(pose) for pose in left]
    assert [id(pose) for pose in found.best_first] == [id(better), id(far)]
    hardly, clearly = (evidence_at(TILTED, 101.0 + CONSTELLATION.decision.tilted_margin + more) for more in (0, 0.1))
    found.add(hardly)
    assert found.poses[-1] is better
    found.add(clearly)
    assert found.poses[-1] is clearly and len(found.poses) == 2


@pytest.fixture(scope="module")
def built_twice(catalogue):
    """Return an index with most of the catalogue's middle repeated 900 m east, with other ground around it."""
    rng = np.random.default_rng(6)
    away = catalogue.positions - catalogue.positions.mean(axis=0)
    again = (np.abs(away).max(axis=1) < 450) & (rng.uniform(size=len(away)) < 0.8)
    moved = catalogue.positions[again] + STEP + rng.normal(0, 1.5, (again.sum(), 2))
    others = catalogue.positions[~again] + STEP + rng.normal(0, 60, ((~again).sum(), 2))
    positions = np.concatenate([catalogue.positions, moved, others])
    classes = np.concatenate([catalogue.classes, catalogue.classes[again], catalogue.classes[~again]])
    areas = np.concatenate([catalogue.areas_m2, catalogue.areas_m2[again], catalogue.areas_m2[~again]])
    return build_index(MapLandmarks(positions, classes, areas, np.zeros(len(positions), bool)), 1.0)


def test_before_a_fix_ground_around_it_that_looks_the_same_is_tried_unless_a_prior_excludes_it(built_twice, index, cut):
    made = cut(1000.0, 1000.0, 30.0, 1.0)
    query, here = made.query, made.pose.center + index.origin - built_twice.origin
    verifier = verification.Verifier(built_twice, EDGE, EDGE, 60.0)
    telling = query.select(verification.telling_objects(query, CONSTELLATION.limits.largest_objects))
    (copy,) = verification.verify(verifier, telling, [Pose(here + complex(*STEP), made.pose.turn)])
    assert copy.log_odds > 100 and len(copy.matched) > 20
    best, other = search.with_copies(verifier, query, [copy], None)[:2]
    assert abs(best.pose.center - here) < 0.5 and other is copy
    assert best.log_odds > copy.log_odds + 20
    there = copy.pose.center + built_twice.origin
    prior = Prior(position=(there.real, there.imag), radius=300.0)
    assert search.with_copies(verifier, query, [copy], prior) == [copy]


def test_unique_ground_has_no_copies(index, cut):
    made = cut(1000.0, 1000.0, 30.0, 1.0)
    verifier = verification.Verifier(index, EDGE, EDGE, 60.0)
    (evidence,) = verification.verify(verifier, made.query, [made.pose])
    assert len(evidence.matched) > 20
    assert search.copies(verifier, made.query, evidence) == []
