"""Parts of an image that disagree with its position."""

from __future__ import annotations

import numpy as np
import pytest
from made_patches import FRAME, MODEST, PRIOR, STRONG, error_m, made_map, spoiled, view

from semref.core.correlation.class_pyramid import MapPyramid
from semref.core.correlation.solver import localize, part_against
from semref.core.labels.overview import most_frequent_labels

HERE, ELSEWHERE = (1300.0, 1000.0), (2000.0, 1450.0)
PARTS = {"left": np.s_[:, :175], "right": np.s_[:, 385:], "upper": np.s_[:175], "lower": np.s_[385:]}


@pytest.fixture(scope="module")
def labels():
    return made_map(1)


@pytest.fixture(scope="module")
def pyramid(labels):
    return MapPyramid(most_frequent_labels(labels), FRAME)


@pytest.mark.slow
@pytest.mark.parametrize("name", PARTS)
@pytest.mark.parametrize("noise", [None, MODEST])
def test_the_part_that_shows_another_place_is_named(labels, pyramid, name, noise):
    image = view(labels, HERE, 40, 1.0)
    image[PARTS[name]] = view(labels, ELSEWHERE, 40, 1.0)[PARTS[name]]
    found = localize(image if noise is None else spoiled(image, noise, 7), pyramid, PRIOR)
    assert found.is_fix and error_m(found.best, HERE) < 10
    assert str(found.reason).startswith(f"In the {name} part of the image, classes hardly match the map")
    values = dict(found.reason.values)
    assert values["agreement"] < 0.5 * values["whole"]


@pytest.mark.slow
@pytest.mark.parametrize("noise", [None, MODEST, STRONG])
@pytest.mark.parametrize("center", [HERE, ELSEWHERE, (700.0, 1200.0)])
def test_an_image_of_one_place_agrees_in_all_its_parts(labels, pyramid, noise, center):
    image = view(labels, center, 75, 1.1)
    found = localize(image if noise is None else spoiled(image, noise, 3), pyramid, PRIOR)
    assert found.is_fix and found.reason is None


def test_a_place_of_another_method_is_compared_part_by_part_too(labels, pyramid):
    image = view(labels, HERE, 40, 1.0)
    place = localize(image, pyramid, PRIOR).best
    assert part_against(image, pyramid, place) is None
    image[PARTS["lower"]] = view(labels, ELSEWHERE, 40, 1.0)[PARTS["lower"]]
    assert dict(part_against(image, pyramid, place).values)["part"].template == "lower part"
