"""A whole training, from tiles to a checked ONNX file with its metadata."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import date
from pathlib import Path

import numpy as np
import torch

from ..core.errors import TrainingError
from ..core.segmentation.class_bias import KEY, class_bias_text
from ..core.segmentation.metadata import TEMPERATURE
from . import (
    base_weights,
    class_bias,
    encoder_weights,
    examples,
    export,
    loop,
    metadata,
    metrics,
    network,
    temperature,
    tiles,
)
from .job import CHECKPOINT, EXAMPLES, FEWEST_PIECES, MOST_PIECES, NETWORK, PACKAGED, RESULT, Job
from .partial import partial_labels

FROM_SCRATCH, FROM_WEIGHTS, FROM_BASE = 3e-3, 1e-3, 5e-4
"""Learning rates that suit random weights, an encoder that knows photos, and a network that knows the classes."""

WATCHED_TILES, JUDGED_TILES, TURNED_TILES = 16, 100, 25
"""Validation tiles where minutes are limited, at most: each epoch; in the end; for how far off classes are shown (four
looks at each)."""

LONGEST_END, EXPORT_S = 0.2, 15.0
"""Share of the time limit in which the network is judged at the end, at most; seconds to write and check the model."""

LONGEST_WATCH = 0.02
"""Share of the time limit in which an epoch is judged, at most."""

SMALLEST_IMAGE = 128
"""Edge in pixels of which the network's pyramid leaves something."""

RESTORING_BATCHES = 8
"""Batches that restore the normalization of a base model."""


@dataclass(frozen=True)
class TrainingGround:
    """What is learned from.

    Attributes:
        classes: By channel.
        training: Reads tiles.
        validation: Reads those that were set aside.
        pixels: (L,) of each label.
        allowed: (L, K) the classes that each label allows (partial.py).
        tile_size: Edge, pixels.
        pixel_size: Meters, None where it is not known.
        mean: (3,) of red, green and blue.
        deviation: (3,) of the same.
    """

    classes: list[tiles.TileClass]
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
    """A network to train: what it is built of, and how its photos are standardized."""

    network: torch.nn.Module
    architecture: dict
    mean: np.ndarray
    deviation: np.ndarray
    learning_rate: float


@dataclass(frozen=True)
class Looks:
    """How many validation tiles are looked at: each epoch, to judge the best network, and for the classes' shifts."""

    watched: int
    judged: int
    turned: int


def run(job: Job, tell: loop.Tell, began: float | None = None) -> loop.Trainer:
    """Trains, exports and checks; ``job.folder`` then holds the result and pictures. Raises TrainingError.

    ``began``: when the process was started (time.monotonic), as its time is limited; otherwise now.
    """
    began = time.monotonic() if began is None else began
    torch.manual_seed(job.seed)
    if job.threads:
        torch.set_num_threads(job.threads)
    ground = read_ground(job)
    settings = settings_of(job, ground)
    start = start_of(job, ground, settings)
    folder = Path(job.folder)
    folder.mkdir(parents=True, exist_ok=True)
    said = {"class_names": ground.class_names, "standardization_mean": start.mean.tolist()}
    said |= {"standardization_std": start.deviation.tolist()}
    (folder / NETWORK).write_text(json.dumps({**start.architecture, **said}), encoding="utf-8")
    settings = loop.Settings(**{**settings.__dict__, "learning_rate": start.learning_rate})
    weights = metrics.class_weights(ground.pixels)
    trainer = loop.Trainer(
        *(start.network, start.mean, start.deviation, ground.class_names),
        *(weights, ground.allowed, settings, folder, tell),
    )
    if not job.processor_time:
        trainer.began = began
    tell(
        "begun",
        device=_device_name(trainer.device),
        training=len(ground.training),
        validation=len(ground.validation),
        weights=sum(p.numel() for p in start.network.parameters()),
        class_weights=[round(float(weight), 2) for weight in weights],
    )
    if job.resume and (folder / CHECKPOINT).exists():
        trainer.resume()
        tell("resumed", epoch=trainer.epoch, share=trainer.told_share)
    looks = looks_of(job, trainer, ground.validation)
    watched = ground.validation.spread(looks.watched)
    trainer.run(ground.training, watched)
    if len(watched) < len(ground.validation):
        trainer.best_confusion = trainer.confusion(trainer.network, ground.validation.spread(looks.judged))
    finish(job, trainer, ground, start, looks, tell)
    return trainer


def read_ground(job: Job) -> TrainingGround:
    """Raises TrainingError for tiles that can't be learned from."""
    folders = tiles.open_folders([Path(path) for path in job.tiles])
    classes = [export.UNLABELED, *folders[0].classes]
    if job.learn_unlabeled:
        classes[0] = tiles.TileClass(0, "other", "#000000", "background")
    values = [c.value for c in classes]
    names, complete = [c.name for c in classes], {Path(path): known for path, known in job.complete.items()}
    excluded = {f.path: [names.index(name) for name in complete[f.path]] for f in folders if f.path in complete}
    allowed, zeros = partial_labels(len(classes), excluded)
    pixels = np.zeros(len(allowed), np.int64)
    for folder in folders:
        counts = folder.class_pixels("train")
        pixels[1 : len(values)] += [counts.get(str(v), 0) for v in values[1:]]
        zero = zeros.get(folder.path, 0 if job.learn_unlabeled else None)
        if zero not in (None, tiles.IGNORED):
            pixels[zero] += counts.get("0", 0)
    if np.count_nonzero(pixels) < 2:
        raise TrainingError(
            "Only one class ({name}) is labeled, and ground without a label counts as unknown: there is nothing to "
            "tell apart. Label another class, or let ground without a label be a class of its own.",
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
    return TrainingGround(
        classes,
        training,
        validation,
        pixels,
        allowed,
        min(folder.manifest["tile_size"] for folder in folders),
        job.resolution or (sizes.pop() if len(sizes) == 1 else None),
        *tiles.band_statistics(folders),
    )


def settings_of(job: Job, ground: TrainingGround) -> loop.Settings:
    covering = len(ground.training) * max(1, (ground.tile_size // min(job.piece_size, ground.tile_size)) ** 2)
    if job.minutes:
        covering = min(max(covering, FEWEST_PIECES), MOST_PIECES)
    return loop.Settings(
        epochs=job.epochs,
        pieces=job.pieces or covering,
        piece_size=min(job.piece_size, ground.tile_size),
        batch=job.batch,
        learning_rate=job.learning_rate,
        patience=job.patience,
        mixed_precision=job.mixed_precision == "on" or (job.mixed_precision == "auto" and torch.cuda.is_available()),
        channels_last=job.channels_last,
        workers=job.workers,
        seed=job.seed,
        light=job.light,
        minutes=job.minutes,
        processor_time=job.processor_time,
    )


def looks_of(job: Job, trainer: loop.Trainer, reader: tiles.TileReader) -> Looks:
    """As many looks as there is time for at the end; that time is reserved. All tiles without a time limit."""
    count = len(reader)
    if not job.minutes:
        return Looks(count, min(JUDGED_TILES, count), count)
    trainer.confusion(trainer.network, reader.spread(1))
    started = time.monotonic()
    trainer.confusion(trainer.network, reader.spread(2))
    tile_s = (time.monotonic() - started) / max(min(count, 2), 1)
    judged, turned = min(JUDGED_TILES, count), min(TURNED_TILES, count)
    share = min(1.0, 60 * job.minutes * LONGEST_END / max(tile_s * (2 * judged + 4 * turned), 1e-6))
    watched = min(WATCHED_TILES, max(2, int(60 * job.minutes * LONGEST_WATCH / max(tile_s, 1e-6))))
    looks = Looks(watched, max(1, int(share * judged)), max(1, int(share * turned)))
    trainer.reserve(EXPORT_S + tile_s * (min(watched, count) + 2 * looks.judged + 4 * looks.turned))
    return looks


def start_of(job: Job, ground: TrainingGround, settings: loop.Settings) -> Start:
    """The network with what it knows at the start. Raises TrainingError for weights that don't fit."""
    if job.base_model:
        base = base_weights.read_base(Path(job.base_model))
        net = base_weights.with_classes(base, ground.class_names)
        if base.is_merged:
            pieces = loop.Pieces(ground.training, settings, 0)
            base_weights.restore_normalization(net, _batches(pieces, base, job.batch))
        return Start(net, base.architecture, base.mean, base.deviation, job.learning_rate or FROM_BASE)
    net = network.pyramid_attention_network(job.encoder, job.depth, len(ground.classes), job.pretrained)
    architecture = {"encoder": job.encoder, "depth": job.depth}
    if not (job.encoder_weights or job.pretrained):
        return Start(net, architecture, ground.mean, ground.deviation, job.learning_rate or FROM_SCRATCH)
    if job.encoder_weights:
        packaged = job.encoder_weights == PACKAGED
        file = encoder_weights.packaged_weights() if packaged else Path(job.encoder_weights)
        encoder_weights.load_encoder_weights(net.encoder, file)
    standardization = encoder_weights.standardization(job.encoder)
    return Start(net, architecture, *standardization, job.learning_rate or FROM_WEIGHTS)


def _batches(pieces: loop.Pieces, base: base_weights.Base, size: int):
    """Standardized batches (N, 3, H, W) of the first pieces."""
    mean, deviation = (torch.tensor(v, dtype=torch.float32).view(1, 3, 1, 1) for v in (base.mean, base.deviation))
    for first in range(0, min(len(pieces), RESTORING_BATCHES * size), size):
        images = [pieces[n][0] for n in range(first, min(first + size, len(pieces)))]
        yield (torch.stack(images).float() - mean) / deviation


def finish(
    job: Job, trainer: loop.Trainer, ground: TrainingGround, start: Start, looks: Looks, tell: loop.Tell
) -> None:
    """Writes the model beside its place, checks it and moves it there; then the result, with pictures."""
    tell("exporting", share=trainer.told_share)
    output, folder = Path(job.output), Path(job.folder)
    temporary = output.with_name(f".{output.name}.part")
    export.write_onnx(trainer.network, ground.tile_size, temporary)
    entries = metadata.entries(
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
    entries |= _biases(export.answering(scores_of), ground, ground.validation.spread(looks.turned))
    tell("exporting", share=trainer.told_share)
    entries |= _temperature(scores_of, ground.validation.spread(looks.judged))
    tell("exporting", share=trainer.told_share)
    export.add_metadata(temporary, entries)
    image = (ground.training(0)[0].transpose(2, 0, 1) - start.mean[:, None, None]) / start.deviation[:, None, None]
    half = max(ground.tile_size // 32 * 16, SMALLEST_IMAGE)
    difference = export.largest_difference(trainer.network, temporary, [image, image[:, :half, : ground.tile_size]])
    examples.write_examples(
        trainer.network, ground.validation, ground.classes, start.mean, start.deviation, folder / EXAMPLES
    )
    temporary.replace(output)
    result = {
        "classes": [c.__dict__ for c in ground.classes],
        "history": trainer.history,
        "best_epoch": trainer.best_epoch,
        "mean_iou": mean_iou(trainer.best_confusion, ground.allowed),
        "confusion": trainer.best_confusion[: len(ground.classes)].tolist(),
        "stopped_by": trainer.stopped_by,
        "seconds": round(trainer.seconds, 1),
        "seconds_a_piece": round(sum(row["seconds"] for row in trainer.history) / max(trainer.step * job.batch, 1), 4),
        "device": _device_name(trainer.device),
        "training": len(ground.training),
        "validation": len(ground.validation),
        "bytes": output.stat().st_size,
        "difference": difference,
        **start.architecture,
    }
    (folder / RESULT).write_text(json.dumps(result), encoding="utf-8")
    tell("done", **{key: result[key] for key in ("best_epoch", "stopped_by", "seconds", "bytes", "difference")})


def _biases(
    answer: Callable[[np.ndarray], np.ndarray], ground: TrainingGround, reader: tiles.TileReader
) -> dict[str, str]:
    """The entry of the metadata that says how far off classes are shown; none without meters or enough landmarks."""
    rows = class_bias.measured(answer, reader, len(ground.classes)) if ground.pixel_size else []
    biases = {ground.class_names[row.ground.value]: row.bias(ground.pixel_size) for row in rows}
    return {KEY: class_bias_text(biases)} if biases else {}


def training_facts(job: Job, trainer: loop.Trainer, ground: TrainingGround) -> dict:
    """What a model's card tells of any training."""
    return {
        "date": date.today().isoformat(),
        "training": {
            "minutes": round(trainer.seconds / 60, 1),
            "pieces": trainer.step * job.batch,
            "piece_size": trainer.settings.piece_size,
            "tiles": len(ground.training),
            "validation_tiles": len(ground.validation),
            "seed": job.seed,
            "start": Path(job.base_model).name or job.encoder,
        },
    }


def _temperature(scores_of: Callable[[np.ndarray], np.ndarray], reader: tiles.TileReader) -> dict[str, float]:
    """The entry of the metadata that makes probabilities of scores; none without validation tiles."""
    found = temperature.fitted(scores_of, reader)
    return {} if found is None else {TEMPERATURE: round(found, 3)}


def mean_iou(confusion: np.ndarray, allowed: np.ndarray) -> float:
    """Of the classes that have a true pixel; 0 without any."""
    found = metrics.intersection_over_union(confusion, allowed)
    return round(float(np.nanmean(found)), 4) if np.isfinite(found).any() else 0.0


def _device_name(device: torch.device) -> str:
    return torch.cuda.get_device_name(device) if device.type == "cuda" else "CPU"
