"""Numbers in the user's language, and tool tips of texts that come from files."""

from __future__ import annotations

from html import escape

from ...processing.messages.numbers import shown


def number_text(value: float, decimals: int = 0) -> str:
    """Format a number with the language's decimal sign and groups of digits."""
    return shown(float(value), f",.{decimals}f")


def plain_tip(text: str) -> str:
    """Return a tool tip that shows the text as it is: Qt takes what looks like HTML for HTML, and loads its images."""
    return f"<p>{escape(text)}</p>".replace("\n", "<br>") if "<" in text else text
