"""For scripts that run inside desktop QGIS: the layers that several of them go their ways with."""

from pathlib import Path

import processing
from qgis.core import QgsFeature, QgsGeometry, QgsProject, QgsVectorLayer


def openstreetmap_layer() -> QgsVectorLayer:
    """200 houses and ponds as QuickOSM makes them, in the project."""
    layer = QgsVectorLayer("Polygon?crs=EPSG:25832&field=building:string&field=natural:string", "osm", "memory")
    for number in range(200):
        x, y, size = 500_000 + 40 * (number % 20), 5_400_000 + 40 * (number // 20), 8 + number % 7
        corners = [(x, y), (x + size, y), (x + size, y + size), (x, y + size), (x, y)]
        _add(layer, corners, "building" if number % 9 else "natural", "yes" if number % 9 else "water")
    layer.updateExtents()
    QgsProject.instance().addMapLayer(layer)
    return layer


def cover_with_database(folder: Path, crs: str) -> tuple[QgsVectorLayer, dict, str, str]:
    """144 houses and a pond that overlaps one, in the project, with a database of them.

    Returns:
        The layer, what algorithms are given for it, and the paths of its label map and of its database.
    """
    cover = QgsVectorLayer(f"Polygon?crs={crs}&field=class:string", "cover", "memory")
    squares = [(x, y, "building") for x in range(0, 240, 20) for y in range(0, 240, 20)]
    for x, y, name in [*squares, (3, 3, "water")]:
        left, bottom = 400_000 + x, 5_400_000 + y
        size = 5 + (x + 3 * y) / 20 % 7
        corners = [(left, bottom), (left + size, bottom), (left + size, bottom + size), (left, bottom)]
        _add(cover, corners, "class", name)
    cover.updateExtents()
    QgsProject.instance().addMapLayer(cover)
    table = folder / "classes.csv"
    table.write_text("value,name,color,role\n1,building,#ff0000,reference\n2,water,#0000ff,reference\n")
    same = {"INPUT": cover, "CLASS_FIELD": "class", "CLASS_TABLE": str(table)}
    labels, database = str(folder / "cover.tif"), str(folder / "cover.gpkg")
    processing.run("semref:rasterizeannotation", {**same, "PIXEL_SIZE": 0.5, "OUTPUT": labels})
    sizes = {"WINDOW_SIZE": 100, "STRIDE": 50, "MINIMUM_AREA": 5, "DATABASE": database}
    processing.run("semref:builddatabase", {"LABELS": labels, **sizes})
    return cover, same, labels, database


def _add(layer: QgsVectorLayer, corners: list, field: str, value: str) -> None:
    feature = QgsFeature(layer.fields())
    ring = ", ".join(f"{x} {y}" for x, y in corners)
    feature.setGeometry(QgsGeometry.fromWkt(f"POLYGON(({ring}))"))
    feature[field] = value
    layer.dataProvider().addFeature(feature)
