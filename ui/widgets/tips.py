"""Tool tips of texts that come from files."""

from __future__ import annotations

from html import escape


def plain_tip(text: str) -> str:
    """The text as a tool tip that shows it as it is: Qt takes what looks like HTML for HTML, and loads its images."""
    return f"<p>{escape(text)}</p>".replace("\n", "<br>") if "<" in text else text
