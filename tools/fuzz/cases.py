"""Small inputs for every algorithm that writes files, and the parameters that it runs with."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

LEFT_OUT = ("trainmodel",)
"""Training takes a Python with torch; tests/qgis/test_train_model.py has its bad inputs."""

_NAMES = ["unlabeled", "building", "water", "bare_land", "field"]
_SUFFIXES = {"sink": ".gpkg", "rasterDestination": ".tif", "folderDestination": ""}
_BUILD = {"REFERENCE_CLASSES": "1;2;3", "WINDOW_SIZE": 100, "STRIDE": 50, "MINIMUM_AREA": 30}
_NOISE = {"MISSED": 0, "INVENTED": 0, "MISNAMED": 0, "RAGGED": 0}


def _given(at: Path) -> dict[str, dict[str, Any]]:
    """Return the parameters of each algorithm beside its outputs."""
    layer = {"INPUT": str(at / "annotation.gpkg"), "CLASS_FIELD": "class"}
    labels, area, model, table = (str(at / name) for name in ("labels.tif", "area.gpkg", "colors.onnx", "classes.csv"))
    color, predicted = str(at / "color.tif"), str(at / "predicted.tif")
    noise = {"DATABASE": area, **_NOISE}
    return {
        "rasterizeannotation": {**layer, "PIXEL_SIZE": 1},
        "classtable": {**layer, "REFERENCE_CLASSES": "water"},
        "classifyopenstreetmap": {"INPUT": layer["INPUT"], "LINES": str(at / "lines.gpkg"), "OTHER_CLASS": "field"},
        "checkannotation": {**layer, "PIXEL_SIZE": 1},
        "repairannotation": layer,
        "decodecolorlabels": {"INPUT": color, "CLASS_TABLE": table, "METHOD": 1},
        "comparelabels": {"REFERENCE": labels, "PREDICTED": predicted, "MINIMUM_AREA": 3},
        "exporttrainingtiles": {"IMAGE": color, "LABELS": labels, "TILE_SIZE": 32, "STRIDE": 32},
        "addmodel": {"INPUT": model, "LICENSE": "CC0", "RESOLUTION": 25, "CLASSES": "a;b;a"},
        "segmentimage": {"INPUT": color, "MODEL": model},
        "builddatabase": {"LABELS": labels, **_BUILD},
        "updatedatabase": {"DATABASE": area, "LABELS": str(at / "corrected.tif")},
        "exportonboard": {"DATABASE": area},
        "describeimage": {"INPUT": str(at / "images" / "0.png"), "DATABASE": area},
        "localizeimages": {"DATABASE": area, "IMAGES": [str(at / "images")], "METHOD": 2},
        "localizeflight": {"DATABASE": area, "IMAGES": [str(at / "images")], "METHOD": 2},
        "georeferenceimages": {"POSITIONS": str(at / "positions.gpkg"), "IMAGES": [str(at / "images")]},
        "evaluatelocalization": {"DATABASE": area, "LABELS": labels, "TRIALS": 1, "METHODS": [1]},
        "assessdatabase": {**noise, "FOOTPRINT": "100", "SPACING": 120, "TRIALS": 20},
        "assessroute": {**noise, "ROUTE": str(at / "route.gpkg"), "SPACING": 150, "FOOTPRINT": 100, "TRIALS": 1},
        "annotationtodatabase": {**layer, "PIXEL_SIZE": 1, **_BUILD, "REFERENCE_CLASSES": "building;water;bare_land"},
        "orthophototodisagreements": {"IMAGE": color, "MODEL": model, "LABELS": labels},
        "correctiontodatabase": {**layer, "CLASS_TABLE": table, "LABELS": labels, "DATABASE": area},
    }


def make_inputs(at: Path) -> None:
    """Write the inputs into a new folder; the provider is registered."""
    import processing
    from made_inputs import CLASSES_CSV, scattered_objects, square, write_layer, write_raster, write_text
    from made_models import painted, write_model

    random = np.random.default_rng(4)
    (at / "images").mkdir(parents=True)
    labels = scattered_objects(220, 260, 90, seed=1)
    corrected = labels.copy()
    corrected[40:65, 60:90] = 4
    write_raster(at / "labels.tif", labels, names=_NAMES)
    write_raster(at / "corrected.tif", corrected, names=_NAMES)
    write_raster(at / "predicted.tif", np.roll(labels, 4, 1), names=_NAMES)
    photo = painted(np.where(labels == 4, 0, labels))
    write_raster(at / "color.tif", (photo + random.integers(0, 9, photo.shape)).astype(np.uint8).transpose(2, 0, 1))
    for n in range(4):
        write_raster(at / "images" / f"{n}.png", labels[10 * n : 10 * n + 110, 24:134], transform=None)
    places = random.uniform(0, 200, (150, 2))
    features = [(square(*place, 14), name, n) for n, (place, name) in enumerate(zip(places, _NAMES[1:4] * 50))]
    features.insert(0, (square(0, 0, 220), "field", 0))
    write_layer(at / "annotation.gpkg", features, [("class", "text"), ("zorder", "integer")])
    west, north = 550000, 5220000
    line = f"LINESTRING ({west + 50} {north - 60}, {west + 200} {north - 150})"
    write_layer(at / "route.gpkg", [(line,)], fields=())
    write_layer(at / "lines.gpkg", [(line, "track")], [("highway", "text")])
    columns = [("image", "text"), ("status", "text"), ("heading", "real"), ("pixel_size", "real")]
    fixes = [(f"POINT ({west + 60 + n} {north - 60})", f"{n}.png", "fix", 30.0 * n, 1.0) for n in range(4)]
    write_layer(at / "positions.gpkg", fixes, columns)
    write_text(at / "classes.csv", CLASSES_CSV)
    write_model(at / "colors.onnx")
    build = {"LABELS": str(at / "labels.tif"), **_BUILD, "DATABASE": str(at / "area.gpkg")}
    processing.run("semref:builddatabase", build)


def all_parameters(provider: Any, inputs: Path, folder: Path) -> dict[str, dict[str, Any]]:
    """Return the parameters of each writer by its name, outputs in ``folder``; KeyError for one without inputs here."""
    given, found = _given(inputs), {}
    for algorithm in provider.algorithms():
        outputs = _destinations(algorithm, folder)
        if outputs and algorithm.name() not in LEFT_OUT:
            if algorithm.name() not in given:
                raise KeyError(f"tools/fuzz/cases.py has no inputs for {algorithm.name()}, which writes files")
            found[algorithm.name()] = {**given[algorithm.name()], **outputs}
    return found


def _destinations(algorithm: Any, folder: Path) -> dict[str, str]:
    found = {}
    for definition in algorithm.parameterDefinitions():
        if definition.isDestination():
            suffix = _SUFFIXES.get(definition.type())
            suffix = f".{definition.defaultFileExtension()}" if suffix is None else suffix
            found[definition.name()] = str(folder / (definition.name().split(":")[-1].replace(" ", "_") + suffix))
    return found
