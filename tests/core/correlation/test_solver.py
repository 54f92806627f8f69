from dataclasses import replace

import numpy as np
import pytest
from made_patches import FRAME, MODEST, ORIGIN, PRIOR, STRONG, error_m, made_map, spoiled, view

from semref.core.correlation import compare, refine, refine_many, search, solver, view_effects
from semref.core.correlation.class_pyramid import MapPyramid, class_fractions
from semref.core.correlation.settings import CORRELATION
from semref.core.correlation.solver import agreement_at, localize
from semref.core.errors import LabelMapError
from semref.core.labels.class_shares import ClassShares
from semref.core.labels.overview import most_frequent_labels
from semref.core.localization import Place, Prior


def test_an_image_without_pixels_is_an_error(pyramid):
    with pytest.raises(LabelMapError):
        localize(np.zeros((0, 5), np.uint8), pyramid, PRIOR)


@pytest.mark.parametrize("sizes", [(0.0, 1.0), (2.0, 1.0)])
def test_an_impossible_range_of_pixel_sizes_is_an_error(pyramid, sizes):
    with pytest.raises(ValueError):
        localize(np.ones((5, 5), np.uint8), pyramid, Prior(pixel_size_range=sizes))


@pytest.mark.parametrize(
    "heading, pixel, size",
    [
        pytest.param(0, 1, (560, 560), marks=pytest.mark.slow),
        (101.3, 0.83, (640, 560)),
        pytest.param(287, 1.2, (480, 600), marks=pytest.mark.slow),
    ],
)
def test_a_clean_image_is_found_finer_than_an_overview_pixel(labels, pyramid, heading, pixel, size):
    center = 1203.7, 905.2
    result = localize(view(labels, center, heading, pixel, size), pyramid, PRIOR)
    assert (result.status, result.reason) == ("fix", None)
    assert error_m(result.best, center) < 2.0
    assert abs((result.heading_deg - heading + 180) % 360 - 180) < 0.3
    assert abs(result.pixel_size_m / pixel - 1) < 0.005
    assert result.confidence > 0.9
    assert 0 < result.error_95_m < 50


@pytest.mark.slow
@pytest.mark.parametrize("noise", [MODEST, STRONG])
def test_a_noisy_image_is_found(labels, pyramid, noise):
    center = 1630.0, 1240.5
    image = spoiled(view(labels, center, 200.5, 1.1), replace(noise, patch_size=40).in_pixels(1.1), 5)
    result = localize(image, pyramid, PRIOR)
    assert result.status == "fix"
    assert error_m(result.best, center) < 0.02 * 560


@pytest.mark.slow
@pytest.mark.parametrize("seed", [11, 12, 13])
def test_an_image_of_another_map_is_not_found_with_a_reason(pyramid, seed):
    result = localize(view(made_map(seed), (1300, 1000), 40, 1.0), pyramid, PRIOR)
    assert result.status in ("no_match", "ambiguous")
    assert str(result.reason).endswith(".")
    assert result.confidence is None


@pytest.mark.slow
def test_a_mirrored_image_is_not_found(labels, pyramid):
    result = localize(view(labels, (1300, 1000), 40, 1.0)[:, ::-1], pyramid, PRIOR)
    assert result.status == "no_match"
    assert "not significantly better than" in str(result.reason)


def test_an_image_of_one_class_has_too_little_information_and_one_of_a_few_meters_asks_for_a_prior(pyramid, labels):
    result = localize(np.full((560, 560), 4, np.uint8), pyramid, PRIOR)
    assert result.status == "no_match"
    assert "class" in str(result.reason)
    result = localize(view(labels, (1300, 1000), 40, 1.0), pyramid, Prior(pixel_size_range=(0.001, 0.002)))
    assert result.status == "no_match"
    assert "prior" in str(result.reason)


@pytest.mark.parametrize("value", [0, 3])
def test_a_map_that_is_alike_everywhere_has_too_little_information(labels, value):
    pyramid = MapPyramid(np.full((300, 300), value, np.uint8), FRAME)
    result = localize(view(labels, (1300, 1000), 40, 1.0), pyramid, PRIOR)
    assert result.status == "no_match"
    assert "map" in str(result.reason)


def test_an_image_is_found_on_a_map_of_only_buildings(labels):
    buildings = np.where(labels == 1, labels, 0)
    center = 1203.7, 905.2
    pyramid = MapPyramid(most_frequent_labels(buildings), FRAME)
    result = localize(view(buildings, center, 101.3, 0.83, (640, 560)), pyramid, PRIOR)
    assert result.status == "fix" and error_m(result.best, center) < 2.0


def test_a_place_that_is_on_the_map_twice_is_ambiguous_without_a_prior(labels):
    doubled = labels.copy()
    doubled[1100:1800, 1700:2500] = labels[200:900, 300:1100]
    pyramid = MapPyramid(most_frequent_labels(doubled), FRAME)
    result = localize(view(doubled, (700, 550), 15, 1.0, (480, 480)), pyramid, PRIOR)
    assert result.status == "ambiguous"
    places = [error_m(result.best, center) for center in ((700, 550), (2100, 1450))]
    assert min(places) < 4
    other = (2100, 1450) if places[0] < places[1] else (700, 550)
    assert error_m(result.alternatives[1], other) < 16
    prior = replace(PRIOR, position=(ORIGIN[0] + 2000, ORIGIN[1] - 1400), radius=300.0)
    result = localize(view(doubled, (2100, 1450), 15, 1.0, (480, 480)), pyramid, prior)
    assert result.status == "fix"
    assert error_m(result.best, (2100, 1450)) < 4


@pytest.mark.slow
def test_the_result_does_not_depend_on_tiles_or_threads(labels, pyramid, monkeypatch):
    image = view(labels, (1500, 700), 123, 0.9)
    first = localize(image, pyramid, PRIOR)
    monkeypatch.setattr(search, "TILE_SIZE", 256)
    monkeypatch.setattr(search, "THREADS", 1)
    other = localize(image, pyramid, PRIOR)
    assert np.hypot(*np.subtract(first.best.position, other.best.position)) < 0.1
    assert abs(first.peaks.score - other.peaks.score) < 0.001
    assert abs(first.peaks.mirror - other.peaks.mirror) < 0.03


@pytest.mark.slow
@pytest.mark.parametrize("center, heading, pixel", [((1500, 700), 123, 0.9), ((1203.7, 905.2), 287, 1.2)])
def test_a_look_at_larger_pixels_first_finds_the_same_place(labels, pyramid, center, heading, pixel):
    image = spoiled(view(labels, center, heading, pixel), replace(MODEST, patch_size=40).in_pixels(pixel), 5)
    # The map counts as so large that coarse pixels choose the places.
    large = MapPyramid(pyramid.labels, pyramid.frame, replace(CORRELATION, most_at_once=0))
    all_places, chosen = (localize(image, one, PRIOR) for one in (pyramid, large))
    assert (all_places.status, chosen.status) == ("fix", "fix")
    assert np.hypot(*np.subtract(all_places.best.position, chosen.best.position)) < 0.5
    # Lead and opponents come from another search, but agree roughly.
    assert chosen.peaks.score == pytest.approx(all_places.peaks.score, abs=0.005)
    assert chosen.peaks.mirror == pytest.approx(all_places.peaks.mirror, abs=0.1)


def test_a_fix_states_the_accuracy_of_position_heading_and_pixel_size(labels, pyramid):
    found = localize(view(labels, (1500, 700), 123, 0.9), pyramid, PRIOR)
    (xx, xy), (yx, yy) = found.covariance.position
    assert xy == pytest.approx(yx) and xx > 0 and xx * yy > xy * yx
    assert 1.9 * np.sqrt(max(xx, yy)) <= found.error_95_m <= 2.5 * np.sqrt(max(xx, yy))
    assert 0 < found.covariance.heading_deviation_deg < 1 and 0 < found.covariance.pixel_size_deviation < 0.02
    assert found.covariance.ellipse_95.semi_major >= found.covariance.ellipse_95.semi_minor > 0


def test_a_place_without_a_radius_is_no_fix(labels, pyramid, monkeypatch):
    monkeypatch.setattr(solver, "leaning_covariance", lambda *_: np.full((4, 4), np.inf))
    found = localize(view(labels, (1500, 700), 123, 0.9), pyramid, PRIOR)
    assert found.status == "ambiguous" and "does not determine the position" in str(found.reason)


def test_agreement_is_high_only_at_the_place_of_the_image_and_unknown_for_one_class_or_beside_the_map(labels, pyramid):
    image = spoiled(view(labels, (1500, 700), 123, 0.9), MODEST.in_pixels(0.9), 1)
    right = ORIGIN[0] + 1500, ORIGIN[1] - 700
    assert agreement_at(image, pyramid, Place(right, 123.0, 0.9)) > 0.6
    for position, heading in ((right, 303.0), ((ORIGIN[0] + 900, ORIGIN[1] - 1200), 123.0)):
        assert abs(agreement_at(image, pyramid, Place(position, heading, 0.9))) < 0.25
    assert agreement_at(np.full((560, 560), 4, np.uint8), pyramid, Place(right, 0.0, 1.0)) is None
    assert agreement_at(np.zeros((560, 560), np.uint8), pyramid, Place(right, 0.0, 1.0)) is None
    image = view(labels, (1500, 700), 123, 0.9)
    assert agreement_at(image, pyramid, Place((ORIGIN[0] - 5000, ORIGIN[1]), 123.0, 0.9)) is None
    one_class = MapPyramid(np.full((300, 300), 3, np.uint8), FRAME)
    assert agreement_at(image, one_class, Place(right, 123.0, 0.9)) is None


def test_a_place_along_a_straight_shore_is_possible_but_no_fix():
    labels = np.full((1600, 1600), 2, np.uint8)
    labels[:, 800:] = 3
    pyramid = MapPyramid(most_frequent_labels(labels), FRAME)
    center = 805.0, 800.0
    here = Prior((ORIGIN[0] + center[0], ORIGIN[1] - center[1]), 30.0, 0.0, 10.0, (0.95, 1.05))
    result = localize(view(labels, center, 0, 1.0), pyramid, here)
    assert result.status == "ambiguous" and result.error_95_m > 0.025 * 560 * np.sqrt(2)
    assert "position" in str(result.reason)


CENTER = (1500.0, 1000.0)
SWAPPED = np.array([0, 1, 3, 2, 5, 4, 6], np.uint8)
"""Exchange classes 2 and 3, and classes 4 and 5."""

VALUES = np.arange(1, 7, dtype=np.uint8)


def test_shares_count_instead_of_the_labels(labels, pyramid):
    image = view(labels, CENTER, 33.0, 1.0)
    by_labels = localize(image, pyramid, PRIOR)
    by_shares = localize(
        SWAPPED[image], pyramid, PRIOR, shares=ClassShares(VALUES, class_fractions(image, VALUES, (280, 280)))
    )
    assert by_labels.is_fix and by_shares.is_fix
    assert error_m(by_shares.best, CENTER) < 4
    assert by_shares.peaks.score == pytest.approx(by_labels.peaks.score, abs=0.02)


@pytest.mark.slow
@pytest.mark.parametrize(("heading_deg", "pixel"), [(37, 0.9), (200, 1.2)])
@pytest.mark.parametrize("beyond", [0.45, 0.5, 0.55, 0.7])
def test_at_the_edge_of_the_map_a_fix_is_right(labels, pyramid, beyond, heading_deg, pixel):
    """The map begins 150 pixels from the left, so that part of the image is beyond the map."""
    center = 150 + (0.5 - beyond) * 560 * pixel, 1000.0
    result = localize(view(labels, center, heading_deg, pixel), pyramid, PRIOR)
    if beyond < 0.6:
        assert result.is_fix
    assert not result.is_fix or error_m(result.best, center) < 3


def test_a_place_fixed_only_by_the_edge_of_the_map_is_no_fix(labels, monkeypatch):
    for module in (compare, refine, refine_many, view_effects):
        monkeypatch.setattr(module, "LEAST_KNOWN_MOVED", 0.5)
    pyramid = MapPyramid(most_frequent_labels(labels), FRAME)
    center = 130.0, 1000.0
    result = localize(view(labels, center, 200, 1.2), pyramid, PRIOR)
    assert error_m(result.best, center) > 10
    assert not result.is_fix and "outside the map" in str(result.reason)
