"""The last images that a tracker keeps, and their storage as arrays of numbers (no pickles)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from .. import limits
from ..correlation.class_pyramid import EvidenceLevel, mirror_level
from ..localization import Prior
from .evidence import SeenImage
from .motion import Link, LinkSource, as_rows


@dataclass(frozen=True)
class Past:
    """An earlier image of the window.

    Attributes:
        link: To the next image.
        weight: Of its evidence.
    """

    seen: SeenImage
    link: Link
    weight: float

    def mirrored(self) -> Past:
        """Return the image with left and right exchanged, without the prior position, which can't be right then.

        The heading is mirrored like the turns of the links, so that the opponent has as many headings as the flight.
        """
        evidence = None if self.seen.evidence is None else mirror_level(self.seen.evidence)
        known = self.seen.prior
        heading = None if known.heading_deg is None else -known.heading_deg % 360
        prior = replace(known, position=None, radius=None, heading_deg=heading)
        seen = SeenImage(evidence, self.seen.edge_px, self.seen.chance, prior)
        return Past(seen, self.link.mirrored(), self.weight)


NOWHERE = Link(0, 1, (0.0, 0.0), 0.0, 0.0, as_rows(np.eye(4)))
"""Placeholder for the link of the latest image."""


def pack(past: Past) -> dict[str, np.ndarray]:
    """Return an image of the window as arrays by name."""
    seen, link = past.seen, past.link
    arrays = {
        "numbers": np.array([seen.edge_px, *seen.chance, seen.own_odds, past.weight]),
        "sizes": np.array(seen.prior.pixel_size_range or ()),
        "heading": np.array([] if seen.prior.heading_deg is None else [seen.prior.heading_deg]),
        "heading_range": np.array([seen.prior.heading_range_deg]),
        "link": np.array(
            [link.first, link.second, *link.translation, link.turn, link.log_scale, link.in_meters], np.float64
        ),
        "link_covariance": np.array(link.covariance),
        "link_source": np.array(list(LinkSource).index(link.source)),
        "own": np.array([]) if seen.own_state is None else seen.own_state,
    }
    if seen.prior.position is not None and seen.prior.radius is not None:
        arrays["position"] = np.array([*seen.prior.position, seen.prior.radius])
    if seen.evidence is not None:
        arrays.update(evidence=seen.evidence.evidence, known=seen.evidence.known, pixel=np.array(seen.evidence.pixel))
    return arrays


def checked_array(
    arrays: Mapping[str, np.ndarray], name: str, *shape: int | None, above: float = -limits.STATE_NUMBER
) -> np.ndarray:
    """Return one of several arrays as float64, whatever its type of number.

    Args:
        arrays: By name.
        *shape: Expected shape; None for an axis of any length.
        above: Lower limit of the numbers, excluded.

    Raises:
        KeyError: The array is missing.
        ValueError: It has another shape, or a number is not finite, too large or too small.
    """
    found = np.array(arrays[name])
    fits = found.ndim == len(shape) and all(wanted in (None, n) for wanted, n in zip(shape, found.shape))
    if not fits or found.dtype.kind not in "biuf" or not ((found > above) & (found <= limits.STATE_NUMBER)).all():
        raise ValueError(f"{name} is invalid")
    return found.astype(np.float64)


def unpack(arrays: Mapping[str, np.ndarray], channels: int) -> Past:
    """Return an image of the window from its arrays.

    Args:
        arrays: As of ``pack``.
        channels: Channels of evidence.

    Raises:
        KeyError: An array is missing.
        ParameterError: The link is invalid.
        ValueError: An array is invalid.
    """
    edge_px, mean, spread, own_odds, weight = checked_array(arrays, "numbers", 5).tolist()
    first, second, right, down, turn, log_scale, in_meters = checked_array(arrays, "link", 7).tolist()
    source = list(LinkSource)[int(checked_array(arrays, "link_source", above=-1))]
    known = as_rows(checked_array(arrays, "link_covariance", 4, 4))
    link = Link(int(first), int(second), (right, down), turn, log_scale, known, source, bool(in_meters))
    evidence = None
    if "evidence" in arrays:
        levels = checked_array(arrays, "evidence", None, None, channels).astype(np.float32)
        labeled = checked_array(arrays, "known", *levels.shape[:2]).astype(np.float32)
        pixel = checked_array(arrays, "pixel", 2, above=0).tolist()
        evidence = EvidenceLevel(levels, labeled, (pixel[0], pixel[1]))
    sizes = checked_array(arrays, "sizes", None, above=0).tolist()
    heading = checked_array(arrays, "heading", None).tolist()
    own = checked_array(arrays, "own", None)
    place = checked_array(arrays, "position", 3).tolist() if "position" in arrays else None
    if len(sizes) not in (0, 2) or len(own) not in (0, 4) or not (edge_px > 0 and spread > 0):
        raise ValueError("an image is invalid")
    prior = Prior(
        None if place is None else (place[0], place[1]),
        None if place is None else place[2],
        heading[0] if heading else None,
        float(checked_array(arrays, "heading_range", 1)[0]),
        (sizes[0], sizes[1]) if sizes else None,
    )
    return Past(SeenImage(evidence, edge_px, (mean, spread), prior, own if len(own) else None, own_odds), link, weight)
