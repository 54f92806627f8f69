"""What is known of images before they are localized: its parameters, and what is searched by their values."""

from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsProcessingParameterDefinition, QgsProcessingParameterNumber, QgsProcessingParameterPoint

from ...core.errors import ParameterError
from ...core.localization import Method, Prior
from ..compat import DOUBLE
from ..translation import tr
from .parameters import with_help

if TYPE_CHECKING:
    from qgis.core import QgsCoordinateReferenceSystem

    from .values import Values

PRIOR_POINT, PRIOR_RADIUS = "PRIOR_POINT", "PRIOR_RADIUS"
PRIOR_HEADING, PRIOR_HEADING_RANGE = "PRIOR_HEADING", "PRIOR_HEADING_RANGE"
SCALE_MINIMUM, SCALE_MAXIMUM = "SCALE_MINIMUM", "SCALE_MAXIMUM"


def parameters() -> tuple[QgsProcessingParameterDefinition, ...]:
    """Position, heading and scale; none is ever needed."""
    return (
        with_help(
            QgsProcessingParameterPoint(PRIOR_POINT, tr("Approximate position"), optional=True),
            tr("Where the images are known to be, roughly. It speeds up the search and is never needed."),
            advanced=True,
        ),
        with_help(
            QgsProcessingParameterNumber(
                PRIOR_RADIUS, tr("Radius around it (map units)"), type=DOUBLE, defaultValue=1000.0, minValue=0.01
            ),
            tr("Only with an approximate position: places farther away are not searched."),
            advanced=True,
        ),
        with_help(
            QgsProcessingParameterNumber(
                PRIOR_HEADING, tr("Approximate heading (°)"), type=DOUBLE, optional=True, minValue=-360, maxValue=360
            ),
            tr(
                "Where the images’ top points to, roughly, in degrees clockwise from grid north. If it is left "
                "out: what the camera tells, if it is known (camera table, XMP), within 25°."
            ),
            advanced=True,
        ),
        with_help(
            QgsProcessingParameterNumber(
                PRIOR_HEADING_RANGE,
                tr("Range around it (± °)"),
                type=DOUBLE,
                defaultValue=20.0,
                minValue=1,
                maxValue=180,
            ),
            tr("Only with an approximate heading: other headings are not searched."),
            advanced=True,
        ),
        *_scale_parameters(),
    )


def _scale_parameters() -> tuple[QgsProcessingParameterDefinition, ...]:
    scale = tr(
        "Ground that the shorter edge of an image shows, as a multiple of the database’s window size. If both are "
        "left out: what the camera’s height and lens tell, if they are known (camera table, EXIF, XMP), else 0.4 "
        "to 2.5. A narrow range is searched faster."
    )
    titles = {SCALE_MINIMUM: tr("Smallest scale"), SCALE_MAXIMUM: tr("Largest scale")}
    return tuple(
        with_help(
            QgsProcessingParameterNumber(key, title, type=DOUBLE, optional=True, minValue=0.01, maxValue=100),
            scale,
            advanced=True,
        )
        for key, title in titles.items()
    )


def scales(values: Values, method: Method) -> tuple[float, float] | None:
    """What the scales are searched in.

    Args:
        values: Of an algorithm with these parameters.
        method: Whose default stands in for the one that is not given.

    Returns:
        (smallest, largest); None, each method's own, when neither is given.

    Raises:
        ParameterError: The smallest is larger than the largest.
    """
    from ...core.localizer.localizer import default_scales

    if not (values.has(SCALE_MINIMUM) or values.has(SCALE_MAXIMUM)):
        return None
    smallest, largest = default_scales(method)
    smallest = values.optional_number(SCALE_MINIMUM, smallest)
    largest = values.optional_number(SCALE_MAXIMUM, largest)
    if smallest > largest:
        raise ParameterError(
            "The smallest scale ({smallest:g}) is above the largest ({largest:g}); give both, the smaller first.",
            smallest=smallest,
            largest=largest,
        )
    return smallest, largest


def prior(values: Values, crs: QgsCoordinateReferenceSystem) -> Prior:
    """Position and heading in the database's CRS; pixel sizes follow from the scales and each image's shape."""
    position = values.point(PRIOR_POINT, crs)
    radius = None if position is None else values.number(PRIOR_RADIUS)
    return Prior(position, radius, values.optional_number(PRIOR_HEADING), values.number(PRIOR_HEADING_RANGE))
