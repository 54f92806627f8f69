"""Read a table that another program appends to during a flight: each row once, when it is complete."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator

from .. import limits
from ..errors import ParameterError, reason_of
from ..tables import Check, Columns, Row


class GrowingTable:
    """Reads the rows that a table got since the last call; it stores no row.

    Attributes:
        restarts: Number of times that the file was shorter than before, so that it is read from its first line again.
    """

    def __init__(self, path: str, check: Check) -> None:
        """Store the path; nothing is read yet.

        Args:
            check: Checks the header.
        """
        self.path, self._check, self.restarts = path, check, 0
        self._columns: Columns | None = None
        self._place = self._number = 0
        self._is_within_line = False

    def new_rows(self, is_ended: bool = False) -> Iterator[Row | ParameterError]:
        """Yield the new rows, and an error in place of each row that can't be used.

        Args:
            is_ended: No program writes any more: a last line without its end counts.

        Raises:
            ParameterError: The file can't be read or has the wrong header.
        """
        try:
            state = os.stat(self.path)
            if not stat.S_ISREG(state.st_mode):
                raise ParameterError("{path} is not a file. Choose a table or a log.", path=self.path)
            if state.st_size < self._place:
                self._columns, self._place, self._number, self._is_within_line = None, 0, 0, False
                self.restarts += 1
            with open(self.path, "rb") as file:
                file.seek(self._place)
                while True:
                    line = file.readline(limits.LINE_BYTES)
                    is_whole = line.endswith(b"\n") or len(line) == limits.LINE_BYTES
                    if not line or not (is_whole or is_ended):
                        # An incomplete line is read by the next call.
                        return
                    self._place += len(line)
                    yield from self._rows_of_line(line)
        except (OSError, ValueError) as error:
            # ValueError: a path with a null character.
            raise ParameterError("{path} can't be read: {reason}.", path=self.path, reason=reason_of(error)) from None

    def _rows_of_line(self, line: bytes) -> Iterator[Row | ParameterError]:
        """Yield one line as a row; nothing for the header and for empty lines."""
        was_within, self._is_within_line = self._is_within_line, not line.endswith(b"\n")
        self._number += not was_within
        if was_within or len(line) == limits.LINE_BYTES:
            # A line without end is reported once and not stored.
            if not was_within:
                yield ParameterError(
                    "{path} has a line of more than {most} characters. Choose another file.",
                    path=self.path,
                    most=limits.LINE_CHARACTERS,
                )
            return
        try:
            text = line.decode("utf-8-sig" if self._columns is None else "utf-8").strip("\r\n")
        except UnicodeDecodeError:
            yield ParameterError("{path} is not text in UTF-8. Save it as CSV in UTF-8.", path=self.path)
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
