"""What was chosen for map correlation, and may be chosen otherwise to calibrate it.

In brackets: the data that a value was set on, and the trials that set it or used it, by their names in
docs/reference/settings.md.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class CorrelationSettings:
    """Settings of map correlation (docs/explanation/method.md#map-correlation); a pyramid is made for one of these.

    Attributes:
        scales: Ground that an image may show without a prior, multiples of a window's edge [what the constellation
            searches; footprint trials].
        rarity_exponent: Weight of a class = (variance of its fraction on the map) ** (−exponent / 2): 0 treats every m²
            alike and lets forest drown the houses, 1 gives a class of which the map has three patches the same say as
            all others [by hand; correlation trials, north, and fit].
        most_comparisons: Places × turns × scales of the first look; 300 km² with images of 1,280 m take 1.9e7 and less
            than a second [by hand, for the time; correlation times].
        most_at_once: Up to so many every place is compared at ``coarse_edge``; of a larger map at ``WIDE_EDGE`` first:
            from some 6,000 km² on with images of 1,280 m [by hand, for the time; large maps].
        coarse_edge: Edge of the image (root of its area) at the first look, coarse pixels: of 80 m for 1,280 m. 20
            found no more and took twice as long [by hand; footprint trials].
        quiet_energy: Share of the map's mean energy that is added to a footprint's own: where nothing varies, chance
            would score high [by hand; correlation trials, north, and fit].
        peaks_per_tile: Best places of a tile and scale that are kept [by hand, for the time; correlation trials, north,
            and fit].
        candidates: Places of the first look that are refined [by hand; footprint trials].
        decoys: The same of the mirrored image [by hand; footprint trials].
        middle_edge: Edge of the image, pixels, at the second look [by hand; footprint trials].
        middle_candidates: Places that remain for the second look [by hand; footprint trials].
        finalists: Places that remain, refined at the decision's pixels [by hand; correlation trials, north, and fit].
        apart: Poses are different places from this share of the image's edge on the ground on [by hand; correlation
            trials, north, and fit].
        decision_edge: Edge of the image at which places are compared and decided about, pixels; four times
            ``coarse_edge`` [by hand; correlation trials, north, and fit].
        finest_edge: The last refinement uses no more pixels than this along an edge: bounds the time on large images
            [by hand, for the time; correlation times].
        blocks: Blocks along each edge of the image that are taken to err independently (covariance) [Liechtenstein,
            north; aerial; radius].
        confidence_curve: ln of the odds that the best place is right: offset, slope a unit of its lead over the
            stronger opponent, which is that one's own Fisher's z = artanh(correlation), slope a unit of the surprise of
            its detail. Of the curves whose calibration error is at most 0.0185 at each of three places, one of those
            with the fewest wrong places at a told risk below 1 in 100; a logistic curve fitted to the three alike has
            −4.8, 6.2, 0.64 [three places, north; areas].
        usual_detail: Mean and standard deviation of the detail at wrong places, and how many of an image's other places
            that counts as [Liechtenstein, north; areas].
        part_energy: Least energy of image and of map in a part, in units of the map's mean one: where hardly anything
            varies, no correlation can be computed [fixes of 120 images of one place and 60 of two, north; parts].
        part_agreement: A part that agrees less than this many times as well as the whole image is reported: none of 108
            fixes of images of one place, whose parts agree 0.77 times as well at least, and 25 of 27 of two. On the
            southern half, which took no part: none of 107, and 19 of 30 [the same; parts].
        error_factor: 95 % radius in units of the larger axis' standard deviation, as the refinement gives it, times the
            noise-to-signal ratio that follows from a correlation s, 1/s² − 1: the worse the labels, the farther their
            errors reach, and the less they are independent. 95 % of the errors are below 2.9 of these units with modest
            noise, below 4.1 with strong; photos of a town, poorly segmented: 2.1, of a shore whose annotation and
            network disagree about where it runs: 6.0 [aerial; photos; radius].
        least_noise: Least such ratio [aerial; radius].
        largest_error: A fix must have a 95 % radius within this share of the image's diagonal. Of poses refined from
            beside the right place it keeps 58 of 60 (modest noise) and 15 of 27 (strong) that are within 2 % of the
            image's edge, and 3 of 9 that are not; on Liechtenstein it refuses none [aerial; Liechtenstein, north;
            radius].
        error_floor_px: Least 95 % radius, overview pixels: the most frequent class of a block says no more
            [Liechtenstein, north; radius].
    """

    scales: tuple[float, float] = (0.4, 2.5)
    rarity_exponent: float = 0.5
    most_comparisons: float = 4e9
    most_at_once: float = 4e8
    coarse_edge: int = 16
    quiet_energy: float = 0.15
    peaks_per_tile: int = 60
    candidates: int = 256
    decoys: int = 96
    middle_edge: int = 32
    middle_candidates: int = 48
    finalists: int = 8
    apart: float = 0.25
    decision_edge: int = 64
    finest_edge: int = 512
    blocks: int = 10
    confidence_curve: tuple[float, float, float] = (-4.6, 5.5, 0.7)
    usual_detail: tuple[float, float, float] = (1.2, 1.4, 4.0)
    part_energy: float = 0.25
    part_agreement: float = 0.5
    error_factor: float = 4.0
    least_noise: float = 0.4
    largest_error: float = 0.025
    error_floor_px: float = 0.15


CORRELATION = CorrelationSettings()
"""As calibrated: the default of every localization."""
