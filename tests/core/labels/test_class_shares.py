"""Shares of classes, asked for by value."""

import numpy as np

from semref.core.labels.class_shares import ClassShares


def test_shares_come_in_the_order_asked_for_and_0_where_a_class_isnt_told():
    shares = ClassShares(np.array([2, 5], np.uint8), np.array([[[10, 200], [30, 40]]], np.uint8))
    found = shares.of(np.array([5, 3, 2], np.uint8))
    assert found.tolist() == [[[200, 0, 10], [40, 0, 30]]]
