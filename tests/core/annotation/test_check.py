from collections import Counter

import cv2
import numpy as np
import pytest
import shapely
from made_annotation import KINDS, SOUTH, WEST, feature, numbered, random_features, square

from semref.core.annotation import findings as kinds
from semref.core.annotation.check import DrawnRegion, check_features, find_raster_losses
from semref.core.annotation.findings import ERROR, INFORMATION, NOTHING, WARNING
from semref.core.annotation.polygons import AnnotatedFeature
from semref.core.annotation.raster_losses import count_pieces, join_runs, lost_regions, merged_regions, runs_of_strip
from semref.core.steps import result_of

LANDMARKS = (1, 2, 3, 4)
BROKEN_LINE = [(kinds.INVALID, ERROR, 0, None), (kinds.NO_AREA, WARNING, 0, None)]
BOWTIE = shapely.from_wkt("POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))")
TWO_BOWTIES = shapely.multipolygons([BOWTIE, shapely.transform(BOWTIE, lambda xy: xy + (20, 0)), square(50, 0, 2)])
LINE = shapely.from_wkt("POLYGON ((0 0, 4 4, 0 0, 0 0))")


def check(features, minimum_area=0.0, maximum_gap=1.0) -> list:
    return result_of(check_features(features, minimum_area, maximum_gap, LANDMARKS))[0]


def found(features, **settings) -> list:
    """Return (kind, severity, feature, other) of each finding, sorted."""
    findings = check(numbered(features), **settings)
    return sorted((f.kind, f.severity, f.feature_id, f.other_id) for f in findings)


FIVE = feature(square(0, 0, 5))
HOLE, LARGE_HOLE = (feature(shapely.difference(square(0, 0, 5), square(2, 2, size))) for size in (0.9, 1.1))
MORE_VERTICES = feature(shapely.from_wkt("POLYGON ((5 5, 5 3, 5 0, 0 0, 0 5, 5 5))"))
HIDING = [feature(square(-1, -1, 6), 2, 1.0), feature(square(0, 0, 9), 3, 0.5)]
NO_GEOMETRY, INVALID = (kinds.NO_GEOMETRY, WARNING, 0, None), (kinds.INVALID, ERROR, 0, None)
DECIDED, SAME_CLASS = (kinds.OVERLAP, INFORMATION), (kinds.SAME_CLASS_NEIGHBORS, INFORMATION)
CASES = {
    "nothing": ([], []),
    "clean neighbors": ([FIVE, feature(square(5, 0, 5), 2)], []),
    "null": ([feature(None)], [NO_GEOMETRY]),
    "empty": ([feature(shapely.from_wkt("POLYGON EMPTY"))], [NO_GEOMETRY]),
    "invalid": ([feature(BOWTIE)], [INVALID]),
    "parts that share an edge": ([feature(shapely.multipolygons([square(0, 0, 5), square(5, 0, 5)]))], [INVALID]),
    "rounding": ([feature(square(0, 0, 50)), feature(shapely.box(49.9999, 0, 90, 50), 2)], []),
    "no area": ([feature(LINE)], BROKEN_LINE),
    "neither area nor class": ([feature(LINE, NOTHING)], BROKEN_LINE),
    "unreadable": ([AnnotatedFeature(0, b"no geometry", 1)], [INVALID]),
    "two broken parts": ([feature(TWO_BOWTIES)], 2 * [INVALID]),
    "overlap": ([FIVE, feature(square(3, 0, 5), 2)], [(kinds.OVERLAP, ERROR, 1, 0)]),
    "decided overlap": ([feature(square(0, 0, 5), 1, 2.0), feature(square(3, 0, 5), 2, 1.0)], [(*DECIDED, 0, 1)]),
    "same class overlap": ([FIVE, feature(square(3, 0, 6), 1)], [(*SAME_CLASS, 0, 1)]),
    "duplicate": ([FIVE, FIVE], [(kinds.DUPLICATE, WARNING, 1, 0)]),
    "duplicate of another class": ([FIVE, feature(square(0, 0, 5), 2)], [(kinds.DUPLICATE, ERROR, 1, 0)]),
    "decided duplicate": ([FIVE, feature(square(0, 0, 5), 2, 1.0)], [(kinds.DUPLICATE, WARNING, 1, 0)]),
    "duplicate with more vertices": ([FIVE, MORE_VERTICES], [(kinds.DUPLICATE, WARNING, 1, 0)]),
    "corner": ([FIVE, feature(square(5, 5, 4))], [(*SAME_CLASS, 1, 0)]),
    "corner of no landmarks": ([feature(square(0, 0, 5), 9), feature(square(5, 5, 4), 9)], []),
    "no landmarks": ([feature(square(0, 0, 5), 9), feature(square(5, 0, 4), 9)], [(*SAME_CLASS, 1, 0)]),
    "corner of one feature": ([feature(shapely.union_all([square(0, 0, 5), square(5, 5, 4)]))], []),
    "hidden": (
        [feature(square(1, 1, 2)), feature(square(0, 0, 5), 2, 1.0)],
        [(kinds.HIDDEN, WARNING, 0, 1), (*DECIDED, 1, 0)],
    ),
    "hidden by several": (
        [feature(square(0, 0, 6)), *HIDING],
        [(kinds.HIDDEN, WARNING, 0, 1), *((*DECIDED, *pair) for pair in ((1, 0), (1, 2), (2, 0)))],
    ),
    "gap": ([HOLE], [(kinds.GAP, WARNING, None, None)]),
    "large hole": ([LARGE_HOLE], []),
    "sliver": (
        [feature(shapely.box(0, 0, 50, 20)), feature(shapely.box(0, 20, 50, 20.1), 2)],
        [(kinds.SLIVER, WARNING, 1, None)],
    ),
}


@pytest.mark.parametrize(("features", "expected"), CASES.values(), ids=CASES)
def test_each_kind_is_found_with_its_severity_and_ids(features, expected):
    assert found(features) == expected


def test_a_crossing_is_reported_with_its_place_and_reason():
    (finding,) = check(numbered([feature(square(9, 9, 1)), feature(BOWTIE, 3)]))
    assert (finding.feature_id, finding.class_value) == (1, 3)
    assert finding.reason == f"Self-intersection ({WEST + 2:.2f}, {SOUTH + 2:.2f})"
    assert shapely.from_wkb(finding.wkb).centroid.coords[0] == pytest.approx((WEST + 2, SOUTH + 2), abs=1e-6)


def test_neighbors_of_one_class_are_listed_smaller_first_with_their_border():
    features = [feature(square(0, 0, 5)), feature(square(5, 1, 3)), feature(square(0, 5, 5), 2)]
    (finding,) = check(numbered(features))
    assert (finding.feature_id, finding.other_id, finding.is_landmark) == (1, 0, True)
    assert finding.number == pytest.approx(3)


def test_small_landmarks_are_reported_as_drawn():
    features = [feature(square(x, 0, 3)) for x in (0, 3, 20)] + [feature(square(40, 0, 3), class_value=9)]
    small = [f for f in check(numbered(features), minimum_area=10) if f.kind == kinds.SMALL]
    assert [(f.feature_id, f.area) for f in small] == [(2, pytest.approx(9))]


def test_invalid_coordinates_are_reported_and_left_out():
    with np.errstate(invalid="ignore"):
        broken = shapely.to_wkb(shapely.polygons([[0, 0], [np.nan, 5], [5, 5]]))
    findings = check([AnnotatedFeature(7, broken, 1), feature(square(0, 0, 5))])
    assert [(f.kind, f.feature_id) for f in findings] == [(kinds.INVALID, 7)]


@pytest.mark.slow
@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind not in ("stacked", "shaken")])
@pytest.mark.parametrize("seed", range(3))
def test_overlaps_have_the_area_of_a_plain_pairwise_intersection(kind, seed):
    features = random_features(kind, seed, 30)
    shapes = shapely.make_valid(shapely.from_wkb([f.wkb for f in features]))
    expected = {}
    for one in range(len(shapes)):
        for other in range(one):
            area = shapes[one].intersection(shapes[other]).area
            if features[one].class_value != features[other].class_value and area > 0.01:
                expected[one, other] = area
    repeated = {f.feature_id for f in check(features) if f.kind == kinds.DUPLICATE}
    areas = Counter()
    for finding in check(features):
        if finding.kind == kinds.OVERLAP:
            areas[tuple(sorted((finding.feature_id, finding.other_id), reverse=True))] += finding.area
    expected = {pair: area for pair, area in expected.items() if not repeated & set(pair)}
    assert {pair: area for pair, area in areas.items() if area > 0.01} == pytest.approx(expected, abs=1e-3)


def landmark(wkt_number: int, area: float, class_value: int = 1) -> DrawnRegion:
    return DrawnRegion(b"", (0, 0, 1, 1), class_value, wkt_number, area)


def test_losses_of_landmarks_by_pixels_are_reported():
    regions = np.zeros((9, 20), int)
    regions[1:7, 1:7] = 1
    regions[1:7, 7:12] = 2
    regions[0, 15:19] = 3
    regions[3:8, 14] = 4
    regions[3:8, 16:20] = 4
    landmarks = [landmark(10, 36), landmark(11, 30), landmark(12, 20), landmark(13, 25)]
    told = find_raster_losses(landmarks, runs_of_strip(regions, 0), 10.0, 1.0)
    found = [(f.kind, f.feature_id, f.other_id, f.number) for f in told]
    assert found == [(kinds.LOST, 12, None, 0), (kinds.MERGED, 11, 10, 0), (kinds.SPLIT, 13, None, 2)]


def random_regions(seed: int):
    """Return (40, 60) region numbers 0 to 12 in blobs, and the class of each number."""
    random = np.random.default_rng(seed)
    noise = cv2.GaussianBlur(random.normal(size=(40, 60, 13)), (0, 0), 2.0)
    return noise.argmax(axis=2), np.array([-1, *random.integers(1, 3, 12)])


def runs_in_strips(regions_hw, rows=7):
    firsts = range(0, len(regions_hw), rows)
    return join_runs([runs_of_strip(regions_hw[first : first + rows], first) for first in firsts])


@pytest.mark.parametrize("seed", range(4))
def test_pieces_losses_and_merges_are_those_of_opencv(seed):
    regions, classes = random_regions(seed)
    runs = runs_in_strips(regions)
    pieces, lost = count_pieces(runs, 13), lost_regions(runs, 13, 30.0)
    for number in range(1, 13):
        mask = (regions == number).astype(np.uint8)
        assert pieces[number] == cv2.connectedComponents(mask, connectivity=8)[0] - 1
        contours = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0]
        assert lost[number] == (max(map(cv2.contourArea, contours), default=0) < 30)
    expected = set()
    for one in range(1, 13):
        around = cv2.dilate((regions == one).astype(np.uint8), np.ones((3, 3), np.uint8))
        for other in np.unique(regions[around > 0]):
            if other > one and classes[one] == classes[other]:
                expected.add((one, int(other)))
    assert {tuple(pair) for pair in merged_regions(runs, classes).tolist()} == expected
