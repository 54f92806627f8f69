"""The contract for every input: a valid result or one error message, in time and memory, and nothing else changed."""

import contextlib
import os
import resource
import select
import signal
import socket
import traceback
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Callable

from semref.core.errors import SemRefError

LIMIT_S, LIMIT_BYTES, LONGEST_MESSAGE = 5, 1 << 30, 3000
ACCEPTED, REFUSED = "accepted", "refused"
_LONG_AGO_NS = 10**12


class Broken(Exception):
    """The contract does not hold: a result is invalid, or something was touched."""


class Refused(Exception):
    """An input was refused with this message."""


class TooSlow(BaseException):
    """Not an Exception, so that no reader takes it for a damaged file."""


def require(holds: Any, otherwise: str) -> None:
    if not holds:
        raise Broken(otherwise)


def require_message(text: str) -> None:
    """Raise Broken for a text that users cannot read."""
    require(text and len(text) <= LONGEST_MESSAGE, f"a message has {len(text)} characters")
    require("Traceback" not in text, "a message is a traceback")
    require(not any(sign in text for sign in "\n\r\0\x1b"), f"a message has control characters: {text[:300]!r}")
    text.encode("utf-8")


class World:
    """A folder for inputs, and what no input may touch: a file outside, a host, other files in the folder.

    Attributes:
        folder: The folder for inputs.
        secret: A raster outside, which inputs name.
        listener: A port of this computer, which inputs name by ``url``.
    """

    def __init__(self, root: Path) -> None:
        self.folder, self.secret = root / "inside", root / "secret.asc"
        self.folder.mkdir(parents=True)
        self.secret.write_text("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 1\n1 1\n", encoding="ascii")
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.url = f"http://127.0.0.1:{self.listener.getsockname()[1]}/asked"
        self.reset()

    def reset(self) -> None:
        """Take the present files as the allowed ones; the secret counts as unread."""
        self._names = set(os.listdir(self.folder))
        self.excuse_reading()

    def excuse_reading(self) -> None:
        written = os.stat(self.secret).st_mtime_ns
        os.utime(self.secret, ns=(written - _LONG_AGO_NS, written))

    def check(self) -> None:
        """Raise Broken if something was touched."""
        status = os.stat(self.secret)
        # GDAL rewrites some GeoJSON files that QGIS opens for editing when it closes them.
        names = {name for name in os.listdir(self.folder) if not name.endswith(".geojson.tmp")}
        changed = names ^ self._names
        for name in names - self._names:
            with contextlib.suppress(OSError):
                os.unlink(self.folder / name)
        self.reset()
        require(status.st_atime_ns <= status.st_mtime_ns - _LONG_AGO_NS, "a file outside the folder was read")
        if select.select([self.listener], [], [], 0)[0]:
            self.listener.accept()[0].close()
            raise Broken("a host was contacted")
        require(not changed, f"files were created or removed: {sorted(changed)[:3]}")


@contextlib.contextmanager
def placed(path: Path, data: bytes) -> Iterator[str]:
    """Write a file, and require afterwards that it is unchanged."""
    path.write_bytes(data)
    try:
        yield str(path)
    finally:
        same = path.is_file() and path.read_bytes() == data
        path.unlink(missing_ok=True)
        require(same, "the input was changed")


def limit_memory() -> None:
    """Allow this process 1 GiB more than now."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    most = pages * resource.getpagesize() + LIMIT_BYTES
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


@contextlib.contextmanager
def limited_time() -> Iterator[None]:
    """Raise TooSlow after LIMIT_S of this process's processor time."""

    def stop(*_: Any) -> None:
        raise TooSlow(f"it takes more than {LIMIT_S} s")

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, LIMIT_S)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def judge(attempt: Callable[[Any], None], made: Any, world: World) -> tuple[str, str]:
    """Return the outcome of an input: ACCEPTED, REFUSED, or the fault that broke the contract; and its traceback."""
    outcome = ACCEPTED
    try:
        with limited_time():
            try:
                attempt(made)
            except (SemRefError, Refused) as error:
                outcome = REFUSED
                require_message(str(error))
        world.check()
    except (Exception, TooSlow) as error:
        return type(error).__name__, "".join(traceback.format_exception(error))[-6000:]
    return outcome, ""
