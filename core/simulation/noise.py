"""Errors of simulated images: quality of labels, and distance of a map from the ground.

A ``LabelNoise`` changes label images (``label_errors.py``) and, when only a database is available, landmarks
(``landmark_errors.py``). The effects of the camera, tilt and lens, belong to the view (``views.py``).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Any

from ..errors import ParameterError

JITTER_LENGTH_PX = 8.0
"""Default distance over which boundaries move together."""

DISPLACED_KERNELS = ((15.0, 0.47), (60.0, 0.28), (2000.0, 0.25))
"""Correlation of a map's displacements, (length, share of the variance), in meters: landmarks of Liechtenstein on maps
of two dates had correlations of 0.43 at 27 m, 0.25 at 100 to 200 m, 0.15 at 1 km."""

DISPLACED_M = 1.13
"""Standard deviation of these displacements along each axis, 1.6 m root mean square."""

_SHARES = ("missed", "spurious", "mislabeled", "background", "leaning")
_LISTS = ("displaced_kernels", "class_shifts", "leaning_classes")


@dataclass(frozen=True)
class LabelNoise:
    """Errors of the labels of an image. Lengths are in m, or in pixels after ``in_pixels``.

    Attributes:
        missed: Share of missed landmarks, 0…1.
        spurious: Spurious landmarks, as a share of the existing ones, 0…1.
        mislabeled: Share of landmarks that get another class.
        jitter: Standard deviation of the boundaries' displacement, along each axis.
        jitter_length: Distance over which boundaries move together; None for JITTER_LENGTH_PX, whatever the pixels.
        missed_below: Only landmarks of a smaller area are missed.
        center: For landmarks only, standard deviation of the center along each axis.
        log_area: For landmarks only, standard deviation of ln area.
        background: Share of the regions outside the classes of landmarks that get another of their classes.
        displaced: Standard deviation, along each axis, of the displacement between map and ground that neighbors share.
        displaced_kernels: Correlation of this displacement, (length, share) each: DISPLACED_KERNELS.
        class_shifts: (class value, right, down) of class offsets, as networks have them.
        leaning: Displacement of roofs of usual height, as a share of the distance from the center.
        leaning_spread: Standard deviation of ln height.
        leaning_classes: Classes that lean; all landmarks if empty.

    Raises:
        ParameterError: A value is negative, a share above 1, or not a number.
    """

    missed: float = 0.0
    spurious: float = 0.0
    mislabeled: float = 0.0
    jitter: float = 0.0
    jitter_length: float | None = None
    missed_below: float = math.inf
    center: float = 0.0
    log_area: float = 0.0
    background: float = 0.0
    displaced: float = 0.0
    displaced_kernels: tuple[tuple[float, float], ...] = DISPLACED_KERNELS
    class_shifts: tuple[tuple[int, float, float], ...] = ()
    leaning: float = 0.0
    leaning_spread: float = 0.4
    leaning_classes: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        for field in fields(self):
            if field.name in _LISTS:
                continue
            value = getattr(self, field.name)
            most = 1.0 if field.name in _SHARES else math.inf
            is_bounded = value is None or value < math.inf or field.name == "missed_below"
            if not is_bounded or value is not None and not 0 <= value <= most:
                raise ParameterError(
                    "Simulated error {name} is {value:g}; it must be from 0 to {most:g}.",
                    name=field.name,
                    value=value,
                    most=most,
                )

    def in_pixels(self, pixel_size: float) -> LabelNoise:
        """Return the same noise with lengths and areas in pixels of ``pixel_size`` m."""
        changed: dict[str, Any] = {name: getattr(self, name) / pixel_size for name in ("jitter", "center", "displaced")}
        changed["displaced_kernels"] = tuple((length / pixel_size, share) for length, share in self.displaced_kernels)
        changed["class_shifts"] = tuple(
            (value, right / pixel_size, down / pixel_size) for value, right, down in self.class_shifts
        )
        if self.jitter_length is not None:
            changed["jitter_length"] = self.jitter_length / pixel_size
        return replace(self, **changed, missed_below=self.missed_below / pixel_size**2)

    @property
    def changes_landmarks(self) -> bool:
        """Whether landmarks are missed, spurious or mislabeled."""
        return self.missed > 0 or self.spurious > 0 or self.mislabeled > 0


USUAL = LabelNoise(missed=0.2, spurious=0.2, mislabeled=0.05, jitter=1.0)
"""Defaults of assessments and evaluations, in meters."""
