"""Open the images to localize: label images with their class offsets, and photos of bounded size."""

from __future__ import annotations

from typing import Any

import numpy as np
from osgeo import gdal

from ..core.errors import ImageError
from ..core.geometry.camera import Camera
from ..core.labels.class_shares import SeenLabels
from ..core.labels.class_table import UNLABELED, ClassTable
from ..core.labels.color_labels import decode_colors
from ..core.labels.image_files import require_size
from ..core.segmentation.class_bias import KEY, known_biases, read_class_bias
from .gdal_errors import read_by_gdal
from .images import GdalImage
from .label_map_file import CLASS_BIAS_ITEM
from .label_maps import GdalLabels
from .rasters import open_raster

_SAMPLED_PX, _MOST_LABEL_COLORS = 128, 256
"""Edge of the sampled square in pixels, and largest number of colors of a label image, with blurred borders."""


class LabelImageReader:
    """A ``pipeline.LabelReader`` of label images in the classes of a table."""

    stated_biases = ""
    resolution_m = None

    def __init__(self, table: ClassTable) -> None:
        self._table = table

    def __call__(self, path: str, camera: Camera | None = None, with_pixels: bool = False) -> SeenLabels:
        """Return the labels of an image and the class offsets that it states; ``with_pixels`` has no effect."""
        labels_hw, stated = read_label_image(path, self._table), stated_biases(path)
        if stated is None:
            return SeenLabels(labels_hw)
        return SeenLabels(labels_hw, biases=known_biases(read_class_bias({KEY: stated}, None, path), self._table))

    def log_pace(self) -> dict[str, Any]:
        """Return no result numbers: there is no network."""
        return {}


def open_photo(path: str) -> GdalImage:
    """Open a photo. Raises ImageError if it is too large."""
    photo = GdalImage(path)
    require_size(photo.shape_hw, None, path)
    return photo


def read_label_image(path: str, table: ClassTable) -> np.ndarray:
    """Return (H, W) uint8 labels: the values of one band, or the decoded colors of three and more bands.

    The table's HSV ranges decode colors; without ranges, the nearest color does. Pixels outside a mask in the file are
    unlabeled. Raises ImageError.
    """
    dataset = open_raster(path)
    width, height = dataset.RasterXSize, dataset.RasterYSize
    require_size((height, width), None, path)
    if dataset.RasterCount == 1:
        labels = GdalLabels(path).read(0, 0, width, height)
    else:
        labels = decode_colors(read_bgr(dataset, path, 0, height), table)
    wanted = _own_mask(dataset, path)
    return labels if wanted is None else np.where(wanted, labels, UNLABELED)


def has_photo_colors(path: str) -> bool:
    """Whether the center of an image with three or more bands has too many colors for a label image.

    Returns False for an unreadable image.
    """
    try:
        dataset = open_raster(path)
        if dataset.RasterCount < 3:
            return False
        size = min(_SAMPLED_PX, dataset.RasterXSize), min(_SAMPLED_PX, dataset.RasterYSize)
        first = (dataset.RasterXSize - size[0]) // 2, (dataset.RasterYSize - size[1]) // 2
        bands = dataset.ReadAsArray(*first, *size)
    except (ImageError, RuntimeError):
        return False
    return bands is not None and len(np.unique(bands[:3].reshape(3, -1), axis=1).T) > _MOST_LABEL_COLORS


def _own_mask(dataset: gdal.Dataset, path: str) -> np.ndarray | None:
    """Return (H, W) bool of the pixels that a mask in the file includes; None without mask. Raises ImageError."""
    band = dataset.GetRasterBand(1)
    if read_by_gdal(path, band.GetMaskFlags) != gdal.GMF_PER_DATASET:
        return None
    return read_by_gdal(path, band.GetMaskBand().ReadAsArray) > 0


def stated_biases(path: str) -> str | None:
    """Return the text of the class offsets in a label map; None if no network made it."""
    return open_raster(path).GetMetadataItem(CLASS_BIAS_ITEM)


def read_bgr(dataset: gdal.Dataset, path: str, first_row: int, rows: int) -> np.ndarray:
    """Return rows of an RGB(A) or paletted image as (rows, W, 3) uint8, blue first. Raises ImageError for others."""
    palette = dataset.GetRasterBand(1).GetRasterColorTable()
    if dataset.RasterCount == 1 and palette is not None:
        colors = np.zeros((256, 3), np.uint8)
        for value in range(min(palette.GetCount(), 256)):
            colors[value] = palette.GetColorEntry(value)[2::-1]
        return colors[_read_bytes(dataset, 1, path, first_row, rows)]
    if dataset.RasterCount < 3:
        raise ImageError(
            "{path} has {bands} band(s) and no palette; a color image has three bands.",
            path=path,
            bands=dataset.RasterCount,
        )
    return np.dstack([_read_bytes(dataset, number, path, first_row, rows) for number in (3, 2, 1)])


def _read_bytes(dataset: gdal.Dataset, number: int, path: str, first_row: int, rows: int) -> np.ndarray:
    band = dataset.GetRasterBand(number)
    if band.DataType != gdal.GDT_Byte:
        kind = gdal.GetDataTypeName(band.DataType)
        raise ImageError("{path} holds {kind} values; a color label image has 8 bits a band.", path=path, kind=kind)
    return read_by_gdal(path, band.ReadAsArray, 0, first_row, dataset.RasterXSize, rows)
