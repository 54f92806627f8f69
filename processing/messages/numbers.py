"""Numbers as the user's locale writes them: the one place for reports, map tips, sentences and the dock."""

from __future__ import annotations

from typing import Any

try:
    from qgis.PyQt.QtCore import QLocale
except ImportError:
    # Pages of reports are put together without QGIS, too: then as Python writes numbers.
    QLocale = None


def shown(number: float, spec: str = "") -> str:
    """A number as ``format(number, spec)`` has it, with the separators of the user's locale.

    >>> shown(14130, ",")  # in German
    '14.130'

    Args:
        number: Any number.
        spec: Python's format; a comma in it asks for groups of three digits.
    """
    if QLocale is None:
        return format(number, spec)
    locale = QLocale()
    signs = {ord(","): str(locale.groupSeparator()), ord("."): str(locale.decimalPoint())}
    return format(number, spec).translate(signs)


def count(number: int) -> str:
    """How many of something there are, in groups of three digits."""
    return shown(number, ",")


class Local(float):
    """A number that templates show by the user's locale: ``"{length:.1f} km".format(length=Local(length))``."""

    def __format__(self, spec: str) -> str:
        """As ``shown``; with a fixed number of decimals in groups of three digits, as counts have them."""
        decimals = spec.startswith(".") and spec.endswith("f")
        return shown(float(self), f",{spec}" if decimals else spec)


class LocalTemplate(str):
    """A template of a sentence that shows its numbers by the user's locale."""

    def format(self, *args: Any, **values: Any) -> str:
        """As ``str.format``."""
        # Python gives a text without values back as it is, and QGIS takes nothing but plain ones into columns.
        return str(super().format(*args, **{name: _local(value) for name, value in values.items()}))


def _local(value: Any) -> Any:
    return Local(value) if isinstance(value, float) else _Whole(value) if type(value) is int else value


class _Whole(int):
    """A whole number in a template; without a format it has no groups, as it may be the number of a feature."""

    def __format__(self, spec: str) -> str:
        return shown(int(self), spec)
