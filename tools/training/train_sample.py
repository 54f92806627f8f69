"""Train the sample model on photos of made-up areas other than the sample area.

    .venv/bin/python tools/training/train_sample.py OUTPUT_FOLDER

For each seed the script creates an area (tools/sample), its label map (semref:rasterizeannotation) and training tiles.
Then it trains in .venv-train (setup_training.sh). Existing files are kept. The model is OUTPUT_FOLDER/sample_area.onnx.
"""

import subprocess
import sys
from pathlib import Path

from common import ROOT, Job, cut, parser_of, prepare, train
from qgis_session import qgis_session

from semref.training.job import SMALL

SEEDS = (11, 12, 13, 14, 15)
"""Seeds other than that of the sample area."""

GRID_PX, VALIDATION_FRACTION = (512, 448), 0.12
CARD = {
    "name": "Sample area (made up)",
    "trained_on": [{"place": "made-up areas, seeds 11 to 15", "about": "rendered photos: fields, woods, villages"}],
    "good_for": "The sample area that SemRef makes up, to try everything with.",
    "not_for": "Any photo of the real world: it has never seen one.",
    "license": "That of SemRef; no foreign data went into it.",
}


def main() -> None:
    parser = parser_of(__doc__)
    options = parser.parse_args()
    folder = prepare(parser, options)
    with qgis_session():
        tiles = [str(tiles_of(folder / f"area{seed}", seed)) for seed in SEEDS]
    job = Job(
        tuple(tiles),
        str(folder / "sample_area.onnx"),
        str(folder / "sample_area.training"),
        encoder=SMALL,
        learn_unlabeled=True,
        epochs=16,
        pieces=800,
        learning_rate=3e-3,
        resolution=1.0,
        card=CARD,
    )
    train(options.python, job)


def tiles_of(area: Path, seed: int) -> Path:
    """Return the training tiles of a seed's area."""
    import processing

    labels, classes = area.with_name(f"{area.name}_labels.tif"), area / "classes.csv"
    if not area.exists():
        command = [sys.executable, "-m", "tools.sample", str(area), "--seed", str(seed)]
        subprocess.run(command, cwd=ROOT, check=True)
    if not labels.exists():
        annotation = {"INPUT": str(area / "landcover.shp"), "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
        options = {"CLASS_TABLE": str(classes), "PIXEL_SIZE": 1.0, "OUTPUT": str(labels)}
        processing.run("semref:rasterizeannotation", {**annotation, **options})
    tiles = area.with_name(f"{area.name}_tiles")
    return cut(area / "orthophoto.tif", labels, classes, tiles, GRID_PX, VALIDATION_FRACTION)


if __name__ == "__main__":
    main()
