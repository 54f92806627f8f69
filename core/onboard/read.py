"""Read an onboard file from an untrusted source.

The reader never executes content and never allocates more memory than the file's size justifies. It checks sizes in the
zip's directory before unpacking, and shapes and types in the arrays' headers.
"""

from __future__ import annotations

import hmac
import io
import math
import os
import struct
import zipfile
import zlib
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.lib import format as npy_format

from .. import limits
from ..database.checks import require_sound
from ..database.model import MapLandmarks, ReferenceDatabase, Windows
from ..database.parameters import BuildParameters, build_parameters
from ..errors import ClassTableError, DatabaseError, reason_of
from ..geometry.lon_lat import HIGHEST_DEGREE, LonLatPolynomial, term_count
from ..labels.class_table import ClassTable, class_table_from_csv
from ..values import checked, number, read_json
from .format import (
    FORMAT,
    HASH,
    HEADER,
    KINDS,
    ONBOARD_VERSION,
    SIGNATURE,
    VECTOR_STEPS,
    OnboardDatabase,
    SignatureStatus,
    digest,
    export_date,
    read_key,
    signature,
)

_UNREADABLE = (zipfile.BadZipFile, zlib.error, EOFError, OSError, RuntimeError, ValueError, struct.error)
"""Errors of a damaged or malicious zip."""

_ODD = (ClassTableError, KeyError, TypeError, ValueError, OverflowError, RecursionError, AttributeError)
"""Errors of a header or arrays with unexpected content."""

_DEFLATE_RATIO = 1032
"""Largest compression ratio of deflate; a member with a larger one is damaged or malicious."""

_ALWAYS_ALLOWED_BYTES, _BYTES_A_FILE_BYTE = 1 << 26, 200
"""Memory that all members together may need, and more for each byte of the file."""


def read_onboard(path: str, key_file: str | None = None) -> OnboardDatabase:
    """Read an onboard file.

    Its database is complete for localization; the result contains the accuracy of vectors, positions and areas.

    Args:
        key_file: Key of the required signature; None to ignore signatures.

    Raises:
        DatabaseError: The file is missing, of another kind, damaged, too new, too large, or not signed with the key.
        ParameterError: The key can't be used.
    """
    key = read_key(key_file) if key_file else None
    if not os.path.exists(path):
        raise DatabaseError(
            "The file {path} does not exist. Export one with “Export for onboard use” or choose another.", path=path
        )
    if not os.path.isfile(path):
        raise DatabaseError("{path} is a folder, pipe or device; choose an onboard file.", path=path)
    try:
        with zipfile.ZipFile(path) as archive:
            files = _unpack(archive, path)
        members = {name: _array(name, data) for name, data in files.items()}
    except _UNREADABLE as error:
        if isinstance(error, OSError) and error.errno is not None:
            raise DatabaseError("{path} can't be read: {reason}.", path=path, reason=reason_of(error)) from None
        raise _damaged(path, error) from None
    try:
        if members[HASH].tobytes() != digest(files):
            raise ValueError("its content hash is wrong")
        if key is not None:
            _require_signature(files, members, key, path, key_file)
        header = read_json(members[HEADER].tobytes().decode("utf-8"), limits.HEADER_BYTES)
        _check_version(header, path)
        found = _onboard(members, header, path)
        return found if key is None else replace(found, signature=SignatureStatus.VERIFIED)
    except _ODD as error:
        raise _damaged(path, error) from None


def _require_signature(
    files: Mapping[str, bytes], members: Mapping[str, np.ndarray], key: bytes, path: str, key_file: str | None
) -> None:
    """Raise DatabaseError unless the file is signed with the key."""
    if SIGNATURE not in members:
        raise DatabaseError(
            "{path} is not signed. Export it with the key {key}, or do not require a signature.",
            path=path,
            key=key_file,
        )
    if not hmac.compare_digest(signature(files, key), members[SIGNATURE].tobytes()):
        raise DatabaseError(
            "{path} was not signed with the key {key}, or was changed since. Copy it again from the computer that "
            "exported it.",
            path=path,
            key=key_file,
        )


def _damaged(path: str, reason: BaseException) -> DatabaseError:
    text = str(reason).rstrip(".")
    if isinstance(reason, KeyError):
        return DatabaseError(
            "{path} is damaged, incomplete or not an onboard file of SemRef ({name} is missing). Copy or export it "
            "again.",
            path=path,
            name=text,
        )
    return DatabaseError(
        "{path} is damaged, incomplete or not an onboard file of SemRef ({reason}). Copy or export it again.",
        path=path,
        reason=text,
    )


def _unpack(archive: zipfile.ZipFile, path: str) -> dict[str, bytes]:
    """Return the .npy files by name; each is unpacked only if its size is allowed."""
    found: dict[str, bytes] = {}
    infos = {info.filename: info for info in archive.infolist()}
    names = {f"{name}.npy" for name in KINDS}
    if f"{HASH}.npy" not in infos or f"{HEADER}.npy" not in infos:
        raise DatabaseError(
            "{path} is not an onboard file of SemRef. Choose one made by “Export for onboard use”.", path=path
        )
    if len(archive.infolist()) != len(infos) or not set(infos) <= names:
        raise zipfile.BadZipFile("it contains an unknown member")
    total = sum(info.file_size for info in infos.values())
    if total > _ALWAYS_ALLOWED_BYTES + _BYTES_A_FILE_BYTE * os.path.getsize(path):
        raise zipfile.BadZipFile(f"it states {total} bytes, more than a file of its size may contain")
    for filename, info in infos.items():
        name = filename[: -len(".npy")]
        if info.flag_bits & 1 or info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise zipfile.BadZipFile(f"{filename} is encrypted or compressed in an unknown way")
        if info.file_size > min(_largest_bytes(name), _DEFLATE_RATIO * info.compress_size + 64):
            raise zipfile.BadZipFile(f"{filename} states {info.file_size} bytes, more than possible")
        found[name] = archive.read(info)
    return found


def _largest_bytes(name: str) -> int:
    if name in (HEADER, HASH, SIGNATURE):
        return limits.HEADER_BYTES + limits.NPY_HEADER_BYTES
    if name == "overview_labels":
        return limits.OVERVIEW_PIXELS
    count = limits.WINDOWS if name.startswith("windows") else limits.LANDMARKS
    return count * int(KINDS[name][0][-1]) * (3 * limits.VECTOR_LANDMARKS if name == "windows_vectors" else 2)


def _array(name: str, data: bytes) -> np.ndarray:
    """Return the array of a .npy file; raises BadZipFile unless it is of the kind that its name requires."""
    file = io.BytesIO(data)
    try:
        version = npy_format.read_magic(file)
        shape, is_fortran, dtype = npy_format.read_array_header_1_0(file)
    # numpy evaluates the header as a Python literal: the errors depend on its version.
    except Exception:
        raise zipfile.BadZipFile(f"{name} is not a plain array") from None
    kind, axes = KINDS[name]
    if version != (1, 0) or is_fortran or min(shape, default=0) < 0:
        raise zipfile.BadZipFile(f"{name} is not a plain array")
    if dtype.str != kind or len(shape) != axes:
        raise zipfile.BadZipFile(f"{name} has the type {dtype.str} and the shape {shape}")
    if file.tell() + math.prod(shape) * dtype.itemsize != len(data):
        raise zipfile.BadZipFile(f"{name} has another size than its shape {shape}")
    return np.frombuffer(data, dtype, offset=file.tell()).reshape(shape)


def _check_version(header: Mapping[str, Any], path: str) -> None:
    if header["format"] != FORMAT:
        raise ValueError(f"its format is {header['format']!r}")
    version = checked(header["version"], int, "its version")
    if version < 1:
        raise ValueError(f"its version is {version}")
    if version > ONBOARD_VERSION:
        raise DatabaseError(
            "{path} has onboard format version {version}; this SemRef reads versions up to {known}. Update SemRef on "
            "this computer.",
            path=path,
            version=version,
            known=ONBOARD_VERSION,
        )


def _onboard(members: Mapping[str, np.ndarray], header: dict, path: str) -> OnboardDatabase:
    parameters = build_parameters(header["parameters"], path)
    table = class_table_from_csv(header["class_table"], "its class table")
    if table.digest() != parameters.class_table_hash:
        raise ValueError("its class table does not match its hash")
    overview = _overview(members, parameters)
    if tuple(header["reference_classes"]) != table.require_references().reference_values:
        raise ValueError("its reference_classes are not those of its class table")
    windows = _windows(members, header, parameters, len(table.references))
    landmarks = _references(members, header, table)
    require_sound(windows, landmarks, parameters, table)
    database = ReferenceDatabase(windows, landmarks, table, parameters, path, overview)
    return OnboardDatabase(
        database,
        _lon_lat(header["lon_lat"], parameters.extent),
        number(header["position_step"], "position_step", 0.0) / 2,
        math.expm1(number(header["log_area_step"], "log_area_step", 0.0) / 2),
        0.5 / VECTOR_STEPS,
        members[HASH].tobytes().hex(),
        os.path.getsize(path),
        None if header.get("exported") is None else export_date(header["exported"]),
        SignatureStatus.NOT_CHECKED if SIGNATURE in members else SignatureStatus.NONE,
    )


def _windows(members: Mapping[str, np.ndarray], header: dict, parameters: BuildParameters, class_count: int) -> Windows:
    columns, rows, levels, counts, steps = (
        members[f"windows_{name}"] for name in ("columns", "rows", "levels", "counts", "vectors")
    )
    sizes_px = [number(size, "window_sizes_px", -1) for size in header["window_sizes_px"]]
    if not len(columns) == len(rows) == len(levels) == len(counts) == len(steps):
        raise ValueError("its windows_ arrays differ in length")
    if steps.shape[1] != 3 * parameters.references_per_vector:
        raise ValueError(f"windows_vectors has {steps.shape[1]} columns")
    if len(levels) and not 1 <= levels.min() <= levels.max() <= len(sizes_px):
        raise ValueError("windows_levels has unknown levels")
    ranks = steps[:, 2 * parameters.references_per_vector :]
    if ranks.max(initial=0) > class_count:
        raise ValueError("windows_vectors has unknown class ranks")
    sizes = np.array(sizes_px)[levels.astype(np.intp) - 1] * parameters.pixel_size
    vectors = np.empty(steps.shape, np.float32)
    for n, most in enumerate((VECTOR_STEPS, VECTOR_STEPS, class_count)):
        columns_of = slice(n * parameters.references_per_vector, (n + 1) * parameters.references_per_vector)
        vectors[:, columns_of] = (np.arange(256) / most).astype(np.float32)[steps[:, columns_of]]
    first_pixels = np.column_stack([columns, rows]).astype(np.int64)
    return Windows(
        first_pixels,
        levels.astype(np.int64),
        sizes,
        parameters.frame.to_map(first_pixels + np.rint(sizes / parameters.pixel_size)[:, None] / 2),
        counts.astype(np.int64),
        vectors,
        # Each object of a vector has a rank: a row without ranks is not a vector.
        described=ranks.any(axis=1),
    )


def _references(members: Mapping[str, np.ndarray], header: dict, table: ClassTable) -> MapLandmarks:
    steps, areas, classes, touches = (
        members[f"references_{name}"] for name in ("positions", "areas", "classes", "touches_edge")
    )
    if not len(steps) == len(areas) == len(classes) == len(touches) or steps.shape[1] != 2:
        raise ValueError("its references_ arrays differ in length")
    origin = [number(value, "position_origin") for value in header["position_origin"]]
    if len(origin) != 2:
        raise ValueError(f"position_origin is {origin}")
    logs = number(header["log_area_lowest"], "log_area_lowest") + areas * number(
        header["log_area_step"], "log_area_step", 0.0
    )
    if not (np.abs(logs) < limits.LOG_AREA).all():
        raise ValueError("a landmark has an impossible area")
    return MapLandmarks(
        positions=np.array(origin) + steps * number(header["position_step"], "position_step", 0.0),
        classes=classes.copy(),
        areas_m2=np.exp(logs),
        touches_edge=touches > 0,
    )


def _overview(members: Mapping[str, np.ndarray], parameters: BuildParameters) -> np.ndarray | None:
    labels = members.get("overview_labels")
    if labels is None:
        return None
    expected = parameters.overview_frame.shape_hw
    if labels.shape != expected:
        raise ValueError(f"overview_labels has the shape {labels.shape} instead of {expected}")
    return labels.copy()


def _lon_lat(values: dict | None, extent: tuple[float, float, float, float]) -> LonLatPolynomial | None:
    if values is None:
        return None
    degree = checked(values["degree"], int, "the degree of lon_lat")
    if not 0 <= degree <= HIGHEST_DEGREE:
        raise ValueError(f"the degree of lon_lat is {degree}")
    wanted = {"center": 2, "half_size": 2, "longitude": term_count(degree), "latitude": term_count(degree)}
    numbers = {name: tuple(number(value, name) for value in values[name]) for name in wanted}
    if any(len(numbers[name]) != count for name, count in wanted.items()) or 0 in numbers["half_size"]:
        raise ValueError("lon_lat has a wrong number of coefficients for its degree")
    (x, y), (half_width, half_height) = numbers["center"], numbers["half_size"]
    error_m = number(values["error_m"], "error_m", -1)
    found = LonLatPolynomial(
        degree, (x, y), (half_width, half_height), numbers["longitude"], numbers["latitude"], error_m
    )
    if not found.is_on_earth(extent):
        raise ValueError("lon_lat gives positions that are not on Earth")
    return found
