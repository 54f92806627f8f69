"""Inputs made by hypothesis are read correctly or refused in one sentence."""

import dataclasses
import json
from unicodedata import category

import numpy as np
import pytest

from semref.core.database.parameters import BuildParameters, build_parameters
from semref.core.errors import ClassTableError, DatabaseError, ModelError, SemRefError
from semref.core.labels.class_table import ClassTable, LandCoverClass, class_table_from_csv
from semref.core.segmentation.metadata import read_classes, read_settings
from semref.core.values import read_json

hypothesis = pytest.importorskip("hypothesis")
strategies = hypothesis.strategies
seeded = hypothesis.settings(derandomize=True, database=None, deadline=None, max_examples=40)

JSON = strategies.recursive(
    strategies.none()
    | strategies.booleans()
    | strategies.integers()
    | strategies.floats()
    | strategies.text(max_size=9),
    lambda inner: strategies.lists(inner, max_size=7) | strategies.dictionaries(strategies.text(max_size=5), inner),
    max_leaves=9,
)
CELLS = strategies.text(strategies.characters(codec="utf-8", exclude_characters="\0\r\n"), max_size=12)
KEYS = ("model_type", "class_names", "resolution", "tile_size", "tiles_overlap", "standardization_std", "class_values")
GOOD = {
    "crs": 'PROJCS["x"]',
    "geotransform": [600000.0, 2.0, 0.0, 5200000.0, 0.0, -2.0],
    **dict.fromkeys(("map_width_px", "map_height_px"), 400),
    **dict.fromkeys(("pixel_size", "window_size", "stride", "minimum_area"), 2.0),
    "levels": [1.0],
    "references_per_vector": 10,
    "overview_factor": 4,
    "format_version": 1,
    **dict.fromkeys(("map_hash", "class_table_hash", "plugin_version"), "x"),
}


def require_one_sentence(error: SemRefError) -> None:
    text = str(error)
    assert text and len(text) < 3000 and text.encode("utf-8")
    # Spaces of any width are ordinary characters here.
    assert all(sign.isprintable() or category(sign) == "Zs" for sign in text)


@pytest.mark.slow
@seeded
@hypothesis.given(strategies.lists(strategies.lists(CELLS, min_size=1, max_size=5), max_size=4))
def test_a_table_of_any_cells_is_a_class_table_or_one_sentence(rows):
    text = "value,name,color,role,draw_order\n" + "\n".join(",".join(row) for row in rows)
    try:
        table = class_table_from_csv(text)
    except ClassTableError as error:
        require_one_sentence(error)
    else:
        assert class_table_from_csv(table.to_csv()) == table


VALUES = strategies.integers(1, 255)
NAMES = strategies.text(strategies.characters(codec="utf-8", categories=("L", "N", "P", "S")), min_size=1, max_size=30)


@pytest.mark.slow
@seeded
@hypothesis.given(strategies.dictionaries(VALUES, NAMES, min_size=1, max_size=6))
def test_every_class_table_comes_back_from_its_csv(names):
    hypothesis.assume(len(set(names.values())) == len(names))
    table = ClassTable(tuple(LandCoverClass(value, name, "#112233") for value, name in names.items()))
    assert class_table_from_csv(table.to_csv()) == table


@seeded
@hypothesis.given(strategies.sampled_from([item.name for item in dataclasses.fields(BuildParameters)]), JSON)
def test_any_value_of_a_parameter_is_one_that_a_map_can_have_or_refused(name, value):
    try:
        stored = read_json(json.dumps({**GOOD, name: value}))
        found = build_parameters(stored, "x.gpkg")
    except (KeyError, ValueError, TypeError, DatabaseError):
        # Readers of files turn the first three into sentences.
        return
    assert np.isfinite([*found.extent, *found.levels, found.stride]).all() and min(found.overview_frame.shape_hw) > 0


@seeded
@hypothesis.given(strategies.dictionaries(strategies.sampled_from(KEYS), JSON.map(json.dumps) | CELLS), VALUES)
def test_any_metadata_of_a_network_are_settings_and_classes_or_one_sentence(texts, channels):
    try:
        settings = read_settings(texts, "x.onnx")
        classes = read_classes(texts, channels, "x.onnx")
    except ModelError as error:
        require_one_sentence(error)
    else:
        assert min(settings.std) > 0 and len(classes.values) == channels
