"""Open rasters with GDAL, safely: only the pixels of the named file are read, never other files or hosts."""

from __future__ import annotations

import functools
import os
import stat

from osgeo import gdal

from ..core import limits
from ..core.errors import ImageError, UnwritableError
from ..core.labels import image_files as core_images
from ..core.labels.image_files import require_kind_of_name
from ..core.sentences import Sentence
from .gdal_errors import gdal_failure, gdal_failures

IMAGE_EXTENSIONS = (
    *(".tif", ".tiff", ".png", ".jpg", ".jpeg", ".jp2", ".heic", ".heif", ".bmp", ".gif", ".webp"),
    *(".vrt", ".img", ".asc"),
)
"""Suffixes of the images of a folder. Not every GDAL reads HEIC: without it, the photo of a phone gets a reason."""

_OWN_PIXELS = (
    *("GTiff", "PNG", "JPEG", "JP2OpenJPEG", "JP2KAK", "JP2ECW", "JP2MrSID", "JPEGXL", "BMP", "GIF", "BIGGIF", "WEBP"),
    *("AVIF", "HEIF", "EXR", "PNM", "HFA", "AAIGrid", "ENVI", "EHdr", "RST", "SAGA", "RMF"),
    *("XYZ", "GSBG", "GS7BG", "SRTMHGT", "USGSDEM", "NITF", "ECW", "MrSID", "GPKG", "MBTiles", "KEA", "HDF4", "HDF5"),
    *("netCDF", "GRIB"),
)
"""GDAL's drivers of files that contain their own pixels.

Other drivers (VRT, WMS, STACIT, ERS, …) read descriptions of rasters in other files or on hosts.
"""

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
"""Drivers by suffix. For other suffixes, GDAL chooses among ``_OWN_PIXELS``."""

DESCRIPTIONS = (".vrt", ".xml", ".wms", ".gti", ".json", ".ers", ".mpr", ".mpl", ".pix")
"""Suffixes of descriptions of rasters, which the user may choose explicitly."""

_OVERVIEW_DRIVERS = ("GTiff", "HFA")
"""Allowed drivers of separate overview and mask files; GDAL itself would open these files with any driver."""

_ERDAS = b"EHFA_HEADER_TAG"
"""Start of the ``.aux`` files that GDAL reads; LaTeX writes ``.aux`` files as well."""

_OVERVIEW_FILE = "OVERVIEW_FILE", "OVERVIEWS"
"""Metadata item and domain, in a TIFF or ``.aux.xml``, that names another file or an address for overviews."""

_FARTHEST = 1e9
"""Largest coordinate and pixel size in map units; false eastings of zoned CRS reach 6e7."""


WITHOUT_GEOREFERENCE = (0.0, 1.0, 0.0, 0.0, 0.0, -1.0)
"""GDAL's six numbers for an image without georeference: x is the column, y the negative row."""


def drivers_for(path: str) -> list[str]:
    """Return GDAL's drivers that may open a path; ``[]`` allows all drivers.

    All drivers are allowed for names that can't be mistaken for a picture: /vsi paths, GDAL's names of parts of files,
    and files with the suffix of a description.
    """
    is_named = path.startswith("/vsi") or path.lower().endswith(DESCRIPTIONS)
    if is_named or not os.path.isfile(path):
        return []
    return list(_BY_SUFFIX.get(os.path.splitext(path)[1].lower(), _OWN_PIXELS))


def open_raster(path: str) -> gdal.Dataset:
    """Open a raster for reading. All of SemRef opens rasters with this function.

    Args:
        path: A file or another name that GDAL can open.

    Raises:
        ImageError: GDAL can't read it, it has the name of a picture but describes another raster or has another
            format, or its georeference is impossible.
    """
    if os.path.exists(path) and not (os.path.isfile(path) or os.path.isdir(path)):
        # GDAL would wait for a pipe forever.
        raise ImageError("Image {path} is a folder, pipe or device; choose an image file.", path=path)
    drivers = drivers_for(path)
    if drivers:
        require_kind_of_name(path, _start(path))
        _require_own_side_cars(path)
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    try:
        gdal.ErrorReset()
        # Without OF_VERBOSE_ERROR GDAL gives no reason when no driver opens a file.
        kind = gdal.OF_RASTER | gdal.OF_READONLY | gdal.OF_VERBOSE_ERROR
        dataset = gdal.OpenEx(path, kind, drivers)
        # GDAL reads damaged keys only now, and may raise an error here as well.
        transform = None if dataset is None else dataset.GetGeoTransform(can_return_null=True)
    except RuntimeError as error:
        raise _unreadable(path, gdal_failure(error)) from None
    finally:
        gdal.PopErrorHandler()
    if dataset is None or dataset.RasterCount == 0:
        raise _unreadable(path, gdal_failure())
    if drivers and dataset.GetMetadataItem(*_OVERVIEW_FILE):
        raise ImageError(
            "{path} names another file for its overviews ({name}), which SemRef does not open; remove {path}.aux.xml, "
            "or build the overviews again.",
            path=path,
            name=dataset.GetMetadataItem(*_OVERVIEW_FILE),
        )
    if transform is not None and not all(abs(value) < _FARTHEST for value in transform):
        numbers = ", ".join(f"{value:g}" for value in transform)
        raise ImageError(
            "{path} has an impossible georeference ({numbers}). Georeference it again.", path=path, numbers=numbers
        )
    return dataset


def _unreadable(path: str, reason: str | Sentence) -> ImageError:
    if not drivers_for(path) or _driver_of(path):
        # GDAL often starts with the path.
        reason = reason.removeprefix(f"{path}: ") if isinstance(reason, str) else reason
        return ImageError("{path} can't be read: {reason}.", path=path, reason=reason)
    if not os.path.getsize(path):
        return ImageError("{path} is empty (0 bytes). Copy the file again.", path=path)
    return ImageError(
        "{path} is not an image that QGIS can read. Copy a damaged file again. Save photos in other formats, such as "
        "RAW or HEIC, as JPEG with their camera data.",
        path=path,
    )


def _start(path: str) -> bytes:
    try:
        with open(path, "rb") as file:
            return file.read(16)
    except OSError:
        # GDAL will report the reason.
        return b""


def transform_of(raster: gdal.Dataset) -> tuple[float, ...]:
    """Return GDAL's six numbers of the grid: of the pixels, with y up, without a georeference."""
    return raster.GetGeoTransform(can_return_null=True) or WITHOUT_GEOREFERENCE


def pixel_area(transform: tuple[float, ...]) -> float:
    """Return the area of a pixel, square map units; ``transform``: GDAL's six numbers."""
    return abs(transform[1] * transform[5] - transform[2] * transform[4])


def require_own_pixels(path: str) -> None:
    """Raise ImageError if GDAL would read other rasters for a file; call it before QGIS opens the file.

    Examples are a description of another raster with the name of a picture, and a raster with such an overview.
    """
    # QGIS itself reports a file that no driver opens.
    if drivers_for(path) and _driver_of(path):
        open_raster(path)


def _driver_of(path: str) -> str:
    """Return the short name of the driver that GDAL would choose for a raster; empty without one."""
    driver = None
    with gdal_failures():
        driver = gdal.IdentifyDriverEx(path, gdal.OF_RASTER)
    return "" if driver is None else driver.ShortName


def _require_own_side_cars(path: str) -> None:
    """Raise ImageError if GDAL would read other rasters because of a file beside a raster.

    Overviews and masks must be TIFF or Erdas files with their own pixels, and so must the files beside them.
    """
    for side_car in _side_cars(path):
        foreign = ImageError(
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
    """Return the files beside a raster with metadata, overviews or a mask for GDAL, in upper or lower case."""
    folder, name = os.path.split(os.path.abspath(path))
    wanted = [f"{name}{suffix}" for suffix in (".aux.xml", ".ovr", ".msk", ".aux")] + [f"{name.rpartition('.')[0]}.aux"]
    try:
        listed = _list_folder(folder, os.stat(folder).st_mtime_ns)
    except OSError:
        # Files in a folder that can't be listed may still be readable.
        return [side_car for one in wanted if os.path.exists(side_car := os.path.join(folder, one))]
    return [os.path.join(folder, one) for want in wanted for one in listed.get(want.lower(), ())]


@functools.lru_cache(maxsize=1)
def _list_folder(folder: str, changed_ns: int) -> dict[str, list[str]]:
    """Return the names in a folder by their lower-case form; ``changed_ns`` is only part of the cache key."""
    found: dict[str, list[str]] = {}
    for name in os.listdir(folder):
        found.setdefault(name.lower(), []).append(name)
    return found


def require_whole_raster(path: str, target: str) -> None:
    """Open a new raster and read its last pixels, which are missing if the disk was full.

    Args:
        target: Its final name, for the message.

    Raises:
        UnwritableError: The raster can't be read to its end.
    """
    dataset = None
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


def image_files(paths: list[str]) -> list[str]:
    """Replace each folder by its images that GDAL reads, sorted. Raises ImageError for a folder without images."""
    return core_images.image_files(paths, IMAGE_EXTENSIONS)
