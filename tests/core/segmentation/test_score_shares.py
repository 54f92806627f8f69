"""Percents become shares of classes on a coarse grid, for rows in any bands."""

import numpy as np
import pytest

from semref.core.segmentation.certainty import NO_DATA, percents
from semref.core.segmentation.photo_labels import ScoreShares
from semref.core.segmentation.tiling import SegmentedRows

VALUES = (3, 0, 7, 3)
"""Two channels of class 3, one without a class."""


@pytest.fixture
def seen():
    """Return (4, 60, 90) percents."""
    return percents(np.moveaxis(np.random.default_rng(3).dirichlet(np.ones(4), (60, 90)), 2, 0))


def added(seen, size_wh, bands):
    sums = ScoreShares(VALUES, seen.shape[1:], size_wh)
    for first, last in zip(bands[:-1], bands[1:]):
        part = seen[:, first:last]
        sums.add(SegmentedRows(first, np.ones(part.shape[1:], np.uint8), percents_chw=part))
    return sums.found()


def true_shares(seen, size_wh):
    """Return (h, w, 2) means of the probabilities of classes 3 and 7 over blocks of whole pixels."""
    shares = seen / 100
    planes = np.stack([shares[0] + shares[3], shares[2]], axis=2)
    width, height = size_wh
    blocks = planes.reshape(height, planes.shape[0] // height, width, planes.shape[1] // width, 2)
    return blocks.mean(axis=(1, 3))


def test_shares_are_means_of_the_softmax_over_each_pixel_of_the_grid(seen):
    found = added(seen, (15, 12), [0, 60])
    assert found.values.tolist() == [3, 7]
    np.testing.assert_allclose(found.shares / 255, true_shares(seen, (15, 12)), atol=0.6 / 255)


@pytest.mark.parametrize("size_wh", [(15, 12), (90, 60), (37, 23), (1, 1)])
def test_rows_in_any_bands_give_the_same(seen, size_wh):
    whole = added(seen, size_wh, [0, 60]).shares.astype(int)
    parts = added(seen, size_wh, [0, 1, 13, 14, 37, 60]).shares.astype(int)
    assert whole.shape == (size_wh[1], size_wh[0], 2)
    assert np.abs(whole - parts).max() <= 1


def test_pixels_without_data_are_unknown(seen):
    seen[:, :30] = NO_DATA
    sums = ScoreShares((1, 2, 3, 4), (60, 90), (1, 2))
    sums.add(SegmentedRows(0, np.ones((60, 90), np.uint8), percents_chw=seen))
    shares = sums.found().shares.astype(int).sum(axis=2)
    assert shares[0, 0] == 0 and abs(shares[1, 0] - 255) <= 3


def test_rows_without_percents_are_refused():
    with pytest.raises(ValueError):
        ScoreShares((1,), (4, 4), (2, 2)).add(SegmentedRows(0, np.ones((4, 4), np.uint8)))
