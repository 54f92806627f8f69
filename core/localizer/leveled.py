"""Images of cameras that were not level: leveled, localized, and told for the image itself."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Optional, Tuple

import numpy as np

from ..constellation.hypotheses import Prior
from ..geometry.leveling import Leveling
from ..geometry.pose import turn_of
from .localizer import Localization, Localizer


@dataclass(frozen=True)
class LeveledLocalization:
    """What a localizer found for a leveled image, told for the image itself.

    result: position is that of the image's center, heading and pixel size are those there, the heading that of its top
    as a level camera would have it; footprint: (4, 2) map coordinates of the ground at its corners, upper left first,
    clockwise; nadir: map coordinates straight below the camera. Both None without a position.
    """

    result: Localization
    footprint: Optional[np.ndarray] = None
    nadir: Optional[Tuple[float, float]] = None


def localize_leveled(
    localizer: Localizer, labels_hw: np.ndarray, method: str, prior: Prior, way: Leveling
) -> LeveledLocalization:
    """Levels an image, localizes it and takes the result back; ``prior`` is about the image's center, with a pixel
    size range. ``method`` is one that tells heading and pixel size."""
    if prior.position is not None and prior.radius is not None:
        # What is searched for is the middle of the level image.
        prior = replace(prior, radius=prior.radius + abs(way.middle) * prior.pixel_size_range[1])
    found = localizer.localize(way.level(labels_hw), method, prior)
    if found.position is None:
        return LeveledLocalization(found)
    turn = turn_of(found.heading_deg, found.pixel_size_m)
    center = complex(*found.position) - turn * way.middle
    corners, nadir = center + turn * way.corners, center + turn * way.nadir
    return LeveledLocalization(
        replace(found, position=(center.real, center.imag)),
        np.column_stack([corners.real, corners.imag]),
        (nadir.real, nadir.imag),
    )
