"""Rasters and the label maps in them, read by GDAL."""

from __future__ import annotations

import functools
import os
import stat
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Callable

import numpy as np
from osgeo import gdal

from ..core import limits
from ..core.errors import LabelMapError, UnwritableError, reason_of
from ..core.labels.class_table import (
    ClassTable,
    LandCoverClass,
    chosen_colors,
    class_table_from_csv,
    class_table_from_values,
)
from ..core.labels.image_files import require_kind_of_name
from ..core.labels.sources import ArrayLabels, LabelSource, count_labels
from .gdal_errors import gdal_failure, gdal_failures, read_by_gdal
from .label_map_file import CLASS_TABLE_ITEM

HELD_PIXELS = 400_000_000
"""A label map up to this size is held in memory while a database is built; a larger one is read piece by piece."""

_COUNTED_AT_ONCE = 8_000_000

_INTEGER_NAMES = ("Byte", "Int8", "UInt16", "Int16", "UInt32", "Int32", "UInt64", "Int64")
_INTEGER_TYPES = {getattr(gdal, f"GDT_{name}") for name in _INTEGER_NAMES if hasattr(gdal, f"GDT_{name}")}
"""Integer types that this GDAL has; it got 64 bits with 3.5 and Int8 with 3.7."""

IMAGE_EXTENSIONS = (".tif", ".tiff", ".png", ".jpg", ".jpeg", ".jp2", ".bmp", ".gif", ".webp", ".vrt", ".img", ".asc")


_OWN_PIXELS = (
    *("GTiff", "PNG", "JPEG", "JP2OpenJPEG", "JP2KAK", "JP2ECW", "JP2MrSID", "JPEGXL", "BMP", "GIF", "BIGGIF", "WEBP"),
    *("AVIF", "HEIF", "EXR", "PNM", "HFA", "AAIGrid", "ENVI", "EHdr", "RST", "SAGA", "RMF"),
    *("XYZ", "GSBG", "GS7BG", "SRTMHGT", "USGSDEM", "NITF", "ECW", "MrSID", "GPKG", "MBTiles", "KEA", "HDF4", "HDF5"),
    *("netCDF", "GRIB"),
)
"""GDAL's drivers of files that hold their own pixels. Others (VRT, WMS, STACIT, ERS, …) read descriptions of rasters
that lie elsewhere, and ask hosts for them."""

_BY_SUFFIX = {
    ".png": ("PNG",),
    ".jpg": ("JPEG",),
    ".jpeg": ("JPEG",),
    ".tif": ("GTiff", "LIBERTIFF"),
    ".tiff": ("GTiff", "LIBERTIFF"),
    ".bmp": ("BMP",),
    ".gif": ("GIF", "BIGGIF"),
    ".webp": ("WEBP",),
}
"""A name with one of these suffixes says what the content is; others are opened by whichever of the drivers fits."""

DESCRIPTIONS = (".vrt", ".xml", ".wms", ".gti", ".json", ".ers", ".mpr", ".mpl", ".pix")
"""Suffixes by which the user names a description as such."""

_OVERVIEW_DRIVERS = ("GTiff", "HFA")
"""Drivers of overviews and masks in files of their own; GDAL itself opens these files with any driver."""

_ERDAS = b"EHFA_HEADER_TAG"
"""GDAL takes no other ``.aux`` for its own; LaTeX writes such files as well."""

_OVERVIEW_FILE = "OVERVIEW_FILE", "OVERVIEWS"
"""Item and domain of metadata, in a TIFF or in ``.aux.xml``, by which a raster names another one, also of a host."""

_FARTHEST = 1e9
"""Map units from the origin, and of a pixel; the false eastings of zoned CRS come to 6e7."""


def drivers_for(path: str) -> list[str]:
    """GDAL's drivers that may open a path; none named (``[]``) stands for all.

    All may for what can't be mistaken for a picture: what is no file (/vsi paths, GDAL's names of parts of files), and
    files that are named as descriptions.
    """
    is_named = path.startswith("/vsi") or path.lower().endswith(DESCRIPTIONS)
    if is_named or not os.path.isfile(path):
        return []
    return list(_BY_SUFFIX.get(os.path.splitext(path)[1].lower(), _OWN_PIXELS))


def open_raster(path: str) -> gdal.Dataset:
    """A GDAL dataset for reading, THE way in for rasters.

    Args:
        path: A file or another name that GDAL knows.

    Raises:
        LabelMapError: It can't be read, with GDAL's reason (GDAL may raise or return None), it only describes another
            raster though it has the name of a picture, it is of another kind than its name says, or its georeference is
            none.
    """
    drivers = drivers_for(path)
    if drivers:
        require_kind_of_name(path, _start(path), LabelMapError)
        _require_own_side_cars(path)
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    try:
        gdal.ErrorReset()
        # Without OF_VERBOSE_ERROR GDAL does not say why no driver takes a file.
        kind = gdal.OF_RASTER | gdal.OF_READONLY | gdal.OF_VERBOSE_ERROR
        dataset = gdal.OpenEx(path, kind, drivers)
        # GDAL reads it from damaged keys only now, and may raise as well.
        transform = None if dataset is None else dataset.GetGeoTransform(can_return_null=True)
    except RuntimeError as error:
        raise LabelMapError("{path} can't be read: {reason}.", path=path, reason=gdal_failure(error)) from None
    finally:
        gdal.PopErrorHandler()
    if dataset is None or dataset.RasterCount == 0:
        raise LabelMapError("{path} can't be read: {reason}.", path=path, reason=gdal_failure())
    if drivers and dataset.GetMetadataItem(*_OVERVIEW_FILE):
        raise LabelMapError(
            "{path} names another file for its overviews ({name}), which SemRef does not open; remove {path}.aux.xml, "
            "or build the overviews again.",
            path=path,
            name=dataset.GetMetadataItem(*_OVERVIEW_FILE),
        )
    if transform is not None and not all(abs(value) < _FARTHEST for value in transform):
        numbers = ", ".join(f"{value:g}" for value in transform)
        raise LabelMapError(
            "{path} has a georeference that no map has ({numbers}); give it its place on the ground anew.",
            path=path,
            numbers=numbers,
        )
    return dataset


def _start(path: str) -> bytes:
    try:
        with open(path, "rb") as file:
            return file.read(16)
    except OSError:
        # GDAL says why.
        return b""


def require_own_pixels(path: str) -> None:
    """Raises LabelMapError for a file that GDAL would read other rasters for, before QGIS opens it.

    That is a description of another raster under the name of a picture, or a raster with such an overview.
    """
    drivers = drivers_for(path)
    if drivers:
        driver = _driver_of(path)
        # What no driver takes is reported by QGIS.
        if driver:
            open_raster(path)


def _driver_of(path: str) -> str:
    """Return the short name of the driver that GDAL would open a raster with; empty without one."""
    driver = None
    with gdal_failures():
        driver = gdal.IdentifyDriverEx(path, gdal.OF_RASTER)
    return "" if driver is None else driver.ShortName


def _require_own_side_cars(path: str) -> None:
    """Raise LabelMapError where GDAL would read other rasters because of a file beside a raster.

    Overviews and masks must be TIFF or Erdas files that hold their own pixels, and so must the files beside them.
    """
    for side_car in _side_cars(path):
        foreign = LabelMapError(
            "{path} is beside {raster}, but does not hold pixels or metadata of its own, so GDAL would open other "
            "files; remove it.",
            path=side_car,
            raster=path,
        )
        is_metadata = side_car.lower().endswith(".aux.xml")
        state = os.stat(side_car)
        if not stat.S_ISREG(state.st_mode) or is_metadata and state.st_size > limits.SIDE_CAR_BYTES:
            raise foreign
        if is_metadata or side_car.lower().endswith(".aux") and not _start(side_car).startswith(_ERDAS):
            continue
        dataset = None
        if _driver_of(side_car) in _OVERVIEW_DRIVERS:
            with gdal_failures():
                dataset = gdal.OpenEx(side_car, gdal.OF_RASTER | gdal.OF_READONLY, list(_OVERVIEW_DRIVERS))
        if dataset is None or dataset.GetMetadataItem(*_OVERVIEW_FILE):
            raise foreign
        _require_own_side_cars(side_car)


def _side_cars(path: str) -> list[str]:
    """Return the files beside a raster from which GDAL takes metadata, overviews or a mask, in any case of letters."""
    folder, name = os.path.split(os.path.abspath(path))
    wanted = [f"{name}{suffix}" for suffix in (".aux.xml", ".ovr", ".msk", ".aux")] + [f"{name.rpartition('.')[0]}.aux"]
    try:
        listed = _listed(folder, os.stat(folder).st_mtime_ns)
    except OSError:
        # A folder that can't be listed may still be read from.
        return [side_car for one in wanted if os.path.exists(side_car := os.path.join(folder, one))]
    return [os.path.join(folder, one) for want in wanted for one in listed.get(want.lower(), ())]


@functools.lru_cache(maxsize=1)
def _listed(folder: str, changed_ns: int) -> dict[str, list[str]]:
    """Return the names in a folder by the same in small letters; ``changed_ns`` tells its states apart."""
    found: dict[str, list[str]] = {}
    for name in os.listdir(folder):
        found.setdefault(name.lower(), []).append(name)
    return found


def require_whole_raster(path: str, target: str) -> None:
    """Opens a raster that was just written and reads its last pixels, which a full disk would lack.

    Args:
        target: What it is called in what is said.

    Raises:
        UnwritableError: When it can't be read to its end.
    """
    dataset = None
    # It may raise or return None, as the user has set it.
    with gdal_failures() as failures:
        dataset = gdal.OpenEx(path, gdal.OF_RASTER | gdal.OF_READONLY)
        if dataset is not None:
            for number in range(1, dataset.RasterCount + 1):
                dataset.GetRasterBand(number).ReadAsArray(dataset.RasterXSize - 1, dataset.RasterYSize - 1, 1, 1)
    if dataset is None or failures:
        reason = failures[-1].rstrip(".") if failures else gdal_failure()
        raise UnwritableError(
            "{path} could not be written whole: {reason}; see whether the disk is full.", path=target, reason=reason
        )


class GdalLabels:
    """A LabelSource on disk: one band of whole numbers 0–255."""

    def __init__(self, path: str, keeps_blocks: bool = False) -> None:
        """Opens the map.

        Args:
            keeps_blocks: For work that returns to the same places: GDAL's cache keeps the blocks of pieces; those of
                whole rows are still let go, as they are read once and in order.

        Raises:
            LabelMapError: The file is anything else.
        """
        self._path = path
        self._keeps_blocks = keeps_blocks
        self._dataset = open_raster(path)
        self._band = self._dataset.GetRasterBand(1)
        if self._dataset.RasterCount != 1:
            raise LabelMapError(
                "{path} has {bands} bands; a label map has one: decode a color image with “Decode color labels” first.",
                path=path,
                bands=self._dataset.RasterCount,
            )
        if self._band.DataType not in _INTEGER_TYPES:
            kind = gdal.GetDataTypeName(self._band.DataType)
            raise LabelMapError(
                "{path} holds {kind} values; a label map holds whole numbers from 0 to 255.", path=path, kind=kind
            )
        self._nodata = self._band.GetNoDataValue()

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""
        return self._dataset.RasterYSize, self._dataset.RasterXSize

    @property
    def dataset(self) -> gdal.Dataset:
        """The open file."""
        return self._dataset

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """(height, width) uint8 labels, 0 where the file says that nothing is.

        Raises:
            LabelMapError: The file is damaged, or a value is no label.
        """
        block = read_by_gdal(LabelMapError, self._path, self._band.ReadAsArray, column, row, width, height)
        # Blocks that are read once and in order would only fill GDAL's cache.
        if not self._keeps_blocks or width == self._dataset.RasterXSize:
            self._dataset.FlushCache()
        if self._nodata is not None and self._nodata != 0:
            block[block == self._nodata] = 0
        if block.dtype == np.uint8:
            return np.ascontiguousarray(block)
        if block.size and (block.min() < 0 or block.max() > 255):
            found = int(block.max() if block.max() > 255 else block.min())
            raise LabelMapError(
                "{path} has the value {found}; a label map holds class values from 0 to 255.",
                path=self._path,
                found=found,
            )
        return block.astype(np.uint8)


class HeldLabels:
    """A label map read into memory, which saves decoding it twice; iterate ``steps()``, then take ``source``.

    Maps of more than HELD_PIXELS stay on disk: ``source`` is then the label map itself.
    """

    def __init__(self, labels: GdalLabels) -> None:
        self._labels = labels
        self.source: LabelSource = labels

    def steps(self) -> Iterator[tuple[str, float]]:
        """Yields (what is being done, share done 0…1)."""
        height, width = self._labels.shape_hw
        if height * width > HELD_PIXELS:
            return
        held = np.empty((height, width), np.uint8)
        rows = max(1, _COUNTED_AT_ONCE // width)
        for first in range(0, height, rows):
            last = min(first + rows, height)
            held[first:last] = self._labels.read(0, first, width, last - first)
            yield "Reading the label map", last / height
        self.source = ArrayLabels(held)


@dataclass(frozen=True)
class RasterFile:
    """What a raster file cannot tell GDAL itself: what QGIS knows of its layer.

    Attributes:
        path: GDAL's source.
        crs_wkt: The CRS as GDAL takes it; empty for none.
        is_metric: Whether that CRS is projected with meters as unit.
        styled_classes: Classes of the layer's style, if it has any.
    """

    path: str
    crs_wkt: str = ""
    is_metric: bool = False
    styled_classes: tuple[LandCoverClass, ...] = ()


def stored_class_table(dataset: gdal.Dataset, path: str) -> ClassTable | None:
    """The class table that a label map made by SemRef carries."""
    text = dataset.GetMetadataItem(CLASS_TABLE_ITEM)
    return class_table_from_csv(text, f"the class table inside {path}") if text else None


def named_classes(dataset: gdal.Dataset) -> tuple[LandCoverClass, ...]:
    """Classes from GDAL's category names and color table."""
    band = dataset.GetRasterBand(1)
    colors = band.GetRasterColorTable()
    named = [(v, name) for v, name in enumerate(band.GetRasterCategoryNames() or []) if 0 < v <= 255 and name]
    found = []
    for (value, name), chosen in zip(named, chosen_colors(named)):
        entry = colors.GetColorEntry(value) if colors is not None and value < colors.GetCount() else None
        color = "#{:02x}{:02x}{:02x}".format(*entry[:3]) if entry else chosen
        found.append(LandCoverClass(value, name, color))
    names = [c.name for c in found]
    return tuple(found) if len(set(names)) == len(names) else ()


def class_table_of_map(labels: GdalLabels, file: RasterFile) -> ClassTable | None:
    """The map's own table, else that of its category names, else of its layer's style; None when it has none."""
    stored = stored_class_table(labels.dataset, file.path)
    if stored is not None:
        return stored
    classes = named_classes(labels.dataset) or file.styled_classes
    return ClassTable(classes) if classes else None


def count_values(labels: GdalLabels, canceled: Callable[[], bool]) -> np.ndarray:
    """(256,) pixels of each value of the whole map; zeros when canceled."""
    height, width = labels.shape_hw
    rows = max(1, _COUNTED_AT_ONCE // width)
    counts = np.zeros(256, np.int64)
    for first in range(0, height, rows):
        counts += count_labels(labels.read(0, first, width, min(rows, height - first)))
        if canceled():
            return np.zeros(256, np.int64)
    return counts


def class_table_of_values(counts: np.ndarray) -> ClassTable:
    """Table of the label values that occur; ``counts``: (256,) pixels a value."""
    return class_table_from_values(int(v) for v in np.flatnonzero(counts) if v)


def image_files(paths: list[str]) -> list[str]:
    """Files as given; a folder stands for the images in it, by name. Raises LabelMapError for an empty folder."""
    found: list[str] = []
    for path in paths:
        if not os.path.isdir(path):
            found.append(path)
            continue
        try:
            inside = sorted(os.listdir(path))
        except OSError as error:
            raise LabelMapError("Image {path} can't be read: {reason}.", path=path, reason=reason_of(error)) from None
        images = [os.path.join(path, name) for name in inside if name.lower().endswith(IMAGE_EXTENSIONS)]
        if not images:
            raise LabelMapError("The folder {path} holds no image ({endings}).", path=path, endings=IMAGE_EXTENSIONS)
        found += images
    return found
