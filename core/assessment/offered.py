"""What an assessment assumes of labels and cameras unless somebody says otherwise; needs no NumPy."""

from __future__ import annotations

OFFERED: dict[str, tuple[float, float | None]] = {
    "missed": (20.0, 100.0),
    "invented": (20.0, 100.0),
    "misnamed": (5.0, 100.0),
    "ragged": (1.0, None),
    "background": (5.0, 100.0),
    "displaced": (1.1, None),
    "shifted": (0.5, None),
    "leaning": (0.5, 100.0),
    "lens": (0.5, 10.0),
    "tilt": (2.0, 30.0),
}
"""What is usual and the most that may be said, by name: percent, map units, degrees."""
