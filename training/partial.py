"""Train with partial labels: if only buildings were drawn in a place, its other ground is known to be no building.

Such ground gets an extra label for the set of channels that it may have. The loss uses the network's total probability
of the set (the “marginal” loss of Shi et al. 2021, arXiv:2007.03868). A road is thus not wrong where no roads were
drawn.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from .tiles import IGNORED


def partial_labels(count: int, excluded: dict[Path, list[int]]) -> tuple[np.ndarray, dict[Path, int]]:
    """Return the channels that each label allows, and the label of each folder's unlabeled ground.

    Channel 0 means unlabeled. No set contains it: otherwise ground that differs from the other places would become
    unlabeled.

    Args:
        excluded: By folder of tiles, the channels that its unlabeled ground can't have.

    Returns:
        (count + S, count) bool: a channel allows itself, a set all channels except 0 and the excluded ones. And the
        number of the set by folder, IGNORED for an empty set.
    """
    kept = {path: tuple(sorted(set(range(1, count)) - set(channels))) for path, channels in excluded.items()}
    sets = sorted({channels for channels in kept.values() if channels})
    allowed = np.zeros((count + len(sets), count), bool)
    allowed[:count] = np.eye(count, dtype=bool)
    for row, channels in zip(allowed[count:], sets):
        row[list(channels)] = True
    return allowed, {path: count + sets.index(one) if one else IGNORED for path, one in kept.items()}


def decided_channels(allowed):
    """Return (count + S, count) bool of the channels that a label decides: all, or those that a set excludes.

    ``allowed``: first result of ``partial_labels``, also as a tensor.
    """
    decided = ~allowed
    decided[: allowed.shape[1]] = True
    return decided
