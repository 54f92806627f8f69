import json

import pytest

from semref.core.errors import ModelError
from semref.core.labels.class_table import class_table_from_csv
from semref.core.segmentation.metadata import named_channels, read_classes, read_settings

NAMES = '{"0": "building", "1": "water"}'


def values_of(texts, channels=2, given=None):
    return read_classes(texts, channels, "m.onnx", given).values


def test_a_model_without_metadata_has_the_defaults():
    found = read_settings({}, "m.onnx")
    assert (found.resolution_m, found.tile_size_px, found.overlap, found.threshold) == (None, None, 0.2, 0.5)
    assert (found.mean, found.std) == ((0, 0, 0), (1, 1, 1))


def test_the_keys_of_deepness_are_read():
    texts = {
        "model_type": '"Segmentor"',
        "resolution": "20.5",
        "tile_size": "256",
        "tiles_overlap": "40",
        "seg_thresh": "0.7",
        "standardization_mean": "[0.4, 0.5, 0.6]",
        "standardization_std": "[0.1, 0.2, 0.3]",
    }
    found = read_settings(texts, "m.onnx")
    assert (found.resolution_m, found.tile_size_px, found.overlap) == (0.205, 256, 0.4)
    assert (found.mean, found.std, found.threshold) == ((0.4, 0.5, 0.6), (0.1, 0.2, 0.3), 0.7)


def test_the_temperature_is_stated_or_unknown():
    assert read_settings({"temperature": "1.5"}, "m.onnx").temperature == 1.5
    assert read_settings({}, "m.onnx").temperature is None


@pytest.mark.parametrize("text", [NAMES, "{0: 'building', 1: 'water'}", '["building", "water"]'])
def test_class_names_may_be_json_or_python(text):
    assert read_classes({"class_names": text}, 2, "m.onnx").names == ("building", "water")


def test_class_names_follow_their_numbers_not_their_order():
    texts = {"class_names": json.dumps({str(n): f"c{n}" for n in (10, *range(10))})}
    assert read_classes(texts, 11, "m.onnx").names == tuple(f"c{n}" for n in range(11))


@pytest.mark.parametrize(
    ("names", "first"),
    [("building water", 1), ("background water", 0), ("Unlabeled water", 0), ("water background", 1)],
)
def test_a_background_in_front_is_0(names, first):
    found = read_classes({"class_names": json.dumps(names.split())}, 2, "m.onnx")
    assert found.values == (first, first + 1)
    assert [c.value for c in found.table] == [v for v in found.values if v]


def test_our_own_keys_give_values_colors_and_roles():
    texts = {
        "class_names": NAMES,
        "class_values": "[9, 4]",
        "class_colors": '["#010203", "#040506"]',
        "class_roles": '["reference", "background"]',
    }
    table = read_classes(texts, 2, "m.onnx").table
    assert [(c.value, c.name, c.color, c.role) for c in table] == [
        (4, "water", "#040506", "background"),
        (9, "building", "#010203", "reference"),
    ]


@pytest.mark.parametrize("names", ['{"0": "building"}', '{"0": "background", "1": "building"}'])
def test_a_single_probability_is_of_the_class_beside_the_background(names):
    found = read_classes({"class_names": names}, 2, "m.onnx")
    assert (found.names, found.values) == (("background", "building"), (0, 1))


def test_a_given_table_overrides_the_metadata_by_name():
    given = class_table_from_csv("value,name,color,role\n7,Water,#0000ff,reference\n3,building,#ff0000,background\n")
    found = read_classes({"class_names": NAMES, "class_values": "[1, 2]"}, 2, "m.onnx", given)
    assert found.values == (3, 7)
    assert [c.role for c in found.table] == ["background", "reference"]


def test_channels_are_mapped_to_a_database_by_name_and_unknown_reference_classes_refused():
    classes = read_classes({"class_names": '["Building", "water", "snow"]'}, 3, "m.onnx")
    database = class_table_from_csv("value,name,role\n4,water,reference\n6,building,reference\n7,field,background\n")
    assert classes.values_in(database, "m.onnx") == (6, 4, 0)
    classes = read_classes({"class_names": NAMES}, 2, "m.onnx")
    database = class_table_from_csv("value,name,role\n4,bare_land,reference\n6,building,reference\n")
    with pytest.raises(
        ModelError, match="m.onnx was not trained on the database's class bare_land, only on building, water"
    ):
        classes.values_in(database, "m.onnx")


@pytest.mark.parametrize(
    ("texts", "message"),
    [
        ({"model_type": '"Detector"'}, "model of type Detector"),
        *(({"resolution": text}, f"“{text}” as resolution") for text in ("fine", "-3", "NaN")),
        ({"tile_size": "[512]"}, "as tile_size"),
        ({"tiles_overlap": "100"}, "number from 0 to 75"),
        ({"temperature": "0"}, "number from 0.01 to 100"),
        ({"standardization_mean": "[0.5]"}, "list of three numbers"),
        ({"standardization_std": "[0.5, 0.0, 0.5]"}, "above 0"),
    ],
)
def test_impossible_settings_are_refused_with_their_key(texts, message):
    with pytest.raises(ModelError, match=message):
        read_settings(texts, "m.onnx")


@pytest.mark.parametrize(
    ("texts", "channels", "message"),
    [
        ({}, 3, "does not name its classes"),
        ({"class_names": NAMES}, 3, "outputs 3 classes, but its metadata"),
        ({"class_names": '{"0": "a", "2": "b"}'}, 2, "one entry for each output"),
        ({"class_names": "building"}, 2, "one entry for each output"),
        ({"class_names": '["a", "a"]'}, 2, "the name a more than once"),
        ({"class_names": NAMES, "class_values": "[1]"}, 2, "class_values"),
        ({"class_names": NAMES, "class_values": "[1, 999]"}, 2, "999 in class_values"),
        ({"class_names": NAMES, "class_values": "[1, 1]"}, 2, "the value 1 more than once"),
        ({"class_names": NAMES, "class_colors": '["red", "blue"]'}, 2, "color “red”"),
    ],
)
def test_impossible_classes_are_refused(texts, channels, message):
    with pytest.raises(ModelError, match=message):
        values_of(texts, channels)


def test_a_table_without_one_of_the_classes_is_refused():
    with pytest.raises(ModelError, match="class table has no class water"):
        values_of({"class_names": NAMES}, 2, class_table_from_csv("value,name\n1,building\n"))


def test_half_a_character_in_a_name_is_replaced_as_it_can_t_be_written():
    assert named_channels({"class_names": r'["\ud800road", "b"]'}, "model") == ["?road", "b"]
