"""What is taken to be known of errors that landmarks share: of the map, of the network, of the camera.

In brackets: what a value was set on; the trials that set it or ran with it, by the name under which docs/calibration.md
has their command.
"""

from __future__ import annotations

from dataclasses import dataclass, field

MAP_ACCURACY = 1.1
"""Standard deviation along each axis of landmarks between two maps of one ground, meters, where nobody states another:
1.6 m root mean square between maps of Liechtenstein of two dates, by other mappers."""


@dataclass(frozen=True)
class ErrorSettings:
    """Settings of the covariance of a pose (docs/method.md#how-exactly).

    Attributes:
        map_kernels: How neighbors share a map's displacement, (length in meters, share of the variance); the rest is
            each landmark's own [maps of two dates; covariance].
        map_factors: Displacements that are tried, multiples of the map's stated accuracy [reasoning].
        own_factors: Noises of single landmarks that are tried, multiples of what the median residual tells
            [reasoning].
        own_spread: Standard deviation of their logarithm, before residuals are seen [by hand; covariance].
        views: Cameras that are tried, (standard deviation of the lens' radial distortion in the corners, of the tilt in
            units of what a tilt of 10° does, share of cameras): none of both, little, much [by hand; covariance].
        class_spread_px: Standard deviation of the shift that a class has as a whole, beyond what is stated, pixels of
            the image [by hand; covariance].
        leaning: Standard deviation of ln pixel size for roofs that lean away from the image's center: they look larger,
            and no residual tells [geometry of houses of 5 m seen from 1,000 m].
        most_landmarks: Landmarks that a pose is fitted to; of more so many, evenly chosen [by hand].
    """

    map_kernels: tuple[tuple[float, float], ...] = ((60.0, 0.28), (2000.0, 0.25))
    map_factors: tuple[float, ...] = (0.03, 0.1, 0.2, 0.4, 0.7, 1.0, 1.5, 2.5)
    own_factors: tuple[float, ...] = (0.35, 0.5, 0.7, 1.0, 1.4, 2.0)
    own_spread: float = 1.0
    views: tuple[tuple[float, float, float], ...] = ((0.0001, 0.0001, 0.7), (0.01, 0.1, 0.15), (0.02, 1.0, 0.15))
    class_spread_px: float = 0.1
    leaning: float = 0.005
    most_landmarks: int = 200


ERRORS = ErrorSettings()
"""As calibrated; what every localization uses that is told nothing else."""


@dataclass(frozen=True)
class ClassBias:
    """How far from where it is a network, or a map, shows a class, meters on the ground.

    Attributes:
        value: Of the class.
        east: Along the map's axes, as shadows make it.
        north: The same.
        right: Along the image's axes, as a network's own habits make it.
        down: The same.
        spread: Standard deviation along each axis of what an image's bias differs from it; None for the default's.
    """

    value: int
    east: float = 0.0
    north: float = 0.0
    right: float = 0.0
    down: float = 0.0
    spread: float | None = None

    def in_image(self, turn: complex) -> complex:
        """The bias in the image's frame, map units: right and up.

        Args:
            turn: Of the image's pose.
        """
        return complex(self.east, self.north) * turn.conjugate() / abs(turn) + complex(self.right, -self.down)


@dataclass(frozen=True)
class SharedErrors:
    """What is known beforehand of a map and of labels.

    Attributes:
        map_accuracy: Standard deviation along each axis of the map's landmarks, map units.
        map_pixel_size: Of the label map, map units; 0 for a map that has none.
        class_biases: Those that are known.
        settings: All else.
    """

    map_accuracy: float = MAP_ACCURACY
    map_pixel_size: float = 0.0
    class_biases: tuple[ClassBias, ...] = ()
    settings: ErrorSettings = field(default=ERRORS)

    def bias_of(self, value: int) -> ClassBias:
        """What is known of a class's bias; none where nothing is."""
        return next((bias for bias in self.class_biases if bias.value == value), ClassBias(value))

    def spread_of(self, bias: ClassBias, pixel_size: float) -> float:
        """Standard deviation along each axis of what remains of a bias, map units."""
        return (
            self.settings.class_spread_px * pixel_size if bias.spread is None else max(bias.spread, 1e-3 * pixel_size)
        )
