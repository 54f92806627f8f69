"""What ``python -m cluster`` does, and how it says what comes of it: in one sentence and an exit code."""

from __future__ import annotations

import contextlib
import importlib
import importlib.metadata
import importlib.util
import io
import json
import math
import signal
import sys
from typing import Any

from ..core.errors import ParameterError, SemRefError
from ..core.sentences import Sentence, english
from .options import DONE, INTERRUPTED, REFUSED, WRONG_USAGE, parser

NEEDED = (
    ("numpy", "numpy"),
    ("cv2", "opencv-python-headless"),
    ("osgeo", "GDAL"),
    ("distributed", "Dask (distributed)"),
)
"""Modules beside Python's own, and what they are called where they are installed."""


def main(arguments: list[str]) -> int:
    """Runs one command; gives its exit code."""
    reader = parser()
    options, others = reader.parse_known_args(arguments)
    if others and options.command != "localize":
        # It says what it does not know, and ends.
        reader.parse_args(arguments)
    teller = JsonTeller() if getattr(options, "json", False) else TextTeller()
    # QGIS ends it so; the terminal sends an interrupt.
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, _interrupted)
    try:
        require_packages()
        if options.command == "localize":
            from .localize import localize

            return localize(options, others, teller)
        work = importlib.import_module(f"{__package__}.{options.command}")
        result = getattr(work, options.command)(options, teller)
    except SemRefError as error:
        teller.failed(error.sentence)
        return WRONG_USAGE if isinstance(error, ParameterError) else REFUSED
    except KeyboardInterrupt:
        teller.failed(None)
        return INTERRUPTED
    except Exception as error:
        teller.broke(error)
        return REFUSED
    teller.done(result)
    return DONE


_asked_to_end: list[bool] = []


def _interrupted(*_: object) -> None:
    _asked_to_end.append(True)
    raise KeyboardInterrupt


def _heed() -> None:
    """Raises KeyboardInterrupt once more: one that meets Python while it clears up an object is lost."""
    if _asked_to_end:
        raise KeyboardInterrupt


def require_packages() -> None:
    """Raises SemRefError for the first that this Python lacks, or where GDAL was made for another numpy."""
    for module, title in NEEDED:
        if importlib.util.find_spec(module) is None:
            raise SemRefError("cluster.lacks_package", python=sys.executable, package=title)
    try:
        # What numpy prints of it is a page long.
        with contextlib.redirect_stderr(io.StringIO()):
            importlib.import_module("osgeo.gdal_array")
    except (ImportError, AttributeError):
        version = importlib.metadata.version("numpy")
        raise SemRefError("cluster.unfit_numpy", python=sys.executable, version=version) from None


class TextTeller:
    """Says on stderr what is being done; a step ends the work when it was asked to."""

    def __init__(self) -> None:
        self._said = ("", -1)

    def step(self, text: str, share: float) -> None:
        """What is being done, and how much of all is (0…1); a line for each new text and every 5 %."""
        _heed()
        percent = int(100 * share)
        if text != self._said[0] or percent >= self._said[1] + 5:
            self._said = text, percent
            self._print(f"{percent:3d} %  {text}")

    def say(self, text: str) -> None:
        """Anything else worth a line."""
        self._print(text)

    def failed(self, sentence: Sentence | None) -> None:
        """Why it ends; None when it was asked to."""
        self._print("cluster: " + ("ended; nothing was written." if sentence is None else english(sentence)))

    def broke(self, error: Exception) -> None:
        """A fault of the program."""
        self._print(f"cluster: {type(error).__name__}: {str(error).partition(chr(10))[0]}")

    def done(self, result: dict[str, Any]) -> None:
        """What came of it, on the output: a line each."""
        for key, value in result.items():
            print(f"{key}: {value}", flush=True)

    @staticmethod
    def _print(text: str) -> None:
        # A closed stderr must not change what is done.
        with contextlib.suppress(OSError):
            print(text, file=sys.stderr, flush=True)


class JsonTeller:
    """Says the same as a line of JSON each, for the program that started this one."""

    def step(self, text: str, share: float) -> None:
        _heed()
        self._tell("step", text=text, share=share)

    def say(self, text: str) -> None:
        self._tell("info", text=text)

    def failed(self, sentence: Sentence | None) -> None:
        if sentence is None:
            self._tell("canceled")
        else:
            self._tell("failed", code=sentence.code, values=dict(sentence.values), text=english(sentence))

    def broke(self, error: Exception) -> None:
        self._tell("broke", reason=f"{type(error).__name__}: {error}".partition("\n")[0])

    def done(self, result: dict[str, Any]) -> None:
        self._tell("done", **result)

    @staticmethod
    def _tell(event: str, **values: object) -> None:
        with contextlib.suppress(OSError):
            told = {key: _plain(value) for key, value in values.items()}
            print(json.dumps({"event": event, **told}, allow_nan=False), flush=True)


def _plain(value: object) -> object:
    """A value as JSON has it, which knows neither NaN nor infinity."""
    if isinstance(value, (tuple, list)):
        return [_plain(part) for part in value]
    if isinstance(value, dict):
        return {key: _plain(part) for key, part in value.items()}
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value if isinstance(value, (int, float)) or value is None else str(value)
