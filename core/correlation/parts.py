"""Check whether a place is right for the whole image: the parts along its edges, each compared with the map.

If an image shows two places side by side, or ground that changed on one side, the rest can agree so well that the place
is certain. The fix then names the part that does not agree.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..localization import IMAGE_PARTS
from ..sentences import Sentence
from .class_pyramid import EvidenceLevel, MapPyramid
from .refine import ScoredPose, map_under

PART_SHARE = 0.3
"""Width of a part as a share of the image's edge."""

PART_KNOWN = 0.3
"""Least share of a part with labels in image and map."""


@dataclass(frozen=True)
class Part:
    """A part of an image at a place.

    Attributes:
        name: Of ``IMAGE_PARTS``.
        agreement: Correlation −1…1 with the map.
        energies: Of image and map, in units of the map's mean one.
    """

    name: str
    agreement: float
    energies: tuple[float, float]


def disagreeing_part(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose) -> Sentence | None:
    """Return the part that agrees least, if it agrees far less than the whole image; otherwise None.

    Args:
        image: Its evidence, at the pixels of the decision.
    """
    settings = pyramid.settings
    whole, parts = agreeing_parts(image, pyramid, pose)
    informative = [part for part in parts if min(part.energies) >= settings.part_energy]
    if whole <= 0 or not informative:
        return None
    least = min(informative, key=lambda part: part.agreement)
    if least.agreement >= settings.part_agreement * whole:
        return None
    part = IMAGE_PARTS[least.name]
    return Sentence(
        "In the {part} of the image, classes hardly match the map ({agreement:.2f}; whole image {whole:.2f}): changed "
        "ground, wrong labels, or another place. The fix is valid for the rest.",
        part=part,
        agreement=least.agreement,
        whole=whole,
    )


def agreeing_parts(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose) -> tuple[float, list[Part]]:
    """Return how well an image and the parts along its edges agree with the map at a place.

    Args:
        image: Its evidence, at the pixels of the decision.

    Returns:
        Correlation −1…1 of the whole image, and the parts with enough labels in image and map.
    """
    there, on_map = map_under(image, pyramid, pose)
    known = (image.known > 0.5) & (on_map > 0.5)
    if not known.any():
        return 0.0, []
    # Minus the mean of the whole image: a part belongs to the same comparison.
    seen, there = (evidence - evidence[known].mean(axis=0) for evidence in (image.evidence, there))
    height, width = known.shape
    reach_x, reach_y = (max(1, round(PART_SHARE * edge)) for edge in (width, height))
    every = slice(None)
    cuts = {
        "left": (every, slice(reach_x)),
        "right": (every, slice(width - reach_x, None)),
        "upper": (slice(reach_y), every),
        "lower": (slice(height - reach_y, None), every),
    }
    parts = []
    for name, cut in cuts.items():
        held = known[cut]
        if held.mean() >= PART_KNOWN:
            both = seen[cut][held], there[cut][held]
            seen_energy, there_energy = (float((one**2).sum(axis=1).mean()) / pyramid.energy for one in both)
            parts.append(Part(name, _agreement(*both, pyramid.quiet), (seen_energy, there_energy)))
    return _agreement(seen[known], there[known], pyramid.quiet), parts


def _agreement(seen: np.ndarray, there: np.ndarray, quiet: float) -> float:
    """Return the correlation −1…1 of (n, C) evidence without means; ``quiet`` is added to the energy of a pixel."""
    energies = [float((one**2).sum()) + quiet * len(one) for one in (seen, there)]
    return float((seen * there).sum() / np.sqrt(energies[0] * energies[1]))
