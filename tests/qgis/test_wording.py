"""Sentences in the user's language, with the key of the algorithm that says them."""

from __future__ import annotations

import pytest

from semref.core.errors import ModelError
from semref.core.sentences import Sentence
from semref.processing.wording import sentences
from semref.processing.wording.keys import SENTENCES_BY_KEY
from semref.processing.wording.sentences import worded

NAMELESS = Sentence("segmentation.no_class_names", source="a.onnx")


@pytest.fixture
def language(monkeypatch):
    """`language({"English": "another language"})` translates those templates."""
    return lambda texts: monkeypatch.setattr(sentences, "tr", lambda text: texts.get(text, text))


def test_an_error_says_what_its_sentence_says():
    assert worded(ModelError(NAMELESS)) == worded(NAMELESS) == str(NAMELESS)


def test_a_sentence_and_those_among_its_values_are_translated(language):
    language({"{where}: {fault}": "{where} : {fault}", "The image has no pixels.": "L’image n’a aucun pixel."})
    sentence = Sentence("labels.at_line", where="a.csv", fault=Sentence("labels.no_pixels"))
    assert worded(sentence) == "a.csv : L’image n’a aucun pixel."


@pytest.mark.parametrize(("count", "said"), [(1, "1 Landmarke"), (3, "3 Landmarken")])
def test_each_form_of_a_plural_is_translated_by_itself(language, count, said):
    one, other = "The image shows {count} landmark", "The image shows {count} landmarks"
    language({one: "{count} Landmarke", other: "{count} Landmarken"})
    assert worded(Sentence("localization.shows_landmarks", count=count)) == said


def test_an_algorithm_with_the_key_says_it_and_others_do_not():
    assert "give them in CLASS_TABLE" in worded(NAMELESS, ["INPUT", "CLASS_TABLE"])
    assert "CLASS_TABLE" not in worded(NAMELESS, ["INPUT"])


def test_a_setting_of_core_is_called_by_the_key_of_the_algorithm_that_has_one():
    sentence = Sentence("assessment.range", setting="missed", low=2.0, high=1.0, least=0.0, most=100.0)
    assert worded(sentence).startswith("missed goes from 2 to 1;")
    assert worded(sentence, ["MISSED"]).startswith("MISSED goes from 2 to 1;")


def test_what_everybody_has_is_told_everywhere():
    sentence = Sentence("onboard.foreign", path="a.npz")
    assert "“Export for onboard use”" in worded(sentence) and "Export" not in str(sentence)


@pytest.mark.parametrize("code", sorted(SENTENCES_BY_KEY))
def test_words_for_a_key_name_it(code):
    key, template = SENTENCES_BY_KEY[code]
    assert key in template


def test_a_severity_is_called_the_same_in_legend_table_report_dock_and_log(qgis_app, run_algorithm, tmp_path):
    from made_inputs import square, write_layer
    from qgis.core import QgsProcessingFeedback, QgsVectorLayer

    path = write_layer(tmp_path / "annotation.gpkg", [(square(10, 10, 30), "a"), (square(10, 10, 30), "b")])
    feedback = QgsProcessingFeedback(False)
    issues, report = str(tmp_path / "issues.gpkg"), tmp_path / "report.html"
    given = {"INPUT": str(path), "CLASS_FIELD": "class", "ISSUES": issues, "REPORT": str(report)}
    run_algorithm("semref:checkannotation", given, feedback)
    layer = QgsVectorLayer(issues, "issues", "ogr")
    words = ["Error", "Warning", "Information"]
    assert [category.label() for category in layer.renderer().categories()] == words
    setup = layer.editorWidgetSetup(layer.fields().lookupField("severity")).config()["map"]
    assert [word for entry in setup for word in entry] == words
    page = report.read_text(encoding="utf-8")
    assert all(f">{word}<" in page for word in words) and "errors</" not in page
    assert "duplicate (Error): 1" in feedback.textLog()


def test_kinds_and_roads_of_trials_have_words(qgis_app):
    from semref.core.evaluation.evaluation import MAP, MIRRORED
    from semref.core.localization import Method
    from semref.processing.wording.columns import column_words

    words = column_words(["kind", "road", "trial"])
    assert {MAP, MIRRORED} == set(words["kind"])
    assert {method.key for method in Method} == set(words["road"])
