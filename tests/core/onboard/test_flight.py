"""``python -m core watch --flight``: each image by all up to it, bounded, and on after a restart."""

from __future__ import annotations

import io
import json
import math
import os
import pickle
import zipfile

import cv2
import numpy as np
import pytest
from numpy.lib.format import write_array_header_1_0
from onboard_area import MAP, SIZE, write_area

from semref.core.geometry.camera import Camera, Lens
from semref.core.geometry.lens_distortion import LensDistortion
from semref.core.geometry.leveling import Attitude, leveling
from semref.core.localizer.leveled import level_labels
from semref.core.onboard.command_line import ALL_FIXED, REFUSED, SOME_WITHOUT_FIX, WRONG_USAGE, main
from semref.core.onboard.flight import FORMAT

STEP = 60
COUNT = 7
FIRST = (90, 60)
"""Row and column of the first image's first pixel; the flight goes east, tops up."""


def center(number):
    """Map (x, y) of an image's center."""
    row, column = FIRST[0] + 8 * number, FIRST[1] + STEP * number
    return 600000 + column + SIZE / 2, 5200000 - row - SIZE / 2


def cut(number):
    row, column = FIRST[0] + 8 * number, FIRST[1] + STEP * number
    return np.ascontiguousarray(MAP[row : row + SIZE, column : column + SIZE])


@pytest.fixture(scope="module")
def database(tmp_path_factory):
    path = str(tmp_path_factory.mktemp("onboard") / "area.npz")
    write_area(path)
    return path


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "incoming").mkdir()
    return tmp_path / "incoming"


def put(folder, numbers, blank=()):
    for number in numbers:
        path = str(folder / f"{number}.png")
        cv2.imwrite(path, np.full((SIZE, SIZE), 4, np.uint8) if number in blank else cut(number))
        os.utime(path, ns=(number * 10**9, number * 10**9))


@pytest.fixture
def watch(database, folder, tmp_path):
    """`watch(*arguments)` looks at what lies in the folder; gives the exit code and the records that came."""

    def run(*arguments):
        fixes = tmp_path / "fixes.jsonl"
        fixes.unlink(missing_ok=True)
        given = ["watch", str(folder), "--database", database, "--once", "--fixes", str(fixes), "--flight", *arguments]
        code = main([*given, "--method", "constellation"])
        lines = fixes.read_text(encoding="utf-8").splitlines() if fixes.exists() else []
        return code, [json.loads(line) for line in lines]

    return run


def off(record, number):
    return np.hypot(record["x"] - center(number)[0], record["y"] - center(number)[1])


@pytest.mark.slow
def test_images_of_a_flight_have_the_track_and_what_they_rest_on(watch, folder):
    put(folder, range(COUNT))
    _, records = watch()
    assert len(records) == COUNT
    for number, record in list(enumerate(records))[3:]:
        assert (record["status"], record["track"], record["outvoted"]) == ("fix", 1, False)
        assert record["source"] in ("own", "flight") and off(record, number) < 3
        assert record["sigma_east"] > 0 and record["longitude"] > 9


LENS = LensDistortion((0.95, 0.95), (0.0, 0.0), (-0.27, 0.11, -0.03))
"""Like that of a Phantom 4, in a square image."""


def bent(number):
    """What a camera with LENS sees where ``cut`` is straight."""
    way = leveling(Attitude(0, 0), LENS.focal_xy[0] * SIZE, (SIZE, SIZE), LENS)
    rows, columns = np.mgrid[0:SIZE, 0:SIZE]
    straight = way.bent.straight(np.column_stack([columns.ravel(), rows.ravel()]) + 0.5).reshape(SIZE, SIZE, 2)
    first = np.array([FIRST[1] + STEP * number, FIRST[0] + 8 * number])
    return cv2.remap(MAP, (straight + first - 0.5).astype(np.float32), None, cv2.INTER_NEAREST)


@pytest.mark.slow
@pytest.mark.parametrize("is_stated", [True, False])
def test_a_lens_that_its_image_states_is_straightened_in_a_flight_too(watch, folder, monkeypatch, is_stated):
    camera = Camera(lens=Lens("focal_length_px", 0.95 * SIZE), distortion=LENS if is_stated else None)
    monkeypatch.setattr("semref.core.onboard.cameras.photo_camera", lambda path: camera)
    for number in range(4):
        cv2.imwrite(str(folder / f"{number}.png"), bent(number))
        os.utime(folder / f"{number}.png", ns=(number * 10**9, number * 10**9))
    _, records = watch()
    last = records[-1]
    assert last["status"] == "fix"
    scale_error = abs(last["pixel_size"] - 1)
    assert (scale_error < 0.003) == is_stated
    if is_stated:
        assert off(last, 3) < 1


@pytest.mark.slow
def test_an_image_that_shows_nothing_is_placed_by_the_flight(watch, folder):
    put(folder, range(COUNT), blank=[5])
    _, records = watch()
    assert (records[5]["status"], records[5]["source"]) == ("fix", "flight")
    assert off(records[5], 5) < 30 and records[5]["error_95"] > records[4]["error_95"]


def test_a_restart_goes_on_where_the_flight_was(watch, folder, tmp_path):
    put(folder, range(5))
    state = str(tmp_path / "flight.npz")
    _, before = watch("--state", state)
    assert len(before) == 5 and before[-1]["track"] == 1
    put(folder, [5, 6])
    code, after = watch("--state", state)
    assert [os.path.basename(record["image"]) for record in after] == ["5.png", "6.png"]
    assert code == ALL_FIXED and [record["track"] for record in after] == [1, 1]
    assert all(off(record, number) < 3 for number, record in zip((5, 6), after))


def test_a_state_without_a_flight_is_refused(database, folder, tmp_path, capsys):
    state = tmp_path / "flight.npz"
    assert main(["watch", str(folder), "--database", database, "--once", "--state", str(state)]) == REFUSED
    assert "--flight" in capsys.readouterr().err and not state.exists()


@pytest.mark.slow
def test_the_answers_after_a_restart_are_those_without_one(watch, folder, tmp_path):
    put(folder, range(COUNT))
    _, whole = watch()
    for number in range(5, COUNT):
        os.remove(folder / f"{number}.png")
    state = str(tmp_path / "flight.npz")
    watch("--state", state)
    put(folder, range(5, COUNT))
    _, after = watch("--state", state)
    for one, other in zip(whole[5:], after):
        assert {**one, "image": 0} == {**other, "image": 0}


@pytest.mark.slow
def test_the_state_does_not_grow_with_the_flight(watch, folder, tmp_path):
    state, sizes = tmp_path / "flight.npz", []
    for number in range(COUNT):
        put(folder, [number])
        watch("--state", str(state))
        sizes.append(state.stat().st_size)
    put(folder, range(COUNT, 3 * COUNT), blank=range(COUNT, 3 * COUNT))
    watch("--state", str(state))
    assert state.stat().st_size < 2.5 * sizes[-1]
    assert not list(tmp_path.glob("*.part"))


@pytest.mark.parametrize("data", [b"", b"no state", b"PK\x03\x04 half a zip"])
def test_a_damaged_state_is_told_and_the_flight_begins_anew(watch, folder, tmp_path, data, capsys):
    state = tmp_path / "flight.npz"
    state.write_bytes(data)
    put(folder, range(2))
    code, records = watch("--state", str(state))
    assert len(records) == 2 and code in (ALL_FIXED, SOME_WITHOUT_FIX)
    told = json.loads(capsys.readouterr().err.splitlines()[0])
    assert (told["level"], told["event"]) == ("error", "flight_state_not_used")
    assert state.read_bytes()[:2] == b"PK" and state.stat().st_size > 1000


def zipped(path, method=zipfile.ZIP_STORED, **members):
    with zipfile.ZipFile(path, "w", method) as archive:
        for name, data in members.items():
            archive.writestr(f"{name}.npy", data)


def npy(shape, kind="|u1", data=b"x"):
    file = io.BytesIO()
    write_array_header_1_0(file, {"descr": kind, "fortran_order": False, "shape": shape})
    return file.getvalue() + data


def header(**values):
    text = json.dumps({"format": FORMAT, "version": 1, "content_hash": "", "after": [1, "a"], **values}).encode()
    return npy((len(text),), data=text)


@pytest.mark.parametrize(
    ("method", "data"),
    [
        (zipfile.ZIP_STORED, npy((10**12,))),
        (zipfile.ZIP_DEFLATED, npy((10**9,), data=bytes(10**5))),
        (zipfile.ZIP_LZMA, npy((1,))),
        (zipfile.ZIP_STORED, npy((1,), "|O", pickle.dumps(1))),
        (zipfile.ZIP_STORED, npy((2, -1))),
        (zipfile.ZIP_STORED, npy((5,), data=b"[" * 5)),
        (zipfile.ZIP_STORED, npy((50_000,), data=b"[" * 50_000)),
        (zipfile.ZIP_STORED, header(after=[math.inf, "a"])),
        (zipfile.ZIP_STORED, header(after=["a"])),
        (zipfile.ZIP_STORED, npy((2,), data=b"[]")),
    ],
    ids=["1 TB", "deflated", "LZMA", "pickle", "negative", "no JSON", "deep JSON", "endless", "after", "list"],
)
def test_a_hostile_state_is_told_and_the_flight_begins_anew(watch, folder, tmp_path, method, data, capsys):
    zipped(tmp_path / "flight.npz", method, header=data)
    put(folder, range(1))
    _, records = watch("--state", str(tmp_path / "flight.npz"))
    assert len(records) == 1
    told = json.loads(capsys.readouterr().err.splitlines()[0])
    assert told["event"] == "flight_state_not_used" and "no state of a flight" in told["reason"]


def test_a_state_of_another_database_is_not_used(watch, folder, tmp_path, capsys):
    state = tmp_path / "flight.npz"
    put(folder, range(1))
    watch("--state", str(state))
    with np.load(state) as found:
        arrays = dict(found)
    header = json.loads(arrays["header"].tobytes())
    header["content_hash"] = "0" * 64
    arrays["header"] = np.frombuffer(json.dumps(header).encode(), np.uint8)
    np.savez(state, **arrays)
    _, records = watch("--state", str(state))
    assert len(records) == 1
    assert "another database" in json.loads(capsys.readouterr().err.splitlines()[-1])["reason"]


def test_a_state_that_can_not_be_written_does_not_end_the_flight(watch, folder, tmp_path, capsys):
    put(folder, range(2))
    _, records = watch("--state", str(tmp_path / "nowhere" / "flight.npz"))
    assert len(records) == 2
    assert json.loads(capsys.readouterr().err.splitlines()[0])["event"] == "state_not_kept"


@pytest.mark.slow
def test_one_bad_image_does_not_end_the_flight(watch, folder):
    put(folder, range(COUNT))
    (folder / "1.png").write_bytes(b"no image")
    os.utime(folder / "1.png", ns=(10**9, 10**9))
    code, records = watch()
    assert code == REFUSED and records[1]["status"] == "error"
    assert records[-1]["status"] == "fix" and off(records[-1], COUNT - 1) < 3


ODOMETRY = "image,dx_m,dy_m,dheading_deg,sigma_m\n"


def row(number):
    """Of the odometry table: to the right and down, as the images go on."""
    return f"{number}.png,{STEP},-8,0,1\n" if number else "0.png,,,,\n"


@pytest.fixture
def blind(monkeypatch):
    """Pixels tell no motion."""
    from semref.core.flight.pixel_motion import Motion

    monkeypatch.setattr("semref.core.onboard.flight.motion_between", lambda before, now: Motion(None))


@pytest.mark.slow
@pytest.mark.usefixtures("blind")
@pytest.mark.parametrize("is_told", [True, False])
def test_a_table_of_motion_holds_the_track_where_pixels_tell_none(watch, folder, tmp_path, is_told):
    put(folder, range(4), blank=[2])
    table = tmp_path / "odometry.csv"
    table.write_text(ODOMETRY + "".join(map(row, range(4))), encoding="utf-8")
    _, records = watch(*(["--odometry", str(table)] if is_told else []))
    assert (records[2]["status"] == "fix" and records[2]["source"] == "flight") == is_told
    assert (records[3]["track"] == records[0]["track"]) == is_told


@pytest.mark.usefixtures("blind")
def test_a_restart_goes_on_with_the_table_of_motion(watch, folder, tmp_path):
    table, state = tmp_path / "odometry.csv", str(tmp_path / "flight.npz")
    table.write_text(ODOMETRY + "".join(map(row, range(2))), encoding="utf-8")
    put(folder, range(2))
    _, before = watch("--odometry", str(table), "--state", state)
    with open(table, "a", encoding="utf-8") as file:
        file.write(row(2) + "broken\n")
    put(folder, [2], blank=[2])
    _, (after,) = watch("--odometry", str(table), "--state", state)
    assert (after["status"], after["source"], after["track"]) == ("fix", "flight", before[-1]["track"])
    assert off(after, 2) < 10


@pytest.mark.slow
def test_what_comes_later_in_the_table_changes_nothing_that_was_said(watch, folder, tmp_path):
    table = tmp_path / "odometry.csv"
    put(folder, range(2))
    told = []
    for last in (2, 5):
        table.write_text(ODOMETRY + "".join(map(row, range(last))), encoding="utf-8")
        told.append(watch("--odometry", str(table))[1])
    assert told[0] == told[1]


def test_bad_tables_are_one_sentence_before_the_start(watch, folder, database, tmp_path, capsys):
    put(folder, range(1))
    table = tmp_path / "odometry.csv"
    for text, message in (("x,y\n1,2\n", "dheading_deg"), (ODOMETRY + "0,,,\n1,a,1,1\n", "dx_m is “a”")):
        table.write_text(text, encoding="utf-8")
        assert watch("--odometry", str(table)) == (REFUSED, [])
        assert message in capsys.readouterr().err
    assert watch("--odometry", str(tmp_path / "nowhere.csv"))[0] == REFUSED
    assert main(["watch", str(folder), "--database", database, "--once", "--odometry", str(table)]) == REFUSED
    assert "--flight" in capsys.readouterr().err
    assert watch("--odometry", str(table), "--state", str(table))[0] == WRONG_USAGE


def test_a_tilted_camera_of_a_table_is_leveled(watch, folder, tmp_path, monkeypatch):
    """What is tilted on the image is where it was on the ground: as QGIS levels it."""
    put(folder, range(1))
    seen = []
    original = "semref.core.onboard.flight.level_labels"
    monkeypatch.setattr(original, lambda labels, way: seen.append(way) or level_labels(labels, way))
    table = tmp_path / "cameras.csv"
    table.write_text("image,roll,pitch,field_of_view,height\n0.png,2,-3,60,173\n", encoding="utf-8")
    watch("--cameras", str(table))
    (way,) = seen
    expected = leveling(Attitude(2, -3), SIZE / 2 / math.tan(math.radians(30)), (SIZE, SIZE))
    assert way.corners == pytest.approx(expected.corners)
