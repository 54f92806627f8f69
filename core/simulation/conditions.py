"""Under what an image is simulated: how poor its labels are, and what all of it shares."""

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
"""Percent and degrees: no map could be read from beyond."""


@dataclass(frozen=True)
class Conditions:
    """What assessments and evaluations assume.

    Attributes:
        noise: of the labels, lengths in map units
        class_shift: how far each class of landmarks is shifted as a whole, in any direction, map units
        lens: radial distortion in the image's corners, of either sign, a share
        tilt_deg: of the camera, in any direction
    """

    noise: LabelNoise = field(default_factory=LabelNoise)
    class_shift: float = 0.0
    lens: float = 0.0
    tilt_deg: float = 0.0

    @property
    def biases(self) -> KnownBiases:
        """What is known of how labels are shifted: as of a network that states no bias."""
        return KnownBiases(class_spread=NETWORK_SPREAD) if self.class_shift > 0 else UNBIASED

    def drawn(self, view: View, rng: np.random.Generator, class_values: Sequence[int]) -> tuple[View, LabelNoise]:
        """One image's own: directions and signs are drawn.

        Args:
            view: what the camera is over
            rng: a seeded one repeats the result
            class_values: classes of landmarks

        Returns:
            The view with lens and tilt, and the noise with the classes' shifts.
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
"""What assessments assume unless they are told otherwise: maps of another date, houses of 5 m seen from 1,000 m, a
network as those that were measured, a camera without calibration on a gimbal; in meters."""


def conditions_of(numbers: Mapping[str, float]) -> Conditions:
    """How poor labels and cameras are taken to be.

    Args:
        numbers: By name: missed, invented, misnamed, ragged, background, displaced, shifted, leaning, lens and tilt;
            percent, map units, degrees.

    Raises:
        ParameterError: For what can't be.
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
