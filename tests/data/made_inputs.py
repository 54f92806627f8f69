"""Small inputs with known truth: layers, label maps, class tables."""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterable, Sequence
from pathlib import Path

import cv2
import numpy as np
from made_labels import scattered_objects as scattered_objects
from osgeo import gdal, ogr, osr

METRIC_CRS = 32632
WEST, NORTH = 550000.0, 5220000.0
"""Upper left corner of the places below, EPSG:32632."""

NAMES = ["unlabeled", "building", "water", "bare_land", "field"]
CLASSES_CSV = (
    "value,name,color,role\n"
    "1,building,#d62728,reference\n"
    "2,water,#1f77b4,reference\n"
    "3,bare_land,#bcbd22,reference\n"
    "4,field,#2ca02c,background\n"
)

_FIELD_TYPES = {"text": ogr.OFTString, "integer": ogr.OFTInteger, "real": ogr.OFTReal}


def spatial_reference(crs) -> osr.SpatialReference | None:
    if crs is None:
        return None
    srs = osr.SpatialReference()
    if isinstance(crs, int):
        srs.ImportFromEPSG(crs)
    else:
        srs.ImportFromWkt(crs)
    srs.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return srs


def square(column: float, row: float, size: float) -> str:
    """Return the WKT of a square; ``column`` and ``row`` of its upper left corner count from WEST, NORTH, rows down."""
    return rectangle(column, row, size, size)


def rectangle(column: float, row: float, width: float, height: float) -> str:
    return polygon([(column, row), (column + width, row), (column + width, row + height), (column, row + height)])


def polygon(corners: Iterable[tuple[float, float]]) -> str:
    """Return the WKT of a polygon of (column, row) corners; the ring is closed here."""
    return f"POLYGON ({ring(corners)})"


def ring(corners: Iterable[tuple[float, float]]) -> str:
    corners = list(corners)
    return "(" + ", ".join(f"{WEST + x} {NORTH - y}" for x, y in [*corners, corners[0]]) + ")"


def write_layer(
    path: Path,
    features: Sequence[tuple],
    fields: Sequence[tuple[str, str]] = (("class", "text"),),
    crs=METRIC_CRS,
    geometry: int = ogr.wkbUnknown,
    options: Sequence[str] = (),
) -> Path:
    """Write a GeoPackage or shapefile (by suffix) of features: (WKT or None, value of each field or None)."""
    driver = {".gpkg": "GPKG", ".shp": "ESRI Shapefile"}[path.suffix]
    source = ogr.GetDriverByName(driver).CreateDataSource(str(path))
    layer = source.CreateLayer(path.stem, spatial_reference(crs), geometry, list(options))
    for name, kind in fields:
        layer.CreateField(ogr.FieldDefn(name, _FIELD_TYPES[kind]))
    for wkt, *values in features:
        feature = ogr.Feature(layer.GetLayerDefn())
        for index, value in enumerate(values):
            if value is not None:
                feature.SetField(index, value)
        if wkt is not None:
            feature.SetGeometry(ogr.CreateGeometryFromWkt(wkt))
        layer.CreateFeature(feature)
    return path


def write_raster(
    path: Path,
    pixels: np.ndarray,
    *,
    crs=METRIC_CRS,
    transform: tuple | None = (WEST, 1.0, 0.0, NORTH, 0.0, -1.0),
    kind: int = gdal.GDT_Byte,
    nodata: float | None = None,
    names: Sequence[str] = (),
    palette: dict[int, Sequence[int]] | None = None,
    options: Sequence[str] = (),
) -> Path:
    """Write a GeoTIFF or PNG (by suffix) of (H, W) or (bands, H, W) pixels; georeferenced by ``transform``.

    Args:
        palette: Red, green and blue of each value.
        options: Creation options of GDAL.
    """
    bands = pixels if pixels.ndim == 3 else pixels[None]
    memory = gdal.GetDriverByName("MEM").Create("", bands.shape[2], bands.shape[1], len(bands), kind)
    if transform is not None:
        memory.SetGeoTransform(transform)
        if crs is not None:
            memory.SetProjection(spatial_reference(crs).ExportToWkt())
    for number, band in enumerate(bands, start=1):
        memory.GetRasterBand(number).WriteArray(band)
    if nodata is not None:
        memory.GetRasterBand(1).SetNoDataValue(nodata)
    if names:
        memory.GetRasterBand(1).SetRasterCategoryNames(list(names))
    if palette:
        table = gdal.ColorTable()
        for value, color in palette.items():
            table.SetColorEntry(int(value), (*map(int, color), 255))
        memory.GetRasterBand(1).SetColorTable(table)
    driver = {".tif": "GTiff", ".png": "PNG"}[path.suffix]
    gdal.GetDriverByName(driver).CreateCopy(str(path), memory, options=list(options))
    return path


def read_pixels(path) -> np.ndarray:
    return gdal.Open(str(path)).ReadAsArray()


def read_rows(path, layer=0) -> list[dict]:
    """Return the values of each feature, with its ``geometry``, None where it is missing or empty."""
    source, rows = ogr.Open(str(path)), []
    for feature in source.GetLayer(layer):
        shape = feature.GetGeometryRef()
        rows.append({**feature.items(), "geometry": None if shape is None or shape.IsEmpty() else shape.Clone()})
    return rows


def write_photo(path: Path, size_wh=(32, 24), **tags: str) -> str:
    """Write a JPEG with these items of EXIF, and no side-car file as GDAL writes and cameras do not."""
    memory = gdal.GetDriverByName("MEM").Create("", *size_wh, 3)
    memory.SetMetadata({f"EXIF_{name}": value for name, value in tags.items()})
    gdal.GetDriverByName("JPEG").CreateCopy(str(path), memory)
    Path(f"{path}.aux.xml").unlink(missing_ok=True)
    return str(path)


def landmarks_in_the_west() -> np.ndarray:
    """Return (500, 800) uint8 labels with 260 landmarks, all of them before column 500."""
    labels = scattered_objects(500, 800, 260, seed=11)
    labels[:, 500:] = 4
    return labels


def write_text(path: Path, text: str, encoding: str = "utf-8") -> Path:
    path.write_bytes(text.encode(encoding))
    return path


def write_older(path: Path) -> bytes:
    """Write an older output of the kind of the name; return its bytes."""
    if path.suffix == ".gpkg":
        with contextlib.closing(sqlite3.connect(path)) as connection:
            connection.execute("PRAGMA page_size=512")
            connection.execute("PRAGMA user_version=7")
    else:
        path.write_bytes({".tif": b"II*\0", ".npz": b"PK\x03\x04", ".html": b"<", ".json": b"{"}[path.suffix] + b"old")
    return path.read_bytes()


def turned_view(
    labels: np.ndarray, size: int, column: float, row: float, heading: float, scale: float = 1.0
) -> np.ndarray:
    """Return (size, size) labels around a point of a map, top towards ``heading`` (° clockwise from north)."""
    angle = np.radians(heading)
    right, down = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    steps = (np.arange(size) + 0.5 - size / 2) * scale
    # OpenCV counts from the center of the first pixel.
    xs = column + steps[None, :] * right[0] + steps[:, None] * down[0] - 0.5
    ys = row + steps[None, :] * right[1] + steps[:, None] * down[1] - 0.5
    return cv2.remap(labels, xs.astype(np.float32), ys.astype(np.float32), cv2.INTER_NEAREST)
