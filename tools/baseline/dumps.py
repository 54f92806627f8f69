"""Files as plain values: layers, GeoPackages, rasters, reports, folders, arrays."""

from __future__ import annotations

import hashlib
import json
import re
import sqlite3
from contextlib import closing
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import canonicalize

import numpy as np
from osgeo import gdal, ogr

gdal.UseExceptions()
ogr.UseExceptions()

NUMBER = re.compile(r"[-−]?\d(?:[\d.,]*\d)?")
SKIPPED_TABLES = ("sqlite_", "rtree_", "gpkg_spatial_ref_sys")
"""Beginnings of names of tables that SQLite and GDAL keep for themselves."""


def digest(content: bytes) -> str:
    """Size and hash of bytes."""
    return f"{len(content)} bytes, sha256 {hashlib.sha256(content).hexdigest()}"


def style_digest(text: str) -> str:
    """Size and hash of a style of QGIS, which writes the attributes of an element in any order."""
    return digest(canonicalize(text).encode())


def layer_rows(path: str) -> list[dict[str, Any]]:
    """Features of a file's only layer in their order, fields by name and every coordinate."""
    dataset = ogr.Open(str(path))
    rows = []
    for feature in dataset.GetLayer(0):
        fields = {feature.GetFieldDefnRef(n).GetName(): feature.GetField(n) for n in range(feature.GetFieldCount())}
        shape = feature.GetGeometryRef()
        rows.append({**fields, "geometry": None if shape is None else [shape.GetGeometryName(), coordinates(shape)]})
    return rows


def coordinates(shape: ogr.Geometry) -> list[Any]:
    """Coordinates of a geometry: x, y, x, y, … of each of its parts."""
    if shape.GetGeometryCount():
        return [coordinates(shape.GetGeometryRef(n)) for n in range(shape.GetGeometryCount())]
    if shape.IsEmpty():
        return []
    return [number for point in shape.GetPoints() for number in point]


def fields_of(path: str) -> list[str]:
    """Layer name, geometry type, CRS and fields with their types, of a file's only layer."""
    dataset = ogr.Open(str(path))
    layer = dataset.GetLayer(0)
    columns = layer.GetLayerDefn()
    defined = [columns.GetFieldDefn(n) for n in range(columns.GetFieldCount())]
    crs = layer.GetSpatialRef()
    kind = ogr.GeometryTypeToName(layer.GetGeomType())
    return [
        kind,
        "no CRS" if crs is None else crs.ExportToWkt(),
        *(f"{column.GetName()} {column.GetTypeName()} {column.GetWidth()}" for column in defined),
    ]


def geopackage_tables(path: str) -> dict[str, Any]:
    """Rows of every table, `parameters` by key with their JSON read, and the SQL that made the tables."""
    with closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as connection:
        schema = connection.execute("SELECT type, name, sql FROM sqlite_master ORDER BY type, name").fetchall()
        schema = [row for row in schema if not row[1].startswith(SKIPPED_TABLES)]
        tables = {name: _table(connection, name) for kind, name, _ in schema if kind == "table"}
    tables["schema"] = {f"{kind} {name}": sql for kind, name, sql in schema}
    if "parameters" in tables:
        tables["parameters"] = {row["key"]: json.loads(row["value"]) for row in tables["parameters"]}
    return tables


def _table(connection: sqlite3.Connection, name: str) -> list[dict[str, Any]]:
    found = connection.execute(f'SELECT * FROM "{name}" ORDER BY rowid')
    columns = [column[0] for column in found.description]
    return [{column: _cell(column, value) for column, value in zip(columns, row)} for row in found]


def _cell(column: str, value: Any) -> Any:
    if column == "styleQML":
        return style_digest(value)
    if isinstance(value, bytes):
        return np.frombuffer(value, "<f4").tolist() if column == "vector" else digest(value)
    return digest(value.encode()) if isinstance(value, str) and len(value) > 2_000 else value


def raster(path: str) -> tuple[dict[str, Any], np.ndarray]:
    """(grid, bands, classes, metadata; pixels) of a raster and of the style beside it."""
    dataset = gdal.Open(str(path))
    bands = [dataset.GetRasterBand(n + 1) for n in range(dataset.RasterCount)]
    colors = bands[0].GetRasterColorTable()
    style = Path(path).with_suffix(".qml")
    about = {
        "size": [dataset.RasterXSize, dataset.RasterYSize],
        "geotransform": dataset.GetGeoTransform(can_return_null=True),
        "crs": dataset.GetProjection(),
        "metadata": dataset.GetMetadata(),
        "structure": dataset.GetMetadata("IMAGE_STRUCTURE"),
        "bands": [[gdal.GetDataTypeName(band.DataType), band.GetNoDataValue(), *band.GetBlockSize()] for band in bands],
        "categories": bands[0].GetCategoryNames(),
        "colors": colors and [list(colors.GetColorEntry(n)) for n in range(colors.GetCount())],
        "style": style_digest(style.read_text(encoding="utf-8")) if style.exists() else None,
    }
    return about, dataset.ReadAsArray()


def onboard_file(path: str) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """(header and whether the content hash is right, the other members) of an onboard file."""
    import zipfile

    with zipfile.ZipFile(path) as file:
        hashed = hashlib.sha256()
        for name in sorted(file.namelist()):
            if name != "content_hash.npy":
                hashed.update(file.read(name))
    with np.load(path) as content:
        members = {name: content[name] for name in content.files}
    header = json.loads(members.pop("header").tobytes().decode())
    right = hashed.digest() == members.pop("content_hash").tobytes()
    return {**header, "content hash is right": right, "members": sorted(members)}, members


def report_numbers(path: str) -> list[str]:
    """All numbers of an HTML page in their order, without those of its markup."""
    reader = _TextOfPage()
    reader.feed(Path(path).read_text(encoding="utf-8"))
    return [number for text in reader.texts for number in NUMBER.findall(text)]


class _TextOfPage(HTMLParser):
    """Collects what a page shows."""

    def __init__(self) -> None:
        super().__init__()
        self.texts: list[str] = []
        self._hidden = 0

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        self._hidden += tag in ("style", "script")

    def handle_endtag(self, tag: str) -> None:
        self._hidden -= tag in ("style", "script")

    def handle_data(self, data: str) -> None:
        if not self._hidden:
            self.texts.append(data)


def folder_files(folder: str) -> dict[str, str]:
    """Size and hash of every file below a folder, by its path there."""
    root = Path(folder)
    files = sorted(path for path in root.rglob("*") if path.is_file())
    return {path.relative_to(root).as_posix(): digest(path.read_bytes()) for path in files}
