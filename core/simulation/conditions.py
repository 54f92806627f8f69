"""Conditions of simulated images: errors of labels and effects that the whole image shares."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from ..geometry.error_settings import NETWORK_SPREAD, UNBIASED, KnownBiases
from .noise import DISPLACED_M, USUAL, LabelNoise

if TYPE_CHECKING:
    from .views import View

LARGEST_LENS, LARGEST_TILT_DEG = 10.0, 30.0
"""Percent and degrees; a map can't be compared beyond."""


@dataclass(frozen=True)
class Conditions:
    """Assumptions of assessments and evaluations.

    Attributes:
        noise: Of the labels, lengths in m.
        class_shift: Class offset of each class of landmarks, in any direction, m.
        lens: Radial distortion in the image's corners, of either sign, a share.
        tilt_deg: Of the camera, in any direction.
    """

    noise: LabelNoise = field(default_factory=LabelNoise)
    class_shift: float = 0.0
    lens: float = 0.0
    tilt_deg: float = 0.0

    @property
    def biases(self) -> KnownBiases:
        """Known class offsets: those of a network without stated offsets."""
        return KnownBiases(class_spread=NETWORK_SPREAD) if self.class_shift > 0 else UNBIASED

    def drawn(self, view: View, rng: np.random.Generator, class_values: Sequence[int]) -> tuple[View, LabelNoise]:
        """Return one image's view and noise with random directions and signs.

        Returns:
            The view with lens and tilt, and the noise with the classes' offsets.
        """
        angles = rng.uniform(0, 2 * math.pi, len(class_values))
        sign, direction = float(rng.choice([-1, 1])), float(rng.uniform(0, 360))
        view = replace(view, lens=sign * self.lens, tilt_deg=self.tilt_deg, tilt_direction_deg=direction)
        if not self.class_shift:
            return view, self.noise
        shifts = tuple(
            (int(value), self.class_shift * math.cos(angle), self.class_shift * math.sin(angle))
            for value, angle in zip(class_values, angles.tolist())
        )
        return view, replace(self.noise, class_shifts=shifts)


ASSUMED = Conditions(
    replace(USUAL, background=USUAL.mislabeled, displaced=DISPLACED_M, leaning=0.005), 0.5, lens=0.005, tilt_deg=2.0
)
"""Default assumptions of assessments, in meters: maps of another date, houses of 5 m seen from 1,000 m, a network like
the measured ones, an uncalibrated camera on a gimbal."""


def conditions_of(numbers: Mapping[str, float]) -> Conditions:
    """Return the conditions of parameters.

    Args:
        numbers: By name: missed, invented, misnamed, ragged, background, displaced, shifted, leaning, lens and tilt;
            percent, m, degrees.

    Raises:
        ParameterError: A value is impossible.
    """
    noise = LabelNoise(
        numbers["missed"] / 100,
        numbers["invented"] / 100,
        numbers["misnamed"] / 100,
        numbers["ragged"],
        background=numbers["background"] / 100,
        displaced=numbers["displaced"],
        leaning=numbers["leaning"] / 100,
    )
    return Conditions(noise, numbers["shifted"], numbers["lens"] / 100, numbers["tilt"])
