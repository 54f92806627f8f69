"""Numbers as the user's language writes them."""

from __future__ import annotations

from ...processing.wording.numbers import shown


def number_text(value: float, decimals: int = 0) -> str:
    """With the language's decimal sign and groups of digits."""
    return shown(float(value), f",.{decimals}f")
