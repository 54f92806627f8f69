"""The steps of *Set up an area*: the algorithms that it runs, in order, and the files that they write."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsReferencedRectangle

from ...core.labels.class_table import OTHER
from ...core.localization import SHOWN_RISK
from ..layers.guess_fields import BUILDING
from ..layers.results_file import LABELS_FOLDER, MOSAIC, MOSAIC_FILE, table_outputs
from ..translation import tr
from .chain import Step

if TYPE_CHECKING:
    from .area_setup import AreaMap, AreaSetup

RULES_FILE, CAMERAS_FILE = "rules.csv", "cameras.csv"
LAND_COVER_FILE, LABEL_MAP_FILE = "land_cover.gpkg", "label_map.tif"
DATABASE_FILE, MODEL_FILE, TRAINING_FILE = "reference_database.gpkg", "model.onnx", "training.html"
EXPECTED_FILE, ASSESSMENT_FILE = "expected_success.gpkg", "assessment.html"
POSITIONS_FILE = "positions.gpkg"
FIRST_FILES = "first_positions.gpkg", "first_footprints.gpkg"
PHOTOS_FOLDER = "training_photos"
PHOTOS_MOSAIC = f"{PHOTOS_FOLDER}/{MOSAIC_FILE}"
"""Results of the model as it is, and imagery of them, where the photos are the imagery of the training."""

TRAIN, GEOREFERENCE = "trainmodel", "georeferenceimages"

SCALES = 0.5, 2.0
"""Scales to search where the ground width of a photo is typical."""

SIMULATED, MOST_SIMULATED, SQUARES = 100, 500, 2000
"""Simulated images of the quick assessment on ground with landmarks, on all ground, and the largest number of squares:
up to half a minute."""


@dataclass(frozen=True)
class AreaRun:
    """What the steps need.

    Attributes:
        known: Classes that the map is limited to; empty for all.
        model: Model of the user or of SemRef; empty without one.
        base: Model to start the training from; None for a new one.
        imagery: Imagery of the training; empty for the photos.
        minutes: Duration of the training; 0 without one.
    """

    map: AreaMap
    area: AreaSetup
    folder: Path
    known: Sequence[str]
    model: str
    base: str | None
    imagery: str
    minutes: float

    def path(self, name: str) -> str:
        return str(self.folder / name)


def steps_of(run: AreaRun) -> list[Step]:
    """Return the steps in order."""
    steps = [*_mapping(run), _building(run)]
    if run.minutes:
        steps += [*([] if run.imagery else _photos_as_imagery(run)), _training(run)]
    steps.append(_assessment(run))
    if run.area.photos.files:
        model = run.path(MODEL_FILE) if run.minutes else run.model
        outputs = {"LABELS": run.path(LABELS_FOLDER), **_tables(run.path(POSITIONS_FILE))}
        steps.append(_localization(run, model, outputs, (POSITIONS_FILE,), tr("Localizing the photos")))
    return steps


def _mapping(run: AreaRun) -> list[Step]:
    """Return the steps from polygons to the label map."""
    plan, steps = run.area.plan, []
    polygons: dict[str, Any] = {"INPUT": run.map.layer, "CLASS_FIELD": run.map.class_field}
    polygons |= {"PRIORITY_FIELD": run.map.priority_field} if run.map.priority_field else {}
    polygons |= {} if run.map.class_field else {"CLASS": BUILDING}
    if run.map.has_tags:
        tags = {"INPUT": run.map.layer, "OUTPUT": run.path(LAND_COVER_FILE)}
        tags |= {} if run.map.lines is None else {"LINES": run.map.lines}
        tags |= {"RULES": run.path(RULES_FILE)} if run.known else {}
        steps.append(Step("classifyopenstreetmap", tags, (LAND_COVER_FILE,), tr("Classifying OpenStreetMap")))
        polygons = {"INPUT": tags["OUTPUT"], "CLASS_FIELD": "class", "PRIORITY_FIELD": "priority"}
    rasterize = {
        **polygons,
        "PIXEL_SIZE": plan.pixel_size_m,
        "EXTENT": QgsReferencedRectangle(run.area.extent, run.area.crs),
        "TARGET_CRS": run.area.crs,
        "OTHER_GROUND": OTHER in run.known and OTHER not in {name.casefold() for name in run.area.classes},
        "OUTPUT": run.path(LABEL_MAP_FILE),
    }
    return [*steps, Step("rasterizeannotation", rasterize, (LABEL_MAP_FILE,), tr("Rasterizing the map"))]


def _building(run: AreaRun) -> Step:
    plan = run.area.plan
    build = {
        "LABELS": run.path(LABEL_MAP_FILE),
        "REFERENCE_CLASSES": ";".join(run.area.reference),
        "WINDOW_SIZE": plan.window_m,
        "STRIDE": plan.stride_m,
        "MINIMUM_AREA": plan.minimum_area_m2,
        "DATABASE": run.path(DATABASE_FILE),
    }
    return Step("builddatabase", build, (DATABASE_FILE,), tr("Building the reference database"))


def _localization(run: AreaRun, model: str, outputs: dict[str, str], files: tuple[str, ...], text: str) -> Step:
    photos = run.area.photos
    values = {"DATABASE": run.path(DATABASE_FILE), "IMAGES": list(photos.files), "RISK": SHOWN_RISK, "MODEL": model}
    if photos.unknown:
        values |= {"ATTITUDE": run.path(CAMERAS_FILE)}
        values |= {"SCALE_MINIMUM": SCALES[0], "SCALE_MAXIMUM": SCALES[1]}
    return Step("localizeimages", {**values, **outputs}, files, text)


def _photos_as_imagery(run: AreaRun) -> list[Step]:
    """Return the steps that make imagery of the photos that get a position with the model as it is."""
    first = {"OUTPUT": run.path(FIRST_FILES[0]), "FOOTPRINTS": run.path(FIRST_FILES[1])}
    georeference = {
        "POSITIONS": first["OUTPUT"],
        "FOOTPRINTS": first["FOOTPRINTS"],
        "IMAGES": list(run.area.photos.files),
        "FORMAT": MOSAIC,
        "RESOLUTION": run.area.plan.resolution_cm,
        "OUTPUT": run.path(PHOTOS_FOLDER),
    }
    return [
        _localization(run, run.model, first, FIRST_FILES, tr("Localizing the photos for the training")),
        Step(GEOREFERENCE, georeference, (PHOTOS_MOSAIC,), tr("Georeferencing the photos for the training")),
    ]


def _training(run: AreaRun) -> Step:
    train = {
        "IMAGE": run.imagery or run.path(PHOTOS_MOSAIC),
        "LABELS": run.path(LABEL_MAP_FILE),
        "BASE_MODEL": run.base,
        "MINUTES": run.minutes,
        "RESOLUTION": run.area.plan.resolution_cm,
        "OUTPUT": run.path(MODEL_FILE),
        "REPORT": run.path(TRAINING_FILE),
    }
    return Step(TRAIN, train, (MODEL_FILE, TRAINING_FILE), tr("Training the model"))


def _assessment(run: AreaRun) -> Step:
    footprint = round(math.sqrt(math.prod(run.area.photos.size_m)), 1)
    assess = {
        "DATABASE": run.path(DATABASE_FILE),
        "FOOTPRINT": str(footprint),
        "SPACING": max(footprint / 2, math.sqrt(run.area.extent.area() / SQUARES)),
        "TRIALS": _simulated(run.area),
        "OUTPUT": run.path(EXPECTED_FILE),
        "REPORT": run.path(ASSESSMENT_FILE),
    }
    return Step("assessdatabase", assess, (EXPECTED_FILE, ASSESSMENT_FILE), tr("Assessing the database"))


def _tables(path: str) -> dict[str, str]:
    """Return the outputs of the localization as tables of one file, as the dock opens them."""
    if "'" in path:
        # QGIS cannot write tables to such a path. The only layer gets the file's name, which is that of the table.
        return {"OUTPUT": path}
    return table_outputs(path)


def _simulated(area: AreaSetup) -> int:
    """Return the simulated images that are spread over all ground so that enough of them show landmarks."""
    photo_m2, photos = math.prod(area.photos.size_m), area.plan.landmarks / max(area.plan.per_photo, 1)
    share = min(max(photos, 1) * photo_m2 / max(area.extent.area(), photo_m2), 1.0)
    return min(round(SIMULATED / share), MOST_SIMULATED)
