"""Leveling of tilted images: labels as a level camera sees them, and the result for the image as taken."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..geometry.leveling import Leveling
from ..geometry.pose import turn_of
from ..labels.class_shares import ClassShares, SeenLabels
from ..localization import Localization, Prior


def level_labels(seen: SeenLabels, way: Leveling) -> SeenLabels:
    """Return the labels of an image as a level camera sees them.

    Args:
        seen: Of the image as taken.
    """
    shares = seen.shares
    if shares is not None:
        height, width = seen.labels_hw.shape
        planes = way.level_planes(shares.shares, (height, width))
        picture = None if shares.picture is None else way.level_planes(shares.picture, (height, width))
        shares = ClassShares(shares.values, planes, picture)
    return replace(seen, labels_hw=way.level(seen.labels_hw), shares=shares)


def of_leveled(prior: Prior, way: Leveling) -> Prior:
    """Return the prior of the level image's middle.

    Args:
        prior: Of the image's center, with a range of pixel sizes.
    """
    if prior.position is None or prior.radius is None or prior.pixel_size_range is None:
        return prior
    return replace(prior, radius=prior.radius + abs(way.middle) * prior.pixel_size_range[1])


def as_taken(found: Localization, way: Leveling) -> Localization:
    """Return the result of a leveled image for the image as taken.

    Args:
        found: Of the leveled image.

    Returns:
        Position, heading and pixel size of the image's center; the heading is that of its top after leveling. Matches
        are in pixels of the image as taken. A fix or likely position has footprint and nadir.
    """
    if found.matches is not None:
        pixels = way.in_image(found.matches.pixels_xy)
        found = replace(found, matches=replace(found.matches, pixels_xy=pixels))
    place = found.best
    if place is None or place.heading_deg is None:
        return found
    turn = turn_of(*place.oriented)
    center = complex(*place.position) - turn * way.middle
    found = replace(found, best=replace(place, position=(center.real, center.imag)))
    if found.place is None:
        return found
    corners = center + turn * way.corners
    nadir = None if way.nadir is None else center + turn * way.nadir
    return replace(
        found,
        footprint=np.column_stack([corners.real, corners.imag]),
        nadir=None if nadir is None else (nadir.real, nadir.imag),
    )
