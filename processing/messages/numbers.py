"""Numbers in the user's locale, for reports, map tips, sentences and the dock."""

from __future__ import annotations

from typing import Any

try:
    from qgis.PyQt.QtCore import QLocale
except ImportError:
    # Reports are also made without QGIS, with numbers as in Python.
    QLocale = None


def shown(number: float, spec: str = "") -> str:
    """Format a number as ``format(number, spec)`` does, with the separators of the user's locale.

    >>> shown(14130, ",")  # in German
    '14.130'

    Args:
        spec: Python's format; a comma in it asks for groups of three digits.
    """
    if QLocale is None:
        return format(number, spec)
    locale = QLocale()
    signs = {ord(","): str(locale.groupSeparator()), ord("."): str(locale.decimalPoint())}
    return format(number, spec).translate(signs)


def count(number: int) -> str:
    """Format a count in groups of three digits."""
    return shown(number, ",")


class Local(float):
    """A number that templates show in the user's locale: ``"{length:.1f} km".format(length=Local(length))``."""

    def __format__(self, spec: str) -> str:
        """Format as ``shown`` does; a fixed number of decimals also groups three digits."""
        decimals = spec.startswith(".") and spec.endswith("f")
        return shown(float(self), f",{spec}" if decimals else spec)


class LocalTemplate(str):
    """A template of a sentence that shows its numbers in the user's locale."""

    def format(self, *args: Any, **values: Any) -> str:
        # Without values str.format returns this object itself, and QGIS takes only plain strings into columns.
        return str(super().format(*args, **{name: _local(value) for name, value in values.items()}))


def _local(value: Any) -> Any:
    return Local(value) if isinstance(value, float) else _Whole(value) if type(value) is int else value


class _Whole(int):
    """A whole number in a template; without a format it has no groups, because it may be a feature id."""

    def __format__(self, spec: str) -> str:
        return shown(int(self), spec)
