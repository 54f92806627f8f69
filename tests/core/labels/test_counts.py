"""How many pixels each label has."""

import numpy as np
import pytest

from semref.core.labels import counts as label_counts
from semref.core.labels.counts import count_labels


@pytest.mark.parametrize("shape", [(0, 0), (0, 5), (1, 1), (1, 300), (300, 1), (123, 257)])
def test_counts_are_those_of_a_plain_count(shape):
    labels = np.random.default_rng(0).integers(0, 256, shape, dtype=np.uint8)
    counts = count_labels(labels)
    assert counts.dtype == np.int64
    assert counts.tolist() == np.bincount(labels.ravel(), minlength=256).tolist()


def test_large_maps_are_counted_in_exact_parts(monkeypatch):
    monkeypatch.setattr(label_counts, "_EXACT", 100)
    labels = np.random.default_rng(1).integers(0, 4, (37, 41), dtype=np.uint8)
    assert count_labels(labels).tolist() == np.bincount(labels.ravel(), minlength=256).tolist()
