"""How poor labels are, in a word: the presets of assessments and evaluations."""

from __future__ import annotations

import pytest
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingParameterDefinition

AS_GIVEN, GOOD, USABLE, POOR = range(4)


@pytest.fixture
def conditions(qgis_app):
    """`conditions(id, parameters)`: what is simulated."""
    from semref.processing.framework.values import Values

    def of(name: str, parameters: dict):
        algorithm = QgsApplication.processingRegistry().createAlgorithmById(name)
        return algorithm.conditions(Values(algorithm, parameters, QgsProcessingContext()))

    return of


@pytest.mark.parametrize("name", ["semref:assessdatabase", "semref:assessroute"])
def test_a_preset_is_a_multiple_of_what_is_assumed_and_leaves_map_and_camera(conditions, name):
    given = conditions(name, {})
    assert conditions(name, {"NETWORK": USABLE, "MISSED": 77}) == given
    for preset, factor in ((GOOD, 0.5), (POOR, 2.0)):
        found = conditions(name, {"NETWORK": preset, "TILT": 7})
        network = (found.noise.missed, found.noise.spurious, found.noise.mislabeled, found.noise.jitter)
        assert network == pytest.approx((0.2 * factor, 0.2 * factor, 0.05 * factor, factor))
        assert found.class_shift == pytest.approx(factor * given.class_shift)
        assert (found.lens, found.noise.displaced, found.tilt_deg) == (given.lens, given.noise.displaced, 7)


def test_numbers_count_where_no_preset_is_chosen(conditions):
    found = conditions("semref:assessroute", {"MISSED": 33, "NETWORK": AS_GIVEN})
    assert found.noise.missed == pytest.approx(0.33) and found.noise.spurious == pytest.approx(0.2)


@pytest.mark.parametrize(("name", "most"), [("assessroute", 6), ("assessdatabase", 4)])
def test_only_what_matters_is_unfolded(qgis_app, name, most):
    algorithm = QgsApplication.processingRegistry().createAlgorithmById(f"semref:{name}")
    folded = QgsProcessingParameterDefinition.FlagAdvanced
    shown = [p.name() for p in algorithm.parameterDefinitions() if not p.isDestination() and not p.flags() & folded]
    assert len(shown) == most and shown[-2:] == ["NETWORK", "COMPARISON"]
