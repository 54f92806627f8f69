"""``burn``: polygons that QGIS wrote down as a label map, strip by strip, by many workers; see ``rasterize.py``."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ..core.annotation.job import BurnJob
from ..core.labels.counts import count_labels
from ..storage.burning import strips_of
from ..storage.carried import read
from ..storage.files import written_beside
from ..storage.label_map_file import LabelMapFile
from .engine import DaskRunner, connected
from .inputs import Teller, require_apart
from .tasks import BURN


def burn(options: Namespace, teller: Teller) -> dict[str, Any]:
    """Makes the label map of a job in a file.

    Args:
        options: Of the command line.
        teller: Takes what is being done.

    Returns:
        Pixels of each value.

    Raises:
        SemRefError: Anything that the user can mend.
    """
    require_apart(options.order, options.labels)
    return {"counts": burnt(read(options.order), options, teller).tolist()}


def burnt(job: BurnJob, options: Namespace, teller: Teller) -> np.ndarray:
    """Writes ``options.labels``, the bytes that one process writes; (256,) pixels of each value.

    Args:
        job: What is burnt.
        options: Of the command line.
        teller: Takes what is being done.

    Raises:
        SemRefError: Anything that the user can mend.
    """
    counts, frame = np.zeros(256, np.int64), job.frame
    height, width = frame.shape_hw
    with (
        written_beside(str(Path(options.labels).absolute())) as temporary,
        connected(options.scheduler, options.local, options.worker_memory, teller.say) as client,
        LabelMapFile(temporary, width, height, frame.geotransform, frame.crs, job.table) as file,
    ):
        teller.step("Burning polygons", 0.0)
        found = DaskRunner(client, "").in_order(BURN, _calls(job), (frame.crs,))
        for (first, _), labels in zip(strips_of(frame), found):
            counts += count_labels(labels)
            file.write_rows(first, labels)
            teller.step("Burning polygons", (first + len(labels)) / height)
    return counts


def _calls(job: BurnJob) -> Iterator[tuple]:
    """Of each strip its place and the polygons that may reach into it."""
    for _, strip in strips_of(job.frame):
        yield strip.geotransform, strip.shape_hw, *job.within(strip.extent)
