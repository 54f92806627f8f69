"""Train a network on pieces of tiles, with curves in a CSV file, resuming, early stop and a time limit."""

from __future__ import annotations

import csv
import math
import time
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path

import numpy as np
import torch
from torch.nn import functional
from torch.optim.swa_utils import AveragedModel

from ..core.errors import TrainingError
from .augment import random_light, random_piece
from .job import CHECKPOINT, FREE, Job
from .metrics import confusion_matrix, decided_channels, intersection_over_union
from .tiles import IGNORED, TileReader

AVERAGING = 0.995  # largest share of the old weights in their running average, per step
WEIGHT_DECAY, LARGEST_GRADIENT = 1e-2, 5.0
WARM_UP_SHARE = 0.05  # of the run, in which the learning rate rises
FIRST_RATE = 0.04  # share of the learning rate at the first step
REPORT_EVERY_S = 0.5
TRAINED = 0.97  # share of the work that is training, without a time limit
BEST, CURVES = "best.pt", "curves.csv"

Report = Callable[..., None]
"""``report(event, **values)`` informs the caller of the training."""


class Pieces(torch.utils.data.Dataset):
    """Random pieces of tiles; equal seed and epoch give equal pieces."""

    def __init__(self, reader: TileReader, job: Job, epoch: int) -> None:
        self._reader, self._job, self._epoch = reader, job, epoch

    def __len__(self) -> int:
        return self._job.pieces

    def __getitem__(self, index: int):
        rng = np.random.default_rng([self._job.seed, self._epoch, index])
        image, labels = self._reader(int(rng.integers(len(self._reader))))
        piece, marks = random_piece(rng, image, labels, self._job.piece_size)
        piece = random_light(rng, piece, self._job.light)
        return torch.from_numpy(piece.transpose(2, 0, 1).copy()), torch.from_numpy(marks).long()


class Trainer:
    """Trains a network; after ``run`` the network has the best weights.

    Attributes:
        history: A row of the curves for each epoch.
        best_confusion: (L, K) pixels of each label and predicted class on the validation tiles in the best epoch.
        stopped_by: ``epochs``, ``patience`` or ``minutes``.
    """

    def __init__(self, network, mean, deviation, class_names, class_weights, allowed, job: Job, report: Report) -> None:
        """Prepare a run in the folder of a job.

        Args:
            class_weights: (L,) weight of each label.
            allowed: (L, K) bool of the classes that each label allows (``metrics.partial_labels``).
            job: With all defaults filled in (``train.with_defaults``).
        """
        self.device = torch.device("cuda" if torch.cuda.is_available() else "cpu")
        self.layout = torch.channels_last if job.channels_last else torch.contiguous_format
        self.network = network.to(self.device, memory_format=self.layout)
        self.average = AveragedModel(self.network, avg_fn=running_average, use_buffers=True)
        self.mean = torch.tensor(mean, dtype=torch.float32, device=self.device).view(1, 3, 1, 1)
        self.deviation = torch.tensor(deviation, dtype=torch.float32, device=self.device).view(1, 3, 1, 1)
        self.class_names = class_names
        self.weights = torch.tensor(class_weights, dtype=torch.float32, device=self.device)
        self.allowed = np.asarray(allowed, bool)
        self._meanings = torch.tensor(self.allowed, device=self.device)
        self.job, self.folder, self.report = job, Path(job.folder), report
        self.optimizer = torch.optim.AdamW(self.network.parameters(), job.learning_rate, weight_decay=WEIGHT_DECAY)
        self.steps_an_epoch = max(1, job.pieces // job.batch)
        is_auto, has_gpu = job.mixed_precision == "auto", self.device.type == "cuda"
        self.is_mixed = job.mixed_precision == "on" or (is_auto and has_gpu)
        self.scaler = torch.amp.GradScaler("cuda", enabled=self.is_mixed and has_gpu)
        self.epoch, self.step, self.best_score, self.best_epoch = 0, 0, -1.0, 0
        self.history: list[dict] = []
        self.best_confusion = np.zeros(self.allowed.shape, np.int64)
        self.stopped_by = ""
        self._seconds_before, self._reported = 0.0, 0.0
        self._clock = time.process_time if job.processor_time else time.monotonic
        self.began = self._clock()
        self._trained = TRAINED

    @property
    def seconds(self) -> float:
        """Duration of the run, including interrupted parts."""
        return self._seconds_before + self._clock() - self.began

    @property
    def share(self) -> float:
        """Share of the training that is done, 0…1: of the steps, or of the time limit if that is larger."""
        by_steps = self.step / (self.job.epochs * self.steps_an_epoch)
        by_time = self.seconds / (60 * self.job.minutes * self._trained) if self.job.minutes else 0.0
        return min(max(by_steps, by_time), 1.0)

    @property
    def total_share(self) -> float:
        """Share of all work until the model is written, 0…1; with a time limit at least the share of time."""
        passed = self.seconds / (60 * self.job.minutes) if self.job.minutes else 0.0
        return min(max(self.share * self._trained, passed), 1.0)

    def reserve(self, seconds: float) -> None:
        """Reserve seconds of the time limit for the work after the training, at most half of the limit."""
        self._trained = 1 - min(seconds / (60 * self.job.minutes), 0.5)

    def run(self, reader: TileReader, validation: TileReader) -> None:
        """Train until a limit is reached, and load the best weights: those of the start if training does not help."""
        if not self.epoch:
            confusion = self.confusion(self.network, validation)
            self._save_best(self.network, self.shown(confusion)["mean_iou"], confusion)
        while not self._is_over():
            started = time.monotonic()
            loss = self._train_epoch(reader)
            self.epoch += 1
            confusion = self.confusion(self.average, validation)
            row = {"epoch": self.epoch, "training_loss": round(loss, 4), **self.shown(confusion)}
            row |= {"learning_rate": f"{learning_rate_at(self.share, self.job.learning_rate):.2e}"}
            row |= {"seconds": round(time.monotonic() - started, 1)}
            self.history.append(row)
            self._write_curves()
            self._save(row["mean_iou"], confusion)
            self.report("epoch", share=self.total_share, **row)
        self.network.load_state_dict(torch.load(self.folder / BEST, map_location=self.device, weights_only=True))

    def _is_over(self) -> bool:
        limits = {
            "epochs": self.epoch >= self.job.epochs,
            "patience": 0 < self.job.patience <= self.epoch - self.best_epoch,
            "minutes": bool(self.job.minutes) and self.epoch > 0 and self.share >= 1,
        }
        self.stopped_by = next((name for name, reached in limits.items() if reached), "")
        return bool(self.stopped_by)

    def _train_epoch(self, reader: TileReader) -> float:
        loader = torch.utils.data.DataLoader(
            Pieces(reader, self.job, self.epoch),
            self.job.batch,
            drop_last=self.job.pieces >= self.job.batch,
            num_workers=self.job.workers,
            pin_memory=self.device.type == "cuda",
        )
        self.network.train()
        total, count = 0.0, 0
        for images, labels in loader:
            total += self._step(images.to(self.device), labels.to(self.device))
            count += 1
            self._report_step(total / count)
            if self.job.minutes and self.share >= 1:
                break
        if not np.isfinite(total):
            raise TrainingError("The training failed: the loss is not a number. Train with a lower learning rate.")
        return total / max(count, 1)

    def _report_step(self, loss: float) -> None:
        if time.monotonic() - self._reported > REPORT_EVERY_S:
            self._reported = time.monotonic()
            self.report("step", share=self.total_share, epoch=self.epoch + 1, loss=round(loss, 4))

    def _step(self, images: torch.Tensor, labels: torch.Tensor) -> float:
        for group in self.optimizer.param_groups:
            group["lr"] = learning_rate_at(self.share, self.job.learning_rate)
        self.optimizer.zero_grad(set_to_none=True)
        with torch.autocast(self.device.type, self._half, enabled=self.is_mixed):
            logits = self.network(self._standardize(images))
        loss = segmentation_loss(logits.float(), labels, self.weights, self._meanings)
        self.scaler.scale(loss).backward()
        self.scaler.unscale_(self.optimizer)
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), LARGEST_GRADIENT)
        self.scaler.step(self.optimizer)
        self.scaler.update()
        self.step += 1
        self.average.update_parameters(self.network)
        return loss.item()

    @property
    def _half(self) -> torch.dtype:
        return torch.float16 if self.device.type == "cuda" else torch.bfloat16

    def _standardize(self, images: torch.Tensor) -> torch.Tensor:
        return ((images - self.mean) / self.deviation).contiguous(memory_format=self.layout)

    def confusion(self, network: torch.nn.Module, reader: TileReader) -> np.ndarray:
        """Return (L, K) pixels of each label and predicted class on whole tiles."""
        network.eval()
        count = len(self.class_names)
        sets = len(self.allowed) - count
        confusion = np.zeros((count + sets, count), np.int64)
        with torch.inference_mode():
            for index in range(len(reader)):
                image, labels = reader(index)
                batch = torch.from_numpy(image.transpose(2, 0, 1)[None].copy()).to(self.device)
                predicted = network(self._standardize(batch)).argmax(1)[0].cpu().numpy()
                confusion += confusion_matrix(labels, predicted, count, sets)
        return confusion

    def shown(self, confusion: np.ndarray) -> dict:
        """Return the intersection over union of each class and their mean; without tiles the mean is 0."""
        iou = intersection_over_union(confusion, self.allowed)
        shown = {f"iou_{name}": round(float(v), 4) for name, v in zip(self.class_names, iou) if np.isfinite(v)}
        return {"mean_iou": round(float(np.nanmean(iou)), 4) if shown else 0.0} | shown

    def _write_curves(self) -> None:
        with (self.folder / CURVES).open("w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, list(self.history[-1]))
            writer.writeheader()
            writer.writerows(self.history)

    def _save_best(self, network: torch.nn.Module, score: float, confusion: np.ndarray) -> None:
        """Save the weights if they are the best ones, or the last ones without validation tiles."""
        if score > self.best_score or score == 0.0:
            self.best_score, self.best_epoch, self.best_confusion = score, self.epoch, confusion
            self._write(BEST, network.state_dict())

    def _save(self, score: float, confusion: np.ndarray) -> None:
        self._save_best(self.average.module, score, confusion)
        state = {
            "network": self.network.state_dict(),
            "average": self.average.state_dict(),
            "optimizer": self.optimizer.state_dict(),
            "scaler": self.scaler.state_dict(),
            "progress": [self.epoch, self.step, self.best_score, self.best_epoch, self.seconds],
            "history": self.history,
            "best_confusion": self.best_confusion.tolist(),
            "settings": self._settings(),
        }
        self._write(CHECKPOINT, state)

    def _settings(self) -> dict:
        """Return the settings as a checkpoint has them: whether the precision is mixed depends on the machine."""
        return {**asdict(self.job), "mixed_precision": self.is_mixed}

    def _write(self, name: str, state: dict) -> None:
        """Write a file and rename it when it is complete, as the process may end at any time. Raises TrainingError."""
        part = self.folder / f"{name}.part"
        try:
            torch.save(state, part)
            part.replace(self.folder / name)
        except (OSError, RuntimeError) as error:
            raise TrainingError(
                "The training can't be saved in {folder} ({reason}). Free some disk space and start the training "
                "again; it continues after the last saved epoch.",
                folder=self.folder,
                reason=_first_line(error),
            ) from None

    def resume(self) -> None:
        """Continue the last run in the folder. Raises TrainingError if this is impossible."""
        path = self.folder / CHECKPOINT
        try:
            state = torch.load(path, map_location=self.device, weights_only=True)
        except Exception as error:  # torch raises many kinds for incomplete files
            raise TrainingError(
                "{path} is damaged ({reason}), so this training can't be continued; start it again without the "
                "earlier run.",
                path=path,
                reason=_first_line(error),
            ) from None
        settings = self._settings()
        differing = [k for k, v in state["settings"].items() if k not in FREE and settings.get(k) != v]
        if differing:
            raise TrainingError(
                "The run in {folder} had other settings ({settings}). Use the same settings, or start a new training.",
                folder=self.folder,
                settings=differing,
            )
        for name in ("network", "average", "optimizer", "scaler"):
            getattr(self, name).load_state_dict(state[name])
        self.epoch, self.step, self.best_score, self.best_epoch, self._seconds_before = state["progress"]
        self.history, self.best_confusion = state["history"], np.array(state["best_confusion"], np.int64)


def _first_line(error: Exception) -> str:
    return str(error).partition("\n")[0].rstrip(".")


def learning_rate_at(share: float, largest: float) -> float:
    """Return the one-cycle learning rate (Smith 2018, arXiv:1803.09820): a short rise, then half a cosine to 0."""
    if share < WARM_UP_SHARE:
        return largest * (FIRST_RATE + (1 - FIRST_RATE) * (1 - math.cos(math.pi * share / WARM_UP_SHARE)) / 2)
    return largest * (1 + math.cos(math.pi * (share - WARM_UP_SHARE) / (1 - WARM_UP_SHARE))) / 2


def running_average(old: torch.Tensor, new: torch.Tensor, count: torch.Tensor) -> torch.Tensor:
    """Return the mean of the first weights, later an exponential average that soon forgets them."""
    return old + (new - old) * torch.clamp(10 / (count + 10), min=1 - AVERAGING)


def segmentation_loss(
    logits: torch.Tensor, labels: torch.Tensor, weights: torch.Tensor, allowed: torch.Tensor
) -> torch.Tensor:
    """Return weighted cross-entropy plus half the soft Dice loss (Milletari et al. 2016) of the classes in the batch.

    Args:
        logits: (N, K, H, W).
        labels: (N, H, W) int64, IGNORED for unknown pixels.
        weights: (L,) weight of each label.
        allowed: (L, K) bool of the classes that each label allows (``metrics.partial_labels``).
    """
    known = labels != IGNORED
    if not known.any():
        return logits.sum() * 0.0
    count, index = logits.shape[1], labels.where(known, 0)
    logs = logits.log_softmax(1)
    right = logs.gather(1, index.clamp(max=count - 1)[:, None])[:, 0]
    decided = known[:, None]
    for number in range(count, len(allowed)):
        right = right.where(labels != number, logs[:, allowed[number]].logsumexp(1))
    if len(allowed) > count:
        decided = decided & decided_channels(allowed)[index].movedim(-1, 1)
    weight = weights[index] * known
    entropy = -(right * weight).sum() / weight.sum()
    shares = logs.exp() * decided
    truth = functional.one_hot(index, len(allowed)).movedim(-1, 1)[:, :count] * known[:, None]
    both, either = (shares * truth).sum((0, 2, 3)), (shares + truth).sum((0, 2, 3))
    present = truth.sum((0, 2, 3)) > 0
    dice = 1 - ((2 * both + 1) / (either + 1))[present].mean() if present.any() else 0.0
    return entropy + 0.5 * dice
