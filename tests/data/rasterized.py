"""Shared parts of the tests of semref:rasterizeannotation."""

from pathlib import Path

from osgeo import gdal
from qgis.core import QgsCategorizedSymbolRenderer, QgsFillSymbol, QgsRendererCategory, QgsVectorLayer
from qgis.PyQt.QtGui import QColor

RASTERIZE = "semref:rasterizeannotation"


def category_names(path):
    # A band does not keep its dataset alive, and GDAL 3.6 reads the .aux.xml only with the metadata.
    dataset = gdal.Open(str(path))
    dataset.GetMetadata()
    return dataset.GetRasterBand(1).GetRasterCategoryNames()


def stored_table(path):
    return gdal.Open(str(path)).GetMetadataItem("SEMREF_CLASS_TABLE")


def styled_layer(path: Path, categories) -> QgsVectorLayer:
    """Return a layer with a categorized style on ``class``: (value, label, color) each."""
    layer = QgsVectorLayer(str(path), path.stem, "ogr")
    found = []
    for value, label, color in categories:
        symbol = QgsFillSymbol.createSimple({})
        symbol.setColor(QColor(color))
        found.append(QgsRendererCategory(value, symbol, label))
    layer.setRenderer(QgsCategorizedSymbolRenderer("class", found))
    return layer
