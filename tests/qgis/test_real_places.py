"""Places that networks for photos are trained on and flown over, and the page of a network's card."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

TOOLS = Path(__file__).resolve().parents[2] / "tools"


@pytest.fixture(scope="module", autouse=True)
def tools():
    """tools/ can be imported from, as its commands do."""
    sys.path.append(str(TOOLS))
    yield
    sys.path.remove(str(TOOLS))


@pytest.mark.parametrize("part", [(0.0, 0.5), (0.5, 1.0)])
def test_crops_of_a_half_show_nothing_of_the_other(part):
    from bench import real_places

    blocks = np.random.default_rng(5).integers(1, 3, (20, 30))
    labels = np.kron(blocks, np.ones((30, 30))).astype(np.uint8)
    place = real_places.PlaceGround(labels, np.zeros((600, 900, 3), np.uint8), part)
    images = place.images(256, 8, np.random.default_rng(3))
    assert len(images) == 8
    for image in images:
        across = image.view.footprint * np.sqrt(0.5)
        turned = np.radians(45 + image.view.heading_deg + 90 * np.arange(4))
        columns = place.ground.frame.to_pixels(image.view.position)[0] + across * np.sin(turned)
        assert columns.min() >= part[0] * 900 - 1 and columns.max() <= part[1] * 900 + 1


def test_a_place_without_room_has_no_crops():
    from bench import real_places

    place = real_places.PlaceGround(np.ones((300, 300), np.uint8), np.zeros((300, 300, 3), np.uint8), (0.0, 1.0))
    assert place.images(256, 3, np.random.default_rng(0)) == []


def test_the_places_left_out_cover_all_that_is_trained_on():
    from bench import photo_places

    photos = [photo for place in photo_places.PLACES for photo in place.photos]
    assert len({photo.name for photo in photos}) == len(photos) == 13
    halves = sorted(photo.part for photo in photos if photo.image.startswith("banepa"))
    assert halves == [(0.0, 0.5), (0.5, 1.0)]
    table = photo_places.class_table(photo_places.BUILDINGS).splitlines()
    assert [row.split(",")[:2] for row in table] == [["value", "name"], ["1", "building"]]


def test_the_page_of_a_card_has_what_the_card_has():
    from training.card_page import card_page

    from semref.core.segmentation.model_card import Ground, ModelCard

    tested = (Ground("Kenya", "flats", True, {"building": 0.612}),)
    card = ModelCard("a/houses.onnx", None, "Houses", ("other", "building"), 0.25, tested_on=tested, not_for="ships")
    page = card_page(card)
    assert page.startswith("# Houses\n\n`houses.onnx`\n")
    for line in ("| classes | other, building |", "| trained at | 0.25 m a pixel |", "| not good for | ships |"):
        assert line in page
    assert "| Kenya, left out of training | 0.612 |" in page and "license" not in page
