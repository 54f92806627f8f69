"""Read CSV tables that users write: class tables, and rules from OpenStreetMap's tags to classes."""

from __future__ import annotations

from ..core import limits
from ..core.errors import ClassTableError, ParameterError
from ..core.labels.class_table import ClassTable, class_table_from_csv
from ..core.labels.openstreetmap import Rules, rules_from_csv
from ..core.tables import bytes_of

CLASSES_FILE = "classes.csv"
"""Name of the class table in a folder of training tiles."""


def read_class_table(path: str) -> ClassTable:
    """Read a class-table CSV in UTF-8 or Latin-1. Raises ClassTableError."""
    return class_table_from_csv(_table_text(path), path)


def read_rules(path: str) -> Rules:
    """Read a CSV of rules from OpenStreetMap's tags to classes. Raises ClassTableError, ParameterError."""
    return rules_from_csv(_table_text(path), path)


def _table_text(path: str) -> str:
    try:
        data = bytes_of(path, limits.TABLE_BYTES)
    except ParameterError as error:
        raise ClassTableError(error.sentence) from None
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("latin-1")
