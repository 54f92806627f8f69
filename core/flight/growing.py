"""A table that another program appends to while images come: its rows, each once, when they are complete."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator

from .. import limits
from ..errors import ParameterError, reason_of
from .table import Check, Columns, Row


class GrowingTable:
    """Reads what came to a table since the last look; it holds no row.

    Attributes:
        restarts: How often it was shorter than before: then it was written anew and is read from its first line.
    """

    def __init__(self, path: str, check: Check) -> None:
        """Reads nothing yet.

        Args:
            check: What its header must have.
        """
        self.path, self._check, self.restarts = path, check, 0
        self._columns: Columns | None = None
        self._place = self._number = 0
        self._is_within_line = False

    def new_rows(self, is_ended: bool = False) -> Iterator[Row | ParameterError]:
        """Rows that came since the last look, and in the place of a line that is none what is wrong with it.

        Args:
            is_ended: Nobody writes any more: a last line without its end counts.

        Raises:
            ParameterError: The file can't be read, or its header is not that of such a table.
        """
        try:
            state = os.stat(self.path)
            if not stat.S_ISREG(state.st_mode):
                raise ParameterError("{path} is no file; choose a table or a log.", path=self.path)
            if state.st_size < self._place:
                self._columns, self._place, self._number, self._is_within_line = None, 0, 0, False
                self.restarts += 1
            with open(self.path, "rb") as file:
                file.seek(self._place)
                while True:
                    line = file.readline(limits.LINE_BYTES)
                    is_whole = line.endswith(b"\n") or len(line) == limits.LINE_BYTES
                    if not line or not (is_whole or is_ended):
                        # What is half written is taken at the next look.
                        return
                    self._place += len(line)
                    yield from self._rows_of_line(line)
        except (OSError, ValueError) as error:
            # ValueError: a path with a null character.
            raise ParameterError("{path} can't be read: {reason}.", path=self.path, reason=reason_of(error)) from None

    def _rows_of_line(self, line: bytes) -> Iterator[Row | ParameterError]:
        """One line as a row; nothing of the header and of an empty line."""
        was_within, self._is_within_line = self._is_within_line, not line.endswith(b"\n")
        self._number += not was_within
        if was_within or len(line) == limits.LINE_BYTES:
            # One that never ends is told once, not held.
            if not was_within:
                yield ParameterError(
                    "{path} has a line of more than {most} characters; choose another file.",
                    path=self.path,
                    most=limits.LINE_CHARACTERS,
                )
            return
        try:
            text = line.decode("utf-8-sig" if self._columns is None else "utf-8").strip("\r\n")
        except UnicodeDecodeError:
            yield ParameterError("{path} is not text in UTF-8; save it as CSV in UTF-8.", path=self.path)
            return
        if not text.strip():
            return
        if self._columns is None:
            columns = Columns.of(self.path, text)
            self._check(columns)
            self._columns = columns
            return
        try:
            yield self._columns.row(text, self._number)
        except ParameterError as error:
            yield error
