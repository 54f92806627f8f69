"""A signed onboard file needs its key; an unsigned file is accepted only if no signature is required."""

from __future__ import annotations

import io
import json
import zipfile
from datetime import datetime, timezone

import numpy as np
import pytest
from onboard_area import write_area

from semref.core.errors import SemRefError
from semref.core.onboard.command_line import ALL_FIXED, main
from semref.core.onboard.format import digest
from semref.core.onboard.read import read_onboard
from semref.core.onboard.signature import signature
from semref.core.onboard.write import write_onboard

FILES = {"a": b"12", "b": b"3"}
KEY = bytes(range(32))


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Return a folder with two keys, an area signed with the first key, and an unsigned area."""
    folder = tmp_path_factory.mktemp("signed")
    (folder / "key").write_bytes(KEY)
    (folder / "other_key").write_bytes(KEY[::-1])
    write_area(str(folder / "unsigned.npz"))
    database = read_onboard(str(folder / "unsigned.npz")).database
    write_onboard(str(folder / "signed.npz"), database, None, key_file=str(folder / "key"))
    return folder


def changed_by_a_stranger(folder, target, drops_signature=False) -> str:
    """Return a file with another landmark and the matching content hash."""
    with zipfile.ZipFile(folder / "signed.npz") as archive:
        files = {name[:-4]: archive.read(name) for name in archive.namelist()}
    areas = bytearray(files["references_areas"])
    areas[-1] ^= 1
    files["references_areas"] = bytes(areas)
    found = io.BytesIO()
    np.save(found, np.frombuffer(digest(files), np.uint8))
    files["content_hash"] = found.getvalue()
    if drops_signature:
        del files["signature"]
    with zipfile.ZipFile(target, "w") as archive:
        for name, data in files.items():
            archive.writestr(f"{name}.npy", data)
    return str(target)


def refusal(path, key) -> str:
    with pytest.raises(SemRefError) as refused:
        read_onboard(str(path), key_file=str(key))
    return str(refused.value)


def test_an_unsigned_file_is_refused(folder):
    assert "is not signed" in refusal(folder / "unsigned.npz", folder / "key")


def test_another_key_is_refused(folder):
    assert "was not signed with the key" in refusal(folder / "signed.npz", folder / "other_key")


@pytest.mark.parametrize(("drops_signature", "said"), [(False, "was changed since"), (True, "is not signed")])
def test_what_a_stranger_changed_is_refused_although_its_hash_fits(folder, tmp_path, drops_signature, said):
    path = changed_by_a_stranger(folder, tmp_path / "changed.npz", drops_signature)
    assert len(read_onboard(path).database.references)
    assert said in refusal(path, folder / "key")


@pytest.mark.parametrize(("content", "said"), [(b"", "0 bytes"), (b"k" * 15, "15 bytes"), (b"k" * 5000, "bytes")])
def test_what_is_no_key_is_refused(folder, tmp_path, content, said):
    (tmp_path / "key").write_bytes(content)
    assert said in refusal(folder / "signed.npz", tmp_path / "key")
    assert "can't be read" in refusal(folder / "signed.npz", tmp_path / "missing")


def test_bytes_can_not_move_from_one_array_to_another():
    assert signature(FILES, KEY) != signature({"a": b"1", "b": b"23"}, KEY)


def described(capsys, *arguments):
    assert main(["info", *map(str, arguments), "--json"]) == ALL_FIXED
    return json.loads(capsys.readouterr().out)


def test_info_shows_the_date_and_what_is_known_of_the_signature(folder, tmp_path, capsys):
    database, date = read_onboard(str(folder / "unsigned.npz")).database, datetime(2026, 5, 1, tzinfo=timezone.utc)
    write_onboard(str(tmp_path / "dated.npz"), database, None, key_file=str(folder / "key"), exported=date)
    found = described(capsys, tmp_path / "dated.npz")
    assert (found["exported"], found["signature"]) == (date.isoformat(), "signed, not checked: no key was given")
    found = described(capsys, tmp_path / "dated.npz", "--require-signature", folder / "key")
    assert found["signature"] == "signed with the key"
    found = described(capsys, folder / "unsigned.npz")
    assert (found["exported"], found["signature"]) == ("not recorded", "not signed")


def test_localizing_logs_the_date_and_what_is_known_of_the_signature(folder, tmp_path, capsys):
    database, date = read_onboard(str(folder / "unsigned.npz")).database, datetime(2026, 5, 1, tzinfo=timezone.utc)
    path = str(tmp_path / "dated.npz")
    write_onboard(path, database, None, key_file=str(folder / "key"), exported=date)
    for key, said in ((None, "signed, not checked: no key was given"), (folder / "key", "signed with the key")):
        required = ["--require-signature", str(key)] if key else []
        main(["localize", str(tmp_path), "--database", path, "--log-level", "info", *required])
        told = [json.loads(line) for line in capsys.readouterr().err.splitlines() if line.startswith("{")]
        (ready,) = [line for line in told if line["event"] == "ready"]
        assert (ready["exported"], ready["signature"]) == (date.isoformat(), said)


@pytest.mark.parametrize("text", ["yesterday", "2026-05-01", 5])
def test_an_invalid_date_is_refused(folder, tmp_path, monkeypatch, text):
    class Moment:
        def isoformat(self, timespec):
            return text

    database = read_onboard(str(folder / "unsigned.npz")).database
    write_onboard(str(tmp_path / "dated.npz"), database, None, exported=Moment())
    with pytest.raises(SemRefError, match="exported|date|isoformat"):
        read_onboard(str(tmp_path / "dated.npz"))


def test_the_date_is_signed(folder, tmp_path):
    """An older file stays valid; a later date needs the key."""
    database = read_onboard(str(folder / "unsigned.npz")).database
    dates = [datetime(year, 5, 1, tzinfo=timezone.utc) for year in (2025, 2026)]
    for date in dates:
        write_onboard(str(tmp_path / f"{date.year}.npz"), database, None, key_file=str(folder / "key"), exported=date)
    assert read_onboard(str(tmp_path / "2025.npz"), key_file=str(folder / "key")).exported == dates[0]
    with zipfile.ZipFile(tmp_path / "2025.npz") as old, zipfile.ZipFile(tmp_path / "2026.npz") as new:
        files = {name: (new if "signature" not in name else old).read(name) for name in new.namelist()}
    with zipfile.ZipFile(tmp_path / "forged.npz", "w") as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    assert read_onboard(str(tmp_path / "forged.npz")).exported == dates[1]
    assert "was changed since" in refusal(tmp_path / "forged.npz", folder / "key")
