"""Differences between QGIS 3.22 and newer versions, in one place."""

from qgis.core import (
    Qgis,
    QgsCoordinateReferenceSystem,
    QgsFeatureRequest,
    QgsField,
    QgsGeometry,
    QgsMapSettings,
    QgsProcessing,
    QgsProcessingParameterNumber,
    QgsUnitTypes,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QVariant

try:
    from qgis.PyQt.QtCore import QMetaType
except ImportError:
    QMetaType = None

_FIELD_TYPES = {
    "text": ("QString", "String"),
    "integer": ("Int", "Int"),
    "long": ("LongLong", "LongLong"),
    "real": ("Double", "Double"),
    "boolean": ("Bool", "Bool"),
    "datetime": ("QDateTime", "DateTime"),
}


def make_field(name: str, kind: str) -> QgsField:
    """Return a field of a kind of _FIELD_TYPES; QGIS 3.38 replaced the types of QVariant by those of QMetaType."""
    meta_name, variant_name = _FIELD_TYPES[kind]
    if Qgis.QGIS_VERSION_INT >= 33800:
        return QgsField(name, getattr(QMetaType.Type, meta_name))
    return QgsField(name, getattr(QVariant, variant_name))


def is_null(value) -> bool:
    """Return whether an attribute is NULL: PyQGIS gives a QVariant NULL until 3.4x, later None."""
    return value is None or (isinstance(value, QVariant) and value.isNull())


def wkt_for_gdal(crs: QgsCoordinateReferenceSystem) -> str:
    variant = getattr(QgsCoordinateReferenceSystem, "WKT_PREFERRED_GDAL", None)
    if variant is None:
        variant = Qgis.CrsWktVariant.PreferredGdal
    return crs.toWkt(variant)


def is_metric(crs: QgsCoordinateReferenceSystem) -> bool:
    """Return whether the CRS is projected with meters as unit."""
    meters = Qgis.DistanceUnit.Meters if Qgis.QGIS_VERSION_INT >= 33000 else QgsUnitTypes.DistanceMeters
    return crs.isValid() and not crs.isGeographic() and crs.mapUnits() == meters


POLYGON = Qgis.WkbType.Polygon if Qgis.QGIS_VERSION_INT >= 33000 else QgsWkbTypes.Polygon
MULTI_POLYGON = Qgis.WkbType.MultiPolygon if Qgis.QGIS_VERSION_INT >= 33000 else QgsWkbTypes.MultiPolygon
POINT = Qgis.WkbType.Point if Qgis.QGIS_VERSION_INT >= 33000 else QgsWkbTypes.Point
POLYGON_GEOMETRY = Qgis.GeometryType.Polygon if Qgis.QGIS_VERSION_INT >= 33000 else QgsWkbTypes.PolygonGeometry
LINE = Qgis.WkbType.LineString if Qgis.QGIS_VERSION_INT >= 33000 else QgsWkbTypes.LineString
POINT_GEOMETRY = Qgis.GeometryType.Point if Qgis.QGIS_VERSION_INT >= 33000 else QgsWkbTypes.PointGeometry
LINE_GEOMETRY = Qgis.GeometryType.Line if Qgis.QGIS_VERSION_INT >= 33000 else QgsWkbTypes.LineGeometry
FLAT_CAP = Qgis.EndCapStyle.Flat if hasattr(Qgis, "EndCapStyle") else QgsGeometry.CapFlat
ROUND_JOIN = Qgis.JoinStyle.Round if hasattr(Qgis, "JoinStyle") else QgsGeometry.JoinStyleRound

if Qgis.QGIS_VERSION_INT >= 33600:
    SOURCE_POLYGON = Qgis.ProcessingSourceType.VectorPolygon
    SOURCE_POINT = Qgis.ProcessingSourceType.VectorPoint
    SOURCE_LINE = Qgis.ProcessingSourceType.VectorLine
    SOURCE_FILE = Qgis.ProcessingSourceType.File
    DOUBLE = Qgis.ProcessingNumberParameterType.Double
    INTEGER = Qgis.ProcessingNumberParameterType.Integer
else:
    SOURCE_POLYGON = QgsProcessing.TypeVectorPolygon
    SOURCE_POINT = QgsProcessing.TypeVectorPoint
    SOURCE_LINE = QgsProcessing.TypeVectorLine
    SOURCE_FILE = QgsProcessing.TypeFile
    DOUBLE = QgsProcessingParameterNumber.Double
    INTEGER = QgsProcessingParameterNumber.Integer

NO_GEOMETRY_CHECK = (
    Qgis.InvalidGeometryCheck.NoCheck if hasattr(Qgis, "InvalidGeometryCheck") else QgsFeatureRequest.GeometryNoCheck
)
"""Features with any geometry: otherwise QGIS ends at the first invalid one."""

MAP_TILE = Qgis.MapSettingsFlag.RenderMapTile if hasattr(Qgis, "MapSettingsFlag") else QgsMapSettings.RenderMapTile
"""Tiles that are drawn one by one fit together."""
