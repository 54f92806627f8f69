"""The kinds of findings, and what a finding says when nobody says more."""

from semref.core.annotation import findings
from semref.core.annotation.findings import CHECKED_KINDS, DISSOLVED, NOTHING, SEVERITIES, Finding


def test_every_kind_is_named_once():
    assert len(set(CHECKED_KINDS)) == len(CHECKED_KINDS)
    assert DISSOLVED not in CHECKED_KINDS, "a repair tells it, not a check"


def test_every_kind_that_the_room_names_is_listed():
    named = {value for name, value in vars(findings).items() if name.isupper() and isinstance(value, str)}
    assert named == {*CHECKED_KINDS, DISSOLVED, *SEVERITIES}


def test_a_bare_finding_concerns_no_feature_and_no_class():
    finding = Finding(findings.GAP, findings.WARNING)
    assert (finding.wkb, finding.feature_id, finding.other_id, finding.area) == (None, None, None, None)
    assert finding.class_value == finding.other_class == NOTHING


def test_no_class_value_is_nothing():
    assert NOTHING not in range(256)
