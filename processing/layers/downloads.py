"""Limit QGIS's downloads for a drawing to http and https, and each reply to a maximum size."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from typing import Callable
from urllib.parse import unquote

from qgis.core import QgsMapLayer, QgsNetworkAccessManager, QgsNetworkRequestParameters
from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtNetwork import QNetworkReply, QNetworkRequest

from ...core import limits

_SCHEMES = {"http", "https"}
_OF_RASTERS = re.compile(r"Qgs(Wms|Wcs|Ams|ArcGis|Xyz)")
"""QGIS classes that request tiles and maps; other requests are not limited."""


@dataclass
class Downloads:
    """Downloads for one drawing.

    Attributes:
        refused: Address with another scheme from a redirect; empty without one.
        is_too_large: Whether a reply was larger than ``limits.ANSWER_BYTES``.
    """

    schemes: set[str] = field(default_factory=lambda: set(_SCHEMES))
    refused: str = ""
    is_too_large: bool = False
    looks: list[Callable[[], None]] = field(default_factory=list)
    """Slots of replies. They are kept here, because Python's garbage collector would delete a reply and its slot."""

    @property
    def is_broken(self) -> bool:
        """Whether a reply or an address was refused."""
        return self.is_too_large or bool(self.refused)


_watched: list[Downloads] = []
_installed: list[object] = []


def install() -> None:
    """Register this module at QGIS's network manager, once per session, in the main thread.

    It is never removed, because other threads may be iterating over the registered functions.
    """
    if not _installed:
        _installed.append(QgsNetworkAccessManager.setRequestPreprocessor(_check_request))
        _installed.append(QgsNetworkAccessManager.setReplyPreprocessor(_limit_reply))


@contextmanager
def watched_downloads(*layers: QgsMapLayer) -> Iterator[Downloads]:
    """Limit downloads until the block ends; call ``install`` before.

    Args:
        layers: The drawn layers. If one of them uses tiles on disk, files are allowed as well.
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
    """Remove the address of a request after a redirect to a refused scheme, or after a refused reply.

    Runs in the requesting thread.
    """
    for downloads in tuple(_watched) if _is_for_raster(request) else ():
        if request.url().scheme().lower() not in {*downloads.schemes, ""}:
            downloads.refused = request.url().toString()
        if downloads.is_broken:
            request.setUrl(QUrl())


def _limit_reply(request: QNetworkRequest, reply: QNetworkReply) -> None:
    """Abort a reply that becomes too large, in the requesting thread."""
    watching = tuple(_watched)
    if not watching or not _is_for_raster(request):
        return

    def look() -> None:
        # QGIS reads only complete replies.
        watched = tuple(_watched)
        with suppress(RuntimeError):
            if reply.bytesAvailable() >= limits.ANSWER_BYTES or any(downloads.is_too_large for downloads in watched):
                for downloads in watched:
                    downloads.is_too_large = True
                reply.abort()

    # Qt may have deleted the reply. PyQt then raises RuntimeError, which would end QGIS in this thread.
    with suppress(RuntimeError):
        # Limits Qt's buffer for fast servers.
        reply.setReadBufferSize(2 * limits.ANSWER_BYTES)
        # Not downloadProgress: Qt omits some of its signals, maybe the one that fills the buffer. QGIS would then wait
        # for its timeout.
        reply.readyRead.connect(look)
        watching[0].looks.append(look)


def _is_for_raster(request: QNetworkRequest) -> bool:
    try:
        name = QNetworkRequest.Attribute(QgsNetworkRequestParameters.RequestAttributes.AttributeInitiatorClass)
    except ValueError:
        # PyQt6 supports only Qt's own attributes.
        return True
    return _OF_RASTERS.match(str(request.attribute(name) or "")) is not None
