"""Prior position, heading and scale of images: the parameters, and how their values limit the search."""

from __future__ import annotations

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterNumber,
    QgsProcessingParameterPoint,
)

from ...core.errors import ParameterError
from ...core.localization import Method, Prior
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import DOUBLE
from ..translation import tr

PRIOR_POINT, PRIOR_RADIUS = "PRIOR_POINT", "PRIOR_RADIUS"
PRIOR_HEADING, PRIOR_HEADING_RANGE = "PRIOR_HEADING", "PRIOR_HEADING_RANGE"
SCALE_MINIMUM, SCALE_MAXIMUM = "SCALE_MINIMUM", "SCALE_MAXIMUM"


def parameters() -> tuple[QgsProcessingParameterDefinition, ...]:
    return (
        with_help(
            QgsProcessingParameterPoint(PRIOR_POINT, "Prior position", optional=True),
            "Approximate position of the images. It limits the search area and makes the search faster. Optional.",
            advanced=True,
        ),
        with_help(
            QgsProcessingParameterNumber(PRIOR_RADIUS, "Search radius (m)", DOUBLE, 1000.0, minValue=0.01),
            "Radius of the search area around the prior position. It is used only with a prior position.",
            advanced=True,
        ),
        with_help(
            QgsProcessingParameterNumber(
                PRIOR_HEADING, "Prior heading (°)", DOUBLE, optional=True, minValue=-360, maxValue=360
            ),
            "Approximate direction of the top of the images, in degrees clockwise from grid north. If not set, "
            "SemRef uses the heading of the camera (camera table or XMP) ± 25°, where it is known.",
            advanced=True,
        ),
        with_help(
            QgsProcessingParameterNumber(
                PRIOR_HEADING_RANGE, "Heading tolerance (± °)", DOUBLE, 20.0, minValue=1, maxValue=180
            ),
            "Only headings within this tolerance of the prior heading are searched. It is used only with a prior "
            "heading.",
            advanced=True,
        ),
        *_scale_parameters(),
    )


def _scale_parameters() -> tuple[QgsProcessingParameterDefinition, ...]:
    titles = {SCALE_MINIMUM: tr("Minimum scale"), SCALE_MAXIMUM: tr("Maximum scale")}
    return tuple(
        with_help(
            QgsProcessingParameterNumber(key, title, DOUBLE, optional=True, minValue=0.01, maxValue=100),
            "Ground length of the shorter image edge, as a multiple of the window size of the database. If neither "
            "limit is set, SemRef uses the height and lens of the camera, or 0.4 to 2.5 if they are unknown. A narrow "
            "range is searched faster.",
            advanced=True,
        )
        for key, title in titles.items()
    )


def scales(values: Values, method: Method) -> tuple[float, float] | None:
    """Return the range of scales to search.

    Args:
        method: Its default replaces the limit that is not given.

    Returns:
        (smallest, largest); None if neither is given, for the range of each method.

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
            "The minimum scale ({smallest:g}) is larger than the maximum scale ({largest:g}). Enter a minimum below "
            "the maximum.",
            smallest=smallest,
            largest=largest,
        )
    return smallest, largest


def prior(values: Values, crs: QgsCoordinateReferenceSystem) -> Prior:
    """Return the prior position and heading in the database's CRS. Pixel sizes follow from the scales and each image's
    shape."""
    position = values.point(PRIOR_POINT, crs)
    radius = None if position is None else values.number(PRIOR_RADIUS)
    return Prior(position, radius, values.optional_number(PRIOR_HEADING), values.number(PRIOR_HEADING_RANGE))
