"""Execute parts of jobs with many images on a worker, which opens shared data once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from typing import Any, NamedTuple

from ..core.assessment.assessment import Assessment
from ..core.database.model import ReferenceDatabase
from ..core.errors import DatabaseError, SemRefError
from ..core.evaluation.evaluation import Evaluation
from ..core.labels.class_shares import SeenLabels
from ..core.labels.class_table import ClassTable
from ..core.labels.image_source import Photo
from ..core.localizer.localizer import Localizer
from ..core.localizer.search import AskedImage, FoundImage, ImagesJob
from ..core.localizer.settings import LOCALIZER
from ..core.pipeline import localize_labels
from ..core.segmentation.model import SegmentationModel
from ..core.segmentation.photo_labels import PhotoReader
from ..storage.database.reader import read_database, read_overview
from ..storage.file_states import fingerprint
from ..storage.label_images import LabelImageReader, open_photo
from ..storage.label_maps import GdalLabels
from ..storage.serialization import from_bytes, to_bytes
from .task_names import ASSESS, CORRELATE, EVALUATE, IMAGES


def do(task: str, job: bytes, pieces: bytes) -> bytes:
    """Execute some parts of a job.

    Args:
        job: The job and the fingerprint of its database, serialized.
        pieces: List of the parts, serialized.

    Returns:
        List of the results, serialized.

    Raises:
        SemRefError: The job can't be executed.
    """
    answer = TASKS[task]
    return to_bytes([answer(job, piece) for piece in from_bytes(pieces)])


def _image(content: bytes, asked: AskedImage) -> FoundImage:
    """Localize an image. Its error becomes part of the result, so that other images continue."""
    opened = _images(content)
    try:
        found = localize_labels(opened.localizer, opened.job.search, opened.read(asked), asked.camera)
    except SemRefError as error:
        return FoundImage(fault=error.sentence)
    return FoundImage(found.localization, None, found.shape_hw)


class _Images(NamedTuple):
    job: ImagesJob
    localizer: Localizer
    read: Callable[[AskedImage], SeenLabels]


@lru_cache(1)
def _images(content: bytes) -> _Images:
    job, known = from_bytes(content)
    database = _require_planned(read_database(job.database, with_overview=job.has_overview), known)
    localizer = Localizer(database, replace(LOCALIZER, allowed_risk=job.risk), job.sun_deg)
    if job.model:
        return _Images(job, localizer, _photo_reader(job.model, database.class_table))
    reader = LabelImageReader(database.class_table)
    return _Images(job, localizer, lambda asked: reader(asked.path))


def _photo_reader(path: str, table: ClassTable) -> Callable[[AskedImage], SeenLabels]:
    # One CPU thread: all workers give equal results.
    reader = PhotoReader(SegmentationModel(path, 1, device="cpu"), table)

    def read(asked: AskedImage) -> SeenLabels:
        return reader.read(asked.path, Photo(open_photo(asked.path), asked.pixel_size_m), asked.camera)

    return read


def _trials(content: bytes, piece: tuple) -> list[Any]:
    query, methods = piece
    return _evaluation(content).run(query, methods)


@lru_cache(1)
def _evaluation(content: bytes) -> Evaluation:
    (path, labels, settings), known = from_bytes(content)
    database = _require_planned(read_database(path, with_overview=True), known)
    return Evaluation(database, GdalLabels(labels), *settings)


def _simulate(content: bytes, piece: tuple) -> Any:
    footprint, query = piece
    return _assessment(content, footprint).run(query)


def _correlate(content: bytes, piece: tuple) -> Any:
    footprint, query = piece
    return _assessment(content, footprint).run_correlation(query)


@lru_cache(1)
def _open_assessment(content: bytes) -> tuple[ReferenceDatabase, Localizer, tuple]:
    (path, has_overview, settings), known = from_bytes(content)
    database = _require_planned(read_database(path, with_bounds=True), known)
    if has_overview:
        database = replace(database, overview=read_overview(path, database.parameters))
    return database, Localizer(database), settings


@lru_cache(2)
def _assessment(content: bytes, footprint: float) -> Assessment:
    database, localizer, settings = _open_assessment(content)
    return Assessment(database, localizer, footprint, *settings)


def _require_planned(database: ReferenceDatabase, known: str) -> ReferenceDatabase:
    """Return the database. Raises DatabaseError if its fingerprint is not ``known``."""
    if fingerprint(database) != known:
        raise DatabaseError(
            "{path} was changed while it was read. Start again when no program writes to it.", path=database.source
        )
    return database


TASKS: dict[str, Callable[[str, Any], Any]] = {
    IMAGES: _image,
    EVALUATE: _trials,
    ASSESS: _simulate,
    CORRELATE: _correlate,
}
