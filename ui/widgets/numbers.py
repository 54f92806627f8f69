"""Numbers as the user's language writes them."""

from __future__ import annotations

from qgis.PyQt.QtCore import QLocale


def number_text(value: float, decimals: int = 0) -> str:
    """With the language's decimal sign and groups of digits."""
    locale = QLocale()
    # QGIS leaves groups out unless its user wants them everywhere; a million can't be read without them.
    locale.setNumberOptions(locale.numberOptions() & ~QLocale.NumberOption.OmitGroupSeparator)
    return locale.toString(float(value), "f", decimals)
