"""A small database of rectangles, and user actions in the dock, for tests of the dock."""

import contextlib
import time
from pathlib import Path

import made_inputs
import numpy as np
import pytest
from qgis.core import (
    QgsApplication,
    QgsFeature,
    QgsGeometry,
    QgsLayerTreeModel,
    QgsProject,
    QgsRasterLayer,
    QgsRectangle,
    QgsVectorFileWriter,
    QgsVectorLayer,
)
from qgis.gui import QgsRubberBand
from qgis.PyQt.QtCore import QCoreApplication, QEvent, QPoint, QPointF, Qt
from qgis.PyQt.QtGui import QDragEnterEvent, QDropEvent

from semref.ui.findings import status_text

PIXELS = 600
WINDOW = 200
STRIDE = 50
ORIGIN = (400_000.0, 5_400_000.0)
CRS = "EPSG:25832"
CUT = (150, 250)
"""First column and row of the window in the query image."""
DEADLINE_S = 120


def label_map() -> np.ndarray:
    """Return small rectangles of three classes, apart from each other."""
    return made_inputs.scattered_objects(PIXELS, PIXELS, 345, seed=7, background=0)


def write_raster(path: Path, labels: np.ndarray, georeferenced: bool) -> str:
    transform = (ORIGIN[0], 1, 0, ORIGIN[1], 0, -1) if georeferenced else None
    return str(made_inputs.write_raster(path, labels, crs=25832, transform=transform))


class Area:
    """Paths of a database, an image cut from one of its windows, and an invalid image."""

    def __init__(self, folder: Path, run_algorithm) -> None:
        labels = label_map()
        column, row = CUT
        self.database = str(folder / "area.gpkg")
        self.image = write_raster(folder / "on_window.tif", labels[row : row + WINDOW, column : column + WINDOW], False)
        self.unreadable = str(folder / "broken.tif")
        Path(self.unreadable).write_text("not an image", encoding="utf-8")
        parameters = {
            "LABELS": write_raster(folder / "labels.tif", labels, True),
            "REFERENCE_CLASSES": "1;2;3",
            "WINDOW_SIZE": WINDOW,
            "STRIDE": STRIDE,
            "MINIMUM_AREA": 20,
            "DATABASE": self.database,
        }
        run_algorithm("semref:builddatabase", parameters)


def settle() -> None:
    for _ in range(5):
        QCoreApplication.processEvents()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def wait_until(condition, what: str) -> None:
    deadline = time.monotonic() + DEADLINE_S
    while not condition():
        if time.monotonic() > deadline:
            pytest.fail(f"{what} did not happen within {DEADLINE_S} s.")
        QCoreApplication.processEvents()
        time.sleep(0.005)


AUTOMATIC, TOPOLOGY_VECTOR, CONSTELLATION = range(3)


def choose_method(dock, method: int) -> None:
    dock.content.localize.method.choice.setCurrentIndex(dock.content.localize.method.choice.findData(method))


def start(dock, database: str, images: list[str]) -> None:
    dock.content.database.file.setFilePath(database)
    dock.content.localize.images.list.add(images)
    dock.content.localize.localize_button.click()


def localize(dock, database: str, images: list[str]) -> None:
    start(dock, database, images)
    wait_until(lambda: not dock.content.localize.run.running, "the end of the run")


def results_of(dock) -> list[tuple[str, str]]:
    return [(finding.name, status_text(finding)) for finding in dock.content.localize.results.list.findings]


def messages(iface) -> list[str]:
    return [item.text() for item in iface.bar.items()]


@contextlib.contextmanager
def logged():
    """Yield the messages of SemRef that QGIS logs meanwhile."""
    texts, log = [], QgsApplication.messageLog()

    def note(text, tag, *_level):
        if tag == "SemRef":
            texts.append(text)

    log.messageReceived[str, str, "Qgis::MessageLevel"].connect(note)
    yield texts
    log.messageReceived[str, str, "Qgis::MessageLevel"].disconnect(note)


def shown_outline(iface):
    """Return the extent of the outline in the canvas's CRS, or None."""
    bands = [item for item in iface.canvas.scene().items() if isinstance(item, QgsRubberBand)]
    extents = [band.asGeometry().boundingBox() for band in bands if band.numberOfVertices()]
    # The heading's arrow and the error's circle are inside the outline.
    return max(extents, key=lambda extent: extent.width()) if extents else None


def shown_center(iface):
    places = rubber_bands(iface, "Point")
    return places[0].boundingBox().center() if places else None


def cut_extent():
    left, top = ORIGIN[0] + CUT[0], ORIGIN[1] - CUT[1]
    return QgsRectangle(left, top - WINDOW, left + WINDOW, top)


def corners(extent):
    return [extent.xMinimum(), extent.yMinimum(), extent.xMaximum(), extent.yMaximum()]


def rubber_bands(iface, geometry_type: str) -> list:
    """Return the geometries of rubber bands, 'Polygon' or 'Line'."""
    bands = [item for item in iface.canvas.scene().items() if isinstance(item, QgsRubberBand)]
    found = [band.asGeometry() for band in bands if band.numberOfVertices()]
    return [geometry for geometry in found if geometry_type in type(geometry.constGet()).__name__]


def add_raster_layer(path: str, name: str):
    layer = QgsRasterLayer(path, name, "gdal")
    QgsProject.instance().addMapLayer(layer)
    return layer


def rectangles(name: str, fields: dict[str, str], rows, path: str = ""):
    """Add a polygon layer of rectangles to the project; returns it.

    fields: kinds by name; rows: ((left, bottom, width, height), value of each field, …); path: of a GeoPackage,
    empty for a layer in memory.
    """
    columns = "&".join(f"field={field}:{kind}" for field, kind in fields.items())
    layer = QgsVectorLayer(f"Polygon?crs={CRS}&{columns}", name, "memory")
    for (left, bottom, width, height), *values in rows:
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromRect(QgsRectangle(left, bottom, left + width, bottom + height)))
        feature.setAttributes(values)
        layer.dataProvider().addFeature(feature)
    layer.updateExtents()
    if path:
        context, options = QgsProject.instance().transformContext(), QgsVectorFileWriter.SaveVectorOptions()
        QgsVectorFileWriter.writeAsVectorFormatV3(layer, path, context, options)
        layer = QgsVectorLayer(path, name, "ogr")
    QgsProject.instance().addMapLayer(layer)
    return layer


def dropped(widget, data) -> bool:
    """Drag `data` over a widget and drop it; return whether it was accepted."""
    how = Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    entering = QDragEnterEvent(QPoint(5, 5), *how)
    widget.dragEnterEvent(entering)
    if entering.isAccepted():
        widget.dropEvent(QDropEvent(QPointF(5, 5), *how))
    return entering.isAccepted()


def from_the_layer_tree(*layers):
    root = QgsProject.instance().layerTreeRoot()
    model = QgsLayerTreeModel(root)
    return model.mimeData([model.node2index(root.findLayer(layer.id())) for layer in layers])
