"""What is found wrong with annotation layers, and what repairing makes of them."""

from __future__ import annotations

from typing import Any

from osgeo import gdal

from . import dumps
from .areas import LIECHTENSTEIN
from .recorder import Recorder

PIECE = (540000.0, 5229000.0, 542000.0, 5231000.0)
"""Left, bottom, right and top of Liechtenstein's polygons."""

BELGRADE = "osm_belgrade/landuse.shp"
BERLIN = "berlin_urban_gradient/LandCov_BerlinUrbanGradient.shp"


def record(recorder: Recorder, places: dict[str, Any]) -> None:
    """Records issues, repaired layers and changes."""
    for name, (settings, pixel_size) in _layers(recorder, places).items():
        issues, report = recorder.path(f"checked/{name}.gpkg"), recorder.path(f"checked/{name}.html")
        more = {"PIXEL_SIZE": pixel_size, "MAXIMUM_GAP": 2.0, "ISSUES": issues, "REPORT": report}
        recorder.run(f"checked/{name}", "checkannotation", {**settings, **more})
        recorder.put_layer(f"checked/{name}", issues)
        recorder.put(f"checked/{name}/report", dumps.report_numbers(report))
        output, changes = recorder.path(f"repaired/{name}.gpkg"), recorder.path(f"repaired/{name}_changes.gpkg")
        more = {"MAXIMUM_GAP": 2.0, "MINIMUM_AREA": 20.0, "OUTPUT": output, "CHANGES": changes}
        recorder.run(f"repaired/{name}", "repairannotation", {**settings, **more})
        recorder.put_layer(f"repaired/{name}", output)
        recorder.put_layer(f"repaired/{name}/changes", changes)


def _layers(recorder: Recorder, places: dict[str, Any]) -> dict[str, tuple[dict[str, Any], float]]:
    """Parameters that name a layer and its classes, and a pixel size, by name."""
    folder = recorder.path("sample")
    sample = {"INPUT": f"{folder}/landcover.shp", "CLASS_FIELD": "class", "CLASS_TABLE": f"{folder}/classes.csv"}
    layers = {"sample": ({**sample, "PRIORITY_FIELD": "zorder"}, 2.0)}
    if "liechtenstein" in places:
        piece = recorder.path("checked/piece.gpkg")
        gdal.VectorTranslate(piece, str(recorder.data / LIECHTENSTEIN), spatFilter=PIECE)
        piece_of = {"INPUT": piece, "CLASS_FIELD": "class", "CLASS_TABLE": places["liechtenstein"].table}
        layers["liechtenstein"] = ({**piece_of, "PRIORITY_FIELD": "zorder"}, 1.0)
    if (recorder.data / BERLIN).exists() and not recorder.quick:
        layers["berlin"] = ({"INPUT": str(recorder.data / BERLIN), "CLASS_FIELD": "Level_2"}, 3.6)
    if (recorder.data / BELGRADE).exists() and not recorder.quick:
        layers["belgrade"] = ({"INPUT": str(recorder.data / BELGRADE), "CLASS_FIELD": "type"}, 2.0)
    return layers
