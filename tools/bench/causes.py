"""Why turned and scaled images of a window are taken for another one: which of the kept landmarks changed, and how."""

from __future__ import annotations

import numpy as np

from bench import page
from bench.ground import Ground
from bench.page import share
from semref.core.simulation.views import View, image_coordinates, map_coordinates

CASES = (
    ("rotation 30°", 30, 1.0),
    ("rotation 60°", 60, 1.0),
    ("view radius 1.2 ×", 0, 1.2),
    ("view radius 0.8 ×", 0, 0.8),
    ("view radius 1.5 ×", 0, 1.5),
    ("view radius 0.65 ×", 0, 0.65),
)

SAME_WITHIN_M = 4.0
"""Centers of one object in two pictures differ by less than this, unless the object itself changed."""

NEAR_THRESHOLD = 1.6
"""Objects up to this many times the larger of both minimum areas may fall below it when pixels or the view change."""

BORDER, THRESHOLD, OTHER, SAME = (
    "object cut by a border",
    "object near the minimum area",
    "object merged, split or else",
    "same objects",
)


def measure(ground: Ground, windows: np.ndarray) -> str:
    rows = []
    for title, heading, scale in CASES:
        reasons = []
        for window in windows:
            view = ground.view_on(window, heading, scale)
            if not ground.try_vector(view).is_right:
                reasons.append(_reasons(ground, ground.view_on(window), view))
        wrong = len(reasons)
        row = [title, share(wrong, len(windows))]
        row += [sum(reason in found for found in reasons) for reason in (THRESHOLD, BORDER, OTHER, SAME)]
        rows.append(row)
    header = ["", "not the right window", THRESHOLD, BORDER, OTHER, SAME]
    return page.table(header, rows)


def _reasons(ground: Ground, window: View, view: View) -> set[str]:
    """What differs between the landmarks kept for a window's vector and for a view of it; several may hold."""
    first, second = (_kept(ground, v) for v in (window, view))
    found = set()
    least = NEAR_THRESHOLD * max(first["least"], second["least"])
    for one, other in ((first, second), (second, first)):
        for k in range(len(one["classes"])):
            near = np.hypot(*(other["places"] - one["places"][k]).T) <= SAME_WITHIN_M
            if (near & (other["classes"] == one["classes"][k])).any():
                continue
            if one["touches"][k] or _leaves(ground, view if one is first else window, one["corners"][k]):
                found.add(BORDER)
            elif one["areas"][k] < least:
                found.add(THRESHOLD)
            elif not _kept_elsewhere(ground, view if one is first else window, one, k):
                found.add(OTHER)
    return found or {SAME}


def _kept(ground: Ground, view: View, everything: bool = False) -> dict:
    """The objects nearest to a view's center, in map units: places, corners of boxes, classes, areas, touches."""
    described = ground.localizer.describe(ground.cut(view), ground.database.parameters.window_size)
    objects = described.objects
    if not everything:
        away = np.hypot(*(objects.centers_xy - ground.size_px / 2).T)
        objects = objects.select(np.argsort(away, kind="stable")[: ground.database.parameters.references_per_vector])
    corners = objects.bounds[:, [[0, 1], [2, 1], [2, 3], [0, 3]]]
    return {
        "places": _on_map(view, objects.centers_xy),
        "corners": _on_map(view, corners),
        "classes": objects.classes,
        "areas": objects.areas_px * view.pixel_size**2,
        "touches": objects.touches_edge,
        "least": ground.database.parameters.minimum_area * (view.pixel_size / ground.frame.pixel_size) ** 2,
    }


def _on_map(view: View, points: np.ndarray) -> np.ndarray:
    """Map coordinates (…, 2) of pixel coordinates (…, 2)."""
    return np.stack(map_coordinates(view, points[..., 0], points[..., 1]), axis=-1)


def _leaves(ground: Ground, view: View, corners: np.ndarray) -> bool:
    """Whether an object with these corners (4, 2) of its box, map coordinates, reaches over the border of a view."""
    inside = np.abs(image_coordinates(view, corners) - ground.size_px / 2) <= ground.size_px / 2
    return not inside.all()


def _kept_elsewhere(ground: Ground, view: View, one: dict, k: int) -> bool:
    """Whether the object is there in the other picture too and was only pushed out of the kept ones by another."""
    other = _kept(ground, view, everything=True)
    near = np.hypot(*(other["places"] - one["places"][k]).T) <= SAME_WITHIN_M
    return bool((near & (other["classes"] == one["classes"][k])).any())
