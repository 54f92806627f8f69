"""Train a Pyramid Attention Network on tiles from semref:exporttrainingtiles and write it as an ONNX model.

    python tools/training/train_pan.py TILES [TILES …] --output MODEL.onnx [--epochs 60] [--test TILES] [--resume]

The script uses the code of semref:trainmodel (training/), but all settings can be changed. TILES are folders of
exported tiles with the same classes. The folder MODEL.training next to the model has the curves (curves.csv), the best
weights and the state for --resume. --test measures the model on tiles of another place, in torch and in
onnxruntime. Run bash tools/training/setup_training.sh first; docs/how-to/train_a_network.md has more.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from plugin_package import load_plugin_package

load_plugin_package()
from semref.core.errors import SemRefError  # noqa: E402
from semref.training.job import Job  # noqa: E402


def main(arguments: list[str] | None = None) -> int:
    """Run the command line and return the exit status."""
    options = parse(arguments)
    try:
        train(options)
    except ImportError as error:
        print(
            f"train_pan: {error}. Run it with the Python that tools/training/setup_training.sh installs.",
            file=sys.stderr,
        )
        return 1
    except SemRefError as error:
        print(f"train_pan: {error}", file=sys.stderr)
        return 1
    return 0


def parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tiles", type=Path, nargs="+", metavar="TILES")
    parser.add_argument("--output", type=Path, required=True, help="ONNX file to write")
    parser.add_argument("--test", type=Path, nargs="+", default=[], metavar="TILES", help="tiles of another place")
    parser.add_argument("--base-model", default="", metavar="FILE", help="continue from this model (.onnx or best.pt)")
    parser.add_argument("--encoder", default="tu-mobilenetv3_small_100", help="default %(default)s")
    parser.add_argument("--depth", type=int, choices=(3, 4, 5), default=5, help="of the encoder; default %(default)s")
    parser.add_argument("--pretrained", action="store_true", help="start from ImageNet's weights (downloads them)")
    parser.add_argument("--encoder-weights", default="", metavar="FILE", help="start from these: a torch state dict")
    parser.add_argument("--learn-unlabeled", action="store_true", help="value 0 is a class, not unknown")
    parser.add_argument("--epochs", type=int, default=60)
    parser.add_argument("--minutes", type=float, default=0.0, help="limit in minutes; default: no limit")
    parser.add_argument("--processor-time", action="store_true", help="count processor time instead of elapsed time")
    parser.add_argument("--pieces", type=int, default=0, help="an epoch; default: as many as cover the tiles once")
    parser.add_argument("--piece-size", type=int, default=256, help="pixels, a multiple of 32; default %(default)s")
    parser.add_argument("--batch", type=int, default=8)
    parser.add_argument("--learning-rate", type=float, default=1e-3)
    parser.add_argument("--light", type=float, default=1.0, help="how much light and color vary; default %(default)s")
    parser.add_argument("--patience", type=int, default=20, help="epochs without progress; 0: train to the end")
    parser.add_argument("--mixed-precision", choices=("auto", "on", "off"), default="auto", help="auto: with a GPU")
    parser.add_argument("--channels-last", action="store_true", help="twice as fast for mobile encoders on a CPU")
    parser.add_argument("--resolution", type=float, help="meters a pixel; default: as the tiles say")
    parser.add_argument("--overlap", type=int, default=15, help="percent of a tile, for the metadata")
    parser.add_argument("--workers", type=int, default=0, help="processes that read tiles")
    parser.add_argument("--threads", type=int, default=0, help="of torch on the CPU")
    parser.add_argument("--seed", type=int, default=1671)
    parser.add_argument("--card", type=Path, metavar="FILE", help="JSON with further entries of the model's card")
    parser.add_argument("--resume", action="store_true", help="continue the run next to the output")
    options = parser.parse_args(arguments)
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
    settings["card"] = json.loads(options.card.read_text(encoding="utf-8")) if options.card else {}
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
    (test,) = tiles.open_folders([folder])
    values = [c.value for c in ground.classes]
    reader = tiles.TileReader(test.tiles("train") + test.tiles("validation"), values, job.learn_unlabeled)
    by_torch, by_onnx, same = export.compare(trainer.network, Path(job.output), reader, mean, deviation)
    print(f"\n{folder}, {len(reader)} tiles, {same:.4%} of the pixels equal in torch and onnxruntime\n")
    print("| class | IoU in torch | IoU in onnxruntime |\n|---|---|---|")
    pairs = zip(ground.class_names, *(metrics.intersection_over_union(m) for m in (by_torch, by_onnx)))
    print("\n".join(f"| {name} | {a:.4f} | {b:.4f} |" for name, a, b in pairs if np.isfinite(a)))


if __name__ == "__main__":
    sys.exit(main())
