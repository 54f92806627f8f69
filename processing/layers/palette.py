"""The colors that maps and reports share: what a color means on one, it means in the other.

All are told apart by the color-blind (deuteranopia and protanopia), by lightness where not by hue; where a color
matters, a shape, a dash or a width says the same.
"""

FIX = "#0067a5"
"""Positions that the image itself gives; the first series of a chart."""

FLIGHT = "#c65102"
"""Positions that the flight gives; the second series."""

GOOD = "#00795c"
BAD = "#b3261e"
"""Errors, wrong fixes, and fixes that were outvoted."""

WARNING = "#e08a00"
"""Warnings, and places that are possible but not decided."""

INFORMATION = "#4a7fb5"
FOURTH = "#a3508c"
"""The fourth series of a chart."""

INK, SOFT_INK, LINE = "#1c2126", "#5d6770", "#d5dade"
"""Of text, of what stands beside it, and of lines in tables."""

CASING = "#ffffff"
"""Around marks, so that they show on forest, water, photos and landmarks alike."""

DARK = {
    FIX: "#56b4e9",
    FLIGHT: "#f0913a",
    GOOD: "#2fc49b",
    BAD: "#ff8a80",
    WARNING: "#f5c04a",
    INFORMATION: "#8fbbe6",
    FOURTH: "#d98fc5",
}
"""The same meanings on a dark page."""
