"""Serialize values of core exactly, to send them to workers and back.

The format is a line of JSON, then the arrays that it refers to.
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
"""Name of the plugin's package, which differs in workers."""

_ROOM = "core"
"""Only classes of this room are restored."""


def to_bytes(value: object) -> bytes:
    """Serialize numbers, texts, bytes, arrays, core's dataclasses and enumerations, and containers of them.

    Raises:
        TypeError: The value contains another type.
    """
    buffers: list[bytes] = []
    return b"".join([json.dumps(_plain(value, buffers)).encode("ascii"), b"\n", *buffers])


def from_bytes(content: bytes) -> Any:  # noqa: ANN401 -- as it was
    """Return the value that ``to_bytes`` serialized. Raises ValueError: the content is invalid."""
    end = content.find(b"\n")
    return _restore(json.loads(content[:end]), memoryview(content)[end + 1 :])


def write(path: str, value: object) -> None:
    """Serialize a value to a file."""
    Path(path).write_bytes(to_bytes(value))


def read(path: str) -> Any:  # noqa: ANN401 -- as it was
    """Return the value in a file of ``write``."""
    return from_bytes(Path(path).read_bytes())


def _plain(value: object, buffers: list[bytes]) -> object:
    """Return a value for JSON; a type that JSON lacks becomes an object with one key, the name of its kind."""
    if isinstance(value, Enum):
        return {"enum": [_name(type(value)), value.value]}
    if isinstance(value, (np.generic, np.ndarray)):
        array = np.ascontiguousarray(value)
        if array.dtype.hasobject:
            raise TypeError(array.dtype.str)
        kind = "array" if isinstance(value, np.ndarray) else "scalar"
        return {kind: [array.dtype.str, list(np.shape(value)), _append(array.tobytes(), buffers)]}
    if isinstance(value, bytes):
        return {"bytes": [len(value), _append(value, buffers)]}
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


def _append(content: bytes, buffers: list[bytes]) -> int:
    begin = sum(map(len, buffers))
    buffers.append(content)
    return begin


def _restore(plain: Any, buffer: memoryview) -> Any:  # noqa: ANN401 -- of any kind
    if isinstance(plain, list):
        return [_restore(part, buffer) for part in plain]
    if not isinstance(plain, dict):
        return plain
    ((kind, held),) = plain.items()
    if kind == "tuple":
        return tuple(_restore(part, buffer) for part in held)
    if kind == "dict":
        return {_restore(key, buffer): _restore(part, buffer) for key, part in held}
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
        # Works for frozen classes and for classes with other constructor arguments.
        object.__setattr__(value, field.name, _restore(content[field.name], buffer))
    return value


def _name(kind: type) -> str:
    """Return “module:class” of a class of core."""
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
