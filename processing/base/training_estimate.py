"""Estimate of the training time on this computer, which dialogs show before the start."""

from __future__ import annotations

from qgis.core import QgsSettings

from ...core.labels.training_tiles import fitting_tiles
from ...training.job import FEWEST_PIECES, MOST_PIECES, PIECE_SIZE

_SETTING = "semref/training/seconds_a_piece/"

CAUTIOUS_S = 0.3
"""Seconds per piece of EfficientNet-Lite0 on two slow cores: used until a training was measured here."""

_SLOWEST_S = 3600.0

STARTED_S, TILE_S, ENDED_SHARE = 15.0, 0.05, 0.25
"""Seconds to start torch; seconds to cut a tile; share of the time limit to test and write the model
(training/train.py)."""


def remember_speed(encoder: str, result: dict) -> None:
    """Store the speed of a training."""
    speed = result.get("seconds_a_piece")
    if isinstance(speed, float) and 0 < speed < _SLOWEST_S:
        QgsSettings().setValue(_SETTING + encoder, speed)


def seconds_a_piece(encoder: str) -> float:
    """Return the speed of the last training on this computer, or a cautious guess."""
    return QgsSettings().value(_SETTING + encoder, CAUTIOUS_S, type=float)


def epochs_within(minutes: float, shape_hw: tuple[int, int], fraction: float, encoder: str) -> float:
    """Return the number of epochs within a time limit.

    Args:
        minutes: Time limit.
        shape_hw: (height, width) of the labeled ground in pixels.
        fraction: Share of the ground that is set aside.
        encoder: Encoder of the network, LITE0 or SMALL.
    """
    size, stride = fitting_tiles(shape_hw)
    tiles = (1 + max(shape_hw[0] - size, 0) // stride) * (1 + max(shape_hw[1] - size, 0) // stride)
    pieces = (1 - fraction) * tiles * max(1, size // PIECE_SIZE) ** 2
    pieces = min(max(pieces, FEWEST_PIECES), MOST_PIECES)
    left_s = 60 * minutes * (1 - ENDED_SHARE) - STARTED_S - TILE_S * tiles
    return max(left_s, 0.0) / (pieces * seconds_a_piece(encoder))
