"""The shipped model of buildings is small, states its license and places, and finds buildings in a drone photo."""

import os
from pathlib import Path

import cv2
import numpy as np
import pytest

pytest.importorskip("onnxruntime")

from semref.core.labels.image_source import ArrayImage
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.model_card import read_card
from semref.core.segmentation.photo_labels import PhotoLabels

ROOT = Path(__file__).parents[2]
MODEL = ROOT / "models" / "buildings.onnx"
DATA = Path(os.environ.get("SEMREF_DATA") or ROOT.parent / "shared" / "data")


def test_the_model_is_small_and_states_its_license_and_results():
    card = read_card(str(MODEL))
    assert MODEL.stat().st_size < 8_000_000
    assert "CC BY 4.0" in card.license and "OpenStreetMap" in card.license and "OpenAerialMap" in card.license
    assert {one.place for one in card.trained_on} == {"banepa_west", "banepa_east", "uganda", "nepal_a", "kenya"}
    assert all(one.is_left_out and one.iou["building"] > 0.3 for one in card.tested_on) and len(card.tested_on) >= 3
    assert card.can_be_base


def test_the_model_finds_buildings_in_a_drone_photo():
    path = DATA / "oam_buildings" / "uganda_1.tif"
    if not path.exists():
        pytest.skip(f"{path.name} is not here")
    model = SegmentationModel(str(MODEL), 1)
    assert (model.classes.names, model.settings.resolution_m) == (("other", "building"), 0.25)
    photo = cv2.resize(cv2.imread(str(path))[:, :, ::-1], None, fx=0.4, fy=0.4, interpolation=cv2.INTER_AREA)
    labels = PhotoLabels(model, ArrayImage(np.ascontiguousarray(photo)), (2, 1)).found()
    assert 0.05 < (labels == 1).mean() < 0.5
