"""What was chosen for the constellation, and may be chosen otherwise to calibrate it.

In brackets: the data that a value was set on, and the trials that set it or used it, by their names in
docs/reference/settings.md.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SearchLimits:
    """How far the constellation searches: more takes more time.

    Attributes:
        scales: Ground that an image may show without a prior, multiples of a window's edge. The goal is 0.5 to 2 [the
            goal, with room; constellation trials, north].
        neighbors: Nearest larger objects that an object of the map makes triangles with, two at a time: 15 triangles an
            object [by hand; constellation trials, north].
        query_neighbors: The same for an image: one more, because some neighbors of an image's object are not on the map
            [by hand; constellation trials, north].
        anchors: Objects of an image that make triangles, its largest. More only take time [by hand; constellation
            trials, north].
        minimum_side_in_sizes: Longest side of a triangle over the size (√area) of its smallest object. A center is
            uncertain by a share of the size, so shorter triangles tell nothing [Liechtenstein, north; constellation
            trials, north].
        first_triangles: Triangles of the first search; all are used only if it brings no fix [by hand, for the time;
            constellation trials, north].
        maximum_hits: Triangles of the index looked at in one search after the other, rarest first. Bounds time and
            memory; the last is more than all that are like an image's at 10⁶ objects [by hand, for the time; catalogue
            sizes].
        seeds: Clusters of poses that are fitted roughly [by hand, for the time; constellation trials, north].
        rough_objects: Largest objects of the image that rough fits use [by hand, for the time; constellation trials,
            north].
        rough_share: Poses are verified while their rough score is this share of the best one's; the best one always is
            [by hand; constellation trials, north].
        verified: Poses verified at most, for the image and for its mirror; also steps tried as repeats of the map [by
            hand, for the time; constellation trials, north].
        largest_objects: Objects of an image used as evidence, largest first. More change nothing but the time [by hand,
            for the time; constellation trials, north].
        tilted_verified: Seeds from which a tilted camera is tried [by hand, for the time; tilted trials].
        landmarks_of_few_seeds: Of a map of more landmarks more ``seeds`` are tried after the second search, with the
            root of how many times more: the size of the map that the constellation was made on [by hand; catalogue
            sizes].
        side_seeds: Clusters of poses that are fitted roughly for a side, whose landmarks are few [by hand, for the
            time; probability].
        side_verified: Poses verified for a side at most [by hand, for the time; probability].
    """

    scales: tuple[float, float] = (0.4, 2.5)
    neighbors: int = 6
    query_neighbors: int = 7
    anchors: int = 70
    minimum_side_in_sizes: float = 5.0
    first_triangles: int = 400
    maximum_hits: tuple[int, ...] = (400_000, 1_500_000, 6_000_000, 40_000_000)
    seeds: int = 32
    rough_objects: int = 80
    rough_share: float = 0.25
    verified: int = 5
    largest_objects: int = 250
    tilted_verified: int = 3
    landmarks_of_few_seeds: int = 10_000
    side_seeds: int = 300
    side_verified: int = 40


@dataclass(frozen=True)
class NoiseModel:
    """Errors of landmarks that the constellation assumes.

    Attributes:
        center_noise_px: Noise of a center, one σ an axis: the part that is the same for all objects, pixels
            [Liechtenstein, north; constellation trials, north].
        center_noise_in_sizes: Noise of a center: the part that grows with the object, share of its size √area. Both are
            added in squares [Liechtenstein, north; constellation trials, north].
        gate_in_noise: A match farther off than this many σ is none. A nearer gate cuts off true matches of objects
            whose noise is larger than assumed, and residuals that were cut off make the ellipse too small
            [Liechtenstein, north; constellation trials, north].
        rough_distractors: Share of an image's objects expected to have nothing to do with the map, in rough fits and in
            what an assessment expects of a place [by hand; constellation trials, north].
        distractors: Shares of an image's objects that may have nothing to do with the map at the right place; the
            evidence is the average over them … [by hand, a grid; probability]
        visibility: … and over these shares of the map's objects in view that may be found in the image [by hand, a
            grid; probability].
        area_deviation: ln area in the image against the map: σ of a normal distribution [by hand; constellation trials,
            north].
        area_outliers: Share of objects that are merged or split, whose ln area follows a wide distribution instead [by
            hand; constellation trials, north].
        area_outlier_deviation: σ of that wide distribution [by hand; constellation trials, north].
        smaller_in_noise: An object of the image may look smaller than the smallest of the map by so many
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
    """Evidence that the constellation asks for.

    Attributes:
        tilted_noise: A tilted camera is tried from seeds unless some pose of a level one has less noise than this
            factor … [by hand; tilted trials]
        tilted_share: … and matches this share of the objects [by hand; tilted trials].
        tilted_margin: Log odds by which a tilted pose must win [by hand; tilted trials].
        tilted_slack: Log odds by which a tilted pose that holds as well as a level one may lie below it, because its
            numbers take more off, at most; and what tilt may add to the mirrored image's. Of 112 images the most were
            20.7, to 144 mirrored images it added none [by hand, for the time; constellation trials, north].
        minimum_log_odds: ln 10⁹: log odds at which nothing more is tried for the image, and that an image's landmarks
            should be able to reach, as astrometry.net asks of stars [Lang et al. 2010; constellation trials, north].
        largest_error: A fix must have a 95 % ellipse within this share of the image's diagonal. Of 218 fixes with 8–12
            objects in view the larger ones are two right ones and two that are 13 and 18 m off [Liechtenstein, north,
            few objects; constellation trials, north].
        confidence_offset: ln of the odds that a place is right whose lead in log odds is 0 [Liechtenstein, north;
            probability].
        confidence_slope: How much they grow with the lead: by chance log odds have an exponential tail, of 650 wrong
            places the highest are 10.1, 9.4 and 9.1 [Liechtenstein, north; probability].
        confidence_scale: Lead beyond which they grow slower, like its logarithm, because there are mistakes that no
            chance explains [reasoning; probability].
        rival_weight: The lead is the log odds less this many times those of the strongest opponent, another place or
            the mirrored image [Liechtenstein, north; probability].
        capped_log_odds: Log odds that a place has to have more where the search left something out, so that it need not
            look everywhere where the place is evident [reasoning; catalogue sizes].
        empty_side_share: An image is of two places only if the landmarks on one side of a cut agree at most this share
            as well as those on the other side … [Liechtenstein, north; probability]
        empty_side_log_odds: … and two shares are so much more likely, ln, than one: of the image's landmarks and of the
            map's each, and of both together. Of 408 whole images the highest with 6 of each is 15.1; 72 of 102 put
            together have more than 17 [Liechtenstein, north; probability].
        side_log_odds: Landmarks on that side are of another place with so many log odds at about the same pixel size;
            with ``minimum_log_odds`` at any pixel size [Liechtenstein, north; probability].
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
        limits: How far it searches [its table].
        noise: Errors that it assumes [its table].
        decision: Evidence that it asks for [its table].
    """

    limits: SearchLimits = SearchLimits()
    noise: NoiseModel = NoiseModel()
    decision: Decision = Decision()


CONSTELLATION = ConstellationSettings()
"""As calibrated: the default of every localization."""
