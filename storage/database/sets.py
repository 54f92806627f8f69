"""A set of databases that are used as one: a small text file that names them (docs/file-formats.md#database-set)."""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Sequence
from pathlib import Path

from ...core.errors import DatabaseError
from ...core.values import checked, read_json, short_text

SUFFIX = ".semrefset"
"""By this a set is told from a database, in large letters as well."""

FORMAT = "SemRef database set"
FORMAT_VERSION = 1

_LARGEST_BYTES = 4 << 20
_MOST_PARTS = 10_000
_LONGEST_PATH = 4096


def is_set(path: str) -> bool:
    """Whether a path is that of a set, by its name."""
    return path.lower().endswith(SUFFIX)


def require_no_set(path: str) -> None:
    """Raises DatabaseError for a set where one database is wanted."""
    if is_set(path):
        raise DatabaseError("storage.set_is_read_only", path=path)


def parts_of(path: str) -> list[str]:
    """Paths of the databases that a set names, in its order.

    Raises:
        DatabaseError: The set, or a database in it, is missing, or the file is none.
    """
    if not os.path.isfile(path):
        raise DatabaseError("storage.no_database", path=path)
    try:
        with open(path, "rb") as file:
            content = file.read(_LARGEST_BYTES + 1)
        if len(content) > _LARGEST_BYTES:
            raise ValueError(f"it has more than {_LARGEST_BYTES >> 20} MB")
        named = _named(checked(read_json(content.decode("utf-8-sig")), dict, "its content"), path)
    except OSError as error:
        raise _unreadable(path, error.strerror or error) from None
    except (KeyError, TypeError, ValueError, LookupError, RecursionError) as error:
        raise _unreadable(path, error) from None
    folder = Path(path).resolve().parent
    found = [str(folder / name) for name in named]
    require_parts(path, found)
    return found


def require_parts(path: str, parts: Sequence[str]) -> None:
    """Raises DatabaseError for databases that a set can't have: missing ones, sets, one of them twice.

    Args:
        path: Of the set.
        parts: Paths of the databases.
    """
    seen: set[str] = set()
    for part in parts:
        if is_set(part):
            raise DatabaseError("storage.set_in_set", path=path, part=part)
        if not os.path.isfile(part):
            raise DatabaseError("storage.set_part_missing", path=path, part=part)
        if os.path.realpath(part) in seen:
            raise DatabaseError("storage.set_names_twice", path=path, part=part)
        seen.add(os.path.realpath(part))


def files_of(path: str) -> list[str]:
    """All files that a database, or a set, is read from; of a set that can't be read itself alone."""
    with contextlib.suppress(DatabaseError):
        return [path, *(parts_of(path) if is_set(path) else ())]
    return [path]


def set_text(path: str, parts: Sequence[str]) -> str:
    """What a set says, with paths from its folder on where databases lie on the same drive.

    Args:
        path: Where the set will lie.
        parts: Paths of the databases; of equally old ones the last counts most.
    """
    folder = Path(path).resolve().parent
    named = [{"path": _from(folder, Path(part).resolve())} for part in parts]
    return (
        json.dumps({"format": FORMAT, "version": FORMAT_VERSION, "parts": named}, indent=2, ensure_ascii=False) + "\n"
    )


def _named(content: dict, path: str) -> list[str]:
    """The paths as they stand in a set; raises ValueError and its like for anything else."""
    if content.get("format") != FORMAT:
        raise ValueError(f"its format is not “{FORMAT}”")
    version = checked(content["version"], int, "version")
    if version > FORMAT_VERSION:
        raise DatabaseError("database.newer_format", source=path, version=version, known=FORMAT_VERSION)
    parts = checked(content["parts"], list, "parts")
    if not 0 < len(parts) <= _MOST_PARTS:
        raise ValueError(f"it names {len(parts)} databases")
    named = [short_text(checked(part, dict, "a part")["path"], "path", _LONGEST_PATH) for part in parts]
    if not all(name.strip() and "\0" not in name for name in named):
        raise ValueError("a path is empty")
    return named


def _from(folder: Path, part: Path) -> str:
    try:
        return Path(os.path.relpath(part, folder)).as_posix()
    except ValueError:
        # Another drive of Windows.
        return part.as_posix()


def _unreadable(path: str, reason: object) -> DatabaseError:
    text = f"{reason} is missing" if isinstance(reason, KeyError) else " ".join(str(reason).split()).rstrip(".")
    return DatabaseError("storage.set_unreadable", path=path, reason=text[:200] or type(reason).__name__)
