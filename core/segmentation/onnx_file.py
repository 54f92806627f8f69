"""Read the header of an ONNX file without onnxruntime: its error messages change between releases.

ONNX is protobuf: a message is a series of fields. Each has a number and a value: an integer, bytes of a stated length
(text, another message), or 4 or 8 bytes. Unneeded fields are skipped.
"""

from __future__ import annotations

import mmap
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from ..named_files import named_file
from ..sentences import Sentence

_VARINT, _EIGHT_BYTES, _LENGTH, _FOUR_BYTES = 0, 1, 2, 5
GRAPH = 7
_METADATA = 14
_NODE, _INITIALIZER, _EXTERNAL_DATA = 1, 5, 13
_OPERATOR, _ATTRIBUTE, _NAME, _TEXT = 4, 5, 1, 4
_ALIGNED = b"coordinate_transformation_mode", b"align_corners"
_KEY, _VALUE = 1, 2


@dataclass(frozen=True)
class OnnxHeader:
    """Header of a model file.

    Attributes:
        weight_files: Names of other files with its weights.
        aligns_corners: Whether it enlarges anything with aligned corners, which moves results away from the middle of a
            tile outwards (docs/how-to/train_a_network.md).
        texts: Its metadata by key, without damaged entries.
    """

    weight_files: tuple[str, ...]
    aligns_corners: bool = False
    texts: Mapping[str, str] = field(default_factory=dict)

    def missing_weights(self, path: str) -> str:
        """Return the name of the first weight file that is missing in the folder of the model; empty otherwise."""
        folder = [os.path.dirname(os.path.abspath(path))]
        return next((name for name in self.weight_files if not os.path.isfile(named_file(name, folder))), "")


def no_model_file(path: str) -> Sentence:
    """Return why a path can't be a model: there is no file."""
    return Sentence("{path} does not exist; choose a model file (.onnx).", path=path)


def no_onnx_model(path: str) -> Sentence:
    """Return why a file can't be a model: it has no header."""
    return Sentence("{path} is not an ONNX model, or it is damaged or incomplete; copy or export it again.", path=path)


def header_of(path: str) -> OnnxHeader | None:
    """Return the header of an ONNX file; None if it is unreadable. Reads only the needed parts of large files."""
    try:
        with open(path, "rb") as file:
            # An empty file can't be mapped. The map is not closed: a profiler, as in Dask's workers, may still keep
            # views of it.
            return read_header(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))
    except (OSError, ValueError):
        return None


def read_header(data: bytes | mmap.mmap) -> OnnxHeader | None:
    """Return the header from the bytes of an ONNX file; None if they are not protobuf or have no graph."""
    graph, texts = None, dict[str, str]()
    try:
        for number, value in fields(memoryview(data)):
            if number == GRAPH and isinstance(value, memoryview):
                graph = value
            elif (entry := _entry(number, value)) is not None:
                texts.update([entry])
        return None if graph is None else OnnxHeader(tuple(_weight_files(graph)), _aligns_corners(graph), texts)
    except ValueError:
        return None


def _entry(number: int, value: int | memoryview) -> tuple[str, str] | None:
    """Return (key, text) of a field that is a metadata entry; None for any other."""
    if number != _METADATA or not isinstance(value, memoryview):
        return None
    try:
        stated = dict(fields(value))
    except ValueError:
        return None
    parts = [stated.get(part, b"") for part in (_KEY, _VALUE)]
    # bytes() of a number would create that many bytes.
    key, text = ("" if isinstance(part, int) else bytes(part).decode("utf-8", "replace") for part in parts)
    return key, text


def with_metadata(data: bytes, key: str, text: str) -> bytes:
    """Return an ONNX file with one metadata entry set, otherwise unchanged.

    Args:
        data: Bytes of a file that ``read_header`` accepts.
        key: Of the entry; an existing one is replaced.
    """
    kept = []
    for number, value, part in parts(memoryview(data)):
        stated = _entry(number, value)
        kept += [] if stated is not None and stated[0] == key else [part]
    return b"".join([*kept, _metadata_field(key, text)])


def with_only_metadata(data: bytes, texts: Mapping[str, str]) -> bytes:
    """Return an ONNX file that ``read_header`` accepts with other metadata: these texts by key, and no more."""
    kept = [part for number, _, part in parts(memoryview(data)) if number != _METADATA]
    return b"".join([*kept, *(_metadata_field(key, text) for key, text in texts.items())])


def _metadata_field(key: str, text: str) -> bytes:
    return field_of(_METADATA, field_of(_KEY, key.encode()) + field_of(_VALUE, text.encode()))


def field_of(number: int, content: bytes | int) -> bytes:
    """Return a protobuf field with an integer ≥ 0, or with bytes of a stated length."""
    if isinstance(content, int):
        return _varint_of(number << 3 | _VARINT) + _varint_of(content)
    return _varint_of(number << 3 | _LENGTH) + _varint_of(len(content)) + content


def _varint_of(value: int) -> bytes:
    found = b""
    while value >= 0x80:
        found, value = found + bytes([value & 0x7F | 0x80]), value >> 7
    return found + bytes([value])


def _weight_files(graph: memoryview) -> list[str]:
    found: dict[str, None] = {}
    for number, tensor in fields(graph):
        if number != _INITIALIZER or not isinstance(tensor, memoryview):
            continue
        for inner, entry in fields(tensor):
            if inner == _EXTERNAL_DATA and isinstance(entry, memoryview):
                texts = {key: bytes(text) for key, text in fields(entry) if isinstance(text, memoryview)}
                if texts.get(_KEY) == b"location":
                    found[texts.get(_VALUE, b"").decode("utf-8", "replace")] = None
    return list(found)


def _aligns_corners(graph: memoryview) -> bool:
    for number, node in fields(graph):
        if number != _NODE or not isinstance(node, memoryview):
            continue
        parts = [(inner, part) for inner, part in fields(node) if isinstance(part, memoryview)]
        if (_OPERATOR, b"Resize") not in parts:
            continue
        for inner, attribute in parts:
            stated = dict(fields(attribute)) if inner == _ATTRIBUTE else {}
            if (stated.get(_NAME), stated.get(_TEXT)) == _ALIGNED:
                return True
    return False


def fields(data: memoryview) -> Iterator[tuple[int, int | memoryview]]:
    """Return (number, value) of each field; raises ValueError for bytes that are not protobuf."""
    return ((number, value) for number, value, _ in parts(data))


def parts(data: memoryview) -> Iterator[tuple[int, int | memoryview, memoryview]]:
    """Yield (number, value, all its bytes) of each field; raises ValueError for bytes that are not protobuf."""
    place = 0
    while place < len(data):
        first = place
        key, place = _varint(data, place)
        number, kind = key >> 3, key & 7
        if kind == _VARINT:
            value, place = _varint(data, place)
            yield number, value, data[first:place]
            continue
        size = {_EIGHT_BYTES: 8, _FOUR_BYTES: 4}.get(kind)
        if kind == _LENGTH:
            size, place = _varint(data, place)
        if size is None or number == 0 or place + size > len(data):
            raise ValueError
        yield number, data[place : place + size], data[first : place + size]
        place += size


def _varint(data: memoryview, place: int) -> tuple[int, int]:
    """Return an integer and the offset after it."""
    value = 0
    for shift in range(0, 70, 7):
        if place >= len(data):
            break
        byte = data[place]
        place += 1
        value |= (byte & 0x7F) << shift
        if byte < 0x80:
            return value, place
    raise ValueError
