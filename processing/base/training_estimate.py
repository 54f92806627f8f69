"""How long a training takes on this computer: what dialogs show before it is started."""

from __future__ import annotations

from qgis.core import QgsSettings

from ...core.labels.training_tiles import fitting_tiles
from ...training.job import FEWEST_PIECES, MOST_PIECES, PIECE_SIZE

_SETTING = "semref/training/seconds_a_piece/"

CAUTIOUS_S = 0.3
"""Seconds that two slow cores take for a piece of EfficientNet-Lite0: until a training has been measured here."""

_SLOWEST_S = 3600.0

STARTED_S, TILE_S, ENDED_SHARE = 15.0, 0.05, 0.25
"""To start torch; to cut a tile; share of the time limit to judge and write the model (training/train.py)."""


def remember_speed(encoder: str, result: dict) -> None:
    """Keeps how fast a training was."""
    speed = result.get("seconds_a_piece")
    if isinstance(speed, float) and 0 < speed < _SLOWEST_S:
        QgsSettings().setValue(_SETTING + encoder, speed)


def seconds_a_piece(encoder: str) -> float:
    """As the last training on this computer took; a cautious guess before there was one."""
    return QgsSettings().value(_SETTING + encoder, CAUTIOUS_S, type=float)


def epochs_within(minutes: float, shape_hw: tuple[int, int], fraction: float, encoder: str) -> float:
    """How many epochs a time limit leaves room for.

    Args:
        minutes: The limit.
        shape_hw: (height, width) of the labeled ground in pixels.
        fraction: Of the ground that is set aside.
        encoder: Of the network, LITE0 or SMALL.
    """
    size, stride = fitting_tiles(shape_hw)
    tiles = (1 + max(shape_hw[0] - size, 0) // stride) * (1 + max(shape_hw[1] - size, 0) // stride)
    pieces = (1 - fraction) * tiles * max(1, size // PIECE_SIZE) ** 2
    pieces = min(max(pieces, FEWEST_PIECES), MOST_PIECES)
    left_s = 60 * minutes * (1 - ENDED_SHARE) - STARTED_S - TILE_S * tiles
    return max(left_s, 0.0) / (pieces * seconds_a_piece(encoder))
