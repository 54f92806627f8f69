"""Does a network tell that it does not know a ground: by tiles that contradict each other, or by how sure it is?

    .venv/bin/python tools/bench foreign_ground --model FOLDER [--count 2] [--work FOLDER]

FOLDER holds networks of tools/training (train_dubai.py: without_tile4.onnx; train_photos.py:
buildings_without_kenya.onnx); the one that ships is measured as well. Each looks at pieces of all grounds in tiles that
overlap as those of Segment image do, and at a tile in the middle of them.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bench import inputs, page, photo_places
from bench.photos import SHIPPED, sample_ground
from semref.core.segmentation.model import SegmentationModel

PAGE = "benchmarks.md"
AREA = "dubai_aerial, banepa, oam_buildings, naip_north_dakota and the sample area."
SEED = 15_005
COUNT, QUICK_COUNT = 2, 1
PIECE_PX = 947
"""Two tiles of 512 that overlap by 15 %."""

PIXEL_M = 0.25
OWN, LEFT_OUT, FOREIGN = "trained on", "left out", "foreign"
SAMPLE, DUBAI = "sample", "dubai"
COLUMNS = ("network", "ground", "changes where tiles overlap", "changes to a tile in the middle", "sure of its labels")


@dataclass(frozen=True)
class Seen:
    """Of one network and ground: shares of pixels whose class changes, and the mean probability of the best class."""

    kind: str
    overlap: float
    middle: float
    sure: float


def measure(run: inputs.Run) -> dict[str, str]:
    if not run.model or not run.model.is_dir():
        return {"foreign ground": "Not measured: --model is no folder of networks."}
    scenes = list(grounds(run))
    rows, summary = [], []
    for path in [SHIPPED, *sorted(run.model.rglob("*.onnx"))]:
        if not run.wants(path.stem):
            continue
        found = {
            name: looked_at(run, SegmentationModel(str(path), 1), kind_of(path.stem, name), photo)
            for name, photo in scenes
            if min(photo.shape[:2]) > 512
        }
        for name, one in found.items():
            rows.append([path.stem, f"{name}, {one.kind}", *(f"{v:.1%}" for v in (one.overlap, one.middle, one.sure))])
            print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
        summary.append([path.stem, *(told_apart(list(found.values()), m, s) for m, s in MEASURES)])
    header = ["network", *(f"told apart by {name}" for name in ("overlaps", "a tile in the middle", "being sure"))]
    return {"foreign ground": f"{page.table(header, summary)}\n\n{page.table(COLUMNS, rows)}"}


MEASURES = (("overlap", 1), ("middle", 1), ("sure", -1))


def told_apart(found: list[Seen], measure: str, sign: int) -> str:
    """Share of pairs of a foreign ground and one trained on in which the foreign one has more of the measure."""
    own, foreign = ([sign * getattr(s, measure) for s in found if s.kind == kind] for kind in (OWN, FOREIGN))
    pairs = [f > o for f in foreign for o in own]
    return f"{np.mean(pairs):.0%} of {len(pairs)} pairs" if pairs else "–"


def kind_of(network: str, ground: str) -> str:
    """What a ground is to a network, by their names."""
    place = DUBAI if ground.startswith(DUBAI) else ground
    known = {"sample": {SAMPLE}, "without": {DUBAI}, "photos": {DUBAI, *PLACE_NAMES}, "buildings": set(PLACE_NAMES)}
    left_out = network.partition("without_")[2]
    if place == DUBAI and any(f"tile{n}" == left_out or n in left_out.removeprefix("tiles") for n in ground[-1:]):
        return LEFT_OUT
    if place in left_out.split("_and_"):
        return LEFT_OUT
    return OWN if place in known.get(network.split("_")[0], ()) else FOREIGN


PLACE_NAMES = tuple(place.name for place in photo_places.PLACES if place.name != DUBAI)


def grounds(run: inputs.Run) -> Iterator[tuple[str, np.ndarray]]:
    """Names and photos (H, W, 3)."""
    yield SAMPLE, sample_ground()[1]
    for place in photo_places.PLACES:
        for number, photo in enumerate(place.photos, start=1):
            image, _ = photo_places.prepared(photo, run.data, PIXEL_M, run.work / "places")
            yield f"{DUBAI}{number}" if place.name == DUBAI else place.name, pixels(image)
    yield "north_dakota", pixels(run.data / "naip_north_dakota" / "m_4709963_se_14_1_20190904.tif")


def pixels(path: Path) -> np.ndarray:
    """(H, W, 3) uint8."""
    return np.ascontiguousarray(np.moveaxis(inputs.read_labels(path)[:3], 0, 2))


def looked_at(run: inputs.Run, model: SegmentationModel, kind: str, photo_hw3: np.ndarray) -> Seen:
    """Means over pieces of the photo."""
    edge = min(PIECE_PX, *photo_hw3.shape[:2])
    rng, found = np.random.default_rng(SEED), []
    while len(found) < run.how_many(COUNT, QUICK_COUNT):
        row, column = (int(rng.integers(0, size - edge + 1)) for size in photo_hw3.shape[:2])
        found.append(piece_seen(model, photo_hw3[row : row + edge, column : column + edge]))
    return Seen(kind, *np.mean(found, axis=0))


def piece_seen(model: SegmentationModel, piece_hw3: np.ndarray) -> tuple[float, float, float]:
    """Shares that change in the overlaps of four corner tiles, and to the tile in their middle; how sure they are."""
    tile, apart = model.tile_hw[0], len(piece_hw3) - model.tile_hw[0]
    shared, half = tile - apart, apart // 2
    starts = ((0, 0), (0, apart), (apart, 0), (apart, apart), (half, half))
    parts = [np.ascontiguousarray(piece_hw3[r : r + tile, c : c + tile]) for r, c in starts]
    looks = [model.probabilities(model.scores([part])[0]) for part in parts]
    a, b, c, d, middle = (look.argmax(axis=0) for look in looks)
    overlaps = (
        a[:, apart:] != b[:, :shared],
        c[:, apart:] != d[:, :shared],
        a[apart:] != c[:shared],
        b[apart:] != d[:shared],
    )
    end = apart - half
    moved = (
        a[half:, half:] != middle[: tile - half, : tile - half],
        d[: tile - end, : tile - end] != middle[end:, end:],
    )
    sure = np.mean([look.max(axis=0).mean() for look in looks])
    return np.concatenate([o.ravel() for o in overlaps]).mean(), np.mean([m.mean() for m in moved]), sure
