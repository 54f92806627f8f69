"""Annotation files read by GDAL alone, where that gives the very polygons that QGIS takes; other files are refused."""

from __future__ import annotations

import contextlib
import math
import sqlite3
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from osgeo import gdal, ogr

from ..core.annotation.classes import ClassLookup, distinct, lookup_of, raw_text, require_known_classes
from ..core.errors import AnnotationError
from ..core.labels.class_table import ClassTable
from ..core.sentences import Sentence
from .burning import BurnPolygon
from .crs_text import crs_wkt
from .database.schema import square_wkb
from .gdal_errors import gdal_failures
from .pixel_grid import union_of_bounds

_NUMBERS = (ogr.OFTInteger, ogr.OFTInteger64, ogr.OFTReal)
_POLYGONS = (ogr.wkbPolygon, ogr.wkbMultiPolygon)


@dataclass(frozen=True)
class Annotation:
    """What an annotation file gives.

    Attributes:
        polygons: To be burnt, of all features that have area and class, in their order.
        table: Of their classes.
        crs: WKT.
        skipped: Features without geometry, area or class.
    """

    polygons: list[BurnPolygon]
    table: ClassTable
    crs: str
    skipped: int


def read_annotation(
    path: str, class_field: str, priority_field: str = "", table: ClassTable | None = None, layer: str = ""
) -> Annotation:
    """Reads the polygons of a file as ``semref:rasterizeannotation`` does.

    Args:
        path: Of a file that GDAL reads.
        class_field: Text or number that tells the class.
        priority_field: Number: the higher lies on top; without it the draw order of classes decides.
        table: Of the classes; without it they are what the class field holds.
        layer: Of a file of several.

    Raises:
        AnnotationError: It can't be read, or QGIS would read it otherwise.
    """
    # It may raise or return None, as the user has set it.
    dataset, found = None, None
    with gdal_failures() as failures:
        dataset = gdal.OpenEx(path, gdal.OF_VECTOR | gdal.OF_READONLY)
        if dataset is not None:
            found = _read(path, dataset, (class_field, priority_field, layer), table)
    if found is None or failures:
        reason = failures[0].rstrip(".") if failures else Sentence("storage.unknown_reason")
        raise AnnotationError("storage.annotation_unreadable", path=path, reason=reason)
    return found


def filled_beneath(polygons: list[BurnPolygon], table: ClassTable) -> list[BurnPolygon]:
    """The same above the class that lies wherever no polygon does, if the table has one.

    Args:
        polygons: One at least.
        table: Of their classes.
    """
    if table.filling is None:
        return polygons
    reach = union_of_bounds([polygon.bounds for polygon in polygons])
    return [BurnPolygon(square_wkb(*reach), table.filling.value, -math.inf, reach), *polygons]


def _read(path: str, dataset: gdal.Dataset, names: tuple[str, str, str], table: ClassTable | None) -> Annotation:
    class_field, priority_field, name = names
    layer = _layer(path, dataset, name)
    crs = _metric_crs(path, layer)
    class_index = _field(path, layer, class_field, (*_NUMBERS, ogr.OFTString))
    priority_index = _field(path, layer, priority_field, _NUMBERS) if priority_field else -1
    lookup = ClassLookup(table) if table is not None else _classes(path, layer, class_index)
    polygons: list[BurnPolygon] = []
    unknown: Counter[str] = Counter()
    skipped = 0
    layer.ResetReading()
    for feature in layer:
        geometry = feature.GetGeometryRef()
        raw = _value(feature, class_index)
        if geometry is None or geometry.IsEmpty() or raw is None or not raw_text(raw):
            skipped += 1
            continue
        value = lookup.value(raw)
        if value is None:
            unknown[raw_text(raw)] += 1
            continue
        priority = lookup.draw_orders.get(value, 0.0)
        if priority_index >= 0:
            given = _value(feature, priority_index)
            priority = -math.inf if given is None else float(given)
        parts = list(_parts(path, feature.GetFID(), geometry))
        skipped += not parts
        polygons += [BurnPolygon(wkb, value, priority, bounds) for wkb, bounds in parts]
    require_known_classes(unknown, layer.GetName(), lookup.table)
    if not polygons:
        raise AnnotationError("storage.nothing_to_rasterize", source=layer.GetName())
    return Annotation(polygons, lookup.table, crs, skipped)


def _layer(path: str, dataset: gdal.Dataset, name: str) -> ogr.Layer:
    layers = [dataset.GetLayer(number) for number in range(dataset.GetLayerCount())]
    # QGIS's styles are a table beside the layers.
    layers = [layer for layer in layers if layer.GetName() != "layer_styles"]
    chosen = [layer for layer in layers if layer.GetName() == name] if name else layers
    if len(chosen) != 1:
        raise AnnotationError("storage.annotation_layers", path=path, layers=[layer.GetName() for layer in layers])
    return chosen[0]


def _metric_crs(path: str, layer: ogr.Layer) -> str:
    srs = layer.GetSpatialRef()
    if srs is None:
        raise AnnotationError("storage.no_crs", path=path)
    if not srs.IsProjected() or abs(srs.GetLinearUnits() - 1) > 1e-9:
        raise _only_in_qgis(path, Sentence("storage.other_crs", crs=srs.GetName() or ""))
    return crs_wkt(srs)


def _field(path: str, layer: ogr.Layer, name: str, kinds: tuple[int, ...]) -> int:
    definition = layer.GetLayerDefn()
    index = definition.GetFieldIndex(name)
    if index < 0:
        names = [definition.GetFieldDefn(number).GetName() for number in range(definition.GetFieldCount())]
        raise AnnotationError("storage.annotation_fields", path=path, name=name, names=names)
    field = definition.GetFieldDefn(index)
    if field.GetType() not in kinds or field.GetSubType() != ogr.OFSTNone:
        raise AnnotationError("storage.annotation_field_kind", path=path, name=name)
    return index


def _classes(path: str, layer: ogr.Layer, index: int) -> ClassLookup:
    """Of what the class field holds."""
    if _may_be_styled(path, layer.GetName()):
        raise _only_in_qgis(path, Sentence("storage.own_style"))
    raws = (_value(feature, index) for feature in layer)
    found = distinct(raw for raw in raws if raw is not None)
    if not found:
        raise AnnotationError("labels.no_class_filled", source=layer.GetName())
    kind = layer.GetLayerDefn().GetFieldDefn(index).GetType()
    return lookup_of([((raw,), str(raw), "") for raw in found], kind in _NUMBERS)


def _may_be_styled(path: str, layer: str) -> bool:
    """Whether QGIS finds a style of the layer, beside the file or in it."""
    if Path(path).with_suffix(".qml").exists() or Path(path).with_suffix(".sld").exists():
        return True
    if not path.lower().endswith(".gpkg") or not Path(path).is_file():
        return False
    query = "SELECT count(*) FROM layer_styles WHERE f_table_name = ?"
    with contextlib.suppress(sqlite3.Error), contextlib.closing(sqlite3.connect(path)) as connection:
        return connection.execute(query, (layer,)).fetchone()[0] > 0
    return False


def _value(feature: ogr.Feature, index: int) -> object:
    return feature.GetField(index) if feature.IsFieldSetAndNotNull(index) else None


def _parts(path: str, fid: int, geometry: ogr.Geometry) -> Iterator[tuple[bytes, tuple[float, float, float, float]]]:
    """Single polygons with area; raises AnnotationError for what QGIS would mend."""
    kind = ogr.GT_Flatten(geometry.GetGeometryType())
    if kind not in _POLYGONS:
        raise _only_in_qgis(path, Sentence("storage.other_geometry", kind=geometry.GetGeometryName()))
    several = kind == ogr.wkbMultiPolygon
    for part in [geometry.GetGeometryRef(n) for n in range(geometry.GetGeometryCount())] if several else [geometry]:
        # GEOS says why one is invalid, by GDAL's errors: that is no failure of reading.
        with gdal_failures():
            is_valid = part.IsValid()
        if not is_valid:
            raise _only_in_qgis(path, Sentence("storage.invalid_polygons", fid=fid))
        if part.GetArea() > 0:
            x_min, x_max, y_min, y_max = part.GetEnvelope()
            yield bytes(part.ExportToIsoWkb()), (x_min, y_min, x_max, y_max)


def _only_in_qgis(path: str, what: Sentence) -> AnnotationError:
    return AnnotationError("storage.annotation_in_qgis", path=path, what=what)
