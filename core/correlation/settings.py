"""Settings of map correlation, which calibration can change.

In brackets: the data that a value was set on, and the trials that set it or used it, by their names in
docs/reference/settings.md.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class CorrelationSettings:
    """Settings of map correlation (docs/explanation/method.md#map-correlation), one set for each pyramid.

    Attributes:
        scales: Footprint widths without a prior, in window sizes [what the constellation searches; footprint trials].
        rarity_exponent: Weight of a class = (variance of its fraction on the map) ** (−exponent / 2). With 0, every m²
            counts alike and forest dominates houses; with 1, a class with three patches on the map counts as much as
            all others [by hand; correlation trials, north, and fit].
        most_comparisons: Places × turns × scales of the first look; 300 km² with images of 1,280 m need 1.9e7 and less
            than a second [by hand, for the time; correlation times].
        most_at_once: Up to this number, every place is compared at ``coarse_edge``; on a larger map at ``WIDE_EDGE``
            first: from some 6,000 km² on with images of 1,280 m [by hand, for the time; large maps].
        coarse_edge: Edge of the image (root of its area) at the first look, coarse pixels: of 80 m for 1,280 m. 20
            found no more and took twice as long [by hand; footprint trials].
        quiet_energy: Share of the map's mean energy that is added to a footprint's own; without it, chance would score
            high on uniform ground [by hand; correlation trials, north, and fit].
        peaks_per_tile: Best places kept of a tile and scale [by hand, for the time; correlation trials, north, and
            fit].
        candidates: Places of the first look that are refined [by hand; footprint trials].
        decoys: Places of the mirrored image that are refined [by hand; footprint trials].
        middle_edge: Edge of the image, pixels, at the second look [by hand; footprint trials].
        middle_candidates: Places that remain for the second look [by hand; footprint trials].
        finalists: Places that remain, refined at the decision's pixels [by hand; correlation trials, north, and fit].
        photo_finalists: The same for a photo, because its edges can show which place is right [photos; outlines].
        apart: Least distance of different places, as a share of the image's edge on the ground [by hand; correlation
            trials, north, and fit].
        decision_edge: Edge of the image for comparison of places and decision, pixels; four times ``coarse_edge`` [by
            hand; correlation trials, north, and fit].
        finest_edge: Most pixels along an edge in the last refinement; limits the time on large images [by hand, for the
            time; correlation times].
        blocks: Blocks along each edge of the image with independent errors (covariance) [Liechtenstein, north; aerial;
            radius].
        confidence_curve: Logarithm of the odds that the best place is right: offset; slopes per unit of its lead over
            the stronger opponent, of the surprise of its detail, and of their product. The unit of the lead is the
            opponent's Fisher's z = artanh(correlation). A logistic curve fitted to photos of unseen
            places and to simulated labels of maps of 1 km² alike, tested on each place left out [photos; parts of
            Liechtenstein; probability on photos].
        outline_curve: Logarithm of the likelihood ratio that the outlines of a photo add: offset, and slope per unit of
            their surprise. Chosen by the calibration error of photos and mirrored photos; a logistic curve has -0.5
            and 0.6 [photos; outlines].
        usual_detail: Mean and standard deviation of the detail at wrong places, and their weight in numbers of an
            image's other places [Liechtenstein, north; areas].
        usual_outlines: The same of the agreement of outlines [mirrored photos; outlines].
        part_energy: Least energy of image and map in a part, in units of the map's mean one: no correlation can be
            computed on nearly uniform ground [fixes of 120 images of one place and 60 of two, north; parts].
        part_agreement: A part that agrees less than this times the whole image is reported: 0 of 108 fixes of images of
            one place (their parts agree at least 0.77 times as well), and 25 of 27 of two. On the southern half, which
            took no part: 0 of 107, and 19 of 30 [the same; parts].
        largest_error: Largest 95 % radius of a fix, as a share of the image's diagonal. Of poses refined from beside
            the right place it keeps 58 of 60 (modest noise) and 15 of 27 (strong) that are within 2 % of the image's
            edge, and 3 of 9 that are not. On Liechtenstein it refuses no fix [aerial; Liechtenstein, north; radius].
        error_floor_px: Least 95 % radius, overview pixels, because the most frequent class of a block is no more
            accurate [Liechtenstein, north; radius].
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
    photo_finalists: int = 24
    apart: float = 0.25
    decision_edge: int = 64
    finest_edge: int = 512
    blocks: int = 10
    confidence_curve: tuple[float, float, float, float] = (-4.6, 7.2, 1.28, 1.24)
    outline_curve: tuple[float, float] = (-1.0, 0.8)
    usual_detail: tuple[float, float, float] = (1.2, 1.4, 4.0)
    usual_outlines: tuple[float, float, float] = (2.9, 1.9, 4.0)
    part_energy: float = 0.25
    part_agreement: float = 0.5
    largest_error: float = 0.025
    error_floor_px: float = 0.15


CORRELATION = CorrelationSettings()
"""Calibrated settings: the default of every localization."""
