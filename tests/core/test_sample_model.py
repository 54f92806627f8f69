from pathlib import Path

import cv2
import numpy as np
import pytest
import shapely

pytest.importorskip("onnxruntime")

from sample import landscape, photo
from sample.classes import CLASSES
from semref.core.labels.image_source import ArrayImage
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.model_card import read_card
from semref.core.segmentation.photo_labels import PhotoLabels
from semref.core.segmentation.tiling import segment

ROOT = Path(__file__).parents[2]
MODEL = ROOT / "models" / "sample_area.onnx"
BUILDINGS = ROOT / "models" / "buildings.onnx"


@pytest.fixture(scope="module")
def model():
    return SegmentationModel(str(MODEL), 1)


def drawn_area():
    """Return (class value, draw order, polygon) of a meadow with fields, forest, a lake, a gravel pit and 24 houses."""
    box = shapely.box
    drawn = [(6, 10, box(0, 0, 400, 400)), (5, 10, box(0, 0, 200, 150)), (5, 10, box(205, 0, 400, 150))]
    drawn += [(4, 30, box(0, 250, 180, 400)), (3, 50, shapely.Point(320, 320).buffer(50))]
    drawn += [(2, 40, shapely.Point(60, 75).buffer(30))]
    return drawn + [(1, 60, box(x, y, x + 14, y + 10)) for x in range(210, 390, 24) for y in (170, 195, 220)]


def test_the_model_is_small_and_has_the_classes_of_the_sample(model):
    assert MODEL.stat().st_size < 3_000_000
    assert [(c.value, c.name, c.color, c.role) for c in model.classes.table] == [
        (c.value, c.name, c.color, c.role) for c in CLASSES
    ]
    assert model.settings.resolution_m == 1.0
    assert model.tile_hw == (512, 512)
    assert model.notes == []


def test_it_sees_what_a_photo_of_a_made_up_area_shows(model):
    features = tuple(landscape.Feature(*row) for row in drawn_area())
    area = landscape.Landscape(features, shapely.Polygon(), (0.0, 0.0, 400.0, 400.0), 25832, 77)
    picture = photo.render(area)
    ordered = sorted(features, key=lambda feature: feature.zorder)
    truth = photo.draw_scene(ordered, area).kind
    found = [rows for _, rows in segment(model, ArrayImage(picture), model.classes.values, 0.15)]
    labels = np.concatenate([rows.labels_hw for rows in found if rows is not None])
    assert (labels == truth).mean() > 0.7
    for value in (1, 2, 3, 4):
        both, either = ((labels == value) & (truth == value)).sum(), ((labels == value) | (truth == value)).sum()
        assert both / either > 0.4, f"class {value}"


def test_what_is_moved_in_a_tile_is_seen_moved_by_as_much(model):
    edge, moved, margin = 512, 64, 192
    photo_hw3 = np.random.default_rng(1671).integers(0, 256, (edge, edge, 3), np.uint8)
    here = model.scores([photo_hw3])[0]
    there = model.scores([np.ascontiguousarray(np.roll(photo_hw3, moved, (0, 1)))])[0]
    inside, before = slice(margin + moved, edge - margin + moved), slice(margin, edge - margin)
    # The border of the tile affects all pixels slightly, through means over the whole tile.
    assert np.abs(there[:, inside, inside] - here[:, before, before]).max() < 0.02 * here.std()


def test_the_model_of_buildings_is_small_and_states_its_license_and_results():
    card = read_card(str(BUILDINGS))
    assert card.can_be_base and BUILDINGS.stat().st_size < 8_000_000
    assert "CC BY 4.0" in card.license and "OpenStreetMap" in card.license and "OpenAerialMap" in card.license
    halves = {"West half of Banepa in Nepal", "East half of Banepa in Nepal"}
    assert {one.place for one in card.trained_on} == {*halves, "Nepal near Banepa", "Uganda", "Kenya"}
    assert all(one.is_left_out and one.iou["building"] > 0.3 for one in card.tested_on) and len(card.tested_on) >= 3


@pytest.mark.real_data
def test_the_model_of_buildings_finds_buildings_in_a_drone_photo(real_data):
    path = real_data("oam_buildings/uganda_1.tif")
    model = SegmentationModel(str(BUILDINGS), 1)
    assert (model.classes.names, model.settings.resolution_m) == (("other", "building"), 0.25)
    photo = cv2.resize(cv2.imread(str(path))[:, :, ::-1], None, fx=0.4, fy=0.4, interpolation=cv2.INTER_AREA)
    labels = PhotoLabels(model, ArrayImage(np.ascontiguousarray(photo)), (2, 1)).found()
    assert 0.05 < (labels == 1).mean() < 0.5
