"""Photos that say they were taken far from the database's ground: told, as another database is meant or a sensor erred.

Positions of satellites find no fix and hold for none: localization is there for when they can't be had or trusted.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from .base import check_canceled
from .localized_image import LocalizedImage, far_sentence

if TYPE_CHECKING:
    from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransformContext, QgsProcessingFeedback

    from ...core.database.model import ReferenceDatabase

FAR_M = 1000.0
"""From the ground's border on; nearer, a camera that looks aside may well see it, and receivers err by less."""


def with_far_photos(
    localized: Sequence[LocalizedImage],
    database: ReferenceDatabase,
    crs: QgsCoordinateReferenceSystem,
    context: QgsCoordinateTransformContext,
    feedback: QgsProcessingFeedback,
) -> list[LocalizedImage]:
    """The images, those whose photos were taken far from the database's ground with how far; says so.

    Args:
        localized: Of one run.
        database: They were looked for in.
        crs: Of the database.
        context: How coordinates are transformed.
        feedback: Of the run.
    """
    from ...storage.photo_position import photo_lon_lat
    from ..exchange.reference_systems import meters_from

    told = []
    for item in localized:
        check_canceled(feedback)
        place = None if item.result is None else photo_lon_lat(item.path)
        away = None if place is None else meters_from(place, database.parameters.extent, crs, context)
        if away is not None and away > FAR_M:
            item = replace(item, gps_distance_m=away)
            feedback.pushWarning(f"{os.path.basename(item.path)}: {far_sentence(away)}")
        told.append(item)
    return told
