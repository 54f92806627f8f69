"""Numbers in the user's language, and tool tips with texts from files."""

from __future__ import annotations

from html import escape

from ...processing.messages.numbers import shown


def number_text(value: float, decimals: int = 0) -> str:
    """Format a number with the language's decimal sign and groups of digits."""
    return shown(float(value), f",.{decimals}f")


def plain_tip(text: str) -> str:
    """Return a tool tip with the text as it is. Qt would interpret text that looks like HTML, and load its images."""
    return f"<p>{escape(text)}</p>".replace("\n", "<br>") if "<" in text else text
