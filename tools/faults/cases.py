"""Everything of the provider that writes, with small inputs in two variants: one made the older outputs, one the new.

The writers and their outputs are taken from the provider: an algorithm without inputs here is an error, an output
that is added to one is written and looked at by itself.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .content import State

VARIANTS = ("old", "new")
SEEDS = {"old": 3, "new": 4}
_NAMES = ["unlabeled", "building", "water", "bare_land", "field"]
_SUFFIXES = {"sink": ".gpkg", "rasterDestination": ".tif", "folderDestination": ""}
_BUILD = {"REFERENCE_CLASSES": "1;2;3", "WINDOW_SIZE": 100, "STRIDE": 50, "MINIMUM_AREA": 30}
_NOISE = {"MISSED": 0, "INVENTED": 0, "MISNAMED": 0, "RAGGED": 0}


def _given(at: Path) -> dict[str, dict[str, Any]]:
    """What each writer is given beside its outputs."""
    layer = {"INPUT": str(at / "annotation.gpkg"), "CLASS_FIELD": "class"}
    labels, area, model, table = (str(at / name) for name in ("labels.tif", "area.gpkg", "colors.onnx", "classes.csv"))
    color, predicted = str(at / "color.tif"), str(at / "predicted.tif")
    noise = {"DATABASE": area, **_NOISE}
    return {
        "rasterizeannotation": {**layer, "PIXEL_SIZE": 1},
        "classtable": {**layer, "REFERENCE_CLASSES": _NAMES[1 + SEEDS[at.name] % 3]},
        "classifyopenstreetmap": {"INPUT": str(at / "annotation.gpkg"), "OTHER_CLASS": "field"},
        "checkannotation": {**layer, "PIXEL_SIZE": 1},
        "repairannotation": layer,
        "decodecolorlabels": {"INPUT": color, "CLASS_TABLE": table, "METHOD": 1},
        "comparelabels": {"REFERENCE": labels, "PREDICTED": predicted, "MINIMUM_AREA": 3},
        "exporttrainingtiles": {"IMAGE": color, "LABELS": labels, "TILE_SIZE": 32, "STRIDE": 32},
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


LEFT_OUT = ("trainmodel", "routesheet")
"""Writers without faults here: training takes a Python with torch, and keeps a run that ended early on purpose
(tests/qgis/test_train_model.py); a PDF has the moment of its writing inside, so that no two are the same."""

_IN_PLACE = {"updatedatabase in place": ("updatedatabase", "DATABASE", "OUTPUT", "area.gpkg")}
"""Outputs that replace an input: (algorithm, key of the input, of the output, file)."""


@dataclass(frozen=True)
class Writer:
    """Something that writes.

    Attributes:
        name: Of the algorithm, and how it is run.
        is_one_run: Whether all its outputs belong to one run; a model's steps are runs of their own.
        run: Variant, folder of the outputs and feedback → results; raises what QGIS raises.
        before: Folder with the older outputs.
        old: State of the older outputs.
        new: State when the new ones were written over them.
        second: State of what another run writes to the same places.
        steps: Times that it tells its progress.
        touches: Things that it does to files.
        seconds: From its first unfinished output to its end.
        largest: Bytes of its largest file.
        needed: Bytes of all its files.
    """

    name: str
    is_one_run: bool
    run: Callable[..., Any]
    before: Path
    old: State
    new: State
    second: State
    steps: int
    touches: int
    seconds: float
    largest: int
    needed: int


def make_inputs(at: Path, run: Callable[..., Any]) -> None:
    """Writes the inputs of one variant, the folder's name."""
    from made_inputs import CLASSES_CSV, scattered_objects, square, write_layer, write_raster, write_text
    from made_models import painted, write_model

    seed = SEEDS[at.name]
    random = np.random.default_rng(seed)
    (at / "images").mkdir(parents=True)
    labels = scattered_objects(220, 260, 90, seed=1)
    corrected = labels.copy()
    corrected[10 * seed : 10 * seed + 25, 60:90] = 4
    write_raster(at / "labels.tif", labels if seed == SEEDS["old"] else corrected, names=_NAMES)
    write_raster(at / "corrected.tif", corrected, names=_NAMES)
    write_raster(at / "predicted.tif", np.roll(labels, seed, 1), names=_NAMES)
    photo = painted(np.roll(np.where(labels == 4, 0, labels), seed, 0))
    write_raster(at / "color.tif", (photo + random.integers(0, 9, photo.shape)).astype(np.uint8).transpose(2, 0, 1))
    for n in range(4):
        cut = labels[10 * n : 10 * n + 110, 20 + seed : 130 + seed]
        write_raster(at / "images" / f"{n}.png", cut, transform=None)
    places = random.uniform(0, 200, (150, 2))
    features = [(square(*place, 14), name, n) for n, (place, name) in enumerate(zip(places, _NAMES[1:4] * 50))]
    features.insert(0, (square(0, 0, 220), "field", 0))
    write_layer(at / "annotation.gpkg", features, [("class", "text"), ("zorder", "integer")])
    west, north = 550000, 5220000
    line = f"LINESTRING ({west + 50} {north - 60}, {west + 200} {north - 150})"
    write_layer(at / "route.gpkg", [(line,)], fields=())
    columns = [("image", "text"), ("status", "text"), ("heading", "real"), ("pixel_size", "real")]
    fixes = [(f"POINT ({west + 60 + n} {north - 60})", f"{n}.png", "fix", 30.0 * n + seed, 1.0) for n in range(4)]
    write_layer(at / "positions.gpkg", fixes, columns)
    write_text(at / "classes.csv", CLASSES_CSV)
    write_model(at / "colors.onnx")
    for name in ("area.gpkg", "again.gpkg"):
        run("builddatabase", {"LABELS": str(at / "labels.tif"), **_BUILD, "DATABASE": str(at / name)})


def destinations(algorithm: Any, folder: Path) -> dict[str, str]:
    """A place in ``folder`` for each output of an algorithm."""
    found = {}
    for definition in algorithm.parameterDefinitions():
        if definition.isDestination():
            suffix = _SUFFIXES.get(definition.type())
            if suffix is None:
                suffix = "." + definition.defaultFileExtension()
            found[definition.name()] = str(folder / (definition.name().split(":")[-1].replace(" ", "_") + suffix))
    return found


def parameters_of(algorithm: Any, inputs: Path, variant: str, folder: Path) -> dict[str, Any]:
    """What a writer is given; raises KeyError for one that has no inputs here."""
    given = _given(inputs / variant)
    if algorithm.name() not in given:
        raise KeyError(f"tools/faults/cases.py has no inputs for {algorithm.name()}, which writes files")
    return {**given[algorithm.name()], **destinations(algorithm, folder)}


def all_parameters(
    provider: Any,
    inputs: Path,
) -> dict[str, tuple[str, Callable[[str, Path], dict[str, Any]]]]:
    """(algorithm, its parameters) of each writer by its name; raises KeyError for a writer without inputs."""
    found: dict[str, tuple[str, Callable[[str, Path], dict[str, Any]]]] = {}
    for algorithm in sorted(provider.algorithms(), key=lambda algorithm: algorithm.name()):
        if destinations(algorithm, inputs) and algorithm.name() not in LEFT_OUT:
            parameters_of(algorithm, inputs, "new", inputs)

            def parameters(variant: str, folder: Path, algorithm: Any = algorithm) -> dict[str, Any]:
                return parameters_of(algorithm, inputs, variant, folder)

            found[algorithm.name()] = algorithm.name(), parameters
    for name, (algorithm_name, _, output, file) in _IN_PLACE.items():
        found[name] = algorithm_name, _in_place(found[algorithm_name][1], name, output, file)
    return found


def _in_place(
    parameters: Callable[[str, Path], dict[str, Any]], name: str, output: str, file: str
) -> Callable[[str, Path], dict[str, Any]]:
    key = _IN_PLACE[name][1]
    return lambda variant, folder: {
        **parameters(variant, folder),
        key: str(folder / file),
        output: str(folder / file),
    }
