"""Read photos and orthophotos as networks need them: red, green and blue with 8 bits each."""

from __future__ import annotations

import numpy as np
from osgeo import gdal

from ..core.errors import ImageError
from .gdal_errors import read_by_gdal
from .rasters import open_raster

WAVELENGTHS_UM = (0.665, 0.560, 0.490)
"""Center wavelengths of red, green and blue, for bands that state their wavelength."""

STRETCHED = 2, 98
"""Percentiles of a band with more than 8 bits that become 0 and 255: QGIS's default stretch."""

_SAMPLES, _SAMPLE_EDGE = 8, 128
"""Number of sampled squares per axis, and their edge in pixels, for the percentiles."""

Window = tuple[int, int, int, int]
"""(first column, first row, width, height) in pixels."""


class GdalImage:
    """An ImageSource in a file.

    Attributes:
        bands: Numbers of the bands for red, green and blue, counted from 1.
        stretch: (3, 2) lowest and highest value of each, which become 0 and 255; None for 8 bits.

    Raises:
        ImageError: The file can't be read.
    """

    def __init__(self, path: str, size_wh: tuple[int, int] | None = None) -> None:
        """Open the image; ``size_wh``: (width, height) to reduce it to by averaging; None for its own size."""
        self._path = path
        self._file = open_raster(path)
        self._colors = self._view = _in_colors(self._file)
        if size_wh is not None:
            width, height = size_wh
            self._view = gdal.Translate(
                "", self._colors, format="VRT", width=width, height=height, resampleAlg="average"
            )
        self.bands = color_bands(self._view)
        kinds = {self._view.GetRasterBand(number).DataType for number in self.bands}
        if any(gdal.DataTypeIsComplex(kind) for kind in kinds):
            raise ImageError("{path} has complex numbers. Choose a photo or an orthophoto.", path=path)
        self.stretch = None if kinds == {gdal.GDT_Byte} else self._percentiles()
        self._row = 0

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""
        return self._view.RasterYSize, self._view.RasterXSize

    @property
    def geotransform(self) -> tuple[float, ...] | None:
        """GDAL's six numbers; None without a georeference."""
        return self._view.GetGeoTransform(can_return_null=True)

    def read(self, column: int, row: int, width: int, height: int) -> tuple[np.ndarray, np.ndarray | None]:
        """Return (height, width, 3) uint8 pixels and (height, width) bool of valid data, see ImageSource."""
        if row != self._row:
            # Tiles are read row by row: earlier rows would only fill GDAL's cache.
            self._view.FlushCache()
            self._file.FlushCache()
            self._row = row
        window = column, row, width, height
        pixels = self._bytes(window) if self.stretch is None else self._read_stretched(window)
        has_data = self._has_data(window)
        if has_data is not None:
            pixels[~has_data] = 0
        return pixels, has_data

    def _has_data(self, window: Window) -> np.ndarray | None:
        """Return (height, width) bool of pixels with data in at least one band; None if all have data."""
        found = None
        for number in sorted(set(self.bands)):
            band = self._view.GetRasterBand(number)
            if band.GetMaskFlags() & gdal.GMF_ALL_VALID:
                return None
            mask = self._values(band.GetMaskBand(), window) > 0
            found = mask if found is None else found | mask
            if not band.GetMaskFlags() & gdal.GMF_NODATA:
                break
        return None if found.all() else found

    def _bytes(self, window: Window) -> np.ndarray:
        """Return (height, width, 3) uint8 pixels as stored, all bands in one call."""
        *_, width, height = window
        pixels = np.empty((height, width, 3), np.uint8)
        sizes, bands = (width, height, gdal.GDT_Byte), list(self.bands)
        spaces = 3, 3 * width, 1  # bytes from pixel to pixel, from line to line, from band to band
        read = self._view.ReadRaster
        read_by_gdal(self._path, read, *window, *sizes, bands, *spaces, buf_obj=pixels)
        return pixels

    def _read_stretched(self, window: Window) -> np.ndarray:
        """Return (height, width, 3) uint8 pixels, stretched between the limits of ``stretch``."""
        read = {number: self._values(self._view.GetRasterBand(number), window) for number in set(self.bands)}
        limited = zip(self.bands, self.stretch)
        return np.stack([_stretch(read[number], *limits) for number, limits in limited], axis=2)

    def _values(self, band: gdal.Band, window: Window) -> np.ndarray:
        return read_by_gdal(self._path, band.ReadAsArray, *window)

    def _percentiles(self) -> np.ndarray:
        height, width = self.shape_hw
        windows = [
            (column, row, min(_SAMPLE_EDGE, width), min(_SAMPLE_EDGE, height))
            for row in _spread(height)
            for column in _spread(width)
        ]
        limits = []
        for number in self.bands:
            band = self._view.GetRasterBand(number)
            found = []
            for window in windows:
                values = self._values(band, window)
                found.append(values[(self._values(band.GetMaskBand(), window) > 0) & np.isfinite(values)])
            values = np.concatenate(found)
            limits.append(np.percentile(values, STRETCHED) if values.size else (0.0, 1.0))
        return np.array(limits)


def _spread(length: int) -> list[int]:
    last = max(0, length - _SAMPLE_EDGE)
    return sorted({int(first) for first in np.linspace(0, last, _SAMPLES)})


def _stretch(values: np.ndarray, least: float, most: float) -> np.ndarray:
    scaled = (np.nan_to_num(values.astype(np.float32)) - least) * (255 / max(most - least, 1e-9))
    return np.clip(scaled + 0.5, 0, 255).astype(np.uint8)


def color_bands(dataset: gdal.Dataset) -> tuple[int, int, int]:
    """Return the numbers of the red, green and blue band, three times the first one for one or two bands.

    The color interpretation decides, then the stated wavelengths, then the order of the bands.
    """
    bands = [dataset.GetRasterBand(number) for number in range(1, dataset.RasterCount + 1)]
    meanings = [band.GetColorInterpretation() for band in bands]
    wanted = (gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand)
    if all(meaning in meanings for meaning in wanted):
        red, green, blue = (meanings.index(meaning) + 1 for meaning in wanted)
        return red, green, blue
    lengths = [_wavelength_um(band) for band in bands]
    if len(bands) >= 3 and None not in lengths:
        red, green, blue = (int(np.argmin(np.abs(np.array(lengths) - middle))) + 1 for middle in WAVELENGTHS_UM)
        if len({red, green, blue}) == 3:
            return red, green, blue
    return (1, 2, 3) if len(bands) >= 3 else (1, 1, 1)


def _wavelength_um(band: gdal.Band) -> float | None:
    """Return the wavelength in micrometers from ENVI's header or, from GDAL 3.10 on, the domain IMAGERY; or None."""
    text = band.GetMetadataItem("wavelength") or band.GetMetadataItem("CENTRAL_WAVELENGTH_UM", "IMAGERY") or ""
    try:
        length = float(text)
    except ValueError:
        return None
    is_nanometers = (band.GetMetadataItem("wavelength_units") or "").lower().startswith("nano")
    return length / 1000 if is_nanometers else length


def _in_colors(dataset: gdal.Dataset) -> gdal.Dataset:
    """Expand a paletted image to red, green and blue; return other images unchanged."""
    if dataset.GetRasterBand(1).GetRasterColorTable() is None or dataset.RasterCount > 1:
        return dataset
    return gdal.Translate("", dataset, format="VRT", rgbExpand="rgb")
