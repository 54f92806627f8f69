"""Images of cameras that were not level: leveled, localized, and told for the image itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..geometry.camera import HEADING_SPREAD_DEG, Camera
from ..geometry.leveling import Leveling
from ..geometry.pose import turn_of
from ..labels.class_shares import ClassShares, SeenLabels
from ..localization import Localization, Method, Prior
from .localizer import Localizer, default_scales


def localize_leveled(  # noqa: PLR0913 - what ``Localizer.localize`` takes, and how the image is leveled
    localizer: Localizer,
    labels_hw: np.ndarray,
    method: Method,
    prior: Prior,
    way: Leveling,
    with_matches: bool = False,
    shares: ClassShares | None = None,
) -> Localization:
    """Levels an image, localizes it and takes the result back.

    Args:
        localizer: Of the database.
        labels_hw: (H, W) uint8 labels of the image as it is.
        method: One that tells heading and pixel size.
        prior: About the image's center, with a range of pixel sizes.
        way: How the image is leveled.
        with_matches: As of ``Localizer.localize``.
        shares: Probable shares of classes in the image as it is.

    Returns:
        The position is that of the image's center, heading and pixel size are those there, the heading that of its top
        as a level camera would have it; footprint and nadir are told, matches are those of the image as it is.
    """
    level = level_labels(SeenLabels(labels_hw, shares), way)
    found = localizer.localize(level.labels_hw, method, of_leveled(prior, way), with_matches, level.shares)
    return as_taken(found, way)


def level_labels(seen: SeenLabels, way: Leveling) -> SeenLabels:
    """What is seen in an image as a level camera sees it.

    Args:
        seen: In the image as it is.
        way: How it is leveled.
    """
    shares = seen.shares
    if shares is not None:
        height, width = seen.labels_hw.shape
        shares = ClassShares(shares.values, way.level_planes(shares.shares, (height, width)))
    return SeenLabels(way.level(seen.labels_hw), shares, seen.trained_on)


def of_leveled(prior: Prior, way: Leveling) -> Prior:
    """What is known of the middle of the level image, which is searched for.

    Args:
        prior: About the image's center, with a range of pixel sizes.
        way: How the image is leveled.
    """
    if prior.position is None or prior.radius is None or prior.pixel_size_range is None:
        return prior
    return replace(prior, radius=prior.radius + abs(way.middle) * prior.pixel_size_range[1])


def as_taken(found: Localization, way: Leveling) -> Localization:
    """The result of a leveled image told for the image as it was taken, as ``localize_leveled`` does.

    Args:
        found: Of the leveled image.
        way: How it was leveled.
    """
    if found.matches is not None:
        pixels = way.in_image(found.matches.pixels_xy)
        found = replace(found, matches=replace(found.matches, pixels_xy=pixels))
    place = found.place
    if place is None:
        return found
    turn = turn_of(*place.oriented)
    center = complex(*place.position) - turn * way.middle
    corners = center + turn * way.corners
    nadir = None if way.nadir is None else center + turn * way.nadir
    return replace(
        found,
        best=replace(place, position=(center.real, center.imag)),
        footprint=np.column_stack([corners.real, corners.imag]),
        nadir=None if nadir is None else (nadir.real, nadir.imag),
    )


def with_camera(prior: Prior, camera: Camera, shape_hw: tuple[int, int]) -> Prior:
    """A prior with what the camera knew of pixel size and heading, where nobody said otherwise.

    Args:
        prior: What the user said.
        camera: Of the image; its meters are map units.
        shape_hw: (height, width) of the image.
    """
    if prior.pixel_size_range is None:
        prior = replace(prior, pixel_size_range=camera.pixel_sizes(shape_hw))
    if prior.heading_deg is None and camera.heading_deg is not None:
        prior = replace(prior, heading_deg=camera.heading_deg, heading_range_deg=HEADING_SPREAD_DEG)
    return prior


def prior_of(localizer: Localizer, method: Method, prior: Prior, camera: Camera, shape_hw: tuple[int, int]) -> Prior:
    """What is searched for an image, by what the user said and its camera knew.

    Args:
        localizer: Of the database.
        method: That finds the image.
        prior: What the user said.
        camera: Of the image; its meters are map units.
        shape_hw: (height, width) of the image as it is.
    """
    prior = with_camera(prior, camera, shape_hw)
    if prior.pixel_size_range is None and camera.leveling(shape_hw) is not None:
        # A leveled image has another shape: its pixel sizes are those of the image as it is, for all methods.
        prior = replace(prior, pixel_size_range=localizer.pixel_sizes(shape_hw, default_scales(method)))
    return prior
