"""What the reference objects say of a pose that another method found (DESIGN §3)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Tuple

import numpy as np

from .constellation import make_query
from .constellation_index import ConstellationIndex, full_area
from .pose import Pose
from .reference_objects import ReferenceObjects
from .verification import LARGEST_OBJECTS, Verifier, expected_objects, telling_objects, verify


@dataclass(frozen=True)
class ObjectCheck:
    """Objects at a pose. expected: of the map, that the image should show whole; shown: of the image, that could be on
    the map; matched: of these, that agree with the map; by_chance: that agree with it in turned and mirrored images at
    the same place, on average; log_odds: of the match, as the constellation weighs it."""

    expected: int
    shown: int
    matched: int
    by_chance: float
    log_odds: float


def check_objects(
    objects: ReferenceObjects,
    shape_hw: Tuple[int, int],
    index: ConstellationIndex,
    minimum_area_px: float,
    position: Tuple[float, float],
    heading_deg: float,
    pixel_size_m: float,
) -> ObjectCheck:
    """The objects of an image against the map's at a pose, after a small refinement.

    ``objects``: of the whole image, extracted with ``minimum_area_px``; ``position``: of its centre, map (x, y);
    ``heading_deg``: of its top, clockwise from grid north. What chance gives is seen in the image turned by half a
    circle and mirrored both ways: they have the same objects and can't be right.
    """
    height, width = shape_hw
    query = make_query(objects, index, width, height)
    query = query.select(telling_objects(query, LARGEST_OBJECTS))
    if not len(index) or not len(query.points):
        return ObjectCheck(0, len(query.points), 0, 0.0, 0.0)
    verifier = Verifier(index, width, height, float(full_area(minimum_area_px, 1.0)))
    pose = Pose(complex(*position) - index.origin, complex(pixel_size_m * np.exp(-1j * np.radians(heading_deg))))
    evidence = verify(verifier, query, pose)
    decoys = [replace(query, points=points) for points in (-query.points, query.points.conj(), -query.points.conj())]
    by_chance = np.mean([len(verify(verifier, decoy, pose).matched) for decoy in decoys])
    expected = len(expected_objects(verifier, query, evidence.pose))
    return ObjectCheck(expected, evidence.considered, len(evidence.matched), float(by_chance), evidence.log_odds)
