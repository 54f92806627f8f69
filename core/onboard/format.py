"""THE onboard file: a reference database as one small ``.npz``, for a computer without QGIS (docs/file-formats.md).

A zip of arrays in numpy's own format (.npy, version 1.0), none of them pickled. A reader never executes what a file
holds and never allocates more than its size justifies: sizes are checked in the zip's directory, shapes and types in
the arrays' headers, before anything is unpacked.
"""

from __future__ import annotations

import hashlib
import io
import json
import math
import os
import re
import struct
import zipfile
import zlib
from dataclasses import asdict, dataclass, fields
from typing import Any, Dict, Mapping, Optional, Tuple

import numpy as np

from ..database.model import BuildParameters, MapLandmarks, ReferenceDatabase, Windows
from ..errors import ClassTableError, DatabaseError
from ..geometry.lon_lat import HIGHEST_DEGREE, LonLatPolynomial, term_count
from ..labels.class_table import class_table_from_csv
from ..windows.grid import window_name

FORMAT = "semref onboard"
ONBOARD_VERSION = 1

PRECISION_PX = 0.01
"""Default of the largest rounding error of a landmark's x and y, in pixels of the label map."""

MAXIMUM_HEADER_BYTES = 1 << 20
MAXIMUM_WINDOWS = 10_000_000
MAXIMUM_REFERENCES = 50_000_000
LONGEST_VECTOR = 1000
MAXIMUM_OVERVIEW_PIXELS = 1 << 30
"""Beyond these a file is refused: the whole of a country fits."""

_DEFLATE_RATIO = 1032
"""What deflate makes of one byte at most; a member that claims more is damaged or hostile."""

_ALWAYS_ALLOWED_BYTES, _BYTES_A_FILE_BYTE = 1 << 26, 200
"""All members together may take so much memory, and so much more for each byte of the file."""

_AREA_STEPS = 65_535
_VECTOR_STEPS = 255

_HEADER, _HASH = "header", "content_hash"
_KINDS = {
    _HEADER: ("|u1", 1),
    _HASH: ("|u1", 1),
    "windows_columns": ("<u4", 1),
    "windows_rows": ("<u4", 1),
    "windows_levels": ("|u1", 1),
    "windows_counts": ("<u4", 1),
    "windows_vectors": ("|u1", 2),
    "references_positions": ("<u4", 2),
    "references_areas": ("<u2", 1),
    "references_classes": ("|u1", 1),
    "references_touches_edge": ("|u1", 1),
    "overview_labels": ("|u1", 2),
}
"""Type and number of axes of every member; the overview alone may be missing."""

_NPY_START = b"\x93NUMPY\x01\x00"
_NPY_HEADER = re.compile(
    rb"\{'descr': '([<|]u[124])', 'fortran_order': False, 'shape': \(([0-9]{1,10}),(?: ([0-9]{1,10}))?\), \} *\n"
)
_LONGEST_NPY_HEADER = 1024

_NOT_ON_BOARD = "block_hashes"
"""The build parameter that only updating a database needs."""

_JSON_TYPES = {"str": str, "int": int, "float": (int, float), "tuple": list}
"""What JSON makes of the types of BuildParameters."""


@dataclass(frozen=True)
class OnboardDatabase:
    """What an onboard file holds: the database, how its map coordinates become degrees, and what rounding cost.

    lon_lat: None where the file can't tell longitude and latitude; position_error: largest of a landmark's
    x and y, map units; area_error: largest of its area, a share of it; vector_error: largest of an element of a
    topology vector (its class ranks are exact); content_hash: SHA-256 of the file's arrays; size_bytes: the file's.
    """

    database: ReferenceDatabase
    lon_lat: Optional[LonLatPolynomial]
    position_error: float
    area_error: float
    vector_error: float
    content_hash: str
    size_bytes: int


# --- writing ---


def write_onboard(
    path: str,
    database: ReferenceDatabase,
    lon_lat: Optional[LonLatPolynomial],
    precision: Optional[float] = None,
) -> None:
    """Writes ``database`` to ``path``, with its overview where it has one. Same database, same bytes.

    ``precision``: largest rounding error of a landmark's x and y, in map units; PRECISION_PX pixels without it.
    Raises DatabaseError for a database that the format can't hold.
    """
    parameters = database.parameters
    precision = PRECISION_PX * parameters.pixel_size if precision is None else precision
    if not (math.isfinite(precision) and precision > 0):
        raise DatabaseError(f"The precision is {precision:g}; it must be more than 0 map units.")
    if parameters.class_table_hash != database.class_table.digest():
        raise DatabaseError(
            f"The class table of {database.source or 'the database'} was changed after it was built; build it again."
        )
    members, quantization = _quantized(database, precision)
    header = {
        "format": FORMAT,
        "version": ONBOARD_VERSION,
        "parameters": {name: value for name, value in asdict(parameters).items() if name != _NOT_ON_BOARD},
        "class_table": database.class_table.to_csv(),
        "reference_classes": list(database.class_table.reference_values),
        "window_sizes_px": _window_sizes_px(database),
        **quantization,
        "lon_lat": None if lon_lat is None else asdict(lon_lat),
    }
    text = json.dumps(header, ensure_ascii=False, separators=(",", ":"), sort_keys=True)
    members[_HEADER] = np.frombuffer(text.encode("utf-8"), np.uint8)
    if len(members[_HEADER]) > MAXIMUM_HEADER_BYTES:
        raise DatabaseError(f"The header would have {len(members[_HEADER])} bytes, more than {MAXIMUM_HEADER_BYTES}.")
    members[_HASH] = np.frombuffer(_digest({name: _npy(array) for name, array in members.items()}), np.uint8)
    with open(path, "wb") as file:
        np.savez_compressed(file, **{name: members[name] for name in _KINDS if name in members})


def _quantized(database: ReferenceDatabase, precision: float) -> Tuple[Dict[str, np.ndarray], Dict[str, Any]]:
    """Arrays by name, and the numbers that the header needs to undo them."""
    windows, references = database.windows, database.references
    if not len(references):
        raise DatabaseError("There is no landmark to export; choose another database or a larger area.")
    columns, rows = _first_pixels(database)
    origin = references.positions.min(axis=0)
    step = 2 * precision
    steps = np.rint((references.positions - origin) / step)
    if steps.max() > np.iinfo(np.uint32).max:
        raise DatabaseError(f"The precision of {precision:g} map units is too fine for the map; choose a larger one.")
    if not (references.areas_m2 > 0).all():
        raise DatabaseError("A landmark has no area; build the database again.")
    logs = np.log(references.areas_m2)
    area_step = max(float(logs.max() - logs.min()), 1e-9) / _AREA_STEPS
    members = {
        "windows_columns": columns.astype(np.uint32),
        "windows_rows": rows.astype(np.uint32),
        "windows_levels": windows.levels.astype(np.uint8),
        "windows_counts": windows.counts.astype(np.uint32),
        "windows_vectors": _vector_steps(windows, len(database.class_table.references)),
        "references_positions": steps.astype(np.uint32),
        "references_areas": np.rint((logs - logs.min()) / area_step).astype(np.uint16),
        "references_classes": references.classes.astype(np.uint8),
        "references_touches_edge": references.touches_edge.astype(np.uint8),
    }
    if database.overview is not None:
        members["overview_labels"] = np.ascontiguousarray(database.overview, np.uint8)
    numbers = {
        "position_origin": origin.tolist(),
        "position_step": step,
        "log_area_lowest": float(logs.min()),
        "log_area_step": area_step,
    }
    return members, numbers


def _first_pixels(database: ReferenceDatabase) -> Tuple[np.ndarray, np.ndarray]:
    """(N,) first column and (N,) first row of each window, from their names; checked against their centers."""
    windows = database.windows
    if not all(re.fullmatch(r"[0-9]{1,9}_[0-9]{1,9}", name) for name in windows.names.tolist()):
        raise DatabaseError("A window is not named after its first pixel (column_row); build the database again.")
    pixels = np.array([name.split("_") for name in windows.names.tolist()], np.int64).reshape(-1, 2)
    centers = _centers(database.parameters, pixels, windows.sizes)
    if np.abs(centers - windows.centers).max(initial=0) > 1e-3 * database.parameters.pixel_size:
        raise DatabaseError("A window does not lie where its name says; build the database again.")
    return pixels[:, 0], pixels[:, 1]


def _centers(parameters: BuildParameters, first_pixels: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    half_px = np.rint(sizes / parameters.pixel_size)[:, None] / 2
    return parameters.frame.to_map(first_pixels + half_px)


def _window_sizes_px(database: ReferenceDatabase) -> list:
    """Edge of the windows of each level, in pixels of the label map."""
    windows, parameters = database.windows, database.parameters
    sizes = [windows.sizes[windows.levels == n + 1] for n in range(len(parameters.levels))]
    whole = [np.unique(np.rint(s / parameters.pixel_size)).astype(int).tolist() for s in sizes]
    if any(len(s) > 1 for s in whole) or not np.isin(windows.levels, np.arange(1, len(whole) + 1)).all():
        raise DatabaseError("The windows' sizes are not those of their levels; build the database again.")
    return [s[0] if s else 0 for s in whole]


def _vector_steps(windows: Windows, class_count: int) -> np.ndarray:
    """(N, 3·X) uint8: ratios and differences in 255 steps, then whole ranks; zeros without a vector."""
    scale = np.repeat([_VECTOR_STEPS, _VECTOR_STEPS, class_count], windows.vectors.shape[1] // 3)
    return np.where(windows.described[:, None], np.rint(windows.vectors * scale), 0).astype(np.uint8)


def _npy(array: np.ndarray) -> bytes:
    file = io.BytesIO()
    np.lib.format.write_array(file, array, version=(1, 0), allow_pickle=False)
    return file.getvalue()


def _digest(files: Mapping[str, bytes]) -> bytes:
    """SHA-256 of all .npy files but the hash's own, in order of their names."""
    found = hashlib.sha256()
    for name in sorted(files):
        if name != _HASH:
            found.update(files[name])
    return found.digest()


# --- reading ---


def read_onboard(path: str, with_overview: bool = True) -> OnboardDatabase:
    """Reads an onboard file. Raises DatabaseError for files that are missing, foreign, damaged, too new or too large.

    Its database has what localization needs; vectors, positions and areas are as exact as the result says.
    """
    if not os.path.isfile(path):
        raise DatabaseError(f"There is no file {path}; export one with “Export for onboard use” or choose another.")
    try:
        with zipfile.ZipFile(path) as archive:
            files = _unpacked(archive, path)
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, RuntimeError, ValueError, struct.error) as error:
        if isinstance(error, OSError) and error.errno is not None:
            raise DatabaseError(f"{path} can't be read: {error.strerror}.") from None
        raise DatabaseError(_damaged(path, error)) from None
    try:
        members = {name: _array(name, data) for name, data in files.items()}
        if members[_HASH].tobytes() != _digest(files):
            raise ValueError("its content hash is another")
        header = json.loads(members[_HEADER].tobytes().decode("utf-8"))
        _check_version(header, path)
        return _onboard(members, header, path, with_overview)
    except ClassTableError as error:
        raise DatabaseError(_damaged(path, error)) from None
    except (KeyError, TypeError, ValueError, OverflowError, RecursionError, AttributeError) as error:
        raise DatabaseError(_damaged(path, error)) from None


def is_onboard_file(path: str) -> bool:
    """Whether a file, damaged or not, is one of ours by the names of its members."""
    if not zipfile.is_zipfile(path):
        return False
    try:
        with zipfile.ZipFile(path) as archive:
            return f"{_HASH}.npy" in archive.namelist()
    except (zipfile.BadZipFile, OSError):
        return False


def _damaged(path: str, reason: object) -> str:
    text = str(reason).rstrip(".")
    if isinstance(reason, KeyError):
        text = f"{text} is missing"
    return f"{path} is damaged, cut short or no onboard file of SemRef ({text}); fetch another copy or export it again."


def _unpacked(archive: zipfile.ZipFile, path: str) -> Dict[str, bytes]:
    """The .npy files by name, each unpacked only when its stated size is one it may have."""
    found: Dict[str, bytes] = {}
    infos = {info.filename: info for info in archive.infolist()}
    names = {f"{name}.npy" for name in _KINDS}
    if f"{_HASH}.npy" not in infos or f"{_HEADER}.npy" not in infos:
        raise DatabaseError(f"{path} is no onboard file of SemRef; choose one made by “Export for onboard use”.")
    if len(archive.infolist()) != len(infos) or not set(infos) <= names:
        raise zipfile.BadZipFile("it holds something that does not belong there")
    total = sum(info.file_size for info in infos.values())
    if total > _ALWAYS_ALLOWED_BYTES + _BYTES_A_FILE_BYTE * os.path.getsize(path):
        raise zipfile.BadZipFile(f"it claims {total} bytes, more than a file of its size may hold")
    for filename, info in infos.items():
        name = filename[: -len(".npy")]
        if info.flag_bits & 1 or info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise zipfile.BadZipFile(f"{name} is encrypted or packed in an unknown way")
        if info.file_size > _largest_bytes(name) or info.file_size > _DEFLATE_RATIO * info.compress_size + 64:
            raise zipfile.BadZipFile(f"{name} claims {info.file_size} bytes, more than it can have")
        with archive.open(info) as file:
            # The header first: what it says must be the size that the directory states, before the rest is unpacked.
            start = file.read(min(info.file_size, _LONGEST_NPY_HEADER))
            _, shape, first = _npy_header(name, start)
            if first + math.prod(shape) * _item_bytes(name) != info.file_size:
                raise zipfile.BadZipFile(f"{name} has not the size that its shape {shape} says")
            found[name] = start + file.read(info.file_size - len(start))
        if len(found[name]) != info.file_size:
            raise zipfile.BadZipFile(f"{name} ends early")
    return found


def _largest_bytes(name: str) -> int:
    if name in (_HEADER, _HASH):
        return MAXIMUM_HEADER_BYTES + _LONGEST_NPY_HEADER
    if name == "overview_labels":
        return MAXIMUM_OVERVIEW_PIXELS
    count = MAXIMUM_WINDOWS if name.startswith("windows") else MAXIMUM_REFERENCES
    return count * _item_bytes(name) * (3 * LONGEST_VECTOR if name == "windows_vectors" else 2)


def _item_bytes(name: str) -> int:
    return int(_KINDS[name][0][-1])


def _npy_header(name: str, start: bytes) -> Tuple[str, Tuple[int, ...], int]:
    """(type, shape, first byte of the data) of a .npy file. Raises BadZipFile unless it is such an array."""
    length = int.from_bytes(start[8:10], "little")
    found = _NPY_HEADER.fullmatch(start[10 : 10 + length])
    if not start.startswith(_NPY_START) or len(start) < 10 + length or found is None:
        raise zipfile.BadZipFile(f"{name} is no plain array of whole numbers")
    kind, axes = _KINDS[name]
    shape = tuple(int(size) for size in found.groups()[1:] if size is not None)
    if found[1].decode("ascii") != kind or len(shape) != axes:
        raise zipfile.BadZipFile(f"{name} has the type {found[1].decode('ascii')} and the shape {shape}")
    return kind, shape, 10 + length


def _array(name: str, data: bytes) -> np.ndarray:
    kind, shape, first = _npy_header(name, data[:_LONGEST_NPY_HEADER])
    return np.frombuffer(data, np.dtype(kind), offset=first).reshape(shape)


def _check_version(header: Any, path: str) -> None:
    if header["format"] != FORMAT:
        raise ValueError(f"its format is {header['format']!r}")
    version = header["version"]
    if isinstance(version, bool) or not isinstance(version, int) or version < 1:
        raise ValueError(f"its version is {version!r}")
    if version > ONBOARD_VERSION:
        raise DatabaseError(
            f"{path} has onboard format version {version}, newer than this SemRef reads ({ONBOARD_VERSION}); "
            "update SemRef's core folder on this computer."
        )


def _onboard(members: Mapping[str, np.ndarray], header: dict, path: str, with_overview: bool) -> OnboardDatabase:
    parameters = _parameters(header["parameters"])
    table = class_table_from_csv(header["class_table"], "its class table")
    if table.digest() != parameters.class_table_hash:
        raise ValueError("its class table is not the one that its hash names")
    overview = _overview(members, parameters) if with_overview else None
    if tuple(header["reference_classes"]) != table.require_references().reference_values:
        raise ValueError("its reference_classes are not those of its class table")
    database = ReferenceDatabase(
        _windows(members, header, parameters, len(table.references)),
        _references(members, header, table),
        table,
        parameters,
        path,
        overview,
    )
    return OnboardDatabase(
        database,
        _lon_lat(header["lon_lat"]),
        _number(header["position_step"], "position_step", 0.0) / 2,
        math.expm1(_number(header["log_area_step"], "log_area_step", 0.0) / 2),
        0.5 / _VECTOR_STEPS,
        members[_HASH].tobytes().hex(),
        os.path.getsize(path),
    )


def _parameters(values: dict) -> BuildParameters:
    taken = [item for item in fields(BuildParameters) if item.name != _NOT_ON_BOARD]
    known = {item.name: values[item.name] for item in taken}
    for item in taken:
        if isinstance(known[item.name], bool) or not isinstance(known[item.name], _JSON_TYPES[item.type]):
            raise ValueError(f"{item.name} is {known[item.name]!r}")
    for name, length in (("geotransform", 6), ("levels", None)):
        numbers = [_number(number, name) for number in known[name]]
        if length is not None and len(numbers) != length or not numbers:
            raise ValueError(f"{name} is {known[name]!r}")
        known[name] = tuple(numbers)
    for name in ("pixel_size", "window_size", "stride", "minimum_area"):
        _number(known[name], name, 0.0)
    for name in ("map_width_px", "map_height_px", "overview_factor", "references_per_vector"):
        if not 0 < known[name] < 1 << 31:
            raise ValueError(f"{name} is {known[name]}")
    return BuildParameters(**known)


def _number(value: Any, name: str, above: float = -math.inf) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not above < value < math.inf:
        raise ValueError(f"{name} is {value!r}")
    return float(value)


def _windows(members: Mapping[str, np.ndarray], header: dict, parameters: BuildParameters, class_count: int) -> Windows:
    columns, rows, levels, counts, steps = (
        members[f"windows_{name}"] for name in ("columns", "rows", "levels", "counts", "vectors")
    )
    sizes_px = [_number(size, "window_sizes_px", -1) for size in header["window_sizes_px"]]
    if not len(columns) == len(rows) == len(levels) == len(counts) == len(steps):
        raise ValueError("its windows_ arrays differ in length")
    if steps.shape[1] != 3 * parameters.references_per_vector:
        raise ValueError(f"windows_vectors has {steps.shape[1]} columns")
    if len(levels) and not 1 <= levels.min() <= levels.max() <= len(sizes_px):
        raise ValueError("windows_levels has levels that are not there")
    ranks = steps[:, 2 * parameters.references_per_vector :]
    if ranks.max(initial=0) > class_count:
        raise ValueError("windows_vectors has class ranks that are not there")
    sizes = np.array(sizes_px)[levels.astype(np.intp) - 1] * parameters.pixel_size
    vectors = np.empty(steps.shape, np.float32)
    for n, most in enumerate((_VECTOR_STEPS, _VECTOR_STEPS, class_count)):
        columns_of = slice(n * parameters.references_per_vector, (n + 1) * parameters.references_per_vector)
        vectors[:, columns_of] = (np.arange(256) / most).astype(np.float32)[steps[:, columns_of]]
    return Windows(
        names=np.array([window_name(c, r) for c, r in zip(columns.tolist(), rows.tolist())], dtype=str),
        levels=levels.astype(np.int64),
        sizes=sizes,
        centers=_centers(parameters, np.column_stack([columns, rows]).astype(np.float64), sizes),
        counts=counts.astype(np.int64),
        vectors=vectors,
        # A vector has a rank for each of its objects, so one without ranks is none.
        described=ranks.any(axis=1),
    )


def _references(members: Mapping[str, np.ndarray], header: dict, table) -> MapLandmarks:
    steps, areas, classes, touches = (
        members[f"references_{name}"] for name in ("positions", "areas", "classes", "touches_edge")
    )
    if not len(steps) == len(areas) == len(classes) == len(touches) or steps.shape[1] != 2:
        raise ValueError("its references_ arrays differ in length")
    if not np.isin(classes, table.reference_values).all():
        raise ValueError("references_classes has classes that are no reference classes")
    origin = [_number(value, "position_origin") for value in header["position_origin"]]
    if len(origin) != 2:
        raise ValueError(f"position_origin is {origin}")
    logs = _number(header["log_area_lowest"], "log_area_lowest") + areas * _number(
        header["log_area_step"], "log_area_step", 0.0
    )
    if not (np.abs(logs) < 50).all():
        raise ValueError("its areas are none")
    return MapLandmarks(
        positions=np.array(origin) + steps * _number(header["position_step"], "position_step", 0.0),
        classes=classes.copy(),
        areas_m2=np.exp(logs),
        touches_edge=touches > 0,
    )


def _overview(members: Mapping[str, np.ndarray], parameters: BuildParameters) -> Optional[np.ndarray]:
    labels = members.get("overview_labels")
    if labels is None:
        return None
    factor = parameters.overview_factor
    expected = -(-parameters.map_height_px // factor), -(-parameters.map_width_px // factor)
    if labels.shape != expected:
        raise ValueError(f"overview_labels has the shape {labels.shape} instead of {expected}")
    return labels.copy()


def _lon_lat(values: Optional[dict]) -> Optional[LonLatPolynomial]:
    if values is None:
        return None
    degree = values["degree"]
    if isinstance(degree, bool) or not isinstance(degree, int) or not 0 <= degree <= HIGHEST_DEGREE:
        raise ValueError(f"the degree of lon_lat is {degree!r}")
    wanted = {"center": 2, "half_size": 2, "longitude": term_count(degree), "latitude": term_count(degree)}
    numbers = {name: tuple(_number(value, name) for value in values[name]) for name in wanted}
    if any(len(numbers[name]) != count for name, count in wanted.items()) or 0 in numbers["half_size"]:
        raise ValueError("lon_lat has not the numbers of its degree")
    return LonLatPolynomial(degree, **numbers, error_m=_number(values["error_m"], "error_m", -1))
