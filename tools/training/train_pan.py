"""Train a Pyramid Attention Network on tiles from semref:exporttrainingtiles and write it as an ONNX model.

    python tools/training/train_pan.py TILES [TILES …] --output MODEL.onnx [--epochs 60] [--test TILES] [--resume]

The script uses the code of semref:trainmodel (training/), but all settings can be changed. TILES are folders of
exported tiles with the same classes. The folder MODEL.training next to the model has the curves (curves.csv), the best
weights and the state for --resume. --test measures the model on tiles of another place. Run
bash tools/training/setup_training.sh first; docs/how-to/train_a_network.md has more.
"""

import argparse
import re
import sys
from dataclasses import fields
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from plugin_package import load_plugin_package

load_plugin_package()
from semref.core.errors import SemRefError  # noqa: E402
from semref.training.job import Job  # noqa: E402


def main() -> None:
    options = parse()
    try:
        train(options)
    except ImportError as error:
        sys.exit(f"train_pan: {error}. Run it with the Python that tools/training/setup_training.sh installs.")
    except SemRefError as error:
        sys.exit(f"train_pan: {error}")


def parse() -> argparse.Namespace:
    """Return the options: those below, and all numbers, texts and switches of ``Job`` with their description there."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tiles", type=Path, nargs="+", metavar="TILES")
    parser.add_argument("--output", type=Path, required=True, help="ONNX file to write")
    parser.add_argument("--test", type=Path, nargs="+", default=[], metavar="TILES", help="tiles of another place")
    kinds = {"str": str, "int": int, "float": float, "float | None": float}
    helps = dict(re.findall(r"^ {8}(\w+): (.*(?:\n {12}.*)*)", Job.__doc__, re.MULTILINE))
    for field in (one for one in fields(Job) if one.type in (*kinds, "bool") and one.name not in ("output", "folder")):
        if field.type == "bool":
            how = {"action": argparse.BooleanOptionalAction}
        else:
            how = {"type": kinds[field.type], "metavar": field.type.split(" ")[0].upper()}
        about = f"{' '.join(helps.get(field.name, '').split())} Default: {field.default}".replace("%", "%%")
        parser.add_argument(f"--{field.name.replace('_', '-')}", default=field.default, help=about, **how)
    options = parser.parse_args()
    if options.pretrained and options.encoder_weights:
        parser.error("--pretrained and --encoder-weights exclude each other")
    return options


def train(options: argparse.Namespace) -> None:
    """Train, export, check and test the model on tiles of other places.

    Raises:
        TrainingError: The training failed."""
    from semref.training import train
    from semref.training.job import CHECKPOINT

    settings = {key: value for key, value in vars(options).items() if key not in ("tiles", "test", "output")}
    folder = options.output.with_suffix(".training")
    tiles = tuple(str(path) for path in options.tiles)
    job = Job(tiles, str(options.output), str(folder), **settings)
    if job.resume and not (folder / CHECKPOINT).exists():
        raise SemRefError("There is no run to resume in {folder}.", folder=folder)
    trainer = train.run(job, say)
    for test in options.test:
        say_test(test, trainer, job)


def say(event: str, **values: object) -> None:
    if event != "step":
        print(" ".join([event, *(f"{key} {value}" for key, value in values.items())]), flush=True)


def say_test(folder: Path, trainer: object, job: Job) -> None:
    """Print a table of IoU per class on the tiles of a folder."""
    import numpy as np

    from semref.training import export, metrics, tiles
    from semref.training.train import read_tiles

    ground = read_tiles(job)
    mean, deviation = (getattr(trainer, name).flatten().cpu().numpy() for name in ("mean", "deviation"))
    scores_of = export.scoring(Path(job.output), mean, deviation)
    (test,) = tiles.open_folders([folder])
    values = [c.value for c in ground.classes]
    reader = tiles.TileReader(test.tiles("train") + test.tiles("validation"), values, job.learn_unlabeled)
    found = ((labels, scores_of(image).argmax(0)) for image, labels in map(reader, range(len(reader))))
    confusion = sum(metrics.confusion_matrix(labels, predicted, len(values)) for labels, predicted in found)
    print(f"\n{folder}, {len(reader)} tiles\n\n| class | IoU |\n|---|---|")
    for name, iou in zip(ground.class_names, metrics.intersection_over_union(confusion)):
        if np.isfinite(iou):
            print(f"| {name} | {iou:.4f} |")


if __name__ == "__main__":
    main()
