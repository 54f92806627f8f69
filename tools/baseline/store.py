"""A recording on disk: a JSON file of values and an .npz file of arrays for each section."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any, Callable

import numpy as np

MANIFEST = "manifest.json"


class RecordingError(Exception):
    """A folder is no recording, or can't become one; the text says why."""


def plain(value: Any, text: Callable[[str], str] = str) -> Any:
    """A value as JSON has it: numbers, texts, lists, dicts with text keys. ``text`` is applied to every text."""
    if value is None or isinstance(value, (bool, int, float)):
        return value
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, dict):
        return {text(str(key)): plain(part, text) for key, part in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [plain(part, text) for part in value]
    return text(str(value))


def write_json(path: Path, content: Any) -> None:
    """Canonical JSON: keys in order, floats by repr."""
    path.write_text(json.dumps(content, sort_keys=True, indent=0, ensure_ascii=False) + "\n", encoding="utf-8")


def write_section(folder: Path, name: str, values: dict[str, Any], arrays: dict[str, np.ndarray]) -> None:
    """Writes what one section recorded."""
    write_json(folder / f"{name}.json", values)
    if arrays:
        np.savez_compressed(folder / f"{name}.npz", **{key.replace("/", "|"): part for key, part in arrays.items()})


def empty_folder(folder: Path) -> None:
    """Makes the folder, or takes an older recording out of it."""
    folder.mkdir(parents=True, exist_ok=True)
    found = [path for path in folder.iterdir() if path.name != MANIFEST]
    if found and not (folder / MANIFEST).exists():
        raise RecordingError(f"{folder} is not empty and no recording; choose another folder.")
    for path in (*found, folder / MANIFEST):
        if path.suffix in (".json", ".npz"):
            path.unlink(missing_ok=True)


def read_manifest(folder: Path) -> dict[str, Any]:
    """What was recorded, when and with what."""
    path = folder / MANIFEST
    manifest = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    if not manifest.get("complete"):
        raise RecordingError(f"{folder} is no recording, or its recording was cut short.")
    return manifest


def read_recording(folder: Path) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """(values, arrays) of all sections by “section/what”."""
    read_manifest(folder)
    values: dict[str, Any] = {}
    arrays: dict[str, np.ndarray] = {}
    for path in sorted(folder.glob("*.json")):
        if path.name != MANIFEST:
            content = json.loads(path.read_text(encoding="utf-8"))
            values.update({f"{path.stem}/{what}": value for what, value in content.items()})
    for path in sorted(folder.glob("*.npz")):
        with np.load(path) as content:
            arrays.update({f"{path.stem}/{key.replace('|', '/')}": content[key] for key in content.files})
    return values, arrays


def is_number(value: Any) -> bool:
    """Return whether a value is a number. True and False are not numbers."""
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def same_float(a: float, b: float) -> bool:
    """Bit for bit, but that every NaN is like every other."""
    return a == b and math.copysign(1, a) == math.copysign(1, b) or a != a and b != b


def names(values: dict[str, Any], arrays: dict[str, np.ndarray]) -> list[str]:
    """Names of everything in a recording, in order."""
    return sorted({*values, *arrays})
