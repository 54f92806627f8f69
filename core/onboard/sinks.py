"""Where ``semref watch`` sends its lines: stdout, a file, a UDP port of this computer.

What can't take a line – a full disk, a closed pipe – says so in the log and is tried again with the next line. It
stops neither the other sink nor the watching.
"""

from __future__ import annotations

import logging
import os
import socket
import sys
from typing import Callable

from ..errors import ParameterError, reason_of
from .log import log_event

LOOPBACK = "127.0.0.1"

_UDP = "udp:"


class Sink:
    """Takes lines; an error of the system in taking one is told once, until a line is taken again.

    Attributes:
        lost: How many lines it could not take.
    """

    def __init__(self, where: str) -> None:
        """Opens nothing yet; ``where`` is what the user called it."""
        self.where = where
        self.lost = 0
        self._fails = False

    def send(self, line: str) -> None:
        """Sends one line with its end; one that can't be sent is lost, counted and told."""
        self.attempt(lambda: self._take(line))

    def attempt(self, send: Callable[[], None]) -> None:
        """Calls what sends; what it can't send is lost, counted and told."""
        try:
            send()
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

    def _take(self, line: str) -> None:
        """Sends nothing."""


class _StandardOutput(Sink):
    def _take(self, line: str) -> None:
        encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
        print(line.encode(encoding, "backslashreplace").decode(encoding), end="", flush=True)


class _File(Sink):
    def __init__(self, where: str) -> None:
        super().__init__(where)
        try:
            # Without a buffer: what a full disk did not take must not come later, out of order.
            self._file = open(where, "ab", buffering=0)  # noqa: SIM115  closed by close
        except (OSError, ValueError) as error:
            raise ParameterError(
                "{where} can't be written: {reason}; choose another place.", where=where, reason=reason_of(error)
            ) from None
        self._before = b"\n" if _ends_within_a_line(where) else b""

    def _take(self, line: str) -> None:
        data = self._before + line.encode("utf-8", "backslashreplace")
        before = os.fstat(self._file.fileno()).st_size
        written = 0
        try:
            while written < len(data):
                written += self._file.write(data[written:]) or 0
        except OSError:
            # No half line stays, unless another process wrote behind it.
            if written and os.fstat(self._file.fileno()).st_size == before + written:
                os.ftruncate(self._file.fileno(), before)
            raise
        self._before = b""

    def close(self) -> None:
        self._file.close()


def _ends_within_a_line(where: str) -> bool:
    """Whether a file has a last line without its end: power was cut while it was written."""
    if not os.path.isfile(where) or not os.path.getsize(where):
        return False
    try:
        with open(where, "rb") as file:
            file.seek(-1, os.SEEK_END)
            return file.read(1) != b"\n"
    except OSError:
        # It may be written to, and not read.
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


def open_sink(where: str | None) -> Sink:
    """The sink of a place: None for nowhere, ``-`` for stdout, ``udp:PORT``, else a file that is appended to.

    Raises:
        ParameterError: The file can't be written, or the port is none.
    """
    if where is None:
        return Sink("nowhere")
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
            "“{where}” is no UDP port of this computer; write udp:PORT, with PORT from 1 to 65535.", where=where
        )
    return int(text)
