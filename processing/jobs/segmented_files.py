"""The outputs of a segmentation: label map, polygons, confidence, and probabilities of each class."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING, Callable

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingFeedback

from ...core.errors import LabelMapError
from ...core.labels.class_table import UNLABELED, ClassTable
from ...core.values import schema
from ..base.algorithm import check_canceled, each, follow, interruptible
from ..base.outputs import Outputs
from ..base.values import Values
from ..compat import POLYGON
from ..translation import tr
from .annotation import geometry_of

if TYPE_CHECKING:
    import numpy as np

    from ...core.geometry.frame import MapFrame
    from ...core.segmentation.certainty import Certainty
    from ...core.segmentation.model import SegmentationModel
    from ...core.segmentation.tiling import SegmentedRows

FIELDS = schema("class integer, class_name text, area real")

TOLERANCE_PX = 1.5
"""Tolerance that straightens pixel edges: those of a slanting line are at most 0.71 pixels off it."""


@contextmanager
def segmented_files(
    outputs: Outputs, frame: MapFrame, model: SegmentationModel, keys: tuple[str, str, str], wanted: Certainty
) -> Iterator[tuple[str, Callable[[Iterable[SegmentedRows]], None]]]:
    """Open the files of one run; yield the path of the label map while it is written, and a function that writes rows.

    It writes rows when they are finished, from the first to the last, so memory does not grow with the height of the
    image. It raises LabelMapError if the disk is full.

    Args:
        keys: Keys of the label map, the confidence and the probabilities.
        wanted: Which of the latter two are written.
    """
    from ...core.segmentation.class_bias import class_bias_text
    from ...storage.label_map_file import LabelMapFile, whole_tile_rows
    from ...storage.pictures import PercentRaster
    from ..layers.class_styles import write_percent_style

    classes = model.classes
    with ExitStack() as files:

        def percents(key: str, names: list[str], shown: int) -> PercentRaster:
            path = files.enter_context(outputs.raster(key, lambda path: write_percent_style(path, shown)))
            return files.enter_context(PercentRaster(path, frame, names))

        label_map = files.enter_context(outputs.label_map(keys[0], classes.table))
        bias = class_bias_text(model.class_bias)
        labels = files.enter_context(LabelMapFile(label_map, frame, classes.table, bias))
        writers = [lambda first, bands: labels.write_rows(first, bands[0])]
        if wanted.of_label:
            confidence = percents(keys[1], [tr("Confidence")], 1)
            writers.append(lambda first, bands: confidence.write_rows(first, bands[1:2]))
        if wanted.of_each:
            # The style shows the first class that is not “unlabeled”.
            shown = next((n for n, value in enumerate(classes.values, start=1) if value != UNLABELED), 1)
            shares = percents(keys[2], list(classes.names), shown)
            writers.append(lambda first, bands: shares.write_rows(first, bands[-len(classes.names) :]))

        def write(rows: Iterable[SegmentedRows]) -> None:
            for first, bands in whole_tile_rows(_stacked(rows)):
                for write_bands in writers:
                    write_bands(first, bands)

        yield label_map, write


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
