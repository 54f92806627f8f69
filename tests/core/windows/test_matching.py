"""Distances between vectors, and the confidences that the paper prints for them."""

import numpy as np
import pytest

from semref.core.windows.topology_vector import DISTANCE_THRESHOLD, vector_confidence, vector_distances

# (smallest Euclidean distance, confidence) as printed: rounded to two decimals, all of them.
PAPER_TABLE_4 = {
    "scale 1.8": (1.650056, 0.17),
    "scale 1.5": (1.404390, 0.30),
    "scale 1.2": (0.209932, 0.90),
    "scale 1": (0.0, 1),
    "scale 0.8": (0.086993, 0.96),
    "scale 0.75": (0.151239, 0.92),
    "scale 0.65": (0.276655, 0.86),
    "scale 0.6": (0.303107, 0.85),
}
PAPER_TABLE_4_FAILURES = {"scale 2": 2.674882, "scale 0.5": 2.720949}
PAPER_TABLE_5 = {
    "turned 0°": (0.0, 1),
    "turned 30°": (0.031209, 0.98),
    "turned 60°": (0.103701, 0.95),
    "turned 90°": (0.000403, 1),
    "turned 120°": (0.059721, 0.97),
    "turned 150°": (0.108878, 0.95),
    "turned 180°": (0.000754, 1),
    "turned 210°": (0.044473, 0.98),
    "turned 240°": (0.10018, 0.95),
    "turned 270°": (0.000679, 1),
    "turned 300°": (0.0421, 0.98),
    "turned 330°": (0.107759, 0.95),
}
SUCCESSES = {**PAPER_TABLE_4, **PAPER_TABLE_5}


@pytest.mark.parametrize(("distance", "confidence"), SUCCESSES.values(), ids=SUCCESSES)
def test_confidences_are_those_of_the_papers_tables_4_and_5(distance, confidence):
    assert round(vector_confidence(distance), 2) == confidence


@pytest.mark.parametrize("distance", PAPER_TABLE_4_FAILURES.values(), ids=PAPER_TABLE_4_FAILURES)
def test_the_papers_two_failures_lie_beyond_the_threshold(distance):
    assert distance > DISTANCE_THRESHOLD
    assert vector_confidence(distance) == 0


@pytest.mark.parametrize(("distance", "confidence"), [(0, 1), (0.5, 0.75), (2, 0), (2.0001, 0), (float("inf"), 0)])
def test_confidence_falls_from_one_to_zero_at_the_threshold(distance, confidence):
    assert vector_confidence(distance) == confidence


@pytest.mark.parametrize("count", [0, 1, 50])
def test_distances_are_euclidean(count):
    rng = np.random.default_rng(count)
    query, vectors = rng.random(30).astype(np.float32), rng.random((count, 30)).astype(np.float32)
    found = vector_distances(query, vectors)
    assert found.shape == (count,) and found.dtype == np.float64
    expected = [sum((float(a) - float(b)) ** 2 for a, b in zip(query, vector)) ** 0.5 for vector in vectors]
    np.testing.assert_allclose(found, expected, rtol=1e-12)


def test_an_equal_vector_has_distance_exactly_zero():
    vectors = np.random.default_rng(1).random((5, 30)).astype(np.float32)
    assert vector_distances(vectors[3], vectors)[3] == 0.0
