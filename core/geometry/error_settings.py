"""Prior knowledge of errors that landmarks share: of the map, of the network, of the camera.

Brackets name the data that a value was set on, and the trials that set it or ran with it. docs/reference/settings.md
has the command of each trial.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

MAP_ACCURACY = 1.2
"""Default standard deviation along each axis of landmarks between two maps of the same ground, meters: the geometric
mean of 0.70 m (Liechtenstein, 2015 and 2021) and 2.0 m (Andorra, 2016 and 2023), as *Compare label maps* measures it
(docs/explanation/method.md#displacement-between-map-dates)."""

NETWORK_SPREAD = 0.6
"""Default standard deviation along each axis of a network's class offset, meters. The network that was measured shows
buildings 0.4 to 0.6 m away from the sun; the offset varies by 0.35 m between pieces of ground
(docs/development.md#class-offsets-of-networks)."""


@dataclass(frozen=True)
class ErrorSettings:
    """Settings of the covariance of a pose (docs/explanation/method.md#position-error).

    Attributes:
        map_kernels: How neighbors share a map's displacement, (length in meters, share of the variance); the rest is
            independent for each landmark. Chosen for the coverage of real pairs of dates; moved landmarks have
            correlations of 0.57 (Liechtenstein) and 0.85 (Andorra) below 30 m, 0.14 and 0.42 at 500 to 1,000 m [maps of
            two dates; covariance].
        map_factors: Displacements that are tried, multiples of the map's stated accuracy, evenly spaced in their
            logarithm [maps of two dates; covariance].
        tilted_exponent: For a tilted pose the prior of a displacement is multiplied by this power of it: the pose has
            four additional numbers, which follow the displacement, and landmarks were matched because they agree with
            it. One for each number [reasoning; maps of two dates; covariance].
        own_factors: Noises of single landmarks that are tried, multiples of the noise that the median residual shows
            [reasoning].
        own_spread: Prior standard deviation of the logarithm of these noises [by hand; covariance].
        views: Cameras that are tried, (standard deviation of the lens' radial distortion in the corners, of the tilt in
            units of the effect of a tilt of 10°, share of cameras): level, slightly tilted, strongly tilted. Map
            correlation weighs its evidence on the camera against the same ones [by hand; covariance].
        class_spread_px: Standard deviation of the shift of a whole class beyond the stated class offset, pixels of the
            image [maps of two dates; covariance].
        common_share: Share of the variance that all classes without a stated offset have in common [photos of
            made-up areas; biases].
        roof_height: Standard deviation of the heights of landmarks, meters: raised ones lean away from the image's
            center, and residuals do not show it [buildings of Andorra with levels or height: median 12.8 m, standard
            deviation of ln 0.4; leaning roofs].
        roof_length: Distance, meters, at which the correlation of these heights falls to 1/e: large buildings, and
            neighbors of similar height [by hand; leaning roofs].
        most_landmarks: Largest number of landmarks that a pose is fitted to, evenly chosen from all. With 100 the
            radius of 32 fixes with 150 or more was 1.11 times as large (median; 0.69–1.68) [by hand].
    """

    map_kernels: tuple[tuple[float, float], ...] = ((60.0, 0.15), (300.0, 0.2), (3000.0, 0.65))
    map_factors: tuple[float, ...] = (0.03, 0.06, 0.13, 0.28, 0.6, 1.3, 2.8, 6.0)
    tilted_exponent: float = 4.0
    own_factors: tuple[float, ...] = (0.35, 0.5, 0.7, 1.0, 1.4, 2.0)
    own_spread: float = 1.0
    views: tuple[tuple[float, float, float], ...] = ((0.0001, 0.0001, 0.7), (0.01, 0.1, 0.15), (0.02, 1.0, 0.15))
    class_spread_px: float = 0.03
    common_share: float = 0.5
    roof_height: float = 6.0
    roof_length: float = 60.0
    most_landmarks: int = 200

    def leaning(self, diagonal_m: float) -> float:
        """Return the standard deviation of the lean, height over camera height, of roofs in an image on the ground.

        The camera is usually about as high as half the diagonal: its field of view is about 90° from corner to corner.
        """
        return self.roof_height / (diagonal_m / 2)


ERRORS = ErrorSettings()
"""Calibrated settings: the default of every localization."""


@dataclass(frozen=True)
class ClassBias:
    """Class offset: how far from its true position a network, or a map, shows a class, meters on the ground.

    Attributes:
        east: Along the map's axes, as shadows cause it.
        north: Along the map's axes, as shadows cause it.
        right: Along the image's axes, as properties of a network cause it.
        down: Along the image's axes, as properties of a network cause it.
        spread: Standard deviation along each axis of an image's offset around this one; None if unknown.
        sun_deg: Azimuth of the sun when east and north were measured, clockwise from grid north; the offset turns with
            it. None if it does not turn or the sun is unknown.
    """

    value: int
    east: float = 0.0
    north: float = 0.0
    right: float = 0.0
    down: float = 0.0
    spread: float | None = None
    sun_deg: float | None = None

    def in_image(self, turn: complex) -> complex:
        """Return the offset in the image's frame, map units: right and up."""
        return complex(self.east, self.north) * turn.conjugate() / abs(turn) + complex(self.right, -self.down)

    @property
    def length(self) -> float:
        """Upper bound of the offset's length, meters."""
        return math.hypot(self.east, self.north) + math.hypot(self.right, self.down)


@dataclass(frozen=True)
class KnownBiases:
    """Known class offsets of labels in a database's classes.

    Attributes:
        class_spread: For the other classes, meters, as for ``SharedErrors``.
    """

    class_biases: tuple[ClassBias, ...] = ()
    class_spread: float = 0.0


UNBIASED = KnownBiases()
"""Labels without class offsets."""


@dataclass(frozen=True)
class SharedErrors:
    """Prior knowledge of the errors of a map and of labels.

    Attributes:
        map_accuracy: Standard deviation along each axis of the map's landmarks, map units.
        map_pixel_size: Of the label map, map units; 0 for a map without pixels.
        class_spread: Standard deviation along each axis of the offset of classes without a stated one, meters: the
            usual value for a network without a stated one. 0 for labels without offsets.
        sun_deg: Azimuth of the sun when the image was taken, clockwise from grid north; None if unknown.
    """

    map_accuracy: float = MAP_ACCURACY
    map_pixel_size: float = 0.0
    class_biases: tuple[ClassBias, ...] = ()
    settings: ErrorSettings = field(default=ERRORS)
    class_spread: float = 0.0
    sun_deg: float | None = None

    def with_biases(self, biases: KnownBiases) -> SharedErrors:
        """Return a copy with the class offsets of an image's labels."""
        return replace(self, class_biases=biases.class_biases, class_spread=biases.class_spread)

    def bias_of(self, value: int) -> ClassBias:
        """Return the offset of a class under the image's sun; zero if it is unknown."""
        found = next((bias for bias in self.class_biases if bias.value == value), ClassBias(value))
        if found.sun_deg is None:
            return found
        if self.sun_deg is None:
            # Its direction is unknown; only its length counts.
            own = self.class_spread if found.spread is None else found.spread
            spread = math.hypot(own, math.hypot(found.east, found.north) / math.sqrt(2))
            return replace(found, east=0.0, north=0.0, spread=spread)
        shadow = complex(found.east, found.north) * cmath.rect(1, math.radians(found.sun_deg - self.sun_deg))
        return replace(found, east=shadow.real, north=shadow.imag)

    def spread_of(self, bias: ClassBias, pixel_size: float) -> float:
        """Return the standard deviation along each axis of what remains of an offset, map units."""
        if bias.spread is None:
            own = self.class_spread * math.sqrt(1 - self.settings.common_share)
            return max(own, self.settings.class_spread_px * pixel_size)
        return max(bias.spread, 1e-3 * pixel_size)

    @property
    def common_spread(self) -> float:
        """Standard deviation along each axis of the shift that classes without a stated offset share, meters."""
        return self.class_spread * math.sqrt(self.settings.common_share)

    def unstated(self, values: Sequence[int]) -> list[int]:
        """Return the class values without a known offset."""
        return [value for value in values if self.bias_of(value).spread is None]
