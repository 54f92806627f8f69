"""Default noise of assessments and evaluations is valid and that of core."""

import pytest

from semref.core.evaluation.evaluation import TrialRanges
from semref.core.localization import Method
from semref.core.simulation.conditions import ASSUMED, LARGEST_LENS, LARGEST_TILT_DEG, conditions_of
from semref.processing.algorithms.evaluate_localization import ORDER
from semref.processing.algorithms.evaluate_localization import USUAL as RANGES
from semref.processing.base.assessing import USUAL


def test_usual_values_are_those_that_assessments_assume():
    found = conditions_of({key.lower(): value for key, (value, _) in USUAL.items()})
    for name in ("missed", "spurious", "mislabeled", "jitter", "background", "leaning"):
        assert getattr(found.noise, name) == pytest.approx(getattr(ASSUMED.noise, name)), name
    assert found.noise.displaced == pytest.approx(ASSUMED.noise.displaced, abs=0.05)
    assert (found.class_shift, found.lens, found.tilt_deg) == (ASSUMED.class_shift, ASSUMED.lens, ASSUMED.tilt_deg)


def test_the_largest_values_are_those_of_cameras():
    assert (USUAL["LENS"][1], USUAL["TILT"][1]) == (LARGEST_LENS, LARGEST_TILT_DEG)
    assert all(most is None or 0 <= value <= most for value, most in USUAL.values())


def test_every_range_is_one_of_an_evaluation():
    ranges = {key.lower(): limits for key, limits in RANGES.items()}
    assert vars(TrialRanges(**ranges)) == ranges


def test_every_method_has_its_place_and_the_published_one_the_last():
    assert set(ORDER) == set(Method) and len(ORDER) == len(Method) and ORDER[-1] is Method.TOPOLOGY_VECTOR
