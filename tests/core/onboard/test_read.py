import io
import json
import math
import shutil
import struct
import subprocess
import tracemalloc
import zipfile
from dataclasses import asdict

import numpy as np
import pytest
from foreign_files import FOREIGN
from onboard_blobs import MAP, TABLE, hashed, members, npy, with_header, zipped

from semref.core.errors import DatabaseError
from semref.core.geometry.lon_lat import LonLatPolynomial
from semref.core.localization import Method
from semref.core.localizer.localizer import Localizer
from semref.core.onboard.format import HASH, digest, is_onboard_file
from semref.core.onboard.read import read_onboard


@pytest.mark.slow
@pytest.mark.parametrize("method", [Method.CONSTELLATION, Method.TOPOLOGY_VECTOR])
def test_images_are_found_where_the_whole_database_finds_them(database, written, method):
    whole, onboard = Localizer(database), Localizer(read_onboard(str(written)).database)
    for column, row in ((0, 0), (100, 60), (190, 111)):
        image = np.ascontiguousarray(np.rot90(MAP[row : row + 120, column : column + 120]))
        expected, found = whole.localize(image, method), onboard.localize(image, method)
        assert (found.status, found.window) == (expected.status, expected.window)
        if expected.position is not None:
            assert np.hypot(*np.subtract(found.position, expected.position)) < 0.1


def test_the_polynomial_comes_back_from_the_file_also_one_of_degree_0(written, lon_lat, tmp_path):
    found = read_onboard(str(written)).lon_lat
    assert isinstance(found, LonLatPolynomial)
    assert found == lon_lat
    values = {**asdict(lon_lat), "degree": 0, "longitude": [9.5], "latitude": [47.1]}
    found = read_onboard(str(with_header(tmp_path / "area.npz", written, lon_lat=values))).lon_lat
    assert (found.degree, found.longitude, found.latitude) == (0, (9.5,), (47.1,))


def refusal(path) -> str:
    with pytest.raises(DatabaseError) as refused:
        read_onboard(str(path))
    return str(refused.value)


@pytest.mark.parametrize("share", np.linspace(0, 0.999, 20).tolist())
def test_a_truncated_file_is_refused(written, tmp_path, share):
    cut = tmp_path / "cut.npz"
    cut.write_bytes(written.read_bytes()[: int(share * written.stat().st_size)])
    assert "incomplete" in refusal(cut)


@pytest.mark.slow
def test_a_flipped_bit_is_refused_or_changes_nothing(written, tmp_path):
    """Times and attributes in the zip's directory are not used; checksums cover the rest."""
    data, refused = written.read_bytes(), 0
    whole = members(written)
    random = np.random.default_rng(3)
    flipped = tmp_path / "flipped.npz"
    for place in random.integers(0, len(data), 150).tolist() + list(range(len(data) - 150, len(data))):
        changed = bytearray(data)
        changed[place] ^= 1 << int(random.integers(8))
        flipped.write_bytes(changed)
        try:
            read_onboard(str(flipped))
        except DatabaseError:
            refused += 1
        else:
            assert members(flipped) == whole
    assert refused > 200


@pytest.mark.parametrize("name", list(FOREIGN))
def test_a_foreign_file_is_refused(tmp_path, name):
    path = tmp_path / "foreign.npz"
    path.write_bytes(FOREIGN[name])
    assert is_onboard_file(str(path)) is False and str(path) in refusal(path)


class Bomb:
    def __reduce__(self):
        return pytest.fail, ("a pickle was opened",)


def other_class(data):
    classes = np.load(io.BytesIO(data))
    return npy(np.where(classes == 2, np.uint8(5), classes))


@pytest.mark.parametrize(
    ("name", "change", "said"),
    [
        ("references_classes", lambda data: npy(np.array([Bomb()], object)), "has the type |O"),
        ("references_classes", other_class, "content hash"),
        ("references_classes", lambda data: data.replace(b"(", b"(9", 1).replace(b" \n", b"\n", 1), "has another size"),
        ("references_classes", lambda data: data.replace(b"{", b"(", 1), "not a plain array"),
        ("../evil", lambda data: npy(np.zeros(3)), "unknown member"),
        *((name, None, "") for name in ("windows_counts", "references_areas", "overview_labels", "header")),
    ],
)
def test_a_file_with_an_odd_an_unknown_or_a_missing_member_is_refused(written, tmp_path, name, change, said):
    files = members(written)
    data = files.pop(f"{name}.npy", None)
    if change:
        files[f"{name}.npy"] = change(data)
    assert said in refusal(zipped(tmp_path / "odd.npz", files))


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"format": "other"}, "its format"),
        ({"version": "1"}, "its version"),
        ({"version": 2}, "version 2; this SemRef reads versions up to 1"),
        ({"class_table": TABLE.to_csv().replace("water", "river")}, "its class table does not match"),
        *(({"class_table": table}, "damaged") for table in (5, "value,name\n900,moon\n")),
        ({"parameters": {}}, "format_version"),
        *(({"position_step": step}, "position_step") for step in (float("nan"), -1)),
        ({"log_area_lowest": 1e9}, "impossible area"),
        ({"window_sizes_px": [60]}, "levels"),
        ({"lon_lat": {"degree": 50}}, "degree"),
        ({"lon_lat": "north"}, "damaged"),
        ({"version": 0}, "its version is 0"),
        ({"reference_classes": [2, 5]}, "its reference_classes"),
        ({"position_origin": [1.0, 2.0, 3.0]}, "position_origin is"),
    ],
)
def test_a_header_that_makes_no_sense_is_refused(written, tmp_path, changes, said):
    assert said in refusal(with_header(tmp_path / "senseless.npz", written, **changes))


@pytest.mark.slow
def test_a_zip_bomb_is_refused_before_it_is_unpacked(written, tmp_path):
    claimed = b"\x93NUMPY\x01\x00\x76\x00" + b"{'descr': '|u1', 'fortran_order': False, 'shape': (400000000,), }"
    files = {**members(written), "references_classes.npy": claimed.ljust(127) + b"\n" + bytes(400_000_000)}
    path = zipped(tmp_path / "bomb.npz", files)
    del files
    tracemalloc.start()
    said = refusal(path)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert "states" in said
    assert most < 5_000_000


@pytest.mark.parametrize("far", [5_420_000.0, -2_000.0])
def test_landmarks_off_the_map_are_refused_although_all_hashes_fit(database, written, tmp_path, far):
    origin = database.references.positions.min(axis=0) + far
    said = refusal(with_header(tmp_path / "far.npz", written, position_origin=origin.tolist()))
    assert "outside the map" in said


def test_a_polynomial_that_leads_off_the_earth_is_refused(written, tmp_path, lon_lat):
    """Otherwise the aircraft would report a latitude of 900 degrees."""
    values = {**asdict(lon_lat), "latitude": [900.0, *lon_lat.latitude[1:]]}
    assert "not on Earth" in refusal(with_header(tmp_path / "area.npz", written, lon_lat=values))


def array(source, name):
    return np.load(io.BytesIO(members(source)[f"{name}.npy"]))


@pytest.mark.parametrize(
    ("name", "change", "said"),
    [
        ("windows_counts", lambda one: one[:-1], "its windows_ arrays differ in length"),
        ("windows_vectors", lambda one: one[:, 1:], "windows_vectors has"),
        ("windows_vectors", lambda one: np.full_like(one, 4), "unknown class ranks"),
        ("windows_levels", lambda one: one * 0, "unknown levels"),
        ("references_areas", lambda one: one[1:], "its references_ arrays differ in length"),
        ("references_positions", lambda one: one[:, :1].copy(), "its references_ arrays differ in length"),
        ("references_classes", lambda one: one.astype(np.int16), "has the type"),
        ("references_classes", lambda one: one[:, None], "has the type"),
        ("references_positions", np.asfortranarray, "not a plain array"),
        ("overview_labels", lambda one: one[1:], "overview_labels has the shape"),
    ],
)
def test_an_array_that_does_not_fit_the_others_is_refused(written, tmp_path, name, change, said):
    changed = {f"{name}.npy": npy(change(array(written, name)))}
    path = hashed(tmp_path / "odd.npz", {**members(written), **changed})
    with pytest.raises(DatabaseError, match=said):
        read_onboard(path)


@pytest.mark.parametrize("half_size", [[1.0, 0.0], [1.0], [1.0, 2.0, 3.0]])
def test_a_polynomial_that_lacks_numbers_is_refused(written, tmp_path, lon_lat, half_size):
    values = {**asdict(lon_lat), "half_size": half_size}
    assert "lon_lat has a wrong number" in refusal(with_header(tmp_path / "odd.npz", written, lon_lat=values))


def test_a_member_that_is_packed_in_an_unknown_way_is_refused(written, tmp_path):
    path = zipped(tmp_path / "packed.npz", members(written), zipfile.ZIP_BZIP2)
    assert "compressed in an unknown way" in refusal(path)


def test_the_stated_errors_are_half_a_step(written):
    header = json.loads(array(written, "header").tobytes())
    found = read_onboard(str(written))
    assert found.position_error == header["position_step"] / 2
    assert found.area_error == pytest.approx(math.expm1(header["log_area_step"] / 2), rel=1e-12)
    assert found.vector_error == 0.5 / 255
    assert found.size_bytes == written.stat().st_size
    assert found.content_hash == array(written, "content_hash").tobytes().hex()
    assert found.database.source == str(written)


def test_an_onboard_file_is_recognized_by_its_members_even_if_it_is_damaged_unless_its_directory_is(written, tmp_path):
    assert is_onboard_file(str(written))
    assert is_onboard_file(zipped(tmp_path / "damaged.npz", dict.fromkeys(members(written), b"")))
    data = bytearray(written.read_bytes())
    start = data.rfind(b"PK\x05\x06")
    (directory,) = struct.unpack_from("<I", data, start + 16)
    data[directory : directory + 4] = b"none"
    (tmp_path / "odd.npz").write_bytes(data)
    assert is_onboard_file(str(tmp_path / "odd.npz")) is False


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
