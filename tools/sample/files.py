"""Files of the sample area: shapefile, class table, orthophoto, photos, truth."""

import csv
import json
from collections.abc import Iterable
from datetime import datetime, timedelta, timezone
from pathlib import Path

import cv2
import numpy as np
from osgeo import gdal, ogr, osr

from semref.core.annotation.polygons import to_wkb
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_table import ClassTable
from semref.storage.gdal_errors import close, require_written
from semref.storage.rasterize import BurnLayer, BurnPolygon
from semref.storage.text_tables import CLASSES_FILE

from . import photo, pictures
from .classes import CLASSES
from .landscape import Landscape

ANNOTATION_FILE, ORTHOPHOTO_FILE = "landcover.shp", "orthophoto.tif"
PHOTOS_FOLDER, PHOTOS_TRUTH_FILE = "photos", "photos.csv"
FLIGHT_FOLDER, FLIGHT_FILE = "flight", "flight.csv"
FLIGHT_START, SECONDS_BETWEEN = datetime(2025, 5, 9, 10, tzinfo=timezone.utc), 12
"""When the first photo of the flight was taken, and how long after it the next one: at some 15 m/s."""

JPEG_QUALITY = 85
MARKER = "sample.json"
"""Distinguishes a folder of ours from somebody's data."""

_FIELDS = (("class", ogr.OFTString, 20), ("class_id", ogr.OFTInteger, 4), ("zorder", ogr.OFTInteger, 4))
_SHAPEFILE_OPTIONS = ["ENCODING=UTF-8", "DBF_DATE_LAST_UPDATE=2025-05-09"]
"""With a fixed day: the format stores one, and the same seed is to give the same file."""


def write_sample(folder: Path, landscape: Landscape) -> None:
    """Write all files of the sample into an existing folder."""
    write_shapefile(landscape, folder)
    write_classes(folder / CLASSES_FILE)
    photo_hw3 = photo.render(landscape)
    write_orthophoto(landscape, photo_hw3, folder / ORTHOPHOTO_FILE)
    views = pictures.plan_photos(photo_hw3.shape[:2], landscape.seed)
    flight = pictures.plan_flight(photo_hw3.shape[:2])
    for name, taken in ((PHOTOS_FOLDER, views), (FLIGHT_FOLDER, flight)):
        (folder / name).mkdir()
        for view in taken:
            shown_hw3 = photo.shoot(photo_hw3, view, landscape.seed)
            cv2.imwrite(str(folder / name / view.name), shown_hw3[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
    write_truth(landscape, views, folder / PHOTOS_TRUTH_FILE)
    write_truth(landscape, flight, folder / FLIGHT_FILE, timed=True)
    about = {"made_by": "semref", "seed": landscape.seed, "pixel_size": 1.0, "photos": len(views)}
    (folder / MARKER).write_text(json.dumps(about, indent=2) + "\n", encoding="utf-8")


def write_shapefile(landscape: Landscape, folder: Path) -> None:
    """landcover.shp with .shx, .prj, .dbf and .cpg."""
    path = str(folder / ANNOTATION_FILE)
    with require_written(path):
        dataset = ogr.GetDriverByName("ESRI Shapefile").CreateDataSource(path)
        if dataset is not None:
            _fill(dataset, landscape)
        close(dataset)
        del dataset


def _fill(dataset: ogr.DataSource, landscape: Landscape) -> None:
    layer = dataset.CreateLayer("landcover", _crs(landscape), ogr.wkbPolygon, _SHAPEFILE_OPTIONS)
    for name, kind, width in _FIELDS:
        field = ogr.FieldDefn(name, kind)
        field.SetWidth(width)
        layer.CreateField(field)
    names = {entry.value: entry.name for entry in CLASSES}
    for drawn in landscape.features:
        feature = ogr.Feature(layer.GetLayerDefn())
        for number, value in enumerate((names[drawn.class_value], drawn.class_value, drawn.zorder)):
            feature.SetField(number, value)
        if drawn.geometry is not None:
            feature.SetGeometryDirectly(ogr.CreateGeometryFromWkb(to_wkb(drawn.geometry)))
        layer.CreateFeature(feature)


def _crs(landscape: Landscape) -> osr.SpatialReference:
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(landscape.epsg)
    return reference


def write_classes(path: Path) -> None:
    """The class table as semref reads it."""
    path.write_text(ClassTable(CLASSES).to_csv(), encoding="utf-8")


def rasterize(landscape: Landscape) -> np.ndarray:
    """Label map (h, w) uint8 of the landscape, higher zorder on top, 0 where nothing is drawn."""
    west, north, width, height = landscape.frame
    drawn = [f for f in landscape.features if f.geometry is not None]
    polygons = [BurnPolygon(to_wkb(f.geometry), f.class_value, f.zorder, f.geometry.bounds) for f in drawn]
    frame = MapFrame.at((west, north), 1.0, (height, width))
    return BurnLayer(polygons, "").rasterize(frame, gdal.GDT_Byte)


def write_orthophoto(landscape: Landscape, photo_hw3: np.ndarray, path: Path) -> None:
    """The whole photo as a georeferenced GeoTIFF, compressed as JPEG."""
    west, north, width, height = landscape.frame
    options = ["COMPRESS=JPEG", "PHOTOMETRIC=YCBCR", f"JPEG_QUALITY={JPEG_QUALITY}", "TILED=YES"]
    rows = np.ascontiguousarray(np.moveaxis(photo_hw3, 2, 0))
    with require_written(path):
        dataset = gdal.GetDriverByName("GTiff").Create(str(path), width, height, 3, gdal.GDT_Byte, options)
        if dataset is not None:
            dataset.SetProjection(_crs(landscape).ExportToWkt())
            dataset.SetGeoTransform((west, 1, 0, north, 0, -1))
            dataset.WriteRaster(0, 0, width, height, rows.tobytes(), band_list=[1, 2, 3])
        close(dataset)
        del dataset


def write_truth(landscape: Landscape, views: Iterable[pictures.Picture], path: Path, timed: bool = False) -> None:
    """Where every picture was cut: its center in map pixels and map units, heading, and scale.

    ``rotation_deg`` is the heading of the image's top, clockwise from grid north; ``scale`` is map pixels per image
    pixel. ``timed``: with the time of each, as a camera table has it.
    """
    west, north, _, _ = landscape.frame
    with path.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        header = ["image", "column", "row", "x", "y", "rotation_deg", "scale"]
        rows.writerow([*header, "time"] if timed else header)
        for number, v in enumerate(views):
            when = [(FLIGHT_START + timedelta(seconds=number * SECONDS_BETWEEN)).isoformat()] if timed else []
            place = round(west + v.column, 4), round(north - v.row, 4)
            rows.writerow([v.name, v.column, v.row, *place, v.heading_deg, v.scale, *when])
