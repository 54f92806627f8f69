"""The metadata key class_bias: reading, writing, a database's classes, and another position of the sun."""

import json

import pytest
from made_models import smallest_model

from semref.core.errors import ModelError
from semref.core.geometry.error_settings import NETWORK_SPREAD, ClassBias, SharedErrors
from semref.core.labels.class_table import class_table_from_csv
from semref.core.segmentation.class_bias import class_bias_text, known_biases, read_class_bias
from semref.core.segmentation.onnx_file import read_metadata, with_metadata

NAMES = ("background", "building", "water")
TABLE = class_table_from_csv(
    "value,name,color,role\n4,Building,#ff0000,reference\n7,water,#0000ff,reference\n9,field,#00ff00,background"
)
STATED = {"building": ClassBias(0, east=-0.13, north=0.6, spread=0.35, sun_deg=150.0)}


def read(content):
    return read_class_bias(
        {"class_bias": content if isinstance(content, str) else json.dumps(content)}, NAMES, "m.onnx"
    )


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
        read(content)


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
    assert read_metadata(data) == {"class_bias": text, "class_names": "kept"}
    assert changed.graph == old.graph and changed.opset_import == old.opset_import
