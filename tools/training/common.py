"""Common steps of the scripts that train: options, training tiles, and the training of semref:trainmodel."""

import argparse
import os
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from plugin_package import ROOT, load_plugin_package

load_plugin_package()
from semref.core.errors import ParameterError  # noqa: E402
from semref.core.steps import result_of  # noqa: E402
from semref.storage.label_maps import RasterFile  # noqa: E402
from semref.storage.text_tables import read_class_table  # noqa: E402
from semref.storage.training_tiles import TileExport  # noqa: E402
from semref.training.job import Job  # noqa: E402

DATA = Path(os.environ.get("SEMREF_DATA") or ROOT.parent / "shared" / "data")


def parser_of(about: str) -> argparse.ArgumentParser:
    """Return a parser with the options of all scripts: output folder and Python."""
    parser = argparse.ArgumentParser(description=about, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output_folder", type=Path)
    parser.add_argument("--python", type=Path, default=ROOT / ".venv-train" / "bin" / "python", help="with torch")
    return parser


def prepare(parser: argparse.ArgumentParser, options: argparse.Namespace, needed: str = "") -> Path:
    """Create and return the output folder; exit without the Python, or without a needed folder of the data."""
    if not options.python.exists():
        parser.error(f"{options.python} is missing; run bash tools/training/setup_training.sh first")
    if needed and not (DATA / needed).is_dir():
        parser.error(f"there is no data at {DATA / needed}")
    folder = options.output_folder.absolute()
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def cut(
    image: Path,
    labels: Path,
    classes: Path,
    tiles: Path,
    grid: tuple[int, int],
    validation: float,
    unseen_apart: bool = False,
) -> Path:
    """Export training tiles of a photo unless they exist, and return their folder.

    A photo that is too small for validation tiles has training tiles only.

    Args:
        image: The photo.
        labels: Label map on the photo's pixels.
        classes: Class table.
        tiles: Folder to write.
        grid: Tile edge and stride, in pixels.
        validation: Share of the ground for validation.
        unseen_apart: As for ``TileExport``.
    """
    for fraction in () if tiles.exists() else (validation, 0.0):
        made = tiles.with_name(f"{tiles.name}_{fraction:g}")
        made.mkdir(parents=True)
        try:
            export = TileExport(
                RasterFile(str(image)), RasterFile(str(labels)), *grid, fraction, unseen_apart=unseen_apart
            )
            result_of(export.write(made, read_class_table(str(classes))))
        except ParameterError:
            continue
        made.rename(tiles)
        break
    return tiles


def train(python: Path, job: Job) -> None:
    """Run the training of semref:trainmodel; exit if it fails."""
    path = Path(job.output).with_suffix(".job.json")
    job.write(path)
    status = subprocess.run([str(python), str(ROOT / "program.py"), "training.command", str(path)]).returncode
    if status:
        sys.exit(status)
