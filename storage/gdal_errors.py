"""Errors of GDAL, which raises them or returns None as the user has set it."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Callable, TypeVar

from osgeo import gdal

from ..core.errors import ImageError, UnwritableError
from ..core.sentences import Sentence

_Read = TypeVar("_Read")

_CUT_JPEG = "Premature end of JPEG file"
"""Part of the warning of libjpeg about missing pixels."""


def gdal_failure(error: object = None) -> str | Sentence:
    """Return GDAL's last error, or ``error``, as a value of a sentence."""
    text = (str(error) if error else "") or gdal.GetLastErrorMsg()
    if not text:
        return Sentence("unknown reason")
    # GDAL 3.10 appends the earlier messages as sentences of their own.
    return re.sub(r"\.\s+(?=[A-Z])", "; ", " ".join(text.split())).rstrip(".")


def unwritten_database(error: object = None) -> UnwritableError:
    """Return the error that a database can't be written, because of GDAL's last error or ``error``."""
    return UnwritableError("The database can't be written: {reason}.", reason=gdal_failure(error))


def read_by_gdal(path: str, read: Callable[..., _Read], *arguments: object, **keywords: object) -> _Read:
    """Call a reading method of GDAL and return its result; raise ImageError if it fails.

    Args:
        path: File name for the error.
    """
    found = None
    with gdal_failures() as failures:
        found = read(*arguments, **keywords)
    if found is not None and _CUT_JPEG not in failures:
        return found
    reason = gdal_failure(failures[-1] if failures else None)
    raise ImageError("{path} is damaged or cut short: {reason}.", path=path, reason=reason)


@contextlib.contextmanager
def gdal_failures() -> Iterator[list[str]]:
    """Collect the errors of GDAL in the block and this thread, whether GDAL raises them or not.

    GDAL's last error is not enough: warnings and later calls replace it. A JPEG that was cut short is an error here;
    GDAL only warns and returns gray pixels.
    """
    failures: list[str] = []

    def remember(kind: int, number: int, text: str) -> None:
        if kind >= gdal.CE_Failure:
            failures.append(text)
        elif _CUT_JPEG in text:
            failures.append(_CUT_JPEG)

    gdal.PushErrorHandler(remember)
    try:
        yield failures
    except RuntimeError as error:
        failures.append(str(error))
    finally:
        gdal.PopErrorHandler()


@contextlib.contextmanager
def require_written(path: str | Path) -> Iterator[None]:
    """Raise UnwritableError for ``path`` if GDAL reports an error in the block."""
    with gdal_failures() as failures:
        yield
    if failures:
        raise UnwritableError("{path} can't be written: {reason}.", path=path, reason=gdal_failure(failures[0]))


def close(dataset: gdal.Dataset | None) -> None:
    """Close a dataset, which may still write, so that ``gdal_failures`` around it gets the errors.

    GDAL before 3.8 closes a dataset when its last reference is deleted: delete it within that block as well. An error
    that GDAL raises in a destructor is lost.
    """
    if dataset is None or not hasattr(dataset, "Close"):
        return
    try:
        dataset.Close()
    except RuntimeError:
        # GDAL 3.8 to 3.10 keep the reference when closing raises, so that Python would close the dataset twice.
        if dataset.this is not None:
            dataset.thisown = False
            dataset.this = None
        raise
