from dataclasses import replace

import numpy as np
import pytest

from semref.core.assessment.assessment import REASONS, Estimates
from semref.core.assessment.cells import Cells, ground_cells
from semref.core.assessment.squares import FIELDS, VERDICTS, footprint_sizes, reason_sentence, square_rows
from semref.core.errors import ParameterError
from semref.core.sentences import english


def estimates(success, reasons):
    numbers = np.array(success, float)
    ones = np.ones(len(numbers))
    errors = np.where(numbers > 0, 2.5, np.nan)
    low, high = np.maximum(numbers - 0.1, 0), np.minimum(numbers + 0.1, 1)
    return Estimates(numbers, low, high, errors, ones.astype(int), 7 * ones, 2 * ones, ones / 4, ones / 8, reasons)


@pytest.fixture
def windows(assessed_database):
    """Return windows with a distinctiveness of a tenth of their number."""
    known = assessed_database.windows
    return replace(known, distinctiveness=np.arange(len(known)) / 10)


def test_a_row_has_verdict_reason_and_distinctiveness(windows):
    success = (0.0, 0.31, 0.61, 0.9, 0.96)
    centers = windows.centers[:5].copy()
    centers[4] -= 5000
    cells = Cells(50.0, centers, np.arange(5), np.zeros(5, int))
    reasons = (REASONS[0], REASONS[1], REASONS[2], REASONS[3], "")
    rows = list(square_rows(cells, windows, 250.0, estimates(success, reasons), 0.9))
    assert [row["verdict"] for row in rows] == list(VERDICTS)
    assert all(row.keys() == {name for name, _ in FIELDS} for row in rows)
    assert [row["error"] for row in rows] == [None, 2.5, 2.5, 2.5, 2.5]
    assert rows[0]["reason"] == "Too few landmarks: 7 in view on average."
    assert rows[1]["reason"].startswith("Similar places") and rows[2]["reason"].startswith("Too little evidence")
    assert rows[3]["reason"] == rows[4]["reason"] == ""
    assert [row["distinctiveness"] for row in rows] == [0.0, 0.1, 0.2, 0.3, None]


def test_reasons_are_formatted_by_the_caller(windows):
    cells = Cells(50.0, windows.centers[:1], np.zeros(1, int), np.zeros(1, int))
    told = estimates((0.2,), (REASONS[3],))
    (row,) = square_rows(cells, windows, 250.0, told, 0.9, lambda sentence: sentence.template.upper())
    assert row["reason"] == "SOME FIXES WOULD BE WRONG."


def test_every_reason_has_a_sentence():
    texts = {english(reason_sentence(reason, 3.0)) for reason in REASONS}
    assert len(texts) == len(REASONS)
    assert reason_sentence("", 3.0) is None


def test_a_list_of_footprints_keeps_its_order_and_drops_what_comes_twice():
    assert footprint_sizes("640; 320,5;640;", 1.0) == [640.0, 320.5]
    assert footprint_sizes("", 250.0) == footprint_sizes(None, 250.0) == [250.0]


@pytest.mark.parametrize("text", ["much", "0", "-3", "200;inf", "nan"])
def test_what_is_no_list_of_footprints_is_refused(text):
    with pytest.raises(ParameterError, match="is not a list of footprint widths"):
        footprint_sizes(text, 1.0)


def test_the_squares_cover_the_map(assessed_database):
    cells = ground_cells(assessed_database, 100.0)
    assert len(cells) == 60
    assert cells.centers.min(axis=0).tolist() == [600050.0, 5199450.0]
    assert (cells.columns.max(), cells.rows.max()) == (9, 5)


def test_unlabeled_ground_counts_inside_the_map_but_not_around_it(built, map_labels):
    labels = np.zeros_like(map_labels)
    labels[:, :600] = map_labels[:, :600]
    labels[210:390, 210:390] = 0
    cells = ground_cells(built(labels), 60.0)
    places = set(zip(cells.columns.tolist(), cells.rows.tolist()))
    assert (4, 4) in places and (5, 5) in places
    assert max(column for column, _ in places) == 9


@pytest.mark.parametrize(
    "size, said", [(0.0, "edge of a square is 0"), (float("nan"), "is nan"), (0.5, "Enter 2.47 m or more")]
)
def test_an_impossible_spacing_is_refused(assessed_database, size, said):
    with pytest.raises(ParameterError, match=said):
        ground_cells(assessed_database, size)
