"""Labels that tell less than a class: a place where only buildings were drawn says of the rest that it is no building.

Such ground has a label of its own, beyond the channels: a set of the channels that it may be. What is learned is that
the network's probability of the set is high, whichever of its channels has it (the “marginal” loss of Shi et al. 2021,
arXiv:2007.03868), so that nothing is said against a road where roads were not drawn.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from .tiles import IGNORED


def partial_labels(count: int, excluded: dict[Path, list[int]]) -> tuple[np.ndarray, dict[Path, int]]:
    """The labels there are, and that of each folder's ground without a label.

    Channel 0 stands for what is unlabeled; no set has it, or everything unlike the other places would become it.

    Args:
        count: Channels.
        excluded: Of folders of tiles the channels that their ground without a label is known not to be.

    Returns:
        (count + S, count) bool, which channels each label allows: itself, or, of a set, all but 0 and those excluded;
        and by folder the number of its set, IGNORED where nothing is left.
    """
    kept = {path: tuple(sorted(set(range(1, count)) - set(channels))) for path, channels in excluded.items()}
    sets = sorted({channels for channels in kept.values() if channels})
    allowed = np.zeros((count + len(sets), count), bool)
    allowed[:count] = np.eye(count, dtype=bool)
    for row, channels in zip(allowed[count:], sets):
        row[list(channels)] = True
    return allowed, {path: count + sets.index(one) if one else IGNORED for path, one in kept.items()}


def told_channels(allowed):
    """(count + S, count) bool: of which channels a label tells whether it is them; a set only of those it excludes.

    allowed: as ``partial_labels`` gives it, or a tensor of that.
    """
    told = ~allowed
    told[: allowed.shape[1]] = True
    return told
