"""Sentences for the findings in a land-cover layer."""

from __future__ import annotations

from ...core.annotation import findings as kinds
from ...core.annotation.findings import Finding
from ...core.values import schema
from ..translation import tr
from .numbers import LocalTemplate

FIELDS = schema("kind text, severity text, message text, feature_id long, other_id long, area real")
"""Columns of layers of findings."""


def row_of(finding: Finding, message: str) -> dict:
    """Return the values of FIELDS by name."""
    return {
        "kind": finding.kind,
        "severity": finding.severity,
        "message": message,
        "feature_id": finding.feature_id,
        "other_id": finding.other_id,
        "area": finding.area,
    }


def sentence(finding: Finding, class_names: dict[int, str]) -> str:
    """Return the sentence for a finding of a check; ``class_names``: by class value."""
    return _filled(_check_template(finding), finding, class_names)


def severity_words() -> dict[str, str]:
    """Return the words for each key of ``severity``, in reports, legends, tables and the dock."""
    return {kinds.ERROR: tr("Error"), kinds.WARNING: tr("Warning"), kinds.INFORMATION: tr("Information")}


def severity_title(severity: str) -> str:
    """Return a severity in the user's language; an unknown key is returned unchanged."""
    return severity_words().get(severity, severity)


def kind_titles() -> dict[str, str]:
    """Return the words for each kind of finding."""
    return {
        kinds.INVALID: tr("invalid geometry"),
        kinds.NO_GEOMETRY: tr("no geometry"),
        kinds.NO_AREA: tr("no area"),
        kinds.THREE_DIMENSIONAL: tr("Z values ignored"),
        kinds.OUTSIDE_CRS: tr("outside the area of the CRS"),
        kinds.NO_CLASS: tr("no class"),
        kinds.UNKNOWN_CLASS: tr("unknown class"),
        kinds.OVERLAP: tr("overlap"),
        kinds.DUPLICATE: tr("duplicate"),
        kinds.HIDDEN: tr("hidden"),
        kinds.GAP: tr("gap between neighbors"),
        kinds.SLIVER: tr("sliver"),
        kinds.SMALL: tr("smaller than the minimum area"),
        kinds.SAME_CLASS_NEIGHBORS: tr("neighbors of one class"),
        kinds.LOST: tr("lost in pixels"),
        kinds.MERGED: tr("merged by pixels"),
        kinds.SPLIT: tr("split by pixels"),
        kinds.DISSOLVED: tr("dissolved"),
    }


def change_sentence(finding: Finding, class_names: dict[int, str]) -> str:
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
    """Return the reason of GEOS, translated if it is a common one."""
    if finding.kind != kinds.INVALID:
        return finding.reason
    words = {
        "Self-intersection": tr("Self-intersection"),
        "Ring Self-intersection": tr("Ring Self-intersection"),
        "Too few points in geometry component": tr("Too few points in geometry component"),
        "Hole lies outside shell": tr("Hole is outside shell"),
        "Holes are nested": tr("Holes are nested"),
        "Nested shells": tr("Nested shells"),
        "Interior is disconnected": tr("Interior is disconnected"),
        "Duplicate Rings": tr("Duplicate Rings"),
    }
    name, bracket, place = finding.reason.partition(" (")
    return words.get(name, name) + bracket + place


def _check_template(finding: Finding) -> str:
    if finding.kind == kinds.OVERLAP and finding.decided:
        return tr(
            "{name} (feature {id}) covers {area:.2f} m² of {other_name} (feature {other}), because of their priority."
        )
    if finding.kind == kinds.DUPLICATE and finding.class_value != finding.other_class:
        return tr("{name} (feature {id}) has the same outline as {other_name} (feature {other}).")
    if finding.kind == kinds.SAME_CLASS_NEIGHBORS and not finding.is_landmark:
        return tr("Features {id} and {other} have the class {name} and share {number:.2f} m of border.")
    if finding.kind == kinds.SAME_CLASS_NEIGHBORS and not finding.number:
        return tr(
            "Features {id} and {other} have the class {name} and touch at a point. Their pixels usually become one "
            "landmark."
        )
    return {
        kinds.INVALID: tr("The geometry of feature {id} is invalid: {reason}."),
        kinds.NO_GEOMETRY: tr("Feature {id} has no geometry and is skipped."),
        kinds.NO_AREA: tr("Feature {id} has no area and is skipped."),
        kinds.THREE_DIMENSIONAL: tr("Feature {id} has Z values, which are ignored."),
        kinds.OUTSIDE_CRS: tr("Feature {id} is outside the area of use of the layer’s CRS."),
        kinds.NO_CLASS: tr("Feature {id} has no class."),
        kinds.UNKNOWN_CLASS: tr("Feature {id} has the class “{reason}”, which is not in the class table or style."),
        kinds.OVERLAP: tr(
            "{name} (feature {id}) and {other_name} (feature {other}) overlap by {area:.2f} m². Only the order of the "
            "features decides which one is on top."
        ),
        kinds.DUPLICATE: tr("Feature {id} is a duplicate of feature {other}: same outline, same class {name}."),
        kinds.HIDDEN: tr("{name} (feature {id}) is completely covered by feature {other}."),
        kinds.GAP: tr("There is a gap of {area:.2f} m² between neighbors. Its longest border is with {other_name}."),
        kinds.SLIVER: tr("There is a sliver of {name} with {area:.2f} m² beside {other_name} (feature {id})."),
        kinds.SMALL: tr(
            "{name} (feature {id}) has {area:.2f} m², less than the minimum area. It is not used as a landmark."
        ),
        kinds.SAME_CLASS_NEIGHBORS: tr(
            "Features {id} and {other} have the class {name} and share {number:.2f} m of border. They become one "
            "landmark."
        ),
        kinds.LOST: tr(
            "{name} (feature {id}, {area:.2f} m²): its pixels cover less than the minimum area. It is not used as a "
            "landmark."
        ),
        kinds.MERGED: tr("{name} (features {id} and {other}): their pixels touch. They become one landmark."),
        kinds.SPLIT: tr("{name} (feature {id}): its pixels form {number:.0f} separate pieces."),
    }[finding.kind]


def _change_templates() -> dict[str, str]:
    return {
        kinds.INVALID: tr("The geometry of feature {id} was invalid ({reason}) and was repaired."),
        kinds.NO_GEOMETRY: tr("Feature {id} was left out, because it has no geometry."),
        kinds.NO_AREA: tr("Feature {id} was left out, because it has no area."),
        kinds.NO_CLASS: tr("Feature {id} was left out, because it has no class."),
        kinds.UNKNOWN_CLASS: tr(
            "Feature {id} was left out, because its class “{reason}” has no category in the style."
        ),
        kinds.THREE_DIMENSIONAL: tr("The Z values of feature {id} were removed."),
        kinds.OUTSIDE_CRS: tr("Feature {id} was left out, because it cannot be reprojected."),
        kinds.OVERLAP: tr(
            "An overlap of {area:.2f} m² now belongs to {name} (feature {id}) and no longer to feature {other}."
        ),
        kinds.DUPLICATE: tr("Features {id} and {other} had the same outline. One of them was kept."),
        kinds.HIDDEN: tr("Feature {id} was left out, because feature {other} covers it."),
        kinds.GAP: tr("A gap of {area:.2f} m² was added to {other_name}."),
        kinds.SLIVER: tr("A sliver of {name} with {area:.2f} m² (feature {id}) was added to {other_name}."),
        kinds.DISSOLVED: tr(
            "{number:.0f} touching features of {name} became one polygon with the attributes of feature {id}."
        ),
    }
