from dataclasses import replace

import numpy as np
import pytest

from semref.core.assessment.images import ImageSimulator
from semref.core.database.model import MapLandmarks
from semref.core.errors import DatabaseError, ParameterError
from semref.core.evaluation.trial import Query
from semref.core.landmarks.landmarks import extract_landmarks
from semref.core.localizer.localizer import Localizer
from semref.core.simulation.noise import LabelNoise
from semref.core.simulation.views import View, cut

FOOTPRINT = 250.0
IN_TOWN = 600300.0, 5199700.0


@pytest.mark.parametrize("heading", [0.0, 30.0, 137.0])
def test_a_simulated_image_has_the_landmarks_of_an_image_of_the_map(assessed_database, localizer, map_labels, heading):
    simulator = ImageSimulator(localizer, assessed_database, FOOTPRINT)
    found, centers = simulator.whole_landmarks(simulator.view(*IN_TOWN, heading))
    frame = assessed_database.parameters.frame
    seen = extract_landmarks(cut(map_labels, frame, View(*IN_TOWN, heading, 1.0, 250, 250)), (1, 2, 3), 20.0)
    seen = seen.select(~seen.touches_edge)
    apart = np.hypot(*(centers[:, None] - seen.centers_xy[None]).transpose(2, 0, 1))
    # Boxes decide which landmarks at the border are whole, not pixels.
    inner, seen_inner = (np.abs(xy - 125).max(axis=1) < 110 for xy in (centers, seen.centers_xy))
    seen_inner &= seen.areas_px > 40
    # Neighbors one pixel apart can merge in some turned images.
    assert (apart[inner].min(axis=1) < 1.0).mean() > 0.85 and (apart[:, seen_inner].min(axis=0) < 1.0).mean() > 0.85
    assert inner.sum() > 15 and len(found) == len(centers)


def test_without_noise_an_image_is_found_where_it_is(assessed_database, localizer):
    simulator = ImageSimulator(localizer, assessed_database, FOOTPRINT)
    query = Query(simulator.view(*IN_TOWN, 77.0))
    trial = simulator.constellation(query, np.random.default_rng(1))
    assert trial.is_right and trial.error < 0.5 and trial.landmarks > 20 and trial.query is query


def test_the_noise_is_what_is_asked_for(assessed_database, localizer):
    rng = np.random.default_rng(3)
    simulator = ImageSimulator(localizer, assessed_database, FOOTPRINT)
    query = Query(simulator.view(*IN_TOWN, 0.0), noise=LabelNoise(missed=0.5))
    counts = [simulator.landmarks(query, rng) for _ in range(40)]
    # Landmarks too small for the catalogue are added, a third as many.
    share = np.mean([len(seen) / on_map for seen, on_map in counts])
    assert share == pytest.approx(0.5 + 0.35, abs=0.08)


@pytest.mark.parametrize("footprint", [0.0, -5.0, 1e6, float("nan"), float("inf")])
def test_an_invalid_footprint_is_refused(assessed_database, localizer, footprint):
    with pytest.raises(ParameterError, match="The footprint width is"):
        ImageSimulator(localizer, assessed_database, footprint)


def test_a_database_without_landmarks_is_refused(assessed_database):
    references = MapLandmarks(np.empty((0, 2)), np.empty(0, np.uint8), np.empty(0), np.empty(0, bool))
    empty = replace(assessed_database, references=references)
    with pytest.raises(DatabaseError, match="no landmark"):
        ImageSimulator(Localizer(empty), empty, FOOTPRINT)


def test_a_footprint_beyond_the_scales_searched_is_known(assessed_database, localizer):
    assert ImageSimulator(localizer, assessed_database, FOOTPRINT).is_searched
    assert not ImageSimulator(localizer, assessed_database, 2.6 * FOOTPRINT).is_searched


def test_map_correlation_is_tried_on_the_overview(built):
    rng = np.random.default_rng(2)
    patches = np.kron(rng.choice([1, 2, 4], (15, 25)), np.ones((40, 40))).astype(np.uint8)
    database = built(patches)
    simulator = ImageSimulator(Localizer(database), database, FOOTPRINT)
    trial = simulator.correlation(Query(simulator.view(600400.0, 5199700.0, 33.0)), np.random.default_rng(1))
    assert trial.is_right and trial.method == trial.result.method == "map correlation"


def test_a_small_image_shows_class_areas_finer_than_the_overview(built):
    rng = np.random.default_rng(2)
    database = built(np.kron(rng.choice([1, 2, 4], (25, 41)), np.ones((24, 24))).astype(np.uint8))
    simulator = ImageSimulator(Localizer(database), database, 120.0)
    places = rng.uniform((600200, 5199600), (600800, 5199900), (12, 2))
    queries = [Query(simulator.view(*place, rng.uniform(0, 360))) for place in places]
    assert all(simulator.correlation(query, rng).is_right for query in queries)
