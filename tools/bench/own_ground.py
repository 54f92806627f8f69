"""A network trained on one half of a place for some minutes, flown over the other half: what minutes buy.

    .venv/bin/python tools/bench own_ground --python PYTHON_WITH_TORCH [--count 50] [--only "Lite0 for 10"] [--write]

The western half of an aerial mosaic with its annotated labels (dubai_aerial) is cut into tiles as semref:trainmodel
cuts them; its training runs for so many minutes of one processor, whatever else the machine does. Crops lie wholly
on the eastern half, the database is of the whole mosaic. Trained models are kept in --work.
"""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from bench import inputs, page
from bench.correlation import ON_A_TILE
from bench.ground import COLUMNS, Ground, cells
from bench.photos import TRUE_LABELS, Network, agreement, as_seen, seen
from bench.tiles import tile_ground
from semref.core.evaluation.trial import Trial
from semref.core.labels.training_tiles import fitting_tiles
from semref.core.localization import Method
from semref.storage.rasters import RasterFile
from semref.storage.text_tables import read_class_table
from semref.storage.training_tiles import TileExport
from semref.training.job import LITE0, PACKAGED, SMALL, Job

PAGE = "benchmarks.md"
AREA = "dubai_aerial."
SEED = 1671
TILE = 4
"""A town on both halves."""

COUNT, QUICK_COUNT = 50, 2
SIZES_PX = (512, 640, 768)
MINUTES = (2, 5, 10)
NETWORKS = {"Lite0": {"encoder": LITE0, "encoder_weights": PACKAGED}, "small": {"encoder": SMALL}}
METHODS = (Method.AUTOMATIC, Method.MAP_CORRELATION)
VALIDATION_FRACTION = 0.2
MANY_EPOCHS = 10_000


def measure(run: inputs.Run) -> dict[str, str]:
    path = run.data / inputs.TILES / f"tile{TILE}_label.tif"
    if not path.exists():
        return {"own ground": f"Not measured: the real data is not here: {path.name}"}
    ground, picture = (
        tile_ground(path),
        np.moveaxis(inputs.read_labels(str(path).replace("_label", "_image"))[:3], 0, 2),
    )
    picture = np.ascontiguousarray(picture)
    middle = ground.labels_hw.shape[1] // 2
    tiles = cut_half(run, path, middle)
    images = flown(run, ground, middle)
    rows, agreement = [], []
    for name, settings in NETWORKS.items():
        for minutes in MINUTES:
            case = f"{name} for {minutes} minutes"
            if run.wants(case):
                model = trained(run, tiles, f"{name}_{minutes}", {**settings, "minutes": minutes})
                network = Network(model, ground)
                predicted = [as_seen(i, network.seen(seen(ground, picture, i.view))) for i in images]
                agreement.append([case, *agreed(ground, network.labels(picture[:, middle:]), middle)])
                rows += located(ground, predicted, case)
    if run.wants(TRUE_LABELS):
        rows += located(ground, images, TRUE_LABELS)
    names = [entry.name for entry in ground.database.class_table]
    about = _ABOUT.format(tile=TILE, sizes=", ".join(map(str, SIZES_PX)))
    second = page.table(["network", *(f"IoU {name}" for name in names), "mean", "pixels right"], agreement)
    return {"own ground": f"{about}\n\n{page.table(COLUMNS, rows)}\n\nOn the eastern half:\n\n{second}"}


_ABOUT = """\
Trained on the western half of tile {tile} of dubai_aerial by the training of semref:trainmodel, for so many minutes of
one processor; turned crops of {sizes} px wholly on the eastern half, at 0.9–1.1 of the mosaic's pixels, pixel size
searched over 0.7–1.4; database of the whole mosaic, all classes as landmarks; errors in pixels. Right: within 2 % of
the edge. “true labels”: what no network could improve."""


def cut_half(run: inputs.Run, labels: Path, middle: int) -> Path:
    """Training tiles of the western half, as semref:trainmodel cuts them."""
    from osgeo import gdal

    tiles = run.work / f"own_ground_tiles{TILE}"
    if tiles.exists():
        return tiles
    halves = {}
    for kind in ("image", "label"):
        source = gdal.Open(str(labels).replace("_label", f"_{kind}"))
        halves[kind] = run.work / f"own_ground_{kind}{TILE}.tif"
        gdal.Translate(str(halves[kind]), source, srcWin=[0, 0, middle, source.RasterYSize])
    table = run.work / "own_ground_classes.csv"
    table.write_text(inputs.TILE_CLASSES, encoding="utf-8")
    image, labels_of_half = (RasterFile(str(halves[kind])) for kind in ("image", "label"))
    size, stride = fitting_tiles((source.RasterYSize, middle))
    export = TileExport(image, labels_of_half, size, stride, VALIDATION_FRACTION)
    tiles.mkdir()
    for _ in export.steps(tiles, read_class_table(str(table))):
        pass
    return tiles


def trained(run: inputs.Run, tiles: Path, name: str, settings: dict) -> Path:
    """The model, trained unless an earlier run left it."""
    model = run.work / f"own_ground_{name}.onnx"
    if not model.exists():
        run_training(run, tiles, model, settings)
    return model


def run_training(run: inputs.Run, tiles: Path, model: Path, settings: dict) -> None:
    """Trains a model on tiles, or goes on where a run was cut off; ends this program where that fails."""
    folder = model.with_suffix(".training")
    job = Job((str(tiles),), str(model), str(folder), epochs=MANY_EPOCHS, light=1.5, patience=0, threads=1, **settings)
    job = replace(job, processor_time=True, resume=True)
    asked = model.with_suffix(".json")
    job.write(asked)
    done = subprocess.run([run.python, str(inputs.TOOLS.parent / "training"), str(asked)], stdout=sys.stderr)
    if done.returncode:
        sys.exit(f"{run.python} could not train {model.name}; it needs torch (--python)")


def flown(run: inputs.Run, ground: Ground, middle: int) -> list:
    """Images that show nothing of the western half."""
    images = []
    left, bottom, right, top = ground.frame.extent
    for number, edge in enumerate(SIZES_PX):
        rng = np.random.default_rng([SEED, number])
        wanted = replace(ON_A_TILE, sizes_px=(edge,), labeled=0.0)
        reach = edge * ON_A_TILE.scales[1] * np.sqrt(0.5)
        ground.extent = (left + middle + reach, bottom, right, top)
        images += [ground.draw(wanted, rng) for _ in range(run.how_many(COUNT, QUICK_COUNT))]
    return images


def located(ground: Ground, images: list, case: str) -> list[list[str]]:
    """A row of the table for each method."""
    rows = []
    for method in METHODS:
        trials: list[Trial] = [ground.try_image(image, method) for image in images]
        rows.append(cells(trials, f"{case}, {method}"))
        print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    return rows


def agreed(ground: Ground, predicted: np.ndarray, middle: int) -> list[str]:
    """Intersection over union of each class and their mean, and the share of pixels that are right."""
    found, right = agreement(ground, ground.labels_hw[:, middle:], predicted)
    return [*(f"{v:.3f}" for v in found), f"{np.mean(found):.3f}", f"{right:.1%}"]
