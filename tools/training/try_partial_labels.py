"""What ground where only buildings were drawn does to the other classes: taken as it is, as “other”, or left out.

    .venv-train/bin/python tools/training/try_partial_labels.py FOLDER [--tile 4] [--minutes 1.5]

FOLDER is that of train_dubai.py --leave-out 4: its tiles, and without_tile4.onnx to go on from. Of one tile all labels
but buildings are taken away; the network then goes on for some minutes of one processor on all tiles, three times with
the same seed: “left out” (without that tile), “partial” (partial.py), “other” (whatever was not drawn is a class of its
own). IoU a class on that tile with all its labels, which none of them has seen: docs/decisions/partial-labels.md.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import sys
import tempfile
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from plugin_package import load_plugin_package

load_plugin_package()
import cv2  # noqa: E402
import numpy as np  # noqa: E402

from semref.training import export, metrics, tiles, train  # noqa: E402
from semref.training.job import Job  # noqa: E402

NUMBERS = (1, 2, 3, 4, 5, 6)
BUILDING, OTHER = 1, 6
OTHER_ROW = f"{OTHER},other,#777777,background\n"
MANY_EPOCHS = 10_000


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--tile", type=int, default=4, choices=NUMBERS)
    parser.add_argument("--minutes", type=float, default=1.5)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as work:
        for way in ("left out", "partial", "other"):
            print(f"| {way} | {' | '.join(tried(way, options, Path(work)))} |", flush=True)


def tried(way: str, options: argparse.Namespace, work: Path) -> list[str]:
    """IoU of each class of Dubai on the tile, trained in one of the ways."""
    folders = {number: options.folder / f"tile{number}" for number in NUMBERS}
    whole = folders.pop(options.tile)
    if way != "left out":
        folders[options.tile] = stripped(whole, work / way, OTHER if way == "other" else 0)
    if way == "other":
        folders = {number: with_other(folder, work / f"other{number}") for number, folder in folders.items()}
    model = work / f"{way}.onnx"
    job = Job(
        tuple(map(str, folders.values())),
        str(model),
        str(model.with_suffix(".training")),
        base_model=str(options.folder / f"without_tile{options.tile}.onnx"),
        complete={str(work / way): ["building"]} if way == "partial" else {},
        epochs=MANY_EPOCHS,
        patience=0,
        minutes=options.minutes,
        processor_time=True,
        threads=1,
        light=1.5,
    )
    trainer = train.run(job, lambda *_event, **_values: None)
    (test,) = tiles.open_folders([whole])
    reader = tiles.TileReader(test.tiles("train") + test.tiles("validation"), list(range(OTHER)), False)
    told = (getattr(trainer, name).flatten().cpu().numpy() for name in ("mean", "deviation"))
    answer = export.answering(export.scoring(model, *told))
    confusion = np.zeros((OTHER + 1, OTHER + 1), np.int64)
    for index in range(len(reader)):
        image, labels = reader(index)
        confusion += metrics.confusion_matrix(labels, answer(image), OTHER + 1)
    iou = metrics.intersection_over_union(confusion)[1:OTHER]
    return [*(f"{value:.3f}" for value in iou), f"{np.mean(iou):.3f}"]


def stripped(folder: Path, target: Path, value: int) -> Path:
    """The tiles of a folder with another value wherever there is no building."""
    shutil.copytree(folder, target)
    for path in target.glob("*/labels/*.png"):
        labels = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
        cv2.imwrite(str(path), np.where(labels == BUILDING, labels, value).astype(np.uint8))
    manifest = target / "manifest.json"
    text = manifest.read_text(encoding="utf-8")
    manifest.write_text(with_counts(text, value), encoding="utf-8")
    return target


def with_counts(text: str, value: int) -> str:
    """A manifest whose pixels without a building are counted under one value."""
    manifest = json.loads(text)
    for subset, counts in manifest["statistics"]["class_pixels"].items():
        building = counts.get(str(BUILDING), 0)
        manifest["statistics"]["class_pixels"][subset] = {
            str(BUILDING): building,
            str(value): sum(counts.values()) - building,
        }
    return json.dumps(manifest)


def with_other(folder: Path, target: Path) -> Path:
    """The same tiles with a class table that has one class more."""
    target.mkdir()
    for entry in folder.iterdir():
        if entry.name != "classes.csv":
            os.symlink(entry.resolve(), target / entry.name)
    table = (folder / "classes.csv").read_text(encoding="utf-8")
    (target / "classes.csv").write_text(table + OTHER_ROW, encoding="utf-8")
    return target


if __name__ == "__main__":
    main()
