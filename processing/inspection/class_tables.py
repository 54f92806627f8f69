"""Class tables for an editor: rows of texts, read from and written to files, and their errors."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ..base.annotation import CLASS_TABLES, PRESETS
from ..translation import tr


@dataclass(frozen=True)
class ClassRow:
    """A class as the user edits it: unchecked texts.

    Attributes:
        value: Class value.
        color: ``#rrggbb``.
        order: Draw order; may be empty.
        hsv: Lowest and highest color of label images, as in the file.
    """

    value: str
    name: str
    color: str
    is_landmark: bool = False
    order: str = ""
    hsv: tuple[str, str] = ("", "")


def read_rows(path: str) -> list[ClassRow]:
    """Return the classes of a file; empty without a file. Raises ClassTableError."""
    from ...storage.text_tables import read_class_table

    return _rows(read_class_table(path).to_csv()) if path else []


def preset_titles() -> list[str]:
    """Return the titles of the nomenclatures in the plugin."""
    return list(PRESETS)


def preset_rows(number: int) -> list[ClassRow]:
    """Return the classes of a nomenclature, by its index in ``preset_titles``."""
    return read_rows(list(PRESETS.values())[number])


def is_shipped(path: str) -> bool:
    """Return whether a file is part of the plugin, so that an update would replace it."""
    return os.path.dirname(os.path.realpath(path)) == os.path.realpath(CLASS_TABLES)


def new_row(values: Iterable[str]) -> ClassRow:
    """Return a new class with the first free value."""
    from ...core.labels.class_colors import default_color
    from ...core.labels.class_table import MAXIMUM_VALUE

    taken = set(values)
    value = next((n for n in range(1, MAXIMUM_VALUE + 1) if str(n) not in taken), MAXIMUM_VALUE)
    return ClassRow(str(value), tr("class {number}").format(number=value), default_color(value))


def require_table(rows: Sequence[ClassRow]) -> str:
    """Return the CSV text of a table of these classes. Raises ClassTableError if they are invalid."""
    from ...core.labels.class_table import BACKGROUND, REFERENCE, ClassTable, class_table_from_csv

    text = io.StringIO(ClassTable(()).to_csv())
    text.seek(0, io.SEEK_END)
    writer = csv.writer(text, lineterminator="\n")
    for row in rows:
        role = REFERENCE if row.is_landmark else BACKGROUND
        # A file has one class per line.
        cells = (row.value, row.name, row.color, role, row.order, *row.hsv)
        writer.writerow([" ".join(cell.split()) for cell in cells])
    return class_table_from_csv(text.getvalue(), tr("Class table")).to_csv()


def save_rows(rows: Sequence[ClassRow], path: str) -> None:
    """Write a class table. Raises ClassTableError, or ParameterError if it cannot be written."""
    from ...storage.atomic_output import written_beside

    text = require_table(rows)
    with written_beside(path, ".csv") as temporary, open(temporary, "w", encoding="utf-8") as file:
        file.write(text)


def _rows(text: str) -> list[ClassRow]:
    """Return the rows in the CSV text of a table."""
    from ...core.labels.class_table import REFERENCE

    return [
        ClassRow(value, name, color, role == REFERENCE, order, (low, high))
        for value, name, color, role, order, low, high in list(csv.reader(io.StringIO(text)))[1:]
    ]
