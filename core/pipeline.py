"""One image in, one result out: labels, prior, leveling, localization. QGIS, workers and the aircraft use it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from .geometry.camera import Camera
from .geometry.leveling import Leveling
from .labels.class_shares import SeenLabels
from .localization import Localization, Prior
from .localizer.leveled import as_taken, level_labels, of_leveled
from .localizer.localizer import Localizer
from .localizer.network_reason import name_network
from .localizer.search import Search


class LabelReader(Protocol):
    """Reads images as labels in the classes of a database: label images, or photos by a network."""

    def __call__(self, path: str, camera: Camera | None = None, with_pixels: bool = False) -> SeenLabels:
        """Read an image.

        Args:
            camera: That took it: a network knows by it how large to see a photo.
            with_pixels: Whether a photo's pixels are needed besides.

        Raises:
            SemRefError: It can't be read.
        """


@dataclass(frozen=True)
class ImageResult:
    """What came of one image.

    Attributes:
        labels_hw: (H, W) uint8 labels of the image as it was taken.
        seen: Labels, and what is known of them, as a level camera sees them.
        leveling: How the image was leveled; None for one that is taken as it is.
        prior: What was known of the level image, and searched.
        level: Where the level image was taken.
    """

    labels_hw: np.ndarray
    seen: SeenLabels
    leveling: Leveling | None
    prior: Prior
    level: Localization

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) of the image as it was taken."""
        return self.labels_hw.shape[0], self.labels_hw.shape[1]

    @property
    def localization(self) -> Localization:
        """Where the image was taken."""
        return self.as_taken(self.level)

    def as_taken(self, found: Localization) -> Localization:
        """Return a result of the level image for the image as it was taken.

        Args:
            found: Of the level image.
        """
        return found if self.leveling is None else as_taken(found, self.leveling)


@dataclass(frozen=True)
class Pipeline:
    """Localizes images one by one; an answer depends on nothing that came before.

    Attributes:
        search: Method, and what is known of all images.
    """

    localizer: Localizer
    search: Search
    read: LabelReader

    def run(self, path: str, camera: Camera, with_pixels: bool = False) -> ImageResult:
        """Read an image and localize it.

        Args:
            camera: How it was held, and what else is known of it.
            with_pixels: As of ``LabelReader``.

        Raises:
            SemRefError: The image, or what the camera states, can't be used.
        """
        return localize_labels(self.localizer, self.search, self.read(path, camera, with_pixels), camera)


def localize_labels(localizer: Localizer, search: Search, seen: SeenLabels, camera: Camera) -> ImageResult:
    """Localize an image whose labels are known, leveled first where its camera states how it was held.

    Args:
        search: Method, and what is known of all images.
        seen: Labels of the image as it was taken, with their biases.

    Raises:
        SemRefError: The labels, or what the camera states, can't be used.
    """
    height, width = seen.labels_hw.shape
    prior = search.prior_of(localizer, camera, (height, width))
    return localize_with(localizer, search, seen, prior, camera.leveling((height, width)))


def localize_with(
    localizer: Localizer, search: Search, seen: SeenLabels, prior: Prior, leveling: Leveling | None
) -> ImageResult:
    """Localize an image of which is known what to search and how to level it.

    Args:
        search: Method, and whether matches are wanted.
        seen: Labels of the image as it was taken, with their biases.
        prior: About the image's center; for one that is leveled with a range of pixel sizes.
        leveling: How to level the image; None to take it as it is. The method must state heading and pixel size.
    """
    labels_hw = seen.labels_hw
    if leveling is not None:
        seen, prior = level_labels(seen, leveling), of_leveled(prior, leveling)
    found = localizer.localize(seen.labels_hw, search.method, prior, search.with_matches, seen.shares, seen.biases)
    named = name_network(found, seen.trained_on, localizer.landmark_classes)
    return ImageResult(labels_hw, seen, leveling, prior, named)
