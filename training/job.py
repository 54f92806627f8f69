"""What is to be trained, with what and how: one JSON file that QGIS or train_pan.py writes and the training reads.

Without torch and numpy: QGIS makes it, too.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path

SMALL, LITE0 = "tu-mobilenetv3_small_050", "tu-tf_efficientnet_lite0"
"""Encoders: 0.3 M weights, from random ones; 3.4 M weights that know photos already (ImageNet)."""

PACKAGED = "packaged"
"""Instead of a file of weights for the encoder: those of EfficientNet-Lite0 that come as a package."""

RESULT, NETWORK, JOB, EXAMPLES = "result.json", "network.json", "job.json", "examples"
"""Files in the folder of a run: what came of it, what its weights belong to, what was asked, pictures."""

MOST_PIECES, FEWEST_PIECES, PIECE_SIZE = 320, 64, 256
"""An epoch, where minutes are limited: at most, so that curves and checkpoints come often, and at least; their edge in
pixels."""

CHECKPOINT = "last.pt"
"""All that going on with a run needs, after each epoch."""

FREE = (
    *("output", "folder", "resume", "workers", "threads", "channels_last", "ground", "card", "tile_size"),
    *("epochs", "minutes", "patience", "processor_time"),
)
"""What a run may be gone on with otherwise: places, the machine, and how long it goes."""


@dataclass(frozen=True)
class Job:
    """A training.

    Attributes:
        tiles: Folders of tiles (semref:exporttrainingtiles).
        output: ONNX file to write.
        folder: Of the run: checkpoint, curves, result.
        base_model: ONNX file or checkpoint (.pt) to go on from; empty for none.
        encoder: Of segmentation_models_pytorch.
        depth: 3 to 5, how often the encoder halves the image.
        encoder_weights: File of weights for the encoder, PACKAGED, or empty.
        pretrained: Whether the encoder's weights are downloaded.
        learn_unlabeled: Whether value 0 is a class of its own, not unknown.
        epochs: At most so many.
        pieces: An epoch; 0 for as many as cover the tiles once, at most MOST_PIECES where minutes are limited.
        piece_size: Edge in pixels, a multiple of 32.
        batch: Pieces a step.
        learning_rate: The largest; 0 for what suits the start.
        light: How much light and color vary.
        patience: Epochs without progress before it stops; 0 for never.
        minutes: From the start of the process to the written model; 0 for no limit.
        processor_time: Whether minutes are of the processor, not of the clock.
        mixed_precision: auto (with a GPU), on or off.
        channels_last: Faster for mobile encoders on a CPU.
        resolution: Meters a pixel; None for what the tiles say.
        overlap: Percent of a tile, for the metadata.
        workers: Processes that read tiles.
        threads: Of torch on the CPU; 0 for its own choice.
        seed: Of all that is random.
        resume: Whether a run in the folder is gone on with.
        ground: What the metadata tell of the ground that was learned: sources, CRS, extent.
        complete: Of folders of tiles the names of the classes that were drawn wherever they are; value 0 is then known
            to be none of them (partial.py).
        tile_size: Edge in pixels of the tiles that the model is to be shown, for the metadata; 0 for that of the tiles.
        card: What else the model's card tells: name, licenses, what it is good for (metadata.py).
        fingerprint: What else a run must have alike to be gone on with: sizes and times of its sources.
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
        """Writes it as JSON; an older file is whole until the new one is."""
        new = path.with_name(f"{path.name}.part")
        new.write_text(json.dumps(asdict(self), indent=1) + "\n", encoding="utf-8")
        new.replace(path)

    def differences(self, other: Job) -> list[str]:
        """Names of what another run was made with otherwise, so that it can't be gone on with as this one."""
        return [f.name for f in fields(self) if f.name not in FREE and _of(self, f.name) != _of(other, f.name)]


def read_job(path: Path) -> Job:
    """Raises OSError or ValueError for a file that holds none."""
    content = json.loads(path.read_text(encoding="utf-8"))
    try:
        return Job(**{**content, "tiles": tuple(content["tiles"])})
    except (TypeError, KeyError):
        raise ValueError(path) from None


def _of(job: Job, name: str) -> object:
    """A value as JSON would give it back."""
    return json.loads(json.dumps(getattr(job, name)))
