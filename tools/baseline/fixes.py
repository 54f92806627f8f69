"""Positions of hundreds of label images and of photos, by every method, with and without what is known before."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import cv2
import numpy as np
from osgeo import gdal

from . import cuts, dumps
from .labels import MODEL
from .recorder import Recorder

METHODS = ("automatic", "topology vector", "constellation", "map correlation")
COUNTS = {
    "sample": {"window": 10, "clean": 12, "noisy": 28, "spoiled": 12, "wide": 10, "poor": 8, "mirrored": 8,
               "tilted": 10, "elsewhere": 4, "colored": 6},
    "liechtenstein": {"window": 10, "clean": 14, "noisy": 34, "spoiled": 16, "wide": 12, "poor": 8, "mirrored": 10,
                      "tilted": 14, "elsewhere": 8, "colored": 6},
    "christchurch": {"window": 8, "clean": 10, "noisy": 20, "spoiled": 6, "wide": 6, "poor": 4, "mirrored": 6},
}  # fmt: skip
"""Images of each area by kind, 300 in all."""

SIZES = {"sample": 512, "liechtenstein": 640, "christchurch": 400}
SLOW = {0: 3, 3: 6}
"""Methods that take seconds where they find no place: every how many images of a kind they get."""

QUICK_KINDS = {0: "clean noisy poor mirrored colored", 3: "noisy mirrored"}
"""Kinds that these methods get in a quick recording."""


def record(recorder: Recorder, places: dict[str, Any]) -> None:
    """Records every column of positions, footprints and alternatives."""
    counted = {}
    for name, counts in COUNTS.items():
        if name not in places:
            continue
        if recorder.quick:
            counts = {kind: max(1, count // 8) for kind, count in counts.items()}
        images = _images(recorder, name, places, counts)
        for method in (1, 2, 0, 3):
            some = [path for path in images if int(path[-6:-4]) % SLOW.get(method, 1) == 0]
            if recorder.quick and method in QUICK_KINDS:
                some = [path for path in some if Path(path).stem[:-3] in QUICK_KINDS[method].split()]
            counted[f"{name} {METHODS[method]}"] = len(some)
            _localize(recorder, f"{name} {METHODS[method]}", places[name], some, METHOD=method)
        _with_priors(recorder, places[name], images)
        if "tilted" in counts:
            _with_attitude(recorder, places[name], [path for path in images if "tilted" in path])
    recorder.put("counts", counted)
    photos = sorted(str(path) for path in Path(recorder.path("sample/photos")).glob("*.jpg"))
    model = str(recorder.repository / MODEL)
    for method in (0, 2) if recorder.quick else (0, 1, 2, 3):
        some = photos[:: 3 if recorder.quick or method == 3 else 1]
        _localize(recorder, f"photos {METHODS[method]}", places["sample"], some, METHOD=method, MODEL=model)


def _images(recorder: Recorder, name: str, places: dict[str, Any], counts: dict[str, int]) -> list[str]:
    """Writes the images of an area; gives their paths."""
    area = places[name]
    labels, references, colors = area.pixels(), area.reference_values(), area.colors()
    pixel = area.geotransform()[1]
    others = gdal.Open(places["elsewhere"]).ReadAsArray() if "elsewhere" in places else labels[::-1, ::-1].T
    paths = []
    for view in cuts.plan(counts, labels.shape, area.window / pixel, area.stride / pixel, SIZES[name], 1671):
        source = labels
        if "elsewhere" in view.name:
            source = np.ascontiguousarray(others)
            column, row = view.column % (others.shape[1] - 800) + 400, view.row % (others.shape[0] - 800) + 400
            view = cuts.replace(view, column=column, row=row)
        image = cuts.cut(source, view, references)
        if "colored" in view.name:
            image = np.ascontiguousarray(colors[image][..., ::-1])
        paths.append(recorder.path(f"images/{name}/{view.name}.png"))
        cv2.imwrite(paths[-1], image)
    return sorted(paths)


def _localize(recorder: Recorder, what: str, area, images: list[str], **settings: Any) -> None:
    """One run; positions are kept by image."""
    outputs = {key: recorder.path(f"fixes/{what}/{key}.gpkg") for key in ("OUTPUT", "FOOTPRINTS", "ALTERNATIVES")}
    recorder.run(what, "localizeimages", {"DATABASE": area.database, "IMAGES": images, **settings, **outputs})
    rows = dumps.layer_rows(outputs["OUTPUT"])
    recorder.put(what, {Path(row["image"]).stem: row for row in rows})
    recorder.put(f"{what}/columns", dumps.fields_of(outputs["OUTPUT"]))
    recorder.put_layer(f"{what}/footprints", outputs["FOOTPRINTS"])
    recorder.put_layer(f"{what}/alternatives", outputs["ALTERNATIVES"])


def _with_priors(recorder: Recorder, area, images: list[str]) -> None:
    """Something known before: right for some of the images, wrong for the others."""
    left, pixel, _, top, _, _ = area.geotransform()
    height, width = area.pixels().shape
    x, y = left + width / 2 * pixel, top - height / 2 * pixel
    place = {"PRIOR_POINT": f"{x},{y} [EPSG:{area.epsg()}]", "PRIOR_RADIUS": 0.25 * width * pixel}
    heading = {"PRIOR_HEADING": 120.0, "PRIOR_HEADING_RANGE": 90.0}
    scales = {"SCALE_MINIMUM": 0.75, "SCALE_MAXIMUM": 1.1}
    some = [path for path in images if "noisy" in path or "window" in path]
    _localize(recorder, f"{area.name} near, topology vector", area, some, METHOD=1, **place)
    _localize(recorder, f"{area.name} near, constellation", area, some, METHOD=2, **place)
    _localize(recorder, f"{area.name} heading, constellation", area, some, METHOD=2, **heading)
    _localize(recorder, f"{area.name} scales, constellation", area, some, METHOD=2, **scales)
    few = some[: 2 if recorder.quick else 12]
    _localize(recorder, f"{area.name} all known, automatic", area, few, METHOD=0, **place, **heading, **scales)
    _localize(recorder, f"{area.name} all known, map correlation", area, few, METHOD=3, **place, **heading, **scales)


def _with_attitude(recorder: Recorder, area, images: list[str]) -> None:
    """Leveled by a camera table with times; the same flight at a speed that makes jumps of most fixes."""
    kinds = {"tilted": len(images)}
    window, stride = (length / area.geotransform()[1] for length in (area.window, area.stride))
    views = cuts.plan(kinds, area.pixels().shape, window, stride, SIZES[area.name], 1671)
    lines = [f"{view.name}.png,{view.tilt[0]!r},{view.tilt[1]!r},{cuts.FIELD_OF_VIEW_DEG},{10 * n}"
             for n, view in enumerate(views)]  # fmt: skip
    table = recorder.path(f"fixes/{area.name}_cameras.csv")
    Path(table).write_text("\n".join(["image,roll,pitch,field_of_view,time", *lines, ""]), encoding="utf-8")
    more = {"ATTITUDE": table, "MAXIMUM_SPEED": 40.0}
    _localize(recorder, f"{area.name} leveled, constellation", area, images, METHOD=2, **more)
    _localize(recorder, f"{area.name} leveled, topology vector", area, images, METHOD=1, **more)
    if recorder.quick:
        return
    few = images[:6]
    _localize(recorder, f"{area.name} leveled, automatic", area, few, METHOD=0, **more)
    _localize(recorder, f"{area.name} leveled, map correlation", area, few, METHOD=3, **more)
