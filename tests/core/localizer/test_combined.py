"""Automatic (METHOD 0): each method's fix is checked by the other; map correlation is the second choice."""

from dataclasses import replace

import cv2
import made_labels
import numpy as np
import pytest

from semref.core.correlation.decision import worth_of_outlines
from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.localization import (
    CorrelationPeaks,
    Localization,
    Method,
    Place,
    Prior,
    Status,
    log_odds_of,
    risk_of,
)
from semref.core.localizer.combined import (
    check_by_areas,
    combine_agreeing,
    combine_without_fix,
    confirm,
    confirm_by_earlier,
    doubt_outside,
    prior_near,
    share_on_map,
    show_likely,
)
from semref.core.localizer.localizer import Localizer
from semref.core.localizer.settings import LOCALIZER
from semref.core.sentences import Sentence
from semref.core.simulation.views import PIXELS, View, cut

ORIGIN = 500_000.0, 5_200_000.0
TABLE = ClassTable(
    tuple(LandCoverClass(n, f"class {n}", "#808080", "reference" if n == 1 else "background") for n in range(1, 7))
)
SIZE = 560
WIDTH, HEIGHT = 2400, 2000


def patches(seed: int) -> np.ndarray:
    """Return (HEIGHT, WIDTH) uint8 patches of classes 2 to 6 around random points."""
    return enlarged(made_labels.patches(seed, (HEIGHT // 4, WIDTH // 4), 500, first=2))


def enlarged(labels: np.ndarray) -> np.ndarray:
    return cv2.resize(labels, (WIDTH, HEIGHT), interpolation=cv2.INTER_NEAREST)


def houses(seed: int) -> np.ndarray:
    """Return (HEIGHT, WIDTH) bool: houses apart from each other."""
    return enlarged(made_labels.scattered_objects(HEIGHT // 2, WIDTH // 2, 650, seed, background=0)) > 0


GROUND, HOUSES = patches(1), houses(2)


def localizer_of(ground: np.ndarray, built: np.ndarray, with_overview: bool = True) -> Localizer:
    labels = np.where(built, 1, ground).astype(np.uint8)
    frame = MapFrame("a metric CRS", (ORIGIN[0], 1.0, 0.0, ORIGIN[1], 0.0, -1.0))
    database = build_from_labels(ArrayLabels(labels), frame, TABLE, BuildSettings(SIZE, SIZE, 60.0), "0")
    return Localizer(database if with_overview else replace(database, overview=None))


@pytest.fixture(scope="module")
def localizer():
    return localizer_of(GROUND, HOUSES)


def view(ground, built, column=1203.7, row=905.2, heading=40.0, scale=1.0) -> np.ndarray:
    seen = View(column, -row, heading, scale, SIZE, SIZE)
    areas, objects = cut(ground, PIXELS, seen), cut(built.astype(np.uint8), PIXELS, seen)
    return np.where(objects > 0, 1, areas).astype(np.uint8)


NOTHING_BUILT = np.zeros_like(HOUSES)
MOVED_HOUSES = houses(3)


def distance(position, column=1203.7, row=905.2) -> float:
    return float(np.hypot(position[0] - ORIGIN[0] - column, ORIGIN[1] - row - position[1]))


def is_same(found, other) -> bool:
    """Whether localizations are equal; numpy rounds the mirror's log odds by where its arrays lie in memory."""
    rounded = {name: getattr(found, name) for name in ("mirror_log_odds", "risk", "confidence")}
    expected = {name: getattr(other, name) for name in rounded}
    return rounded == pytest.approx(expected) and found == replace(other, **rounded)


def test_a_fix_of_the_constellation_is_taken_as_it_is(localizer):
    image = view(GROUND, HOUSES)
    found = localizer.localize(image, Method.AUTOMATIC)
    alone = localizer.localize_by_constellation(image)
    assert alone.is_fix and is_same(found, replace(alone, risk=found.risk, confidence=found.confidence))


@pytest.mark.parametrize("built", [HOUSES, NOTHING_BUILT])
def test_a_part_that_shows_another_place_is_named_by_either_method(localizer, built):
    image = view(GROUND, built)
    image[:, 395:] = view(patches(9), built)[:, 395:]
    found = localizer.localize(image, Method.AUTOMATIC)
    assert found.status == Status.FIX and distance(found.position) < 4
    assert str(found.reason).startswith("In the right part of the image, classes hardly match the map")


def test_landmarks_that_class_areas_speak_against_are_no_fix(localizer):
    image = view(patches(9), HOUSES)
    assert localizer.localize_by_constellation(image).status == Status.FIX
    found = localizer.localize(image, Method.AUTOMATIC)
    assert found.status == Status.AMBIGUOUS and found.position is None
    assert "class areas" in str(found.reason)
    assert [distance(place.position) < 2 for place in found.alternatives] == [True]


@pytest.mark.parametrize("built", [NOTHING_BUILT, MOVED_HOUSES], ids=["none", "moved"])
def test_class_areas_are_enough_where_landmarks_are_missing_or_do_not_come_out_whole(localizer, built):
    found = localizer.localize(view(GROUND, built), Method.AUTOMATIC)
    assert (found.status, found.method, found.reason) == (Status.FIX, Method.MAP_CORRELATION, None)
    assert distance(found.position) < 4 and 0 < found.error_95_m < 30 and found.confidence > 0.9
    assert (found.references > 20) == built.any()


@pytest.mark.slow
def test_class_areas_resolve_an_ambiguity_of_landmarks():
    twin_houses = HOUSES.copy()
    twin_houses[:, WIDTH // 2 :] = twin_houses[:, : WIDTH // 2]
    localizer = localizer_of(GROUND, twin_houses)
    for column in (600, 600 + WIDTH // 2):
        image = view(GROUND, twin_houses, column, 1000)
        unsure = localizer.localize_by_constellation(image)
        assert unsure.status == Status.AMBIGUOUS and len(unsure.alternatives) == 2
        found = localizer.localize(image, Method.AUTOMATIC)
        assert (found.status, found.method, found.reason) == (Status.FIX, Method.CONSTELLATION, None)
        assert distance(found.position, column, 1000) < 1 and found.alternatives == ()
        assert found.error_95_m < 3 and found.best.inliers > 10 and found.confidence > 0.99


def test_without_an_overview_only_the_constellation_is_used():
    localizer = localizer_of(GROUND, HOUSES, with_overview=False)
    assert not localizer.has_overview
    for image in (view(GROUND, HOUSES), view(GROUND, NOTHING_BUILT)):
        assert is_same(localizer.localize(image, Method.AUTOMATIC), localizer.localize_by_constellation(image))


def test_without_a_fix_the_reasons_of_both_methods_are_shown_and_missing_landmarks_counted(localizer):
    found = localizer.localize(view(patches(8), houses(4)), Method.AUTOMATIC)
    assert found.status in (Status.NO_MATCH, Status.AMBIGUOUS) and found.position is None
    assert str(found.reason).startswith("The best candidate position (log odds")
    assert "Map correlation found no position either: " in str(found.reason)
    assert str(found.reason).endswith("all headings, the whole map.")
    found = localizer.localize(np.zeros((SIZE, SIZE), np.uint8), Method.AUTOMATIC)
    assert found.status == Status.TOO_FEW_REFERENCES
    assert "more are needed. Map correlation found no position either: only 0%" in str(found.reason)


@pytest.mark.slow
def test_both_methods_search_the_same_range_of_scales_unless_one_is_given(localizer):
    image = view(GROUND, NOTHING_BUILT, scale=2.2)
    found = localizer.localize(image, Method.AUTOMATIC)
    assert (found.status, found.method) == (Status.FIX, Method.MAP_CORRELATION)
    given = Prior(pixel_size_range=(0.5, 1.2))
    assert localizer.localize(image, Method.AUTOMATIC, given).status != Status.FIX
    found = localizer.localize(view(GROUND, HOUSES, scale=2.2), Method.AUTOMATIC)
    assert (found.status, found.method) == (Status.FIX, Method.CONSTELLATION)


def test_a_reason_states_the_searched_area(localizer):
    image = view(GROUND, NOTHING_BUILT, scale=2.2)
    found = localizer.localize(image, Method.AUTOMATIC, Prior(pixel_size_range=(0.5, 1.2)))
    assert str(found.reason).endswith("Searched: pixel sizes 0.5–1.2 m, all headings, the whole map.")
    near = Prior((500_000.0, 5_200_000.0), 250.0, 370.0, 20.0, (0.5, 1.2))
    reason = str(localizer.localize(image, Method.MAP_CORRELATION, near).reason)
    assert reason.endswith("headings within 20° of 10°, the ground within 250 m of 500000, 5200000.")


def test_a_prior_applies_to_both_methods(localizer):
    image = view(GROUND, NOTHING_BUILT)
    here = Prior(position=(ORIGIN[0] + 1150, ORIGIN[1] - 950), radius=150.0)
    assert localizer.localize(image, Method.AUTOMATIC, here).status == Status.FIX
    assert localizer.localize(image, Method.AUTOMATIC, replace(here, position=ORIGIN)).status != Status.FIX


def test_a_search_area_mostly_outside_the_map_makes_a_position_less_probable():
    priors = Prior(), Prior((5.0, 20.0), 1e5), Prior((5.0, 5.0), 4.0), Prior((-4.0, 20.0), 5.0), Prior((60.0, 5.0), 9.0)
    assert [share_on_map(prior, (0.0, 0.0, 10.0, 40.0)) for prior in priors] == pytest.approx([1, 1, 1, 0.1, 0])
    assert doubt_outside(AREAS, 0.5) == AREAS
    found = doubt_outside(AREAS, 0.2)
    assert found.is_fix and (found.risk, 1 - found.confidence) == pytest.approx((4e-5, 4e-5), rel=1e-3)
    found = doubt_outside(AREAS, 0.01)
    assert (found.status, found.alternatives) == (Status.AMBIGUOUS, (AREAS.best,))
    assert show_likely(found).is_likely and found.risk == pytest.approx(99e-5, rel=1e-2)
    assert doubt_outside(doubted(AREAS, 0.01), 0.0).risk == 1


PLACE = Place((100.0, 200.0), 30.0, 1.0)
SAID = Sentence("The mirrored image matches almost as well; the pattern of landmarks is too regular.")
KNOWN = {"best": PLACE, "confidence": 1 - 1e-6, "risk": 1e-6, "error_95_m": 1.0}
STARS = Localization(Status.FIX, Method.CONSTELLATION, 30, **KNOWN)
BESIDE = {"best": replace(PLACE, position=(103.0, 204.0)), "confidence": 1 - 1e-5, "risk": 1e-5, "error_95_m": 8.0}
AREAS = replace(STARS, method=Method.MAP_CORRELATION, **BESIDE)


@pytest.mark.parametrize(
    ("agreement", "status"), [(None, Status.FIX), (0.9, Status.FIX), (0.6, Status.FIX), (-0.1, Status.NO_MATCH)]
)
def test_a_fix_remains_if_class_areas_agree_or_are_undecided(agreement, status):
    found = check_by_areas(STARS, agreement)
    # A place refused only for its risk can still be confirmed by map correlation.
    assert (found.status, found.is_doubted) == (status, status == Status.NO_MATCH)


def test_agreeing_class_areas_confirm_a_place_refused_only_for_its_risk():
    stars = doubted(STARS, 3e-4)
    found = check_by_areas(stars, 0.9)
    assert (found.status, found.reason) == (Status.FIX, None)
    assert found.confidence == 1 - found.risk > 1 - LOCALIZER.allowed_risk
    assert check_by_areas(stars, None) == stars
    assert check_by_areas(replace(stars, is_doubted=False), 0.9).status == Status.NO_MATCH
    assert check_by_areas(stars, 0.2).status == Status.NO_MATCH


def test_the_part_that_disagrees_stays_named_when_class_areas_agree_and_at_a_refined_pose():
    assert check_by_areas(replace(STARS, reason=SAID), 0.9).reason == SAID
    assert confirm(replace(AREAS, reason=SAID), STARS, around(20.0)).reason == SAID
    assert combine_agreeing(doubted(STARS, STARS.risk), replace(AREAS, reason=SAID), 1000).reason == SAID


def test_two_independent_methods_with_one_place_lower_the_risk():
    stars, areas = doubted(STARS, 0.01), doubted(AREAS, 0.003)
    found = combine_agreeing(stars, areas, 1000)
    assert (found.status, found.position, found.reason) == (Status.FIX, STARS.position, None)
    assert found.risk == pytest.approx(3e-5 / np.exp(LOCALIZER.agreement_worth), rel=0.05)
    assert combine_agreeing(stars, replace(areas, risk=0.9), 1000) is None
    assert combine_agreeing(replace(stars, best=replace(PLACE, position=(900.0, 200.0))), areas, 1000) is None
    assert combine_agreeing(replace(stars, best=replace(PLACE, heading_deg=60.0)), areas, 1000) is None
    # Across north, 359.5° and 0.2° differ by 0.7°.
    north, beside = (replace(PLACE, heading_deg=heading) for heading in (0.2, 359.5))
    assert combine_agreeing(replace(stars, best=north), replace(areas, best=beside), 1000).is_fix


def test_two_looks_at_a_photo_with_one_place_lower_the_risk():
    found, earlier = doubted(AREAS, 0.01), doubted(AREAS, 0.05)
    offset, slope = LOCALIZER.looks_curve
    expected = offset + slope * (np.log(99) + np.log(19))
    both = confirm_by_earlier(found, earlier, 1000)
    assert both.risk == pytest.approx(1 / (1 + np.exp(expected))) and not both.is_fix
    assert confirm_by_earlier(found, earlier, 1000, replace(LOCALIZER, allowed_risk=0.01)).is_fix
    # The edges of the photo, the same in both looks, count once.
    edges = worth_of_outlines(3.0, LOCALIZER.correlation)
    shown, before = (
        replace(one, risk=risk_of(log_odds_of(one.risk) + edges), peaks=CorrelationPeaks(0.5, 0.3, 0.3, outlines=3.0))
        for one in (found, earlier)
    )
    assert log_odds_of(confirm_by_earlier(shown, before, 1000).risk) == pytest.approx(log_odds_of(both.risk) + edges)
    # A look that is nearly certain needs no help, and a poor earlier look takes nothing away.
    assert confirm_by_earlier(doubted(AREAS, 1e-9), earlier, 1000).is_fix
    assert confirm_by_earlier(found, doubted(AREAS, 0.99), 1000).risk == pytest.approx(found.risk)


@pytest.mark.parametrize("changed", [{"position": (130.0, 204.0)}, {"heading_deg": 60.0}, {"pixel_size_m": 1.2}])
def test_two_looks_at_a_photo_with_other_places_are_no_evidence(changed):
    found, earlier = doubted(AREAS, 0.01), doubted(AREAS, 0.05, replace(AREAS.best, **changed))
    assert confirm_by_earlier(found, replace(earlier, error_95_m=500.0), 1000) == found


def test_an_inaccurate_place_is_not_confirmed_by_an_earlier_look():
    found, earlier = doubted(AREAS, 0.01), doubted(AREAS, 0.05)
    inaccurate = replace(found, is_doubted=False)
    assert confirm_by_earlier(inaccurate, earlier, 1000) == inaccurate
    assert confirm_by_earlier(found, replace(earlier, is_doubted=False), 1000) == found


def test_the_constellation_searches_again_at_the_place_of_map_correlation_but_not_without_a_fix():
    prior = prior_near(AREAS, Prior(), 1000)
    assert (prior.position, prior.radius, prior.heading_deg) == ((103.0, 204.0), 20.0, 30.0)
    assert prior_near(replace(AREAS, error_95_m=48.0), Prior(), 1000).radius == 60.0
    assert prior.pixel_size_range[0] < 1.0 < prior.pixel_size_range[1]
    with pytest.raises(ValueError, match="no fix"):
        prior_near(replace(AREAS, status=Status.NO_MATCH), Prior(), 1000)


def around(radius):
    return Prior(AREAS.position, radius)


def test_a_second_look_anywhere_refines_a_fix_but_does_not_lower_its_risk():
    found = confirm(AREAS, STARS, around(20.0))
    assert (found.position, found.error_95_m, found.method) == (STARS.position, 1.0, Method.CONSTELLATION)
    assert (found.risk, found.confidence) == (AREAS.risk, 1 - AREAS.risk)
    assert confirm(AREAS, STARS, Prior()).position == STARS.position
    assert confirm(AREAS, STARS, Prior(AREAS.position)).position == STARS.position


def test_of_places_alike_the_one_where_class_areas_agree_is_taken_if_it_is_the_only_one():
    far, close = replace(PLACE, position=(900.0, 200.0)), replace(PLACE, position=(101.0, 203.0))
    unsure = Localization(Status.AMBIGUOUS, Method.CONSTELLATION, 30, SAID, best=PLACE, risk=0.5)
    assert confirm(AREAS, replace(unsure, alternatives=(PLACE, far)), around(20.0)).position == PLACE.position
    assert confirm(AREAS, replace(unsure, alternatives=(PLACE, close)), around(20.0)) is None
    # Only the mirrored image is a rival; no place can decide between them.
    assert confirm(AREAS, replace(unsure, alternatives=(PLACE,)), around(20.0)) is None


def test_without_a_fix_the_places_of_both_methods_are_listed():
    other = replace(PLACE, heading_deg=99.0)
    stars = Localization(Status.NO_MATCH, Method.CONSTELLATION, 30, SAID)
    areas = Localization(Status.AMBIGUOUS, Method.MAP_CORRELATION, 0, SAID, alternatives=(PLACE, other))
    found = combine_without_fix(stars, areas, 1000)
    assert (found.status, found.alternatives) == (Status.AMBIGUOUS, (PLACE, other))
    said = str(SAID)
    assert str(found.reason) == f"{said} Map correlation found no position either: {said[0].lower()}{said[1:]}"


def test_a_place_that_both_methods_found_is_listed_once():
    apart = replace(PLACE, position=(PLACE.position[0] + 500.0, PLACE.position[1]))
    beside = replace(PLACE, position=(PLACE.position[0] + 1.0, PLACE.position[1]))
    stars = Localization(Status.AMBIGUOUS, Method.CONSTELLATION, 30, SAID, alternatives=(PLACE,))
    areas = Localization(Status.AMBIGUOUS, Method.MAP_CORRELATION, 0, SAID, alternatives=(beside, apart))
    assert combine_without_fix(stars, areas, round(100 / PLACE.pixel_size_m)).alternatives == (PLACE, apart)


def doubted(found, risk, place=None):
    unsure = {"status": Status.NO_MATCH, "reason": SAID, "confidence": None, "is_doubted": True}
    return replace(found, risk=risk, best=place or found.best, **unsure)


def test_without_a_fix_the_more_probable_of_two_places_is_kept():
    far = replace(PLACE, position=(900.0, 200.0))
    stars, areas = doubted(STARS, 0.5, far), doubted(AREAS, 0.1)
    found = combine_without_fix(stars, areas, 1000)
    assert (found.method, found.best, found.references) == (Method.MAP_CORRELATION, AREAS.best, STARS.references)
    # Odds of 1 and 9 against neither.
    assert found.risk == pytest.approx(2 / 11)
    assert combine_without_fix(doubted(STARS, 0.05, far), areas, 1000).best == far


def test_without_a_fix_agreement_of_both_methods_lowers_the_risk():
    found = combine_without_fix(doubted(STARS, 0.9), doubted(AREAS, 0.9), 1000)
    assert (found.method, found.best) == (Method.CONSTELLATION, STARS.best)
    assert found.risk == pytest.approx(1 / (1 + np.exp(LOCALIZER.agreement_worth) / 81))
