"""A made town and its images, for tests of the constellation."""

import numpy as np

from semref.core.constellation.index import build_index
from semref.core.constellation.solver import localize
from semref.core.database.model import MapLandmarks
from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks.landmarks import extract_landmarks
from semref.core.localization import Prior
from semref.core.simulation.landmark_errors import spoil_landmarks
from semref.core.simulation.noise import LabelNoise
from semref.core.simulation.views import PIXELS, View, cut

SIZE = 640
CLASSES = (1, 2, 3)
ORIGIN = (500_000.0, 5_200_000.0)
PRIOR = Prior(pixel_size_range=(0.4, 2.5))
NOISE = LabelNoise(missed=0.2, spurious=0.2, mislabeled=0.05, center=1.0, log_area=0.1)


def town(seed, size=3000, count=2500):
    """Return (size, size) uint8 labels of houses in clusters, with a few fields and ponds."""
    rng = np.random.default_rng(seed)
    labels = np.zeros((size, size), np.uint8)
    centers = rng.uniform(0, size, (40, 2))
    for _ in range(count):
        x, y = centers[rng.integers(40)] + rng.normal(0, 220, 2)
        value = rng.choice(CLASSES, p=(0.85, 0.1, 0.05))
        width, height = rng.uniform(8, 30, 2) * (1 if value == 1 else 1.8)
        left, top, right, bottom = (int(v) for v in (x, y, x + width, y + height))
        if min(left, top) < 2 or max(right, bottom) > size - 2:
            continue
        if not labels[top - 2 : bottom + 2, left - 2 : right + 2].any():
            labels[top:bottom, left:right] = value
    return labels


class Ground:
    def __init__(self, labels):
        self.source = ArrayLabels(labels)
        self.objects = seen = extract_landmarks(labels, CLASSES, 80)
        positions = seen.centers_xy * (1, -1) + ORIGIN
        self.references = MapLandmarks(positions, seen.classes, seen.areas_px, seen.touches_edge)
        self.index = build_index(self.references, 1.0)

    def see(self, view, noise=None, seed=0):
        objects = extract_landmarks(cut(self.source, PIXELS, view), CLASSES, 12)
        if noise is None:
            return objects
        return spoil_landmarks(objects, noise, np.random.default_rng(seed), objects, (SIZE, SIZE))


def seen_from(column, row, heading=0.0, scale=1.0):
    return View(column, -row, heading, scale, SIZE, SIZE)


def solve(ground, objects, prior=PRIOR):
    return localize(objects, (SIZE, SIZE), ground.index, prior)


def error(result, view):
    return np.hypot(*(np.subtract(result.best.position, ORIGIN) - view.position))
