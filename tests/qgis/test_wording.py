import pytest
from made_inputs import square, write_layer
from qgis.core import QgsProcessingFeedback, QgsVectorLayer
from qgis.PyQt.QtCore import QLocale

from semref.core.annotation.findings import CHECKED_KINDS, ERROR, Finding
from semref.core.errors import ModelError
from semref.core.evaluation.evaluation import MAP, MIRRORED
from semref.core.localization import Method, shown_landmarks
from semref.core.sentences import Sentence
from semref.processing.messages import annotation_messages, sentences
from semref.processing.messages.columns import column_words
from semref.processing.messages.numbers import Local, count, shown
from semref.processing.messages.sentences import worded


@pytest.fixture
def language(monkeypatch):
    """`language({"English": "another language"})` translates those templates."""
    return lambda texts: monkeypatch.setattr(sentences, "tr", lambda text: texts.get(text, text))


def test_an_error_has_the_text_of_its_sentence():
    said = Sentence("{path} does not exist.", path="a.onnx")
    assert worded(ModelError(said)) == worded(said) == str(said)


def test_a_sentence_and_those_among_its_values_are_translated(language):
    language({"{where}: {fault}": "{where} : {fault}", "The image has no pixels.": "L’image n’a aucun pixel."})
    sentence = Sentence("{where}: {fault}", where="a.csv", fault=Sentence("The image has no pixels."))
    assert worded(sentence) == "a.csv : L’image n’a aucun pixel."


@pytest.mark.parametrize(("count", "said"), [(1, "1 Landmarke"), (3, "3 Landmarken")])
def test_each_form_of_a_plural_is_translated_by_itself(language, count, said):
    one, other = "The image shows {count} landmark", "The image shows {count} landmarks"
    language({one: "{count} Landmarke", other: "{count} Landmarken"})
    assert worded(shown_landmarks(count)) == said


def test_a_severity_is_called_the_same_in_legend_table_report_dock_and_log(qgis_app, run_algorithm, tmp_path):
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


def test_kinds_and_methods_of_trials_have_labels(qgis_app):
    words = column_words(["kind", "road", "trial"])
    assert {MAP, MIRRORED} == set(words["kind"])
    assert {method.key for method in Method} == set(words["road"])


def test_every_kind_of_finding_has_a_title_a_sentence_and_a_description(qgis_app, repository):
    page = (repository / "docs" / "how-to" / "correct_a_layer.md").read_text(encoding="utf-8")
    for kind in CHECKED_KINDS:
        assert annotation_messages.kind_titles().get(kind), f"add {kind} to kind_titles"
        assert annotation_messages.sentence(Finding(kind, ERROR), {}), f"add {kind} to _check_template"
        assert f"`{kind}`" in page, f"add {kind} to the page"


@pytest.fixture
def german(qgis_app):
    before = QLocale()
    QLocale.setDefault(QLocale("de_DE"))
    yield
    QLocale.setDefault(before)


@pytest.mark.parametrize(
    ("number", "spec", "text"),
    [
        *((14130, ",", "14.130"), (1234567.891, ",.1f", "1.234.567,9"), (3.14159, ".2f", "3,14"), (7, "", "7")),
        *((0.1234, ".1%", "12,3%"), (-2.5, "+.1f", "-2,5"), (1e-12, ".0e", "1e-12")),
    ],
)
def test_a_number_has_the_separators_of_the_locale(german, number, spec, text):
    assert shown(number, spec) == text


def test_counts_templates_and_sentences_of_core_show_their_numbers_so_and_their_texts_untouched(german):
    assert [count(number) for number in (999, 3918, 14130)] == ["999", "3.918", "14.130"]
    assert f"{Local(12.34):.1f} km" == "12,3 km"
    template = "The nearest window has distance {distance:.3f}, more than {threshold:g}."
    assert "2,250" in worded(Sentence(template, distance=2.25, threshold=2))
    assert worded(Sentence("{source}, line {line}", source="a.b,c", line=12)).count("a.b,c") == 1


def test_a_sentence_without_values_is_a_plain_text_that_qgis_takes_into_columns():
    assert type(worded(Sentence("Some fixes would be wrong."))) is str
