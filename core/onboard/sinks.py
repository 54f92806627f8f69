"""Outputs of ``semref watch``: stdout, a file, or a UDP port of this computer.

If an output can't take a line, because a disk is full or a pipe is closed, the log reports it and the next line is
tried again. Neither the other outputs nor the watching stop.
"""

from __future__ import annotations

import logging
import os
import socket
import sys
from typing import Any

from ..errors import ParameterError, reason_of
from .log import log_event

LOOPBACK = "127.0.0.1"

_UDP = "udp:"


class Sink:
    """Takes lines, or records of images; a system error is logged once until one succeeds again.

    Attributes:
        lost: Number of lines that could not be written.
    """

    def __init__(self, where: str) -> None:
        """Store the address; nothing is opened yet."""
        self.where = where
        self.lost = 0
        self._fails = False

    def send(self, line: Any) -> None:  # noqa: ANN401 - a text, or a record for an autopilot
        """Send one line with its end; a failed line is lost, counted and logged."""
        try:
            self._take(line)
        except OSError as error:
            self.lost += 1
            if not self._fails:
                log_event(logging.ERROR, "sink_fails", where=self.where, reason=reason_of(error))
            self._fails = True
        else:
            if self._fails:
                log_event(logging.ERROR, "sink_works_again", where=self.where, lost=self.lost)
            self._fails = False

    def close(self) -> None:
        """Close the connection, if the sink has one."""

    def _take(self, line: Any) -> None:  # noqa: ANN401 - as of ``send``
        """Send one line; raises OSError."""
        raise NotImplementedError


class _StandardOutput(Sink):
    def _take(self, line: str) -> None:
        write_to_stdout(line)


def write_to_stdout(text: str) -> None:
    """Write a text, with escapes for characters that stdout can't encode; raises OSError."""
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
    print(text.encode(encoding, "backslashreplace").decode(encoding), end="", flush=True)


def not_written(where: str, error: OSError | ValueError) -> ParameterError:
    """Return the error of an output that can't be written."""
    return ParameterError(
        "{where} can't be written: {reason}. Choose another output.", where=where, reason=reason_of(error)
    )


class _File(Sink):
    def __init__(self, where: str) -> None:
        super().__init__(where)
        try:
            # Without a buffer: a line that a full disk refused must not be written later, out of order.
            self._file = open(where, "ab", buffering=0, opener=_open_at_once)  # noqa: SIM115  closed by close
        except (OSError, ValueError) as error:
            raise not_written(where, error) from None
        self._before = b"\n" if _ends_within_a_line(where) else b""

    def _take(self, line: str) -> None:
        data = self._before + line.encode("utf-8", "backslashreplace")
        before = os.fstat(self._file.fileno()).st_size
        written = 0
        try:
            while written < len(data):
                written += self._file.write(data[written:]) or 0
        except OSError:
            # Remove a partial line, unless another process has written after it.
            if written and os.fstat(self._file.fileno()).st_size == before + written:
                os.ftruncate(self._file.fileno(), before)
            raise
        self._before = b""

    def close(self) -> None:
        self._file.close()


def _open_at_once(path: str, flags: int) -> int:
    """Open a file; a named pipe without a reader is an error, because waiting for it would stop everything."""
    if not hasattr(os, "O_NONBLOCK"):
        return os.open(path, flags, 0o666)
    file = os.open(path, flags | os.O_NONBLOCK, 0o666)
    os.set_blocking(file, True)
    return file


def _ends_within_a_line(where: str) -> bool:
    """Return whether the last line of a file has no end, because power was cut during writing."""
    if not os.path.isfile(where) or not os.path.getsize(where):
        return False
    try:
        with open(where, "rb") as file:
            file.seek(-1, os.SEEK_END)
            return file.read(1) != b"\n"
    except OSError:
        # The file may be writable but not readable.
        return False


class _UdpPort(Sink):
    def __init__(self, where: str) -> None:
        super().__init__(where)
        self._port = _udp_port(where)
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

    def _take(self, line: str) -> None:
        self._socket.sendto(line.encode("utf-8", "backslashreplace"), (LOOPBACK, self._port))

    def close(self) -> None:
        self._socket.close()


def open_sink(where: str) -> Sink:
    """Return the sink of an address: ``-`` for stdout, ``udp:PORT``, otherwise a file to append to.

    Raises:
        ParameterError: The file can't be written, or the port is invalid.
    """
    if where == "-":
        return _StandardOutput("stdout")
    return _UdpPort(where) if where.startswith(_UDP) else _File(where)


def check_sink(where: str) -> None:
    """Raise ParameterError for ``udp:`` without a port number."""
    if where.startswith(_UDP):
        _udp_port(where)


def _udp_port(where: str) -> int:
    """Return the number in ``udp:PORT``; raises ParameterError when it is not from 1 to 65535."""
    text = where[len(_UDP) :]
    if not text.isdecimal() or len(text) > 5 or not 0 < int(text) < 65_536:
        raise ParameterError(
            "“{where}” is not a UDP port of this computer. Enter udp:PORT, with PORT from 1 to 65535.", where=where
        )
    return int(text)
