"""THE judged trial: a simulated image, what a localizer said of it, and how far that is from the truth.

Evaluations, assessments and benchmarks all make ``Query`` objects, localize what their views show, and hand both to
``judge``; what they count (``summary``, ``rates``) is counted over ``Trial`` objects alone.

Example:
    >>> query = Query(View(x, y, heading_deg=30.0, pixel_size=1.2))
    >>> labels_hw = spoil_labels(cut(source, frame, query.view), noise, rng, class_values)
    >>> trial = judge(query, method, localizer.localize(labels_hw, method))
    >>> trial.is_right, trial.error, trial.radius_ratio
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..geometry.pose import Ellipse
from ..localization import Localization, Method, Status
from ..simulation.noise import LabelNoise
from ..simulation.views import View

RIGHT_SHARE = 0.02
"""A position counts as right within this share of the footprint, unless told otherwise."""

SMALLEST_AXIS = 1e-6
"""Axes of an ellipse, map units, are taken to be at least so long."""


@dataclass(frozen=True)
class Query:
    """One image to be localized, before it is made.

    Attributes:
        view: what it shows: the truth
        kind: of images that are counted together; what the names are is up to who asks
        number: in its kind
        noise: how it is spoiled, lengths in map units
        is_of_map: False for ground that the database doesn't have: any fix is wrong, as it is of a mirrored view
    """

    view: View
    kind: str = ""
    number: int = 0
    noise: LabelNoise = LabelNoise()
    is_of_map: bool = True

    @property
    def can_be_right(self) -> bool:
        """Whether there is a right place at all."""
        return self.is_of_map and not self.view.is_mirrored


@dataclass(frozen=True)
class Trial:
    """What came of a query with one method. Errors are None where the method tells nothing to compare.

    Attributes:
        method: that was asked for
        is_right: a fix at the right place
        error: distance of the position from the true one, map units
        heading_error_deg: the short way round
        scale_error: of the pixel size, relative
        radius_ratio: error in units of the 95 % ellipse, or circle, that was told, in its direction; at most 1 inside
        window: that was matched, or lies nearest to the position found
        landmarks: of the map, whole in view or in the window, before any noise; None where nobody counted
        seconds: processor time of localizing; NaN where it wasn't taken
    """

    query: Query
    method: Method
    result: Localization
    is_right: bool = False
    error: float | None = None
    heading_error_deg: float | None = None
    scale_error: float | None = None
    radius_ratio: float | None = None
    window: str | None = None
    landmarks: int | None = None
    seconds: float = math.nan

    @property
    def status(self) -> Status:
        """Status of the localization."""
        return self.result.status

    @property
    def is_fix(self) -> bool:
        """Whether a position was told."""
        return self.result.is_fix

    @property
    def is_wrong(self) -> bool:
        """Whether a wrong position was told."""
        return self.is_fix and not self.is_right

    @property
    def error_share(self) -> float | None:
        """Error as a share of the footprint."""
        return None if self.error is None else self.error / self.query.view.footprint


def judge(  # noqa: PLR0913 - the last three are notes that a trial carries along
    query: Query,
    method: Method,
    result: Localization,
    right_within: float | None = None,
    landmarks: int | None = None,
    seconds: float = math.nan,
) -> Trial:
    """Compares a result with the truth.

    Args:
        query: the image, whose view is the truth
        method: that was asked for
        right_within: map units that a right position may be off; None for RIGHT_SHARE of the footprint
        landmarks: as ``Trial`` says
        seconds: as ``Trial`` says
    """
    if result.position is None:
        return Trial(query, method, result, landmarks=landmarks, seconds=seconds)
    view = query.view
    x, y = result.position[0] - view.x, result.position[1] - view.y
    error, heading_error, scale_error = math.hypot(x, y), None, None
    if result.heading_deg is not None and result.pixel_size_m is not None:
        heading_error = abs((result.heading_deg - view.heading_deg + 180) % 360 - 180)
        scale_error = abs(result.pixel_size_m * view.width_px / view.footprint - 1)
    within = RIGHT_SHARE * view.footprint if right_within is None else right_within
    return Trial(
        query,
        method,
        result,
        query.can_be_right and result.is_fix and error <= within,
        error,
        heading_error,
        scale_error,
        _radius_ratio(x, y, result),
        result.window,
        landmarks,
        seconds,
    )


def _radius_ratio(x: float, y: float, result: Localization) -> float | None:
    if result.covariance is not None and result.covariance.ellipse_95 is not None:
        return ellipse_ratio(x, y, result.covariance.ellipse_95)
    return math.hypot(x, y) / result.error_95_m if result.error_95_m else None


def ellipse_ratio(x: float, y: float, ellipse: Ellipse) -> float:
    """Length of an error (x, y), map units, in units of the 95 % ellipse in its direction; at most 1 inside."""
    along = complex(x, y) * np.exp(-1j * np.radians(90 - ellipse.orientation_deg))
    # Landmarks without any noise give an ellipse without extent.
    major, minor = max(ellipse.semi_major, SMALLEST_AXIS), max(ellipse.semi_minor, SMALLEST_AXIS)
    return float(np.hypot(along.real / major, along.imag / minor))
