"""Onboard files, whole and clipped, and what `python -m core` finds with them."""

from __future__ import annotations

import json
from typing import Any

import cv2

from . import cuts, dumps
from .areas import write_geojson
from .labels import MODEL
from .recorder import Recorder

COUNTS = {"clean": 6, "noisy": 14, "spoiled": 8, "window": 4, "poor": 4, "mirrored": 4}
QUICK_COUNTS = {"clean": 2, "noisy": 4, "window": 2, "poor": 1, "mirrored": 1}
METHODS = {"automatic": 12, "constellation": 40, "topology-vector": 40, "map-correlation": 4}
"""Methods of the command line, with the number of images."""


def record(recorder: Recorder, places: dict[str, Any]) -> None:
    """Records files and fixes."""
    for name in ("sample", "liechtenstein", "christchurch"):
        if name in places:
            _export(recorder, name, places[name], {})
    sample = places["sample"]
    left, pixel, _, top, _, _ = sample.geotransform()
    route = recorder.path("onboard/route.geojson")
    line = f"{left + 900 * pixel} {top - 900 * pixel}, {left + 2100 * pixel} {top - 1700 * pixel}"
    write_geojson(route, f"LINESTRING({line})", sample.epsg())
    _export(recorder, "clipped", sample, {"CLIP": route, "DISTANCE": 500, "PRECISION": 0.5})
    _export(recorder, "small", sample, {"OVERVIEW": False, "PRECISION": 0.001})
    for name in ("sample", "clipped", "small"):
        path = recorder.path(f"onboard/{name}.npz")
        recorder.put(f"info/{name}", json.loads("".join(recorder.command(["info", path, "--json"])["out"])))
    recorder.put("info/text", [line for line in recorder.command(["info", path])["out"] if "version" not in line])
    _localize(recorder, sample)


def _export(recorder: Recorder, name: str, area, settings: dict[str, Any]) -> None:
    output = recorder.path(f"onboard/{name}.npz")
    recorder.run(f"file/{name}", "exportonboard", {"DATABASE": area.database, **settings, "OUTPUT": output})
    header, members = dumps.onboard_file(output)
    recorder.put(f"file/{name}", header)
    for member, array in members.items():
        recorder.put_array(f"file/{name}/{member}", array)


def _localize(recorder: Recorder, sample) -> None:
    labels, references = sample.pixels(), sample.reference_values()
    pixel = sample.geotransform()[1]
    counts = QUICK_COUNTS if recorder.quick else COUNTS
    images = []
    for view in cuts.plan(counts, labels.shape, sample.window / pixel, sample.stride / pixel, 512, 9):
        images.append(recorder.path(f"onboard/images/{view.name}.png"))
        cv2.imwrite(images[-1], cuts.cut(labels, view, references))
    whole, small = recorder.path("onboard/sample.npz"), recorder.path("onboard/small.npz")
    # A few of each kind rather than many of the first.
    mixed = sorted(images, key=lambda path: (path[-6:], path))
    for method, count in METHODS.items():
        found = recorder.command(["localize", *mixed[:count], "--database", whole, "--method", method, "--json"])
        _put(recorder, f"localized/{method}", found)
    left, _, _, top, _, _ = sample.geotransform()
    near = [str(left + 2000 * pixel), str(top - 1500 * pixel), "900"]
    arguments = ["localize", *mixed, "--database", small, "--method", "constellation", "--near", *near]
    _put(recorder, "localized/near", recorder.command([*arguments, "--json"]))
    recorder.put("localized/as text", recorder.command(arguments)["out"])
    photos = [recorder.path("sample/photos")]
    arguments = ["localize", *photos, "--database", whole, "--model", str(recorder.repository / MODEL), "--json"]
    _put(recorder, "localized/photos", recorder.command(arguments))
    arguments = ["watch", recorder.path("onboard/images"), "--database", small, "--method", "constellation", "--once"]
    found = recorder.command([*arguments, "--fixes", recorder.path("onboard/fixes.jsonl")])
    recorder.put("watched/status", [found["status"], found["err"]])
    with open(recorder.path("onboard/fixes.jsonl"), encoding="utf-8") as file:
        recorder.put("watched", _by_image(file.read().splitlines()))


def _put(recorder: Recorder, what: str, found: dict[str, Any]) -> None:
    recorder.put(what, _by_image(found["out"]))
    recorder.put(f"{what}/status", [found["status"], found["err"]])


def _by_image(lines: list[str]) -> dict[str, Any]:
    rows = [json.loads(line) for line in lines]
    return {row["image"]: row for row in rows}
