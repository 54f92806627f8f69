"""Reasons name the network first, because it is the most likely cause."""

from dataclasses import replace

import pytest

from semref.core.localization import Localization, Method, Status
from semref.core.localizer.network_reason import name_network
from semref.core.sentences import Sentence

PLACES, CLASSES = ("made-up areas", "Banepa"), ("building", "water")
TOO_FEW = Localization(
    Status.TOO_FEW_REFERENCES,
    Method.CONSTELLATION,
    1,
    Sentence(
        "{shown}; {needed}.",
        shown=Sentence("The image shows {count} whole landmark", count=1),
        needed=Sentence("at least {count} more are needed", count=7),
    ),
)
NO_MATCH = replace(
    TOO_FEW, status=Status.NO_MATCH, reason=Sentence("No place on the map has triangles of landmarks like the image's.")
)


def test_too_few_landmarks_of_a_photo_are_what_the_network_found():
    assert str(name_network(TOO_FEW, PLACES, CLASSES).reason) == (
        "The network found 1 landmark (building, water); at least 7 more are needed. "
        "The network was trained on: made-up areas, Banepa."
    )


def test_a_reason_within_a_reason_counts_what_the_network_found_too():
    both = Sentence(
        "{constellation} Map correlation found no position either: {correlation:clause}",
        constellation=TOO_FEW.reason,
        correlation=NO_MATCH.reason,
    )
    said = str(name_network(replace(TOO_FEW, reason=both), (), CLASSES).reason)
    assert said.startswith("The network found 1 landmark (building, water); at least 7 more are needed. Map")


def test_any_other_reason_follows_what_the_network_was_trained_on():
    said = str(name_network(NO_MATCH, PLACES, CLASSES).reason)
    assert said.startswith("The network was trained on: made-up areas, Banepa. No place on the map")


@pytest.mark.parametrize("found", [NO_MATCH, TOO_FEW])
def test_reasons_do_not_name_a_network_without_metadata(found):
    assert name_network(found, None, CLASSES) == found
    assert "trained" not in str(name_network(found, (), CLASSES).reason)
