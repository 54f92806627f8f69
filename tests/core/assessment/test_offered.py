"""What is usual is what assessments assume, and can be."""

import pytest

from semref.core.assessment.job import conditions_of
from semref.core.assessment.offered import OFFERED
from semref.core.simulation.conditions import ASSUMED, LARGEST_LENS, LARGEST_TILT_DEG


def test_usual_values_are_those_that_assessments_assume():
    usual = {name: value for name, (value, _) in OFFERED.items()}
    found = conditions_of(usual)
    for name in ("missed", "spurious", "mislabeled", "jitter", "background", "leaning"):
        assert getattr(found.noise, name) == pytest.approx(getattr(ASSUMED.noise, name)), name
    assert found.noise.displaced == pytest.approx(ASSUMED.noise.displaced, abs=0.05)
    assert (found.class_shift, found.lens, found.tilt_deg) == (ASSUMED.class_shift, ASSUMED.lens, ASSUMED.tilt_deg)


def test_the_largest_values_are_those_of_cameras():
    assert (OFFERED["lens"][1], OFFERED["tilt"][1]) == (LARGEST_LENS, LARGEST_TILT_DEG)
    assert all(most is None or 0 <= value <= most for value, most in OFFERED.values())
