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


@pytest.mark.parametrize("part", [(0.0, 0.5), (0.5, 1.0)])
def test_strips_of_a_half_show_nothing_of_the_other(part, monkeypatch):
    from bench import real_flights, real_places

    from semref.core.simulation.views import map_coordinates

    monkeypatch.setattr(real_flights, "EDGE_PX", 96)
    blocks = np.random.default_rng(5).integers(1, 3, (20, 30))
    labels = np.kron(blocks, np.ones((30, 30))).astype(np.uint8)
    place = real_places.PlaceGround(labels, np.full((600, 900, 3), 99, np.uint8), part)
    strips = real_flights.Strips(place.ground, place.picture, place.part)
    rng = np.random.default_rng(3)
    for _ in range(4):
        strip = real_flights._strip(strips, rng)
        assert len(strip.views) == len(strip.photos) == 6
        for view in strip.views:
            corners = map_coordinates(view, np.array([0, 96, 0, 96]), np.array([0, 0, 96, 96]))
            columns = place.ground.frame.to_pixels(np.column_stack(corners))[:, 0]
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


def test_networks_are_found_by_the_places_and_tiles_left_out(tmp_path):
    from bench import real_places, real_tiles

    names = ("buildings_without_kenya", "buildings_without_uganda_and_nepal_a", "without_tile4", "without_tiles25")
    for name in names:
        (tmp_path / f"{name}.onnx").touch()
    assert [path.stem for path in real_places.without(tmp_path, "nepal_a")] == ["buildings_without_uganda_and_nepal_a"]
    assert real_places.without(tmp_path, "nepal") == []
    assert {n: path.stem for n, path in real_tiles.networks(tmp_path).items()} == {
        4: "without_tile4",
        2: "without_tiles25",
        5: "without_tiles25",
    }


def test_ground_is_own_left_out_or_foreign_to_a_network():
    from bench.foreign_ground import FOREIGN, LEFT_OUT, OWN, kind_of

    assert kind_of("without_tile4", "dubai4") == LEFT_OUT and kind_of("without_tile4", "dubai3") == OWN
    assert kind_of("without_tiles25", "dubai5") == LEFT_OUT and kind_of("without_tile4", "banepa_west") == FOREIGN
    assert kind_of("buildings_without_kenya", "kenya") == LEFT_OUT and kind_of("buildings", "dubai1") == FOREIGN
    assert kind_of("buildings_without_kenya", "uganda") == OWN == kind_of("sample_area", "sample")


def test_indices_tell_water_wetland_vegetation_and_ripe_fields_apart():
    from bench import infrared_map as tried

    colors = {
        tried.WATER: (60, 90, 60, 40),
        tried.WETLAND: (90, 110, 80, 100),
        tried.VEGETATION: (70, 110, 80, 200),
        tried.GROUND: (190, 190, 140, 200),
    }
    bands = np.zeros((4, 40, 160), np.uint8)
    for number, color in enumerate(colors.values()):
        bands[:, :, 40 * number : 40 * number + 40] = np.array(color)[:, None, None]
    found = tried.labels_of(bands)
    assert [int(found[20, 40 * n + 20]) for n in range(4)] == list(colors)


def test_parting_and_joining_change_buildings_alone():
    from bench import groups

    labels = np.full((80, 120), groups.OTHER, np.uint8)
    labels[20:50, 20:50] = labels[20:50, 56:90] = groups.BUILDING
    labels[:5] = 0
    joined, parted = groups.closed(labels, 4), groups.opened(groups.closed(labels, 4), 4)
    assert joined[35, 53] == groups.BUILDING and labels[35, 53] == groups.OTHER
    assert (joined[:5] == 0).all() and (parted == joined).mean() > 0.95
