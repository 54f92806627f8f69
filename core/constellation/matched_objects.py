"""Which of an image's landmarks are which of the map's, where a fix is known: to be shown and counted."""

from __future__ import annotations

from dataclasses import replace
from typing import Tuple

import numpy as np

from ..database.model import MapLandmarks
from ..geometry.footprint import on_ground
from ..geometry.pose import Pose, turn_of
from ..landmarks.landmarks import Landmarks
from .index import build_index, full_area
from .solver import TILTED_MARGIN, make_query
from .verification import LARGEST_OBJECTS, MINIMUM_MATCHES, Verifier, telling_objects, verify, verify_tilted

NEARBY = 0.1
"""Objects of the map are looked at this share of the footprint's extent around it, too."""


def matched_objects(
    objects: Landmarks,
    shape_hw: Tuple[int, int],
    footprint: np.ndarray,
    heading_deg: float,
    pixel_size_m: float,
    references: MapLandmarks,
    map_pixel_size_m: float,
) -> np.ndarray:
    """(m, 2) int64: objects of the image and of the map that agree, as the constellation verifies a pose.

    Told in docs/method.md#constellation.

    objects: of an image of ``shape_hw`` pixels; footprint: (4, 2) map coordinates of the ground at its corners, upper
    left first, clockwise – of a tilted image that was leveled, a trapezoid; heading_deg, pixel_size_m: at its center.
    Empty where no more agree than by chance. At most LARGEST_OBJECTS of the image's objects are compared.
    """
    height, width = shape_hw
    reach = NEARBY * np.ptp(footprint, axis=0)
    low, high = footprint.min(axis=0) - reach, footprint.max(axis=0) + reach
    near = np.flatnonzero(((references.positions >= low) & (references.positions <= high)).all(axis=1))
    nothing = np.empty((0, 2), np.int64)
    if min(len(objects), len(near)) < MINIMUM_MATCHES:
        return nothing
    index = build_index(_select(references, near), map_pixel_size_m)
    turn = turn_of(heading_deg, pixel_size_m)
    ground = on_ground(np.vstack([objects.centers_xy, [(width / 2, height / 2)]]), footprint, shape_hw)
    ground = ground[:, 0] + 1j * ground[:, 1]
    # Where a level camera would have seen them: of an image that is level already, where they are.
    query = replace(make_query(objects, index, width, height), points=(ground[:-1] - ground[-1]) / turn)
    telling = telling_objects(query, LARGEST_OBJECTS)
    if len(telling) < MINIMUM_MATCHES:
        return nothing
    verifier = Verifier(index, width, height, float(full_area(objects.areas_px.min(), 1.0)))
    chosen, pose = query.select(telling), Pose(complex(ground[-1] - index.origin), turn)
    evidence = verify(verifier, chosen, pose)
    if len(evidence.matched):
        tilted = verify_tilted(verifier, chosen, pose, complex(chosen.points[evidence.matched].mean()))
        evidence = tilted if tilted.log_odds > evidence.log_odds + TILTED_MARGIN else evidence
    if evidence.log_odds <= 0:
        return nothing
    return np.column_stack([telling[evidence.matched], near[evidence.objects]])


def _select(references: MapLandmarks, chosen: np.ndarray) -> MapLandmarks:
    return MapLandmarks(
        references.positions[chosen],
        references.classes[chosen],
        references.areas_m2[chosen],
        references.touches_edge[chosen],
    )
