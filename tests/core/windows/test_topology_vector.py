import json
import math
from pathlib import Path

import numpy as np
import pytest

from semref.core.windows.topology_vector import (
    class_ranks,
    topology_vector,
    topology_vectors,
    vector_confidence,
    vector_distances,
    vector_objects,
)

CENTER = (50.0, 40.0)

PAPER = json.loads((Path(__file__).parents[2] / "data" / "paper_tables.json").read_text(encoding="utf-8"))
"""Vectors of tables 1 to 3; distance and confidence, rounded to two decimals, of tables 4 and 5 (0 for failures)."""


def polar(*objects):
    """Return points and classes from (distance, angle in degrees from +x towards +y, class value)."""
    points = [
        (CENTER[0] + d * math.cos(math.radians(a)), CENTER[1] + d * math.sin(math.radians(a))) for d, a, _ in objects
    ]
    return np.array(points, float).reshape(-1, 2), np.array([c for _, _, c in objects], np.uint8)


def vector_rows(objects, reference_values=(1, 2, 3), references_per_vector=10, center=CENTER):
    vector = topology_vector(*polar(*objects), center, reference_values, references_per_vector)
    assert vector.dtype == np.float32 and vector.shape == (3 * references_per_vector,)
    return vector.reshape(3, references_per_vector)


def random_objects(seed, count):
    rng = np.random.default_rng(seed)
    return list(zip(rng.uniform(1, 60, count), rng.uniform(0, 360, count), rng.integers(1, 4, count).tolist()))


@pytest.mark.parametrize("count", [0, 1, 2])
def test_fewer_than_three_objects_give_no_vector(count):
    assert topology_vector(*polar(*random_objects(0, count)), CENTER, (1, 2, 3)) is None


def test_three_objects_give_the_vector_computed_by_hand():
    rows = vector_rows([(10, 0, 1), (20, 90, 3), (5, 240, 2)], references_per_vector=4)
    # Farthest first, then clockwise: 90° → 240° → 360° → 450°.
    np.testing.assert_allclose(rows[0], [1, 0.25, 0.5, 0], atol=1e-7)
    np.testing.assert_allclose(rows[1], [1, 120 / 150, 90 / 150, 0], atol=1e-7)
    np.testing.assert_allclose(rows[2], [1, 2 / 3, 1 / 3, 0], atol=1e-7)


@pytest.mark.parametrize("table", PAPER["vectors"].values(), ids=PAPER["vectors"])
def test_the_papers_vectors_come_back_from_the_configuration_they_describe(table):
    ratios, differences, ranks = (np.array(row) for row in table)
    count = int((ratios > 0).sum())
    # The differences go once around, which gives their scale.
    degrees = differences[:count] * 360 / differences.sum()
    angles = 77.0 + np.concatenate([[0], np.cumsum(degrees)[:-1]])
    classes = np.round(ranks[:count] * 3).astype(int).tolist()
    rows = vector_rows(list(zip(ratios[:count] * 640, angles, classes)))
    np.testing.assert_allclose(rows, np.array(table), rtol=0, atol=1e-5)


@pytest.mark.parametrize("degrees", [0.0, 1e-7, 30.0, 90.0, 180.0, 211.3, 359.0])
@pytest.mark.parametrize("count", [3, 10, 15])
def test_turning_the_image_changes_nothing(count, degrees):
    objects = random_objects(count, count)
    turned = [(d, a + degrees, c) for d, a, c in objects]
    np.testing.assert_allclose(vector_rows(turned), vector_rows(objects), rtol=0, atol=1e-6)


def test_the_order_of_the_objects_changes_nothing_but_mirroring_the_image_does():
    objects = random_objects(2, 15)
    shuffled = [objects[k] for k in np.random.default_rng(3).permutation(15)]
    assert (vector_rows(shuffled) == vector_rows(objects)).all()
    objects = random_objects(5, 8)
    mirrored = [(d, -a, c) for d, a, c in objects]
    assert np.abs(vector_rows(mirrored) - vector_rows(objects)).max() > 0.1


def test_of_too_many_objects_the_nearest_are_kept():
    objects = random_objects(6, 30)
    nearest = sorted(objects)[:10]
    assert (vector_rows(objects) == vector_rows(nearest)).all()
    assert (vector_rows(objects) != vector_rows(sorted(objects)[:9] + [sorted(objects)[10]])).any()


def test_objects_all_in_one_direction_have_no_angle_differences():
    rows = vector_rows([(10, 33, 1), (20, 33, 2), (40, 33, 3)], references_per_vector=3)
    np.testing.assert_allclose(rows[0], [1, 0.25, 0.5], atol=1e-7)  # after the farthest the nearest
    assert rows[1].tolist() == [0, 0, 0]


@pytest.mark.parametrize("off", [0.0, 1e-13, -1e-13])
def test_an_object_exactly_at_the_center_has_angle_zero(off):
    points = np.array([[50.0 + off, 40.0 - off], [50.0, 60.0], [50.0, 30.0]])
    vector = topology_vector(points, np.array([1, 2, 3], np.uint8), CENTER, (1, 2, 3), 3)
    np.testing.assert_allclose(vector[:3], [1, 0.5, 0], atol=1e-7)  # 90°, 270°, then 0°
    np.testing.assert_allclose(vector[3:6], [1, 0.5, 0.5], atol=1e-7)


@pytest.mark.parametrize("noise", [1e-13, 1e-11, 1e-9])
@pytest.mark.parametrize("seed", range(5))
def test_rounding_errors_do_not_decide_ties(seed, noise):
    rng = np.random.default_rng(seed)
    thirds = (np.stack(np.meshgrid(np.arange(5), np.arange(5)), axis=-1).reshape(-1, 2) - 2.0) * 7 + 1 / 3
    points = np.concatenate([thirds, thirds]) + 500
    classes = np.repeat([1, 3], 25).astype(np.uint8)  # two objects at each place
    exact = topology_vector(points, classes, (500, 500), (1, 2, 3))
    shaken = topology_vector(points + rng.uniform(-noise, noise, points.shape), classes, (500, 500), (1, 2, 3))
    np.testing.assert_allclose(shaken, exact, rtol=0, atol=1e-6)


@pytest.mark.parametrize("last_two", [[(30, 200, 3), (30, 200, 1)], [(30, 200, 1), (30, 200, 3)]])
def test_of_two_objects_in_one_place_the_lower_rank_is_kept(last_two):
    """Rings in rings share a center of gravity; their order must not decide which one counts."""
    rows = vector_rows([(10, 0, 2), (20, 90, 2), *last_two], references_per_vector=3)
    np.testing.assert_allclose(rows[2], [1 / 3, 2 / 3, 2 / 3], atol=1e-7)


@pytest.mark.parametrize(
    ("classes", "expected"), [([], []), ([7], [2 / 3]), ([200, 3, 7, 3], [1, 1 / 3, 2 / 3, 1 / 3])]
)
def test_ranks_follow_the_order_of_the_class_values(classes, expected):
    for values in ((3, 7, 200), (200, 3, 7)):
        np.testing.assert_allclose(class_ranks(np.array(classes, np.uint8), values), expected)


@pytest.mark.parametrize("references_per_vector", [3, 5, 10, 40])
def test_many_images_at_once_equal_each_by_itself(references_per_vector):
    images = [random_objects(seed, count) for seed, count in enumerate((3, 30, 4, 10, 11, 25, 9))]
    offsets = np.full((len(images), 30, 2), np.inf)
    ranks = np.zeros((len(images), 30))
    for k, objects in enumerate(images):
        points, classes = polar(*objects)
        offsets[k, : len(points)] = points - CENTER
        ranks[k, : len(points)] = class_ranks(classes, (1, 2, 3))
    together = topology_vectors(offsets, ranks, references_per_vector)
    alone = [topology_vector(*polar(*objects), CENTER, (1, 2, 3), references_per_vector) for objects in images]
    assert together.dtype == np.float32
    assert (together == np.array(alone)).all()


def test_the_objects_of_a_vector_are_listed_in_its_order():
    """Farthest first, then by angle; objects beyond the X nearest are left out."""
    objects = [(10, 200, 1), (40, 100, 2), (30, 350, 3), (20, 20, 1), (90, 5, 2)]
    points, classes = polar(*objects)
    kept = vector_objects(points, classes, CENTER, (1, 2, 3), 4)
    assert kept.tolist() == [1, 0, 2, 3]
    vector = topology_vector(points, classes, CENTER, (1, 2, 3), 4)
    np.testing.assert_allclose(vector[8:], classes[kept] / 3, atol=1e-7)
    nothing = vector_objects(points[:0], classes[:0], CENTER, (1, 2, 3))
    assert nothing.dtype == np.int64 and nothing.shape == (0,)


EXACT = {"half": (0.5, 0.75), "threshold": (2.0, 0), "none": (float("inf"), 0)}
CONFIDENCES = {**PAPER["confidences"], **EXACT}


@pytest.mark.parametrize(("distance", "confidence"), CONFIDENCES.values(), ids=CONFIDENCES)
def test_confidences_are_those_of_the_papers_tables_4_and_5_and_fall_to_zero_at_the_threshold(distance, confidence):
    assert round(vector_confidence(distance), 2) == confidence


@pytest.mark.parametrize("count", [0, 1, 50])
def test_distances_are_euclidean(count):
    rng = np.random.default_rng(count)
    query, vectors = rng.random(30).astype(np.float32), rng.random((count, 30)).astype(np.float32)
    found = vector_distances(query, vectors)
    assert vector_distances(query, query[None]) == 0
    assert found.shape == (count,) and found.dtype == np.float64
    expected = [sum((float(a) - float(b)) ** 2 for a, b in zip(query, vector)) ** 0.5 for vector in vectors]
    np.testing.assert_allclose(found, expected, rtol=1e-12)
