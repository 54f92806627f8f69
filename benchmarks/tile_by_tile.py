"""Segment an image tile by tile, with the published steps of Deepness (0.7), as a reference.

This is not Deepness: its windows, tasks and messages, which would take more time, are missing. The code reads each tile
band by band with QGIS's data provider and bilinear resampling, standardizes it, and runs it in a session with
onnxruntime's default settings. numpy selects the best channel. The middle of each tile goes into one array of the whole
image, and a median blur removes seams and specks. Polygons are OpenCV's contours of each class with their holes, added
point by point to features of a memory layer.
"""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np

BLUR_PX = 9
"""Default of Deepness."""


class TileByTile:
    """Segment an image: ``labels()`` returns channel + 1 of each pixel, ``polygons(labels)`` a layer for each class."""

    def __init__(self, model: Path, image: Path) -> None:
        """Open model and image. The image has 8 bits, red, green and blue, and the pixel size of the model."""
        import onnxruntime
        from qgis.core import QgsRasterLayer

        self._layer = QgsRasterLayer(str(image))
        self._session = onnxruntime.InferenceSession(str(model), providers=["CPUExecutionProvider"])
        texts = self._session.get_modelmeta().custom_metadata_map
        self._tile = int(json.loads(texts["tile_size"]))
        self._stride = round(self._tile * (1 - float(json.loads(texts["tiles_overlap"])) / 100))
        self._mean, self._deviation = (
            np.array(json.loads(texts[key]), np.float32) for key in ("standardization_mean", "standardization_std")
        )

    def labels(self) -> np.ndarray:
        """Return labels (H, W) uint8, 1 for the first channel."""
        height, width = self._layer.height(), self._layer.width()
        rows, columns = (max(0, -(-(size - self._tile) // self._stride)) + 1 for size in (height, width))
        whole = np.zeros(((rows - 1) * self._stride + self._tile, (columns - 1) * self._stride + self._tile), np.uint8)
        margin = (self._tile - self._stride) // 2
        for row in range(rows):
            for column in range(columns):
                scores = self._session.run(None, {self._session.get_inputs()[0].name: self._planes(row, column)})[0]
                found = np.argmax(scores, axis=1)[0] + 1
                top, left = (0 if place == 0 else margin for place in (row, column))
                y, x = row * self._stride, column * self._stride
                whole[y + top : y + self._tile, x + left : x + self._tile] = found[top:, left:]
        return cv2.medianBlur(whole, BLUR_PX)[:height, :width]

    def _planes(self, row: int, column: int) -> np.ndarray:
        """Return standardized pixels (1, 3, tile, tile) float32."""
        from qgis.core import QgsRectangle

        extent, size = self._layer.extent(), self._layer.rasterUnitsPerPixelX()
        left = extent.xMinimum() + column * self._stride * size
        top = extent.yMaximum() - row * self._stride * size
        wanted = QgsRectangle(left, top - self._tile * size, left + self._tile * size, top)
        provider = self._layer.dataProvider()
        provider.enableProviderResampling(True)
        provider.setZoomedInResamplingMethod(provider.ResamplingMethod.Bilinear)
        provider.setZoomedOutResamplingMethod(provider.ResamplingMethod.Bilinear)
        blocks = [provider.block(band, wanted, self._tile, self._tile) for band in (1, 2, 3)]
        bands = [np.frombuffer(bytes(block.data()), np.uint8).reshape(self._tile, self._tile) for block in blocks]
        pixels = (np.stack(bands, axis=2).astype(np.float32) / 255 - self._mean) / self._deviation
        return np.ascontiguousarray(pixels.transpose(2, 0, 1)[None], np.float32)

    def polygons(self, labels_hw: np.ndarray) -> list:
        """Return a memory layer for each class in the labels."""
        return [self._layer_of(labels_hw == value) for value in np.unique(labels_hw)]

    def _layer_of(self, mask_hw: np.ndarray) -> object:
        from qgis.core import QgsFeature, QgsGeometry, QgsVectorLayer

        contours, hierarchy = cv2.findContours(mask_hw.astype(np.uint8), cv2.RETR_CCOMP, cv2.CHAIN_APPROX_SIMPLE)
        placed = [self._points(contour) for contour in contours]
        features = []
        for n, (_, _, child, parent) in enumerate([] if hierarchy is None else hierarchy[0].tolist()):
            if parent >= 0 or len(placed[n]) < 3:
                continue
            holes = []
            while child >= 0:
                holes += [placed[child]] if len(placed[child]) >= 3 else []
                child = int(hierarchy[0][child][0])
            feature = QgsFeature()
            feature.setGeometry(QgsGeometry.fromPolygonXY([placed[n], *holes]))
            features.append(feature)
        layer = QgsVectorLayer("multipolygon", "class", "memory")
        layer.setCrs(self._layer.crs())
        layer.dataProvider().addFeatures(features)
        layer.updateExtents()
        return layer

    def _points(self, contour: np.ndarray) -> list:
        from qgis.core import QgsPointXY

        extent, size = self._layer.extent(), self._layer.rasterUnitsPerPixelX()
        left, top = extent.xMinimum(), extent.yMaximum()
        return [QgsPointXY(left + x * size, top - y * size) for x, y in contour[:, 0].tolist()]
