import json
import os
from pathlib import Path

import pytest
from made_models import smallest_model

from semref.core.errors import ModelError
from semref.core.geometry.error_settings import NETWORK_SPREAD, ClassBias, SharedErrors
from semref.core.labels.class_table import class_table_from_csv
from semref.core.segmentation.class_bias import class_bias_text, known_biases, read_class_bias
from semref.core.segmentation.model_card import KEY, card_of_texts, read_card
from semref.core.segmentation.onnx_file import read_header, with_metadata

NAMES = ("background", "building", "water")
TABLE = class_table_from_csv(
    "value,name,color,role\n4,Building,#ff0000,reference\n7,water,#0000ff,reference\n9,field,#00ff00,background"
)
STATED = {"building": ClassBias(0, east=-0.13, north=0.6, spread=0.35, sun_deg=150.0)}


def test_what_is_written_is_read():
    assert read_class_bias({"class_bias": class_bias_text(STATED)}, NAMES, "m.onnx") == STATED
    assert read_class_bias({}, NAMES, "m.onnx") == {}


@pytest.mark.parametrize(
    "content",
    [
        "{", "[]", "1", {"road": {}}, {"building": 1}, {"building": {"up": 1}}, {"building": {"east": True}},
        {"building": {"spread": -1}}, {"building": {"east": 1e9}}, '{"building": {"east": NaN}}',
        {"building": {"sun": -1}}, {"building": {"north": "1"}},
    ],
)  # fmt: skip
def test_impossible_values_are_refused_with_their_key(content):
    with pytest.raises(ModelError, match="class_bias"):
        read_class_bias({"class_bias": content if isinstance(content, str) else json.dumps(content)}, NAMES, "m.onnx")


def test_biases_are_those_of_the_databases_classes_and_others_have_the_usual_spread():
    known = known_biases(STATED, TABLE)
    assert known.class_biases == (ClassBias(4, -0.13, 0.6, spread=0.35, sun_deg=150.0),)
    assert known.class_spread == NETWORK_SPREAD
    assert known_biases({}, TABLE).class_spread == NETWORK_SPREAD
    both = {**STATED, "water": ClassBias(0, spread=0.1)}
    assert known_biases(both, TABLE).class_spread == 0.0


def test_a_bias_turns_with_the_sun_and_without_it_is_spread():
    bias = ClassBias(4, east=1.0, north=0.0, spread=0.3, sun_deg=90.0)
    south = SharedErrors(class_biases=(bias,), sun_deg=180.0).bias_of(4)
    assert (south.east, south.north, south.spread) == pytest.approx((0.0, -1.0, 0.3))
    unknown = SharedErrors(class_biases=(bias,)).bias_of(4)
    assert (unknown.east, unknown.north) == (0.0, 0.0) and unknown.spread == pytest.approx((0.09 + 0.5) ** 0.5)


def test_metadata_of_a_file_are_set_and_all_else_stays():
    onnx = pytest.importorskip("onnx")
    old = onnx.ModelProto()
    old.ParseFromString(smallest_model())
    onnx.helper.set_model_props(old, {"class_bias": "old", "class_names": "kept"})
    text = class_bias_text({"a" * 200: ClassBias(0, east=1.0)})
    data = with_metadata(old.SerializeToString(), "class_bias", text)
    changed = onnx.load_from_string(data)
    onnx.checker.check_model(changed)
    assert {entry.key: entry.value for entry in changed.metadata_props} == {"class_bias": text, "class_names": "kept"}
    assert read_header(data).texts == {"class_bias": text, "class_names": "kept"}
    assert changed.graph == old.graph and changed.opset_import == old.opset_import


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
