"""Whether a place holds for all of an image: the parts along its edges, each compared with the map by itself.

An image that shows two places side by side, or ground that changed on one side, agrees with the map in the rest so well
that the place is sure; what it does not hold for is told.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..localization import IMAGE_PARTS
from ..sentences import Sentence
from .class_pyramid import EvidenceLevel, MapPyramid
from .refine import ScoredPose, map_under

PART_SHARE = 0.3
"""Share of an image's edge that a part of it reaches in from that edge."""

PART_KNOWN = 0.3
"""Least share of a part that image and map both have labels of."""


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
    """What a place that agrees as a whole does not hold for.

    Args:
        image: Its evidence, at the pixels of the decision.

    Returns:
        The part that agrees least, if it agrees far less than the whole image; None if none does.
    """
    settings = pyramid.settings
    whole, parts = agreeing_parts(image, pyramid, pose)
    telling = [part for part in parts if min(part.energies) >= settings.part_energy]
    if whole <= 0 or not telling:
        return None
    least = min(telling, key=lambda part: part.agreement)
    if least.agreement >= settings.part_agreement * whole:
        return None
    part = IMAGE_PARTS[least.name]
    return Sentence(
        "In the {part} of the image the classes hardly agree with the map ({agreement:.2f}, {whole:.2f} in all of "
        "it): changed, mistaken, or another place. The fix holds for the rest.",
        part=part,
        agreement=least.agreement,
        whole=whole,
    )


def agreeing_parts(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose) -> tuple[float, list[Part]]:
    """How well an image and the parts along its edges agree with the map at a place.

    Args:
        image: Its evidence, at the pixels of the decision.

    Returns:
        Correlation −1…1 of all of it, and the parts of which enough has labels in image and map.
    """
    there, on_map = map_under(image, pyramid, pose)
    known = (image.known > 0.5) & (on_map > 0.5)
    if not known.any():
        return 0.0, []
    # Against the mean of all that is known: a part is a piece of the same comparison.
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
    """Correlation −1…1 of (n, C) evidence whose mean is off already; ``quiet`` is added to the energy of a pixel."""
    energies = [float((one**2).sum()) + quiet * len(one) for one in (seen, there)]
    return float((seen * there).sum() / np.sqrt(energies[0] * energies[1]))
