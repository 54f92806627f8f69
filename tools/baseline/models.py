"""The models that ship: each in one run, on the sample area."""

from __future__ import annotations

import shutil
from typing import Any

import numpy as np
from osgeo import gdal

from .labels import MODEL
from .recorder import Recorder


def record(recorder: Recorder, places: dict[str, Any]) -> None:
    """Records what the models' children write."""
    folder = recorder.path("sample")
    polygons = {"INPUT": f"{folder}/landcover.shp", "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
    polygons["CLASS_TABLE"] = f"{folder}/classes.csv"
    labels, database = recorder.path("models/labels.tif"), recorder.path("models/area.gpkg")
    parameters = {**polygons, "PIXEL_SIZE": 2.0, "WINDOW_SIZE": 640, "STRIDE": 320, "MINIMUM_AREA": 50}
    parameters.update({"rasterize:Label map": labels, "build:Reference database": database})
    recorder.run("annotation to database", "annotationtodatabase", parameters)
    recorder.put_raster("annotation to database/label map", labels)
    recorder.put_database("annotation to database/database", database)
    _correct(recorder, polygons, labels, database)
    output, predicted = recorder.path("models/disagreements.gpkg"), recorder.path("models/predicted.tif")
    crop = recorder.path("models/crop.tif")
    gdal.Translate(crop, f"{folder}/orthophoto.tif", srcWin=(1500, 1200, 600, 500))
    parameters = {"IMAGE": crop, "MODEL": str(recorder.repository / MODEL), "LABELS": places["sample"].labels}
    parameters.update({"compare:Disagreements": output, "segment:Predicted label map": predicted})
    recorder.run("orthophoto to disagreements", "orthophototodisagreements", parameters)
    recorder.put_layer("orthophoto to disagreements", output)
    recorder.put_raster("orthophoto to disagreements/label map", predicted)


def _correct(recorder: Recorder, polygons: dict[str, Any], labels: str, database: str) -> None:
    """Return an old label map with a hole that the land-cover layer fills."""
    old, updated = recorder.path("models/old.tif"), recorder.path("models/old.gpkg")
    shutil.copyfile(labels, old)
    dataset = gdal.Open(old, gdal.GA_Update)
    dataset.GetRasterBand(1).WriteArray(np.zeros((120, 150), np.uint8), 700, 500)
    dataset = None
    parameters = {"LABELS": old, "WINDOW_SIZE": 640, "STRIDE": 320, "MINIMUM_AREA": 50, "DATABASE": updated}
    recorder.run("correction/old database", "builddatabase", parameters)
    corrected, output = recorder.path("models/corrected.tif"), recorder.path("models/corrected.gpkg")
    parameters = {**polygons, "LABELS": old, "DATABASE": updated}
    parameters.update({"rasterize:Corrected label map": corrected, "update:Updated database": output})
    recorder.run("correction to database", "correctiontodatabase", parameters)
    recorder.put_raster("correction to database/label map", corrected)
    recorder.put_database("correction to database/database", output)
