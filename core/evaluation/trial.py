"""A judged trial: a simulated image, its localization, and the error against the ground truth.

Evaluations, assessments and benchmarks make ``Query`` objects, localize the content of their views, and pass both to
``judge``. All statistics (``summary``, ``rates``) are computed from ``Trial`` objects.

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
"""Default of the largest error of a right position, as a share of the footprint."""

SMALLEST_AXIS = 1e-6
"""Least length of an ellipse's axes, m."""


@dataclass(frozen=True)
class Query:
    """One image to localize, before it is made.

    Attributes:
        view: Its content, which is the ground truth.
        kind: Name of images that are counted together; callers choose it.
        number: In its kind.
        noise: Simulated errors, lengths in m.
        is_of_map: False for ground outside the database: any fix is wrong, as for a mirrored view.
    """

    view: View
    kind: str = ""
    number: int = 0
    noise: LabelNoise = LabelNoise()
    is_of_map: bool = True

    @property
    def can_be_right(self) -> bool:
        """Whether a right place exists."""
        return self.is_of_map and not self.view.is_mirrored


@dataclass(frozen=True)
class Trial:
    """Result of a query with one method. Errors are None if the method gives nothing to compare.

    Attributes:
        is_right: Whether it is a fix at the right place.
        error: Distance of the position from the true one, m; also of a likely position.
        scale_error: Of the pixel size, relative.
        radius_ratio: Error in units of the stated 95 % ellipse or circle in its direction; at most 1 inside.
        window: Matched window, or the one nearest to the position.
        landmarks: Landmarks of the map, whole in view or in the window, before any errors; None if not counted.
        seconds: Processor time of localizing; NaN if not measured.
        is_likely_right: Whether it is a likely position at the right place, which is no fix.
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
    is_likely_right: bool = False

    @property
    def status(self) -> Status:
        """Status of the localization."""
        return self.result.status

    @property
    def is_fix(self) -> bool:
        """Whether the result is a fix. A likely position is none: it is neither right nor wrong."""
        return self.result.is_fix

    @property
    def is_wrong(self) -> bool:
        """Whether the result is a fix at a wrong place."""
        return self.is_fix and not self.is_right


def judge(  # noqa: PLR0913 - the last three are notes that a trial carries along
    query: Query,
    method: Method,
    result: Localization,
    right_within: float | None = None,
    landmarks: int | None = None,
    seconds: float = math.nan,
) -> Trial:
    """Compare a result with the ground truth.

    Args:
        right_within: Largest error of a right position, m; None for RIGHT_SHARE of the footprint.
        landmarks: As in ``Trial``.
        seconds: As in ``Trial``.
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
    is_there = query.can_be_right and error <= within
    return Trial(
        query,
        method,
        result,
        is_there and result.is_fix,
        error,
        heading_error,
        scale_error,
        _radius_ratio(x, y, result),
        result.window,
        landmarks,
        seconds,
        is_there and result.is_likely,
    )


def _radius_ratio(x: float, y: float, result: Localization) -> float | None:
    if result.covariance is not None and result.covariance.ellipse_95 is not None:
        return ellipse_ratio(x, y, result.covariance.ellipse_95)
    return math.hypot(x, y) / result.error_95_m if result.error_95_m else None


def ellipse_ratio(x: float, y: float, ellipse: Ellipse) -> float:
    """Return the length of an error (x, y) in units of the 95 % ellipse in its direction; at most 1 inside."""
    along = complex(x, y) * np.exp(-1j * np.radians(90 - ellipse.orientation_deg))
    # Landmarks without noise give an ellipse without extent.
    major, minor = max(ellipse.semi_major, SMALLEST_AXIS), max(ellipse.semi_minor, SMALLEST_AXIS)
    return float(np.hypot(along.real / major, along.imag / minor))
