"""Numbers are formatted by the user's locale."""

import pytest
from qgis.PyQt.QtCore import QLocale

from semref.core.sentences import Sentence
from semref.processing.messages.numbers import Local, count, shown
from semref.processing.messages.sentences import worded


@pytest.fixture
def german(qgis_app):
    before = QLocale()
    QLocale.setDefault(QLocale("de_DE"))
    yield
    QLocale.setDefault(before)


@pytest.mark.parametrize(
    ("number", "spec", "text"),
    [
        (14130, ",", "14.130"),
        (3.14159, ".2f", "3,14"),
        (1234567.891, ",.1f", "1.234.567,9"),
        (0.1234, ".1%", "12,3%"),
        (-2.5, "+.1f", "-2,5"),
        (7, "", "7"),
        (1e-12, ".0e", "1e-12"),
    ],
)
def test_a_number_has_the_separators_of_the_locale(german, number, spec, text):
    assert shown(number, spec) == text


def test_counts_have_groups_everywhere_alike(german):
    assert [count(number) for number in (999, 3918, 14130)] == ["999", "3.918", "14.130"]


def test_templates_show_their_numbers_so(german):
    assert f"{Local(12.34):.1f} km" == "12,3 km"


def test_sentences_of_core_show_their_numbers_so_and_their_texts_untouched(german):
    said = worded(
        Sentence("The nearest window has distance {distance:.3f}, more than {threshold:g}.", distance=2.25, threshold=2)
    )
    assert "2,250" in said
    assert worded(Sentence("{source}, line {line}", source="a.b,c", line=12)).count("a.b,c") == 1


def test_a_sentence_without_values_is_a_plain_text_that_qgis_takes_into_columns():
    assert type(worded(Sentence("Some fixes would be wrong."))) is str
