"""The job of a training: a JSON file that QGIS or train_pan.py writes and the training reads.

This file imports neither torch nor numpy, because QGIS uses it.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path

SMALL, LITE0 = "tu-mobilenetv3_small_050", "tu-tf_efficientnet_lite0"
"""Encoders: 0.3 M weights with random start; 3.4 M weights that were trained on ImageNet."""

PACKAGED = "packaged"
"""Value of ``encoder_weights`` for the weights of EfficientNet-Lite0 from a Python package."""

RESULT, NETWORK, JOB, EXAMPLES = "result.json", "network.json", "job.json", "examples"
"""Files in the folder of a run: results, architecture, job, pictures."""

MOST_PIECES, FEWEST_PIECES, PIECE_SIZE = 320, 64, 256
"""Largest and smallest number of pieces per epoch with a time limit, and their edge in pixels.

The largest number keeps epochs short, so that curves and checkpoints are written often.
"""

CHECKPOINT = "last.pt"
"""File with all data for continuing a run, written after each epoch."""

CHECKPOINT_JOB = "checkpoint"
"""First argument of the process that exports a checkpoint of others (checkpoint.py) instead of training."""

FREE = (
    *("output", "folder", "resume", "workers", "threads", "channels_last", "ground", "card", "tile_size"),
    *("epochs", "minutes", "patience", "processor_time"),
)
"""Fields that may differ when a run is continued: paths, the machine, and the duration."""


@dataclass(frozen=True)
class Job:
    """A training.

    Attributes:
        tiles: Folders of training tiles (semref:exporttrainingtiles).
        output: ONNX file to write.
        folder: Folder of the run, with checkpoint, curves and result.
        base_model: ONNX file or checkpoint (.pt) to continue from; empty without one.
        encoder: Name in segmentation_models_pytorch.
        depth: How often the encoder halves the image, 3 to 5.
        encoder_weights: File with weights for the encoder, PACKAGED, or empty.
        pretrained: Whether to download the encoder's weights.
        learn_unlabeled: Whether value 0 is a class; otherwise it is unknown ground.
        epochs: Largest number of epochs.
        pieces: Pieces per epoch; 0 for a number that covers the tiles once, at most MOST_PIECES with a time limit.
        piece_size: Edge in pixels, a multiple of 32.
        batch: Pieces per step.
        learning_rate: Largest learning rate; 0 to choose it from the kind of start.
        light: Factor for the variation of light and color.
        patience: Epochs without progress before the training stops; 0 for no early stop.
        minutes: Time limit from the start of the process to the written model; 0 for no limit.
        processor_time: Whether minutes are processor time instead of clock time.
        mixed_precision: auto (with a GPU), on or off.
        channels_last: Whether to use this memory layout, which is faster for mobile encoders on a CPU.
        resolution: Pixel size in m; None for that of the tiles.
        overlap: Percent of a tile, for the metadata.
        workers: Number of processes that read tiles.
        threads: CPU threads of torch; 0 for its default.
        resume: Whether to continue a run in the folder.
        ground: Metadata of the training ground: sources, CRS, extent.
        complete: By folder of tiles, names of the classes that were drawn completely. Value 0 then excludes these
            classes (``metrics.partial_labels``).
        tile_size: Tile edge in pixels for the model's metadata; 0 for that of the tiles.
        card: Other data for the model card: name, licenses, suitable uses (``export.metadata_of``).
        fingerprint: Sizes and times of the sources, which must be equal to continue a run.
    """

    tiles: tuple[str, ...]
    output: str
    folder: str
    base_model: str = ""
    encoder: str = SMALL
    depth: int = 5
    encoder_weights: str = ""
    pretrained: bool = False
    learn_unlabeled: bool = False
    epochs: int = 60
    pieces: int = 0
    piece_size: int = PIECE_SIZE
    batch: int = 8
    learning_rate: float = 0.0
    light: float = 1.0
    patience: int = 20
    minutes: float = 0.0
    processor_time: bool = False
    mixed_precision: str = "auto"
    channels_last: bool = True
    resolution: float | None = None
    overlap: int = 15
    workers: int = 0
    threads: int = 0
    seed: int = 1671
    resume: bool = False
    ground: dict = field(default_factory=dict)
    complete: dict = field(default_factory=dict)
    tile_size: int = 0
    card: dict = field(default_factory=dict)
    fingerprint: dict = field(default_factory=dict)

    def write(self, path: Path) -> None:
        """Write the job as JSON; an older file is replaced when the new one is complete."""
        new = path.with_name(f"{path.name}.part")
        new.write_text(json.dumps(asdict(self), indent=1) + "\n", encoding="utf-8")
        new.replace(path)

    def differences(self, other: Job) -> list[str]:
        """Return names of fields that differ from another run and prevent continuing it."""
        return [f.name for f in fields(self) if f.name not in FREE and _of(self, f.name) != _of(other, f.name)]


def read_job(path: Path) -> Job:
    """Read a job. Raises OSError or ValueError for an invalid file."""
    content = json.loads(path.read_text(encoding="utf-8"))
    try:
        return Job(**{**content, "tiles": tuple(content["tiles"])})
    except (TypeError, KeyError):
        raise ValueError(path) from None


def _of(job: Job, name: str) -> object:
    """Return a value after conversion to JSON and back."""
    return json.loads(json.dumps(getattr(job, name)))
