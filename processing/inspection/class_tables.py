"""Class tables as a window shows them: rows of texts, read from and written to files, and what is wrong with them."""

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
    """A class as a person edits it: texts as they are typed, nothing checked.

    Attributes:
        value: Of its pixels.
        color: ``#rrggbb``.
        order: Its draw order; empty for none.
        hsv: Its least and greatest color of label images, as the file has them.
    """

    value: str
    name: str
    color: str
    is_landmark: bool = False
    order: str = ""
    hsv: tuple[str, str] = ("", "")


def read_rows(path: str) -> list[ClassRow]:
    """The classes of a file; none without one. Raises ClassTableError."""
    from ...storage.text_tables import read_class_table

    return _rows(read_class_table(path).to_csv()) if path else []


def preset_titles() -> list[str]:
    """Of the nomenclatures that ship."""
    return list(PRESETS)


def preset_rows(number: int) -> list[ClassRow]:
    """The classes of one of them, by its place in ``preset_titles``."""
    return read_rows(list(PRESETS.values())[number])


def is_shipped(path: str) -> bool:
    """Whether a file is one of the plugin's own, which an update would replace."""
    return os.path.dirname(os.path.realpath(path)) == os.path.realpath(CLASS_TABLES)


def new_row(values: Iterable[str]) -> ClassRow:
    """A class more, with the first value that is free."""
    from ...core.labels.class_colors import default_color
    from ...core.labels.class_table import MAXIMUM_VALUE

    taken = set(values)
    value = next((n for n in range(1, MAXIMUM_VALUE + 1) if str(n) not in taken), MAXIMUM_VALUE)
    return ClassRow(str(value), tr("class {number}").format(number=value), default_color(value))


def require_table(rows: Sequence[ClassRow]) -> str:
    """The CSV text of a table of these classes. Raises ClassTableError when they make none."""
    from ...core.labels.class_table import BACKGROUND, REFERENCE, ClassTable, class_table_from_csv

    text = io.StringIO(ClassTable(()).to_csv())
    text.seek(0, io.SEEK_END)
    writer = csv.writer(text, lineterminator="\n")
    for row in rows:
        role = REFERENCE if row.is_landmark else BACKGROUND
        # A file has a class a line.
        cells = (row.value, row.name, row.color, role, row.order, *row.hsv)
        writer.writerow([" ".join(cell.split()) for cell in cells])
    return class_table_from_csv(text.getvalue(), tr("Class table")).to_csv()


def save_rows(rows: Sequence[ClassRow], path: str) -> None:
    """Writes a class table. Raises ClassTableError, or ParameterError where it can't be written."""
    from ...storage.atomic_output import written_beside

    text = require_table(rows)
    with written_beside(path, ".csv") as temporary, open(temporary, "w", encoding="utf-8") as file:
        file.write(text)


def _rows(text: str) -> list[ClassRow]:
    """The rows of a table's own CSV."""
    from ...core.labels.class_table import REFERENCE

    return [
        ClassRow(value, name, color, role == REFERENCE, order, (low, high))
        for value, name, color, role, order, low, high in list(csv.reader(io.StringIO(text)))[1:]
    ]
