"""What workers do of a job of many images: open what is the same for all once, and answer piece by piece."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from typing import Any, NamedTuple

from ..core.assessment.assessment import Assessment
from ..core.assessment.job import AssessmentJob
from ..core.database.model import ReferenceDatabase
from ..core.errors import DatabaseError, SemRefError
from ..core.evaluation.evaluation import Evaluation
from ..core.labels.class_shares import SeenLabels
from ..core.labels.class_table import ClassTable
from ..core.localizer.localizer import Localizer
from ..core.localizer.search import AskedImage, FoundImage, ImagesJob
from ..core.localizer.settings import LOCALIZER
from ..core.segmentation.class_bias import KnownBiases, known_biases
from ..storage.database.reader import read_database, read_overview
from ..storage.file_states import fingerprint
from ..storage.label_images import LabelImageReader, opened_photo
from ..storage.rasters import GdalLabels
from ..storage.serialization import from_bytes, to_bytes
from .task_names import ASSESS, CORRELATE, EVALUATE, IMAGES


def do(task: str, job: bytes, pieces: bytes) -> bytes:
    """Answer some pieces of a job.

    Args:
        task: One of ``TASKS``.
        job: The job and the fingerprint of its database, serialized.
        pieces: A serialized list of them.

    Returns:
        The serialized list of what was found.

    Raises:
        SemRefError: The job can't be done.
    """
    answer = TASKS[task]
    return to_bytes([answer(job, piece) for piece in from_bytes(pieces)])


def _image(content: bytes, asked: AskedImage) -> FoundImage:
    """One bad image must not stop the others."""
    opened = _images(content)
    try:
        seen, known = opened.read(asked)
        opened.localizer.heed_biases(known.class_biases, known.class_spread)
        found = opened.job.search.localized(opened.localizer, seen, asked.camera)
    except SemRefError as error:
        return FoundImage(fault=error.sentence)
    return FoundImage(found, None, seen.labels_hw.shape)


class _Images(NamedTuple):
    job: ImagesJob
    localizer: Localizer
    read: Callable[[AskedImage], tuple[SeenLabels, KnownBiases]]


@lru_cache(1)
def _images(content: bytes) -> _Images:
    job, known = _opened(content)
    database = _as_planned(read_database(job.database, with_overview=job.has_overview), known)
    localizer = Localizer(database, replace(LOCALIZER, allowed_risk=job.risk), job.sun_deg)
    read = _photos(job.model, database.class_table) if job.model else _label_images(database.class_table)
    return _Images(job, localizer, read)


def _label_images(table: ClassTable) -> Callable[[AskedImage], tuple[SeenLabels, KnownBiases]]:
    reader = LabelImageReader(table)
    return lambda asked: (reader.seen(asked.path), reader.biases(asked.path))


def _photos(path: str, table: ClassTable) -> Callable[[AskedImage], tuple[SeenLabels, KnownBiases]]:
    # onnxruntime is needed for photos only.
    from ..core.segmentation.model import SegmentationModel
    from ..core.segmentation.photo_labels import PhotoLabels

    # One thread on the processor: all workers give the same.
    model = SegmentationModel(path, 1, device="cpu")
    values, known = model.classes.values_in(table, path), known_biases(model.class_bias, table)

    def read(asked: AskedImage) -> tuple[SeenLabels, KnownBiases]:
        photo = opened_photo(asked.path)
        return PhotoLabels(model, photo, values, asked.pixel_size_m, asked.camera).seen(), known

    return read


def _trials(content: bytes, piece: tuple) -> list[Any]:
    query, methods = piece
    return _evaluation(content).run(query, methods)


@lru_cache(1)
def _evaluation(content: bytes) -> Evaluation:
    job, known = _opened(content)
    database = _as_planned(read_database(job.database, with_overview=True), known)
    return job.evaluation(database, GdalLabels(job.labels))


def _simulated(content: bytes, piece: tuple) -> Any:
    footprint, query = piece
    return _assessment(content, footprint).run(query)


def _correlated(content: bytes, piece: tuple) -> Any:
    footprint, query = piece
    return _assessment(content, footprint).run_correlation(query)


@lru_cache(1)
def _assessed(content: bytes) -> tuple[AssessmentJob, ReferenceDatabase, Localizer]:
    job, known = _opened(content)
    database = _as_planned(read_database(job.database, with_bounds=True), known)
    if job.has_overview:
        database = replace(database, overview=read_overview(job.database, database.parameters))
    return job, database, Localizer(database)


@lru_cache(2)
def _assessment(content: bytes, footprint: float) -> Assessment:
    job, database, localizer = _assessed(content)
    return job.assessment(database, localizer, footprint)


def _opened(content: bytes) -> tuple[Any, str]:
    """A job, and the fingerprint of its database."""
    return from_bytes(content)


def _as_planned(database: ReferenceDatabase, known: str) -> ReferenceDatabase:
    """The same; raises DatabaseError for another one than pieces were planned by."""
    if fingerprint(database) != known:
        raise DatabaseError("cluster.map_changed", path=database.source)
    return database


TASKS: dict[str, Callable[[str, Any], Any]] = {
    IMAGES: _image,
    EVALUATE: _trials,
    ASSESS: _simulated,
    CORRELATE: _correlated,
}
