import json
from datetime import datetime, timezone

import pytest
from onboard_blobs import hashed, members, zipped

from semref.core.errors import SemRefError
from semref.core.onboard.command_line import ALL_FIXED, main
from semref.core.onboard.format import signature
from semref.core.onboard.read import read_onboard
from semref.core.onboard.write import write_onboard

FILES = {"a": b"12", "b": b"3"}
KEY = bytes(range(32))
DATE = datetime(2026, 5, 1, tzinfo=timezone.utc)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("signed")
    (folder / "key").write_bytes(KEY)
    (folder / "other_key").write_bytes(KEY[::-1])
    return folder


@pytest.fixture(scope="module")
def export(folder, area):
    """`export(name, key_file=…, exported=…)` writes the unsigned area again, by default signed with the first key."""

    def run(name, **options):
        options = {"key_file": str(folder / "key"), **options}
        write_onboard(str(folder / name), read_onboard(area).database, None, **options)
        return str(folder / name)

    return run


@pytest.fixture(scope="module")
def signed(export):
    return export("signed.npz")


def changed_by_a_stranger(signed, target, drops_signature=False) -> str:
    """Return a file with another landmark and the matching content hash."""
    files = members(signed)
    areas = bytearray(files["references_areas.npy"])
    areas[-1] ^= 1
    files["references_areas.npy"] = bytes(areas)
    if drops_signature:
        del files["signature.npy"]
    return hashed(target, files)


def refusal(path, key) -> str:
    with pytest.raises(SemRefError) as refused:
        read_onboard(str(path), key_file=str(key))
    return str(refused.value)


def test_an_unsigned_file_and_another_key_are_refused(area, folder, signed):
    assert "is not signed" in refusal(area, folder / "key")
    assert "was not signed with the key" in refusal(signed, folder / "other_key")


@pytest.mark.parametrize(("drops_signature", "said"), [(False, "was changed since"), (True, "is not signed")])
def test_what_a_stranger_changed_is_refused_although_its_hash_fits(signed, folder, tmp_path, drops_signature, said):
    path = changed_by_a_stranger(signed, tmp_path / "changed.npz", drops_signature)
    assert len(read_onboard(path).database.references)
    assert said in refusal(path, folder / "key")


@pytest.mark.parametrize(("content", "said"), [(b"", "0 bytes"), (b"k" * 15, "15 bytes"), (b"k" * 5000, "bytes")])
def test_what_is_no_key_is_refused(signed, tmp_path, content, said):
    (tmp_path / "key").write_bytes(content)
    assert said in refusal(signed, tmp_path / "key")
    assert "can't be read" in refusal(signed, tmp_path / "missing")


def test_bytes_can_not_move_from_one_array_to_another():
    assert signature(FILES, KEY) != signature({"a": b"1", "b": b"23"}, KEY)


def described(capsys, *arguments):
    assert main(["info", *map(str, arguments), "--json"]) == ALL_FIXED
    return json.loads(capsys.readouterr().out)


def test_info_shows_the_date_and_what_is_known_of_the_signature(export, folder, capsys):
    dated = export("dated.npz", exported=DATE)
    found = described(capsys, dated)
    assert (found["exported"], found["signature"]) == (DATE.isoformat(), "signed, not checked: no key was given")
    found = described(capsys, dated, "--require-signature", folder / "key")
    assert found["signature"] == "signed with the key"
    found = described(capsys, export("unsigned.npz", key_file=None))
    assert (found["exported"], found["signature"]) == ("not recorded", "not signed")


def test_localizing_logs_the_date_and_what_is_known_of_the_signature(export, folder, tmp_path, capsys):
    path = export("dated.npz", exported=DATE)
    for key, said in ((None, "signed, not checked: no key was given"), (folder / "key", "signed with the key")):
        required = ["--require-signature", str(key)] if key else []
        main(["localize", str(tmp_path), "--database", path, "--log-level", "info", *required])
        told = [json.loads(line) for line in capsys.readouterr().err.splitlines() if line.startswith("{")]
        (ready,) = [line for line in told if line["event"] == "ready"]
        assert (ready["exported"], ready["signature"]) == (DATE.isoformat(), said)


@pytest.mark.parametrize("text", ["yesterday", "2026-05-01", 5])
def test_an_invalid_date_is_refused(export, text):
    class Moment:
        def isoformat(self, timespec):
            return text

    with pytest.raises(SemRefError, match="exported|date|isoformat"):
        read_onboard(export("dated.npz", key_file=None, exported=Moment()))


def test_the_date_is_signed(export, folder, tmp_path):
    """An older file stays valid; a later date needs the key."""
    earlier = DATE.replace(year=2025)
    old, new = export("old.npz", exported=earlier), export("new.npz", exported=DATE)
    assert read_onboard(old, key_file=str(folder / "key")).exported == earlier
    forged = zipped(tmp_path / "forged.npz", {**members(new), "signature.npy": members(old)["signature.npy"]})
    assert read_onboard(forged).exported == DATE
    assert "was changed since" in refusal(forged, folder / "key")
