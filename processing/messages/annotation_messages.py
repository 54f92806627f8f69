"""What findings in an annotation mean to the user: a sentence each, with its values."""

from __future__ import annotations

from ...core.annotation import findings as kinds
from ...core.annotation.findings import Finding
from ..translation import tr
from .numbers import LocalTemplate

FIELDS = (
    ("kind", "text"),
    ("severity", "text"),
    ("message", "text"),
    ("feature_id", "long"),
    ("other_id", "long"),
    ("area", "real"),
)
"""Columns of layers of findings."""


def row_of(finding: Finding, message: str) -> dict:
    """Values of FIELDS by name."""
    return {
        "kind": finding.kind,
        "severity": finding.severity,
        "message": message,
        "feature_id": finding.feature_id,
        "other_id": finding.other_id,
        "area": finding.area,
    }


def sentence(finding: Finding, class_names: dict[int, str]) -> str:
    """What a finding of a check says; ``class_names``: by class value."""
    return _filled(_check_template(finding), finding, class_names)


def severity_words() -> dict[str, str]:
    """THE word for each key of ``severity``: in reports, legends, tables and the dock alike."""
    return {kinds.ERROR: tr("Error"), kinds.WARNING: tr("Warning"), kinds.INFORMATION: tr("Information")}


def severity_title(severity: str) -> str:
    """A severity in the user's language; what this version does not know stands for itself."""
    return severity_words().get(severity, severity)


def kind_titles() -> dict[str, str]:
    """Words for each kind of finding."""
    return {
        kinds.INVALID: tr("invalid geometry"),
        kinds.NO_GEOMETRY: tr("no geometry"),
        kinds.NO_AREA: tr("no area"),
        kinds.THREE_DIMENSIONAL: tr("heights left out"),
        kinds.OUTSIDE_CRS: tr("outside the CRS’s area"),
        kinds.NO_CLASS: tr("no class"),
        kinds.UNKNOWN_CLASS: tr("unknown class"),
        kinds.OVERLAP: tr("overlap"),
        kinds.DUPLICATE: tr("duplicate"),
        kinds.HIDDEN: tr("hidden"),
        kinds.GAP: tr("gap between neighbors"),
        kinds.SLIVER: tr("sliver"),
        kinds.SMALL: tr("below the minimum area"),
        kinds.SAME_CLASS_NEIGHBORS: tr("neighbors of one class"),
        kinds.LOST: tr("lost in pixels"),
        kinds.MERGED: tr("merged by pixels"),
        kinds.SPLIT: tr("split by pixels"),
        kinds.DISSOLVED: tr("dissolved"),
    }


def change_sentence(finding: Finding, class_names: dict[int, str]) -> str:
    """What a repair says it has done about a finding."""
    return _filled(_change_templates()[finding.kind], finding, class_names)


def _filled(template: str, finding: Finding, class_names: dict[int, str]) -> str:
    return LocalTemplate(template).format(
        id=finding.feature_id,
        other=finding.other_id,
        name=class_names.get(finding.class_value, ""),
        other_name=class_names.get(finding.other_class, ""),
        area=finding.area or 0.0,
        reason=_reason(finding),
        number=finding.number,
    )


def _reason(finding: Finding) -> str:
    """As GEOS says it, in the user's language where it is one of its usual reasons."""
    if finding.kind != kinds.INVALID:
        return finding.reason
    words = {
        "Self-intersection": tr("Self-intersection"),
        "Ring Self-intersection": tr("Ring Self-intersection"),
        "Too few points in geometry component": tr("Too few points in geometry component"),
        "Hole lies outside shell": tr("Hole lies outside shell"),
        "Holes are nested": tr("Holes are nested"),
        "Nested shells": tr("Nested shells"),
        "Interior is disconnected": tr("Interior is disconnected"),
        "Duplicate Rings": tr("Duplicate Rings"),
    }
    name, bracket, place = finding.reason.partition(" (")
    return words.get(name, name) + bracket + place


def _check_template(finding: Finding) -> str:
    if finding.kind == kinds.OVERLAP and finding.decided:
        return tr("{name} (feature {id}) lies on {area:.2f} m² of {other_name} (feature {other}), as their order says.")
    if finding.kind == kinds.DUPLICATE and finding.class_value != finding.other_class:
        return tr("{name} (feature {id}) has the same outline as {other_name} (feature {other}).")
    if finding.kind == kinds.SAME_CLASS_NEIGHBORS and not finding.is_landmark:
        return tr("Features {id} and {other} are both {name} and share {number:.2f} m of border.")
    if finding.kind == kinds.SAME_CLASS_NEIGHBORS and not finding.number:
        return tr(
            "Features {id} and {other} are both {name} and touch in a point: as a rule their pixels become one "
            "landmark."
        )
    return {
        kinds.INVALID: tr("The geometry of feature {id} is invalid: {reason}."),
        kinds.NO_GEOMETRY: tr("Feature {id} has no geometry and is skipped."),
        kinds.NO_AREA: tr("Feature {id} has no area and is skipped."),
        kinds.THREE_DIMENSIONAL: tr("Feature {id} has heights (Z), which are left out."),
        kinds.OUTSIDE_CRS: tr("Feature {id} lies outside the area that the layer’s CRS is made for."),
        kinds.NO_CLASS: tr("Feature {id} has no class."),
        kinds.UNKNOWN_CLASS: tr("Feature {id} has the class “{reason}”, which is not among the classes."),
        kinds.OVERLAP: tr(
            "{name} (feature {id}) and {other_name} (feature {other}) claim the same {area:.2f} m², and only the order "
            "of the features says which lies on top."
        ),
        kinds.DUPLICATE: tr("Feature {id} repeats feature {other}: same outline, same class {name}."),
        kinds.HIDDEN: tr("Nothing is seen of {name} (feature {id}): feature {other} lies on top."),
        kinds.GAP: tr("A gap of {area:.2f} m² lies between neighbors; its longest border is with {other_name}."),
        kinds.SLIVER: tr("A sliver of {name} of {area:.2f} m² lies beside {other_name} (feature {id})."),
        kinds.SMALL: tr("{name} (feature {id}) covers {area:.2f} m², less than the minimum area: it is no landmark."),
        kinds.SAME_CLASS_NEIGHBORS: tr(
            "Features {id} and {other} are both {name} and share {number:.2f} m of border: they become one landmark."
        ),
        kinds.LOST: tr(
            "{name} (feature {id}, {area:.2f} m²): the outline of its pixels stays under the minimum area, so it is "
            "no landmark."
        ),
        kinds.MERGED: tr("{name} (features {id} and {other}): their pixels touch, so they become one landmark."),
        kinds.SPLIT: tr("{name} (feature {id}) falls into {number:.0f} pieces of pixels."),
    }[finding.kind]


def _change_templates() -> dict[str, str]:
    return {
        kinds.INVALID: tr("The geometry of feature {id} was made valid: {reason}."),
        kinds.NO_GEOMETRY: tr("Feature {id} was left out: it has no geometry."),
        kinds.NO_AREA: tr("Feature {id} was left out: it has no area."),
        kinds.NO_CLASS: tr("Feature {id} was left out: it has no class."),
        kinds.UNKNOWN_CLASS: tr("Feature {id} was left out: its class “{reason}” has no category in the style."),
        kinds.THREE_DIMENSIONAL: tr("The heights (Z) of feature {id} were left out."),
        kinds.OUTSIDE_CRS: tr("Feature {id} was left out: it can’t be reprojected."),
        kinds.OVERLAP: tr(
            "{area:.2f} m² that two claimed belong to {name} (feature {id}), no longer to feature {other}."
        ),
        kinds.DUPLICATE: tr("Feature {id} and feature {other} had the same outline; one is left."),
        kinds.HIDDEN: tr("Feature {id} was left out: feature {other} covers it."),
        kinds.GAP: tr("A gap of {area:.2f} m² was given to {other_name}."),
        kinds.SLIVER: tr("A sliver of {name} of {area:.2f} m² (feature {id}) was given to {other_name}."),
        kinds.DISSOLVED: tr(
            "{number:.0f} touching features of {name} are one polygon with the attributes of feature {id}."
        ),
    }
