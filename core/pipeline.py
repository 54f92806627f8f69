"""One image in, one result out: labels, prior, leveling, localization. QGIS, workers and the aircraft use it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from .geometry.camera import Camera
from .geometry.leveling import Leveling
from .labels.class_shares import SeenLabels
from .localization import Localization, Method, Prior
from .localizer.leveled import as_taken, level_labels, of_leveled
from .localizer.localizer import Localizer
from .localizer.network_reason import name_network
from .localizer.search import Search


class LabelReader(Protocol):
    """Reads images as labels in the classes of a database: label images, or photos with a network."""

    def __call__(self, path: str, camera: Camera | None = None, with_pixels: bool = False) -> SeenLabels:
        """Read an image.

        Args:
            camera: Camera of the image; it gives the scale at which a network reads the photo.
            with_pixels: Whether the caller also needs the pixels of a photo.

        Raises:
            SemRefError: The image can't be read.
        """


@dataclass(frozen=True)
class ImageResult:
    """Result of one image.

    Attributes:
        labels_hw: (H, W) uint8 labels of the image as taken.
        seen: Labels and their properties after leveling.
        leveling: How the image was leveled; None for an image used as taken.
    """

    labels_hw: np.ndarray
    seen: SeenLabels
    leveling: Leveling | None
    prior: Prior
    level: Localization

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) of the image as taken."""
        return self.labels_hw.shape[0], self.labels_hw.shape[1]

    @property
    def localization(self) -> Localization:
        """Localization of the image as taken."""
        return self.as_taken(self.level)

    def as_taken(self, found: Localization) -> Localization:
        """Return a localization of the leveled image for the image as taken."""
        return found if self.leveling is None else as_taken(found, self.leveling)


@dataclass(frozen=True)
class Pipeline:
    """Localizes images one by one; a result does not depend on earlier images.

    Attributes:
        looks_again: Whether a photo without a position is labeled again, more thoroughly. Images of a flight need it
            less than they need the time.
    """

    localizer: Localizer
    search: Search
    read: LabelReader
    looks_again: bool = True

    def run(self, path: str, camera: Camera, with_pixels: bool = False) -> ImageResult:
        """Read an image and localize it.

        Args:
            with_pixels: As for ``LabelReader``.

        Raises:
            SemRefError: The image or the data of its camera can't be used.
        """
        if self.search.method is Method.TOPOLOGY_VECTOR:
            # The published method does not level images.
            camera = camera.without_leveling()
        seen = self.read(path, camera, with_pixels)
        seen = seen if self.looks_again else replace(seen, look_again=None)
        return localize_labels(self.localizer, self.search, seen, camera)


def localize_labels(localizer: Localizer, search: Search, seen: SeenLabels, camera: Camera) -> ImageResult:
    """Localize an image from its labels; level it first if the camera's attitude is known.

    Args:
        seen: Labels of the image as taken, with their class offsets.

    Raises:
        SemRefError: The labels or the data of the camera can't be used.
    """
    height, width = seen.labels_hw.shape
    prior, leveling = search.prior_of(localizer, camera, (height, width)), camera.leveling((height, width))
    return localize_with(localizer, search, seen, prior, leveling)


def localize_with(
    localizer: Localizer, search: Search, seen: SeenLabels, prior: Prior, leveling: Leveling | None
) -> ImageResult:
    """Localize an image with a given prior and leveling.

    A photo without a position is labeled again, more thoroughly, if that is possible. The second labels decide; the
    first ones can confirm them. The published method takes the first labels.

    Args:
        prior: Prior of the image's center; with a range of pixel sizes if the image is leveled.
        leveling: How to level the image; None to use it as taken. The method must find heading and pixel size.
    """
    known = prior if leveling is None else of_leveled(prior, leveling)

    def look(seen: SeenLabels, earlier: Localization | None = None) -> ImageResult:
        level = seen if leveling is None else level_labels(seen, leveling)
        found = _found(localizer, search, level, known, leveling, earlier)
        return ImageResult(seen.labels_hw, level, leveling, known, found)

    result = look(replace(seen, look_again=None))
    if seen.look_again is None or result.level.is_fix or search.method is Method.TOPOLOGY_VECTOR:
        return result
    return look(seen.look_again(), result.level)


def localize_again(localizer: Localizer, search: Search, result: ImageResult, prior: Prior) -> ImageResult:
    """Localize an image that was read and leveled before with another prior, of the leveled image."""
    return replace(result, prior=prior, level=_found(localizer, search, result.seen, prior, result.leveling))


def _found(  # noqa: PLR0913 - as ``localize_with``, and an earlier result for the same photo
    localizer: Localizer,
    search: Search,
    seen: SeenLabels,
    prior: Prior,
    leveling: Leveling | None,
    earlier: Localization | None = None,
) -> Localization:
    if leveling is not None:
        localizer = localizer.with_view(leveling.view)
    found = localizer.localize(
        seen.labels_hw, search.method, prior, search.with_matches, seen.shares, seen.biases, earlier
    )
    return name_network(found, seen.trained_on, localizer.landmark_classes)
