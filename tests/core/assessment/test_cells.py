"""Assessed squares cover the map without the frame around it."""

import numpy as np
import pytest

from semref.core.assessment.cells import ground_cells
from semref.core.errors import ParameterError


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
