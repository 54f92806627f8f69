"""Small seeded land-cover layers with known truth: features as `core` takes them."""

import numpy as np
import shapely

from semref.core.annotation.polygons import AnnotatedFeature

WEST, SOUTH = 550_000.0, 5_220_000.0


def feature(geometry, class_value: int = 1, priority: float = 0.0, feature_id: int = 0) -> AnnotatedFeature:
    """Return a feature; ``geometry`` counts from WEST, SOUTH; None is a missing geometry."""
    if geometry is None:
        return AnnotatedFeature(feature_id, None, class_value, priority)
    return AnnotatedFeature(feature_id, shapely.to_wkb(moved(geometry)), class_value, priority)


def moved(geometry):
    return shapely.transform(geometry, lambda xy: xy + (WEST, SOUTH))


def square(x: float, y: float, size: float):
    return shapely.box(x, y, x + size, y + size)


def numbered(features) -> list:
    """Return the same features with ids 0, 1, 2, …"""
    return [AnnotatedFeature(n, f.wkb, f.class_value, f.priority) for n, f in enumerate(features)]


def random_features(kind: str, seed: int, count: int = 25) -> list:
    """Return features of classes 1 to 4 that overlap, touch and cross themselves.

    kind: "stars" anywhere, "bowties" that cross themselves, "blocks" with corners on whole meters, "shaken" blocks
    with edges up to 10 µm apart, "strips" thinner than a gap that counts, "stacked" equal ones.
    """
    random = np.random.default_rng(seed)
    made = []
    for _ in range(count):
        made.append(feature(_SHAPES[kind](random), int(random.integers(1, 5)), float(random.integers(0, 3))))
    return numbered(made)


def _star(random):
    corners = int(random.integers(3, 12))
    angles = np.sort(random.uniform(0, 2 * np.pi, corners))
    radii = random.uniform(1, 15, corners)
    corners = np.column_stack([np.cos(angles), np.sin(angles)]) * radii[:, None]
    return shapely.polygons(random.uniform(0, 60, 2) + corners)


def _bow(random):
    return shapely.polygons(random.uniform(0, 50, 2) + random.uniform(0, 15, (int(random.integers(4, 9)), 2)))


def _block(random):
    x, y = random.integers(0, 20, 2)
    width, height = random.integers(1, 8, 2)
    return shapely.box(x, y, x + width, y + height)


def _shaken(random):
    corners = shapely.get_coordinates(_block(random))[:-1]
    return shapely.polygons(corners + random.uniform(-1e-5, 1e-5, corners.shape))


def _strip(random):
    line = shapely.linestrings(random.uniform(0, 30, (2, 2)))
    return shapely.buffer(line, float(random.choice([0.05, 0.2, 2.0])), cap_style="flat")


def _stacked(random):
    return square(*(4.0 * random.integers(0, 4, 2)), 5.0)


_SHAPES = {"stars": _star, "bowties": _bow, "blocks": _block, "shaken": _shaken, "strips": _strip, "stacked": _stacked}
KINDS = tuple(_SHAPES)
