"""Search parameters of images: method, prior and cameras, for all callers."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..geometry.camera import HEADING_SPREAD_DEG, Camera
from ..localization import Localization, Method, Prior
from ..sentences import Sentence
from .localizer import Localizer, default_scales


@dataclass(frozen=True)
class Search:
    """Search parameters that all images of a run share.

    Attributes:
        known: Prior of all images, in the database's CRS.
        scales: Smallest and largest ground that an image shows, in window sizes; None for the method's default.
    """

    method: Method
    known: Prior = Prior()
    scales: tuple[float, float] | None = None
    with_matches: bool = False

    def prior_of(self, localizer: Localizer, camera: Camera, shape_hw: tuple[int, int]) -> Prior:
        """Return the prior of an image: the user's values, completed by those of its camera.

        Args:
            camera: Of the image; its meters are map units.
            shape_hw: (height, width) of the image as taken.
        """
        sizes = localizer.pixel_sizes(shape_hw, self.scales) if self.scales else camera.pixel_sizes(shape_hw)
        if sizes is None and camera.leveling(shape_hw) is not None:
            # A leveled image has another shape; its pixel sizes are those of the image as taken, for all methods.
            sizes = localizer.pixel_sizes(shape_hw, default_scales(self.method))
        prior = replace(self.known, pixel_size_range=sizes)
        if prior.heading_deg is None and camera.heading_deg is not None:
            prior = replace(prior, heading_deg=camera.heading_deg, heading_range_deg=HEADING_SPREAD_DEG)
        return prior


@dataclass(frozen=True)
class ImagesJob:
    """Data that all images of a localization by workers share.

    Attributes:
        database: Path of the reference database.
        model: Path of a network; empty for label images.
        risk: Maximum error probability.
        sun_deg: Azimuth of the sun; None if unknown.
    """

    database: str
    has_overview: bool
    model: str
    risk: float
    sun_deg: float | None
    search: Search


@dataclass(frozen=True)
class AskedImage:
    """One image of the job.

    Attributes:
        pixel_size_m: Ground meters along a row and a column of a pixel of a photo; None if unknown.
    """

    path: str
    camera: Camera
    pixel_size_m: tuple[float, float] | None = None


@dataclass(frozen=True)
class FoundImage:
    """Result of one image.

    Attributes:
        result: Its localization; None if the image can't be used.
        fault: Why the image can't be used; None otherwise.
        shape_hw: (height, width) of the image.
    """

    result: Localization | None = None
    fault: Sentence | None = None
    shape_hw: tuple[int, int] = (0, 0)
