"""What map correlation's evidence from a photo is worth: the labels alone, or the scores of the network.

    .venv/bin/python tools/bench evidence --model MODEL --tile N [--count 25] [--write]

MODEL was not trained on tile N of dubai_aerial and states its `temperature`, as training writes it. All kinds of
evidence judge the same crops, and crops that are wrong by construction: mirrored, and looked for on another tile. “four
turns”: scores are the means of four looks at the crop turned by right angles, each of them a run of the network.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from bench import inputs, page
from bench.correlation import ON_A_TILE, best_right, place_is_right
from bench.ground import Ground, Image, accuracy, milliseconds
from bench.photos import Network, as_seen, seen
from bench.tiles import tile_ground, tile_paths
from semref.core.evaluation.trial import Trial
from semref.core.labels.class_shares import SeenLabels
from semref.core.localization import Method
from semref.core.sentences import Sentence

PAGE = "benchmarks.md"
AREA = "dubai_aerial."
SEED = 15_002
COUNT, QUICK_COUNT = 25, 1
SIZES_PX = (512, 640, 768)
LIKELY = 0.1
COLUMNS = (
    "evidence, crops",
    "right fixes",
    "wrong fixes",
    "best place right, fix or not",
    "why no fix",
    "told risk of wrong best places: least, below 1 in 10",
    "median error, heading, scale",
    "in the 95 % radius",
    "ms median, p95",
)
Evidence = Callable[[Image], Image]
KINDS: dict[str, Evidence] = {
    "labels alone": lambda image: replace(image, shares=None),
    "scores": lambda image: image,
}
TURNED = "scores of four turns"


def measure(run: inputs.Run) -> dict[str, str]:
    paths = tile_paths(run)
    path = next((path for path in paths if path.stem == f"tile{run.tile}_label"), None)
    if path is None or not run.model:
        return {"evidence of photos": "Not measured: there is no --model, or the real data is not here."}
    ground = tile_ground(path)
    other = tile_ground(paths[(paths.index(path) + 1) % len(paths)])
    picture = np.ascontiguousarray(np.moveaxis(inputs.read_labels(str(path).replace("_label", "_image"))[:3], 0, 2))
    network = Network(run.model, ground)
    for one in (ground, other):
        one.localizer.heed_biases(*network.biases)
    rows = []
    for name in (*KINDS, TURNED):
        if not run.wants(name):
            continue
        kind = KINDS.get(name, KINDS["scores"])
        crops = drawn(run, ground, picture, network.seen_in_turns if name == TURNED else network.seen)
        own = {edge: [ground.try_image(kind(image), Method.MAP_CORRELATION) for image in some] for edge, some in crops}
        rows += [line(f"{name}, {edge} px", trials) for edge, trials in own.items()]
        rows.append(line(f"{name}, all", [trial for trials in own.values() for trial in trials]))
        rows.append(line(f"{name}, wrong by construction", nulls(ground, other, kind, crops)))
        for row in rows[-len(crops) - 2 :]:
            print("  " + " | ".join(row), file=sys.stderr, flush=True)
    return {
        "evidence of photos": f"{_ABOUT.format(model=run.model.name, tile=run.tile)}\n\n{page.table(COLUMNS, rows)}"
    }


_ABOUT = """\
`{model}` on tile {tile} of dubai_aerial, which it was not trained on: off-grid, turned crops at 0.9–1.1 of the tile's
pixels, pixel size searched over 0.7–1.4, map correlation alone; database of the annotated labels; errors in pixels.
Right: within 2 % of the edge. Wrong by construction: the same crops mirrored, and looked for in the next tile's
database; any fix of these is wrong."""


def drawn(
    run: inputs.Run, ground: Ground, picture: np.ndarray, look: Callable[[np.ndarray], SeenLabels]
) -> list[tuple[int, list[Image]]]:
    """Crops of each size, as they are seen; always the same ones."""
    found = []
    for edge in SIZES_PX:
        rng = np.random.default_rng([SEED, run.tile, edge])
        wanted = replace(ON_A_TILE, sizes_px=(edge,), labeled=0.0)
        images = [ground.draw(wanted, rng) for _ in range(run.how_many(COUNT, QUICK_COUNT))]
        found.append((edge, [as_seen(image, look(seen(ground, picture, image.view))) for image in images]))
    return found


def nulls(ground: Ground, other: Ground, kind: Evidence, crops: Sequence[tuple[int, list[Image]]]) -> list[Trial]:
    """Crops whose every fix is wrong."""
    images = [replace(kind(i), query=replace(i.query, is_of_map=False)) for _, some in crops for i in some]
    mirrored = [ground.try_image(as_mirrored(image), Method.MAP_CORRELATION) for image in images]
    return mirrored + [other.try_image(image, Method.MAP_CORRELATION) for image in images]


def as_mirrored(image: Image) -> Image:
    """Left and right exchanged."""
    shares = image.shares
    if shares is not None:
        shares = replace(shares, shares=np.ascontiguousarray(shares.shares[:, ::-1]))
    return replace(image, labels_hw=np.ascontiguousarray(image.labels_hw[:, ::-1]), shares=shares)


def line(name: str, trials: Sequence[Trial]) -> list[str]:
    """A row with COLUMNS."""
    right, total = [trial for trial in trials if trial.is_right], len(trials)
    can_be_right = any(trial.query.can_be_right for trial in trials)
    reasons = Counter(why(trial) for trial in trials if not trial.is_fix)
    return [
        name,
        page.rate(len(right), total) if can_be_right else "–",
        page.rate(sum(trial.is_wrong for trial in trials), total),
        best_right(trials) if can_be_right else "–",
        ", ".join(f"{count} {reason}" for reason, count in reasons.most_common()) or "–",
        told(trials),
        *accuracy(right),
        milliseconds(trials),
    ]


def told(trials: Sequence[Trial]) -> str:
    """What is said of best places that are wrong."""
    wrong = [t for t in trials if not (t.query.can_be_right and place_is_right(t)) and t.result.risk is not None]
    risks = [t.result.risk for t in wrong]
    return f"{min(risks):.2g}, {sum(risk < LIKELY for risk in risks)} of {len(risks)}" if risks else "–"


def why(trial: Trial) -> str:
    """Code of the reason that there is no fix, without what was searched."""
    reason = trial.result.reason
    while reason is not None:
        # Of both roads of automatic that of map correlation: constellations find no photos of real places.
        inner = [dict(reason.values).get(name) for name in ("correlation", "reason")]
        inner = [one for one in inner if isinstance(one, Sentence)]
        if not inner:
            break
        reason = inner[0]
    return str(trial.result.status) if reason is None else reason.code.split(".")[-1].replace("_", " ")
