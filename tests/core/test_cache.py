import hashlib
import json
import os
import subprocess
import sys
import time
import zlib
from unittest.mock import Mock

import numpy as np
import pytest

from semref.core import cache, limits
from semref.core.cache import cache_folder, digest, load_or_build, user_secret

KEY = digest([b"area"])
ON_POSIX = pytest.mark.skipif(os.name == "nt", reason="Windows protects the folder by its access list")


def arrays(seed=0):
    rng = np.random.default_rng(seed)
    return {
        "keys": rng.integers(0, 1 << 32, 700, np.uint32),
        "planes": rng.random((7, 9, 3), np.float32)[:, ::-1],
        "none": np.zeros((0, 3), np.float32),
        "flags": rng.integers(0, 255, (50, 2), np.uint8),
    }


@pytest.fixture(autouse=True)
def folder(monkeypatch, tmp_path):
    monkeypatch.setenv("SEMREF_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def path(folder):
    return folder / f"index-{KEY}.semref-cache"


def assert_same(found, expected):
    assert list(found) == list(expected)
    for name, array in expected.items():
        assert found[name].dtype == array.dtype and found[name].shape == array.shape
        np.testing.assert_array_equal(found[name], array)


def loaded(seed=0, key=KEY):
    return load_or_build("index", key, lambda: arrays(seed))


def test_arrays_are_built_once_and_then_loaded_to_the_last_bit(path):
    assert_same(loaded(), arrays())
    assert sorted(file.name for file in path.parent.iterdir()) == [path.name, "secret"]
    found = loaded(1)
    assert_same(found, arrays())
    assert not found["keys"].flags.owndata and not found["keys"].flags.writeable


def test_a_file_under_the_name_of_other_content_is_not_believed(path):
    loaded(1, digest([b"other"]))
    (other,) = path.parent.glob("index-*")
    os.replace(other, path)
    assert_same(loaded(), arrays())


def test_a_file_that_is_damaged_anywhere_is_built_again(path):
    loaded()
    whole = path.read_bytes()
    places = {*range(0, 300, 7), *np.random.default_rng(3).integers(300, len(whole), 60).tolist()}
    for place in sorted(places):
        path.write_bytes(whole[:place] + bytes([whole[place] ^ 4]) + whole[place + 1 :])
        assert_same(loaded(1), arrays(1))
    for length in (0, 1, 31, 32, 35, 36, 300, len(whole) // 2, len(whole) - 1):
        path.write_bytes(whole[:length])
        assert_same(loaded(2), arrays(2))
        assert_same(loaded(3), arrays(2))
    path.write_bytes(whole + b"x")
    assert_same(loaded(4), arrays(4))


def test_a_forged_file_is_built_again_though_all_checksums_without_the_secret_are_right(path):
    loaded()
    whole = bytearray(path.read_bytes())
    whole[-100] ^= 1
    crc = zlib.crc32(whole[:-4]).to_bytes(4, "little")
    forged = [bytes(whole[:-4]) + crc, hashlib.sha256(whole[32:]).digest() + whole[32:]]
    layout = json.dumps({"keys": ["<u4", [1 << 40], 0]}).encode()
    forged.append(bytes(32) + len(layout).to_bytes(4, "little") + layout)
    for content in forged:
        path.write_bytes(content)
        assert_same(loaded(1), arrays(1))
    (path.parent / "secret").write_bytes(b"s" * 32)
    assert_same(loaded(2), arrays(2))


@ON_POSIX
@pytest.mark.parametrize("put", ["pipe", "link", "folder"])
@pytest.mark.parametrize("name", ["array", "secret"])
def test_a_pipe_a_link_or_a_folder_in_the_place_of_a_file_neither_blocks_nor_is_followed(path, tmp_path, put, name):
    loaded()
    place, victim = path if name == "array" else path.parent / "secret", tmp_path / "victim"
    victim.write_bytes(place.read_bytes())
    before = victim.read_bytes()
    place.unlink()
    puts = {"pipe": lambda: os.mkfifo(place), "link": lambda: place.symlink_to(victim), "folder": place.mkdir}
    puts[put]()
    assert_same(loaded(1), arrays(1))
    assert_same(loaded(2), arrays(2 if put == "folder" else 1))
    assert victim.read_bytes() == before and not place.is_symlink()


@ON_POSIX
def test_nothing_of_another_user_is_read_or_written(path, monkeypatch, caplog):
    loaded()
    us = os.geteuid()
    before = path.stat().st_mtime_ns
    monkeypatch.setattr(os, "geteuid", lambda: us + 1)
    assert_same(loaded(1), arrays(1))
    assert path.stat().st_mtime_ns == before and user_secret() is None
    assert [record.details["kind"] for record in caplog.records] == ["index"]


@ON_POSIX
@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root can give a file away")
def test_a_file_that_another_user_owns_is_built_again(path):
    loaded()
    os.chown(path, 65534, 65534)
    assert_same(loaded(1), arrays(1))
    assert path.stat().st_uid == 0


@ON_POSIX
def test_a_folder_that_others_can_write_to_and_a_linked_folder_are_not_used(folder, tmp_path):
    folder.mkdir()
    folder.chmod(0o777)
    assert_same(loaded(), arrays())
    folder.chmod(0o700)
    folder.rename(tmp_path / "elsewhere")
    folder.symlink_to(tmp_path / "elsewhere")
    assert_same(loaded(), arrays())
    assert list((tmp_path / "elsewhere").iterdir()) == []


@ON_POSIX
def test_only_the_user_can_read_the_folder_and_its_files(path):
    loaded()
    assert path.parent.stat().st_mode & 0o777 == 0o700
    for file in path.parent.iterdir():
        assert file.stat().st_mode & 0o777 == 0o600, file


def test_arrays_are_built_where_no_folder_can_be_made_and_for_a_user_without_a_home(monkeypatch, tmp_path, caplog):
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("SEMREF_CACHE", str(tmp_path / "file" / "cache"))
    assert_same(loaded(), arrays())
    assert_same(loaded(1), arrays(1))
    assert [record.message for record in caplog.records] == ["not_cached"] * 2
    for name in ("SEMREF_CACHE", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(cache.Path, "home", Mock(side_effect=RuntimeError("no home directory")))
    assert_same(loaded(), arrays())


def test_a_folder_that_became_read_only_is_still_read(path, monkeypatch):
    loaded()
    refused = Mock(side_effect=PermissionError(13, "Permission denied"))
    for function in ("replace", "unlink", "utime"):
        monkeypatch.setattr(os, function, refused)
    monkeypatch.setattr(cache.tempfile, "mkstemp", refused)
    assert_same(loaded(1), arrays())
    assert_same(loaded(2, digest([b"other"])), arrays(2))


def test_a_disk_that_is_full_leaves_nothing(path, monkeypatch):
    loaded()
    before = sorted(path.parent.iterdir())
    monkeypatch.setattr(os, "replace", Mock(side_effect=OSError(28, "No space left on device")))
    assert_same(loaded(1, digest([b"other"])), arrays(1))
    assert sorted(path.parent.iterdir()) == before


def test_each_system_has_its_own_cache_folder(monkeypatch, tmp_path):
    monkeypatch.delenv("SEMREF_CACHE")
    monkeypatch.setattr(cache.Path, "home", lambda: tmp_path)
    monkeypatch.setattr(sys, "platform", "darwin")
    assert cache_folder() == tmp_path / "Library" / "Caches" / "semref"
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    if os.name != "nt":
        assert cache_folder() == tmp_path / "xdg" / "semref"
        monkeypatch.setenv("XDG_CACHE_HOME", "relative")
        assert cache_folder() == tmp_path / ".cache" / "semref"


def test_the_files_used_last_remain_when_the_cache_is_full(path, monkeypatch):
    keys = [digest([bytes([n])]) for n in range(4)]
    for n, key in enumerate(keys[:3]):
        loaded(n, key)
        os.utime(path.parent / f"index-{key}.semref-cache", (1000 + n,) * 2)
    size = os.path.getsize(path.parent / f"index-{keys[0]}.semref-cache")
    loaded(9, keys[0])
    foreign = path.parent / "notes.txt"
    foreign.write_bytes(bytes(3 * size))
    os.utime(foreign, (0, 0))
    monkeypatch.setattr(limits, "CACHE_BYTES", 3 * size + 100)
    loaded(3, keys[3])
    left = {file.name[6:70] for file in path.parent.glob("index-*")}
    assert left == {keys[0], keys[2], keys[3]} and foreign.exists()


def test_arrays_that_are_larger_than_the_cache_may_be_push_nothing_out(path, monkeypatch):
    loaded()
    monkeypatch.setattr(limits, "CACHE_BYTES", path.stat().st_size)
    found = load_or_build("index", digest([b"large"]), lambda: {"large": np.zeros(1 << 16)})
    assert len(found["large"]) == 1 << 16
    assert_same(loaded(1), arrays())


def test_the_next_write_removes_what_a_killed_writer_left(path):
    path.parent.mkdir(mode=0o700)
    killed, writing = path.parent / "a.semref-tmp", path.parent / "b.semref-tmp"
    for file in (killed, writing):
        file.write_bytes(b"half")
    os.utime(killed, (0, 0))
    os.utime(writing, (time.time(),) * 2)
    loaded()
    assert path.exists() and writing.exists() and not killed.exists()


def test_processes_that_start_at_once_give_the_same_arrays(path, repository):
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); import numpy as np; from core.cache import load_or_build as f\n"
        "build = lambda: {'a': np.arange(100_000)}\n"
        "sys.exit(not all((f('index', c * 64, build)['a'] == np.arange(100_000)).all() for c in 'abcabc'))"
    )
    running = [subprocess.Popen([sys.executable, "-c", code, str(repository)]) for _ in range(3)]
    assert [process.wait() for process in running] == [0, 0, 0]
    assert not list(path.parent.glob("*.semref-tmp"))


def test_a_digest_is_that_of_the_bytes_with_their_number_before_them():
    assert digest([b"ab", b"c"]) != digest([b"a", b"bc"])
    column = np.arange(6)
    assert digest([column]) == digest([column.tobytes()]) == digest([np.repeat(column, 2)[::2]])
    bits = np.arange(4).reshape(2, 2) > 1
    expected = hashlib.sha256((4).to_bytes(8, "little") + b"\0\0\1\1" + (0).to_bytes(8, "little")).hexdigest()
    assert digest([bits, np.zeros((0, 3))]) == expected
