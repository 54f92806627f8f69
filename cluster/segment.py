"""``segment``: a photo or an orthophoto to a label map by many workers, as ``semref:segmentimage`` makes it."""

from __future__ import annotations

import tempfile
from argparse import Namespace
from collections.abc import Iterator
from dataclasses import astuple
from pathlib import Path
from typing import Any

import numpy as np

from ..core.segmentation.certainty import Sureness
from ..core.segmentation.class_bias import class_bias_text
from ..core.segmentation.tiling import Tiles
from ..storage.files import written_beside
from ..storage.label_map_file import LabelMapFile, whole_tile_rows
from ..storage.text_tables import read_class_table
from .engine import DaskRunner, connected
from .inputs import Teller, require_apart, require_unchanged, seen_by_workers, state
from .photos import Opened, Opening, opened
from .tasks import SEGMENT

TILES_A_BLOCK = 8
"""Along each axis: a ninth more are looked at for the seams, and 10 MB of labels come back."""


def segment(options: Namespace, teller: Teller) -> dict[str, Any]:
    """Makes the label map that the command line asks for.

    Args:
        options: Of the command line.
        teller: Takes what is being done.

    Returns:
        What came of it, by name.

    Raises:
        SemRefError: Anything that the user can mend.
    """
    opening = _opening(options)
    for path in (opening.image, opening.model):
        require_apart(path, options.labels)
    photo, before = opened(opening), state(opening.image)
    height, width = photo.image.shape_hw
    classes, bias = photo.model.classes, class_bias_text(photo.model.class_bias)
    place = photo.geotransform, photo.crs_wkt
    sure = Sureness()
    with written_beside(str(Path(options.labels).absolute())) as temporary:
        with (
            connected(options.scheduler, options.local, options.worker_memory, teller.say) as client,
            LabelMapFile(temporary, width, height, *place, classes.table, bias) as file,
        ):
            runner = DaskRunner(client, "")
            for first, labels in whole_tile_rows(_rows(photo, opening, runner, sure, Path(temporary).parent)):
                file.write_rows(first, labels)
                teller.step("Segmenting", (first + len(labels)) / height)
        require_unchanged({opening.image: before})
    return {"labels": options.labels, "width": width, "height": height, "certainty": sure.mean}


def _opening(options: Namespace) -> Opening:
    table = read_class_table(options.class_table).to_csv() if options.class_table else ""
    resolution_m = None if options.resolution is None else options.resolution / 100
    overlap = None if options.overlap is None else options.overlap / 100
    image, model = seen_by_workers(options.image), seen_by_workers(options.model)
    return Opening(image, model, table, resolution_m, overlap, options.device)


def _rows(
    photo: Opened, opening: Opening, run: DaskRunner, sure: Sureness, folder: Path
) -> Iterator[tuple[int, np.ndarray]]:
    """(first row, (rows, W) labels) of each row of tiles, from top to bottom, as one process finishes them."""
    tiles = photo.tiles
    firsts = [range(0, len(starts), TILES_A_BLOCK) for starts in (tiles.columns, tiles.rows)]
    places = [(column, row) for row in firsts[1] for column in firsts[0]]
    blocks = [tiles.block(photo.model.tile_hw, place, TILES_A_BLOCK) for place in places]
    found = run.in_order(SEGMENT, ((place, TILES_A_BLOCK) for place in places), astuple(opening))
    across = len(firsts[0])
    for first in range(0, len(blocks), across):
        yield from _band(tiles, blocks[first : first + across], found, sure, folder)


def _band(
    tiles: Tiles, blocks: list[Tiles], found: Iterator, sure: Sureness, folder: Path
) -> Iterator[tuple[int, np.ndarray]]:
    """The blocks that lie side by side, as whole rows."""
    _, top, _, bottom = blocks[0].box
    # In a file without a name: of an orthophoto of a country it is gigabytes.
    with tempfile.TemporaryFile(dir=folder) as file:
        labels = np.memmap(file, np.uint8, "w+", shape=(bottom - top, tiles.box[2]))
        for block in blocks:
            labels[:, block.box[0] : block.box[2]], total, count = next(found)
            sure.add(Sureness(total, count))
        ends = [*(row for row in tiles.rows if top < row < bottom), bottom]
        for begin, end in zip([top, *ends], ends):
            yield begin, np.array(labels[begin - top : end - top])
        del labels
