"""Odometry and camera tables that grow during the flight: the values of an image when it arrives.

A line with an error is logged and skipped; the flight continues.
"""

from __future__ import annotations

import logging
import os
import stat
import time
from collections.abc import Iterator
from typing import Callable, Generic, TypeVar

from .. import limits
from ..errors import ParameterError, reason_of
from ..flight.motion import Link
from ..flight.odometry import OdometryRow, check_odometry, link_over, step_of
from ..tables import Check, Columns, Row, image_of, not_utf8, too_long
from .log import log_event

ROW_WITHIN_S, LOOK_EVERY_S = 0.5, 0.05
"""Largest delay of a row after its image, and the time between two looks for it."""

Value = TypeVar("Value")


class TableOfImages(Generic[Value]):
    """Values of a growing table by image name without folders and extension."""

    def __init__(self, path: str, check: Check, read: Callable[[Row, bool], Value], is_ended: bool) -> None:
        """Store the path; nothing is read yet.

        Args:
            read: Converts a row; its second argument is whether no known row comes before.
            is_ended: No program writes any more.
        """
        self._table, self._read, self._is_ended = GrowingTable(path, check), read, is_ended
        self._rows: list[Value] = []
        self._numbers: dict[str, int] = {}
        self._first = 0
        self._is_cut = True
        self._restarts = 0
        self._keeps_up, self._fails = True, False

    def check(self) -> None:
        """Read the current rows; raises ParameterError for the first error."""
        self._look(is_strict=True)

    def of(self, image: str) -> Value | None:
        """Return the value of an image; waits while the table keeps up with the images. None without one."""
        number = self._number_of(image)
        return None if number is None else self._rows[number - self._first]

    def between(self, first: str, last: str) -> list[Value] | None:
        """Return the values from the row after one image to that of a later one; None if either is missing."""
        end, start = self._number_of(last), self._numbers.get(first)
        if start is None or end is None or end <= start:
            return None
        return self._rows[start + 1 - self._first : end + 1 - self._first]

    def _number_of(self, image: str) -> int | None:
        until = time.monotonic() + (ROW_WITHIN_S if self._keeps_up and not self._is_ended else 0.0)
        while True:
            self._look()
            if image in self._numbers or time.monotonic() >= until:
                break
            time.sleep(LOOK_EVERY_S)
        self._keeps_up = image in self._numbers
        return self._numbers.get(image)

    def _look(self, is_strict: bool = False) -> None:
        try:
            for row in self._table.new_rows(self._is_ended):
                self._take(row, is_strict)
            self._fails = False
        except ParameterError as error:
            if is_strict:
                raise
            if not self._fails:
                log_event(logging.ERROR, "table_fails", reason=str(error))
            self._fails = True

    def _take(self, row: Row | ParameterError, is_strict: bool) -> None:
        if self._restarts != self._table.restarts:
            self._restarts, self._is_cut = self._table.restarts, True
            self._first += len(self._rows)
            self._rows.clear()
            self._numbers.clear()
        try:
            if isinstance(row, ParameterError):
                raise row
            image = image_of(row, self._numbers)
            value = self._read(row, self._is_cut)
        except ParameterError as error:
            if is_strict:
                raise
            log_event(logging.ERROR, "table_line_left_out", reason=str(error))
            # The motion of the next row begins at an unknown place.
            self._is_cut = True
            return
        self._is_cut = False
        self._numbers[image] = self._first + len(self._rows)
        self._rows.append(value)
        if len(self._rows) > limits.HELD_ROWS:
            self._forget(limits.HELD_ROWS // 2)

    def _forget(self, count: int) -> None:
        del self._rows[:count]
        self._first += count
        self._numbers = {image: number for image, number in self._numbers.items() if number >= self._first}


class OdometryTable(TableOfImages[OdometryRow]):
    """Motion from image to image in a growing table."""

    def __init__(self, path: str, is_ended: bool) -> None:
        """Store the path; nothing is read yet."""
        super().__init__(path, check_odometry, step_of, is_ended)

    def link(self, before: str, now: str) -> Link | None:
        """Return the motion from an image to a later one, by names without extensions; None if the table lacks it."""
        steps = self.between(before, now)
        return None if not steps or any(step.is_break for step in steps) else link_over(0, 1, steps)


class GrowingTable:
    """Reads the rows that a table got since the last call; it stores no row.

    Attributes:
        restarts: Number of times that the file was shorter than before, so that it is read from its first line again.
    """

    def __init__(self, path: str, check: Check) -> None:
        """Store the path; nothing is read yet."""
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
                yield too_long(self.path)
            return
        try:
            text = line.decode("utf-8-sig" if self._columns is None else "utf-8").strip("\r\n")
        except UnicodeDecodeError:
            yield not_utf8(self.path)
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
