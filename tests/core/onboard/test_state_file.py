import os

import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.onboard.state_file import StateFile

ARRAYS = {"header": np.arange(40, dtype=np.uint8), "tracker_counts": np.array([1.5, 2.5])}
KEY = bytes(range(32))


@pytest.fixture
def state(tmp_path):
    found = StateFile(str(tmp_path / "flight.npz"), KEY)
    found.write(found.pack(ARRAYS))
    return found


def test_what_was_written_is_read(state):
    found = state.read()
    assert found.keys() == ARRAYS.keys()
    assert all((found[name] == ARRAYS[name]).all() for name in ARRAYS)


def test_every_byte_is_authenticated_before_anything_is_parsed(state, tmp_path, monkeypatch):
    path = tmp_path / "flight.npz"
    data = path.read_bytes()
    monkeypatch.setattr("numpy.load", lambda *_, **__: pytest.fail("it was parsed"))
    for place in range(len(data)):
        path.write_bytes(data[:place] + bytes([data[place] ^ 1]) + data[place + 1 :])
        with pytest.raises(ParameterError, match="changed since"):
            state.read()
    for wrong in (*(data[:count] for count in (0, 10, 32, len(data) - 1)), data + b"1"):
        path.write_bytes(wrong)
        with pytest.raises(ParameterError, match="changed since"):
            state.read()


def test_another_key_and_a_signature_for_something_else_are_refused(state, tmp_path):
    """A signature of other bytes with the same key, such as an onboard file's, is not valid for a state."""
    import hashlib
    import hmac

    data = (tmp_path / "flight.npz").read_bytes()[:-32]
    (tmp_path / "flight.npz").write_bytes(data + hmac.new(KEY, data, hashlib.sha256).digest())
    with pytest.raises(ParameterError, match="changed since"):
        state.read()
    with pytest.raises(ParameterError, match="another key than this flight"):
        StateFile(state.path, KEY[::-1]).read()


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with names")
@pytest.mark.parametrize("make", [os.mkfifo, os.mkdir])
def test_what_is_no_regular_file_is_refused_at_once(tmp_path, make):
    make(tmp_path / "flight.npz")
    with pytest.raises(ParameterError, match="not a regular file"):
        StateFile.at(str(tmp_path / "flight.npz"), None)
    with pytest.raises((ParameterError, OSError)):
        StateFile(str(tmp_path / "flight.npz"), KEY).read()


@pytest.mark.skipif(not hasattr(os, "symlink") or os.name == "nt", reason="rights of POSIX")
def test_a_link_is_replaced_and_what_it_leads_to_stays(tmp_path):
    (tmp_path / "victim").write_bytes(b"mine")
    (tmp_path / "flight.npz").symlink_to(tmp_path / "victim")
    state = StateFile(str(tmp_path / "flight.npz"), KEY)
    state.write(state.pack(ARRAYS))
    assert (tmp_path / "victim").read_bytes() == b"mine" and not (tmp_path / "flight.npz").is_symlink()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["flight.npz", "victim"]


@pytest.mark.parametrize("content", [b"my notes", b"PK\x03\x04" + b"another archive" * 10])
def test_a_file_of_the_user_is_not_replaced(tmp_path, content):
    path = tmp_path / "notes.npz"
    path.write_bytes(content)
    with pytest.raises(ParameterError, match="of another kind"):
        StateFile.at(str(path), None)
    assert path.read_bytes() == content


@pytest.mark.parametrize("left", [b"", bytes(5000)])
def test_a_file_that_a_power_failure_emptied_is_no_obstacle(tmp_path, left):
    path = tmp_path / "flight.npz"
    path.write_bytes(left)
    assert StateFile.at(str(path), None).path == str(path)


def test_a_missing_folder_is_refused_by_name_and_without_a_secret_a_key_is_asked_for(tmp_path, monkeypatch):
    with pytest.raises(ParameterError, match="nowhere.*does not exist"):
        StateFile.at(str(tmp_path / "nowhere" / "flight.npz"), None)
    monkeypatch.setattr("semref.core.onboard.state_file.user_secret", lambda: None)
    with pytest.raises(ParameterError, match="--require-signature"):
        StateFile.at(str(tmp_path / "flight.npz"), None)
    (tmp_path / "key").write_bytes(KEY)
    assert StateFile.at(str(tmp_path / "flight.npz"), str(tmp_path / "key")).key == KEY
