"""The page of a model card."""

import sys
from pathlib import Path

import pytest

from semref.core.segmentation.model_card import Ground, ModelCard
from semref.processing.reports.model_card import card_html

TOOLS = Path(__file__).resolve().parents[2] / "tools"


@pytest.fixture(scope="module", autouse=True)
def tools():
    """Allow imports from tools/, as in its commands."""
    sys.path.append(str(TOOLS))
    yield
    sys.path.remove(str(TOOLS))


def test_the_page_of_a_card_has_what_the_card_has():
    from training.card_page import card_page

    tested = (Ground("Kenya", "flats", True, {"building": 0.612}),)
    card = ModelCard("a/houses.onnx", None, "Houses", ("other", "building"), 0.25, tested_on=tested, not_for="ships")
    page = card_page(card)
    assert page.startswith("# Houses\n\n`houses.onnx`\n")
    for line in ("| classes | other, building |", "| trained at | 0.25 m a pixel |", "| not good for | ships |"):
        assert line in page
    assert "| Kenya, left out of training | 0.612 |" in page and "license" not in page


def test_no_text_of_a_model_becomes_markup():
    hostile = "<b>a&b</b>"
    ground = Ground(hostile, hostile, True, {hostile: 0.5})
    card = ModelCard(
        hostile, None, hostile, (hostile,), 0.25, trained_on=(ground,), tested_on=(ground,), license=hostile
    )
    assert "<b>a" not in card_html(card) and card_html(card).count("&lt;b&gt;a&amp;b&lt;/b&gt;") == 8
