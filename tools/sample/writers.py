"""Files of the sample: shapefile, class table, pictures, truth. The only module here that needs GDAL."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import cv2
import numpy as np
from osgeo import gdal, ogr, osr

from . import photo, pictures
from .classes import CLASSES
from .landscape import Landscape

LAYER = "landcover"
JPEG_QUALITY = 85
BURNED_FIELD = "class_id"
DBF_DATE = "2025-05-09"  # a fixed day: the format stores one, and the same seed is to give the same file


class SampleError(Exception):
    """The sample could not be made; the text says why and what to do."""


def fill_layer(dataset, landscape: Landscape, features) -> ogr.Layer:
    """Create the annotation layer in an OGR dataset and write features to it in their order."""
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(landscape.epsg)
    layer = dataset.CreateLayer(LAYER, reference, ogr.wkbPolygon, options=_layer_options(dataset))
    if layer is None:
        raise SampleError(f"The layer {LAYER} could not be created: {gdal.GetLastErrorMsg()}")
    text = ogr.FieldDefn("class", ogr.OFTString)
    text.SetWidth(20)
    for field in (text, _integer(BURNED_FIELD), _integer("zorder")):
        layer.CreateField(field)
    names = {entry.value: entry.name for entry in CLASSES}
    for drawn in features:
        feature = ogr.Feature(layer.GetLayerDefn())
        feature.SetField("class", names[drawn.class_value])
        feature.SetField(BURNED_FIELD, drawn.class_value)
        feature.SetField("zorder", drawn.zorder)
        if drawn.geometry is not None:
            feature.SetGeometryDirectly(ogr.CreateGeometryFromWkb(drawn.geometry.wkb))
        if layer.CreateFeature(feature) != 0:
            raise SampleError(f"A feature could not be written, is the disk full? {gdal.GetLastErrorMsg()}")
    return layer


def _layer_options(dataset) -> list[str]:
    if dataset.GetDriver().GetName() != "ESRI Shapefile":
        return []
    return ["ENCODING=UTF-8", f"DBF_DATE_LAST_UPDATE={DBF_DATE}"]


def _integer(name: str) -> ogr.FieldDefn:
    field = ogr.FieldDefn(name, ogr.OFTInteger)
    field.SetWidth(4)
    return field


def write_shapefile(landscape: Landscape, folder: Path) -> Path:
    """landcover.shp with .prj, .dbf and .cpg."""
    path = folder / f"{LAYER}.shp"
    dataset = ogr.GetDriverByName("ESRI Shapefile").CreateDataSource(str(path))
    if dataset is None:
        raise SampleError(f"The shapefile {path} could not be created: {gdal.GetLastErrorMsg()}")
    fill_layer(dataset, landscape, landscape.features)
    dataset = None  # closes the file
    return path


def write_classes(path: Path) -> None:
    """The class table as semref reads it."""
    with path.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["value", "name", "color", "role", "hsv_min", "hsv_max"])
        for c in CLASSES:
            rows.writerow([c.value, c.name, c.color, c.role, _spaced(c.hsv_min), _spaced(c.hsv_max)])


def _spaced(numbers) -> str:
    return " ".join(str(n) for n in numbers)


def grid_of(landscape: Landscape, pixel_size: float) -> tuple[float, float, int, int]:
    """West, north, width and height in pixels of the map, on multiples of the pixel size (gdal_rasterize -tap)."""
    x0, y0, x1, y1 = (v / pixel_size for v in landscape.extent)
    west, south, east, north = math.floor(x0 + 1e-6), math.floor(y0 + 1e-6), math.ceil(x1 - 1e-6), math.ceil(y1 - 1e-6)
    return west * pixel_size, north * pixel_size, east - west, north - south


def rasterize(landscape: Landscape, pixel_size: float) -> np.ndarray:
    """Label map (h, w) uint8 of the landscape, higher zorder on top, 0 where nothing is drawn."""
    west, north, width, height = grid_of(landscape, pixel_size)
    drawn = sorted((f for f in landscape.features if f.geometry is not None), key=lambda f: f.zorder)
    memory = _memory_dataset()
    layer = fill_layer(memory, landscape, drawn)
    target = gdal.GetDriverByName("MEM").Create("", width, height, 1, gdal.GDT_Byte)
    target.SetGeoTransform((west, pixel_size, 0, north, 0, -pixel_size))
    if gdal.RasterizeLayer(target, [1], layer, options=[f"ATTRIBUTE={BURNED_FIELD}"]) != 0:
        raise SampleError(f"The landscape could not be rasterised: {gdal.GetLastErrorMsg()}")
    return np.frombuffer(target.ReadRaster(), np.uint8).reshape(height, width)


def _memory_dataset():
    """A place for layers in memory: from GDAL 3.11 the driver MEM holds them too and "Memory" is on its way out."""
    driver = gdal.GetDriverByName("MEM")
    if driver.GetMetadataItem("DCAP_VECTOR") == "YES":
        return driver.Create("", 0, 0, 0, gdal.GDT_Unknown)
    return ogr.GetDriverByName("Memory").CreateDataSource("")


def write_pictures(labels_hw: np.ndarray, views, folder: Path) -> None:
    """One PNG a view, without georeference: class values, or RGB in the class colours."""
    for view in views:
        picture = pictures.cut(labels_hw, view)
        if view.in_color:
            picture = pictures.colored(picture)[:, :, ::-1]  # OpenCV writes BGR
        if not cv2.imwrite(str(folder / view.name), picture, [cv2.IMWRITE_PNG_COMPRESSION, 7]):
            raise SampleError(f"The picture {folder / view.name} could not be written, is the disk full?")


def write_orthophoto(landscape: Landscape, pixel_size: float, photo_hw3: np.ndarray, path: Path) -> None:
    """The whole photo as a georeferenced GeoTIFF, compressed as JPEG."""
    west, north, width, height = grid_of(landscape, pixel_size)
    options = ["COMPRESS=JPEG", "PHOTOMETRIC=YCBCR", f"JPEG_QUALITY={JPEG_QUALITY}", "TILED=YES"]
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), width, height, 3, gdal.GDT_Byte, options)
    if dataset is None:
        raise SampleError(f"The orthophoto {path} could not be created: {gdal.GetLastErrorMsg()}")
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(landscape.epsg)
    dataset.SetProjection(reference.ExportToWkt())
    dataset.SetGeoTransform((west, pixel_size, 0, north, 0, -pixel_size))
    rows = np.ascontiguousarray(np.moveaxis(photo_hw3, 2, 0))
    if dataset.WriteRaster(0, 0, width, height, rows.tobytes(), band_list=[1, 2, 3]) != 0:
        raise SampleError(f"The orthophoto {path} could not be written, is the disk full? {gdal.GetLastErrorMsg()}")


def write_photos(photo_hw3: np.ndarray, views, seed: int, folder: Path) -> None:
    """One JPEG a view, without georeference, as a camera would have taken it."""
    for view in views:
        taken = photo.shoot(photo_hw3, view, seed)
        if not cv2.imwrite(str(folder / view.name), taken[:, :, ::-1], [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY]):
            raise SampleError(f"The photo {folder / view.name} could not be written, is the disk full?")


def write_truth(landscape: Landscape, pixel_size: float, views, path: Path) -> None:
    """Where every picture was cut: its centre in map pixels and map units, heading, and scale.

    `rotation_deg` is the heading of the image's top, clockwise from grid north; `scale` is map pixels per image pixel.
    """
    west, north, _, _ = grid_of(landscape, pixel_size)
    with path.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["image", "kind", "column", "row", "x", "y", "rotation_deg", "scale", "window"])
        for v in views:
            x, y = west + v.column * pixel_size, north - v.row * pixel_size
            rows.writerow([v.name, v.kind, v.column, v.row, round(x, 4), round(y, 4), v.heading_deg, v.scale, v.window])
