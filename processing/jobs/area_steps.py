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
    from .area_map import AreaMap
    from .area_setup import AreaSetup

RULES_FILE, CAMERAS_FILE = "rules.csv", "cameras.csv"
LAND_COVER_FILE, LABEL_MAP_FILE = "land_cover.gpkg", "label_map.tif"
DATABASE_FILE, MODEL_FILE, TRAINING_FILE = "reference_database.gpkg", "model.onnx", "training.html"
EXPECTED_FILE, ASSESSMENT_FILE = "expected_success.gpkg", "assessment.html"
POSITIONS_FILE = "positions.gpkg"

TRAIN, GEOREFERENCE = "trainmodel", "georeferenceimages"

ROUNDS = "first", "second"
"""Names of the rounds of a training on photos. In the second round, more photos have a position."""

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
    is_flight: bool

    def path(self, name: str) -> str:
        return str(self.folder / name)


def steps_of(run: AreaRun) -> list[Step]:
    steps = [*_mapping(run), _building(run)]
    if run.minutes and run.imagery:
        steps.append(_training(run, run.imagery, run.base, run.minutes))
    elif run.minutes:
        steps += _training_on_photos(run)
    steps.append(_assessment(run))
    if run.area.photos.files:
        model = run.path(MODEL_FILE) if run.minutes else run.model
        outputs = {"LABELS": run.path(LABELS_FOLDER), **_tables(run.path(POSITIONS_FILE), run.is_flight)}
        steps.append(_localization(run, model, outputs, (POSITIONS_FILE,), tr("Localizing the photos")))
    return steps


def _mapping(run: AreaRun) -> list[Step]:
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
    algorithm = "localizeflight" if run.is_flight else "localizeimages"
    return Step(algorithm, {**values, **outputs}, files, text)


def _training_on_photos(run: AreaRun) -> list[Step]:
    """Return rounds that localize the photos, make imagery of those with a position, and train the model on it."""
    steps, model, base = [], run.model, run.base
    for name in ROUNDS:
        files = f"{name}_positions.gpkg", f"{name}_footprints.gpkg"
        outputs = dict(zip(("OUTPUT", "FOOTPRINTS"), map(run.path, files)))
        text = tr("Localizing the photos for the training")
        steps.append(_localization(run, model, outputs, files, text))
        georeference = {
            "POSITIONS": outputs["OUTPUT"],
            "FOOTPRINTS": outputs["FOOTPRINTS"],
            "IMAGES": list(run.area.photos.files),
            "FORMAT": MOSAIC,
            "RESOLUTION": run.area.plan.resolution_cm,
            "OUTPUT": run.path(f"{name}_photos"),
        }
        mosaic = f"{name}_photos/{MOSAIC_FILE}"
        text = tr("Georeferencing the photos for the training")
        steps.append(Step(GEOREFERENCE, georeference, (mosaic,), text))
        prefix = "" if name == ROUNDS[-1] else f"{name}_"
        steps.append(_training(run, run.path(mosaic), base, run.minutes / len(ROUNDS), prefix))
        model = base = run.path(prefix + MODEL_FILE)
    return steps


def _training(run: AreaRun, imagery: str, base: str | None, minutes: float, prefix: str = "") -> Step:
    files = prefix + MODEL_FILE, prefix + TRAINING_FILE
    train = {
        "IMAGE": imagery,
        "LABELS": run.path(LABEL_MAP_FILE),
        "BASE_MODEL": base,
        "MINUTES": minutes,
        "RESOLUTION": run.area.plan.resolution_cm,
        "OUTPUT": run.path(files[0]),
        "REPORT": run.path(files[1]),
    }
    if not run.imagery:
        # The few tiles of a few photos teach more than they test.
        train["VALIDATION_FRACTION"] = 0.0
    return Step(TRAIN, train, files, tr("Training the model"))


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


def _tables(path: str, is_flight: bool) -> dict[str, str]:
    """Return the outputs of the localization as tables of one file, as the dock opens them."""
    if "'" in path:
        # QGIS cannot write tables to such a path. The only layer gets the file's name, which is that of the table.
        return {"OUTPUT": path}
    return table_outputs(path, is_flight)


def _simulated(area: AreaSetup) -> int:
    """Return the simulated images that are spread over all ground so that enough of them show landmarks."""
    photo_m2, photos = math.prod(area.photos.size_m), area.plan.landmarks / max(area.plan.per_photo, 1)
    share = min(max(photos, 1) * photo_m2 / max(area.extent.area(), photo_m2), 1.0)
    return min(round(SIMULATED / share), MOST_SIMULATED)
