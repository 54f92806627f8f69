"""Numbers as the user's language writes them."""

from __future__ import annotations

from qgis.PyQt.QtCore import QLocale


def number_text(value: float, decimals: int = 0) -> str:
    """With the language's decimal sign and groups of digits."""
    return QLocale().toString(float(value), "f", decimals)
