"""The line below the button, and its second sentence."""

import pytest

from semref.ui.widgets.progress import StatusLine

SAID, ASIDE = "2 of 2 images have a position.", "CPU, 11.6 tiles per second."


@pytest.fixture
def line(qgis_app):
    line = StatusLine()
    line.show_text(SAID, ASIDE)
    line.show()
    yield line
    line.close()


def test_a_narrow_line_shows_the_second_sentence_in_the_tool_tip_and_is_shortened_in_the_middle(line):
    line.resize(2000, 20)
    assert line.text() == f"{SAID} {ASIDE}"
    line.resize(line.fontMetrics().horizontalAdvance(SAID) + 5, 20)
    assert line.text() == SAID
    assert line.toolTip() == line.text_shown == f"{SAID} {ASIDE}"
    line.resize(line.fontMetrics().horizontalAdvance(SAID) // 2, 20)
    assert "…" in line.text() and line.text().startswith("2 of") and line.text().endswith("ition.")
