import numpy as np
import pytest

from semref.core.geometry.error_settings import ClassBias, ErrorSettings, SharedErrors
from semref.core.geometry.pose import Pose, fit_similarity, fit_tilted
from semref.core.geometry.shared_errors import (
    CLASSES,
    LANDMARKS,
    MAP,
    PIXELS,
    MatchedPoints,
    bordered,
    eliminated,
    inverted,
    phase_deviation,
    refined_pose,
)
from semref.core.simulation.fields import correlated_shifts
from semref.core.simulation.noise import DISPLACED_KERNELS

EXACT_MAP = SharedErrors(0.0, settings=ErrorSettings(class_spread_px=0.001, views=((1e-4, 1e-4, 1.0),)))
USUAL = SharedErrors()
DIAGONAL = 1700.0
TRUE = Pose(5000 + 7000j, 1.2 * np.exp(0.5j))


def complex_normal(rng, count, deviation=1.0):
    return deviation * (rng.normal(size=count) + 1j * rng.normal(size=count))


def tried(rng, count, displaced=0.0, shift=0j, errors=USUAL, bend=0.0, own=0.6, kernels=DISPLACED_KERNELS, true=TRUE):
    """Return a pose refined from landmarks in villages (with a tilt: those that agree), and its covariance."""
    villages = rng.uniform(-550, 550, (6, 2))
    points = villages[rng.integers(0, 6, count)] + rng.normal(0, 80, (count, 2))
    image = points @ (1, 1j)
    seen = image * (1 + bend * np.abs(image) ** 2 / (DIAGONAL / 2) ** 2)
    on_map = true.on_map(seen) + complex_normal(rng, count, own) - shift
    if displaced:
        on_map += displaced * correlated_shifts(np.column_stack([on_map.real, on_map.imag]), kernels, rng) @ (1, 1j)
    first = Pose(*(complex(v) for v in fit_similarity(image, on_map, np.ones(count))))
    agree, deviations = np.full(count, True), np.full(count, 1.4 * own)
    for _ in range(0 if true.is_level else 6):
        first = fit_tilted(image[agree], on_map[agree], deviations[agree], first, DIAGONAL)
        residuals = np.abs(on_map - first.on_map(image))
        agree = residuals <= max(np.sort(residuals)[count // 3], 3 * own)
    every = image[agree], on_map[agree], deviations[agree], np.ones(agree.sum(), np.uint8)
    return refined_pose(MatchedPoints(*every, DIAGONAL), first, errors)


def held(results):
    inside = 0
    for pose, known in results:
        off = pose.center - TRUE.center
        off = np.array([off.real, off.imag])
        inside += off @ np.linalg.inv(np.array(known.position)) @ off <= 5.991
    return inside / len(results)


@pytest.mark.slow
@pytest.mark.parametrize("count", [8, 60])
def test_the_covariance_covers_independent_errors(count):
    rng = np.random.default_rng(count)
    assert 0.9 <= held([tried(rng, count, errors=EXACT_MAP) for _ in range(150)]) <= 1.0


@pytest.mark.slow
def test_the_covariance_covers_errors_shared_by_neighbors():
    rng = np.random.default_rng(1)
    results = [tried(rng, 60, displaced=1.13) for _ in range(150)]
    assert 0.89 <= held(results) <= 0.99
    assert held([tried(rng, 60, displaced=1.13, errors=EXACT_MAP) for _ in range(100)]) < 0.7


@pytest.mark.slow
def test_the_covariance_covers_maps_with_two_fifths_drawn_again():
    rng = np.random.default_rng(2)
    kernels = USUAL.settings.map_kernels
    results = [tried(rng, 60, displaced=m, own=0.3, kernels=kernels) for m in (0.03, 0.03, 0.03, 0.7, 2.0) * 30]
    assert 0.89 <= held(results) <= 0.99


def test_the_covariance_covers_a_moved_map_that_a_tilted_pose_follows():
    rng, kernels = np.random.default_rng(2), USUAL.settings.map_kernels
    true = Pose(TRUE.center, TRUE.turn, 0.004 + 0.003j, (0.04 - 0.05j) / 850)
    assert held([tried(rng, 45, displaced=0.7, own=0.3, kernels=kernels, true=true) for _ in range(100)]) >= 0.88


def test_a_map_that_did_not_change_keeps_a_small_radius():
    rng = np.random.default_rng(3)
    radii = [tried(rng, 60, own=0.1)[1].radius_95 for _ in range(10)]
    assert np.median(radii) < 0.25


def test_a_stated_bias_is_taken_off_in_ground_and_in_image_axes():
    rng = np.random.default_rng(3)
    shift = complex(0.6, -2.0)
    turned = shift * TRUE.turn.conjugate() / abs(TRUE.turn)
    for bias in (
        ClassBias(1, east=shift.real, north=shift.imag, spread=0.1),
        ClassBias(1, right=turned.real, down=-turned.imag, spread=0.1),
    ):
        pose, known = tried(rng, 80, shift=shift, errors=SharedErrors(0.3, class_biases=(bias,)))
        assert abs(pose.center - TRUE.center) < 0.4
    unstated, _ = tried(rng, 80, shift=shift)
    assert abs(unstated.center - TRUE.center) > 1.5


def test_the_spread_of_a_bias_is_added():
    rng = np.random.default_rng(4)
    wide = SharedErrors(0.0, class_biases=(ClassBias(1, spread=2.0),))
    known = tried(rng, 60, errors=wide)[1]
    assert known.parts[0][0] == CLASSES and known.part(CLASSES) == pytest.approx(2.4477 * 2, rel=0.05)


def test_parts_make_the_radius():
    _, known = tried(np.random.default_rng(6), 60, displaced=1.13)
    assert {name for name, _ in known.parts} >= {LANDMARKS, MAP, CLASSES, PIXELS}
    mean = np.sqrt(np.trace(np.array(known.position)) / 2)
    assert np.sqrt(sum(part**2 for _, part in known.parts)) == pytest.approx(2.4477 * mean, rel=1e-3)
    assert known.full[0][:2] == known.position[0] and len(known.full) == 4
    assert -1 <= known.correlation <= 1


@pytest.mark.slow
def test_heading_and_pixel_size_are_within_their_deviations():
    rng = np.random.default_rng(7)
    headings, sizes = [], []
    for _ in range(60):
        pose, known = tried(rng, 60, displaced=1.13)
        headings.append(abs(np.degrees(np.angle(pose.turn / TRUE.turn))) / known.heading_deviation_deg)
        sizes.append(abs(abs(pose.turn) - abs(TRUE.turn)) / known.pixel_size_deviation)
    assert (np.array(headings) < 1.96).mean() > 0.8 and (np.array(sizes) < 1.96).mean() > 0.9


def test_pixels_round_alike_only_along_rows_of_the_map_at_its_scale():
    assert phase_deviation(1.0 + 0j, 1.0, 1800.0) == pytest.approx(0.2887, abs=1e-3)
    assert phase_deviation(1j, 1.0, 1800.0) == pytest.approx(0.2887, abs=1e-3)
    assert phase_deviation(np.exp(0.5j), 1.0, 1800.0) < 0.01 and phase_deviation(1.1 + 0j, 1.0, 1800.0) < 0.01
    assert phase_deviation(1.0 + 0j, 0.0, 1800.0) == 0.0


def test_matrices_are_inverted_together_as_each_by_itself():
    draws = np.random.default_rng(3).normal(size=(5, 4, 13, 20))
    matrices = draws @ draws.swapaxes(-1, -2) * np.logspace(-3, 3, 13)[:, None] * np.logspace(-3, 3, 13)
    inverses, logarithms = inverted(matrices)
    np.testing.assert_allclose(inverses, np.linalg.inv(matrices), rtol=1e-7)
    np.testing.assert_allclose(logarithms, np.linalg.slogdet(matrices)[1], rtol=1e-10)


def test_unknowns_are_eliminated_with_what_is_known_of_them():
    rng = np.random.default_rng(4)
    columns, right = rng.normal(size=(5, 20, 6)), rng.normal(size=20)
    precisions, means = np.array([0, 0, 0.5, 1, 2, 3]), rng.normal(size=6)
    both = np.concatenate([np.broadcast_to(right[:, None], (5, 20, 1)), columns], axis=2)
    rest, logarithms = eliminated(both.swapaxes(1, 2) @ both + bordered(precisions, means), 4)
    for one, left, logarithm in zip(columns, rest, logarithms):
        normal = one.T @ one + np.diag(precisions)
        solution = np.linalg.solve(normal, one.T @ right + precisions * means)
        np.testing.assert_allclose(np.linalg.solve(left[1:, 1:], left[1:, 0]), solution[:2])
        np.testing.assert_allclose(np.linalg.inv(left[1:, 1:]), np.linalg.inv(normal)[:2, :2])
        smallest = ((one @ solution - right) ** 2).sum() + (precisions * (solution - means) ** 2).sum()
        assert left[0, 0] - left[0, 1:] @ solution[:2] == pytest.approx(smallest)
        wanted = np.linalg.slogdet(normal)[1] - np.linalg.slogdet(left[1:, 1:])[1]
        assert logarithm == pytest.approx(wanted)


def test_of_very_many_landmarks_so_many_are_used_from_first_to_last():
    count = 1000
    all_of_them = MatchedPoints(*(np.arange(count),) * 4, 1.0)
    thinned = all_of_them.thinned(200)
    assert len(thinned.image) == 200 and thinned.image[[0, -1]].tolist() == [0, count - 1]
    assert len(np.unique(thinned.classes)) == 200
    assert all_of_them.thinned(count) is all_of_them


def test_what_nobody_states_of_a_network_is_added_once_for_all_its_classes():
    rng = np.random.default_rng(6)
    points = rng.uniform(-550, 550, (120, 2)) @ (1, 1j)
    on_map = TRUE.on_map(points) + complex_normal(rng, 120, 0.5)
    first = Pose(*(complex(v) for v in fit_similarity(points, on_map, np.ones(120))))

    def part(classes, **known):
        matched = MatchedPoints(points, on_map, np.full(120, 0.7), np.uint8(np.arange(120) % classes), DIAGONAL)
        return refined_pose(matched, first, SharedErrors(0.0, **known))[1].part(CLASSES)

    one, six = part(1, class_spread=0.5), part(6, class_spread=0.5)
    assert one == pytest.approx(2.4477 * 0.5, rel=0.05)
    # Half of the variance is the same in all classes; the other half averages out over six.
    assert six == pytest.approx(2.4477 * 0.5 * (0.5 + 0.5 / 6) ** 0.5, rel=0.1)
    stated = tuple(ClassBias(value, spread=0.05) for value in range(6))
    assert part(6, class_spread=0.5, class_biases=stated) < 0.2


def test_logarithms_are_taken_of_contiguous_numbers(monkeypatch):
    """For other arrays, NumPy's last bit depends on the memory address, so it changes from run to run."""
    log, taken = np.log, []
    monkeypatch.setattr(np, "log", lambda values: taken.append(np.asarray(values).flags.contiguous) or log(values))
    tried(np.random.default_rng(4), 20)
    assert len(taken) > 13 and all(taken)
