"""A hash of all of some data, which tells it from other data."""

from __future__ import annotations

import hashlib

import numpy as np

from semref.core.kept.digests import digest


def test_a_digest_tells_where_one_column_ends_and_the_next_begins():
    assert digest([b"ab", b"c"]) != digest([b"a", b"bc"])
    column = np.arange(6)
    assert digest([column]) == digest([column.tobytes()]) == digest([np.repeat(column, 2)[::2]])


def test_a_digest_is_that_of_the_bytes_with_their_number_before_them():
    bits = np.arange(4).reshape(2, 2) > 1
    expected = hashlib.sha256((4).to_bytes(8, "little") + b"\0\0\1\1" + (0).to_bytes(8, "little")).hexdigest()
    assert digest([bits, np.zeros((0, 3))]) == expected
