"""The onboard file: what comes back, how exactly, and that nothing else is ever taken for one."""

from __future__ import annotations

import gzip
import io
import json
import pickle
import shutil
import subprocess
import tracemalloc
import zipfile
from dataclasses import fields, replace

import cv2
import numpy as np
import pytest

from semref.core.database.build import BuildSettings, DatabaseBuilder
from semref.core.database.model import Windows
from semref.core.errors import DatabaseError
from semref.core.geometry.frame import MapFrame
from semref.core.geometry.lon_lat import LonLatPolynomial, fit_lon_lat
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.localization import Method
from semref.core.localizer.localizer import Localizer
from semref.core.onboard.format import digest, is_onboard_file
from semref.core.onboard.read import read_onboard
from semref.core.onboard.write import write_onboard

TABLE = ClassTable(
    (
        LandCoverClass(2, "building", "#ff0000", "reference"),
        LandCoverClass(3, "forêt", "#00ff00"),
        LandCoverClass(5, "water", "#0000ff", "reference"),
        LandCoverClass(7, "bare, dry", "#ffff00", "reference"),
    )
)
FRAME = MapFrame('PROJCS["a metric CRS"]', (600000.0, 2.0, 0.0, 5200000.0, 0.0, -2.0))
SETTINGS = BuildSettings(120.0, 40.0, minimum_area=28.0, levels=(1.0, 2.0))


def blobs(height=320, width=400):
    noise = np.random.default_rng(0).random((5, height, width)).astype(np.float32)
    smooth = np.stack([cv2.GaussianBlur(layer, (0, 0), 1.8) for layer in noise])
    return np.array((0, 2, 3, 5, 7), np.uint8)[smooth.argmax(axis=0)]


def linear(points_xy):
    return 9 + (points_xy[:, 0] - 600000) / 80000, 47 + (points_xy[:, 1] - 5200000) / 111000


MAP = blobs()


@pytest.fixture(scope="module")
def database():
    builder = DatabaseBuilder(ArrayLabels(MAP), FRAME, TABLE, SETTINGS, "1.2.3")
    for _ in builder.steps():
        pass
    return replace(builder.database, overview=builder.overview)


@pytest.fixture(scope="module")
def lon_lat(database):
    return fit_lon_lat(linear, database.parameters.extent)


@pytest.fixture(scope="module")
def written(database, lon_lat, tmp_path_factory):
    path = tmp_path_factory.mktemp("onboard") / "area.npz"
    write_onboard(str(path), database, lon_lat)
    return path


def members(path) -> dict:
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def zipped(path, files: dict) -> str:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    return str(path)


def npy(array) -> bytes:
    file = io.BytesIO()
    np.save(file, array)
    return file.getvalue()


def with_header(path, source, **changes) -> str:
    """A copy of a file with another header and the hash that belongs to it, as its maker would have written it."""
    files = members(source)
    header = json.loads(np.load(io.BytesIO(files["header.npy"])).tobytes())
    header.update(changes)
    files["header.npy"] = npy(np.frombuffer(json.dumps(header).encode("utf-8"), np.uint8))
    found = digest({name[:-4]: data for name, data in files.items()})
    files["content_hash.npy"] = npy(np.frombuffer(found, np.uint8))
    return zipped(path, files)


# --- what comes back ---


def test_everything_comes_back_as_exactly_as_the_file_says(database, written):
    found = read_onboard(str(written))
    mine, theirs = database.windows, found.database.windows
    assert found.database.parameters == replace(database.parameters, block_hashes=())
    assert found.database.class_table == TABLE
    for name in ("first_pixels", "names", "levels", "sizes", "counts", "described"):
        np.testing.assert_array_equal(getattr(theirs, name), getattr(mine, name))
    np.testing.assert_array_equal(theirs.centers, mine.centers)
    assert np.abs(theirs.vectors - mine.vectors).max() <= found.vector_error * 1.0001
    np.testing.assert_array_equal(theirs.vectors[:, 20:], mine.vectors[:, 20:])
    mine, theirs = database.references, found.database.references
    np.testing.assert_array_equal(theirs.classes, mine.classes)
    np.testing.assert_array_equal(theirs.touches_edge, mine.touches_edge)
    assert found.position_error == pytest.approx(0.02)
    assert 0 < np.abs(theirs.positions - mine.positions).max() <= found.position_error * 1.0001
    assert 0 < np.abs(theirs.areas_m2 / mine.areas_m2 - 1).max() <= found.area_error
    np.testing.assert_array_equal(found.database.overview, database.overview)


def test_the_asked_precision_is_kept(database, tmp_path):
    path = str(tmp_path / "coarse.npz")
    write_onboard(path, database, None, precision=0.5)
    found = read_onboard(path)
    worst = np.abs(found.database.references.positions - database.references.positions).max()
    assert 0.4 < worst <= found.position_error == 0.5


def test_a_database_of_no_windows_and_no_overview_comes_back(database, tmp_path):
    path = str(tmp_path / "bare.npz")
    arrays = {item.name: getattr(database.windows, item.name) for item in fields(Windows)}
    windows = Windows(**{name: array if array is None else array[:0] for name, array in arrays.items()})
    write_onboard(path, replace(database, windows=windows, overview=None), None)
    found = read_onboard(path)
    assert (len(found.database.windows), found.database.overview, found.lon_lat) == (0, None, None)
    assert len(found.database.references) == len(database.references)


def test_the_same_database_gives_the_same_bytes(database, lon_lat, written, tmp_path):
    again = tmp_path / "again.npz"
    write_onboard(str(again), database, lon_lat)
    assert again.read_bytes() == written.read_bytes()


def test_windows_and_references_keep_to_their_budget(database, written):
    with zipfile.ZipFile(written) as archive:
        size = {info.filename: info.compress_size for info in archive.infolist()}
    windows, references = (
        sum(bytes_ for name, bytes_ in size.items() if name.startswith(kind)) for kind in ("windows", "references")
    )
    assert windows <= 40 * len(database.windows)
    assert references <= 20 * len(database.references)


@pytest.mark.parametrize("method", [Method.CONSTELLATION, Method.TOPOLOGY_VECTOR])
def test_images_are_found_where_the_whole_database_finds_them(database, written, method):
    whole, onboard = Localizer(database), Localizer(read_onboard(str(written)).database)
    for column, row in ((0, 0), (100, 60), (190, 111)):
        image = np.ascontiguousarray(np.rot90(MAP[row : row + 120, column : column + 120]))
        expected, found = whole.localize(image, method), onboard.localize(image, method)
        assert (found.status, found.window) == (expected.status, expected.window)
        if expected.position is not None:
            assert np.hypot(*np.subtract(found.position, expected.position)) < 0.1


# --- refusals ---


def refusal(path) -> str:
    with pytest.raises(DatabaseError) as refused:
        read_onboard(str(path))
    return str(refused.value)


@pytest.mark.parametrize("share", np.linspace(0, 0.999, 20).tolist())
def test_a_truncated_file_is_refused(written, tmp_path, share):
    cut = tmp_path / "cut.npz"
    cut.write_bytes(written.read_bytes()[: int(share * written.stat().st_size)])
    assert "cut short" in refusal(cut)


def test_a_flipped_bit_is_refused_or_changes_nothing(written, tmp_path):
    """Times and attributes in the zip's directory mean nothing here; all else is covered by checksums."""
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


def zip_of(files: dict) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    return file.getvalue()


FOREIGN = {
    "empty": b"",
    "text": b"value,name\n",
    "sqlite": b"SQLite format 3\0" + bytes(500),
    "zeros": bytes(5000),
    "zip end": b"PK\x05\x06" + bytes(18),
    "zip start": b"PK\x03\x04" + bytes(500),
    "png": b"\x89PNG\r\n\x1a\n" + bytes(200),
    "jpeg": b"\xff\xd8\xff\xe0" + bytes(200),
    "tiff": b"II*\x00\x08\x00\x00\x00" + bytes(200),
    "gzip": gzip.compress(b"landmarks"),
    "npy": npy(np.arange(9)),
    "pickle": pickle.dumps({"header": 1}),
    "json": b'{"format": "semref onboard", "version": 1}',
    "elf": b"\x7fELF" + bytes(300),
    "one byte": b"P",
    "zip of nothing": zip_of({}),
    "zip of text": zip_of({"readme.txt": b"hello"}),
    "zip of header alone": zip_of({"header.npy": npy(np.zeros(3, np.uint8))}),
    **{f"noise {n}": np.random.default_rng(n).bytes(3000) for n in range(5)},
}


@pytest.mark.parametrize("name", list(FOREIGN))
def test_a_foreign_file_is_refused(tmp_path, name):
    path = tmp_path / "foreign.npz"
    path.write_bytes(FOREIGN[name])
    assert str(path) in refusal(path)
    assert not is_onboard_file(str(path))


def test_a_missing_file_is_refused(tmp_path):
    assert "There is no file" in refusal(tmp_path / "nothing.npz")


def test_another_npz_is_refused(tmp_path):
    np.savez_compressed(tmp_path / "other.npz", a=np.arange(3))
    assert "is no onboard file of SemRef" in refusal(tmp_path / "other.npz")


def test_an_onboard_file_is_known_as_one(written):
    assert is_onboard_file(str(written))


def test_a_pickle_is_never_opened(written, tmp_path):
    class Bomb:
        def __reduce__(self):
            return (pytest.fail, ("a pickle was opened",))

    file = io.BytesIO()
    np.save(file, np.array([Bomb()], object), allow_pickle=True)
    path = zipped(tmp_path / "bomb.npz", {**members(written), "references_classes.npy": file.getvalue()})
    assert "no plain array" in refusal(path)


def test_a_changed_array_is_refused_although_its_checksum_fits(written, tmp_path):
    files = members(written)
    classes = np.load(io.BytesIO(files["references_classes.npy"]))
    files["references_classes.npy"] = npy(np.where(classes == 2, np.uint8(5), classes))
    assert "content hash" in refusal(zipped(tmp_path / "altered.npz", files))


def test_a_newer_version_is_refused(written, tmp_path):
    assert "version 2, newer" in refusal(with_header(tmp_path / "newer.npz", written, version=2))


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"format": "other"}, "its format"),
        ({"version": "1"}, "its version"),
        ({"class_table": TABLE.to_csv().replace("water", "river")}, "its class table is not the one"),
        ({"class_table": 5}, "damaged"),
        ({"parameters": {}}, "format_version"),
        ({"position_step": float("nan")}, "position_step"),
        ({"position_step": -1}, "position_step"),
        ({"log_area_lowest": 1e9}, "impossible area"),
        ({"window_sizes_px": [60]}, "levels"),
        ({"lon_lat": {"degree": 50}}, "degree"),
        ({"lon_lat": "north"}, "damaged"),
    ],
)
def test_a_header_that_makes_no_sense_is_refused(written, tmp_path, changes, said):
    assert said in refusal(with_header(tmp_path / "senseless.npz", written, **changes))


@pytest.mark.parametrize("name", ["windows_counts", "references_areas", "overview_labels", "header"])
def test_a_missing_array_is_refused(written, tmp_path, name):
    files = members(written)
    del files[f"{name}.npy"]
    assert refusal(zipped(tmp_path / "less.npz", files))


def test_something_that_does_not_belong_there_is_refused(written, tmp_path):
    path = zipped(tmp_path / "more.npz", {**members(written), "../evil.npy": npy(np.zeros(3))})
    assert "does not belong" in refusal(path)


def test_a_zip_bomb_is_refused_before_it_is_unpacked(written, tmp_path):
    claimed = b"\x93NUMPY\x01\x00\x76\x00" + b"{'descr': '|u1', 'fortran_order': False, 'shape': (400000000,), }"
    files = {**members(written), "references_classes.npy": claimed.ljust(127) + b"\n" + bytes(400_000_000)}
    path = zipped(tmp_path / "bomb.npz", files)
    del files
    tracemalloc.start()
    said = refusal(path)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert "claims" in said
    assert most < 5_000_000


def test_a_shape_that_claims_more_than_the_member_holds_is_refused(written, tmp_path):
    files = members(written)
    files["references_classes.npy"] = files["references_classes.npy"].replace(b"(", b"(9", 1).replace(b" \n", b"\n", 1)
    assert "has not the size" in refusal(zipped(tmp_path / "claims.npz", files))


def test_a_class_table_that_was_changed_after_the_build_is_not_exported(database, tmp_path):
    table = ClassTable((*TABLE.classes, LandCoverClass(9, "new", "#123456")))
    with pytest.raises(DatabaseError, match="was changed after it was built"):
        write_onboard(str(tmp_path / "changed.npz"), replace(database, class_table=table), None)


def test_a_precision_finer_than_the_format_holds_is_refused(database, tmp_path):
    with pytest.raises(DatabaseError, match="too fine"):
        write_onboard(str(tmp_path / "fine.npz"), database, None, precision=1e-9)


# --- longitude and latitude ---


def mercator(points_xy):
    radius = 6378137.0
    return np.degrees(points_xy[:, 0] / radius), np.degrees(np.arctan(np.sinh(points_xy[:, 1] / radius)))


def test_longitude_and_latitude_are_within_the_stated_error():
    extent = (1_000_000.0, 5_900_000.0, 1_060_000.0, 6_000_000.0)
    found = fit_lon_lat(mercator, extent)
    points = np.random.default_rng(1).uniform(extent[:2], extent[2:], (1000, 2))
    lon, lat = found(points)
    true_lon, true_lat = mercator(points)
    error = np.hypot((lon - true_lon) * 111320 * np.cos(np.radians(true_lat)), (lat - true_lat) * 111320).max()
    assert found.error_m <= 0.01
    assert error <= 1.1 * found.error_m + 1e-6


def test_the_antimeridian_is_crossed():
    def across(points_xy):
        return (points_xy[:, 0] / 80_000 + 359.9 + 180) % 360 - 180, points_xy[:, 1] / 111_000

    found = fit_lon_lat(lambda points: across(points + (-14_320_000 + 80_000 * 180, 0)), (0, 0, 20_000, 20_000))
    assert found.error_m < 1e-4


def test_a_map_around_a_pole_gets_no_polynomial():
    def polar(points_xy):
        x, y = points_xy.T
        return np.degrees(np.arctan2(x, -y)), 90 - np.hypot(x, y) / 111_000

    assert fit_lon_lat(polar, (-50_000, -50_000, 50_000, 50_000)) is None


def test_the_polynomial_comes_back_from_the_file(written, lon_lat):
    found = read_onboard(str(written)).lon_lat
    assert isinstance(found, LonLatPolynomial)
    assert found == lon_lat


# --- a reader in another language ---


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


@pytest.mark.parametrize("far", [5_420_000.0, -2_000.0])
def test_landmarks_off_the_map_are_refused_although_all_hashes_fit(database, written, tmp_path, far):
    origin = database.references.positions.min(axis=0) + far
    said = refusal(with_header(tmp_path / "far.npz", written, position_origin=origin.tolist()))
    assert "off the map" in said
