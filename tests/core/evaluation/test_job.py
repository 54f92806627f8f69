"""A job creates its evaluation, with mirrored images and extra images for the tables."""

import pytest

from semref.core.evaluation.evaluation import MOST_IN_A_CELL, Evaluation
from semref.core.localization import Method

BOTH = [Method.AUTOMATIC, Method.TOPOLOGY_VECTOR]


class Planner:
    def trials(self, count, mirrored):
        return [("map", n) for n in range(count)] + [("mirrored", n) for n in range(mirrored)]

    def noise_grid(self, count):
        return [("noise", n) for n in range(count)]

    def moves(self, count):
        return [("offset", n) for n in range(count)]

    def tables(self):
        return [("scaling", 0)]


@pytest.mark.parametrize(("count", "share", "mirrored"), [(200, 0.25, 50), (1, 0.9, 0), (3, 0.9, 2), (10, 0.0, 0)])
def test_so_many_are_mirrored_but_one_at_least_is_of_the_map(count, share, mirrored):
    jobs = Evaluation.plan(Planner(), BOTH, count, share, False)
    kinds = [query[0] for query, _ in jobs]
    assert kinds.count("mirrored") == mirrored and len(kinds) == count
    assert all(methods == BOTH for _, methods in jobs)


@pytest.mark.parametrize(("count", "a_cell"), [(1, 2), (160, 10), (100_000, MOST_IN_A_CELL)])
def test_a_report_has_more_images_and_its_grid_of_noise_the_first_method(count, a_cell):
    jobs = Evaluation.plan(Planner(), BOTH, count, 0.25, True)[count:]
    assert [query[0] for query, _ in jobs] == ["noise"] * a_cell + ["offset"] * a_cell + ["scaling"]
    assert all(methods == (BOTH[:1] if query[0] == "noise" else BOTH) for query, methods in jobs)
