"""What can be wrong with an annotation: kinds of findings and how severe they are."""

from __future__ import annotations

from dataclasses import dataclass

ERROR, WARNING, INFORMATION = "error", "warning", "information"
SEVERITIES = (ERROR, WARNING, INFORMATION)

NOTHING = -1
"""Class of places that no polygon covers, and of features without a class; 0 is a class value like others."""

INVALID = "invalid"
NO_GEOMETRY = "no_geometry"
NO_AREA = "no_area"
THREE_DIMENSIONAL = "three_dimensional"
OUTSIDE_CRS = "outside_crs"
NO_CLASS = "no_class"
UNKNOWN_CLASS = "unknown_class"
OVERLAP = "overlap"
DUPLICATE = "duplicate"
HIDDEN = "hidden"
GAP = "gap"
SLIVER = "sliver"
SMALL = "small"
SAME_CLASS_NEIGHBORS = "same_class_neighbors"
LOST = "lost"
MERGED = "merged"
SPLIT = "split"

CHECKED_KINDS = (
    INVALID,
    NO_GEOMETRY,
    NO_AREA,
    THREE_DIMENSIONAL,
    OUTSIDE_CRS,
    NO_CLASS,
    UNKNOWN_CLASS,
    OVERLAP,
    DUPLICATE,
    HIDDEN,
    GAP,
    SLIVER,
    SMALL,
    SAME_CLASS_NEIGHBORS,
    LOST,
    MERGED,
    SPLIT,
)

DISSOLVED = "dissolved"
"""Only of repairs: polygons of one class that touched are one now."""


@dataclass(frozen=True)
class Finding:
    """One thing that is wrong with an annotation, or that a repair changed.

    Attributes:
        kind: One of CHECKED_KINDS, or DISSOLVED.
        severity: One of SEVERITIES.
        wkb: WKB of a (multi)polygon to show, coordinates in meters; None where there is none.
        feature_id: Id of the feature; None where no feature is concerned.
        other_id: Id of the other feature; None where no other is concerned.
        class_value: Class of the feature; NOTHING for none.
        other_class: Class of the other feature; NOTHING for none.
        area: m²; None where it has none.
        reason: Why a geometry is invalid, or the value that is no class.
        number: What the kind measures or counts: meters of shared border, pieces, features.
        decided: Whether a priority says which of two polygons lies on top.
        is_landmark: Of neighbors, whether their class is one of landmarks.
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
