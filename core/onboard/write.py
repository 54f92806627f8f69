"""Write an onboard file; values are rounded to a stated precision."""

from __future__ import annotations

import io
import json
import math
from dataclasses import asdict
from datetime import datetime
from typing import Any

import numpy as np

from .. import limits
from ..database.model import ReferenceDatabase, Windows
from ..errors import DatabaseError
from ..geometry.lon_lat import LonLatPolynomial
from ..sentences import Sentence
from .format import (
    AREA_STEPS,
    FORMAT,
    HASH,
    HEADER,
    KINDS,
    NOT_ON_BOARD,
    ONBOARD_VERSION,
    PRECISION_PX,
    SIGNATURE,
    VECTOR_STEPS,
    digest,
    read_key,
    signature,
)


def write_onboard(  # noqa: PLR0913 - a database, and what is stated beside it
    path: str,
    database: ReferenceDatabase,
    lon_lat: LonLatPolynomial | None,
    precision: float | None = None,
    key_file: str | None = None,
    exported: datetime | None = None,
) -> None:
    """Write a database, with its overview if it has one. The same database and date give the same bytes.

    Args:
        lon_lat: Longitude and latitude of its map coordinates; None to leave them out.
        precision: Largest rounding error of a landmark's x and y, m; PRECISION_PX pixels by default.
        key_file: Key of the signature; None without one.
        exported: Date with time zone in the file; None without one.

    Raises:
        DatabaseError: The format can't store the database.
        ParameterError: The key can't be used.
    """
    key = read_key(key_file) if key_file else None
    parameters = database.parameters
    precision = PRECISION_PX * parameters.pixel_size if precision is None else precision
    if not (math.isfinite(precision) and precision > 0):
        raise DatabaseError("The precision is {precision:g}; it must be more than 0 m.", precision=precision)
    if parameters.class_table_hash != database.class_table.digest():
        raise DatabaseError(
            "The class table of {source} was changed after the build. Build the database again.",
            source=database.source or Sentence("the database"),
        )
    members, quantization = _quantize(database, precision)
    header = {
        "format": FORMAT,
        "version": ONBOARD_VERSION,
        "parameters": {name: value for name, value in asdict(parameters).items() if name != NOT_ON_BOARD},
        "class_table": database.class_table.to_csv(),
        "reference_classes": list(database.class_table.reference_values),
        "window_sizes_px": _window_sizes_px(database),
        **quantization,
        "lon_lat": None if lon_lat is None else asdict(lon_lat),
    }
    if exported is not None:
        header["exported"] = exported.isoformat(timespec="seconds")
    text = json.dumps(header, ensure_ascii=False, separators=(",", ":"), sort_keys=True)
    members[HEADER] = np.frombuffer(text.encode("utf-8"), np.uint8)
    if len(members[HEADER]) > limits.HEADER_BYTES:
        raise DatabaseError(
            "The header of the onboard file has {size} bytes; at most {most} are allowed.",
            size=len(members[HEADER]),
            most=limits.HEADER_BYTES,
        )
    files = {name: _npy(array) for name, array in members.items()}
    members[HASH] = np.frombuffer(digest(files), np.uint8)
    if key is not None:
        members[SIGNATURE] = np.frombuffer(signature(files, key), np.uint8)
    with open(path, "wb") as file:
        np.savez_compressed(file, **{name: members[name] for name in KINDS if name in members})


def _quantize(database: ReferenceDatabase, precision: float) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    """Return arrays by name, and the numbers of the header that restore the values."""
    windows, references = database.windows, database.references
    if not len(references):
        raise DatabaseError("The database has no landmark to export. Choose another database or a larger area.")
    columns, rows = windows.first_pixels.T
    origin = references.positions.min(axis=0)
    step = 2 * precision
    steps = np.rint((references.positions - origin) / step)
    if steps.max() > np.iinfo(np.uint32).max:
        raise DatabaseError(
            "The precision of {precision:g} m is too fine for the extent of the map. Choose a larger one.",
            precision=precision,
        )
    if not (references.areas_m2 > 0).all():
        raise DatabaseError("A landmark has no area. Build the database again.")
    logs = np.log(references.areas_m2)
    area_step = max(float(logs.max() - logs.min()), 1e-9) / AREA_STEPS
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


def _window_sizes_px(database: ReferenceDatabase) -> list:
    """Return the edge of the windows of each level, in pixels of the label map."""
    windows, parameters = database.windows, database.parameters
    sizes = [windows.sizes[windows.levels == n + 1] for n in range(len(parameters.levels))]
    whole = [np.unique(np.rint(s / parameters.pixel_size)).astype(int).tolist() for s in sizes]
    if any(len(s) > 1 for s in whole) or not np.isin(windows.levels, np.arange(1, len(whole) + 1)).all():
        raise DatabaseError("The windows have other sizes than their levels. Build the database again.")
    return [s[0] if s else 0 for s in whole]


def _vector_steps(windows: Windows, class_count: int) -> np.ndarray:
    """Return (N, 3·X) uint8: ratios and differences in 255 steps, then whole ranks; zeros without a vector."""
    scale = np.repeat([VECTOR_STEPS, VECTOR_STEPS, class_count], windows.vectors.shape[1] // 3)
    return np.where(windows.described[:, None], np.rint(windows.vectors * scale), 0).astype(np.uint8)


def _npy(array: np.ndarray) -> bytes:
    file = io.BytesIO()
    np.lib.format.write_array(file, array, version=(1, 0), allow_pickle=False)
    return file.getvalue()
