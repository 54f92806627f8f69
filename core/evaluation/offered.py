"""What an evaluation draws from and tells first, unless somebody says otherwise; needs no NumPy."""

from __future__ import annotations

from ..localization import Method

OFFERED: dict[str, tuple[float, float]] = {
    "scale": (0.8, 1.25),
    "rotation": (0.0, 360.0),
    "offset": (0.0, 0.5),
    "missed": (20.0, 20.0),
    "invented": (20.0, 20.0),
    "misnamed": (5.0, 5.0),
    "ragged": (0.0, 1.0),
    "background": (5.0, 5.0),
    "displaced": (1.1, 1.1),
    "shifted": (0.5, 0.5),
    "leaning": (0.0, 1.0),
    "lens": (0.0, 1.0),
    "tilt": (0.0, 3.0),
}
"""Ranges of ``TrialRanges``, by name."""

ORDER = (Method.AUTOMATIC, Method.CONSTELLATION, Method.MAP_CORRELATION, Method.TOPOLOGY_VECTOR)
"""Of several methods the first is what the grid of noise is about."""
