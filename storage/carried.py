"""Values of core as text, from process to process and back, exactly: what workers are asked, and what they found."""

from __future__ import annotations

import base64
import importlib
import json
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import Path, PurePath
from typing import Any

import numpy as np

_ROOT = __name__.rpartition(".storage.")[0]
"""The plugin's package, which is called otherwise in workers."""

_ROOM = "core"
"""Only what is made there is made again from a text."""


def to_text(value: object) -> str:
    """A value as text: numbers, texts, arrays, core's dataclasses and enumerations, and what holds them.

    Raises:
        TypeError: It holds anything else.
    """
    return json.dumps(_plain(value))


def from_text(text: str) -> Any:  # noqa: ANN401 -- as it was
    """The value that ``to_text`` made a text of.

    Raises:
        ValueError: It is none.
    """
    return _made(json.loads(text))


def write(path: str, value: object) -> None:
    """Writes a value as a file of text."""
    Path(path).write_text(to_text(value), encoding="utf-8")


def read(path: str) -> Any:  # noqa: ANN401 -- as it was
    """The value of a file that ``write`` wrote."""
    return from_text(Path(path).read_text(encoding="utf-8"))


def _plain(value: object) -> object:
    """A value as JSON has it; what JSON has not is an object of one key, which tells its kind."""
    if isinstance(value, Enum):
        return {"enum": [_name(type(value)), value.value]}
    if isinstance(value, np.generic):
        return {"scalar": _bytes(np.asarray(value))}
    if isinstance(value, np.ndarray):
        return {"array": _bytes(value)}
    if isinstance(value, PurePath):
        return str(value)
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, list):
        return [_plain(part) for part in value]
    if isinstance(value, tuple):
        return {"tuple": [_plain(part) for part in value]}
    if isinstance(value, dict):
        return {"dict": [[_plain(key), _plain(part)] for key, part in value.items()]}
    if is_dataclass(value) and not isinstance(value, type):
        held = {field.name: _plain(getattr(value, field.name)) for field in fields(value)}
        return {"object": [_name(type(value)), held]}
    raise TypeError(type(value).__name__)


def _bytes(array: np.ndarray) -> list[object]:
    if array.dtype.hasobject:
        raise TypeError(array.dtype.str)
    return [array.dtype.str, list(array.shape), base64.b64encode(np.ascontiguousarray(array).tobytes()).decode("ascii")]


def _made(plain: Any) -> Any:  # noqa: ANN401 -- of any kind
    if isinstance(plain, list):
        return [_made(part) for part in plain]
    if not isinstance(plain, dict):
        return plain
    ((kind, held),) = plain.items()
    if kind == "tuple":
        return tuple(_made(part) for part in held)
    if kind == "dict":
        return {_made(key): _made(part) for key, part in held}
    if kind in {"array", "scalar"}:
        name, shape, text = held
        array = np.frombuffer(base64.b64decode(text), np.dtype(name)).reshape(shape).copy()
        return array if kind == "array" else array[()]
    name, content = held
    made = _type(name)
    if kind == "enum":
        return made(content)
    value = object.__new__(made)
    for field in fields(made):
        # As it was made once: frozen ones and those that take other arguments are alike.
        object.__setattr__(value, field.name, _made(content[field.name]))
    return value


def _name(kind: type) -> str:
    """A class of core by its module there."""
    module = kind.__module__.removeprefix(f"{_ROOT}.")
    if module.partition(".")[0] != _ROOM:
        raise TypeError(kind.__name__)
    return f"{module}:{kind.__qualname__}"


def _type(name: str) -> type:
    module, _, title = name.partition(":")
    if module.partition(".")[0] != _ROOM or ".." in module:
        raise ValueError(name)
    found = getattr(importlib.import_module(f"{_ROOT}.{module}"), title, None)
    if not (isinstance(found, type) and (is_dataclass(found) or issubclass(found, Enum))):
        raise ValueError(name)
    return found
