"""Findings about a land-cover layer: their kinds and severities."""

from __future__ import annotations

from dataclasses import dataclass

ERROR, WARNING, INFORMATION = SEVERITIES = "error", "warning", "information"

NOTHING = -1
"""Class of ground without a polygon, and of features without a class; 0 is a class value like others."""

CHECKED_KINDS = (
    INVALID := "invalid",
    NO_GEOMETRY := "no_geometry",
    NO_AREA := "no_area",
    THREE_DIMENSIONAL := "three_dimensional",
    OUTSIDE_CRS := "outside_crs",
    NO_CLASS := "no_class",
    UNKNOWN_CLASS := "unknown_class",
    OVERLAP := "overlap",
    DUPLICATE := "duplicate",
    HIDDEN := "hidden",
    GAP := "gap",
    SLIVER := "sliver",
    SMALL := "small",
    SAME_CLASS_NEIGHBORS := "same_class_neighbors",
    LOST := "lost",
    MERGED := "merged",
    SPLIT := "split",
)
"""Kinds that a check finds, in the order in which they are shown."""

DISSOLVED = "dissolved"
"""Only in repairs: touching polygons of one class were joined."""


@dataclass(frozen=True)
class Finding:
    """A problem of a land-cover layer, or a change by a repair.

    Attributes:
        kind: One of CHECKED_KINDS, or DISSOLVED.
        severity: One of SEVERITIES.
        wkb: WKB of a (multi)polygon to show, coordinates in meters, or None.
        feature_id: Id of the feature, or None.
        other_id: Id of the other feature, or None.
        class_value: Class of the feature, or NOTHING.
        other_class: Class of the other feature, or NOTHING.
        area: m², or None.
        reason: Why a geometry is invalid, or the value that is not a class.
        number: Measure or count of the kind: meters of shared border, pieces, features.
        decided: Whether a priority decides which of two polygons is on top.
        is_landmark: For neighbors, whether their class is a landmark class.
    """

    kind: str
    severity: str
    wkb: bytes | None = None
    feature_id: int | None = None
    other_id: int | None = None
    class_value: int = NOTHING
    other_class: int = NOTHING
    area: float | None = None
    reason: str = ""
    number: float = 0.0
    decided: bool = False
    is_landmark: bool = False
