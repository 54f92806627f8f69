"""The outputs of a segmentation: label map, polygons, confidence, and probabilities of each class."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import ExitStack
from typing import TYPE_CHECKING, Callable

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingFeedback

from ...core.errors import LabelMapError
from ...core.labels.class_table import UNLABELED, ClassTable
from ...core.values import schema
from ..compat import POLYGON
from ..translation import tr
from .algorithm import check_canceled, each, follow, interruptible
from .annotation import geometry_of
from .outputs import Outputs
from .values import Values

if TYPE_CHECKING:
    import numpy as np

    from ...core.geometry.frame import MapFrame
    from ...core.segmentation.certainty import Certainty
    from ...core.segmentation.model import SegmentationModel
    from ...core.segmentation.tiling import SegmentedRows
    from ...storage.pictures import PercentRaster

FIELDS = schema("class integer, class_name text, area real")

TOLERANCE_PX = 1.5
"""Tolerance that straightens pixel edges: those of a slanting line are at most 0.71 pixels off it."""


class SegmentedFiles:
    """The files of one run, open within a ``with``; ``label_map`` is the path of the label map while it is written.

    Rows are written when they are finished, so memory does not grow with the height of the image.
    """

    def __init__(
        self, outputs: Outputs, frame: MapFrame, model: SegmentationModel, keys: tuple[str, str, str], wanted: Certainty
    ) -> None:
        """Prepare to write.

        Args:
            keys: Keys of the label map, the confidence and the probabilities.
            wanted: Which of the latter two are written.
        """
        self._outputs, self._frame, self._model, self._keys, self._wanted = outputs, frame, model, keys, wanted
        self._files = ExitStack()
        self._writers: list[Callable[[int, np.ndarray], None]] = []
        self.label_map = ""

    def __enter__(self) -> SegmentedFiles:
        with ExitStack() as files:
            self._open(files)
            self._files = files.pop_all()
        return self

    def __exit__(self, *error: object) -> bool | None:
        return self._files.__exit__(*error)  # type: ignore[arg-type]

    def write(self, rows: Iterable[SegmentedRows]) -> None:
        """Write all rows, from the first to the last. Raises LabelMapError if the disk is full."""
        from ...storage.label_map_file import whole_tile_rows

        for first, bands in whole_tile_rows(_stacked(rows)):
            for write in self._writers:
                write(first, bands)

    def _open(self, files: ExitStack) -> None:
        from ...core.segmentation.class_bias import class_bias_text
        from ...storage.label_map_file import LabelMapFile

        classes = self._model.classes
        self.label_map = files.enter_context(self._outputs.label_map(self._keys[0], classes.table))
        bias = class_bias_text(self._model.class_bias)
        labels = files.enter_context(LabelMapFile(self.label_map, self._frame, classes.table, bias))
        self._writers = [lambda first, bands: labels.write_rows(first, bands[0])]
        if self._wanted.of_label:
            confidence = self._percents(files, self._keys[1], [tr("Confidence")], 1)
            self._writers.append(lambda first, bands: confidence.write_rows(first, bands[1:2]))
        if self._wanted.of_each:
            # The style shows the first class that is not “unlabeled”.
            shown = next((n for n, value in enumerate(classes.values, start=1) if value != UNLABELED), 1)
            each = self._percents(files, self._keys[2], list(classes.names), shown)
            self._writers.append(lambda first, bands: each.write_rows(first, bands[-len(classes.names) :]))

    def _percents(self, files: ExitStack, key: str, names: list[str], shown: int) -> PercentRaster:
        from ...storage.pictures import PercentRaster
        from ..layers.class_styles import write_percent_style

        path = files.enter_context(self._outputs.raster(key, lambda path: write_percent_style(path, shown)))
        return files.enter_context(PercentRaster(path, self._frame, names))


def _stacked(rows: Iterable[SegmentedRows]) -> Iterator[tuple[int, np.ndarray]]:
    """Yield (first row, (bands, rows, W) uint8): labels, their confidence, and probabilities of each class, as
    selected."""
    import numpy as np

    for piece in rows:
        bands = [piece.labels_hw[None]]
        bands += [] if piece.percent_hw is None else [piece.percent_hw[None]]
        bands += [] if piece.percents_chw is None else [piece.percents_chw]
        yield piece.first, bands[0] if len(bands) == 1 else np.concatenate(bands)


def write_polygons(
    values: Values,
    outputs: Outputs,
    key: str,
    path: str,
    crs: QgsCoordinateReferenceSystem,
    table: ClassTable,
    feedback: QgsProcessingFeedback,
) -> None:
    """Write the polygons of the label map in ``path``, if selected, by MINIMUM_AREA and TOLERANCE.

    Raises:
        LabelMapError: They cannot be made.
    """
    if not values.has(key):
        return
    from ...core.annotation.outlines import areas_and_wkb, can_simplify
    from ...storage.polygonize import polygonize
    from ...storage.rasters import open_raster, transform_of
    from ..layers.class_styles import annotation_renderer

    transform = transform_of(open_raster(path))
    tolerance = values.optional_number("TOLERANCE", TOLERANCE_PX * abs(transform[1]))
    if tolerance and not can_simplify():
        feedback.pushWarning(
            tr("The polygons keep the edges of the pixels, because simplification needs Shapely 2.1 with GEOS 3.12.")
        )
    minimum_area = values.optional_number("MINIMUM_AREA", 0.0)
    steps = polygonize(path, minimum_area, tolerance, lambda: not feedback.isCanceled())
    try:
        classes, polygons = follow(interruptible(steps, feedback), feedback)
    except LabelMapError:
        check_canceled(feedback)
        raise
    names = {one.value: one.name for one in table}
    areas, wkb = areas_and_wkb(polygons)
    renderer = annotation_renderer(table, "class_name")
    with outputs.layer(key, FIELDS, POLYGON, crs, "class_polygons", renderer=renderer) as sink:
        for value, area, outline in each(zip(classes.tolist(), areas.tolist(), wkb), feedback):
            sink.add_row(geometry_of(outline), (value, names.get(value), area))
