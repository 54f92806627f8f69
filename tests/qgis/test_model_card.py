"""The page of a model card in QGIS."""

from semref.core.segmentation.model_card import Ground, ModelCard
from semref.processing.reports.model_card import card_html


def test_no_text_of_a_model_becomes_markup():
    hostile = "<b>a&b</b>"
    ground = Ground(hostile, hostile, True, {hostile: 0.5})
    card = ModelCard(
        hostile, None, hostile, (hostile,), 0.25, trained_on=(ground,), tested_on=(ground,), license=hostile
    )
    assert "<b>a" not in card_html(card) and card_html(card).count("&lt;b&gt;a&amp;b&lt;/b&gt;") == 8
