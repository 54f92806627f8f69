"""The colors of maps and reports, which have the same meanings in both.

Color-blind people (deuteranopia and protanopia) can distinguish them by hue or lightness. A shape, a dash or a width
always repeats the meaning of a color.
"""

FIX = "#0067a5"
"""Positions of the images themselves; the first series of a chart."""

FLIGHT = "#c65102"
"""Positions from the flight; the second series."""

GOOD = "#00795c"
BAD = "#b3261e"
"""Errors, wrong positions and rejected positions."""

WARNING = "#e08a00"
"""Amber: warnings, likely and possible positions. ``resources/styles`` and ``resources/severity`` repeat it."""

FOURTH = "#a3508c"
"""The fourth series of a chart."""

INK, SOFT_INK, LINE = "#1c2126", "#5d6770", "#d5dade"
"""Text, secondary text, and lines in tables."""

CASING = "#ffffff"
"""Outline of marks, so that they are visible on forest, water, photos and landmarks."""

DARK = {FIX: "#56b4e9", FLIGHT: "#f0913a", GOOD: "#2fc49b", BAD: "#ff8a80", FOURTH: "#d98fc5"}
"""The same meanings on a dark page."""
