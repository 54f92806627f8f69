"""Read the folders of training tiles that semref:exporttrainingtiles writes."""

from __future__ import annotations

import copy
import json
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from ..core.errors import ClassTableError, TrainingError
from ..core.labels.class_table import LandCoverClass, class_table_from_csv

IGNORED = 255  # label of pixels without influence on the training
CACHE_BYTES = 2_000_000_000


@dataclass(frozen=True)
class TilePair:
    """A tile with its labels.

    Attributes:
        bands: Numbers, from 1, of red, green and blue.
        stretch: (3, 2) values that become 0 and 1, or None.
        unlabeled: Meaning of value 0: a channel, a set of channels (metrics.py) or IGNORED; None for the default of the
            reader.
    """

    image: Path
    labels: Path
    bands: tuple[int, int, int]
    stretch: tuple | None
    unlabeled: int | None = None


@dataclass(frozen=True)
class TileFolder:
    """An exported folder: its manifest, classes and tiles."""

    path: Path
    manifest: dict
    classes: tuple[LandCoverClass, ...]

    def tiles(self, subset: str) -> list[TilePair]:
        bands, stretch = self.manifest["network_bands"], self.manifest["stretch"]
        images = sorted((self.path / subset / "images").glob("*"))
        labels = self.path / subset / "labels"
        pairs = [TilePair(image, labels / f"{image.stem}.png", bands, stretch) for image in images]
        return pairs if subset == "train" else without_overlap(pairs, self.manifest.get("tile_size", 0))


def without_overlap(pairs: list[TilePair], size: int) -> list[TilePair]:
    """Return tiles that don't overlap, so that no pixel counts twice in the validation."""
    kept: dict[tuple[int, int], TilePair] = {}
    for pair in pairs:
        column, row = (int(part) for part in pair.image.stem.split("_"))
        if not any(abs(column - c) < size and abs(row - r) < size for c, r in kept):
            kept[column, row] = pair
    return list(kept.values())


def open_folder(path: Path) -> TileFolder:
    """Open a folder of exported tiles. Raises TrainingError for another folder."""
    try:
        manifest = json.loads((path / "manifest.json").read_text(encoding="utf-8"))
        table = class_table_from_csv((path / "classes.csv").read_text(encoding="utf-8"))
    except (OSError, ValueError, ClassTableError) as error:
        raise TrainingError("{path} has no exported training tiles: {reason}.", path=path, reason=error) from None
    folder = TileFolder(path, manifest, tuple(one for one in table if one.value))
    if not folder.tiles("train"):
        raise TrainingError("{path} has no tiles for training.", path=path)
    return folder


def open_folders(paths: list[Path]) -> list[TileFolder]:
    """Open folders for one training. Raises TrainingError if their classes differ."""
    folders = [open_folder(path) for path in paths]
    for folder in folders[1:]:
        if [(c.value, c.name) for c in folder.classes] != [(c.value, c.name) for c in folders[0].classes]:
            raise TrainingError(
                "{path} and {first} have different classes. Export both with the same class table.",
                path=folder.path,
                first=folders[0].path,
            )
    return folders


def band_statistics(folders: list[TileFolder]) -> tuple[np.ndarray, np.ndarray]:
    """Return mean and deviation (3,) of red, green and blue in 0…1 over the training tiles of all folders.

    The deviation is at least one gray level: a network divides by it, also for a band with a single value.
    """
    counts = np.array([len(folder.tiles("train")) for folder in folders], float)[:, None]
    means, deviations = (
        np.array([folder.manifest["statistics"][key] for folder in folders]) for key in ("band_mean", "band_std")
    )
    mean = (counts * means).sum(axis=0) / counts.sum()
    variance = (counts * (deviations**2 + means**2)).sum(axis=0) / counts.sum() - mean**2
    return mean, np.sqrt(np.maximum(variance, 255**-2))


class TileReader:
    """Reads tiles as (H, W, 3) float32 in 0…1 and (H, W) uint8 channel indices, and caches them in memory.

    ``values``: class value of each output channel. Pixels of other values are IGNORED, and those of value 0 as well
    unless ``learn_unlabeled`` is true.
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
        """Return a reader of at most ``most`` evenly spaced tiles."""
        chosen = copy.copy(self)
        chosen.pairs = [self.pairs[n] for n in spread(len(self.pairs), most)]
        chosen._kept = {}
        return chosen

    def __call__(self, index: int) -> tuple[np.ndarray, np.ndarray]:
        if index not in self._kept:
            pair = self.pairs[index]
            image, labels = read_image(pair), cv2.imread(str(pair.labels), cv2.IMREAD_UNCHANGED)
            if labels is None or labels.shape != image.shape[:2]:
                raise TrainingError(
                    "The label tile {path} is missing or has another size than its image. Export the training tiles "
                    "again.",
                    path=pair.labels,
                )
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
    """Return at most ``most`` evenly spaced numbers below ``count``."""
    return sorted({int(n) for n in np.linspace(0, count - 1, min(count, most))}) if count else []


def standardized(image: np.ndarray, mean, deviation) -> np.ndarray:
    """Return the network's input, (1, 3, H, W) float32, for an image (H, W, 3) in 0…1."""
    return ((image - mean) / deviation).astype(np.float32).transpose(2, 0, 1)[None].copy()


def read_image(pair: TilePair) -> np.ndarray:
    """Return (H, W, 3) uint8: red, green and blue as semref:segmentimage passes them to the network."""
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
