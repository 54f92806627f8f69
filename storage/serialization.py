"""Values of core as bytes, from process to process and back, exactly: what workers are asked, and what they found.

A line of JSON, then the arrays that it refers to.
"""

from __future__ import annotations

import importlib
import json
from dataclasses import fields, is_dataclass
from enum import Enum
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

_ROOT = __name__.rpartition(".storage.")[0]
"""The plugin's package, which has another name in workers."""

_ROOM = "core"
"""Only classes of this room are restored."""


def to_bytes(value: object) -> bytes:
    """Serialize numbers, texts, bytes, arrays, core's dataclasses and enumerations, and what contains them.

    Raises:
        TypeError: The value contains anything else.
    """
    buffers: list[bytes] = []
    return b"".join([json.dumps(_plain(value, buffers)).encode("ascii"), b"\n", *buffers])


def from_bytes(content: bytes) -> Any:  # noqa: ANN401 -- as it was
    """The value that ``to_bytes`` serialized.

    Raises:
        ValueError: The content is not such a value.
    """
    end = content.find(b"\n")
    return _restored(json.loads(content[:end]), memoryview(content)[end + 1 :])


def write(path: str, value: object) -> None:
    """Write a value into a file."""
    Path(path).write_bytes(to_bytes(value))


def read(path: str) -> Any:  # noqa: ANN401 -- as it was
    """The value in a file that ``write`` wrote."""
    return from_bytes(Path(path).read_bytes())


def _plain(value: object, buffers: list[bytes]) -> object:
    """A value as JSON has it; what JSON lacks is an object of one key, which names its kind."""
    if isinstance(value, Enum):
        return {"enum": [_name(type(value)), value.value]}
    if isinstance(value, (np.generic, np.ndarray)):
        array = np.ascontiguousarray(value)
        if array.dtype.hasobject:
            raise TypeError(array.dtype.str)
        kind = "array" if isinstance(value, np.ndarray) else "scalar"
        return {kind: [array.dtype.str, list(np.shape(value)), _kept(array.tobytes(), buffers)]}
    if isinstance(value, bytes):
        return {"bytes": [len(value), _kept(value, buffers)]}
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, list):
        return [_plain(part, buffers) for part in value]
    if isinstance(value, tuple):
        return {"tuple": [_plain(part, buffers) for part in value]}
    if isinstance(value, dict):
        return {"dict": [[_plain(key, buffers), _plain(part, buffers)] for key, part in value.items()]}
    if is_dataclass(value) and not isinstance(value, type):
        content = {field.name: _plain(getattr(value, field.name), buffers) for field in fields(value)}
        return {"object": [_name(type(value)), content]}
    raise TypeError(type(value).__name__)


def _kept(content: bytes, buffers: list[bytes]) -> int:
    """Append to the buffers; where the content begins."""
    begin = sum(map(len, buffers))
    buffers.append(content)
    return begin


def _restored(plain: Any, buffer: memoryview) -> Any:  # noqa: ANN401 -- of any kind
    if isinstance(plain, list):
        return [_restored(part, buffer) for part in plain]
    if not isinstance(plain, dict):
        return plain
    ((kind, held),) = plain.items()
    if kind == "tuple":
        return tuple(_restored(part, buffer) for part in held)
    if kind == "dict":
        return {_restored(key, buffer): _restored(part, buffer) for key, part in held}
    if kind == "bytes":
        length, begin = held
        return bytes(buffer[begin : begin + length])
    if kind in {"array", "scalar"}:
        name, shape, begin = held
        dtype, count = np.dtype(name), prod(shape)
        flat = np.frombuffer(buffer, dtype, count, begin) if count else np.empty(0, dtype)
        array = flat.reshape(shape).copy()
        return array if kind == "array" else array[()]
    name, content = held
    made = _type(name)
    if kind == "enum":
        return made(content)
    value = object.__new__(made)
    for field in fields(made):
        # As it was made once: frozen ones and those that take other arguments are alike.
        object.__setattr__(value, field.name, _restored(content[field.name], buffer))
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
