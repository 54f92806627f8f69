"""Class tables for an editor: rows of unchecked texts, read from and written to files, and their errors."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Collection, Sequence

from ...core.labels.class_colors import default_color
from ...core.labels.class_table import BACKGROUND, MAXIMUM_VALUE, REFERENCE, ClassTable, class_table_from_csv
from ...storage.atomic_output import written_beside
from ...storage.text_tables import read_class_table
from ..jobs.annotation import CLASS_TABLES
from ..translation import tr

ClassRow = Sequence[str]
"""The cells of a class, in the order of the columns of a file."""


def read_rows(path: str) -> list[ClassRow]:
    """Return the classes of a file; empty without a file. Raises ClassTableError."""
    return list(csv.reader(io.StringIO(read_class_table(path).to_csv())))[1:] if path else []


def role_titles() -> dict[str, str]:
    return {REFERENCE: tr("landmarks"), BACKGROUND: tr("background")}


def is_shipped(path: str) -> bool:
    """Return whether a file is part of the plugin, so that an update would replace it."""
    return os.path.dirname(os.path.realpath(path)) == os.path.realpath(CLASS_TABLES)


def new_row(taken: Collection[str]) -> ClassRow:
    """Return a new class with the first value that is not taken."""
    value = next((n for n in range(1, MAXIMUM_VALUE + 1) if str(n) not in taken), MAXIMUM_VALUE)
    return str(value), tr("class {number}").format(number=value), default_color(value), BACKGROUND, "", "", ""


def require_table(rows: Sequence[ClassRow]) -> str:
    """Return the CSV text of a table of these classes. Raises ClassTableError if they are invalid."""
    text = io.StringIO(ClassTable(()).to_csv())
    text.seek(0, io.SEEK_END)
    # A file has one class per line.
    csv.writer(text, lineterminator="\n").writerows([" ".join(cell.split()) for cell in row] for row in rows)
    return class_table_from_csv(text.getvalue(), tr("Class table")).to_csv()


def save_rows(rows: Sequence[ClassRow], path: str) -> None:
    """Write a class table. Raises ClassTableError, or ParameterError if it cannot be written."""
    text = require_table(rows)
    with written_beside(path, ".csv") as temporary, open(temporary, "w", encoding="utf-8") as file:
        file.write(text)
