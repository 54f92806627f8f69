"""What a model says about itself to people: what it was trained on, how good it is, what it is not good for.

Read from the metadata of an ONNX file without onnxruntime (docs/reference/file_formats.md#model-card). Files of other
makers say less; what is not of the shape that is told there is left out, never an error.
"""

from __future__ import annotations

import math
import mmap
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from .. import limits
from ..errors import ModelError
from ..sentences import Sentence
from ..values import read_json
from .metadata import named_channels, read_settings
from .onnx_file import read_header, read_metadata

KEY = "model_card"


@dataclass(frozen=True)
class Ground:
    """Where a model was trained or tested.

    Attributes:
        about: What it is and looks like.
        is_left_out: Tested by a network of the same making that was trained without it.
        iou: Intersection over union by name of class; empty where it was trained on.
    """

    place: str
    about: str = ""
    is_left_out: bool = False
    iou: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class ModelCard:
    """What there is to know of a model's file; texts are empty, and numbers None, where it does not say.

    Attributes:
        fault: Why it can't be used.
        classes: Of its outputs.
        resolution_m: Meters a pixel that it was trained on.
        date: When it was trained.
        validation_iou: On parts of the ground it was trained on that were set aside.
        confusion: Share of each class (row) that is taken for each.
        good_for: In a sentence.
        not_for: In a sentence.
        license: In a sentence.
        minutes: Of training.
        can_be_base: It says what it is built of, so that “Train model” can go on from it.
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
        """On places that were left out where there are such, else on ground set aside; None where it does not say."""
        by_place = [ground.iou for ground in self.tested_on if ground.iou]
        found = [
            sum(iou.values()) / len(iou) for iou in by_place or ([self.validation_iou] if self.validation_iou else [])
        ]
        return sum(found) / len(found) if found else None


def read_card(path: str) -> ModelCard:
    """Return the card of an ONNX file; of one that can't be used it says why not."""
    # A pipe would be waited for without end.
    if not os.path.isfile(path):
        return ModelCard(path, Sentence("{path} does not exist; choose a model file (.onnx).", path=path))
    try:
        # Of files of hundreds of megabytes only what is looked at is read; an empty one is refused.
        with open(path, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
            texts = None if read_header(data) is None else read_metadata(data)
    except OSError:
        return ModelCard(path, Sentence("{path} does not exist; choose a model file (.onnx).", path=path))
    except ValueError:
        texts = None
    if texts is None:
        return ModelCard(
            path,
            Sentence("{path} is not an ONNX model, or it is damaged or cut short; copy or export it again.", path=path),
        )
    return card_of_texts(texts, path)


def card_of_texts(texts: Mapping[str, str], path: str) -> ModelCard:
    """Return the card that a model's metadata make."""
    fault, classes, resolution = None, [], None
    try:
        resolution = read_settings(texts, path).resolution_m
        classes = named_channels(texts, path) or []
    except ModelError as error:
        fault = error.sentence
    told = _json(texts, KEY, dict)
    training = told.get("training")
    ground = _json(texts, "training_ground", dict)
    trained_on = _grounds(told.get("trained_on"))
    if not trained_on and ground.get("image"):
        trained_on = (Ground(_text(ground["image"]), _text(ground.get("labels"))),)
    return ModelCard(
        path,
        fault,
        _text(told.get("name")),
        tuple(classes),
        resolution,
        _text(told.get("date") or ground.get("date")),
        trained_on,
        _grounds(told.get("tested_on")),
        _shares(_json(texts, "validation_iou", dict)),
        _matrix(_json(texts, "validation_confusion", list), len(classes)),
        _text(told.get("good_for"), limits.CARD_CHARACTERS),
        _text(told.get("not_for"), limits.CARD_CHARACTERS),
        _text(told.get("license"), limits.CARD_CHARACTERS),
        _number(training.get("minutes")) if isinstance(training, dict) else None,
        bool(_json(texts, "architecture", dict)),
    )


def _json(texts: Mapping[str, str], key: str, kind: type) -> Any:  # noqa: ANN401 - of the kind
    """Return what is said under a key where it is of a kind, else an empty one."""
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
    """Return a square of shares; empty where it is none."""
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
