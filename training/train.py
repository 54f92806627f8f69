"""Execute a training, from tiles to a checked ONNX file with metadata."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from datetime import date
from pathlib import Path

import cv2
import numpy as np
import torch

from ..core.errors import TrainingError
from ..core.labels.class_table import OTHER, LandCoverClass
from ..core.segmentation.class_bias import KEY, class_bias_text
from ..core.segmentation.metadata import TEMPERATURE
from . import base_weights, class_bias, export, loop, metrics, network, tiles
from .job import CHECKPOINT, EXAMPLES, FEWEST_PIECES, MOST_PIECES, NETWORK, PACKAGED, RESULT, Job
from .metrics import partial_labels
from .tiles import TileReader, spread, standardized

FROM_SCRATCH, FROM_WEIGHTS, FROM_BASE = 3e-3, 1e-3, 5e-4
"""Learning rates for random weights, for a pretrained encoder, and for a base model."""

EPOCH_TILES, FINAL_TILES, BIAS_TILES = 16, 100, 25
"""Largest number of validation tiles with a time limit: per epoch, for the final network, and for the class offsets."""

FINAL_SHARE, EXPORT_S = 0.2, 15.0
"""Largest share of the time limit for the final validation; seconds to write and check the model."""

EPOCH_SHARE = 0.02
"""Largest share of the time limit for the validation of an epoch."""

SMALLEST_IMAGE = 128
"""Smallest edge in pixels for the network's pyramid."""

RESTORING_BATCHES = 8
"""Number of batches for restoring the normalization of a base model."""


@dataclass(frozen=True)
class TileData:
    """The tiles of a training.

    Attributes:
        pixels: (L,) pixels of each label.
        allowed: (L, K) bool of the classes that each label allows (``metrics.partial_labels``).
        tile_size: Edge in pixels.
        pixel_size: In m; None if unknown.
        mean: (3,) mean of red, green and blue.
        deviation: (3,) standard deviation of red, green and blue.
    """

    classes: list[LandCoverClass]
    training: tiles.TileReader
    validation: tiles.TileReader
    pixels: np.ndarray
    allowed: np.ndarray
    tile_size: int
    pixel_size: float | None
    mean: np.ndarray
    deviation: np.ndarray

    @property
    def class_names(self) -> list[str]:
        return [c.name for c in self.classes]


@dataclass(frozen=True)
class Start:
    """A network to train, its architecture, and the standardization of its photos."""

    network: torch.nn.Module
    architecture: dict
    mean: np.ndarray
    deviation: np.ndarray
    learning_rate: float


@dataclass(frozen=True)
class ValidationTiles:
    """Numbers of validation tiles: for each epoch, for the final network, and for the class offsets."""

    epoch: int
    final: int
    bias: int


def run(job: Job, report: loop.Report, began: float | None = None) -> loop.Trainer:
    """Train, export and check a network; write result and pictures to ``job.folder``. Raises TrainingError.

    ``began``: start of the process (time.monotonic) for the time limit; None for now.
    """
    began = time.monotonic() if began is None else began
    torch.manual_seed(job.seed)
    if job.threads:
        torch.set_num_threads(job.threads)
    ground = read_tiles(job)
    job = with_defaults(job, ground)
    start = start_of(job, ground)
    folder = Path(job.folder)
    folder.mkdir(parents=True, exist_ok=True)
    standardization = {"standardization_mean": start.mean.tolist(), "standardization_std": start.deviation.tolist()}
    stated = {**start.architecture, "class_names": ground.class_names, **standardization}
    (folder / NETWORK).write_text(json.dumps(stated), encoding="utf-8")
    job = replace(job, learning_rate=start.learning_rate)
    weights = metrics.class_weights(ground.pixels)
    trainer = loop.Trainer(
        *(start.network, start.mean, start.deviation, ground.class_names), *(weights, ground.allowed, job, report)
    )
    if not job.processor_time:
        trainer.began = began
    report(
        "begun",
        device=_device_name(trainer.device),
        training=len(ground.training),
        validation=len(ground.validation),
        weights=sum(p.numel() for p in start.network.parameters()),
        class_weights=[round(float(weight), 2) for weight in weights],
    )
    if job.resume and (folder / CHECKPOINT).exists():
        trainer.resume()
        report("resumed", epoch=trainer.epoch, share=trainer.total_share)
    numbers = validation_tiles(job, trainer, ground.validation)
    epoch_tiles = ground.validation.spread(numbers.epoch)
    trainer.run(ground.training, epoch_tiles)
    if len(epoch_tiles) < len(ground.validation):
        trainer.best_confusion = trainer.confusion(trainer.network, ground.validation.spread(numbers.final))
    finish(job, trainer, ground, start, numbers, report)
    return trainer


def read_tiles(job: Job) -> TileData:
    """Open the tiles of a job. Raises TrainingError for unsuitable tiles."""
    folders = tiles.open_folders([Path(path) for path in job.tiles])
    classes = [export.UNLABELED, *folders[0].classes]
    if job.learn_unlabeled:
        classes[0] = LandCoverClass(0, OTHER, "#000000")
    values = [c.value for c in classes]
    names, complete = [c.name for c in classes], {Path(path): known for path, known in job.complete.items()}
    excluded = {f.path: [names.index(name) for name in complete[f.path]] for f in folders if f.path in complete}
    allowed, zeros = partial_labels(len(classes), excluded)
    pixels = np.zeros(len(allowed), np.int64)
    for folder in folders:
        counts = folder.manifest["statistics"]["class_pixels"]["train"]
        pixels[1 : len(values)] += [counts.get(str(v), 0) for v in values[1:]]
        zero = zeros.get(folder.path, 0 if job.learn_unlabeled else None)
        if zero not in (None, tiles.IGNORED):
            pixels[zero] += counts.get("0", 0)
    if np.count_nonzero(pixels) < 2:
        raise TrainingError(
            "Only one class ({name}) is labeled, and unlabeled ground counts as unknown, so the network can't learn to "
            "distinguish classes. Label another class, or treat unlabeled ground as a class.",
            name=classes[int(np.argmax(pixels))].name,
        )
    training, validation = (
        tiles.TileReader(
            [replace(p, unlabeled=zeros.get(f.path)) for f in folders for p in f.tiles(subset)],
            values,
            job.learn_unlabeled,
        )
        for subset in ("train", "validation")
    )
    sizes = {folder.manifest["pixel_size"] for folder in folders}
    return TileData(
        classes,
        training,
        validation,
        pixels,
        allowed,
        min(folder.manifest["tile_size"] for folder in folders),
        job.resolution or (sizes.pop() if len(sizes) == 1 else None),
        *tiles.band_statistics(folders),
    )


def with_defaults(job: Job, ground: TileData) -> Job:
    """Return the job with the number of pieces and their size chosen."""
    piece_size = min(job.piece_size, ground.tile_size)
    covering = len(ground.training) * max(1, (ground.tile_size // piece_size) ** 2)
    if job.minutes:
        covering = min(max(covering, FEWEST_PIECES), MOST_PIECES)
    return replace(job, pieces=job.pieces or covering, piece_size=piece_size)


def validation_tiles(job: Job, trainer: loop.Trainer, reader: tiles.TileReader) -> ValidationTiles:
    """Choose the numbers of validation tiles, and reserve time for them at the end. All without a time limit."""
    count = len(reader)
    if not job.minutes:
        return ValidationTiles(count, min(FINAL_TILES, count), count)
    trainer.confusion(trainer.network, reader.spread(1))
    started = time.monotonic()
    trainer.confusion(trainer.network, reader.spread(2))
    tile_s = (time.monotonic() - started) / max(min(count, 2), 1)
    final, bias = min(FINAL_TILES, count), min(BIAS_TILES, count)
    share = min(1.0, 60 * job.minutes * FINAL_SHARE / max(tile_s * (2 * final + 4 * bias), 1e-6))
    epoch = min(EPOCH_TILES, max(2, int(60 * job.minutes * EPOCH_SHARE / max(tile_s, 1e-6))))
    numbers = ValidationTiles(epoch, max(1, int(share * final)), max(1, int(share * bias)))
    trainer.reserve(EXPORT_S + tile_s * (min(epoch, count) + 2 * numbers.final + 4 * numbers.bias))
    return numbers


def start_of(job: Job, ground: TileData) -> Start:
    """Return the network with its start weights. Raises TrainingError for weights of another network."""
    if job.base_model:
        base = base_weights.read_base(Path(job.base_model))
        net = base_weights.with_classes(base, ground.class_names)
        if base.is_merged:
            pieces = loop.Pieces(ground.training, job, 0)
            base_weights.restore_normalization(net, _batches(pieces, base, job.batch))
        return Start(net, base.architecture, base.mean, base.deviation, job.learning_rate or FROM_BASE)
    net = network.pyramid_attention_network(job.encoder, job.depth, len(ground.classes), job.pretrained)
    architecture = {"encoder": job.encoder, "depth": job.depth}
    if not (job.encoder_weights or job.pretrained):
        return Start(net, architecture, ground.mean, ground.deviation, job.learning_rate or FROM_SCRATCH)
    if job.encoder_weights:
        packaged = job.encoder_weights == PACKAGED
        file = network.packaged_weights() if packaged else Path(job.encoder_weights)
        network.load_encoder_weights(net.encoder, file)
    standardization = network.standardization(job.encoder)
    return Start(net, architecture, *standardization, job.learning_rate or FROM_WEIGHTS)


def _batches(pieces: loop.Pieces, base: base_weights.Base, size: int):
    """Yield standardized batches (N, 3, H, W) of the first pieces."""
    mean, deviation = (torch.tensor(v, dtype=torch.float32).view(1, 3, 1, 1) for v in (base.mean, base.deviation))
    for first in range(0, min(len(pieces), RESTORING_BATCHES * size), size):
        images = [pieces[n][0] for n in range(first, min(first + size, len(pieces)))]
        yield (torch.stack(images).float() - mean) / deviation


def finish(
    job: Job, trainer: loop.Trainer, ground: TileData, start: Start, numbers: ValidationTiles, report: loop.Report
) -> None:
    """Write the model to a temporary file, check and rename it; write the result and the pictures."""
    report("exporting", share=trainer.total_share)
    output, folder = Path(job.output), Path(job.folder)
    temporary = output.with_name(f".{output.name}.part")
    export.write_onnx(trainer.network, ground.tile_size, temporary)
    entries = export.metadata_of(
        ground.classes,
        (start.mean, start.deviation),
        job.tile_size or ground.tile_size,
        job.overlap,
        ground.pixel_size,
        start.architecture,
        (trainer.best_confusion, ground.allowed),
        job.ground,
        {**training_facts(job, trainer, ground), **job.card},
    )
    scores_of = export.scoring(temporary, start.mean, start.deviation)
    entries |= _biases(scores_of, ground, ground.validation.spread(numbers.bias))
    report("exporting", share=trainer.total_share)
    entries[TEMPERATURE] = round(metrics.fit_temperature(scores_of, ground.validation.spread(numbers.final)), 3)
    report("exporting", share=trainer.total_share)
    export.add_metadata(temporary, entries)
    image = tiles.standardized(ground.training(0)[0], start.mean, start.deviation)
    half = max(ground.tile_size // 32 * 16, SMALLEST_IMAGE)
    difference = export.largest_difference(trainer.network, temporary, [image, image[..., :half, :]])
    write_examples(trainer.network, ground.validation, ground.classes, start.mean, start.deviation, folder / EXAMPLES)
    temporary.replace(output)
    result = {
        "classes": [{"name": c.name, "color": c.color} for c in ground.classes],
        "history": trainer.history,
        "best_epoch": trainer.best_epoch,
        "mean_iou": trainer.shown(trainer.best_confusion)["mean_iou"],
        "confusion": trainer.best_confusion[: len(ground.classes)].tolist(),
        "stopped_by": trainer.stopped_by,
        "seconds": round(trainer.seconds, 1),
        "device": _device_name(trainer.device),
        "training": len(ground.training),
        "validation": len(ground.validation),
        "bytes": output.stat().st_size,
        "difference": difference,
        **start.architecture,
    }
    (folder / RESULT).write_text(json.dumps(result), encoding="utf-8")
    report("done", **{key: result[key] for key in ("best_epoch", "stopped_by", "seconds", "bytes", "difference")})


def _biases(
    scores_of: Callable[[np.ndarray], np.ndarray], ground: TileData, reader: tiles.TileReader
) -> dict[str, str]:
    """Return the metadata entry of the class offsets; empty without a pixel size or enough landmarks."""
    if not ground.pixel_size:
        return {}
    rows = class_bias.measure_class_biases(
        lambda image: scores_of(image).argmax(0).astype(np.uint8), reader, len(ground.classes)
    )
    biases = {ground.class_names[row.ground.value]: row.bias(ground.pixel_size) for row in rows}
    return {KEY: class_bias_text(biases)} if biases else {}


def training_facts(job: Job, trainer: loop.Trainer, ground: TileData) -> dict:
    """Return the entries of the model card about the training."""
    return {
        "date": date.today().isoformat(),
        "training": {
            "minutes": round(trainer.seconds / 60, 1),
            "pieces": trainer.step * job.batch,
            "piece_size": job.piece_size,
            "tiles": len(ground.training),
            "validation_tiles": len(ground.validation),
            "seed": job.seed,
            "start": Path(job.base_model).name or job.encoder,
        },
    }


def _device_name(device: torch.device) -> str:
    return torch.cuda.get_device_name(device) if device.type == "cuda" else "CPU"


EDGE_PX, GAP_PX, MOST = 256, 8, 4
UNKNOWN = (200, 200, 200)


def write_examples(
    network: torch.nn.Module, reader: TileReader, classes: Sequence[LandCoverClass], mean, deviation, folder: Path
) -> None:
    """Write example_N.png of some evenly spread tiles: photo, annotation and prediction side by side."""
    folder.mkdir(exist_ok=True)
    colors = np.full((256, 3), UNKNOWN, np.uint8)
    colors[: len(classes)] = [c.rgb for c in classes]
    network = network.cpu().eval()
    for number, index in enumerate(spread(len(reader), MOST)):
        image, labels = reader(index)
        with torch.inference_mode():
            found = network(torch.from_numpy(standardized(image, mean, deviation))).argmax(1)[0].numpy()
        shown = [np.clip(image * 255 + 0.5, 0, 255).astype(np.uint8), colors[labels], colors[found]]
        gap = np.full((EDGE_PX, GAP_PX, 3), 255, np.uint8)
        small = [cv2.resize(one, (EDGE_PX, EDGE_PX), interpolation=cv2.INTER_AREA) for one in shown]
        picture = np.hstack([small[0], gap, small[1], gap, small[2]])
        cv2.imwrite(str(folder / f"example_{number}.png"), np.ascontiguousarray(picture[:, :, ::-1]))
