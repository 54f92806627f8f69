"""Training: pieces of tiles in, best weights out, with curves in a CSV file, resuming and early stopping."""

from __future__ import annotations

import csv
import time
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
import torch
from torch.nn import functional
from torch.optim.swa_utils import AveragedModel

from .augment import random_light, random_piece
from .metrics import confusion_matrix, intersection_over_union
from .tiles import IGNORED, TileReader, TrainingError

AVERAGING = 0.995  # largest share of the old weights in their running average, a step
WEIGHT_DECAY, LARGEST_GRADIENT = 1e-2, 5.0
WARM_UP_SHARE = 0.05  # of all steps, in which the learning rate rises
MACHINE = ("channels_last", "workers")  # settings that don't decide the result
CHECKPOINT, BEST, CURVES = "last.pt", "best.pt", "curves.csv"


@dataclass(frozen=True)
class Settings:
    """What a run is made with; a run is resumed with the same."""

    epochs: int
    pieces: int  # an epoch
    piece_size: int
    batch: int
    learning_rate: float
    patience: int  # epochs without a better validation before it stops; 0: never
    mixed_precision: bool
    channels_last: bool
    workers: int
    seed: int
    light: float = 1.0  # how much light and color of the pieces vary


class Pieces(torch.utils.data.Dataset):
    """Random pieces of tiles; the same seed and epoch give the same pieces."""

    def __init__(self, reader: TileReader, settings: Settings, epoch: int) -> None:
        self._reader, self._settings, self._epoch = reader, settings, epoch

    def __len__(self) -> int:
        return self._settings.pieces

    def __getitem__(self, index: int):
        rng = np.random.default_rng([self._settings.seed, self._epoch, index])
        image, labels = self._reader(int(rng.integers(len(self._reader))))
        piece, marks = random_piece(rng, image, labels, self._settings.piece_size)
        piece = random_light(rng, piece, self._settings.light)
        return torch.from_numpy(piece.transpose(2, 0, 1).copy()), torch.from_numpy(marks).long()


class Trainer:
    """Trains a network in ``folder``; ``run`` returns with the best weights loaded into it."""

    def __init__(self, network, mean, deviation, class_names, class_weights, settings: Settings, folder: Path) -> None:
        self.device = torch.device("cuda" if torch.cuda.is_available() else "cpu")
        self.layout = torch.channels_last if settings.channels_last else torch.contiguous_format
        self.network = network.to(self.device, memory_format=self.layout)
        self.average = AveragedModel(self.network, avg_fn=running_average, use_buffers=True)
        self.mean = torch.tensor(mean, dtype=torch.float32, device=self.device).view(1, 3, 1, 1)
        self.deviation = torch.tensor(deviation, dtype=torch.float32, device=self.device).view(1, 3, 1, 1)
        self.class_names = class_names
        self.weights = torch.tensor(class_weights, dtype=torch.float32, device=self.device)
        self.settings, self.folder = settings, folder
        self.optimizer = torch.optim.AdamW(self.network.parameters(), settings.learning_rate, weight_decay=WEIGHT_DECAY)
        self.steps_an_epoch = max(1, settings.pieces // settings.batch)
        self.schedule = torch.optim.lr_scheduler.OneCycleLR(
            self.optimizer,
            settings.learning_rate,
            total_steps=settings.epochs * self.steps_an_epoch,
            pct_start=WARM_UP_SHARE,
            cycle_momentum=False,
        )
        self.scaler = torch.amp.GradScaler("cuda", enabled=settings.mixed_precision and self.device.type == "cuda")
        self.epoch, self.best_score, self.best_epoch = 0, -1.0, 0

    def run(self, reader: TileReader, validation: TileReader) -> None:
        while self.epoch < self.settings.epochs and not self._is_stuck():
            started = time.monotonic()
            loss = self._train_epoch(reader)
            self.epoch += 1
            row = {"epoch": self.epoch, "training_loss": round(loss, 4)}
            row |= self._validated(validation)
            row |= {"learning_rate": f"{self.schedule.get_last_lr()[0]:.2e}"}
            row |= {"seconds": round(time.monotonic() - started, 1)}
            self._write_curves(row)
            self._save(row["mean_iou"])
            print(" ".join(f"{key} {value}" for key, value in row.items()), flush=True)
        self.network.load_state_dict(torch.load(self.folder / BEST, map_location=self.device, weights_only=True))

    def _is_stuck(self) -> bool:
        return 0 < self.settings.patience <= self.epoch - self.best_epoch

    def _train_epoch(self, reader: TileReader) -> float:
        loader = torch.utils.data.DataLoader(
            Pieces(reader, self.settings, self.epoch),
            self.settings.batch,
            drop_last=True,
            num_workers=self.settings.workers,
            pin_memory=self.device.type == "cuda",
        )
        self.network.train()
        total = 0.0
        for images, labels in loader:
            loss = self._step(images.to(self.device), labels.to(self.device))
            total += loss
        if not np.isfinite(total):
            raise TrainingError("The loss is no longer a number; train with a lower --learning-rate.")
        return total / self.steps_an_epoch

    def _step(self, images: torch.Tensor, labels: torch.Tensor) -> float:
        self.optimizer.zero_grad(set_to_none=True)
        with torch.autocast(self.device.type, self._half, enabled=self.settings.mixed_precision):
            logits = self.network(self._standardized(images))
        loss = segmentation_loss(logits.float(), labels, self.weights)
        self.scaler.scale(loss).backward()
        self.scaler.unscale_(self.optimizer)
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), LARGEST_GRADIENT)
        self.scaler.step(self.optimizer)
        self.scaler.update()
        self.schedule.step()
        self.average.update_parameters(self.network)
        return loss.item()

    @property
    def _half(self) -> torch.dtype:
        return torch.float16 if self.device.type == "cuda" else torch.bfloat16

    def _standardized(self, images: torch.Tensor) -> torch.Tensor:
        return ((images - self.mean) / self.deviation).contiguous(memory_format=self.layout)

    def _validated(self, reader: TileReader) -> dict:
        """Intersection over union a class of the averaged weights on whole tiles; without tiles all of it is 0."""
        self.average.eval()
        count = len(self.class_names)
        confusion = np.zeros((count, count), np.int64)
        with torch.inference_mode():
            for index in range(len(reader)):
                image, labels = reader(index)
                batch = torch.from_numpy(image.transpose(2, 0, 1)[None].copy()).to(self.device)
                predicted = self.average(self._standardized(batch)).argmax(1)[0].cpu().numpy()
                confusion += confusion_matrix(labels, predicted, count)
        iou = intersection_over_union(confusion)
        shown = {f"iou_{name}": round(float(v), 4) for name, v in zip(self.class_names, iou) if np.isfinite(v)}
        return {"mean_iou": round(float(np.nanmean(iou)), 4) if shown else 0.0} | shown

    def _write_curves(self, row: dict) -> None:
        path = self.folder / CURVES
        is_new = self.epoch == 1
        with path.open("w" if is_new else "a", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, list(row))
            if is_new:
                writer.writeheader()
            writer.writerow(row)

    def _save(self, score: float) -> None:
        """Best weights (the last ones where nothing validates) and everything that resuming needs."""
        if score > self.best_score or score == 0.0:
            self.best_score, self.best_epoch = score, self.epoch
            torch.save(self.average.module.state_dict(), self.folder / BEST)
        state = {
            "network": self.network.state_dict(),
            "average": self.average.state_dict(),
            "optimizer": self.optimizer.state_dict(),
            "schedule": self.schedule.state_dict(),
            "scaler": self.scaler.state_dict(),
            "progress": [self.epoch, self.best_score, self.best_epoch],
            "settings": asdict(self.settings),
        }
        torch.save(state, self.folder / f"{CHECKPOINT}.part")
        (self.folder / f"{CHECKPOINT}.part").replace(self.folder / CHECKPOINT)

    def resume(self) -> None:
        """Goes on where the last run in the folder stopped. Raises TrainingError when it had other settings."""
        path = self.folder / CHECKPOINT
        if not path.exists():
            raise TrainingError(f"There is no run to resume in {self.folder}; leave out --resume.")
        state = torch.load(path, map_location=self.device, weights_only=True)
        differing = [k for k, v in asdict(self.settings).items() if k not in MACHINE and state["settings"].get(k) != v]
        if differing:
            raise TrainingError(f"The run in {self.folder} had another {' and '.join(differing)}; give the same again.")
        for name in ("network", "average", "optimizer", "schedule", "scaler"):
            getattr(self, name).load_state_dict(state[name])
        self.epoch, self.best_score, self.best_epoch = state["progress"]


def running_average(old: torch.Tensor, new: torch.Tensor, count: torch.Tensor) -> torch.Tensor:
    """Mean of the first weights, then an exponential average, in which the first ones are soon forgotten."""
    return old + (new - old) * torch.clamp(10 / (count + 10), min=1 - AVERAGING)


def segmentation_loss(logits: torch.Tensor, labels: torch.Tensor, weights: torch.Tensor) -> torch.Tensor:
    """Weighted cross-entropy plus soft Dice (Milletari et al. 2016) over the classes in the batch.

    logits: (N, K, H, W); labels: (N, H, W) int64, IGNORED where nothing is known.
    """
    known = labels != IGNORED
    if not known.any():
        return logits.sum() * 0.0
    entropy = functional.cross_entropy(logits, labels, weights, ignore_index=IGNORED)
    shares = logits.softmax(1) * known[:, None]
    truth = functional.one_hot(labels.where(known, 0), logits.shape[1]).movedim(-1, 1) * known[:, None]
    both, either = (shares * truth).sum((0, 2, 3)), (shares + truth).sum((0, 2, 3))
    present = truth.sum((0, 2, 3)) > 0
    dice = 1 - ((2 * both + 1) / (either + 1))[present].mean()
    return entropy + 0.5 * dice
