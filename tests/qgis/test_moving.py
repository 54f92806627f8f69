"""Outputs of one run move together: whoever is killed at any moment of it is taken back by the next one."""

from __future__ import annotations

import json
import os
import shutil
import signal
import sys
from pathlib import Path

import pytest

from semref.core.errors import ParameterError
from semref.storage import locks, moving
from semref.storage.files import Batch

OLD, NEW, GONE = "old", "new", "gone"


@pytest.fixture(autouse=True)
def quick_disk(monkeypatch):
    """Waiting for the disk takes most of the time, and only a power cut would tell."""
    monkeypatch.setattr(os, "fsync", lambda _: None)


def lay_out(folder: Path) -> None:
    """Places of two outputs with an older one, one of them with a companion, one without, and an older folder."""
    (folder / "other").mkdir(parents=True)
    for name in ("a.gpkg", "a.gpkg-wal", "other/b.csv", "inputs.txt"):
        (folder / name).write_text(OLD)
    (folder / "tiles").mkdir()
    for name in ("mark", "1"):
        (folder / "tiles" / name).write_text(OLD)


def write(folder: Path) -> None:
    with Batch() as batch:
        Path(batch.file(str(folder / "a.gpkg"))).write_text(NEW)
        b = Path(batch.file(str(folder / "other" / "b.csv")))
        b.write_text(NEW)
        b.with_suffix(".prj").write_text(NEW)
        Path(batch.file(str(folder / "c.txt"))).write_text(NEW)
        tiles = Path(batch.folder(str(folder / "tiles"), "mark"))
        for name in ("mark", "1"):
            (tiles / name).write_text(NEW)
        batch.commit()


def content(folder: Path) -> dict[str, str]:
    """Text of each file by its path, what is hidden included."""
    return {str(path.relative_to(folder)): path.read_text() for path in sorted(folder.rglob("*")) if path.is_file()}


def killed_at(number: int, work, *events: str) -> bool:
    """Whether a child was killed before the ``number``-th thing that it did to files."""
    child = os.fork()
    if child == 0:
        done = 0

        def look(event: str, arguments: tuple) -> None:
            nonlocal done
            if event in events:
                if done == number:
                    os.kill(os.getpid(), signal.SIGKILL)
                done += 1

        sys.addaudithook(look)
        try:
            work()
        finally:
            os._exit(0)
    return os.WIFSIGNALED(os.waitpid(child, 0)[1])


TOUCHES = ("os.rename", "os.link", "os.remove", "os.rmdir", "os.mkdir", "open", "tempfile.mkdtemp", "os.scandir")


@pytest.fixture
def states(tmp_path):
    """What the places hold before and after a run that nothing happens to."""
    lay_out(tmp_path / "sound")
    before = content(tmp_path / "sound")
    write(tmp_path / "sound")
    after = content(tmp_path / "sound")
    assert set(after) == {*before, "c.txt", "other/b.prj"} - {"a.gpkg-wal"}
    assert {name for name, text in after.items() if text == NEW} == {*after} - {"inputs.txt"}
    return before, after


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_a_run_killed_at_any_moment_is_taken_back_or_complete(tmp_path, states):
    before, after = states
    seen = []
    for number in range(1000):
        folder = tmp_path / str(number)
        lay_out(folder)
        was_killed = killed_at(number, lambda folder=folder: write(folder), *TOUCHES)
        for path in (folder, folder / "other"):
            moving.clear(path)
        found = content(folder)
        assert found in (before, after), f"killed at {number}"
        assert list(folder.rglob(".*")) == []
        seen.append(found == after)
        if not was_killed:
            break
    # All moments before the last move give the old, all after it the new.
    assert seen == sorted(seen) and 40 < seen.index(True) < len(seen) - 10 and found == after


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_who_takes_back_may_be_killed_at_any_moment(tmp_path, states):
    before, _ = states
    for number in range(1000):
        folder = tmp_path / str(number)
        lay_out(folder)
        # The last thing that moves: everything else has moved.
        child_dies_before_the_last_move(folder)
        assert content(folder) != before
        was_killed = killed_at(number, lambda folder=folder: moving.clear(folder), *TOUCHES)
        for path in (folder, folder / "other"):
            moving.clear(path)
        assert content(folder) == before, f"killed at {number}"
        assert list(folder.rglob(".*")) == []
        if not was_killed:
            break
    assert number > 20


def child_dies_before_the_last_move(folder: Path) -> None:
    child = os.fork()
    if child == 0:
        real = moving._do

        def move(plan, what):
            if what.name == "tiles":
                os.replace(folder / "tiles", plan.workplace / ".older" / "tiles")
                os.kill(os.getpid(), signal.SIGKILL)
            real(plan, what)

        moving._do = move
        write(folder)
    assert os.WIFSIGNALED(os.waitpid(child, 0)[1])


@pytest.mark.parametrize("name", ["a.gpkg", "b.csv", "b.prj", "c.txt", "tiles"])
def test_one_that_cant_be_moved_takes_all_back(tmp_path, states, monkeypatch, name):
    before, _ = states
    lay_out(tmp_path / "here")
    real = os.replace

    def replace(source, target):
        if Path(target).name == name and Path(target).parent.name in ("here", "other") and ".older" not in str(source):
            raise PermissionError(13, "Permission denied", str(target))
        real(source, target)

    monkeypatch.setattr(os, "replace", replace)
    with pytest.raises(ParameterError, match=name):
        write(tmp_path / "here")
    assert content(tmp_path / "here") == before
    assert list((tmp_path / "here").rglob(".*")) == []


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_what_was_changed_since_a_kill_stays(tmp_path):
    lay_out(tmp_path)
    child_dies_before_the_last_move(tmp_path)
    (tmp_path / "a.gpkg").write_text("edited by the user")
    moving.clear(tmp_path)
    moving.clear(tmp_path / "other")
    assert (tmp_path / "a.gpkg").read_text() == "edited by the user"
    assert (tmp_path / "other" / "b.csv").read_text() == NEW
    assert (tmp_path / "tiles" / "mark").read_text() == OLD
    assert list(tmp_path.rglob(".*")) == []


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_a_folder_that_was_renamed_since_a_kill_is_taken_back(tmp_path, states):
    before, _ = states
    lay_out(tmp_path / "flight")
    (tmp_path / "flight" / "other").rename(tmp_path / "flight" / "kept")
    (tmp_path / "flight" / "other").symlink_to("kept")
    child = os.fork()
    if child == 0:
        real = moving._do

        def die(plan, what):
            if what.name == "c.txt":
                os.kill(os.getpid(), signal.SIGKILL)
            real(plan, what)

        moving._do = die
        with Batch() as batch:
            for name in ("a.gpkg", "c.txt"):
                Path(batch.file(str(tmp_path / "flight" / name))).write_text(NEW)
            batch.commit()
    os.waitpid(child, 0)
    assert (tmp_path / "flight" / "a.gpkg").read_text() == NEW
    (tmp_path / "flight").rename(tmp_path / "renamed")
    moving.clear(tmp_path / "renamed")
    assert {name: text for name, text in content(tmp_path / "renamed").items() if "kept" not in name} == {
        name: text for name, text in before.items() if "other" not in name
    }


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_a_copy_that_was_cut_short_replaces_nothing(tmp_path, states, monkeypatch):
    """Where the file system has no links."""
    before, after = states

    def no_link(*_):
        raise OSError(95, "Operation not supported")

    def cut(source, target, **_):
        Path(target).write_text("ol")
        os.kill(os.getpid(), signal.SIGKILL)

    lay_out(tmp_path / "here")
    monkeypatch.setattr(os, "link", no_link)
    child = os.fork()
    if child == 0:
        moving.shutil.copy2 = cut
        write(tmp_path / "here")
    assert os.WIFSIGNALED(os.waitpid(child, 0)[1])
    moving.clear(tmp_path / "here")
    moving.clear(tmp_path / "here" / "other")
    assert content(tmp_path / "here") == before
    write(tmp_path / "here")
    assert content(tmp_path / "here") == after


def test_a_plan_from_a_stranger_speaks_only_for_its_own_folder(tmp_path):
    victim = tmp_path / "victim"
    (victim / ".x.part").mkdir(parents=True)
    (victim / "precious").write_text(OLD)
    (victim / ".x.part" / ".lock").touch()
    planted = tmp_path / "unpacked" / ".x.part"
    (planted / ".older").mkdir(parents=True)
    (planted / ".older" / "precious").write_text("evil")
    (planted / ".lock").touch()
    (planted / ".moving").touch()
    for moves in ([["../../victim/precious", None, None, True, False]], [["precious", None, None, True, False]]):
        for places in ([planted, victim / ".x.part"], [planted], [victim / ".x.part", planted], [victim]):
            said = {"workplaces": [str(place) for place in places], "moves": moves}
            (planted / ".moves").write_text(json.dumps(said))
            moving.clear(planted.parent)
            assert (victim / "precious").read_text() == OLD
            assert (victim / ".x.part" / ".lock").exists()
            planted.mkdir(parents=True, exist_ok=True)
            for name in (".lock", ".moving"):
                (planted / name).touch()


@pytest.mark.parametrize("text", ["", "[", "[1]", '{"workplaces": 1}', '{"workplaces": [], "moves": []}', "ÿ"])
def test_a_plan_that_is_none_is_left_alone(tmp_path, text):
    stray = tmp_path / ".a.part"
    stray.mkdir()
    for name in (".lock", ".moving"):
        (stray / name).touch()
    (stray / ".moves").write_text(text, encoding="utf-8")
    moving.clear(tmp_path)
    assert stray.exists()
    (stray / ".moving").unlink()
    moving.clear(tmp_path)
    assert not stray.exists()


def test_a_living_run_is_left_alone(tmp_path):
    lay_out(tmp_path)
    with Batch() as batch:
        Path(batch.file(str(tmp_path / "a.gpkg"))).write_text(NEW)
        moving.clear(tmp_path)
        batch.commit()
    assert (tmp_path / "a.gpkg").read_text() == NEW


def test_an_empty_workplace_of_a_dead_run_is_removed_and_a_living_one_makes_it_again(tmp_path, monkeypatch):
    (tmp_path / ".dead.part").mkdir()
    real, removed = locks.held, []

    def held(path):
        if not removed:
            removed.append(path)
            moving.clear(tmp_path)
        return real(path)

    monkeypatch.setattr("semref.storage.files.held", held)
    with Batch() as batch:
        path = Path(batch.file(str(tmp_path / "a.txt")))
        assert not (tmp_path / ".dead.part").exists() and not removed[0].parent.exists()
        path.write_text(NEW)
        batch.commit()
    assert content(tmp_path) == {"a.txt": NEW}


def test_a_check_that_fails_last_of_all_leaves_all_as_it_was(tmp_path, states):
    before, _ = states
    lay_out(tmp_path / "here")

    def changed() -> None:
        raise ParameterError("storage.database_changed", path="a.gpkg")

    with Batch() as batch, pytest.raises(ParameterError, match="changed by another program"):
        Path(batch.file(str(tmp_path / "here" / "a.gpkg"))).write_text(NEW)
        batch.commit(changed)
    shutil.rmtree(tmp_path / "sound")
    assert content(tmp_path / "here") == before


def test_a_folder_that_others_filled_meanwhile_is_left_alone(tmp_path):
    target = tmp_path / "labels"
    with Batch() as batch, pytest.raises(ParameterError, match="holds other files"):
        (Path(batch.folder(str(target))) / "1.png").write_text(NEW)
        target.mkdir()
        (target / "precious.png").write_text(OLD)
        batch.commit()
    assert content(tmp_path) == {"labels/precious.png": OLD}
