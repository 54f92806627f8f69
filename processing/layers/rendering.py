"""Draw layers that are not files with QGIS: map tiles, web maps, layers of services."""

from __future__ import annotations

import time
from collections.abc import Sequence
from math import ceil
from typing import Callable

import numpy as np
from qgis.core import (
    QgsBilinearRasterResampler,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsMapLayer,
    QgsMapRendererSequentialJob,
    QgsMapSettings,
    QgsProject,
    QgsRasterLayer,
    QgsRectangle,
)
from qgis.PyQt.QtCore import QBuffer, QEventLoop, QIODevice, QSize, QTimer
from qgis.PyQt.QtGui import QColor, QImage

from ...core import limits
from ...core.errors import ImageError
from ...core.geometry.frame import MapFrame
from ...core.steps import Steps
from ...storage.pictures import ColorPicture
from ..compat import MAP_TILE, wkt_for_gdal
from .downloads import Downloads, install, watched_downloads
from .reference_systems import describe_crs, metric_crs, transformed_box

TILE_PX = 1024
"""Edge of a drawn tile; a cancel takes effect within CANCEL_EVERY_MS."""

CANCEL_EVERY_MS = 200

PICTURE_DPI = 192
"""Resolution of a map's picture on paper, which sets the size of symbols and texts."""


def needs_drawing(layer: QgsRasterLayer | None) -> bool:
    """Whether a layer must be drawn, because GDAL can't read it from a file."""
    return layer is not None and layer.isValid() and layer.providerType() != "gdal"


def drawable(layer: QgsRasterLayer) -> QgsRasterLayer:
    """Return an opaque, smooth copy of a layer for drawing in another thread; call it in the layer's thread."""
    install()
    copy = layer.clone()
    copy.setOpacity(1.0)
    for set_resampler in (copy.resampleFilter().setZoomedInResampler, copy.resampleFilter().setZoomedOutResampler):
        set_resampler(QgsBilinearRasterResampler())
    return copy


def plan_drawing(
    layer: QgsRasterLayer,
    extent: QgsRectangle,
    extent_crs: QgsCoordinateReferenceSystem,
    pixel_size_m: float,
    context: QgsCoordinateTransformContext,
) -> tuple[QgsCoordinateReferenceSystem, MapFrame]:
    """Return the metric CRS for drawing a layer, true to scale, and the pixel grid.

    Args:
        layer: Result of ``drawable``.

    Raises:
        ImageError: The extent can't be transformed to a metric CRS, or is too large.
    """
    crs = metric_crs(extent_crs, QgsCoordinateReferenceSystem(), extent, context)
    ground = transformed_box(QgsCoordinateTransform(extent_crs, crs, context), extent)
    if ground.isEmpty() or not ground.isFinite():
        raise ImageError(
            "The extent for “{layer}” does not fit its CRS {crs}. Choose another extent.",
            layer=layer.name(),
            crs=describe_crs(extent_crs),
        )
    width, height = (max(1, ceil(side / pixel_size_m)) for side in (ground.width(), ground.height()))
    if width * height > limits.DRAWN_PIXELS:
        most = limits.DRAWN_PIXELS // 1_000_000
        raise ImageError(
            "“{layer}” would be drawn with {width} × {height} pixels, which is more than {most_million} million. "
            "Choose a smaller extent, or download the image as a file from its provider.",
            layer=layer.name(),
            width=width,
            height=height,
            most_million=most,
        )
    transform = ground.xMinimum(), pixel_size_m, 0.0, ground.yMaximum(), 0.0, -pixel_size_m
    return crs, MapFrame(wkt_for_gdal(crs), transform, (height, width))


def draw(
    layer: QgsRasterLayer,
    plan: tuple[QgsCoordinateReferenceSystem, MapFrame],
    path: str,
    context: QgsCoordinateTransformContext,
    canceled: Callable[[], bool],
) -> Steps[None]:
    """Draw a layer into a GeoTIFF; yield after each tile.

    Args:
        layer: Result of ``drawable``.
        plan: Result of ``plan_drawing``.
        canceled: Called several times a second; True ends the drawing.

    Raises:
        ImageError: The layer shows nothing in the extent, or its server fails.
        UnwritableError: The file can't be written.
    """
    crs, frame = plan
    name, settings = layer.name(), _settings([layer], crs, context)
    height, width = frame.shape_hw
    places = [(column, row) for row in range(0, height, TILE_PX) for column in range(0, width, TILE_PX)]
    anything = False
    with ColorPicture(path, frame) as picture, watched_downloads(layer) as downloads:
        for n, (column, row) in enumerate(places, start=1):
            shape_hw = min(TILE_PX, height - row), min(TILE_PX, width - column)
            settings.setOutputSize(QSize(*reversed(shape_hw)))
            settings.setExtent(QgsRectangle(*frame.part(column, row, shape_hw).extent))
            pixels_hw4 = _pixels(_draw_piece(settings, canceled, downloads, name), shape_hw)
            anything = anything or bool(pixels_hw4[:, :, 3].any())
            picture.write(column, row, pixels_hw4)
            yield "Drawing the layer", n / len(places)
    if not anything:
        raise ImageError(
            "“{layer}” shows nothing in the extent. Choose another extent, or check whether its server answers.",
            layer=name,
        )


def _require_plain_answers(layer: str, downloads: Downloads) -> None:
    """Raise ImageError if a reply or redirect was refused."""
    if downloads.is_too_large:
        raise ImageError(
            "The server of “{layer}” answered with more than {most_mb} MB for one tile; SemRef stopped reading it.",
            layer=layer,
            most_mb=limits.ANSWER_BYTES // 1_000_000,
        )
    if downloads.refused:
        raise ImageError(
            "The server of “{layer}” redirects to {address}; SemRef reads tiles over http and https only.",
            layer=layer,
            address=downloads.refused,
        )


def styled_copy(layer: QgsMapLayer) -> QgsMapLayer:
    """Return a copy of a layer with its style for drawing in another thread; call it in the layer's thread."""
    install()
    if QgsProject.instance().mapLayer(layer.id()) is None:
        # QGIS opens the files of algorithms without their style.
        layer.loadDefaultStyle()
    return layer.clone()


def map_picture(
    layers: Sequence[QgsMapLayer],
    extent: QgsRectangle,
    crs: QgsCoordinateReferenceSystem,
    width_px: int,
    context: QgsCoordinateTransformContext,
    canceled: Callable[[], bool],
) -> bytes:
    """Return a JPEG of styled layers, the first on top.

    Args:
        layers: Results of ``styled_copy``.
        canceled: Called several times a second; True ends the drawing.

    Raises:
        ImageError: A layer can't be drawn.
    """
    settings = _settings(layers, crs, context)
    settings.setBackgroundColor(QColor("white"))
    settings.setOutputDpi(PICTURE_DPI)
    settings.setOutputSize(QSize(width_px, round(width_px * extent.height() / extent.width())))
    settings.setExtent(extent)
    with watched_downloads(*layers) as downloads:
        image = _draw_piece(settings, canceled, downloads, layers[-1].name())
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    image.save(buffer, "JPG", 85)
    return bytes(buffer.data())


def _settings(
    layers: Sequence[QgsMapLayer], crs: QgsCoordinateReferenceSystem, context: QgsCoordinateTransformContext
) -> QgsMapSettings:
    """Return the settings for all tiles of a drawing.

    The layers are passed to QGIS once: PyQt may treat a Python object as deleted while the network thread calls Python.
    """
    settings = QgsMapSettings()
    settings.setLayers(list(layers))
    settings.setDestinationCrs(crs)
    settings.setTransformContext(context)
    settings.setBackgroundColor(QColor(0, 0, 0, 0))
    settings.setFlag(MAP_TILE, True)
    return settings


def _draw_piece(settings: QgsMapSettings, canceled: Callable[[], bool], downloads: Downloads, layer: str) -> QImage:
    """Draw one tile. Raises ImageError: the layer can't be drawn."""
    job = QgsMapRendererSequentialJob(settings)
    loop, timer = QEventLoop(), QTimer()
    job.finished.connect(loop.quit)
    end = time.monotonic() + limits.DRAWING_S

    def look() -> None:
        if canceled() or downloads.is_broken or time.monotonic() > end:
            job.cancelWithoutBlocking()

    timer.timeout.connect(look)
    timer.start(CANCEL_EVERY_MS)
    job.start()
    if job.isActive():
        loop.exec(QEventLoop.ProcessEventsFlag.ExcludeUserInputEvents)
    timer.stop()
    if time.monotonic() > end and not canceled():
        raise ImageError(
            "The server of “{layer}” took longer than {most_s} s for one tile. Try again later, or choose another "
            "layer.",
            layer=layer,
            most_s=int(limits.DRAWING_S),
        )
    _require_plain_answers(layer, downloads)
    if job.errors() and not canceled():
        raise ImageError("“{layer}” can’t be drawn: {reason}.", layer=layer, reason=job.errors()[0].message)
    return job.renderedImage()


def _pixels(image: QImage, shape_hw: tuple[int, int]) -> np.ndarray:
    height, width = shape_hw
    if image.isNull():
        return np.zeros((height, width, 4), np.uint8)
    plain = image.convertToFormat(QImage.Format.Format_RGBA8888)
    bits = plain.constBits()
    bits.setsize(plain.bytesPerLine() * plain.height())
    return np.frombuffer(bits, np.uint8).reshape(height, plain.bytesPerLine() // 4, 4)[:, :width].copy()
