"""Selected result: marks on the map, the image in the dock, and matched landmarks in both."""

from __future__ import annotations

import os
from typing import Callable

from qgis.core import QgsProject
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....core.errors import ImageError
from ....core.named_files import named_file
from ....processing.compat import wkt_for_gdal
from ....processing.inspection.image import ImageQuery
from ....processing.messages.sentences import worded
from ....processing.translation import tr
from ...canvas.drapes import PlacedImage, add_placed, place_image
from ...canvas.highlight import HitHighlight, TrackMarks
from ...canvas.match_marks import MatchMarks
from ...findings import Finding
from ...running.background import Reader
from ...widgets.messages import Messages
from .picture import ImagePicture, PictureShelf
from .results import ResultsBox


class ShownHit(QObject):
    """Follows the selection of a ResultsBox.

    described: name and topology vector of the selected image; None without a vector.
    """

    described = pyqtSignal(str, object)

    def __init__(self, canvas: QgsMapCanvas, results: ResultsBox, messages: Messages) -> None:
        super().__init__(results)
        self._results, self._messages = results, messages
        self.highlight = HitHighlight(canvas, self)
        self.matches = MatchMarks(canvas, self)
        self.track = TrackMarks(canvas, self)
        self._pictures = PictureShelf()
        self._picture_reader = Reader(self)
        self._drape_reader = Reader(self)
        self._database = self._model = ""
        self._chosen: Callable[[], list[str]] | None = None
        self._results.image.clear(_nothing_yet())
        self._connect()

    def _connect(self) -> None:
        self._results.list.findingSelected.connect(self._show)
        self._results.zoom.toggled.connect(self._zoom_if_asked)
        self._results.drape.clicked.connect(self.drape)
        self._picture_reader.answered.connect(self._show_picture)
        self._picture_reader.failed.connect(self._results.image.clear)
        self._drape_reader.answered.connect(self._show_drape)
        self._drape_reader.failed.connect(self._messages.error)

    def use(self, database: str, model: str, chosen: Callable[[], list[str]] | None = None) -> None:
        """Set what the next results were computed with.

        Args:
            model: Path of the model; empty for label images.
            chosen: Returns files and folders with images that may be opened; None if the user chose all images.
        """
        self._database, self._model, self._chosen = database, model, chosen

    def set_visible(self, visible: bool) -> None:
        """Show or hide the marks on the canvas."""
        for marks in (self.highlight, self.matches, self.track):
            marks.set_visible(visible)

    # --- selected result ---

    def _show(self, finding: Finding | None) -> None:
        if not self.highlight.show(finding):
            self._messages.warning(
                tr("The position is outside the area of the project’s CRS. Choose another CRS to show it.")
            )
        self._zoom_if_asked()
        self.matches.clear()
        self._picture_reader.forget()
        self.described.emit("", None)
        if finding is None:
            self._results.image.clear(_nothing_yet())
            return
        self._results.image.clear(tr("Reading…"))
        if finding.matches is not None:
            self.matches.show(finding.matches, finding.crs)
        image = self._file_of(finding)
        if not image:
            self._results.image.clear(_not_chosen())
            return
        pixel_size = None if finding.corners is None else finding.pixel_size
        query = ImageQuery(image, finding.labels, self._model, pixel_size)
        self._picture_reader.read(tr("Reading an image"), self._pictures.read, query, self._database)

    def _show_picture(self, picture: ImagePicture) -> None:
        finding = self._results.list.selected()
        self._results.image.show_picture(picture, () if finding.matches is None else finding.matches.pixels)
        self.described.emit(os.path.basename(picture.path), picture.seen.vector)

    def _zoom_if_asked(self) -> None:
        if self._results.zoom.isChecked():
            self.highlight.zoom()

    # --- image on the map ---

    def drape(self) -> None:
        """Add the selected image to the map at its position."""
        finding = self._results.list.selected()
        image = self._file_of(finding)
        if not image:
            self._messages.warning(_not_chosen())
            return
        arguments = image, finding.corners, wkt_for_gdal(finding.crs)
        self._drape_reader.read(tr("Adding an image to the map"), place_image, *arguments)

    def _file_of(self, finding: Finding) -> str:
        """Return the path of an image; empty if results from a file name an image that the user did not choose."""
        return finding.image if self._chosen is None else named_file(finding.image, self._chosen())

    def _show_drape(self, placed: PlacedImage) -> None:
        try:
            add_placed(placed, self._database, QgsProject.instance())
        except ImageError as error:
            self._messages.error(worded(error))


def _not_chosen() -> str:
    return tr("This image is not in the folder of the results. Add the image or its folder to the list of images.")


def _nothing_yet() -> str:
    return tr("The selected image appears here.")
