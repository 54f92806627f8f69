"""An example call of every algorithm on the sample area.

Each call uses files of the plugin's folder ``sample``, or outputs of earlier calls. ``list_algorithms.py`` shows them
in the reference page; tests/qgis/test_example_calls.py checks and runs them.
"""

import json
import shlex

MODEL = "sample_area.onnx"
COVER = {"INPUT": "sample/landcover.shp", "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
COVER |= {"CLASS_TABLE": "sample/classes.csv"}
SIZES = {"WINDOW_SIZE": 640, "STRIDE": 160, "MINIMUM_AREA": 50}
DATABASE = {"DATABASE": "reference.gpkg"}
QUICK = {**DATABASE, "NETWORK": 2, "MAP_CORRELATION": False}

EXAMPLES: dict[str, dict] = {
    "classtable": {"INPUT": "sample/landcover.shp", "CLASS_FIELD": "class", "OUTPUT": "classes.csv"},
    "checkannotation": {**COVER, "MINIMUM_AREA": 50, "ISSUES": "issues.gpkg", "REPORT": "issues.html"},
    "repairannotation": {**COVER, "OUTPUT": "clean.gpkg", "CHANGES": "changes.gpkg"},
    "rasterizeannotation": {**COVER, "PIXEL_SIZE": 1, "OUTPUT": "labels.tif"},
    "builddatabase": {"LABELS": "labels.tif", **SIZES, **DATABASE},
    "annotationtodatabase": {
        **COVER,
        **SIZES,
        "PIXEL_SIZE": 1,
        "rasterize:Label map": "area.tif",
        "build:Reference database": "area.gpkg",
    },
    "classifyopenstreetmap": {"INPUT": "area.osm.pbf", "LINES": "area.osm.pbf", "OUTPUT": "classified.gpkg"},
    "segmentimage": {"INPUT": "sample/orthophoto.tif", "MODEL": MODEL, "OUTPUT": "predicted.tif"},
    "comparelabels": {
        "REFERENCE": "labels.tif",
        "PREDICTED": "predicted.tif",
        "DISAGREEMENTS": "disagreements.gpkg",
        "REPORT": "comparison.html",
    },
    "orthophototodisagreements": {
        "IMAGE": "sample/orthophoto.tif",
        "MODEL": MODEL,
        "LABELS": "labels.tif",
        "segment:Predicted label map": "seen.tif",
        "compare:Disagreements": "seen.gpkg",
    },
    "decodecolorlabels": {
        "INPUT": "colors.tif",
        "CLASS_TABLE": "sample/classes.csv",
        "METHOD": 1,
        "OUTPUT": "decoded.tif",
    },
    "exporttrainingtiles": {"IMAGE": "sample/orthophoto.tif", "LABELS": "labels.tif", "OUTPUT": "tiles"},
    "trainmodel": {
        "IMAGE": "sample/orthophoto.tif",
        **COVER,
        "MINUTES": 10,
        "OUTPUT": "own.onnx",
        "REPORT": "own.html",
    },
    "addmodel": {
        "INPUT": MODEL,
        "CLASSES": "other;building;bare_land;water;forest;grass;grass",
        "OUTPUT": "merged.onnx",
    },
    "correctiontodatabase": {
        **COVER,
        "LABELS": "labels.tif",
        **DATABASE,
        "rasterize:Corrected label map": "corrected.tif",
        "update:Updated database": "corrected.gpkg",
    },
    "updatedatabase": {**DATABASE, "LABELS": "corrected.tif", "OUTPUT": "updated.gpkg"},
    "setuparea": {
        "PHOTOS": ["sample/photos"],
        "PHOTO_WIDTH": 640,
        "ANNOTATION": "sample/landcover.shp",
        "MODEL": MODEL,
        "FOLDER": "area_and_positions",
    },
    "exportonboard": {**DATABASE, "OUTPUT": "onboard.npz"},
    "localizeimages": {
        **DATABASE,
        "IMAGES": ["sample/photos"],
        "MODEL": MODEL,
        "OUTPUT": "positions.gpkg",
        "FOOTPRINTS": "footprints.gpkg",
        "LABELS": "photo_labels",
    },
    "georeferenceimages": {"POSITIONS": "positions.gpkg", "FOOTPRINTS": "footprints.gpkg", "OUTPUT": "georeferenced"},
    "describeimage": {"INPUT": "photo_labels/photo_01.tif", **DATABASE, "REFERENCES": "landmarks.gpkg"},
    "localizeflight": {
        **DATABASE,
        "IMAGES": ["sample/flight"],
        "MODEL": MODEL,
        "OUTPUT": "flight.gpkg",
        "TRACK": "track.gpkg",
    },
    "evaluatelocalization": {
        **DATABASE,
        "LABELS": "labels.tif",
        "TRIALS": 20,
        "OUTPUT": "trials.gpkg",
        "REPORT": "trials.html",
    },
    "assessdatabase": {**QUICK, "SPACING": 800, "TRIALS": 100, "OUTPUT": "assessed.gpkg", "REPORT": "assessed.html"},
    "assessroute": {**QUICK, "ROUTE": "track.gpkg", "OUTPUT": "route.gpkg", "REPORT": "route.html"},
}
"""Parameters by the algorithm's name. An example uses only outputs of earlier ones."""

ELSEWHERE = {
    "classifyopenstreetmap": "`area.osm.pbf` is an extract of OpenStreetMap. The sample area has no such file.",
    "decodecolorlabels": "`gdal_translate -expand rgb labels.tif colors.tif` creates such an image from a label map.",
    "trainmodel": "Needs the [training environment](../how-to/train_a_network.md#install-the-training-environment).",
}
"""Requirements of an example besides the sample and earlier examples."""


def in_terminal(name: str) -> str:
    """Return the call for ``qgis_process``."""
    values = [shlex.quote(f"{key}={_text(value)}") for key, value in EXAMPLES[name].items()]
    return _folded(f"qgis_process run semref:{name} --", values)


def in_python(name: str) -> str:
    """Return the call for ``processing.run``."""
    values = [f"    {json.dumps(key)}: {_literal(value)}," for key, value in EXAMPLES[name].items()]
    return "\n".join([f'processing.run("semref:{name}", {{', *values, "})"])


def _text(value) -> str:
    return ";".join(value) if isinstance(value, list) else str(value).lower() if isinstance(value, bool) else str(value)


def _literal(value) -> str:
    return repr(value) if isinstance(value, bool) else json.dumps(value)


def _folded(begin: str, values: list[str], width: int = 110) -> str:
    lines = [begin]
    for value in values:
        if len(lines[-1]) + len(value) > width:
            lines[-1] += " \\"
            lines.append("   ")
        lines[-1] += f" {value}"
    return "\n".join(lines)
