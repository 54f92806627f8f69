"""The demo's QGIS project and its map picture: the hit of one query image, highlighted."""

from __future__ import annotations

from pathlib import Path

from osgeo import gdal
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsFillSymbol,
    QgsGeometry,
    QgsLayoutExporter,
    QgsLayoutItemLabel,
    QgsLayoutItemLegend,
    QgsLayoutItemMap,
    QgsLayoutItemPicture,
    QgsLayoutItemScaleBar,
    QgsLayoutPoint,
    QgsLayoutSize,
    QgsLegendStyle,
    QgsMarkerSymbol,
    QgsPointXY,
    QgsPrintLayout,
    QgsProject,
    QgsRasterLayer,
    QgsReferencedRectangle,
    QgsSingleSymbolRenderer,
    QgsUnitTypes,
    QgsVectorLayer,
)
from qgis.PyQt.QtGui import QColor, QFont

HIT_COLOR = "#ffb000"
MILLIMETERS = QgsUnitTypes.LayoutMillimeters
PAGE_MM = (297, 210)


def write_project_and_picture(folder: Path, paths: dict[str, str], fix: dict, image: Path) -> None:
    """Writes semref_demo.qgz and map.png into ``folder``; ``fix`` is the highlighted row of the positions layer."""
    project = QgsProject.instance()
    project.clear()
    project.setTitle("SemRef demo")
    # Bottom first; the project opens with the hit on top.
    labels = QgsRasterLayer(paths["labels"], "Label map")
    references = QgsVectorLayer(f"{paths['database']}|layername=references", "Landmarks")
    windows = QgsVectorLayer(f"{paths['database']}|layername=windows", "Windows")
    positions = _positions_layer(paths["positions"])
    hit = _hit_layer(paths["footprints"], image.name)
    center = _center_layer(labels.crs(), fix, image.name)
    for layer in (labels, windows, references, positions, hit, center):
        if not layer.isValid():
            raise RuntimeError(f"{layer.name()} ({layer.source()}) could not be opened")
        project.addMapLayer(layer)
    project.setCrs(labels.crs())
    root = project.layerTreeRoot()
    for hidden in (windows, positions):
        root.findLayer(hidden.id()).setItemVisibilityChecked(False)
    project.viewSettings().setDefaultViewExtent(QgsReferencedRectangle(labels.extent(), labels.crs()))
    layout = _layout(project, labels, fix, image)
    project.layoutManager().addLayout(layout)
    picture = str(folder / "map.png")
    settings = QgsLayoutExporter.ImageExportSettings()
    settings.dpi = 150
    # QGIS also tries to write the georeference into the PNG, which GDAL can't and says.
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    exported = QgsLayoutExporter(layout).exportToImage(picture, settings)
    gdal.PopErrorHandler()
    if exported != QgsLayoutExporter.Success:
        raise RuntimeError(f"{picture} could not be written")
    if not project.write(str(folder / "semref_demo.qgz")):
        raise RuntimeError(f"the project could not be written: {project.error()}")


def _positions_layer(path: str) -> QgsVectorLayer:
    layer = QgsVectorLayer(path, "Positions of all pictures")
    symbol = QgsMarkerSymbol.createSimple(
        {"name": "diamond", "color": "#ffffff", "outline_color": "#000000", "size": "2.5"}
    )
    layer.setRenderer(QgsSingleSymbolRenderer(symbol))
    return layer


def _hit_layer(path: str, image: str) -> QgsVectorLayer:
    layer = QgsVectorLayer(path, "Hit: ground the picture shows")
    layer.setSubsetString(f"image LIKE '%/{image}'")
    symbol = QgsFillSymbol.createSimple(
        {"color": "255,176,0,50", "outline_color": HIT_COLOR, "outline_width": "1.2", "style": "solid"}
    )
    layer.setRenderer(QgsSingleSymbolRenderer(symbol))
    return layer


def _center_layer(crs: QgsCoordinateReferenceSystem, fix: dict, image: str) -> QgsVectorLayer:
    layer = QgsVectorLayer(f"Point?crs={crs.authid()}&field=image:string", "Hit: position", "memory")
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(fix["x"], fix["y"])))
    feature.setAttributes([image])
    layer.dataProvider().addFeature(feature)
    layer.updateExtents()
    symbol = QgsMarkerSymbol.createSimple(
        {"name": "cross_fill", "color": HIT_COLOR, "outline_color": "#000000", "size": "6"}
    )
    layer.setRenderer(QgsSingleSymbolRenderer(symbol))
    return layer


def _layout(project: QgsProject, labels: QgsRasterLayer, fix: dict, image: Path) -> QgsPrintLayout:
    layout = QgsPrintLayout(project)
    layout.initializeDefaults()
    layout.setName("Hit")
    page_map = QgsLayoutItemMap(layout)
    layout.addLayoutItem(page_map)
    _place(page_map, 8, 20, 196, 147)
    page_map.setCrs(labels.crs())
    page_map.setLayers([node.layer() for node in project.layerTreeRoot().findLayers() if node.isVisible()])
    page_map.setKeepLayerSet(True)
    page_map.setExtent(labels.extent())
    page_map.setFrameEnabled(True)
    _label(layout, "SemRef: where was this picture taken?", 8, 6, 280, 10, 18, bold=True)
    _label(layout, "Query picture (labels)", 212, 20, 78, 6, 10, bold=True)
    picture = QgsLayoutItemPicture(layout)
    picture.setPicturePath(str(_colored(image, labels)))
    layout.addLayoutItem(picture)
    _place(picture, 212, 27, 70, 70)
    picture.setFrameEnabled(True)
    text = (
        f"{image.name}\nx {fix['x']:.1f}   y {fix['y']:.1f}   (± {fix['error_95']:.2f} m)\n"
        f"longitude {fix['longitude']:.6f}°   latitude {fix['latitude']:.6f}°\n"
        f"heading {fix['heading']:.1f}°   pixel size {fix['pixel_size']:.2f} m\n"
        f"{fix['inliers']} of {fix['references']} landmarks agree, confidence {fix['confidence']:.2f}"
    )
    _label(layout, text, 212, 100, 80, 28, 9)
    _legend(layout, project, page_map)
    scale_bar = QgsLayoutItemScaleBar(layout)
    layout.addLayoutItem(scale_bar)
    scale_bar.setLinkedMap(page_map)
    scale_bar.setStyle("Single Box")
    scale_bar.setUnits(QgsUnitTypes.DistanceMeters)
    scale_bar.setUnitLabel("m")
    scale_bar.setUnitsPerSegment(500)
    scale_bar.setNumberOfSegments(2)
    scale_bar.setNumberOfSegmentsLeft(0)
    scale_bar.update()
    scale_bar.attemptMove(QgsLayoutPoint(8, 172, MILLIMETERS))
    _label(layout, f"Label map and landmarks of the sample area, {labels.crs().authid()}", 100, 173, 104, 8, 9)
    return layout


def _legend(layout: QgsPrintLayout, project: QgsProject, page_map: QgsLayoutItemMap) -> None:
    """What the map shows, small enough to stand beside it."""
    legend = QgsLayoutItemLegend(layout)
    layout.addLayoutItem(legend)
    legend.setLinkedMap(page_map)
    legend.setAutoUpdateModel(False)
    root = legend.model().rootGroup()
    for node in project.layerTreeRoot().findLayers():
        if not node.isVisible():
            root.removeLayer(node.layer())
    for style in (QgsLegendStyle.SymbolLabel, QgsLegendStyle.Subgroup):
        legend.setStyleFont(style, QFont("DejaVu Sans", 8))
    legend.setSymbolHeight(3)
    legend.setSymbolWidth(5)
    legend.setBoxSpace(0)
    for style, side in ((QgsLegendStyle.Symbol, QgsLegendStyle.Top), (QgsLegendStyle.Subgroup, QgsLegendStyle.Top)):
        legend.setStyleMargin(style, side, 1.5)
    legend.adjustBoxSize()
    legend.attemptMove(QgsLayoutPoint(212, 127, MILLIMETERS))


def _colored(image: Path, labels: QgsRasterLayer) -> Path:
    """The label image in the class colors, for people to look at; beside the project."""
    # GDAL's Python objects do not keep their dataset alive: it needs a name.
    label_map, source = gdal.Open(labels.source()), gdal.Open(str(image))
    memory = gdal.GetDriverByName("MEM").CreateCopy("", source)
    memory.GetRasterBand(1).SetColorTable(label_map.GetRasterBand(1).GetColorTable())
    target = image.parent.parent.parent / "query.png"
    gdal.GetDriverByName("PNG").CreateCopy(str(target), memory)
    return target


def _place(item, left: float, top: float, width: float, height: float) -> None:
    item.attemptMove(QgsLayoutPoint(left, top, MILLIMETERS))
    item.attemptResize(QgsLayoutSize(width, height, MILLIMETERS))


def _label(layout, text: str, left: float, top: float, width: float, height: float, size: int, bold=False) -> None:
    label = QgsLayoutItemLabel(layout)
    label.setText(text)
    font = QFont("DejaVu Sans", size)
    font.setBold(bold)
    label.setFont(font)
    label.setFontColor(QColor("#222222"))
    layout.addLayoutItem(label)
    _place(label, left, top, width, height)
