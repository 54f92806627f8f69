"""Label images that lie nowhere on the map, given to automatic: any fix is a wrong one.

In parts; a later run with the same --work and a larger --count goes on.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, partial

import cv2
import numpy as np

from bench import inputs, kept, page
from bench.correlation import BUILDINGS, ON_THE_MAP
from bench.elsewhere import LATTICE_KINDS, lattice, sample_area
from bench.ground import GOAL, REACH_PX, Ground, Image
from bench.tiles import tile_paths
from semref.core.evaluation.trial import Query, Trial
from semref.core.localization import Method
from semref.core.simulation.noise import STRONG, LabelNoise
from semref.core.simulation.views import PIXELS, View, cut, random_view

PAGE = "benchmarks.md"
SEED = 31_000
COUNT, QUICK_COUNT = 400, 2
EDGE_PX = 1280
SCALES = (0.4, 1.25)
FIELDS = (4, 5, 6)
"""Classes of the ground that lattices of plots lie on."""

AERIAL_CLASSES = {1: 1, 2: 2, 3: 7, 4: 6, 5: 3}
"""Those of aerial label maps, as those of the map that they look like."""

CUTS = (0.3, 0.4, 0.5, 0.6, 0.7)
STATUSES = ("fix", "ambiguous", "no_match", "too_few_references")
ONE_SIDE = "localization.one_side_elsewhere"


@dataclass(frozen=True)
class Source:
    """Ground that images are of, and the database that they are looked for in.

    Attributes:
        ground: the area's own
        known: the same with a database of its other half alone
        paths: aerial label maps
    """

    ground: Ground
    known: Ground
    paths: Sequence


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"elsewhere by automatic": "Not measured: the real data is not here."}
    cv2.setNumThreads(1)
    ground = Ground.of(run)
    source = Source(ground, ground.known_elsewhere(), tile_paths(run))
    rows, every = [], []
    for number, (kind, make) in enumerate(KINDS.items()):
        if not run.wants(kind) or make is _aerial and not source.paths:
            continue
        measured = partial(_part, source, make, number)
        found = kept.trials(run, "elsewhere_automatic", kind, run.how_many(COUNT, QUICK_COUNT), measured)
        if not found:
            continue
        every += [] if make is two_places else found
        rows.append(_row(kind, found))
        print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    rows.append(_row("all but those of two places", every))
    header = ["images", "fixes: all wrong", "of them by constellation, by map correlation", "ambiguous", "no match"]
    header += ["too few landmarks", "told to be of two places", "fixes that say for which part they don’t hold"]
    header += ["smallest risk told"]
    return {"elsewhere by automatic": f"{_ABOUT.format(half=run.half)}\n\n{page.table(header, rows)}"}


_ABOUT = """\
Automatic, label images of 1,280 px that lie nowhere on the map of Liechtenstein (where they are of the map, from its
{half}ern half, at any place), without any approximate position. “Poor network”: the strong noise of “map correlation”.
Goal: no fix for any of 3,000 (with none, the 95 % interval ends at 0.13 %); a fix needs a told risk of at most 1 in
10,000. Images of two places, cut at 0.3–0.7 of the edge, have half of a right place, which is counted as wrong, too."""


def _part(source: Source, make: Callable, number: int, part: int, size: int) -> list[Trial]:
    rng = np.random.default_rng([SEED, number, part])
    found = []
    for n in range(size):
        known, image = make(source, rng, part * kept.TRIALS_A_PART + n)
        found.append(known.try_image(image, Method.AUTOMATIC))
    return found


Made = tuple  # (Ground, Image)


def _landscape(source: Source, rng: np.random.Generator, number: int) -> Made:
    """Another landscape each part. The classes of the sample area have the values of the map's."""
    return source.ground, _view_of(sample_labels(SEED + number // kept.TRIALS_A_PART), rng)


@lru_cache(maxsize=1)
def sample_labels(seed: int) -> np.ndarray:
    """Labels of a made-up area."""
    return sample_area(seed)


def _aerial(source: Source, rng: np.random.Generator, number: int) -> Made:
    table = np.zeros(256, np.uint8)
    table[list(AERIAL_CLASSES)] = list(AERIAL_CLASSES.values())
    return source.ground, _view_of(table[inputs.read_labels(source.paths[number % len(source.paths)])], rng)


def _view_of(labels_hw: np.ndarray, rng: np.random.Generator) -> Image:
    """An image of a label map of pixels; what lies beside the map is cut away, so that images may be smaller."""
    height, width = labels_hw.shape
    edge = min(EDGE_PX, int(0.6 * min(height, width) / SCALES[0]))
    reach = 0.3
    extent = (reach * width, -(1 - reach) * height, (1 - reach) * width, -reach * height)
    view = random_view(rng, extent, (edge, edge), SCALES)
    return Image(Query(view, is_of_map=False), cut(labels_hw, PIXELS, view))


def _lattice(source: Source, rng: np.random.Generator, number: int) -> Made:
    """Plots in rows on two kinds of fields."""
    plots = lattice(rng, LATTICE_KINDS[number % len(LATTICE_KINDS)])
    first, second = rng.choice(FIELDS, 2, replace=False)
    y, x = np.mgrid[:EDGE_PX, :EDGE_PX]
    turn = rng.uniform(0, 2 * np.pi)
    beyond = (x - EDGE_PX / 2) * np.cos(turn) + (y - EDGE_PX / 2) * np.sin(turn) > rng.uniform(-300, 300)
    labels = np.where(beyond, second, first).astype(np.uint8)
    for (column, row), value, area in zip(plots.centers_xy, plots.classes, plots.areas_px):
        half = area**0.5 / 2
        left, top, right, bottom = (round(edge) for edge in (column - half, row - half, column + half, row + half))
        labels[max(top, 0) : max(bottom, 0), max(left, 0) : max(right, 0)] = value
    return source.ground, Image(Query(View(0.0, 0.0, 0.0, 1.0, EDGE_PX, EDGE_PX), is_of_map=False), labels)


def _mirrored(noise: LabelNoise, in_meters: bool, source: Source, rng: np.random.Generator, number: int) -> Made:
    image = source.ground.draw(replace(ON_THE_MAP, is_mirrored=True), rng)
    return source.ground, spoiled(source.ground, image, noise, in_meters, rng)


def _other_half(noise: LabelNoise, in_meters: bool, source: Source, rng: np.random.Generator, number: int) -> Made:
    image = source.ground.draw(ON_THE_MAP, rng, is_of_map=False)
    return source.known, spoiled(source.ground, image, noise, in_meters, rng)


def two_places(source: Source, rng: np.random.Generator, number: int) -> Made:
    """One side of an image of one place, the other of another."""
    ground = source.ground
    one = ground.draw(ON_THE_MAP, rng)
    scale = one.view.pixel_size / ground.frame.pixel_size
    other = ground.draw(replace(ON_THE_MAP, scales=(scale, scale)), rng)
    both, where = one.labels_hw.copy(), int(rng.choice(CUTS) * EDGE_PX)
    if rng.integers(2):
        both[:, where:] = other.labels_hw[:, where:]
    else:
        both[where:] = other.labels_hw[where:]
    image = replace(one, query=replace(one.query, is_of_map=False), labels_hw=both)
    return ground, spoiled(ground, image, GOAL, False, rng)


def spoiled(ground: Ground, image: Image, noise: LabelNoise, in_meters: bool, rng: np.random.Generator) -> Image:
    before = ground.spoiled_values
    ground.spoiled_values = BUILDINGS if in_meters else before
    try:
        return ground.spoiled(image, noise.in_pixels(image.view.pixel_size) if in_meters else noise, rng)
    finally:
        ground.spoiled_values = before


KINDS: dict[str, Callable[[Source, np.random.Generator, int], Made]] = {
    "made-up landscapes, another one each part": _landscape,
    "mirrored, 20 / 20 / 5 %": partial(_mirrored, GOAL, False),
    "mirrored, poor network": partial(_mirrored, STRONG, True),
    "regular lattices of plots on fields": _lattice,
    "aerial label maps of Dubai": _aerial,
    f"one half, 20 / 20 / 5 %, on a map that ends {REACH_PX:,} m from it": partial(_other_half, GOAL, False),
    f"one half, poor network, on a map that ends {REACH_PX:,} m from it": partial(_other_half, STRONG, True),
    "two places side by side, 20 / 20 / 5 %": two_places,
}


def _row(title: str, found: Sequence[Trial]) -> list[str]:
    statuses, fixes = Counter(t.status.key for t in found), [t for t in found if t.is_fix]
    roads = Counter(t.result.method for t in fixes)
    told = sum(t.result.reason is not None and ONE_SIDE in repr(t.result.reason) for t in found)
    risks = [t.result.risk for t in found if t.result.risk is not None]
    return [
        title,
        page.rate(len(fixes), len(found)),
        f"{roads[Method.CONSTELLATION]}, {roads[Method.MAP_CORRELATION]}",
        *(str(statuses[status]) for status in STATUSES[1:]),
        str(told),
        str(sum(t.result.reason is not None for t in fixes)),
        f"{min(risks, default=1.0):.2g}",
    ]
