"""Train the sample model on photos of made-up areas other than the sample area.

    .venv/bin/python tools/training/train_sample.py OUTPUT_FOLDER [--seeds 11 12 13 14 15] [-- options of train_pan.py]

For each seed the script creates an area (tools/sample), its label map (semref:rasterizeannotation) and training tiles
(semref:exporttrainingtiles). Then it trains in .venv-train (setup_training.sh). Existing files are kept. The model is
OUTPUT_FOLDER/sample_area.onnx.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from qgis_session import ROOT, load_plugin_package, qgis_session

load_plugin_package()
from sample import DEFAULT_SEED  # noqa: E402

SEEDS = (11, 12, 13, 14, 15)
TILE_PX, STRIDE_PX, VALIDATION_FRACTION = 512, 448, 0.12
TRAINING_PYTHON = ROOT / ".venv-train" / "bin" / "python"
MODEL = "sample_area.onnx"
TRAINING = (
    "--encoder",
    "tu-mobilenetv3_small_050",
    "--channels-last",
    "--learn-unlabeled",
    "--epochs",
    "16",
    "--pieces",
    "800",
    "--learning-rate",
    "3e-3",
    "--resolution",
    "1.0",
)


CARD = {
    "name": "Sample area (made up)",
    "trained_on": [{"place": "made-up areas, seeds 11 to 15", "about": "rendered photos: fields, woods, villages"}],
    "good_for": "The sample area that SemRef makes up, to try everything with.",
    "not_for": "Any photo of the real world: it has never seen one.",
    "license": "That of SemRef; no foreign data went into it.",
}
"""Return the model's own description."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output_folder", type=Path)
    parser.add_argument("--seeds", type=int, nargs="+", default=list(SEEDS))
    parser.add_argument("--python", type=Path, default=TRAINING_PYTHON, help="Python of the training environment")
    end = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)  # argparse can't have options between positionals
    options, training = parser.parse_args(sys.argv[1:end]), sys.argv[end + 1 :]
    if DEFAULT_SEED in options.seeds:
        parser.error(f"{DEFAULT_SEED} is the sample area. Train on other seeds.")
    if not options.python.exists():
        parser.error(f"{options.python} is missing; run bash tools/training/setup_training.sh first")
    folder = options.output_folder.absolute()
    folder.mkdir(parents=True, exist_ok=True)
    card = folder / "card.json"
    card.write_text(json.dumps(CARD), encoding="utf-8")
    with qgis_session():
        tiles = [tiles_of(folder / f"area{seed}", seed) for seed in options.seeds]
    command = [
        options.python,
        ROOT / "tools" / "training" / "train_pan.py",
        *tiles,
        "--output",
        folder / MODEL,
        "--card",
        card,
        *TRAINING,
    ]
    sys.exit(subprocess.run([str(part) for part in [*command, *training]]).returncode)


def tiles_of(area: Path, seed: int) -> Path:
    """Return the training tiles of a seed's area."""
    import processing

    tiles, labels = area.with_name(f"{area.name}_tiles"), area.with_name(f"{area.name}_labels.tif")
    if tiles.exists():
        return tiles
    if not area.exists():
        command = [sys.executable, "-m", "tools.sample", str(area.absolute()), "--seed", str(seed)]
        subprocess.run(command, cwd=ROOT, check=True)
    annotation = {"INPUT": str(area / "landcover.shp"), "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
    burning = {"CLASS_TABLE": str(area / "classes.csv"), "PIXEL_SIZE": 1.0, "OUTPUT": str(labels)}
    processing.run("semref:rasterizeannotation", {**annotation, **burning})
    cut = {"TILE_SIZE": TILE_PX, "STRIDE": STRIDE_PX, "VALIDATION_FRACTION": VALIDATION_FRACTION}
    pair = {"IMAGE": str(area / "orthophoto.tif"), "LABELS": str(labels)}
    made = processing.run("semref:exporttrainingtiles", {**pair, **cut, "OUTPUT": str(tiles)})
    print(f"{tiles}: {made['TILE_COUNT']} tiles", flush=True)
    return tiles


if __name__ == "__main__":
    main()
