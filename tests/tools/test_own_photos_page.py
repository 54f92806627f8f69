"""The page on one's own photos says what the dock says: its buttons, and its sentences word by word."""

from __future__ import annotations

import html
import re

import pytest

PAGE = "docs/tutorials/own_area_and_photos.md"
EMPHASIS = {"as a flight", "GPS takes no part in a fix"}
"""What stands in italics and is no text of the dock."""

FEWEST_LETTERS = 12
"""A text of hardly more than placeholders would fit everything."""


@pytest.fixture(scope="module")
def patterns(repository):
    """What each English text of SemRef looks like when its placeholders are filled."""
    catalogue = (repository / "i18n" / "semref_de.ts").read_text(encoding="utf-8")
    texts = {html.unescape(text) for text in re.findall(r"<source>(.*?)</source>", catalogue, flags=re.DOTALL)}
    return {re.compile(filled(text.removeprefix("{reason} "))): text for text in texts}


def filled(text: str) -> str:
    """A regular expression for a text with values in place of its placeholders."""
    return ".+?".join(re.escape(part) for part in re.split(r"\{[^}]*\}", text))


def is_said(sentence: str, patterns: dict) -> bool:
    """Whether it is one of the texts with values in it."""
    letters = [text for pattern, text in patterns.items() if pattern.fullmatch(sentence)]
    return any(len(re.sub(r"\{[^}]*\}|\W", "", text)) >= FEWEST_LETTERS for text in letters)


def test_what_is_quoted_is_what_is_said(repository, patterns):
    lines = (repository / PAGE).read_text(encoding="utf-8").splitlines()
    quoted = [line[2:] for line in lines if line.startswith("> ")]
    assert len(quoted) >= 8
    for sentence in quoted:
        parts = [sentence] if is_said(sentence, patterns) else sentence.rstrip(".").split("; ")
        for part in parts:
            # A clause of a sentence begins with a small letter.
            assert is_said(part, patterns) or is_said(part[0].lower() + part[1:], patterns), part


def test_what_is_named_to_press_is_there(repository, patterns):
    page = (repository / PAGE).read_text(encoding="utf-8")
    body = re.sub(r"<!-- walk.*?/walk -->|^\*\[[^\n]*\*$", "", page, flags=re.DOTALL | re.MULTILINE)
    named = re.findall(r"(?<![*\w])\*([^*\n]+)\*(?!\*)", body)
    known = set(patterns.values())
    begun = {text.partition(" (")[0] for text in known}
    missing = [
        text
        for text in named
        if text not in known | begun | EMPHASIS and not any(p.fullmatch(text.replace("…", "9")) for p in patterns)
    ]
    assert len(named) > 15 and missing == []
