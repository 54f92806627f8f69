"""Tables that people write as text: classes, and rules from OpenStreetMap's tags to them."""

from __future__ import annotations

from ..core import limits
from ..core.errors import ClassTableError, ParameterError
from ..core.flight.table import bytes_of
from ..core.labels.class_table import ClassTable, class_table_from_csv
from ..core.labels.openstreetmap import Rules, rules_from_csv

CLASSES_FILE = "classes.csv"
"""A class table beside what it describes."""


def read_class_table(path: str) -> ClassTable:
    """A class-table CSV in UTF-8 (or, failing that, Latin-1); raises ClassTableError."""
    return class_table_from_csv(_table_text(path), path)


def read_rules(path: str) -> Rules:
    """Rules from OpenStreetMap's tags to classes, a CSV as class tables are; raises ClassTableError, ParameterError."""
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
