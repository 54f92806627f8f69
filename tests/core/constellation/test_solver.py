import dataclasses

import numpy as np
import pytest
from made_town import NOISE, ORIGIN, PRIOR, SIZE, Ground, error, seen_from, solve, town

from semref.core.constellation import search
from semref.core.constellation.hypotheses import query_triangles
from semref.core.constellation.index import build_index
from semref.core.constellation.lookup import Lookup, find_seeds
from semref.core.constellation.settings import CONSTELLATION
from semref.core.constellation.solver import localize, make_query, matches_at
from semref.core.constellation.verification import Verifier, verify_tilted, weigh_all
from semref.core.database.model import MapLandmarks
from semref.core.geometry.pose import Pose
from semref.core.landmarks.landmarks import Landmarks
from semref.core.localization import Place, Prior, Status


@pytest.fixture(scope="module")
def ground():
    return Ground(town(7))


def points_as_objects(centers, classes=None, areas=None):
    count = len(centers)
    return Landmarks(
        np.asarray(centers, float).reshape(-1, 2),
        np.ones(count, np.uint8) if classes is None else classes,
        np.full(count, 200.0) if areas is None else areas,
        np.zeros((count, 4), np.int64),
        np.zeros(count, bool),
    )


@pytest.mark.parametrize("count", [0, 1, 3])
def test_too_few_objects_are_counted_with_those_needed(ground, count):
    result = solve(ground, points_as_objects(np.random.default_rng(0).uniform(50, 600, (count, 2))))
    assert result.status == Status.TOO_FEW_REFERENCES
    assert f"shows {count} whole" in str(result.reason) and "more are needed" in str(result.reason)


def test_an_empty_catalogue_gives_no_fix(ground):
    empty = MapLandmarks(np.empty((0, 2)), np.empty(0, np.uint8), np.empty(0), np.empty(0, bool))
    result = localize(ground.see(seen_from(1500, 1500)), (SIZE, SIZE), build_index(empty, 1.0), PRIOR)
    assert result.status != Status.FIX


@pytest.mark.parametrize(("share", "counts"), [(1.0, True), (0.1, False)])
def test_objects_smaller_than_any_of_the_catalogue_are_no_evidence(ground, share, counts):
    view = seen_from(1500, 1500)
    right = ground.see(view)
    small = dataclasses.replace(right, areas_px=share * ground.index.minimum_area_m2 * np.ones(len(right)))
    query = make_query(small, ground.index, (SIZE, SIZE))
    center = complex(*view.position) + complex(*ORIGIN) - ground.index.origin
    verifier, pose = Verifier(ground.index, SIZE, SIZE, 1.0), Pose(center, 1 + 0j)
    (evidence,) = weigh_all(verifier, query, [pose], np.ones(1))
    assert (len(evidence.matched) > 0, evidence.considered > 0) == (counts, counts)
    assert counts or evidence.log_odds <= 0


@pytest.mark.slow
@pytest.mark.parametrize("heading", [0.0, 33.3, 90.0, 201.7, 359.0])
@pytest.mark.parametrize("scale", [0.75, 1.0, 1.6])
def test_a_clean_view_is_found_exactly_at_any_heading_and_scale(ground, heading, scale):
    view = seen_from(1400.3, 1610.8, heading, scale)
    result = solve(ground, ground.see(view))
    assert result.status == Status.FIX, result.reason
    assert error(result, view) < 0.5
    assert abs((result.best.heading_deg - heading + 180) % 360 - 180) < 0.1
    assert result.best.pixel_size_m == pytest.approx(scale, rel=0.002)


@pytest.mark.slow
def test_most_noisy_views_are_found_and_no_fix_is_wrong(ground):
    rng = np.random.default_rng(3)
    fixes = []
    for seed in range(25):
        view = seen_from(*rng.uniform(700, 2300, 2), rng.uniform(0, 360), rng.uniform(0.8, 1.25))
        result = solve(ground, ground.see(view, NOISE, seed))
        if result.status == Status.FIX:
            fixes.append((error(result, view), result.covariance.ellipse_95))
    assert len(fixes) >= 23
    assert max(off for off, _ in fixes) < 10
    # The 95 % ellipse has the right size or is too large: the assumed map accuracy is worse than the real one.
    ratios = np.array([off / np.hypot(u.semi_major, u.semi_minor) * np.sqrt(2) for off, u in fixes])
    assert 0.1 < np.median(ratios) < 0.9
    assert (ratios <= 1.3).mean() >= 0.8


def test_a_mirrored_view_and_one_of_another_town_get_no_fix(ground):
    other = Ground(town(8))
    for center in ((1400, 1600), (1000, 2000), (2000, 900)):
        seen = ground.see(seen_from(*center, 77.0))
        mirrored = dataclasses.replace(seen, centers_xy=np.abs((SIZE, 0) - seen.centers_xy))
        assert solve(ground, mirrored).status != Status.FIX
        result = solve(ground, other.see(seen_from(*center, 10.0)))
        assert result.status in (Status.NO_MATCH, Status.TOO_FEW_REFERENCES) and result.reason


@pytest.fixture
def tried_tilted(monkeypatch):
    """Record the number of landmarks of each trial with a tilted camera."""
    tried = []

    def verify(verifier, query, poses, focuses):
        tried.extend([len(query.points)] * len(poses))
        return verify_tilted(verifier, query, poses, focuses)

    monkeypatch.setattr(search, "verify_tilted", verify)
    return tried


def test_a_tilted_camera_is_tried_for_the_mirror_only_where_it_could_change_the_risk(ground, tried_tilted):
    counts, found = [], []
    for slack in (CONSTELLATION.decision.tilted_slack, 1e9):
        decision = dataclasses.replace(CONSTELLATION.decision, tilted_slack=slack)
        settings = dataclasses.replace(CONSTELLATION, decision=decision)
        index = dataclasses.replace(ground.index, settings=settings)
        objects = ground.see(seen_from(1400, 1600, 77.0), NOISE)
        tried_tilted.clear()
        found.append(localize(objects, (SIZE, SIZE), index, PRIOR))
        counts.append(len(tried_tilted))
    assert counts[0] <= 1 < counts[1]
    assert found[0].is_fix and found[0].confidence == found[1].confidence and found[0].best == found[1].best


@pytest.mark.parametrize(("tilt", "trials"), [(0.0, 0), (3.0, 1), (8.0, 1)])
def test_a_tilted_camera_is_tried_once_where_a_level_one_does_not_explain_the_image(ground, tried_tilted, tilt, trials):
    view = dataclasses.replace(seen_from(1400, 1600, 77.0), tilt_deg=tilt, tilt_direction_deg=40.0)
    found = solve(ground, ground.see(view))
    assert found.is_fix and error(found, view) < 3 and len(tried_tilted) == trials


@pytest.mark.slow
def test_a_regular_lattice_of_plots_gets_no_fix_on_its_own_map():
    labels = np.zeros((2400, 2400), np.uint8)
    for top in range(20, 2380, 60):
        for left in range(20, 2380, 60):
            labels[top : top + 14, left : left + 14] = 1
    plots = Ground(labels)
    for view in (seen_from(1200, 1200), seen_from(1000.5, 1300.2, 31.0, 1.1)):
        assert solve(plots, plots.see(view)).status in (Status.AMBIGUOUS, Status.NO_MATCH)


def test_two_places_that_are_alike_are_named_as_alternatives_and_a_prior_distinguishes_them():
    piece = town(9, 1200, 500)
    twins = Ground(np.hstack([piece, np.zeros((1200, 200), np.uint8), piece]))
    result = solve(twins, twins.see(seen_from(600, 600, 20.0)))
    assert result.status == Status.AMBIGUOUS and len(result.alternatives) == 2
    assert abs(result.alternatives[1].position[0] - result.best.position[0]) == pytest.approx(1400, abs=1)
    view = seen_from(2000, 600, 20.0)
    prior = dataclasses.replace(PRIOR, position=(ORIGIN[0] + 2100, ORIGIN[1] - 550), radius=300.0)
    result = solve(twins, twins.see(view), prior)
    assert result.status == Status.FIX and error(result, view) < 1


ELSEWHERE = {"position": (ORIGIN[0] + 300, ORIGIN[1] - 300), "radius": 200.0}


@pytest.mark.parametrize(
    "wrong", [ELSEWHERE, {"heading_deg": 200.0, "heading_range_deg": 20.0}, {"pixel_size_range": (1.5, 2.5)}]
)
def test_a_prior_that_excludes_the_truth_gives_no_fix(ground, wrong):
    view = seen_from(1800, 1700, 45.0)
    assert solve(ground, ground.see(view), dataclasses.replace(PRIOR, **wrong)).status != Status.FIX


def test_matches_name_objects_of_the_image_and_of_the_map(ground):
    view = seen_from(1500, 1300, 0.0)
    objects = ground.see(view)
    matches = solve(ground, objects).matches
    assert len(matches) >= 20
    seen = matches.pixels_xy + (view.x - SIZE / 2, -view.y - SIZE / 2)
    np.testing.assert_allclose(seen, ground.objects.centers_xy[matches.on_map], atol=0.6)
    on_map = ground.references.positions[matches.on_map]
    np.testing.assert_allclose(matches.seen_xy, on_map, atol=0.6)
    np.testing.assert_allclose(matches.residuals, np.hypot(*(matches.seen_xy - on_map).T), atol=1e-6)


def test_matches_at_the_place_of_another_method_are_those_of_a_fix_there(ground):
    view = seen_from(1500.0, 1490.0)
    objects = ground.see(view)
    x, y = np.array(ORIGIN) + view.position
    found = matches_at(objects, (SIZE, SIZE), ground.index, Place((x + 1, y), 0.5, 1.002))
    fix = solve(ground, objects).matches
    assert len(found) == len(fix) and set(found.on_map) == set(fix.on_map)
    assert matches_at(objects, (SIZE, SIZE), ground.index, Place((x + 73, y - 41), 0.0, 1.0)) is None
    nothing = objects.select(np.zeros(len(objects), bool))
    assert matches_at(nothing, (SIZE, SIZE), ground.index, Place((x, y), 0.0, 1.0)) is None


def test_a_tilted_camera_is_located(ground):
    for direction in (0.0, 130.0):
        view = dataclasses.replace(seen_from(1500, 1300, 70.0), tilt_deg=10.0, tilt_direction_deg=direction)
        result = solve(ground, ground.see(view))
        assert result.status == Status.FIX and error(result, view) < 0.02 * SIZE


def test_objects_at_the_border_do_no_harm(ground):
    objects = ground.see(seen_from(1500, 1300, 120.0))
    moved = objects.centers_xy + np.where(objects.touches_edge[:, None], 9.0, 0.0)
    result = solve(ground, dataclasses.replace(objects, centers_xy=moved))
    assert result.place == solve(ground, objects).place


@pytest.mark.parametrize("place", [(700, 2200), (2300, 800)])
def test_a_cap_does_not_count_triangles_that_a_prior_excludes(ground, place):
    view = seen_from(*place, 70.0, 1.1)
    objects = ground.see(view, NOISE, 5)
    query = make_query(objects, ground.index, (SIZE, SIZE))
    triangles = query_triangles(query, CONSTELLATION, CONSTELLATION.limits.anchors[0])
    position = (ORIGIN[0] + view.position[0] + 40, ORIGIN[1] + view.position[1] - 30)
    prior = Prior(position=position, radius=100.0, pixel_size_range=(0.9, 1.3))
    everything = find_seeds(Lookup(ground.index, query, triangles, prior), 10**9)
    cap = 20_000
    anywhere = find_seeds(Lookup(ground.index, query, triangles, dataclasses.replace(prior, radius=None)), cap)
    there = find_seeds(Lookup(ground.index, query, triangles, prior), cap)
    assert (anywhere.capped, there.capped, everything.capped) == (True, False, False)
    assert len(there.votes)
    for name in ("centers", "turns", "focuses", "votes"):
        np.testing.assert_allclose(getattr(there, name), getattr(everything, name), rtol=1e-12)


def test_a_place_that_capped_searches_leave_out_is_found_by_one_that_looks_everything_up(ground):
    view = seen_from(1400, 1600, 77.0)
    limits = dataclasses.replace(CONSTELLATION.limits, maximum_hits=(0, 0, 10**9))
    narrow = dataclasses.replace(CONSTELLATION, limits=limits)
    capped = dataclasses.replace(ground.index, settings=narrow)
    objects = ground.see(view)
    found = localize(objects, (SIZE, SIZE), capped, PRIOR)
    assert found.status == Status.FIX and error(found, view) < 0.5
    assert not found.search_capped
    assert (found.risk, found.confidence) == (pytest.approx(1e-12, abs=1e-6), 1 - found.risk)


def test_an_image_whose_largest_landmarks_are_not_on_the_map_is_found_by_the_others(ground):
    view, few = seen_from(1400, 1600, 77.0), 20
    objects = ground.see(view)
    centers = objects.centers_xy.copy()
    largest = np.argsort(-objects.areas_px)[:few]
    centers[largest] = np.random.default_rng(3).uniform(0, SIZE, (few, 2))
    spoiled = dataclasses.replace(objects, centers_xy=centers)
    results = {}
    for many in (few, len(objects)):
        limits = dataclasses.replace(CONSTELLATION.limits, anchors=(few, many))
        index = dataclasses.replace(ground.index, settings=dataclasses.replace(CONSTELLATION, limits=limits))
        results[many] = localize(spoiled, (SIZE, SIZE), index, PRIOR)
    assert [result.status for result in results.values()] == [Status.NO_MATCH, Status.FIX]
    assert error(results[len(objects)], view) < 0.5


def test_a_smaller_risk_that_is_allowed_refuses_more(ground):
    objects = ground.see(seen_from(1400, 1600, 77.0)).select(np.arange(9))
    asked = {risk: localize(objects, (SIZE, SIZE), ground.index, PRIOR, None, risk) for risk in (0.4, 1e-11)}
    assert [found.status for found in asked.values()] == [Status.FIX, Status.NO_MATCH]
    assert "error probability of" in str(asked[1e-11].reason)
    assert asked[1e-11].is_doubted


def test_a_view_of_few_large_landmarks_near_each_other_is_found():
    rng = np.random.default_rng(4)
    seen = np.array([[70, 80], [330, 90], [200, 200], [75, 310], [320, 325], [195, 60], [205, 335]], float)
    seen = 200 + 0.85 * (seen - 200)
    others = rng.uniform(1000, 4000, (40, 2))
    positions = np.concatenate([seen * (1, -1) + (0, 400), others])
    areas = np.concatenate([np.full(len(seen), 2500.0), rng.uniform(2000, 3000, len(others))])
    count = len(positions)
    on_map = MapLandmarks(positions, np.ones(count, np.uint8), areas, np.zeros(count, bool))
    found = localize(points_as_objects(seen, areas=areas[: len(seen)]), (400, 400), build_index(on_map, 1.0), PRIOR)
    assert found.best is not None
    assert np.hypot(*np.subtract(found.best.position, (200, 200))) < 2
