"""A job contains the common settings of its assessments and creates them again."""

from semref.core.assessment.assessment import Assessment, AssessmentJob
from semref.core.simulation.conditions import Conditions
from semref.core.simulation.noise import USUAL


def test_a_job_makes_the_assessments_again(assessed_database, localizer):
    made = [Assessment(assessed_database, localizer, edge, Conditions(USUAL), seed=5) for edge in (250.0, 180.0)]
    job = AssessmentJob.of(made[0])
    assert job.has_overview == (assessed_database.overview is not None)
    places = assessed_database.references.positions[:4]
    for first in made:
        again = job.assessment(assessed_database, localizer, first.footprint)
        assert again.plan(places, 50.0, 6) == first.plan(places, 50.0, 6)
        assert (again.seed, again.correlation, again.conditions) == (first.seed, first.correlation, first.conditions)
