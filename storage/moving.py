"""How the outputs of one run move to their places together, and what the next run does when one died over it.

Told in docs/decisions/outputs.md.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

from ..core.errors import ParameterError
from ..core.values import checked, read_json
from .locks import claimed, folders_held

SUFFIX, LOCK = ".part", ".lock"
"""Folders of unfinished outputs are hidden and end so; the file in them is locked while their run lives."""

_OLDER = ".older"
"""Folder in a workplace: what its outputs replace lies there until all are moved."""

_PLAN, _MOVING = ".moves", ".moving"
"""What a workplace will move, written before; the mark in the first workplace of a run while anything is moved."""

_LARGEST_PLAN = 8 << 20
"""Characters: an output has a handful of companions, and a run a handful of outputs."""

_OWN = (LOCK, _OLDER, _PLAN, _MOVING)

State = tuple[int, int]
"""(bytes, time of change in ns) of a file: what it keeps when it is moved, linked or copied."""


@dataclass(frozen=True)
class Move:
    """One file or folder that goes from a workplace to its place beside it, or an older companion that goes.

    Attributes:
        name: Its name in both places.
        old: The state of the older file; None where there is none, and for a folder.
        new: The state of the new one; None for a companion that goes, and for a folder.
        has_old: Whether there is an older one.
        is_folder: Whether it is a folder.
    """

    name: str
    old: State | None
    new: State | None
    has_old: bool
    is_folder: bool = False


@dataclass(frozen=True)
class Plan:
    """What one workplace moves.

    Attributes:
        workplace: The folder beside the places.
        moves: In order.
    """

    workplace: Path
    moves: tuple[Move, ...]

    @property
    def folder(self) -> Path:
        """Where its outputs go."""
        return self.workplace.parent


def move_of(workplace: Path, name: str) -> Move:
    """The move of one name as things are now."""
    source, target = workplace / name, workplace.parent / name
    is_folder = source.is_dir()
    return Move(name, _state(target), None if is_folder else _state(source), os.path.lexists(target), is_folder)


def is_own(name: str) -> bool:
    """Whether a name in a workplace is none of an output."""
    return name in _OWN


def move_all(plans: Sequence[Plan]) -> None:
    """Moves everything; when one can't be moved, those that were are taken back.

    Whoever is killed meanwhile is taken back by the next run, see ``clear``.

    Raises:
        ParameterError: An older file can't be replaced.
        OSError: The disk can't take what was written.
    """
    if not plans:
        # Outputs in memory alone.
        return
    moves = [(plan, move) for plan in plans for move in plan.moves]
    if not moves:
        return
    if len(moves) == 1 and not (moves[0][1].is_folder and moves[0][1].has_old):
        # One rename is all or nothing by itself.
        _do(*moves[0])
        _flush_folder(plans[0].folder)
        return
    mark = plans[0].workplace / _MOVING
    for plan in plans:
        _keep_older(plan)
        _write_plan(plan, plans)
    mark.touch()
    _flush_folder(mark.parent)
    try:
        for plan, move in moves:
            _do(plan, move)
        for plan in plans:
            _flush_folder(plan.folder)
    except BaseException:
        # Where even this fails the mark stays, and the next run tries again.
        _take_back(plans)
        mark.unlink()
        raise
    mark.unlink()
    _flush_folder(mark.parent)


def is_moving(workplace: Path) -> bool:
    """Whether a run stopped halfway and could not be taken back."""
    return (workplace / _MOVING).exists()


def clear(folder: Path) -> None:
    """Removes what dead runs left in a folder; one that died while it moved its outputs is taken back first.

    Nothing is said of what can't be removed: it is in nobody's way.
    """
    try:
        entries = list(os.scandir(os.path.realpath(folder)))
        found = [Path(entry.path) for entry in entries if _is_workplace_name(entry.name) and entry.is_dir()]
    except OSError:
        return
    for workplace in found:
        with contextlib.suppress(OSError, ValueError):
            _clear(workplace)


def dismantle(workplace: Path, lock: IO[bytes] | None = None) -> None:
    """Removes a workplace, its lock last: what is left of one is recognized as a dead run's."""
    with contextlib.suppress(OSError):
        for entry in list(os.scandir(workplace)):
            if entry.name != LOCK:
                _remove(Path(entry.path))
        if lock is not None:
            # Windows removes no file that is open.
            lock.close()
        (workplace / LOCK).unlink(missing_ok=True)
        workplace.rmdir()


def _clear(workplace: Path) -> None:
    if not (workplace / LOCK).exists():
        # Of a run that died before it had one, or makes it just now and then makes both again.
        workplace.rmdir()
        return
    together = _together(workplace)
    locks = [claimed(place / LOCK) for place in together]
    try:
        if all(lock is not None for lock in locks):
            if is_moving(together[0]):
                plans = [_read_plan(place) for place in together]
                with folders_held(plan.folder for plan in plans):
                    if all(_is_untouched(plan) for plan in plans):
                        _take_back(plans)
                    else:
                        _fill_gaps(plans)
                    (together[0] / _MOVING).unlink()
            for place, lock in zip(together, locks):
                dismantle(place, lock)
    finally:
        for lock in locks:
            if lock is not None:
                lock.close()


def _together(workplace: Path) -> list[Path]:
    """The workplaces of one run that was moving its outputs; only this one where it was not.

    Raises:
        OSError: One of them can't be reached.
    """
    try:
        places = _places(workplace)
    except (FileNotFoundError, ValueError):
        if is_moving(workplace):
            raise
        # Killed before it was written to its end, and so before anything was moved.
        return [workplace]
    if not (places[0] / _MOVING).exists():
        # Moved or taken back; but who can't look must not say so.
        os.stat(places[0].parent)
        return [workplace]
    # They must name each other: a file from a stranger can speak only for the folder that it lies in.
    if workplace not in places or any(_places(place) != places for place in places):
        raise ValueError("a plan that others don't know of")
    return places


# --- forth ---


def _do(plan: Plan, move: Move) -> None:
    source, target = plan.workplace / move.name, plan.folder / move.name
    try:
        if move.has_old and target.is_dir():
            os.replace(target, plan.workplace / _OLDER / move.name)
        if move.is_folder or move.new is not None:
            os.replace(source, target)
        else:
            target.unlink()
    except PermissionError:
        raise ParameterError("storage.not_replaceable", path=target) from None


def _keep_older(plan: Plan) -> None:
    """Gives each older file a second name: at no moment is there none under its own."""
    older = plan.workplace / _OLDER
    older.mkdir()
    for move in plan.moves:
        if move.has_old and not (plan.folder / move.name).is_dir():
            _link(plan.folder / move.name, older / move.name)
    _flush_folder(older)


def _link(path: Path, name: Path) -> None:
    """A second name for a file; where the file system has no such links, a copy."""
    try:
        os.link(path, name)
    except (OSError, NotImplementedError, AttributeError):
        shutil.copy2(path, name, follow_symlinks=False)
        flush(name)


def _write_plan(plan: Plan, plans: Sequence[Plan]) -> None:
    said = {
        "workplaces": [os.path.realpath(other.workplace) for other in plans],
        "moves": [[move.name, move.old, move.new, move.has_old, move.is_folder] for move in plan.moves],
    }
    path = plan.workplace / _PLAN
    path.write_text(json.dumps(said), encoding="ascii")
    flush(path)
    _flush_folder(plan.workplace)


# --- and back ---


def _take_back(plans: Sequence[Plan]) -> None:
    """Puts every older file back to its place; once more does no harm."""
    for plan in reversed(plans):
        for move in reversed(plan.moves):
            older, target = plan.workplace / _OLDER / move.name, plan.folder / move.name
            if os.path.lexists(older):
                if target.is_dir() and not target.is_symlink():
                    shutil.rmtree(target)
                os.replace(older, target)
            elif not move.has_old and not os.path.lexists(plan.workplace / move.name):
                _remove(target)
        _flush_folder(plan.folder)


def _fill_gaps(plans: Sequence[Plan]) -> None:
    """Puts older files back only where nothing is: somebody has gone on with what was moved."""
    for plan in plans:
        for move in plan.moves:
            older, target = plan.workplace / _OLDER / move.name, plan.folder / move.name
            if os.path.lexists(older) and not os.path.lexists(target):
                os.replace(older, target)


def _is_untouched(plan: Plan) -> bool:
    """Whether all that lies in the places is what the run put or left there."""
    for move in plan.moves:
        if not move.is_folder and move.old is None and move.has_old:
            continue
        if not move.is_folder and _state(plan.folder / move.name) not in (move.old, move.new):
            return False
    return True


def _places(workplace: Path) -> list[Path]:
    said = checked(_said(workplace).get("workplaces"), list, "workplaces")
    places = [Path(checked(place, str, "a workplace")) for place in said]
    if not places or not all(_is_workplace_name(place.name) for place in places):
        raise ValueError("no workplaces")
    # The folder may be called otherwise now than when the run lived.
    called = [place.parent for place in places if place.name == workplace.name]
    return [workplace.with_name(place.name) if place.parent in called else place for place in places]


def _read_plan(workplace: Path) -> Plan:
    """Raises ValueError for what ``_write_plan`` did not write, OSError where it can't be read."""
    moves = []
    for entry in checked(_said(workplace).get("moves"), list, "moves"):
        name, old, new, has_old, is_folder = checked(entry, list, "a move")
        if os.path.basename(checked(name, str, "a name")) != name or name in ("", ".", ".."):
            raise ValueError("a name with a folder")
        moves.append(Move(name, _read_state(old), _read_state(new), has_old is True, is_folder is True))
    return Plan(workplace, tuple(moves))


def _read_state(value: object) -> State | None:
    if value is None:
        return None
    size, changed = checked(value, list, "a state")
    return checked(size, int, "a size"), checked(changed, int, "a time")


def _said(workplace: Path) -> dict[str, Any]:
    with (workplace / _PLAN).open(encoding="ascii") as file:
        return checked(read_json(file.read(_LARGEST_PLAN + 1), _LARGEST_PLAN), dict, "a plan")


# --- files ---


def flush(path: Path) -> None:
    """Has what was written reach the disk, so that a full one is heard of before anything is moved."""
    files = [path] if path.is_file() else [child for child in path.rglob("*") if child.is_file()]
    for file in files:
        # Windows flushes only files that may be written to.
        with file.open("rb+") as opened:
            os.fsync(opened.fileno())
    for folder in {file.parent for file in files}:
        _flush_folder(folder)


def _flush_folder(folder: Path) -> None:
    """Has new names reach the disk, too, where the system can."""
    with contextlib.suppress(OSError):
        number = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(number)
        finally:
            os.close(number)


def _state(path: Path) -> State | None:
    try:
        found = os.lstat(path)
    except OSError:
        return None
    return None if path.is_dir() and not path.is_symlink() else (found.st_size, found.st_mtime_ns)


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def _is_workplace_name(name: str) -> bool:
    return name.startswith(".") and name.endswith(SUFFIX)
