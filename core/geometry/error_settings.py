"""What is taken to be known of errors that landmarks share: of the map, of the network, of the camera.

In brackets: the data that a value was set on, and the trials that set it or used it, by their names in
docs/reference/settings.md.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

MAP_ACCURACY = 1.1
"""Standard deviation along each axis of landmarks between two maps of one ground, meters, where nobody states another:
1.6 m root mean square between maps of Liechtenstein of two dates, by other mappers."""

NETWORK_SPREAD = 0.6
"""Standard deviation along each axis of the shift that a network gives a class, meters, where nobody states it: the one
that was measured shows buildings 0.4 to 0.6 m from the sun, by 0.35 m more or less from piece to piece of ground
(docs/development.md#class-offsets-of-networks)."""


@dataclass(frozen=True)
class ErrorSettings:
    """Settings of the covariance of a pose (docs/explanation/method.md#position-error).

    Attributes:
        map_kernels: How neighbors share a map's displacement, (length in meters, share of the variance); the rest is
            each landmark's own. Correlations of 0.43 at 27 m, 0.25 at 100 to 200 m and 0.15 at 1 km were measured [maps
            of two dates; covariance].
        map_factors: Displacements that are tried, multiples of the map's stated accuracy [reasoning].
        own_factors: Noises of single landmarks that are tried, multiples of what the median residual tells [reasoning].
        own_spread: Standard deviation of their logarithm, before residuals are seen [by hand; covariance].
        views: Cameras that are tried, (standard deviation of the lens' radial distortion in the corners, of the tilt in
            units of what a tilt of 10° does, share of cameras): none of both, little, much. Map correlation weighs what
            it sees of a camera against the same ones [by hand; covariance].
        class_spread_px: Standard deviation of the shift that a class has as a whole, beyond what is stated, pixels of
            the image [by hand; covariance].
        common_share: Share of the variance that classes of which nothing is known are shifted by alike [photos of
            made-up areas; biases].
        leaning: Standard deviation of ln pixel size for roofs that lean away from the image's center: they look larger,
            and no residual tells [geometry of houses of 5 m seen from 1,000 m].
        most_landmarks: Landmarks that a pose is fitted to; of more so many, evenly chosen. Of 100 the radius of 32
            fixes with 150 or more was 1.11 times as large (median; 0.69–1.68) [by hand].
    """

    map_kernels: tuple[tuple[float, float], ...] = ((60.0, 0.28), (2000.0, 0.25))
    map_factors: tuple[float, ...] = (0.03, 0.1, 0.2, 0.4, 0.7, 1.0, 1.5, 2.5)
    own_factors: tuple[float, ...] = (0.35, 0.5, 0.7, 1.0, 1.4, 2.0)
    own_spread: float = 1.0
    views: tuple[tuple[float, float, float], ...] = ((0.0001, 0.0001, 0.7), (0.01, 0.1, 0.15), (0.02, 1.0, 0.15))
    class_spread_px: float = 0.1
    common_share: float = 0.5
    leaning: float = 0.005
    most_landmarks: int = 200


ERRORS = ErrorSettings()
"""As calibrated: the default of every localization."""


@dataclass(frozen=True)
class ClassBias:
    """How far from where it is a network, or a map, shows a class, meters on the ground.

    Attributes:
        east: Along the map's axes, as shadows make it.
        north: The same.
        right: Along the image's axes, as a network's own habits make it.
        down: The same.
        spread: Standard deviation along each axis of what an image's bias differs from it; None where nobody knows.
        sun_deg: Where the sun stood, clockwise from grid north, when east and north were measured: they turn with it.
            None where they don't, or where nobody knows.
    """

    value: int
    east: float = 0.0
    north: float = 0.0
    right: float = 0.0
    down: float = 0.0
    spread: float | None = None
    sun_deg: float | None = None

    def in_image(self, turn: complex) -> complex:
        """The bias in the image's frame, map units: right and up."""
        return complex(self.east, self.north) * turn.conjugate() / abs(turn) + complex(self.right, -self.down)

    @property
    def length(self) -> float:
        """At most so far it shifts, meters."""
        return math.hypot(self.east, self.north) + math.hypot(self.right, self.down)


@dataclass(frozen=True)
class KnownBiases:
    """What is known of how a network, or whatever else made labels, shifts a database's classes.

    Attributes:
        class_spread: Of the other classes, meters, as ``SharedErrors`` says.
    """

    class_biases: tuple[ClassBias, ...] = ()
    class_spread: float = 0.0


UNBIASED = KnownBiases()
"""Of labels that nothing shifts."""


@dataclass(frozen=True)
class SharedErrors:
    """What is known beforehand of a map and of labels.

    Attributes:
        map_accuracy: Standard deviation along each axis of the map's landmarks, map units.
        map_pixel_size: Of the label map, map units; 0 for a map that has none.
        class_spread: Standard deviation along each axis of the shift of classes of which nothing is known, meters: what
            a network that states none is to be trusted with. 0 for labels that nothing shifts.
        sun_deg: Where the sun stood when the image was taken, clockwise from grid north; None where nobody knows.
    """

    map_accuracy: float = MAP_ACCURACY
    map_pixel_size: float = 0.0
    class_biases: tuple[ClassBias, ...] = ()
    settings: ErrorSettings = field(default=ERRORS)
    class_spread: float = 0.0
    sun_deg: float | None = None

    def with_biases(self, biases: KnownBiases) -> SharedErrors:
        """Return the same with what is known of the labels of an image.

        Args:
            biases: Of whatever made the labels.
        """
        return replace(self, class_biases=biases.class_biases, class_spread=biases.class_spread)

    def bias_of(self, value: int) -> ClassBias:
        """What is known of a class's bias under the image's sun; none where nothing is."""
        found = next((bias for bias in self.class_biases if bias.value == value), ClassBias(value))
        if found.sun_deg is None:
            return found
        if self.sun_deg is None:
            # It points anywhere: its length is all that is known.
            spread = math.hypot(self._told(found), math.hypot(found.east, found.north) / math.sqrt(2))
            return replace(found, east=0.0, north=0.0, spread=spread)
        shadow = complex(found.east, found.north) * cmath.rect(1, math.radians(found.sun_deg - self.sun_deg))
        return replace(found, east=shadow.real, north=shadow.imag)

    def spread_of(self, bias: ClassBias, pixel_size: float) -> float:
        """Standard deviation along each axis of what remains of a bias, map units."""
        if bias.spread is None:
            own = self.class_spread * math.sqrt(1 - self.settings.common_share)
            return max(own, self.settings.class_spread_px * pixel_size)
        return max(bias.spread, 1e-3 * pixel_size)

    @property
    def common_spread(self) -> float:
        """Standard deviation along each axis of what all classes are shifted by of which nothing is known, meters."""
        return self.class_spread * math.sqrt(self.settings.common_share)

    def unstated(self, values: Sequence[int]) -> list[int]:
        """Those of class values of whose shift nothing is known."""
        return [value for value in values if self.bias_of(value).spread is None]

    def _told(self, bias: ClassBias) -> float:
        return self.class_spread if bias.spread is None else bias.spread
