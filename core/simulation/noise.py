"""THE errors of simulated images: how poor labels are, and how far a map is from the ground.

One ``LabelNoise`` spoils label images (``label_errors.py``) and, where nothing but a catalogue is there to be seen,
landmarks (``landmark_errors.py``). What the camera adds, tilt and lens, belongs to the view (``views.py``).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Any

from ..errors import ParameterError

JITTER_LENGTH_PX = 8.0
"""Over what length boundaries move alike, unless a noise states its own."""

DISPLACED_KERNELS = ((15.0, 0.47), (60.0, 0.28), (2000.0, 0.25))
"""How displacements of a map are shared, (length, share of the variance): landmarks of Liechtenstein on maps of two
dates had correlations of 0.43 at 27 m, 0.25 at 100 to 200 m, 0.15 at 1 km; in meters."""

DISPLACED_M = 1.13
"""Standard deviation along each axis of the same displacements, 1.6 m root mean square."""

_SHARES = ("missed", "spurious", "mislabeled", "merge_share", "split", "patches", "background", "leaning")
_LISTS = ("displaced_kernels", "class_shifts", "leaning_classes")


@dataclass(frozen=True)
class LabelNoise:
    """How poor the labels of an image are. Lengths are in map units, or in pixels after ``in_pixels``.

    Attributes:
        missed: share of the landmarks that are missed, 0…1
        spurious: landmarks added that are not there, as a share of those that are, 0…1
        mislabeled: share of the landmarks that get another class
        jitter: standard deviation of the boundaries' displacement, along each axis
        jitter_length: over what length boundaries move alike; None for JITTER_LENGTH_PX, whatever the pixels
        missed_below: only landmarks of a smaller area are missed
        merge_gap: gaps between landmarks of a class up to this width are filled
        merge_share: share of the image in which they are
        split: chance that a landmark is cut across
        split_length: only longer landmarks are
        split_gap: width of the cut
        thin: narrower parts of any class are lost
        patches: share of the area that gets random classes, in whole patches
        patch_size: about the edge of such a patch
        center: of landmarks alone, standard deviation of the center along each axis
        log_area: of landmarks alone, standard deviation of ln area
        background: share of the regions of other classes than those of landmarks that get another of these
        displaced: standard deviation, along each axis, of what map and ground differ by, which neighbors share
        displaced_kernels: how they share it, (length, share) each: DISPLACED_KERNELS
        class_shifts: (class value, right, down) of classes that are shifted as a whole, as networks do
        leaning: how far roofs of usual height lie from where they stand, as a share of the distance from the center
        leaning_spread: standard deviation of ln height
        leaning_classes: classes that lean; all landmarks if empty

    Raises:
        ParameterError: for a negative value, a share above 1, and what is no number.
    """

    missed: float = 0.0
    spurious: float = 0.0
    mislabeled: float = 0.0
    jitter: float = 0.0
    jitter_length: float | None = None
    missed_below: float = math.inf
    merge_gap: float = 0.0
    merge_share: float = 1.0
    split: float = 0.0
    split_length: float = 0.0
    split_gap: float = 3.0
    thin: float = 0.0
    patches: float = 0.0
    patch_size: float = 80.0
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
                    "Noise: {name} is {value:g}; give a number from 0 to {most:g}.",
                    name=field.name,
                    value=value,
                    most=most,
                )

    def in_pixels(self, pixel_size: float) -> LabelNoise:
        """The same noise, its lengths and areas in pixels of ``pixel_size`` map units."""
        lengths = ("jitter", "merge_gap", "split_length", "split_gap", "thin", "patch_size", "center", "displaced")
        changed: dict[str, Any] = {name: getattr(self, name) / pixel_size for name in lengths}
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
"""What assessments and evaluations assume unless they are told otherwise; in meters."""

_NETWORK = LabelNoise(missed_below=200.0, split_length=40.0)

MODEST = replace(_NETWORK, merge_gap=6, split=0.2, jitter=3, jitter_length=9, patches=0.15, thin=4, missed=0.15)
"""A usable network, in meters, seen on aerial tiles with an IoU of buildings near 0.5: houses merged, boundaries off by
3 m, 15 % of the area in a random class."""

STRONG = replace(_NETWORK, merge_gap=10, split=0.4, jitter=6, jitter_length=18, patches=0.35, thin=8, missed=0.4)
"""A poor network, in meters: boundaries off by 6 m, 35 % of the area in a random class, four small landmarks of ten
missed."""
