"""Usual ranges are ranges of an evaluation, and every method has its place."""

from semref.core.evaluation.evaluation import TrialRanges
from semref.core.evaluation.offered import OFFERED, ORDER
from semref.core.localization import Method


def test_every_range_is_offered_and_can_be():
    assert vars(TrialRanges(**OFFERED)) == OFFERED


def test_every_method_has_its_place_and_the_published_one_the_last():
    assert set(ORDER) == set(Method) and len(ORDER) == len(Method) and ORDER[-1] is Method.TOPOLOGY_VECTOR
