"""Metadata of a segmentation model: the keys of the Deepness plugin, and SemRef's own.

See docs/reference/file_formats.md#segmentation-model.
"""

from __future__ import annotations

import ast
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .. import limits
from ..errors import ClassTableError, ModelError
from ..labels.class_colors import chosen_colors
from ..labels.class_table import BACKGROUND, MAXIMUM_VALUE, UNLABELED, ClassTable, LandCoverClass
from ..values import read_json
from .class_bias import KEY as CLASS_BIAS

DEFAULT_OVERLAP = 0.2
"""Default overlap of tiles, as a share of a tile."""

MAXIMUM_OVERLAP = 0.75
"""A larger overlap would run the network over every pixel more than sixteen times."""

DEFAULT_THRESHOLD = 0.5
"""Probability from which a pixel has the class, for networks with one output (Deepness: seg_thresh)."""

TEMPERATURE = "temperature"
"""The metadata key of the divisor of scores before the softmax that makes them probabilities of each class."""

LEAST_TEMPERATURE = 0.01
"""Scores with a smaller temperature, or larger than its inverse, are not logits."""

_KEYS = (
    *("model_type", "class_names", "names", "resolution", "tile_size", "tiles_size", "tiles_overlap", "seg_thresh"),
    *("standardization_mean", "standardization_std", "class_values", "class_colors", "class_roles"),
    *(CLASS_BIAS, TEMPERATURE),
)

BACKGROUND_NAMES = ("background", "_background", "unlabeled", "unlabelled", "other", "others", "none", "void")
"""Names of a channel 0 that is not a class."""


@dataclass(frozen=True)
class ModelClasses:
    """The classes of a model: ``names`` of its output channels, class value of each (0 if not a class), and table."""

    names: tuple[str, ...]
    values: tuple[int, ...]
    table: ClassTable

    def values_in(self, table: ClassTable, source: str) -> tuple[int, ...]:
        """Return the value in ``table`` of each channel, by name; 0 for classes that ``table`` lacks.

        Raises ModelError if a reference class of ``table`` is not among the model's. ``source``: the model's name.
        """
        own = {name.casefold() for name in self.names}
        missing = [c.name for c in table.references if c.name.casefold() not in own]
        if missing:
            raise ModelError(
                "{source} was not trained on the database's class {missing}, only on {names}; choose a model with all "
                "landmark classes of the database.",
                source=source,
                missing=missing,
                names=self.names,
            )
        found = {c.name.casefold(): c.value for c in table}
        return tuple(found.get(name.casefold(), UNLABELED) for name in self.names)


@dataclass(frozen=True)
class ModelSettings:
    """Properties of the images that a model needs, and of its outputs.

    ``resolution_m``: ground meters per pixel, None if unknown. ``tile_size_px``: None if unknown. ``overlap``: of
    tiles, as a share of a tile. ``mean``, ``std``: (red, green, blue) of pixels in 0…1. ``threshold``: probability from
    which a pixel has the class, for networks with one output. ``temperature``: converts scores to probabilities; None
    if the model does not state it.
    """

    resolution_m: float | None
    tile_size_px: int | None
    overlap: float
    mean: tuple[float, ...]
    std: tuple[float, ...]
    threshold: float
    temperature: float | None = None


def read_settings(texts: Mapping[str, str], source: str) -> ModelSettings:
    """Read settings from a model's metadata by key; values are JSON or Python literals, as in Deepness.

    ``source``: the model's name in messages. Raises ModelError with the wrong key.
    """
    for key, text in texts.items():
        if key in _KEYS and len(text) > limits.VALUE_CHARACTERS:
            raise ModelError(
                "{source} has {count} characters of metadata in {key}; at most {most} are allowed.",
                source=source,
                key=key,
                count=len(text),
                most=limits.VALUE_CHARACTERS,
            )
    kind = _literal(texts.get("model_type", "Segmentor"))
    if str(kind).casefold() != "segmentor":
        raise ModelError(
            "{source} is a model of type {kind} (metadata key model_type); choose a Segmentor.",
            source=source,
            kind=kind,
        )
    resolution_cm = _number(texts, "resolution", source, 0.001, 1e6)
    tile_size = _number(texts, "tile_size" if "tile_size" in texts else "tiles_size", source, 1, 16384)
    overlap = _number(texts, "tiles_overlap", source, 0, 100 * MAXIMUM_OVERLAP)
    threshold = _number(texts, "seg_thresh", source, 0, 1)
    return ModelSettings(
        resolution_m=None if resolution_cm is None else resolution_cm / 100,
        tile_size_px=None if tile_size is None else int(tile_size),
        overlap=DEFAULT_OVERLAP if overlap is None else overlap / 100,
        mean=_three(texts, "standardization_mean", source, 0.0),
        std=_three(texts, "standardization_std", source, 1.0),
        threshold=DEFAULT_THRESHOLD if threshold is None else threshold,
        temperature=_number(texts, TEMPERATURE, source, LEAST_TEMPERATURE, 1 / LEAST_TEMPERATURE),
    )


def named_channels(texts: Mapping[str, str], source: str) -> list[str] | None:
    """Return the class names in a model's metadata, in order of its channels; None without any. Raises ModelError."""
    key = next((key for key in ("class_names", "names") if key in texts), None)
    # JSON's escapes can contain surrogates, which can't be written to a file.
    return (
        None
        if key is None
        else [str(name).encode("utf-8", "replace").decode("utf-8") for name in _by_channel(texts, key, source)]
    )


def read_classes(texts: Mapping[str, str], channels: int, source: str, given: ClassTable | None = None) -> ModelClasses:
    """Read the classes of a model with ``channels`` classes (2 for a network with the probability of one class).

    ``given``: the user's class table, which overrides values, colors and roles. Raises ModelError.
    """
    names = named_channels(texts, source)
    is_named = names is not None
    if names is None:
        if given is None:
            raise ModelError(
                "{source} does not name its classes (metadata key class_names); choose a model that does, or segment "
                "with a class table in the order of the network’s outputs.",
                source=source,
            )
        names = [c.name for c in given if c.value != UNLABELED]
    if len(names) == channels - 1 and (channels == 2 or not is_named):
        names = [BACKGROUND_NAMES[0], *names]
    if len(names) != channels:
        raise ModelError(
            "{source} outputs {channels} classes, but its metadata (class_names) have {count} class names: {names}. "
            "Use the names from its training."
            if is_named
            else "{source} outputs {channels} classes, but the class table has {count} class names: {names}. Use the "
            "names from its training.",
            source=source,
            channels=channels,
            count=len(names),
            names=names[:12],
        )
    values, table = _classes(texts, names, source, given)
    return ModelClasses(tuple(names), values, table)


def _classes(
    texts: Mapping[str, str], names: Sequence[str], source: str, given: ClassTable | None
) -> tuple[tuple[int, ...], ClassTable]:
    """Return (class value of each channel, table of the classes other than 0)."""
    if given is not None:
        return _given_classes(names, source, given)
    first_is_none = names[0].casefold() in BACKGROUND_NAMES
    values = [channel if first_is_none else channel + 1 for channel in range(len(names))]
    if "class_values" in texts:
        values = [_class_value(v, source) for v in _by_channel(texts, "class_values", source, len(names))]
    colors = chosen_colors(zip(values, names))
    if "class_colors" in texts:
        colors = [str(color) for color in _by_channel(texts, "class_colors", source, len(names))]
    roles = [BACKGROUND] * len(names)
    if "class_roles" in texts:
        roles = [str(role) for role in _by_channel(texts, "class_roles", source, len(names))]
    try:
        found = [LandCoverClass(*row) for row in zip(values, names, colors, roles) if row[0] != UNLABELED]
        return tuple(values), ClassTable(tuple(found))
    except ClassTableError as error:
        raise ModelError("{where}: {fault}", where=source, fault=error.sentence) from None


def _given_classes(names: Sequence[str], source: str, given: ClassTable) -> tuple[tuple[int, ...], ClassTable]:
    known = {c.name.casefold(): c.value for c in given}
    missing = [n for n in names if n.casefold() not in known and n.casefold() not in BACKGROUND_NAMES]
    if missing:
        raise ModelError(
            "The class table has no class {missing} of {source}; add it, or use no class table.",
            missing=missing,
            source=source,
        )
    values = tuple(known.get(name.casefold(), UNLABELED) for name in names)
    return values, ClassTable(tuple(c for c in given if c.value in values and c.value != UNLABELED))


def _by_channel(texts: Mapping[str, str], key: str, source: str, count: int | None = None) -> list[Any]:
    """Return a list, or a dict of channel number → item, as a list in the order of the channels."""
    found = _literal(texts[key])
    if isinstance(found, dict):
        try:
            by_number = {int(number): item for number, item in found.items()}
        except (ValueError, TypeError, OverflowError):
            by_number = {}
        found = [by_number[n] for n in sorted(by_number)] if sorted(by_number) == list(range(len(found))) else None
    if not isinstance(found, list) or not found or (count is not None and len(found) != count):
        raise ModelError(
            '{source} has “{text}” as {key}; it must be JSON with one entry for each output, like {{"0": …, "1": …}}.',
            source=source,
            text=texts[key][: limits.NAME_CHARACTERS],
            key=key,
        )
    return found


def _class_value(value: object, source: str) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= MAXIMUM_VALUE:
        raise ModelError(
            "{source} has {value} in class_values; class values are whole numbers from 0 to 255.",
            source=source,
            value=value,
        )
    return value


def _number(texts: Mapping[str, str], key: str, source: str, least: float, most: float) -> float | None:
    if key not in texts:
        return None
    found = _literal(texts[key])
    if isinstance(found, bool) or not isinstance(found, (int, float)) or not least <= found <= most:
        raise ModelError(
            "{source} has “{text}” as {key}. It must be a number from {least:g} to {most:g}; correct or remove it.",
            source=source,
            text=texts[key][: limits.NAME_CHARACTERS],
            key=key,
            least=least,
            most=most,
        )
    return float(found)


def _three(texts: Mapping[str, str], key: str, source: str, default: float) -> tuple[float, ...]:
    if key not in texts:
        return (default,) * 3
    found, is_positive = _literal(texts[key]), key == "standardization_std"
    if isinstance(found, (list, tuple)) and len(found) == 3:
        numbers = all(isinstance(v, (int, float)) and abs(v) < limits.STANDARDIZATION for v in found)
        if numbers and (not is_positive or min(found) > 0):
            return tuple(float(v) for v in found)
    raise ModelError(
        "{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue, above 0."
        if is_positive
        else "{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue.",
        source=source,
        text=texts[key][: limits.NAME_CHARACTERS],
        key=key,
    )


def _literal(text: str) -> Any:  # noqa: ANN401 - as in JSON
    """Parse JSON, else a Python literal (older models for Deepness), else return the text itself."""
    try:
        return read_json(text)
    except ValueError:
        return _python_literal(text)


def _python_literal(text: str) -> Any:  # noqa: ANN401 - as in JSON
    # Deeper than any metadata: ast itself would exceed its recursion limit.
    if sum(map(text.count, "([{")) > limits.BRACKETS:
        return text
    try:
        return ast.literal_eval(text)
    except (ValueError, SyntaxError, TypeError, MemoryError, RecursionError):
        return text
