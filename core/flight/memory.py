"""What a tracker remembers of the last images, and how it is written down: numbers in arrays, no pickles."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..correlation.class_pyramid import EvidenceLevel, mirrored_level
from ..localization import Prior
from .evidence import SeenImage
from .motion import Link, LinkSource, as_rows


@dataclass(frozen=True)
class Past:
    """An earlier image of the window.

    Attributes:
        seen: The image.
        link: To the next one.
        weight: Of its evidence.
    """

    seen: SeenImage
    link: Link
    weight: float


NOWHERE = Link(0, 1, (0.0, 0.0), 0.0, 0.0, as_rows(np.eye(4)))
"""Stands for the link of the latest image, which leads to none yet."""


def packed(past: Past) -> dict[str, np.ndarray]:
    """An image of the window as arrays by name."""
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


def unpacked(arrays: Mapping[str, np.ndarray]) -> Past:
    """An image of the window from ``packed``; raises KeyError or ValueError for what is none."""
    edge_px, mean, spread, own_odds, weight = arrays["numbers"].tolist()
    first, second, right, down, turn, log_scale, in_meters = arrays["link"].tolist()
    source = list(LinkSource)[int(arrays["link_source"])]
    known = as_rows(arrays["link_covariance"])
    link = Link(int(first), int(second), (right, down), turn, log_scale, known, source, bool(in_meters))
    evidence = None
    if "evidence" in arrays:
        pixel = arrays["pixel"].tolist()
        evidence = EvidenceLevel(arrays["evidence"], arrays["known"], (pixel[0], pixel[1]))
    sizes, heading = arrays["sizes"].tolist(), arrays["heading"].tolist()
    place = arrays["position"].tolist() if "position" in arrays else None
    prior = Prior(
        None if place is None else (place[0], place[1]),
        None if place is None else place[2],
        heading[0] if heading else None,
        float(arrays["heading_range"][0]),
        (sizes[0], sizes[1]) if sizes else None,
    )
    own = arrays["own"] if len(arrays["own"]) else None
    return Past(SeenImage(evidence, edge_px, (mean, spread), prior, own, own_odds), link, weight)


def mirrored(seen: SeenImage) -> SeenImage:
    """Left and right exchanged, without what can't be right then."""
    evidence = None if seen.evidence is None else mirrored_level(seen.evidence)
    return SeenImage(evidence, seen.edge_px, seen.chance, Prior(pixel_size_range=seen.prior.pixel_size_range))
