"""Settings of the constellation, which calibration can vary.

In brackets: the data that a value was set on, and the trials that set it or used it, by their names in
docs/reference/settings.md.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SearchLimits:
    """Extent of the constellation's search: larger values take more time.

    Attributes:
        scales: Range of ground size that an image may show without a prior, multiples of a window's edge. The goal is
            0.5 to 2 [the goal, with room; constellation trials, north].
        neighbors: Nearest larger landmarks that a landmark of the map forms triangles with, two at a time: 15 triangles
            a landmark [by hand; constellation trials, north].
        query_neighbors: The same for an image: one more, because some neighbors of an image's landmark are not on the
            map [by hand; constellation trials, north].
        anchors: Landmarks of an image that form triangles in the first two searches, its largest, and in the later
            ones. If 40 % of the landmarks are missed and 40 % spurious, the largest have no triangle of the map in 12 %
            of images; with 250, in 1 % [Liechtenstein, south; constellation trials, north].
        minimum_side_in_sizes: Longest side of a triangle over the size (√area) of its smallest landmark. The
            uncertainty of a center is a share of the size, so shorter triangles are useless [Liechtenstein, north;
            constellation trials, north].
        first_triangles: Triangles of the first search; all are used only if it brings no fix [by hand, for the time;
            constellation trials, north].
        maximum_hits: Largest number of index triangles examined in the successive searches, rarest first. Limits time
            and memory; the last exceeds the number of similar triangles at 10⁶ landmarks [by hand, for the time;
            catalogue sizes].
        seeds: Clusters of poses that are roughly fitted in the first two searches [by hand, for the time; constellation
            trials, north].
        thorough_seeds: The same in the later searches, and for a side, which has few landmarks [by hand, for the time;
            probability].
        rough_objects: Largest landmarks of the image that rough fits use [by hand, for the time; constellation trials,
            north].
        rough_share: Poses are verified if their rough score is at least this share of the best one's [by hand;
            constellation trials, north].
        verified: Largest number of poses verified, for the image and for its mirror; also of steps tested as repeats of
            the map [by hand, for the time; constellation trials, north].
        largest_objects: Landmarks of an image used as evidence, largest first. More change only the time [by hand, for
            the time; constellation trials, north].
        tilted_verified: Seeds from which a tilted camera is tested [by hand, for the time; tilted trials].
        landmarks_of_few_seeds: Map size that the constellation was designed for. For a map of more landmarks, the seeds
            of the later searches are at least ``seeds`` times the square root of the ratio [by hand; catalogue sizes].
        side_verified: Largest number of poses verified for a side [by hand, for the time; probability].
    """

    scales: tuple[float, float] = (0.4, 2.5)
    neighbors: int = 6
    query_neighbors: int = 7
    anchors: tuple[int, int] = (70, 250)
    minimum_side_in_sizes: float = 5.0
    first_triangles: int = 400
    maximum_hits: tuple[int, ...] = (400_000, 1_500_000, 6_000_000, 40_000_000)
    seeds: int = 32
    thorough_seeds: int = 300
    rough_objects: int = 80
    rough_share: float = 0.25
    verified: int = 5
    largest_objects: int = 250
    tilted_verified: int = 3
    landmarks_of_few_seeds: int = 10_000
    side_verified: int = 40


@dataclass(frozen=True)
class NoiseModel:
    """Errors of landmarks that the constellation assumes.

    Attributes:
        center_noise_px: Noise of a center, one σ an axis: the part that is equal for all landmarks, pixels
            [Liechtenstein, north; constellation trials, north].
        center_noise_in_sizes: Noise of a center: the part that grows with the landmark, share of its size √area. Both
            are added in squares [Liechtenstein, north; constellation trials, north].
        gate_in_noise: Largest residual of a match in σ. A smaller gate cuts off true matches of landmarks with more
            noise than assumed, and cut residuals make the ellipse too small [Liechtenstein, north; constellation
            trials, north].
        rough_distractors: Share of an image's landmarks without relation to the map, in rough fits and in the
            expectations of an assessment [by hand; constellation trials, north].
        distractors: Possible shares of an image's landmarks without relation to the map at the right place. The
            evidence is the average over them [by hand, a grid; probability].
        visibility: Possible shares of the map's landmarks in view that are found in the image. The evidence is the
            average over them, too [by hand, a grid; probability].
        area_deviation: Difference of ln area between image and map: σ of a normal distribution [by hand; constellation
            trials, north].
        area_outliers: Share of merged or split landmarks, with ln area in a wide distribution instead [by hand;
            constellation trials, north].
        area_outlier_deviation: σ of that wide distribution [by hand; constellation trials, north].
        smaller_in_noise: How much smaller than the smallest landmark of the map one of the image may look, in
            ``area_deviation``; smaller ones are no evidence [images from elsewhere; images from elsewhere].
    """

    center_noise_px: float = 0.7
    center_noise_in_sizes: float = 0.1
    gate_in_noise: float = 4.5
    rough_distractors: float = 0.4
    distractors: tuple[float, ...] = (0.2, 0.4, 0.6, 0.8, 0.9)
    visibility: tuple[float, ...] = (0.2, 0.5, 0.8)
    area_deviation: float = 0.2
    area_outliers: float = 0.15
    area_outlier_deviation: float = 1.0
    smaller_in_noise: float = 2.0


@dataclass(frozen=True)
class Decision:
    """Evidence that the constellation requires.

    Attributes:
        tilted_noise: Largest noise factor of a level pose that makes tests of a tilted camera from seeds unnecessary
            [by hand; tilted trials].
        tilted_share: Smallest share of matched landmarks of such a pose [by hand; tilted trials].
        tilted_margin: Log odds by which a tilted pose must win [by hand; tilted trials].
        tilted_slack: Log odds by which a tilted pose may be below an equally good level one, at most, because more
            numbers are fitted; and the most that tilt may add to the mirrored image's. Of 112 images the most were
            20.7; 144 mirrored images gained nothing [by hand, for the time; constellation trials, north].
        minimum_log_odds: Log odds, ln 10⁹, that end the search of an image, and that an image's landmarks should be
            able to reach, as astrometry.net requires of stars [Lang et al. 2010; constellation trials, north].
        largest_error: Largest 95 % ellipse of a fix, share of the image's diagonal. Of 218 fixes with 8–12 landmarks in
            view the larger ones are two right ones, and two with errors of 13 and 18 m [Liechtenstein, north, few
            objects; constellation trials, north].
        confidence_offset: Log of the odds that a candidate with a lead in log odds of 0 is right [Liechtenstein, north;
            probability].
        confidence_slope: Growth of these odds with the lead: by chance log odds have an exponential tail; of 650 wrong
            candidates the highest are 10.1, 9.4 and 9.1 [Liechtenstein, north; probability].
        confidence_scale: Lead beyond which they grow only like its logarithm, because some errors are not due to chance
            [reasoning; probability].
        rival_weight: The lead is the log odds minus this factor times those of the strongest alternative, another
            candidate or the mirrored image [Liechtenstein, north; probability].
        capped_log_odds: Additional log odds that a candidate needs if the search omitted something, so that an evident
            candidate does not require a complete search [reasoning; catalogue sizes].
        empty_side_share: An image shows two places only if landmarks on one side of a cut agree at most this share as
            often as on the other side [Liechtenstein, north; probability].
        empty_side_log_odds: Log odds, in addition, that two shares are more likely than one. They are for landmarks of
            the image and of the map each, and for both together. Of 408 whole images the highest with 6 for each is
            15.1; 72 of 102 composed ones have more than 17 [Liechtenstein, north; probability].
        side_log_odds: Log odds that show that landmarks on that side are of another place at about the same pixel size;
            at any pixel size ``minimum_log_odds`` are required [Liechtenstein, north; probability].
    """

    tilted_noise: float = 1.6
    tilted_share: float = 0.6
    tilted_margin: float = 6.0
    tilted_slack: float = 25.0
    minimum_log_odds: float = 20.7
    largest_error: float = 0.01
    confidence_offset: float = -3.3
    confidence_slope: float = 0.76
    confidence_scale: float = 60.0
    rival_weight: float = 1.0
    capped_log_odds: float = 10.0
    empty_side_share: float = 0.45
    empty_side_log_odds: tuple[float, float] = (6.0, 17.0)
    side_log_odds: float = 10.0


@dataclass(frozen=True)
class ConstellationSettings:
    """Settings of the constellation (docs/explanation/method.md#constellation); an index stores those of its build.

    Attributes:
        limits: Extent of the search [its table].
        noise: Assumed errors [its table].
        decision: Required evidence [its table].
    """

    limits: SearchLimits = SearchLimits()
    noise: NoiseModel = NoiseModel()
    decision: Decision = Decision()


CONSTELLATION = ConstellationSettings()
"""Calibrated settings: the default of every localization."""
