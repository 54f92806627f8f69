"""How images are looked for, whoever does it: by which method, with what is known beforehand and of their cameras."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..geometry.camera import Camera
from ..labels.class_shares import SeenLabels
from ..localization import Localization, Method, Prior
from ..sentences import Sentence
from .leveled import localize_leveled, prior_of
from .localizer import Localizer
from .network_reason import name_network


@dataclass(frozen=True)
class Search:
    """What is the same for all images of a run.

    Attributes:
        method: By which they are looked for.
        known: Of all of them, in the database's CRS.
        scales: Smallest and largest ground that an image shows, in window sizes; None for the method's own.
        with_matches: Whether landmarks that agree are told.
    """

    method: Method
    known: Prior = Prior()
    scales: tuple[float, float] | None = None
    with_matches: bool = False

    def prior_of(self, localizer: Localizer, camera: Camera, shape_hw: tuple[int, int]) -> Prior:
        """What is known of an image beforehand.

        Args:
            localizer: Of the database.
            camera: Of the image.
            shape_hw: (height, width) of the image.
        """
        sizes = self.scales and localizer.pixel_sizes(shape_hw, self.scales)
        return prior_of(localizer, self.method, replace(self.known, pixel_size_range=sizes), camera, shape_hw)

    def localized(self, localizer: Localizer, seen: SeenLabels, camera: Camera) -> Localization:
        """Where an image was taken, leveled first where its camera tells how it was held.

        Args:
            localizer: Of the database.
            seen: In the image.
            camera: Of the image.

        Raises:
            SemRefError: What the camera tells, or the image, can't be used.
        """
        labels_hw, shares, method = seen.labels_hw, seen.shares, self.method
        height, width = labels_hw.shape
        prior, way = self.prior_of(localizer, camera, (height, width)), camera.leveling((height, width))
        if way is None:
            found = localizer.localize(labels_hw, method, prior, self.with_matches, shares)
        else:
            found = localize_leveled(localizer, labels_hw, method, prior, way, self.with_matches, shares)
        return name_network(found, seen.trained_on, localizer.landmark_classes)


@dataclass(frozen=True)
class ImagesJob:
    """Images that are localized elsewhere: what is the same for all.

    Attributes:
        database: Path of the reference database.
        has_overview: Whether its overview is read.
        model: Path of a network; empty for label images.
        risk: Of a wrong fix that is allowed.
        sun_deg: Direction of the sun; None where nobody tells.
        search: How images are looked for.
    """

    database: str
    has_overview: bool
    model: str
    risk: float
    sun_deg: float | None
    search: Search


@dataclass(frozen=True)
class AskedImage:
    """One of them.

    Attributes:
        path: Of the image.
        camera: How it was held.
        pixel_size_m: Ground meters along a row and a column of a pixel of a photo; None where it doesn't say.
    """

    path: str
    camera: Camera
    pixel_size_m: tuple[float, float] | None = None


@dataclass(frozen=True)
class FoundImage:
    """What came of it.

    Attributes:
        result: Where it was taken; None where it can't be used.
        fault: Why it can't; None where it can.
        shape_hw: (height, width) of the image.
    """

    result: Localization | None = None
    fault: Sentence | None = None
    shape_hw: tuple[int, int] = (0, 0)
