"""What holds for every input, by machine: a valid result or one sentence, in time and memory, nothing else touched."""

from __future__ import annotations

import contextlib
import os
import resource
import select
import signal
import socket
import sys
import traceback
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Callable

LONGEST_S = 5.0
MOST_BYTES = 1 << 30
LONGEST_SENTENCE = 3000
REFUSED, ACCEPTED = "refused", "accepted"


class Broken(Exception):
    """The contract does not hold: what came out is no valid result, or something was touched."""


class Refused(Exception):
    """QGIS refused an input, with the sentence that this has."""


class TooSlow(BaseException):
    """Not an Exception, so that no reader takes it for a damaged file."""


def require(holds: Any, otherwise: str) -> None:
    """Raises Broken unless a result is what it should be."""
    if not holds:
        raise Broken(otherwise)


def require_one_sentence(text: str) -> None:
    """Raises Broken for a text that is no sentence for people."""
    require(text and len(text) <= LONGEST_SENTENCE, f"a sentence is too long: {len(text)} characters")
    require("Traceback" not in text, "a traceback for a sentence")
    require(not any(sign in text for sign in "\n\r\0\x1b"), f"a sentence has controls: {text[:300]!r}")
    text.encode("utf-8")


@dataclass
class World:
    """What no input may touch: a file outside its folder, a host, the folder's other files.

    Attributes:
        folder: The folder for an input. Attempts must leave it unchanged.
        secret: A raster outside, which inputs name: nobody may read it.
        listener: A port of this computer, which inputs name: nobody may call it.
    """

    folder: Path
    secret: Path
    listener: socket.socket
    _names: set[str] = field(default_factory=set)

    @classmethod
    def made(cls, folder: Path) -> World:
        (folder / "inside").mkdir(parents=True)
        secret = folder / "secret.asc"
        secret.write_text("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 1\n1 1\n", encoding="ascii")
        listener = socket.create_server(("127.0.0.1", 0))
        world = cls(folder / "inside", secret, listener)
        world.forget()
        return world

    @property
    def url(self) -> str:
        """An address on this computer that nobody may ask."""
        return f"http://127.0.0.1:{self.listener.getsockname()[1]}/asked"

    def forget(self) -> None:
        """Takes what is there now as what should be; the secret counts as not read."""
        self._names = set(os.listdir(self.folder))
        self.excuse_reading()

    def excuse_reading(self) -> None:
        """The secret counts as not read: a user may name it as an input."""
        written = os.stat(self.secret).st_mtime_ns
        os.utime(self.secret, ns=(written - 10**12, written))

    def check(self) -> None:
        """Raises Broken where something was touched."""
        stat = os.stat(self.secret)
        if stat.st_atime_ns > stat.st_mtime_ns - 10**12:
            self.forget()
            raise Broken("a file outside the folder was read")
        if select.select([self.listener], [], [], 0)[0]:
            self.listener.accept()[0].close()
            raise Broken("a host was asked")
        names = set(os.listdir(self.folder))
        # GDAL rewrites some GeoJSON files that QGIS opens for editing, when it closes them.
        names = {name for name in names if not name.endswith(".geojson.tmp")}
        if names != self._names:
            for name in names - self._names:
                with contextlib.suppress(OSError):
                    os.unlink(os.path.join(self.folder, name))
            changed = sorted(names ^ self._names)[:3]
            self._names = set(os.listdir(self.folder))
            raise Broken(f"files came or went beside the input: {changed}")


class Placed:
    """Bytes in a file. They must be the same after a reader has read them."""

    def __init__(self, folder: Path, name: str) -> None:
        self.path = os.path.join(folder, name)
        self._data = b""

    def __call__(self, data: bytes) -> Placed:
        self._data = data
        return self

    def __enter__(self) -> str:
        with open(self.path, "wb") as file:
            file.write(self._data)
        return self.path

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        try:
            with open(self.path, "rb") as file:
                same = file.read() == self._data
        except OSError:
            same = False
        finally:
            if os.path.lexists(self.path):
                os.unlink(self.path)
        if not same:
            require(same, "the input was changed")


def limit_memory() -> None:
    """From here on this process can get a GiB more, and no more."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    most = pages * resource.getpagesize() + MOST_BYTES
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


@contextlib.contextmanager
def in_time(seconds: float = LONGEST_S) -> Iterator[None]:
    """Raises TooSlow in the block when it computes longer; other work of the machine does not count."""

    def stop(*_: Any) -> None:
        raise TooSlow(f"it takes more than {seconds:g} s")

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


@dataclass(frozen=True)
class Verdict:
    """What became of an input: refused or accepted, else what broke, where, and how it shows."""

    outcome: str
    where: str = ""
    details: str = ""


def tried(attempt: Callable[[Any], Any], made: Any, world: World, refusals: tuple) -> Verdict:
    """Gives one input to a door and judges what comes of it."""
    outcome = ACCEPTED
    try:
        with in_time():
            try:
                attempt(made)
            except (*refusals, Refused) as error:
                outcome = REFUSED
                require_one_sentence(str(error))
        world.check()
    except (Exception, TooSlow) as error:
        return Verdict(type(error).__name__, _where(error), "".join(traceback.format_exception(error))[-6000:])
    return Verdict(outcome)


def _where(error: BaseException) -> str:
    """The innermost place in the plugin that the error came through; the same place is the same find."""
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if "/tools/fuzz/contract" not in frame.filename and _is_own(frame.filename)]
    last: traceback.FrameSummary | None = own[-1] if own else (frames[-1] if frames else None)
    kept = str(error).split(":")[0][:80] if isinstance(error, Broken) else ""
    return f"{Path(last.filename).name}:{last.lineno} {kept}" if last else ""


def _is_own(filename: str) -> bool:
    return filename.startswith(str(Path(__file__).resolve().parents[2])) and "site-packages" not in filename


if sys.platform != "linux":
    raise ImportError("Fuzzing limits memory and watches files as Linux lets it.")
