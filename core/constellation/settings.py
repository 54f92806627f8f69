"""What was chosen for the constellation: thresholds, counts, tolerances.

In brackets: what a value was set on; the trials that set it or ran with it, by the name under which docs/calibration.md
has their command.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ConstellationSettings:
    """Settings of the constellation (docs/method.md#constellation); an index is built for one of these.

    Attributes:
        scales: Ground that an image may show without a prior, multiples of a window's edge. The goal is 0.5 to 2 [the
            goal, with room; constellation trials, north].
        smallest_object_px: Contour area, px², below which an object of an image has neither a shape nor a center to
            speak of [reasoning].
        minimum_objects: Whole objects of known class below which nothing is searched: three make a hypothesis, one more
            tests it [reasoning].
        neighbors: Nearest larger objects that an object of the map makes triangles with, two at a time: 15 triangles an
            object [by hand; constellation trials, north].
        query_neighbors: The same for an image: one more, because some neighbors of an image's object are not on the map
            [by hand; constellation trials, north].
        anchors: Objects of an image that make triangles, its largest. More only take time [by hand; constellation
            trials, north].
        candidates_per_neighbor: Neighbors looked at for each larger one wanted; half of them are larger by
            construction, locally more or fewer [reasoning].
        minimum_side_in_sizes: Longest side of a triangle over the size (√area) of its smallest object. A center is
            uncertain by a share of the size, so shorter triangles tell nothing [Liechtenstein, north; constellation
            trials, north].
        density_neighbors: Neighbors of the same class whose distance tells the local density [reasoning].
        center_noise_px: Noise of a center, one σ an axis: the part that is the same for all objects, pixels
            [Liechtenstein, north; constellation trials, north].
        center_noise_in_sizes: Noise of a center: the part that grows with the object, share of its size √area. Both are
            added in squares [Liechtenstein, north; constellation trials, north].
        place_tolerance_in_noise: Tolerance of C in the frame of AB: this many times the noise, 2.5 σ of a difference of
            three noisy centers, over |AB| [reasoning].
        place_tolerance_minimum: Least such tolerance, share of |AB|: below it the 8-bit numbers of the index end
            [format of the index].
        place_tolerance_maximum: Triangles that need more tolerance, share of |AB|, tell too little and are left out [by
            hand; constellation trials, north].
        area_tolerance: Tolerance of ln(area / |AB|²): edges off by a pixel or two [reasoning].
        first_triangles: Triangles of the first search; all are used only if it brings no fix [by hand, for the time;
            constellation trials, north].
        maximum_hits: Triangles of the index looked at in one search after the other, rarest first. Bounds time and
            memory; the last is more than all that are like an image's at 10⁶ objects [by hand, for the time; catalogue
            sizes].
        cell_of_image: Cells in which poses are gathered: share of the image's diagonal on the ground [by hand;
            constellation trials, north].
        cell_of_turn: The same for heading, radians, and ln pixel size [by hand; constellation trials, north].
        seeds: Clusters of poses that are fitted roughly [by hand, for the time; constellation trials, north].
        rough_objects: Largest objects of the image that rough fits use [by hand, for the time; constellation trials,
            north].
        rough_gates: How far a match may be off in the rough fits, one after the other, share of the image's diagonal
            [by hand; constellation trials, north].
        rough_share: Poses are verified while their rough score is this share of the best one's; the best one always is
            [by hand; constellation trials, north].
        verified: Poses verified at most, for the image and for its mirror; also steps tried as repeats of the map [by
            hand, for the time; constellation trials, north].
        few_objects: Up to so many objects a pose is verified from its seed as well as from its rough fit, which may
            have settled on wrong matches [by hand; constellation trials, north].
        gate_in_noise: A match farther off than this many σ is none. A nearer gate cuts off true matches of objects
            whose noise is larger than assumed, and residuals that were cut off make the ellipse too small
            [Liechtenstein, north; constellation trials, north].
        noise_factors: How much less and more noise than assumed an image may have; measured from its own residuals
            [reasoning].
        assumed_matches: So many matches with just the assumed noise count with those it is measured from: as many
            numbers as a pose has twice over, so that a handful of residuals can't make the noise vanish [by hand;
            constellation trials, north].
        minimum_matches: Matches without which a pose is not fitted again [reasoning].
        refinements: Rounds of match and fit for one pose [by hand; constellation trials, north].
        robust_refinements: The first of them, which trust near matches more, to leave wrong ones; the others weigh by
            Huber's rule, whose uncertainty ``level_covariance`` knows [by hand; constellation trials, north].
        largest_objects: Objects of an image used as evidence, largest first. More change nothing but the time [by hand,
            for the time; constellation trials, north].
        growing_gate: For tilted cameras: how far off a match may be, besides its noise, share of the image's diagonal
            [by hand; tilted trials].
        growing_reach: For tilted cameras: how far from where the pose holds matches are taken, round by round, share of
            the diagonal [by hand; tilted trials].
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
        assumed_objects: Objects that make a hypothesis can't be evidence for it. Any three of those matched may have
            made it, so so many times their mean is taken off [reasoning].
        assumed_objects_tilted: The same for a tilted camera, whose pose has four numbers more, as many as two objects
            bring [reasoning].
        tilted_noise: A tilted camera is tried from seeds unless some pose of a level one has less noise than this
            factor … [by hand; tilted trials]
        tilted_share: … and matches this share of the objects [by hand; tilted trials].
        tilted_verified: Seeds from which it is tried [by hand, for the time; tilted trials].
        tilted_margin: Log odds by which a tilted pose must win [by hand; tilted trials].
        tilted_slack: Log odds by which a tilted pose that holds as well as a level one may lie below it, because its
            numbers take more off, at most; and what tilt may add to the mirrored image's. Of 112 images the most were
            20.7, to 144 mirrored images it added none [by hand, for the time; constellation trials, north].
        same_tilted_place: A level and a tilted pose whose objects lie nearer than this share of the diagonal are the
            same place [by hand; tilted trials].
        minimum_log_odds: ln 10⁹: log odds at which nothing more is tried for the image, and that an image's landmarks
            should be able to reach, as astrometry.net asks of stars [Lang et al. 2010; constellation trials, north].
        same_place_in_noise: Poses whose objects lie nearer to each other than this many σ are the same place
            [reasoning].
        repeated: A step is tried as a repeat of the map when it leads this share of the objects to another of their
            class … [by hand; constellation trials, north]
        repeat_reach: … and is at most this share of their extent long [by hand; constellation trials, north].
        copy_reach: So far around a place that would be a fix other ground is sought that looks the same, diagonals of
            the image: two estates built by one plan lie beside each other [reasoning; real tiles].
        copy_area_in_noise: Objects of such ground have the areas of each other within so many ``area_deviation``
            [reasoning; real tiles].
        largest_error: A fix must have a 95 % ellipse within this share of the image's diagonal. Of 218 fixes with 8–12
            objects in view the larger ones are two right ones and two that are 13 and 18 m off [Liechtenstein, north,
            few objects; constellation trials, north].
        landmarks_of_few_seeds: Of a map of more landmarks more ``seeds`` are tried after the second search, with the
            root of how many times more: the size of the map that the constellation was made on [by hand; catalogue
            sizes].
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
        empty_side_landmarks: Landmarks without which one side of an image tells nothing about whether it shows the same
            place [reasoning; probability].
        empty_side_share: On that side this share of the other's, at most, agrees [Liechtenstein, north; probability].
        empty_side_log_odds: How much more likely, ln, two shares have to be than one: of the image's landmarks and of
            the map's each, and of both together. Of 408 whole images the highest with 6 of each is 15.1; 72 of 102 put
            together have more than 17 [Liechtenstein, north; probability].
        uneven_log_odds: The same of the image's landmarks alone, from which on those of that side that don't agree are
            sought elsewhere, and a fix tells of it [reasoning; probability].
        side_log_odds: With so many log odds, at about the same pixel size, those are of another place; with
            ``minimum_log_odds`` at any pixel size [Liechtenstein, north; probability].
        side_pixel_sizes: About the same pixel size: up to this ratio [reasoning].
        side_seeds: Clusters of poses that are fitted roughly for a side, whose landmarks are few [by hand, for the
            time; probability].
        side_verified: Poses verified for a side at most [by hand, for the time; probability].
    """

    scales: tuple[float, float] = (0.4, 2.5)
    smallest_object_px: float = 9.0
    minimum_objects: int = 4
    neighbors: int = 6
    query_neighbors: int = 7
    anchors: int = 70
    candidates_per_neighbor: int = 5
    minimum_side_in_sizes: float = 5.0
    density_neighbors: int = 6
    center_noise_px: float = 0.7
    center_noise_in_sizes: float = 0.1
    place_tolerance_in_noise: float = 3.5
    place_tolerance_minimum: float = 0.012
    place_tolerance_maximum: float = 0.06
    area_tolerance: float = 0.4
    first_triangles: int = 400
    maximum_hits: tuple[int, ...] = (400_000, 1_500_000, 6_000_000, 40_000_000)
    cell_of_image: float = 0.04
    cell_of_turn: float = 0.1
    seeds: int = 32
    rough_objects: int = 80
    rough_gates: tuple[float, float] = (0.012, 0.006)
    rough_share: float = 0.25
    verified: int = 5
    few_objects: int = 40
    gate_in_noise: float = 4.5
    noise_factors: tuple[float, float] = (0.5, 3.0)
    assumed_matches: int = 4
    minimum_matches: int = 4
    refinements: int = 6
    robust_refinements: int = 4
    largest_objects: int = 250
    growing_gate: float = 0.006
    growing_reach: tuple[float, ...] = (0.15, 0.2, 0.3, 0.4, 0.55, 0.75, 1.0, 1.0)
    rough_distractors: float = 0.4
    distractors: tuple[float, ...] = (0.2, 0.4, 0.6, 0.8, 0.9)
    visibility: tuple[float, ...] = (0.2, 0.5, 0.8)
    area_deviation: float = 0.2
    area_outliers: float = 0.15
    area_outlier_deviation: float = 1.0
    smaller_in_noise: float = 2.0
    assumed_objects: int = 3
    assumed_objects_tilted: int = 5
    tilted_noise: float = 1.6
    tilted_share: float = 0.6
    tilted_verified: int = 3
    tilted_margin: float = 6.0
    tilted_slack: float = 25.0
    same_tilted_place: float = 0.04
    minimum_log_odds: float = 20.7
    same_place_in_noise: float = 5.0
    repeated: float = 0.15
    repeat_reach: float = 0.5
    copy_reach: float = 1.0
    copy_area_in_noise: float = 3.0
    largest_error: float = 0.01
    landmarks_of_few_seeds: int = 10_000
    confidence_offset: float = -3.3
    confidence_slope: float = 0.76
    confidence_scale: float = 60.0
    rival_weight: float = 1.0
    capped_log_odds: float = 10.0
    empty_side_landmarks: int = 5
    empty_side_share: float = 0.45
    empty_side_log_odds: tuple[float, float] = (6.0, 17.0)
    uneven_log_odds: float = 8.0
    side_log_odds: float = 10.0
    side_pixel_sizes: float = 1.11
    side_seeds: int = 300
    side_verified: int = 40


CONSTELLATION = ConstellationSettings()
"""As calibrated; what every localization uses that is told nothing else."""
