"""The metadata key ``class_bias``: class offsets of a network, by class name.

See docs/reference/file_formats.md#segmentation-model.

Meters on the ground, JSON: ``{"building": {"east": -0.13, "north": 0.6, "spread": 0.35, "sun": 150}}``.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace

from .. import limits
from ..errors import ModelError
from ..geometry.error_settings import NETWORK_SPREAD, ClassBias, KnownBiases
from ..labels.class_table import ClassTable
from ..values import read_json

KEY = "class_bias"

_LENGTHS = ("east", "north", "right", "down", "spread")
_SUN = "sun"


def read_class_bias(texts: Mapping[str, str], names: Sequence[str] | None, source: str) -> dict[str, ClassBias]:
    """Return the class offsets in a model's metadata, by lower-case name; their class value is 0.

    Args:
        texts: The metadata by key.
        names: Of the model's classes; None to accept any name.
        source: The model's name in messages.

    Raises:
        ModelError: The entry is malformed, names another class, or has a number out of range.
    """
    if KEY not in texts:
        return {}
    try:
        found = {str(name).casefold(): _read_one(entry) for name, entry in _object(read_json(texts[KEY])).items()}
    except ValueError:
        raise _refused(texts, source) from None
    if names is not None and not set(found) <= {name.casefold() for name in names}:
        raise _refused(texts, source)
    return found


def known_biases(stated: Mapping[str, ClassBias], table: ClassTable) -> KnownBiases:
    """Return a model's offsets for a database's classes; landmark classes without one have the usual spread."""
    found = [(entry, stated.get(entry.name.casefold())) for entry in table]
    biases = tuple(replace(bias, value=entry.value) for entry, bias in found if bias is not None)
    is_whole = all(bias is not None and bias.spread is not None for entry, bias in found if entry.is_reference)
    return KnownBiases(biases, 0.0 if is_whole else NETWORK_SPREAD)


def class_bias_text(biases: Mapping[str, ClassBias]) -> str:
    """Return the metadata entry for offsets by class name."""
    return json.dumps({name: _entry(bias) for name, bias in biases.items()}, ensure_ascii=False)


def _entry(bias: ClassBias) -> dict[str, float]:
    lengths = {name: getattr(bias, name) for name in _LENGTHS}
    stated = {name: round(length, 4) for name, length in lengths.items() if length or name == "spread" and length == 0}
    return stated if bias.sun_deg is None else {**stated, _SUN: round(bias.sun_deg, 2)}


def _object(found: object) -> dict[str, object]:
    if not isinstance(found, dict):
        raise ValueError
    return found


def _read_one(entry: object) -> ClassBias:
    stated = _object(entry)
    for name, number in stated.items():
        least, most = (
            (0.0 if name == "spread" else -limits.CLASS_BIAS_M, limits.CLASS_BIAS_M)
            if name in _LENGTHS
            else (0.0, 360.0)
        )
        if name not in (*_LENGTHS, _SUN) or isinstance(number, bool) or not isinstance(number, (int, float)):
            raise ValueError
        if not least <= number <= most:
            raise ValueError
    numbers = {name: float(number) for name, number in stated.items() if isinstance(number, (int, float))}
    sun_deg = numbers.pop(_SUN, None)
    return ClassBias(0, **numbers, sun_deg=sun_deg)


def _refused(texts: Mapping[str, str], source: str) -> ModelError:
    return ModelError(
        '{source} has “{text}” as {key}. It must be JSON like {{"building": {{"east": 0.1, "spread": 0.3}}}} with '
        "names of its classes; east, north, right, down and spread in meters up to {most:g}, sun in degrees. Correct "
        "or remove it.",
        source=source,
        text=texts[KEY][: limits.NAME_CHARACTERS],
        key=KEY,
        most=limits.CLASS_BIAS_M,
    )
