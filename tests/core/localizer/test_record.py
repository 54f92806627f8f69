from dataclasses import replace

import pytest

from semref.core.geometry.pose import Ellipse, PoseCovariance
from semref.core.localization import Localization, Method, Place, Status
from semref.core.localizer.network_reason import name_network
from semref.core.localizer.record import DEVIATIONS, error_probability, record
from semref.core.sentences import Sentence

PLACE = Place((600250.0, 5199600.0), heading_deg=90.0, pixel_size_m=0.5, log_odds=12.5, inliers=7)
KNOWN = PoseCovariance(((1.0, 0.0), (0.0, 4.0)), 0.2, 0.01, Ellipse(4.9, 2.4, 30.0))
FIX = Localization(Status.FIX, Method.CONSTELLATION, 9, best=PLACE, confidence=0.99, error_95_m=4.9, covariance=KNOWN)


def test_a_fix_fills_all_columns():
    status = {"status": "fix", "method": "constellation", "reason": ""}
    place = {"x": 600250.0, "y": 5199600.0, "heading": 90.0, "pixel_size": 0.5, "window": None, "distance": None}
    evidence = {"confidence": 0.99, "inliers": 7, "references": 9, "log_odds": 12.5}
    ellipse = {"error_95": 4.9, "error_95_minor": 2.4, "error_95_direction": 30.0}
    deviations = {"heading_deviation": 0.2, "pixel_size_deviation": 0.01, "sigma_heading": 0.2, "sigma_scale": 0.02}
    sigmas = {"sigma_east": 1.0, "sigma_north": 2.0, "correlation": 0.0}
    assert record(FIX) == {**status, **place, **evidence, **ellipse, **deviations, **sigmas}


def test_without_a_fix_there_is_evidence_but_no_place_or_accuracy():
    unsure = replace(FIX, status=Status.AMBIGUOUS, reason=Sentence("The image has no pixels."))
    found = record(unsure, lambda said: said.template)
    assert [found[name] for name in ("x", "y", "heading", "pixel_size", "error_95")] == [None] * 5
    assert (found["inliers"], found["log_odds"], found["reason"]) == (7, 12.5, "The image has no pixels.")
    assert set(found) == set(record(FIX)) and [found[name] for name in DEVIATIONS] == [None] * len(DEVIATIONS)


@pytest.mark.parametrize(
    ("confidence", "words"),
    [
        *((0.5, "1 in 2"), (0.9, "1 in 10"), (1 - 1 / 1234, "1 in 1,200")),
        *((confidence, "below 1 in 10,000") for confidence in (1 - 1e-4, 1 - 1e-9, 1.0)),
    ],
)
def test_an_error_probability_is_shown_no_smaller_than_it_was_tested(confidence, words):
    assert str(error_probability(confidence)) == words


def test_a_fix_has_the_parts_of_its_radius():
    known = replace(KNOWN, parts=(("map", 1.25), ("landmarks", 0.5), ("pixels", 0.1)))
    said = record(replace(FIX, covariance=known))["reason"]
    assert said == "Error budget (95 %): map 1.2 m, single landmarks 0.5 m."
    remark = Sentence(
        "In the {part} of the image only {agree} of {count} landmarks agree with the map: new there, off the map, or "
        "of another place. The position is valid for the rest.",
        part="left part",
        agree=0,
        count=24,
    )
    both = record(replace(FIX, covariance=known, reason=remark))["reason"]
    assert both.startswith("In the left part of the image only 0 of 24 landmarks agree") and both.endswith(said)


PLACES, CLASSES = ("made-up areas", "Banepa"), ("building", "water")
SHOWN = Sentence("The image shows {count} whole landmark", count=1)
LACKING = Sentence("{shown}; {needed}.", shown=SHOWN, needed=Sentence("at least {count} more are needed", count=7))
TOO_FEW = Localization(Status.TOO_FEW_REFERENCES, Method.CONSTELLATION, 1, LACKING)
NO_MATCH = replace(
    TOO_FEW, status=Status.NO_MATCH, reason=Sentence("No place on the map has triangles of landmarks like the image's.")
)


def test_too_few_landmarks_of_a_photo_are_what_the_network_found():
    assert str(name_network(TOO_FEW, PLACES, CLASSES).reason) == (
        "The network found 1 landmark (building, water); at least 7 more are needed. "
        "The network was trained on: made-up areas, Banepa."
    )


def test_a_reason_within_a_reason_counts_what_the_network_found_too():
    template = "{constellation} Map correlation found no position either: {correlation:clause}"
    both = Sentence(template, constellation=TOO_FEW.reason, correlation=NO_MATCH.reason)
    said = str(name_network(replace(TOO_FEW, reason=both), (), CLASSES).reason)
    assert said.startswith("The network found 1 landmark (building, water); at least 7 more are needed. Map")


def test_what_the_network_was_trained_on_follows_any_reason():
    said = str(name_network(NO_MATCH, PLACES, CLASSES).reason)
    assert said == f"{NO_MATCH.reason} The network was trained on: made-up areas, Banepa."


@pytest.mark.parametrize("found", [NO_MATCH, TOO_FEW])
def test_reasons_do_not_name_a_network_without_metadata(found):
    assert name_network(found, None, CLASSES) == found
    assert "trained" not in str(name_network(found, (), CLASSES).reason)
