"""The onboard file's format: recognized by its members, hashed as a whole, and readable in JavaScript."""

from __future__ import annotations

import json
import shutil
import struct
import subprocess

import numpy as np
import pytest
from foreign_files import FOREIGN
from onboard_blobs import members, zipped

from semref.core.onboard.format import HASH, digest, is_onboard_file
from semref.core.onboard.read import read_onboard


def test_an_onboard_file_is_recognized(written):
    assert is_onboard_file(str(written))


def test_a_damaged_onboard_file_is_recognized_by_its_members(written, tmp_path):
    assert is_onboard_file(zipped(tmp_path / "damaged.npz", dict.fromkeys(members(written), b"")))


def test_a_zip_with_an_unreadable_directory_is_no_onboard_file(written, tmp_path):
    """It ends like a zip, but its directory is damaged."""
    data = bytearray(written.read_bytes())
    start = data.rfind(b"PK\x05\x06")
    (directory,) = struct.unpack_from("<I", data, start + 16)
    data[directory : directory + 4] = b"none"
    (tmp_path / "odd.npz").write_bytes(data)
    assert is_onboard_file(str(tmp_path / "odd.npz")) is False


@pytest.mark.parametrize("name", list(FOREIGN))
def test_a_foreign_file_is_no_onboard_file(tmp_path, name):
    path = tmp_path / "foreign.npz"
    path.write_bytes(FOREIGN[name])
    assert is_onboard_file(str(path)) is False


def test_the_hash_is_of_all_members_but_itself_whatever_their_order():
    files = {"windows_rows": b"rows", "header": b"header"}
    assert digest({HASH: b"any", **dict(reversed(files.items()))}) == digest(files)
    assert digest({**files, "header": b"reader"}) != digest(files)


def test_a_reader_in_javascript_reads_the_same(written, database, repository):
    node = shutil.which("node")
    if node is None:
        pytest.skip("node is not here: the reader in JavaScript is not tried")
    command = [node, str(repository / "tools/readers/read_onboard.js"), str(written)]
    found = json.loads(subprocess.run(command, capture_output=True, check=True, text=True, encoding="utf-8").stdout)
    mine = read_onboard(str(written)).database
    assert found["header"]["parameters"]["crs"] == mine.parameters.crs
    assert [window["name"] for window in found["windows"]] == mine.windows.names.tolist()
    np.testing.assert_allclose([window["center"] for window in found["windows"]], mine.windows.centers)
    np.testing.assert_allclose([window["size"] for window in found["windows"]], mine.windows.sizes)
    np.testing.assert_allclose([window["vector"] for window in found["windows"]], mine.windows.vectors, rtol=1e-6)
    references = found["references"]
    np.testing.assert_allclose([(r["x"], r["y"]) for r in references], mine.references.positions)
    np.testing.assert_allclose([r["area"] for r in references], mine.references.areas_m2)
    assert [r["class"] for r in references] == mine.references.classes.tolist()
    assert [r["touches_edge"] for r in references] == mine.references.touches_edge.tolist()
