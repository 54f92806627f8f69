"""Text tables: lines with a header, of limited size; errors name the line."""

from __future__ import annotations

import csv
import os
import re
import stat
from collections.abc import Container, Iterator, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Callable

from . import limits
from .errors import ParameterError, reason_of
from .sentences import Sentence


def bytes_of(path: str, most: int, count: int | None = None) -> bytes:
    """Return the bytes of a regular file.

    Args:
        most: Largest size of the file, bytes.
        count: Number of bytes from the beginning; None for all.

    Raises:
        ParameterError: The file can't be read, is not a regular file or is too large.
    """
    try:
        state = os.stat(path)
        if not stat.S_ISREG(state.st_mode):
            raise ParameterError("{path} is not a file. Choose a table or a log.", path=path)
        if state.st_size > most:
            raise ParameterError(
                "{path} is larger than {most_mb} MB, the largest size of tables and logs. Choose another file.",
                path=path,
                most_mb=most // 1_000_000,
            )
        with open(path, "rb") as file:
            # Not more than the file has: Python allocates the full size first.
            return file.read(min(most if count is None else count, state.st_size))
    except (OSError, ValueError) as error:
        # ValueError: a path with a null character.
        raise ParameterError("{path} can't be read: {reason}.", path=path, reason=reason_of(error)) from None


@dataclass(frozen=True)
class Row:
    """A row of a table.

    Attributes:
        texts: Cells by column name in lower case; empty where the row is short.
        place: File and line, for messages.
    """

    texts: dict[str, str]
    place: Sentence

    def number(self, name: str, default: float | None = None) -> float:
        """Return a finite number.

        Args:
            default: Value of an empty or missing cell; None makes it an error.

        Raises:
            ParameterError: The cell is not a finite number.
        """
        text = self.texts.get(name, "")
        if not text and default is not None:
            return default
        try:
            value = float(text)
        except ValueError:
            value = float("nan")
        if not isfinite(value):
            raise ParameterError(
                "{place}: {name} is “{text}”, which is not a number.", place=self.place, name=name, text=text[:40]
            )
        return value

    def within(self, name: str, least: float, most: float, default: float | None = None) -> float:
        """Return a number from ``least`` to ``most``; raises ParameterError for any other."""
        value = self.number(name, default)
        if not least <= value <= most:
            raise ParameterError(
                "{place}: {name} is {value:g}; it must be from {least:g} to {most:g}.",
                place=self.place,
                name=name,
                value=value,
                least=least,
                most=most,
            )
        return value


@dataclass(frozen=True)
class Columns:
    """The header of a table.

    Attributes:
        names: Of the columns, in lower case.
        first: The line itself.
    """

    path: str
    names: tuple[str, ...]
    separator: str
    first: str

    @classmethod
    def of(cls, path: str, line: str) -> Columns:
        """Return the header of a first line with commas, semicolons or tabs between cells."""
        _require_length(path, line)
        first = line.strip()
        separator = max(",;\t", key=first.count)
        return cls(path, tuple(name.strip().strip('"').lower() for name in first.split(separator)), separator, first)

    def need(self, names: Sequence[str]) -> None:
        """Raise ParameterError if a column is missing."""
        if not set(names) <= set(self.names):
            raise ParameterError(
                "{path} begins with “{first}”; its header needs the columns {columns}.",
                path=self.path,
                first=self.first[:200],
                columns=tuple(names),
            )

    def row(self, line: str, number: int) -> Row:
        """Return a row from its line.

        Args:
            line: Without line end.
            number: Of the line, from 1.

        Raises:
            ParameterError: The line is too long or not part of a table.
        """
        _require_length(self.path, line)
        place = Sentence("{source}, line {line}", source=self.path, line=number)
        try:
            cells = next(csv.reader([line], delimiter=self.separator, skipinitialspace=True), [])
        except csv.Error as error:
            # A null character, before Python 3.11.
            raise ParameterError("{path} can't be read: {reason}.", path=place, reason=str(error)) from None
        return Row({name: cell.strip() for name, cell in zip(self.names, cells)}, place)


def too_long(path: str) -> ParameterError:
    """Return the error of a file with too long a line."""
    return ParameterError(
        "{path} has a line of more than {most} characters. Choose another file.",
        path=path,
        most=limits.LINE_CHARACTERS,
    )


def not_utf8(path: str) -> ParameterError:
    """Return the error of a table in another encoding."""
    return ParameterError("{path} is not text in UTF-8. Save it as CSV in UTF-8.", path=path)


def _require_length(path: str, line: str) -> None:
    if len(line) > limits.LINE_CHARACTERS:
        raise too_long(path)


Check = Callable[[Columns], None]
"""Raises ParameterError for the header of another kind of table."""


def rows_of(path: str, check: Check) -> Iterator[Row]:
    """Yield the rows of a CSV with commas, semicolons or tabs between cells; empty lines are skipped.

    Raises:
        ParameterError: The file can't be used.
    """
    try:
        text = bytes_of(path, limits.TABLE_BYTES).decode("utf-8-sig")
    except UnicodeDecodeError:
        raise not_utf8(path) from None
    yield from rows_of_text(text, path, check)


def rows_of_text(text: str, source: str, check: Check) -> Iterator[Row]:
    """Yield the rows of the content of a CSV, as ``rows_of`` does; ``source``: the file, for messages."""
    lines = text.lstrip("\ufeff").splitlines()
    numbered = [(n, line) for n, line in enumerate(lines, start=1) if line.strip()]
    columns = Columns.of(source, numbered[0][1] if numbered else "")
    check(columns)
    for number, line in numbered[1:]:
        yield columns.row(line, number)


def stem_of(path: str) -> str:
    """Return an image's name without extension and folders of any system."""
    return os.path.splitext(re.split(r"[/\\]", path)[-1])[0]


def image_of(row: Row, known: Container[str] = ()) -> str:
    """Return the name of a row's image, without folders and extension.

    Args:
        known: Names of the rows before.

    Raises:
        ParameterError: The row names no image, or one of those before.
    """
    stem = stem_of(row.texts.get("image", ""))
    if not stem:
        raise ParameterError("{place}: the image is missing. Enter its file name.", place=row.place)
    if stem in known:
        raise ParameterError(
            "{place}: the image {image} has a row already. Keep one row for each image.", place=row.place, image=stem
        )
    return stem
