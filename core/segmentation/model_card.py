"""Model card: what a model was trained on, how good it is, and what it is not suitable for.

The card is read from the metadata of an ONNX file without onnxruntime (docs/reference/file_formats.md#model-card).
Models from others state less. Entries of an unexpected form are ignored without an error.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from .. import limits
from ..errors import ModelError
from ..sentences import Sentence
from ..values import read_json
from .metadata import named_channels, read_settings
from .onnx_file import header_of, no_model_file, no_onnx_model

KEY = "model_card"


@dataclass(frozen=True)
class Ground:
    """Place where a model was trained or tested.

    Attributes:
        is_left_out: Tested by a network of the same kind that was trained without this place.
        iou: Intersection over union by class name; empty for training places.
    """

    place: str
    about: str = ""
    is_left_out: bool = False
    iou: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class ModelCard:
    """Information about a model's file; texts are empty, and numbers None, if not stated.

    Attributes:
        fault: Why the model can't be used.
        resolution_m: Meters per pixel of its training images.
        validation_iou: On held-out parts of the training ground.
        confusion: Share of each class (row) that is predicted as each.
        can_be_base: The architecture is stated, so that “Train model” can continue from it.
    """

    file: str
    fault: Sentence | None = None
    name: str = ""
    classes: tuple[str, ...] = ()
    resolution_m: float | None = None
    date: str = ""
    trained_on: tuple[Ground, ...] = ()
    tested_on: tuple[Ground, ...] = ()
    validation_iou: Mapping[str, float] = field(default_factory=dict)
    confusion: tuple[tuple[float, ...], ...] = ()
    good_for: str = ""
    not_for: str = ""
    license: str = ""
    minutes: float | None = None
    can_be_base: bool = False

    @property
    def mean_iou(self) -> float | None:
        """Mean IoU on places that were left out, or on held-out ground; None if not stated."""
        by_place = [ground.iou for ground in self.tested_on if ground.iou]
        found = [
            sum(iou.values()) / len(iou) for iou in by_place or ([self.validation_iou] if self.validation_iou else [])
        ]
        return sum(found) / len(found) if found else None


def read_card(path: str) -> ModelCard:
    """Return the card of an ONNX file; ``fault`` states why it can't be used."""
    # Opening a pipe would block.
    if not os.path.isfile(path):
        return ModelCard(path, no_model_file(path))
    header = header_of(path)
    if header is None:
        return ModelCard(path, no_onnx_model(path))
    return card_of_texts(header.texts, path)


def card_of_texts(texts: Mapping[str, str], path: str) -> ModelCard:
    """Return the card from a model's metadata."""
    fault, classes, resolution = None, [], None
    try:
        resolution = read_settings(texts, path).resolution_m
        classes = named_channels(texts, path) or []
    except ModelError as error:
        fault = error.sentence
    card = _json(texts, KEY, dict)
    training = card.get("training")
    ground = _json(texts, "training_ground", dict)
    trained_on = _grounds(card.get("trained_on"))
    if not trained_on and ground.get("image"):
        trained_on = (Ground(_text(ground["image"]), _text(ground.get("labels"))),)
    return ModelCard(
        path,
        fault,
        _text(card.get("name")),
        tuple(classes),
        resolution,
        _text(card.get("date") or ground.get("date")),
        trained_on,
        _grounds(card.get("tested_on")),
        _shares(_json(texts, "validation_iou", dict)),
        _matrix(_json(texts, "validation_confusion", list), len(classes)),
        _text(card.get("good_for"), limits.CARD_CHARACTERS),
        _text(card.get("not_for"), limits.CARD_CHARACTERS),
        _text(card.get("license"), limits.CARD_CHARACTERS),
        _number(training.get("minutes")) if isinstance(training, dict) else None,
        bool(_json(texts, "architecture", dict)),
    )


def _json(texts: Mapping[str, str], key: str, kind: type) -> Any:  # noqa: ANN401 - of the kind
    """Return the JSON value of a key if it has the type, else an empty one."""
    try:
        found = read_json(texts.get(key, ""), limits.VALUE_CHARACTERS)
    except ValueError:
        found = None
    return found if isinstance(found, kind) else kind()


def _text(value: object, longest: int = limits.NAME_CHARACTERS) -> str:
    return value[:longest] if isinstance(value, str) else ""


def _number(value: object) -> float | None:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        return None
    return float(value)


def _shares(value: object) -> dict[str, float]:
    """Return numbers in 0…1 by name."""
    if not isinstance(value, dict):
        return {}
    found = {_text(name): _number(share) for name, share in value.items()}
    return {name: share for name, share in found.items() if share is not None and 0 <= share <= 1}


def _matrix(rows: list, size: int) -> tuple[tuple[float, ...], ...]:
    """Return a square matrix of shares; empty if malformed."""
    found = []
    for row in rows:
        shares = [share for share in map(_number, row) if share is not None] if isinstance(row, list) else []
        found += [tuple(shares)] if len(shares) == size else []
    return tuple(found) if len(found) == len(rows) == size else ()


def _grounds(value: object) -> tuple[Ground, ...]:
    entries = [one for one in value[: limits.CARD_PLACES] if isinstance(one, dict)] if isinstance(value, list) else []
    return tuple(
        Ground(_text(one.get("place")), _text(one.get("about")), one.get("how") == "left out", _shares(one.get("iou")))
        for one in entries
        if _text(one.get("place"))
    )
