"""Evaluation results as JSON: each trial once for each method, and the given settings."""

import json

from semref.core.evaluation.as_json import FIELDS, evaluation_json, values_of
from semref.core.evaluation.evaluation import MAP, MIRRORED, WindowQuery
from semref.core.evaluation.rates import Rate
from semref.core.evaluation.trial import judge
from semref.core.localization import Localization, Method, Place, Status
from semref.core.simulation.views import View

FOUND = Localization(Status.FIX, Method.CONSTELLATION, 9, best=Place((103.0, 204.0), 30.0, 1.0), confidence=0.999)


def trials():
    made = []
    for number in range(4):
        query = WindowQuery(View(100.0, 200.0, 30.0, is_mirrored=number == 3), MAP if number < 3 else MIRRORED, number)
        result = FOUND if number == 0 else Localization(Status.NO_MATCH, Method.CONSTELLATION)
        made.append(judge(query, Method.CONSTELLATION, result))
    return made


def test_a_trial_has_every_column_and_how_far_off_it_is():
    values = values_of(trials()[0])
    assert list(values) == [name for name, _ in FIELDS]
    assert (values["error"], values["right"], values["true_x"], values["x"]) == (5.0, 1, 100.0, 103.0)


def test_the_text_has_settings_rates_and_trials():
    told = json.loads(evaluation_json(trials(), [Method.CONSTELLATION], {"SEED": 3}, Rate(7, 9)))
    assert (
        told["settings"] == {"SEED": 3}
        and told["windows"] == {"tried": 7, "all": 9}
        and list(told["methods"]) == ["constellation"]
    )
    right = told["methods"]["constellation"]["right"]
    assert 0 < right["low"] < right["share"] == 1 / 3 < right["high"] < 1
    assert [trial["kind"] for trial in told["trials"]] == [MAP] * 3 + [MIRRORED]
