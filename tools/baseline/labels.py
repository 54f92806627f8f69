"""Label maps made in other ways and looked at: described, compared, decoded, segmented, cut into tiles."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import cv2
import numpy as np
from osgeo import gdal

from . import cuts, dumps
from .recorder import Recorder

MODEL = "models/sample_area.onnx"
BERLIN_PHOTO = "berlin_urban_gradient/berlin_hires_rgb8.tif"
CROP = (1000, 800, 900, 700)
"""First column and row, width and height of the orthophoto's part that is segmented."""


def record(recorder: Recorder, places: dict[str, Any]) -> None:
    """Records the answers on label maps."""
    for name in ("sample", "liechtenstein"):
        if name in places:
            _describe(recorder, places[name])
    _decode(recorder, places["sample"])
    predicted = _segment(recorder, places["sample"])
    _compare(recorder, places, predicted)
    _tiles(recorder, places["sample"])


def _describe(recorder: Recorder, area) -> None:
    references, labels = area.reference_values(), area.pixels()
    window, stride = area.window / area.geotransform()[1], area.stride / area.geotransform()[1]
    for view in cuts.plan({"window": 2, "spoiled": 2, "poor": 1}, labels.shape, window, stride, 640, 5):
        image = recorder.path(f"described/{area.name}_{view.name}.png")
        cv2.imwrite(image, cuts.cut(labels, view, references))
        settings = {"DATABASE": area.database}
        if view.name.endswith("_01"):
            settings = {"CLASS_TABLE": area.table, "MINIMUM_AREA": 30, "REFERENCES_PER_VECTOR": 5}
        what = f"described/{area.name} {view.name}"
        points, vector = f"{image}.gpkg", f"{image}.json"
        recorder.run(what, "describeimage", {"INPUT": image, **settings, "REFERENCES": points, "VECTOR": vector})
        recorder.put_layer(what, points)
        recorder.put(f"{what}/vector", Path(vector).read_text(encoding="utf-8"))


def _decode(recorder: Recorder, sample) -> None:
    """A picture in the class colours with blended edges, which match no class or a wrong one."""
    crop = sample.pixels()[600:1400, 700:1700]
    picture = cv2.GaussianBlur(np.ascontiguousarray(sample.colors()[crop][..., ::-1]), (0, 0), 1.5)
    path = recorder.path("decoded/colors.png")
    cv2.imwrite(path, picture)
    for method, name in enumerate(("HSV ranges", "nearest color")):
        output = recorder.path(f"decoded/{method}.tif")
        parameters = {"INPUT": path, "CLASS_TABLE": sample.table, "METHOD": method, "OUTPUT": output}
        recorder.run(f"decoded/{name}", "decodecolorlabels", parameters)
        recorder.put_raster(f"decoded/{name}", output)


def _segment(recorder: Recorder, sample) -> str:
    """The shipped network on a part of the orthophoto, which it knows, and on Berlin, which it doesn't."""
    crop = recorder.path("segmented/crop.tif")
    gdal.Translate(crop, recorder.path("sample/orthophoto.tif"), srcWin=CROP)
    images = {"sample": (crop, {}), "sample overlapping": (crop, {"OVERLAP": 50, "RESOLUTION": 150})}
    if (recorder.data / BERLIN_PHOTO).exists() and not recorder.quick:
        images["berlin"] = (str(recorder.data / BERLIN_PHOTO), {"CLASS_TABLE": sample.table})
    for name, (image, settings) in images.items():
        output = recorder.path(f"segmented/{name}.tif")
        parameters = {"INPUT": image, "MODEL": str(recorder.repository / MODEL), **settings, "OUTPUT": output}
        recorder.run(f"segmented/{name}", "segmentimage", parameters)
        recorder.put_raster(f"segmented/{name}", output)
    return recorder.path("segmented/sample.tif")


def _compare(recorder: Recorder, places: dict[str, Any], predicted: str) -> None:
    pairs = {"segmented": (places["sample"].labels, predicted)}
    if "liechtenstein" in places:
        pairs["edited"] = (places["liechtenstein"].labels, recorder.path("liechtenstein/edited.tif"))
    if "christchurch" in places:
        pairs["dates"] = (places["christchurch"].labels, recorder.path("christchurch/labels_2018.tif"))
    for name, (reference, found) in pairs.items():
        output, report = recorder.path(f"compared/{name}.gpkg"), recorder.path(f"compared/{name}.html")
        parameters = {"REFERENCE": reference, "PREDICTED": found, "DISAGREEMENTS": output, "REPORT": report}
        recorder.run(f"compared/{name}", "comparelabels", parameters)
        recorder.put_layer(f"compared/{name}", output)
        recorder.put(f"compared/{name}/report", dumps.report_numbers(report))


def _tiles(recorder: Recorder, sample) -> None:
    crop = recorder.path("segmented/crop.tif")
    output = recorder.path("tiles")
    parameters = {"IMAGE": crop, "LABELS": sample.labels, "TILE_SIZE": 128, "STRIDE": 112, "OUTPUT": output}
    recorder.run("tiles", "exporttrainingtiles", {**parameters, "VALIDATION_FRACTION": 0.3})
    recorder.put("tiles/files", dumps.folder_files(output))
    texts = {path.name: path.read_text(encoding="utf-8") for path in sorted(Path(output).glob("*.json"))}
    recorder.put("tiles/texts", texts)
