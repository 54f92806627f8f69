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
