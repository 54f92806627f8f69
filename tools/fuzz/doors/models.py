"""Networks: their metadata, and whole ONNX files."""

from __future__ import annotations

import json
from random import Random
from typing import Any

import numpy as np

from ..contract import World, require
from ..door import Door, Placed, Tools
from ..mutations import json_bytes, mutated_bytes, mutated_json, one_of, word

_LITERALS = (
    "{(1,):2}",
    "{1:2,1:3}",
    "[" * 900,
    "(" * 101,
    "1+1j",
    "__import__('os')",
    "b'x'",
    "{1,2}",
    "-" * 5000 + "1",
)


def _values() -> dict[str, Any]:
    return {
        "model_type": "Segmentor",
        "class_names": {"0": "building", "1": "water", "2": "bare_land"},
        "resolution": 20,
        "tile_size": 64,
        "tiles_overlap": 25,
        "seg_thresh": 0.5,
        "standardization_mean": [0.5, 0.5, 0.5],
        "standardization_std": [0.5, 0.5, 0.5],
        "class_values": [1, 2, 3],
        "class_colors": ["#ff0000", "#00ff00", "#0000ff"],
        "class_roles": ["reference", "reference", "background"],
        "class_bias": {"building": {"east": -0.1, "north": 0.6, "spread": 0.4, "sun": 180}},
    }


def changed_metadata(random: Random) -> dict[str, str]:
    """Metadata by key, with values, keys and texts changed."""
    values = _values()
    for _ in range(random.choice((1, 1, 2, 3))):
        key = random.choice(list(values))
        kind = random.randrange(5)
        if kind == 0:
            values[random.choice((key, "names", "tiles_size", word(random)))] = values.pop(key)
        elif kind == 1 and len(values) > 1:
            del values[key]
        else:
            values[key] = mutated_json(random, values[key])
    texts = {key: json_bytes(random, value).decode("utf-8", "replace") for key, value in values.items()}
    if random.random() < 0.3:
        texts[random.choice(list(texts))] = random.choice((random.choice(_LITERALS), word(random)))
    return texts


def metadata(world: World) -> Tools:
    from semref.core.segmentation.class_bias import LARGEST_M, read_class_bias
    from semref.core.segmentation.metadata import read_classes, read_settings

    def attempt(made: Any) -> None:
        texts, channels = made
        settings = read_settings(texts, "x.onnx")
        require(np.isfinite([*settings.mean, *settings.std, settings.overlap, settings.threshold]).all(), "no numbers")
        require(settings.resolution_m is None or 0 < settings.resolution_m < 1e6, "a resolution that is none")
        require(settings.tile_size_px is None or settings.tile_size_px > 0, "a tile without pixels")
        classes = read_classes(texts, channels, "x.onnx")
        require(len(classes.names) == len(classes.values) == channels, "classes for other channels")
        require(all(0 <= value <= 255 for value in classes.values), "a class value that is none")
        for bias in read_class_bias(texts, classes.names, "x.onnx").values():
            require(bias.length <= 4 * LARGEST_M and 0 <= (bias.spread or 0.0) <= LARGEST_M, "a bias that is none")
            require(bias.sun_deg is None or 0 <= bias.sun_deg <= 360, "a sun that is nowhere")

    return lambda random: (changed_metadata(random), random.choice((3, 3, 3, 3, 2, 4, 1))), attempt


def _fields(data: bytes) -> list[list]:
    """[key, content] of a protobuf message; raises ValueError for what is none."""
    found, place = [], 0
    while place < len(data):
        key, place = _number(data, place)
        start = place
        if key & 7 == 0:
            _, place = _number(data, place)
        elif key & 7 in (1, 5):
            place += 8 if key & 7 == 1 else 4
        elif key & 7 == 2:
            length, start = _number(data, place)
            place = start + length
        else:
            raise ValueError
        if place > len(data) or key < 8:
            raise ValueError
        found.append([key, data[start:place]])
    return found


def _number(data: bytes, place: int) -> tuple:
    value = 0
    for shift in range(0, 70, 7):
        if place >= len(data):
            raise ValueError
        value |= (data[place] & 127) << shift
        place += 1
        if data[place - 1] < 128:
            return value, place
    raise ValueError


def _written(value: int) -> bytes:
    found = bytearray()
    while value > 127:
        found.append(value & 127 | 128)
        value >>= 7
    return bytes([*found, value])


def mutated_message(random: Random, data: bytes, depth: int = 0) -> bytes:
    """A protobuf message with one of its fields changed, however deep; lengths are right."""
    try:
        fields = _fields(data)
    except ValueError:
        fields = []
    if not fields:
        return mutated_bytes(random, data, most=2)
    field, kind = random.choice(fields), random.randrange(8)
    if kind <= 3 and field[0] & 7 == 2 and depth < 9:
        field[1] = mutated_message(random, field[1], depth + 1)
    elif kind == 4:
        fields.remove(field)
    elif kind == 5:
        fields.insert(random.randrange(len(fields) + 1), list(field))
    elif field[0] & 7 == 0:
        field[1] = _written(random.choice((0, 1, 2, 3, 7, 11, 16, 99, 2**20, 2**31, 2**62, 2**64 - 1)))
    elif field[0] & 7 == 2:
        field[1] = mutated_bytes(random, field[1], [b"../x", b"location"], 2)
    return b"".join(
        _written(key) + (_written(len(content)) if key & 7 == 2 else b"") + content for key, content in fields
    )


def networks(world: World) -> Tools:
    from made_models import brightest_color, metadata, writer

    from semref.core.segmentation.model import SegmentationModel

    shapes = {"input_shape": (1, 3, "h", "w"), "output_shape": (1, "c", "h", "w")}
    small = {"tile_size": 16}
    samples = [
        writer.model_bytes(brightest_color(), metadata=metadata(**small), **shapes),
        writer.model_bytes(brightest_color(3), metadata=metadata(**small), **shapes),
        writer.model_bytes(brightest_color(external="w"), metadata=metadata(**small), **shapes),
    ]
    placed = Placed(world.folder, "model.onnx")

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            model = SegmentationModel(path, 1)
            height, width = model.tile_hw
            if height * width > 1 << 16:
                return
            scores = model.scores([np.full((height, width, 3), 90, np.uint8)])
        require(np.isfinite(scores).all() and scores.shape[2:] == (height, width), "scores that are none")

    def with_metadata(random: Random) -> bytes:
        texts = {key: text for key, text in changed_metadata(random).items() if json.dumps(text)}
        texts.setdefault("tile_size", "16")
        return writer.model_bytes(
            brightest_color(), metadata={key.replace("\ud800", ""): text for key, text in texts.items()}, **shapes
        )

    def make(random: Random) -> bytes:
        data = random.choice(samples)
        return one_of(
            random,
            lambda r: mutated_message(r, data),
            lambda r: mutated_message(r, mutated_message(r, data)),
            lambda r: mutated_bytes(r, data),
            with_metadata,
        )

    return make, attempt


DOORS = (
    Door("metadata", "metadata of networks", metadata, 70_000),
    Door("networks", "networks (ONNX files)", networks, 2_000, 500),
)
