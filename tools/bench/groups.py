"""Buildings found merged or split as evidence of the constellation: groups of them, on the map and in the image alike.

    .venv/bin/python tools/bench groups --model FOLDER [--count 20]

FOLDER is that of tools/training/train_photos.py. Buildings of map and image are joined where they are close (closing),
or taken where they are dense (blurred and cut at one half), before landmarks are made of both. What came out, and why
none of it is in the plugin: docs/decisions/photo-evidence.md.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import replace
from functools import partial

import cv2
import numpy as np

from bench import inputs, page, photo_places
from bench.ground import Image, cells, memory_ground
from bench.photos import SEED, TRUE_LABELS, Network, seen
from bench.real_places import (
    BUILDING,
    CLASSES,
    OTHER,
    PIXEL_M,
    SETTINGS,
    BuildingsNetwork,
    PlaceGround,
    ground_of,
    without,
)
from semref.core.localization import Method

PAGE = "benchmarks.md"
AREA = "banepa and oam_buildings."
SIZES_PX = (512,)
COUNT, QUICK_COUNT = 20, 1
COLUMNS = ("landmarks of", "labels", "right fixes", "wrong fixes", "no fix", "landmarks in view → found (medians)")


def as_they_are(labels_hw: np.ndarray) -> np.ndarray:
    """(H, W) uint8, nothing changed."""
    return labels_hw


def closed(labels_hw: np.ndarray, reach: int) -> np.ndarray:
    """(H, W) uint8: buildings less than twice ``reach`` pixels apart are one."""
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * reach + 1, 2 * reach + 1))
    joined = cv2.morphologyEx((labels_hw == BUILDING).view(np.uint8), cv2.MORPH_CLOSE, kernel)
    return _labels(joined > 0, labels_hw)


def opened(labels_hw: np.ndarray, reach: int) -> np.ndarray:
    """(H, W) uint8: buildings joined by less than twice ``reach`` pixels are apart."""
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * reach + 1, 2 * reach + 1))
    return _labels(cv2.morphologyEx((labels_hw == BUILDING).view(np.uint8), cv2.MORPH_OPEN, kernel) > 0, labels_hw)


def dense(labels_hw: np.ndarray, spread: float) -> np.ndarray:
    """(H, W) uint8: building is where, in a Gaussian of that standard deviation in pixels, half of the ground is."""
    share = cv2.GaussianBlur((labels_hw == BUILDING).astype(np.float32), (0, 0), spread)
    return _labels(share > 0.5, labels_hw)


def peaks(labels_hw: np.ndarray, spread: float) -> np.ndarray:
    """(H, W) uint8: building is where the density lies above that of the surroundings four times as wide."""
    mask = (labels_hw == BUILDING).astype(np.float32)
    near, wide = (cv2.GaussianBlur(mask, (0, 0), s) for s in (spread, 4 * spread))
    return _labels(near > wide + 0.15, labels_hw)


def _labels(is_building: np.ndarray, labels_hw: np.ndarray) -> np.ndarray:
    return np.where(labels_hw == 0, 0, np.where(is_building, BUILDING, OTHER)).astype(np.uint8)


KINDS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "buildings as they are": as_they_are,
    **{f"buildings joined within {2 * reach} px": partial(closed, reach=reach) for reach in (2, 4, 8, 16)},
    **{f"buildings parted at necks of {2 * reach} px": partial(opened, reach=reach) for reach in (4, 8)},
    **{f"dense ground, {spread} px": partial(dense, spread=spread) for spread in (4, 8, 16)},
    **{f"peaks of density, {spread} px": partial(peaks, spread=spread) for spread in (8, 16)},
}


def measure(run: inputs.Run) -> dict[str, str]:
    if not run.model or not run.model.is_dir():
        return {"groups": "Not measured: --model is no folder of train_photos.py."}
    drawn = [one for place in photo_places.PLACES for one in crops(run, place)]
    rows = []
    for name, kind in KINDS.items():
        if not run.wants(name):
            continue
        trials: dict[str, list] = {"network": [], TRUE_LABELS: []}
        for ground, pairs in drawn:
            changed = memory_ground(kind(ground.ground.labels_hw), CLASSES, SETTINGS, PIXEL_M)
            changed.prior = ground.ground.prior
            for source, number in (("network", 0), (TRUE_LABELS, 1)):
                for pair in pairs:
                    image = replace(pair[number], labels_hw=kind(pair[number].labels_hw))
                    trials[source].append(changed.try_image(image, Method.CONSTELLATION))
        for source, found in trials.items():
            row = cells(found, name)
            rows.append([name, source, *row[2:6]])
            print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    return {"groups": page.table(COLUMNS, rows)}


def crops(run: inputs.Run, place: photo_places.Place) -> list[tuple[PlaceGround, list[tuple[Image, Image]]]]:
    """Of each photo of a place its ground and crops: as the network sees them, and with true labels."""
    found = []
    for model in without(run.model, place.name):
        for number, photo in enumerate(place.photos):
            one = ground_of(run, photo)
            network: Network = BuildingsNetwork(model, one.ground)
            rng = np.random.default_rng([SEED, number])
            images = [i for edge in SIZES_PX for i in one.images(edge, run.how_many(COUNT, QUICK_COUNT), rng)]
            answers = [network.labels(seen(one.ground, one.picture, image.view)) for image in images]
            pairs = [(replace(image, labels_hw=labels), image) for image, labels in zip(images, answers)]
            if pairs:
                found.append((one, pairs))
    return found
