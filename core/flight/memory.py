"""The last images that a tracker keeps, and their storage as arrays of numbers (no pickles)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

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


def unpack(arrays: Mapping[str, np.ndarray]) -> Past:
    """Return an image of the window from its arrays, as of ``pack``."""
    edge_px, mean, spread, own_odds, weight = arrays["numbers"].tolist()
    first, second, right, down, turn, log_scale, in_meters = arrays["link"].tolist()
    source, known = list(LinkSource)[int(arrays["link_source"])], as_rows(arrays["link_covariance"])
    link = Link(int(first), int(second), (right, down), turn, log_scale, known, source, bool(in_meters))
    evidence = None
    if "evidence" in arrays:
        evidence = EvidenceLevel(arrays["evidence"], arrays["known"], tuple(arrays["pixel"].tolist()))
    place = arrays["position"].tolist() if "position" in arrays else None
    heading, sizes = arrays["heading"].tolist(), arrays["sizes"].tolist()
    prior = Prior(
        None if place is None else (place[0], place[1]),
        None if place is None else place[2],
        heading[0] if heading else None,
        float(arrays["heading_range"][0]),
        (sizes[0], sizes[1]) if sizes else None,
    )
    own = arrays["own"] if len(arrays["own"]) else None
    return Past(SeenImage(evidence, edge_px, (mean, spread), prior, own, own_odds), link, weight)
