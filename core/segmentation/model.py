"""ONNX segmentation networks: scores of classes from images, also averaged over turned and mirrored copies."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from concurrent.futures import CancelledError
from threading import Event

import numpy as np

from ..errors import ModelError
from ..labels.class_table import ClassTable
from ..sentences import Sentence
from .certainty import softmax
from .class_bias import read_class_bias
from .devices import AUTO
from .metadata import named_channels, read_classes
from .model_card import card_of_texts
from .network import OnnxNetwork
from .onnx_file import header_of


class SegmentationModel(OnnxNetwork):
    """A network with named classes from an ONNX file: images → scores of its classes.

    Attributes:
        class_bias: Its class offsets, by lower-case name, if stated.
        trained_on: Names of places, if stated.
        tiles_seen: Number of images processed so far.
    """

    def __init__(self, path: str, threads: int, class_table: ClassTable | None = None, device: str = AUTO) -> None:
        """Open the network.

        Args:
            class_table: The user's, see ``read_classes``.
            device: One of ``devices.KEYS``.

        Raises:
            ModelError: onnxruntime is missing, or the file or its metadata can't be used.
        """
        super().__init__(path, threads, device)
        self.tiles_seen, self._counting = 0, threading.Lock()
        header = header_of(path)
        if header is not None and header.aligns_corners:
            self.notes.append(
                Sentence(
                    "The network enlarges with aligned corners: away from the middle of a tile it shows things up to "
                    "some pixels too far out, and photos seem up to 1 % larger than they are."
                )
            )
        names = named_channels(self.texts, path)
        self._gives_numbers = self.is_single and (self.gives_integers or (names is not None and len(names) > 2))
        self._gives_probability = self.is_single and not self._gives_numbers
        self._gives_probabilities = self._gives_numbers or not self.is_single and self.sums_to_one
        channels = 2 if self.is_single else self.channels
        if self._gives_numbers:
            channels = len(names or class_table or ())
        self.classes = read_classes(self.texts, channels, path, class_table)
        self.class_bias = read_class_bias(self.texts, self.classes.names, path)
        self.trained_on = tuple(ground.place for ground in card_of_texts(self.texts, path).trained_on)

    @property
    def temperature(self) -> float | None:
        """Divisor of scores in ``probabilities``, from the metadata; None without such scores."""
        return None if self._gives_probabilities or self._gives_probability else self.settings.temperature

    @property
    def has_scores(self) -> bool:
        """Whether it outputs scores or probabilities, not only class numbers."""
        return not self._gives_numbers

    def scores(self, images: Sequence[np.ndarray]) -> np.ndarray:
        """Return (N, C, H, W) float32 scores of each class; the highest one decides a pixel's class.

        ``images``: N of (H, W, 3) uint8, red first, H × W = ``tile_hw``.
        Raises ModelError if the network fails or returns values that are not numbers.
        """
        outputs = self.run(images)
        with self._counting:
            self.tiles_seen += len(images)
        if self._gives_numbers:
            return self._votes(outputs)
        found = outputs.astype(np.float32, copy=False)
        # The sum contains every NaN and infinity.
        if not np.isfinite(found.sum()):
            raise ModelError(
                "{path} outputs values that are not numbers (NaN or infinite). It is damaged, or its "
                "standardization_mean and standardization_std differ from those of its training.",
                path=self.path,
            )
        if self._gives_probability:
            found = found.reshape(len(images), 1, *self.tile_hw)
            return np.concatenate([np.full_like(found, self.settings.threshold), found], axis=1)
        return found

    def probabilities(self, scores: np.ndarray) -> np.ndarray:
        """Return (C, …) float32 probability of each class, from (C, …) scores or their weighted means."""
        if self._gives_probability:
            return np.stack([1 - scores[1], scores[1]])
        if self._gives_probabilities:
            return scores
        temperature = self.settings.temperature
        return softmax(scores if temperature is None else scores / np.float32(temperature))

    def _votes(self, outputs: np.ndarray) -> np.ndarray:
        """Return one for the class that the network outputs, zero for the others."""
        numbers = outputs.reshape(len(outputs), 1, *self.tile_hw)
        count = len(self.classes.names)
        if not ((numbers >= 0) & (numbers < count)).all():
            raise ModelError(
                "{path} outputs the class number {number:g}, but names only {count} classes. Use the names from its "
                "training.",
                path=self.path,
                number=numbers.max(),
                count=count,
            )
        return (numbers == np.arange(count).reshape(1, count, 1, 1)).astype(np.float32)


def averaged_scores(model: SegmentationModel, images: Sequence[np.ndarray], stop: Event) -> np.ndarray:
    """Return (N, C, H, W) float32 mean scores over all orientations that fit the network's tiles, 8 or 4.

    Each orientation has other errors. On photos of places that networks had not seen, the average gives 86 instead of
    71 positions of 280 (docs/decisions/photo-evidence.md).

    Args:
        images: N of (H, W, 3) uint8, red first, of the network's size.
        stop: Set by another thread to end between two orientations.

    Raises:
        CancelledError: ``stop`` was set.
        ModelError: As ``SegmentationModel.scores``.
    """
    height, width = model.tile_hw
    quarters = range(4) if height == width else (0, 2)
    total = np.zeros((), np.float32)
    for turns in quarters:
        for step in (1, -1):
            if stop.is_set():
                raise CancelledError
            seen = [np.ascontiguousarray(np.rot90(image[:, ::step], turns)) for image in images]
            total = total + np.rot90(model.scores(seen), -turns, axes=(2, 3))[..., ::step]
    return np.ascontiguousarray(total / np.float32(2 * len(quarters)))
