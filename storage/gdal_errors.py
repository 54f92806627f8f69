"""What GDAL fails at, whether it raises or returns None, as the user has set it."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterator
from typing import Callable, TypeVar

from osgeo import gdal

from ..core.errors import SemRefError
from ..core.sentences import Sentence

_Read = TypeVar("_Read")


def gdal_failure(error: object = None) -> str | Sentence:
    """What GDAL said last, whether it raised or not, as a value of a sentence."""
    text = (str(error) if error else "") or gdal.GetLastErrorMsg()
    if not text:
        return Sentence("unknown reason")
    # GDAL 3.10 appends the earlier messages as sentences of their own.
    return re.sub(r"\.\s+(?=[A-Z])", "; ", " ".join(text.split())).rstrip(".")


def read_by_gdal(
    kind: type[SemRefError], path: str, read: Callable[..., _Read], *arguments: object, **keywords: object
) -> _Read:
    """Return what GDAL reads; it may raise or return None, as the user set it.

    Args:
        kind: Of the error that a damaged file is.
        path: Of the file, for the error.
        read: A method of GDAL.
        arguments: Of ``read``.
        keywords: Of ``read``.
    """
    error: object = None
    try:
        found = read(*arguments, **keywords)
        if found is not None:
            return found
    except RuntimeError as raised:
        error = raised
    raise kind(Sentence("{path} is damaged or cut short: {reason}.", path=path, reason=gdal_failure(error)))


@contextlib.contextmanager
def gdal_failures() -> Iterator[list[str]]:
    """Collects what GDAL fails at in the block and this thread, whether GDAL raises or not.

    Its last error alone would not do: warnings and later calls replace it.
    """
    failures: list[str] = []

    def remember(kind: int, number: int, text: str) -> None:
        if kind >= gdal.CE_Failure:
            failures.append(text)

    gdal.PushErrorHandler(remember)
    try:
        yield failures
    except RuntimeError as error:
        failures.append(str(error))
    finally:
        gdal.PopErrorHandler()


def close(dataset: gdal.Dataset | None) -> None:
    """Closes a dataset, which may still write, so that ``gdal_failures`` around it hears of what fails then.

    GDAL before 3.8 does so when the last reference goes: drop it within that block, too. Where GDAL raises, what fails
    in a destructor is lost.
    """
    if dataset is None or not hasattr(dataset, "Close"):
        return
    try:
        dataset.Close()
    except RuntimeError:
        # GDAL 3.8 to 3.10 leave the reference in place when closing raises: Python would close what is gone once more.
        if dataset.this is not None:
            dataset.thisown = False
            dataset.this = None
        raise
