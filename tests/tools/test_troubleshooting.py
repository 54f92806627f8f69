"""The page of messages has every sentence that SemRef says, and what is added to it belongs to sentences that exist."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools" / "docs"))

import troubleshooting  # noqa: E402


@pytest.fixture(scope="module")
def sentences() -> dict[str, str]:
    return troubleshooting.sentences()


def test_what_is_explained_stands_on_the_page_as_it_is_said():
    """Building the guide writes the page anew; between two times other sentences may be older on it."""
    written = troubleshooting.PAGE.read_text(encoding="utf-8")
    assert {
        template for template in troubleshooting.notes() if troubleshooting.shown(template) not in written
    } == set(), "run tools/docs/troubleshooting.py"


def test_the_page_that_is_written_has_every_sentence(sentences):
    page = troubleshooting.page(sentences)
    assert [template for template in sentences if troubleshooting.shown(template).partition("; ")[0] not in page] == []


def test_every_note_belongs_to_a_sentence_that_is_said(sentences):
    assert set(troubleshooting.notes()) - set(sentences) == set()


def test_sentences_of_a_new_room_have_a_place_until_somebody_finds_a_better_one():
    page = troubleshooting.page({"Something new.": "novel/x.py"})
    assert page.index(f"## {troubleshooting.OTHERS}") < page.index("| Something new. |")


def test_every_reason_that_an_image_has_no_position_is_explained():
    reasons = troubleshooting.reasons()
    assert reasons - set(troubleshooting.notes()) == set()


def test_values_are_shown_by_what_they_are_and_what_to_do_stands_by_itself():
    template = "{path} has {size_mb:.1f} MB; choose another."
    assert troubleshooting.page({template: "storage/x.py"}).count("| *path* has *size mb* MB. | Choose another. |") == 1
