"""Tables of flights as text: lines with a header, of bounded size, each row with the place that is told of it."""

from __future__ import annotations

import csv
import os
import re
import stat
from collections.abc import Container, Iterator, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Callable

from .. import limits
from ..errors import ParameterError, reason_of
from ..sentences import Sentence


def text_of(path: str) -> str:
    """The text of a file in UTF-8.

    Raises:
        ParameterError: It can't be read, is no regular file, is too large or is no text.
    """
    data = bytes_of(path, limits.TABLE_BYTES)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise ParameterError("{path} is not text in UTF-8; save it as CSV in UTF-8.", path=path) from None


def bytes_of(path: str, most: int, count: int | None = None) -> bytes:
    """The bytes of a regular file that has at most ``most``.

    Args:
        most: Bytes that it may have.
        count: How many of its first ones; all if None.

    Raises:
        ParameterError: It can't be read, is no regular file or is too large.
    """
    try:
        state = os.stat(path)
        if not stat.S_ISREG(state.st_mode):
            raise ParameterError("{path} is no file; choose a table or a log.", path=path)
        if state.st_size > most:
            raise ParameterError(
                "{path} is larger than {most_mb} MB, which no table or log that is read here is.",
                path=path,
                most_mb=most // 1_000_000,
            )
        with open(path, "rb") as file:
            # No more than there is: a buffer of all that is asked for would be made first.
            return file.read(min(most if count is None else count, state.st_size))
    except (OSError, ValueError) as error:
        # ValueError: a path with a null character.
        raise ParameterError("{path} can't be read: {reason}.", path=path, reason=reason_of(error)) from None


@dataclass(frozen=True)
class Row:
    """A row of a table.

    Attributes:
        texts: By the column's name, in small letters; empty where a row is short.
        place: File and line, as told.
    """

    texts: dict[str, str]
    place: Sentence

    def number(self, name: str, default: float | None = None) -> float:
        """A finite number.

        Args:
            default: Where the cell is empty or missing; None: that is an error.

        Raises:
            ParameterError: It is none.
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
        """A number of a range; raises ParameterError for any other."""
        value = self.number(name, default)
        if not least <= value <= most:
            raise ParameterError(
                "{place}: {name} is {value:g}, but it must lie between {least:g} and {most:g}.",
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
        names: Of its columns, in small letters.
        separator: Between cells.
        first: The line itself.
    """

    path: str
    names: tuple[str, ...]
    separator: str
    first: str

    @classmethod
    def of(cls, path: str, line: str) -> Columns:
        """Reads a first line whose cells are separated by commas, semicolons or tabs."""
        _require_length(path, line)
        first = line.strip()
        separator = max(",;\t", key=first.count)
        return cls(path, tuple(name.strip().strip('"').lower() for name in first.split(separator)), separator, first)

    def need(self, names: Sequence[str]) -> None:
        """Raises ParameterError where a column is missing."""
        if not set(names) <= set(self.names):
            raise ParameterError(
                "{path} begins with “{first}”, but its header needs the columns {columns}.",
                path=self.path,
                first=self.first[:200],
                columns=tuple(names),
            )

    def row(self, line: str, number: int) -> Row:
        """A row from its line.

        Args:
            line: Without its end.
            number: Of the line, from 1.

        Raises:
            ParameterError: The line is none of a table.
        """
        _require_length(self.path, line)
        place = Sentence("{source}, line {line}", source=self.path, line=number)
        try:
            cells = next(csv.reader([line], delimiter=self.separator, skipinitialspace=True), [])
        except csv.Error as error:
            # A null character, before Python 3.11.
            raise ParameterError("{path} can't be read: {reason}.", path=place, reason=str(error)) from None
        return Row({name: cell.strip() for name, cell in zip(self.names, cells)}, place)


def _require_length(path: str, line: str) -> None:
    if len(line) > limits.LINE_CHARACTERS:
        raise ParameterError(
            "{path} has a line of more than {most} characters; choose another file.",
            path=path,
            most=limits.LINE_CHARACTERS,
        )


Check = Callable[[Columns], None]
"""Raises ParameterError for a header that is not that of a kind of tables."""


def rows_of(path: str, check: Check) -> Iterator[Row]:
    """Rows of a CSV that is separated by commas, semicolons or tabs; empty lines are left out.

    Args:
        check: What its header must have.

    Raises:
        ParameterError: The file can't be used.
    """
    numbered = [(n, line) for n, line in enumerate(text_of(path).splitlines(), start=1) if line.strip()]
    columns = Columns.of(path, numbered[0][1] if numbered else "")
    check(columns)
    for number, line in numbered[1:]:
        yield columns.row(line, number)


def stem_of(path: str) -> str:
    """An image's name without folders, of any system, and extension."""
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
