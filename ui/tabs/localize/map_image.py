"""An image of what the map shows of a layer that is no file, such as map tiles: would this place be found?"""

from __future__ import annotations

from threading import Event

from qgis.core import QgsProject, QgsRasterLayer
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....processing.translation import tr
from ...running.background import Reader


class MapImage(QObject):
    """Draws one at a time in the background. ``shut_down`` before it is deleted.

    made: the path of a GeoTIFF that lasts as long as QGIS runs; failed: a sentence; broke: a bug's traceback.
    """

    made = pyqtSignal(object)
    failed = pyqtSignal(str)
    broke = pyqtSignal(str)

    def __init__(self, canvas: QgsMapCanvas, parent: QObject) -> None:
        super().__init__(parent)
        self._canvas = canvas
        self._canceled = Event()
        self._reader = Reader(self)
        self._reader.answered.connect(self.made)
        self._reader.failed.connect(self.failed)
        self._reader.broke.connect(self.broke)

    def draw(self, layer: QgsRasterLayer, model_path: str) -> None:
        """Draws the canvas's extent of a layer, as large as the network wants it."""
        if not model_path:
            self.failed.emit(tr("Choose a model first: it says how large the pixels of the map shall be."))
            return
        # Not at the top: it brings GDAL's arrays, and the dock shall open at once.
        from ....processing.base.photo_source import draw_for_model
        from ....processing.layers.rendering import drawable

        settings = self._canvas.mapSettings()
        extent, crs = settings.visibleExtent(), settings.destinationCrs()
        arguments = drawable(layer), extent, crs, model_path, QgsProject.instance().transformContext()
        self._reader.read(tr("Drawing the layer"), draw_for_model, *arguments, self._canceled.is_set)

    def shut_down(self) -> None:
        """Ends what is being drawn."""
        self._canceled.set()
        self._reader.shut_down()
