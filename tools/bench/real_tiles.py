"""Tiles of dubai_aerial by networks that were not trained on them: the part of ``photos`` that is about all of these.

``--model FOLDER`` holds networks named after the tiles that were left out: without_tile4.onnx, without_tiles25.onnx.
Beside each stands what the true labels of the same crops give, which no network can better. What a tile came to is kept
in --work (as a pickle: a folder of one's own): runs of single tiles (``--only "tile 2"``) are joined by a later one.
"""

from __future__ import annotations

import hashlib
import pickle
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from bench import inputs, kept, page
from bench.correlation import ON_A_TILE
from bench.evidence import why
from bench.ground import accuracy
from bench.photos import SEED, TRUE_LABELS, Network, agreement, as_seen, seen
from bench.tiles import tile_ground, tile_paths
from semref.core.evaluation.trial import Trial
from semref.core.localization import Method

SIZES_PX = (512, 640, 768)
COUNT, QUICK_COUNT = 25, 1
COLUMNS = (
    *("tile left out, crops, labels", "right fixes", "wrong fixes", "why no fix"),
    *("median error, heading, scale", "in the 95 % radius"),
)
WITHOUT = "without_tile"


def networks(folder: Path) -> dict[int, Path]:
    """Of each tile that was left out of a network's training, that network."""
    paths = sorted(folder.glob(f"{WITHOUT}*.onnx"))
    return {int(n): path for path in paths for n in path.stem.removeprefix(WITHOUT).removeprefix("s")}


def measured(run: inputs.Run) -> str:
    """Tables of fixes and of agreement, by tile and by size of crop."""
    trials: Found = {}
    agreed = []
    for path in tile_paths(run):
        number = int(path.stem.removeprefix("tile").partition("_")[0])
        model = networks(run.model).get(number)
        if model is None or not run.wants(f"tile {number}"):
            continue
        found, row = _kept(run, path, number, model)
        agreed.append(row)
        for key, some in found.items():
            trials.setdefault(key, []).extend(some)
            print("  " + " | ".join(_row(", ".join(key), some)), file=sys.stderr, flush=True)
    if not agreed:
        return f"Not measured: there is no {WITHOUT}N.onnx in {run.model.name}."
    rows = [_row(f"{case}, {source}", found) for (case, source), found in sorted(trials.items())]
    header = ["tile left out, network", *ALL, "mean", "pixels right"]
    sizes = ", ".join(map(str, SIZES_PX))
    return f"{_ABOUT.format(sizes=sizes)}\n\n{page.table(COLUMNS, rows)}\n\n{page.table(header, agreed)}"


ALL = [f"IoU {line.split(',')[1]}" for line in inputs.TILE_CLASSES.strip().split("\n")[1:]]
_ABOUT = """\
Each tile of dubai_aerial by a network that was trained without it: off-grid, turned crops of {sizes} px at 0.9–1.1 of
the tile's pixels, pixel size searched over 0.7–1.4, method automatic; database of the annotated labels, all classes as
landmarks; errors in pixels. Right: within 2 % of the edge. “true labels”: what no network could improve; what is
missing there the ground, or its annotation, does not allow."""


Found = dict[tuple[str, str], list[Trial]]
"""Trials by (case, source of the labels)."""


def _kept(run: inputs.Run, path: Path, number: int, model: Path) -> tuple[Found, list[str]]:
    """What ``_tile`` gives, measured unless this state of the code has done so with this network."""
    count, network = run.how_many(COUNT, QUICK_COUNT), hashlib.sha256(model.read_bytes()).hexdigest()[:8]
    file = run.work / f"real_tile_{number}_{count}_{network}_{kept.state(kept.OF_ALL)}.pickle"
    if not file.exists():
        file.write_bytes(pickle.dumps(_tile(path, number, model, count)))
    return pickle.loads(file.read_bytes())


def _tile(path: Path, number: int, model: Path, count: int) -> tuple[Found, list[str]]:
    """Crops of a tile, localized; how well its labels are found."""
    trials: Found = {}
    ground = tile_ground(path)
    picture = np.ascontiguousarray(np.moveaxis(inputs.read_labels(str(path).replace("_label", "_image"))[:3], 0, 2))
    network = Network(model, ground)
    ground.localizer.heed_biases(*network.biases)
    for edge in SIZES_PX:
        rng = np.random.default_rng([SEED, number, edge])
        for _ in range(count):
            image = ground.draw(replace(ON_A_TILE, sizes_px=(edge,), labeled=0.0), rng)
            shown = as_seen(image, network.seen(seen(ground, picture, image.view)))
            for source, given in (("network", shown), (TRUE_LABELS, image)):
                found = ground.try_image(given, Method.AUTOMATIC)
                for case in (f"tile {number}", f"{edge} px, all tiles", "all"):
                    trials.setdefault((case, source), []).append(found)
    iou, right = agreement(ground, ground.labels_hw, network.labels(picture))
    return trials, [f"{number}, {model.stem}", *(f"{v:.3f}" for v in iou), f"{np.mean(iou):.3f}", f"{right:.1%}"]


def _row(name: str, trials: Sequence[Trial]) -> list[str]:
    right, total = [trial for trial in trials if trial.is_right], len(trials)
    reasons = Counter(why(trial) for trial in trials if not trial.is_fix)
    return [
        name,
        page.rate(len(right), total),
        page.rate(sum(trial.is_wrong for trial in trials), total),
        ", ".join(f"{count} {reason}" for reason, count in reasons.most_common()) or "–",
        *accuracy(right),
    ]
