"""Folders of tiles as semref:exporttrainingtiles writes them."""

from __future__ import annotations

import copy
import csv
import json
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from ..core.errors import TrainingError

IGNORED = 255  # label of pixels that don't count
CACHE_BYTES = 2_000_000_000


@dataclass(frozen=True)
class TileClass:
    value: int
    name: str
    color: str
    role: str


@dataclass(frozen=True)
class TilePair:
    """A tile.

    Attributes:
        image: Its file.
        labels: The file of its labels.
        bands: Numbers, from 1, of red, green and blue.
        stretch: Which values become 0 and 1, or None.
        unlabeled: What value 0 stands for: a channel, a set of them (partial.py) or IGNORED; None for what the reader
            is told.
    """

    image: Path
    labels: Path
    bands: tuple[int, int, int]
    stretch: tuple | None
    unlabeled: int | None = None


@dataclass(frozen=True)
class TileFolder:
    """One exported folder: its manifest, its classes, and its tiles by subset."""

    path: Path
    manifest: dict
    classes: tuple[TileClass, ...]

    def tiles(self, subset: str) -> list[TilePair]:
        bands, stretch = self.manifest["network_bands"], self.manifest["stretch"]
        images = sorted((self.path / subset / "images").glob("*"))
        labels = self.path / subset / "labels"
        pairs = [TilePair(image, labels / f"{image.stem}.png", bands, stretch) for image in images]
        return pairs if subset == "train" else apart(pairs, self.manifest.get("tile_size", 0))

    def class_pixels(self, subset: str) -> dict[str, int]:
        """Pixels of each class value on the tiles of a subset."""
        return self.manifest["statistics"]["class_pixels"][subset]


def apart(pairs: list[TilePair], size: int) -> list[TilePair]:
    """Tiles of which none overlaps another, so that no pixel of the validation counts twice."""
    kept: dict[tuple[int, int], TilePair] = {}
    for pair in pairs:
        column, row = (int(part) for part in pair.image.stem.split("_"))
        if not any(abs(column - c) < size and abs(row - r) < size for c, r in kept):
            kept[column, row] = pair
    return list(kept.values())


def open_folder(path: Path) -> TileFolder:
    """Raises TrainingError when it is not a folder of exported tiles."""
    try:
        manifest = json.loads((path / "manifest.json").read_text(encoding="utf-8"))
        with (path / "classes.csv").open(encoding="utf-8", newline="") as file:
            rows = [TileClass(int(r["value"]), r["name"], r["color"], r["role"]) for r in csv.DictReader(file)]
    except (OSError, ValueError, KeyError) as error:
        raise TrainingError("{path} holds no exported training tiles: {reason}.", path=path, reason=error) from None
    folder = TileFolder(path, manifest, tuple(sorted((row for row in rows if row.value), key=lambda row: row.value)))
    if not folder.tiles("train"):
        raise TrainingError("{path} holds no tiles to train on.", path=path)
    return folder


def open_folders(paths: list[Path]) -> list[TileFolder]:
    """Folders that can be trained on together. Raises TrainingError when their classes differ."""
    folders = [open_folder(path) for path in paths]
    for folder in folders[1:]:
        if [(c.value, c.name) for c in folder.classes] != [(c.value, c.name) for c in folders[0].classes]:
            raise TrainingError(
                "{path} has other classes than {first}; export both with one class table.",
                path=folder.path,
                first=folders[0].path,
            )
    return folders


def band_statistics(folders: list[TileFolder]) -> tuple[np.ndarray, np.ndarray]:
    """Mean and deviation (3,) of red, green and blue in 0…1, over all folders' training tiles."""
    counts = np.array([len(folder.tiles("train")) for folder in folders], float)[:, None]
    means, deviations = (
        np.array([folder.manifest["statistics"][key] for folder in folders]) for key in ("band_mean", "band_std")
    )
    mean = (counts * means).sum(axis=0) / counts.sum()
    return mean, np.sqrt((counts * (deviations**2 + means**2)).sum(axis=0) / counts.sum() - mean**2)


class TileReader:
    """Reads tiles as (H, W, 3) float32 in 0…1 and (H, W) uint8 channel indices, keeping what fits in memory.

    ``values``: class value of each output channel. Pixels of other values are IGNORED, and those of value 0 too
    unless ``learn_unlabeled``.
    """

    def __init__(self, pairs: list[TilePair], values: list[int], learn_unlabeled: bool) -> None:
        self.pairs = pairs
        self._channel = np.full(256, IGNORED, np.uint8)
        self._channel[values] = np.arange(len(values))
        if not learn_unlabeled:
            self._channel[0] = IGNORED
        self._kept: dict[int, tuple[np.ndarray, np.ndarray]] = {}
        self._free = CACHE_BYTES

    def __len__(self) -> int:
        return len(self.pairs)

    def spread(self, most: int) -> TileReader:
        """At most so many of the tiles, evenly apart."""
        chosen = copy.copy(self)
        chosen.pairs = [self.pairs[n] for n in spread(len(self.pairs), most)]
        chosen._kept = {}
        return chosen

    def __call__(self, index: int) -> tuple[np.ndarray, np.ndarray]:
        if index not in self._kept:
            pair = self.pairs[index]
            image, labels = read_image(pair), cv2.imread(str(pair.labels), cv2.IMREAD_UNCHANGED)
            if labels is None or labels.shape != image.shape[:2]:
                raise TrainingError("The labels {path} are missing or don't fit their image.", path=pair.labels)
            channels = self._channels(pair, labels)
            if image.nbytes + labels.nbytes > self._free:
                return image / np.float32(255), channels
            self._free -= image.nbytes + labels.nbytes
            self._kept[index] = image, channels
        image, labels = self._kept[index]
        return image / np.float32(255), labels

    def _channels(self, pair: TilePair, labels: np.ndarray) -> np.ndarray:
        channels = self._channel[labels]
        if pair.unlabeled is not None:
            channels[labels == 0] = pair.unlabeled
        return channels


def spread(count: int, most: int) -> list[int]:
    """At most so many numbers below ``count``, evenly apart."""
    return sorted({int(n) for n in np.linspace(0, count - 1, min(count, most))}) if count else []


def read_image(pair: TilePair) -> np.ndarray:
    """(H, W, 3) uint8: red, green, blue as semref:segmentimage will show them to the network."""
    if pair.image.suffix == ".png":
        picture = cv2.imread(str(pair.image), cv2.IMREAD_UNCHANGED)
        if picture is None:
            raise TrainingError("The tile {path} can't be read.", path=pair.image)
        picture = picture[:, :, ::-1] if picture.ndim == 3 else picture[:, :, None]
    else:
        import tifffile  # GeoTIFF tiles are the exception

        picture = tifffile.imread(pair.image)
        picture = picture if picture.ndim == 3 else picture[:, :, None]
    picture = picture[:, :, [band - 1 for band in pair.bands]]
    if pair.stretch is None:
        return picture
    least, most = np.array(pair.stretch, np.float32).T
    stretched = (picture - least) * (255 / np.maximum(most - least, 1e-9))
    return np.clip(stretched + 0.5, 0, 255).astype(np.uint8)
