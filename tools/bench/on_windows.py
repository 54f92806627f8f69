"""Images cut exactly on windows: as files through semref:localizeimages, and through core, which must agree."""

from __future__ import annotations

import cv2
import numpy as np

from bench import inputs, plugin
from bench.ground import Ground
from bench.page import share


def measure(run: inputs.Run, ground: Ground, windows: np.ndarray) -> str:
    folder = run.work / "on_windows"
    folder.mkdir(exist_ok=True)
    names = [str(ground.database.windows.names[window]) for window in windows]
    pictures = [ground.cut(ground.view_on(window)) for window in windows]
    for name, picture in zip(names, pictures):
        cv2.imwrite(str(folder / f"{name}.png"), picture)
    output = folder / "positions.gpkg"
    parameters = {"DATABASE": str(run.database(run.area.stride)), "IMAGES": str(folder), "METHOD": 1}
    plugin.run_algorithm("localizeimages", {**parameters, "OUTPUT": str(output)})
    rows = _rows(output)
    found = [rows[f"{name}.png"] for name in names]
    same = [_same(row, ground.localizer.localize_by_topology_vector(p)) for row, p in zip(found, pictures)]
    same_pixels = [np.array_equal(p, _window_labels(ground, w)) for p, w in zip(pictures, windows)]
    right = [row["window"] == name for row, name in zip(found, names)]
    twins = [row["window"] for row, ok in zip(found, right) if not ok]
    distances = [row["distance"] for row in found]
    confidences = [row["confidence"] for row in found]
    return _TEXT.format(
        number=len(windows),
        found=share(sum(right), len(right)),
        instead=f" (instead: {', '.join(map(str, twins))})" if twins else "",
        distance=f"median {np.median(distances):.1e}, largest {max(distances):.1e}",
        confidence=f"median {np.median(confidences):.6f}, smallest {min(confidences):.6f}",
        pixels=sum(same_pixels),
        same=sum(same),
    )


_TEXT = """\
{number} windows as PNG files through `semref:localizeimages`, METHOD 1: own window found {found}{instead}; distance
{distance}; confidence {confidence}. {pixels} of the files hold exactly the window's pixels. The same images handed to
`core` directly gave the same status, window, distance and confidence for {same} of {number}, so the tables below were
made that way."""


def _rows(output) -> dict[str, dict]:
    """Rows of the positions layer by the image's file name."""
    from osgeo import ogr

    dataset = ogr.Open(str(output))
    names = ("status", "window", "distance", "confidence")
    return {
        feature.GetField("image").rpartition("/")[2]: {name: feature.GetField(name) for name in names}
        for feature in dataset.GetLayer(0)
    }


def _same(row: dict, result) -> bool:
    return (row["status"], row["window"]) == (result.status, result.window) and (
        abs(row["distance"] - result.distance) < 1e-9 and abs(row["confidence"] - result.confidence) < 1e-9
    )


def _window_labels(ground: Ground, window: int) -> np.ndarray:
    column, row = ground.database.windows.first_pixels[window]
    return ground.labels_hw[row : row + ground.size_px, column : column + ground.size_px]
