"""Model cards, also with invalid content."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from made_models import smallest_model

from semref.core.segmentation.model_card import KEY, card_of_texts, read_card
from semref.core.segmentation.onnx_file import with_metadata

TOLD = {
    "name": "Houses of two towns",
    "date": "2026-11-22",
    "trained_on": [{"place": "one town", "about": "old", "classes": ["building"]}, {"place": "another"}],
    "tested_on": [
        {"place": "a third", "how": "left out", "iou": {"building": 0.6}},
        {"place": "one town", "how": "set aside", "iou": {"building": 0.8}},
    ],
    "good_for": "houses",
    "not_for": "ships",
    "license": "free",
    "training": {"minutes": 12.5},
}
TEXTS = {
    "class_names": '{"0": "other", "1": "building"}',
    "resolution": "25",
    "validation_iou": '{"other": 0.9, "building": 0.7}',
    "validation_confusion": "[[0.9, 0.1], [0.2, 0.8]]",
    KEY: json.dumps(TOLD),
}


def test_a_card_shows_the_metadata():
    card = card_of_texts(TEXTS, "model.onnx")
    assert (card.fault, card.name, card.classes, card.resolution_m) == (None, TOLD["name"], ("other", "building"), 0.25)
    assert [(one.place, one.about) for one in card.trained_on] == [("one town", "old"), ("another", "")]
    assert [(one.is_left_out, one.iou["building"]) for one in card.tested_on] == [(True, 0.6), (False, 0.8)]
    assert (card.good_for, card.not_for, card.license) == ("houses", "ships", "free")
    assert (card.date, card.minutes) == ("2026-11-22", 12.5)
    assert card.confusion == ((0.9, 0.1), (0.2, 0.8))


def test_the_score_is_that_of_held_out_ground_if_there_is_any():
    assert card_of_texts(TEXTS, "").mean_iou == pytest.approx(0.7)
    aside = {key: text for key, text in TEXTS.items() if key != KEY}
    assert card_of_texts(aside, "").mean_iou == pytest.approx(0.8)
    assert card_of_texts({}, "").mean_iou is None


def test_a_model_without_a_card_names_the_image_that_it_was_trained_on():
    ground = {"image": "town.tif", "labels": "houses", "date": "2026-01-02"}
    card = card_of_texts({"training_ground": json.dumps(ground)}, "")
    assert [(one.place, one.about) for one in card.trained_on] == [("town.tif", "houses")]
    assert card.date == "2026-01-02"


@pytest.mark.parametrize(
    "said",
    [
        *("", "[]", "nonsense", "{"),
        json.dumps(dict.fromkeys(TOLD, 7)),
        json.dumps({key: [None, {"place": 3}, "x"] for key in TOLD}),
        json.dumps({"training": {"minutes": True}, "tested_on": [{"place": "p", "iou": {"a": 7, "b": "x"}}]}),
    ],
)
def test_what_is_of_another_shape_is_left_out(said):
    texts = {KEY: said, "validation_iou": said, "validation_confusion": said, "training_ground": said}
    card = card_of_texts(texts, "model.onnx")
    assert (card.name, card.trained_on, card.license, card.minutes, card.mean_iou) == ("", (), "", None, None)
    assert all(not one.iou for one in card.tested_on)


def test_a_file_is_read_without_running_it(tmp_path):
    path = tmp_path / "model.onnx"
    path.write_bytes(with_metadata(smallest_model(), KEY, json.dumps(TOLD)))
    assert read_card(str(path)).name == TOLD["name"]


def test_files_that_are_no_segmentation_model_are_reported_and_no_pipe_is_waited_for(tmp_path):
    os.mkfifo(tmp_path / "pipe.onnx")
    (tmp_path / "folder.onnx").mkdir()
    (tmp_path / "loop.onnx").symlink_to(tmp_path / "loop.onnx")
    (tmp_path / "empty.onnx").write_bytes(b"")
    (tmp_path / "text.onnx").write_bytes(b"no model")
    for name in ("missing", "pipe", "folder", "loop", "empty", "text"):
        fault = str(read_card(str(tmp_path / f"{name}.onnx")).fault)
        assert ("is not an ONNX model" if name in ("empty", "text") else "does not exist; choose") in fault
    assert "model of type Detector" in str(card_of_texts({"model_type": "Detector"}, "").fault)


@pytest.mark.parametrize(
    "entry",
    [
        b"\xff\xff",
        # Key and text are numbers.
        b"\x08\xff\xff\xff\xff\xff\xff\xff\xff\x7f\x10\xff\xff\xff\xff\xff\xff\xff\xff\x7f",
    ],
)
def test_a_damaged_metadata_entry_is_skipped_and_leaves_the_others(entry, tmp_path):
    path = Path(tmp_path / "model.onnx")
    path.write_bytes(smallest_model() + bytes([14 << 3 | 2, len(entry)]) + entry)
    assert read_card(str(path)).fault is None
    path.write_bytes(with_metadata(path.read_bytes(), KEY, json.dumps(TOLD)))
    assert read_card(str(path)).name == TOLD["name"]
