"""What QGIS downloads for a drawing: over http or https alone, and each answer of bounded size."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Callable
from urllib.parse import unquote

from qgis.core import QgsMapLayer, QgsNetworkAccessManager, QgsNetworkRequestParameters
from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtNetwork import QNetworkReply, QNetworkRequest

from ...core import limits

_SCHEMES = {"http", "https"}
_OF_RASTERS = re.compile(r"Qgs(Wms|Wcs|Ams|ArcGis|Xyz)")
"""Classes of QGIS that ask for tiles and maps; requests of others are left alone."""


@dataclass
class Downloads:
    """Downloads for one drawing.

    Attributes:
        schemes: Of addresses that may be asked.
        refused: An address of another scheme that a server sent QGIS to; empty for none.
        is_too_large: Whether an answer was larger than ``limits.ANSWER_BYTES``.
    """

    schemes: set[str] = field(default_factory=lambda: set(_SCHEMES))
    refused: str = ""
    is_too_large: bool = False
    looks: list[Callable[[], None]] = field(default_factory=list)
    """What replies call, kept alive: a reply and its function refer to each other, and Python's garbage collector
    would end their connection."""

    @property
    def is_broken(self) -> bool:
        """Whether the server sent what is not taken."""
        return self.is_too_large or bool(self.refused)


_watched: list[Downloads] = []
_installed: list[object] = []


def install() -> None:
    """Makes QGIS's network manager call this module, once a session; for the main thread.

    It is never removed: other threads may be going through the list of what is called.
    """
    if not _installed:
        _installed.append(QgsNetworkAccessManager.setRequestPreprocessor(_check_request))
        _installed.append(QgsNetworkAccessManager.setReplyPreprocessor(_limit_reply))


@contextmanager
def watched_downloads(*layers: QgsMapLayer) -> Iterator[Downloads]:
    """Watches downloads until the block ends, after ``install``.

    Args:
        layers: What is drawn. Where the user named tiles on the disk, files may be asked for as well.
    """
    downloads = Downloads()
    if any("=file:" in unquote(layer.source()).lower() for layer in layers):
        downloads.schemes.add("file")
    _watched.append(downloads)
    try:
        yield downloads
    finally:
        _watched.remove(downloads)


def _check_request(request: QNetworkRequest) -> None:
    """Takes the address out of a request that a redirect made, or that follows too large an answer.

    It runs in the thread that asks.
    """
    for downloads in tuple(_watched) if _is_for_raster(request) else ():
        if request.url().scheme().lower() not in {*downloads.schemes, ""}:
            downloads.refused = request.url().toString()
        if downloads.is_broken:
            request.setUrl(QUrl())


def _limit_reply(request: QNetworkRequest, reply: QNetworkReply) -> None:
    """Ends a reply that grows too large, in the thread that asks."""
    watching = tuple(_watched)
    if not watching or not _is_for_raster(request):
        return

    def look() -> None:
        # QGIS reads a reply only when it is whole.
        watched = tuple(_watched)
        if reply.bytesAvailable() >= limits.ANSWER_BYTES or any(downloads.is_too_large for downloads in watched):
            for downloads in watched:
                downloads.is_too_large = True
            reply.abort()

    # Qt reads no further than this ahead, however fast the server is.
    reply.setReadBufferSize(2 * limits.ANSWER_BYTES)
    # Not downloadProgress: Qt leaves out some of its signals, perhaps that for the bytes that fill the buffer, after
    # which QGIS would wait for its timeout.
    watching[0].looks.append(look)
    reply.readyRead.connect(look)


def _is_for_raster(request: QNetworkRequest) -> bool:
    try:
        name = QNetworkRequest.Attribute(QgsNetworkRequestParameters.RequestAttributes.AttributeInitiatorClass)
    except ValueError:
        # PyQt6 knows Qt's own attributes alone.
        return True
    return _OF_RASTERS.match(str(request.attribute(name) or "")) is not None
