import numpy as np
import pytest

from semref.core.errors import LabelMapError
from semref.core.labels.class_table import class_table_from_csv
from semref.core.labels.comparison import (
    LabelComparison,
    count_pairs,
    decode_disagreement,
    disagreement_codes,
    match_classes,
)

ANNOTATED = np.array([[0, 1, 1, 1], [2, 2, 2, 0]], np.uint8)
PREDICTED = np.array([[1, 1, 2, 0], [2, 2, 3, 3]], np.uint8)


def compare(annotated, predicted):
    return LabelComparison(count_pairs(np.array(annotated, np.uint8), np.array(predicted, np.uint8)))


def test_pairs_are_counted_exactly_also_of_more_pixels_than_single_precision_holds():
    random = np.random.default_rng(1)
    first, second = random.integers(0, 256, (2, 300, 400)).astype(np.uint8)
    wanted = np.zeros((256, 256), int)
    np.add.at(wanted, (first.ravel(), second.ravel()), 1)
    np.testing.assert_array_equal(count_pairs(first, second), wanted)
    labels = np.ones((4100, 4100), np.uint8)
    labels[0, 0] = 2
    counts = count_pairs(labels, labels)
    assert (counts[1, 1], counts[2, 2]) == (4100 * 4100 - 1, 1)


def test_figures_equal_those_done_by_hand():
    found = compare(ANNOTATED, PREDICTED)
    assert found.pixels == 6
    assert found.overall_accuracy == pytest.approx(3 / 6)
    assert found.values == (0, 1, 2, 3)
    assert [found.iou(v) for v in (1, 2, 3)] == pytest.approx([1 / 3, 2 / 4, 0])
    assert found.mean_iou == pytest.approx((1 / 3 + 2 / 4) / 2)
    assert [found.recall(v) for v in (1, 2, 3)] == [pytest.approx(1 / 3), pytest.approx(2 / 3), None]
    assert [found.precision(v) for v in (1, 2, 3)] == [1, pytest.approx(2 / 3), 0]


def test_what_is_not_annotated_is_left_out():
    found = compare([[0, 0, 1]], [[1, 2, 1]])
    assert (found.pixels, found.overall_accuracy, found.iou(1), found.values) == (1, 1, 1, (1,))


@pytest.mark.parametrize("annotated", [[[]], [[0, 0]]])
def test_maps_without_a_common_labeled_pixel_are_refused(annotated):
    with pytest.raises(LabelMapError, match="the reference map has no labels"):
        compare(annotated, annotated)


def test_disagreements_are_coded_where_the_annotation_is_contradicted():
    codes = disagreement_codes(ANNOTATED, PREDICTED)
    np.testing.assert_array_equal(codes > 0, [[0, 0, 1, 1], [0, 0, 1, 0]])
    assert [decode_disagreement(int(code)) for code in codes[codes > 0]] == [(1, 2), (1, 0), (2, 3)]
    assert decode_disagreement(int(disagreement_codes(np.array([[255]], np.uint8), np.array([[254]], np.uint8))[0, 0]))


def test_classes_are_matched_by_name_whatever_their_values():
    annotated = class_table_from_csv("value,name\n1,water\n2,Building\n")
    predicted = class_table_from_csv("value,name\n1,building\n2,snow\n5,WATER\n")
    match = match_classes(annotated, predicted)
    assert match.by_name and match.only_predicted == ("snow",)
    assert [int(match.values[v]) for v in (0, 1, 5, 9)] == [0, 2, 1, 0]
    snow = int(match.values[2])
    assert snow not in (0, 1, 2)
    assert [match.name(v) for v in (0, 1, 2, snow, 77)] == ["unlabeled", "water", "Building", "snow", "77"]


@pytest.mark.parametrize("predicted", [None, "value,name\n1,a\n9,b\n"])
def test_maps_without_common_names_are_matched_by_value(predicted):
    annotated = class_table_from_csv("value,name\n1,water\n2,building\n")
    match = match_classes(annotated, predicted and class_table_from_csv(predicted))
    assert not match.by_name
    np.testing.assert_array_equal(match.values, np.arange(256))
    assert match.name(1) == "water"
    assert match.name(9) == ("b" if predicted else "9")
