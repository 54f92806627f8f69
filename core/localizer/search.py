"""How images are looked for, whoever does it: by which method, with what is known beforehand and of their cameras."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..geometry.camera import HEADING_SPREAD_DEG, Camera
from ..localization import Localization, Method, Prior
from ..sentences import Sentence
from .localizer import Localizer, default_scales


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
        """Return what is known of an image beforehand: what the user said, else what its camera states.

        Args:
            camera: Of the image; its meters are map units.
            shape_hw: (height, width) of the image as it is.
        """
        sizes = localizer.pixel_sizes(shape_hw, self.scales) if self.scales else camera.pixel_sizes(shape_hw)
        if sizes is None and camera.leveling(shape_hw) is not None:
            # A leveled image has another shape: its pixel sizes are those of the image as it is, for all methods.
            sizes = localizer.pixel_sizes(shape_hw, default_scales(self.method))
        prior = replace(self.known, pixel_size_range=sizes)
        if prior.heading_deg is None and camera.heading_deg is not None:
            prior = replace(prior, heading_deg=camera.heading_deg, heading_range_deg=HEADING_SPREAD_DEG)
        return prior


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
