import errno
import io
import json
import math
import os
import shutil
import threading
from datetime import datetime, timezone
from pathlib import Path

import cv2
import numpy as np
import pytest
from onboard_area import MAP, NOTHING, SIZE

from semref.core.geometry.camera import Camera, Lens
from semref.core.geometry.lens_distortion import LensDistortion
from semref.core.geometry.leveling import Attitude, leveling
from semref.core.localizer.leveled import level_labels
from semref.core.onboard.command_line import ALL_FIXED, REFUSED, SOME_WITHOUT_FIX, WRONG_USAGE, main
from semref.core.onboard.flight import FORMAT, VERSION
from semref.core.onboard.read import read_onboard
from semref.core.onboard.state_file import StateFile
from semref.core.onboard.write import write_onboard

STEP = 60
COUNT = 7
FIRST = (90, 60)
"""Row and column of the first image's first pixel; the flight goes east with the tops up."""
ODOMETRY = "image,dx_m,dy_m,dheading_deg,sigma_m\n"


def center(number):
    row, column = FIRST[0] + 8 * number, FIRST[1] + STEP * number
    return 600000 + column + SIZE / 2, 5200000 - row - SIZE / 2


def cut(number):
    row, column = FIRST[0] + 8 * number, FIRST[1] + STEP * number
    return np.ascontiguousarray(MAP[row : row + SIZE, column : column + SIZE])


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    """Provide a new user with its own secret."""
    return user_at(tmp_path / "home", monkeypatch)


def user_at(home, monkeypatch):
    """Make the process that of a user whose caches and data are in this folder; returns the folder."""
    for name in ("XDG_CACHE_HOME", "XDG_DATA_HOME", "SEMREF_CACHE"):
        monkeypatch.setenv(name, str(home))
    return home


def put(folder, numbers, blank=(), view=cut):
    for number in numbers:
        path = str(folder / f"{number}.png")
        cv2.imwrite(path, NOTHING if number in blank else view(number))
        os.utime(path, ns=(number * 10**9, number * 10**9))


@pytest.fixture
def watch(area, folder, tmp_path):
    """`watch(*arguments)` processes the folder; returns the exit code and the records."""

    def run(*arguments):
        fixes = tmp_path / "fixes.jsonl"
        fixes.unlink(missing_ok=True)
        given = ["watch", str(folder), "--database", area, "--once", "--fixes", str(fixes), "--flight", *arguments]
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


@pytest.mark.slow
def test_after_images_without_content_a_place_is_predicted_but_no_position_is_sent(watch, folder, tmp_path):
    put(folder, range(COUNT), blank=(4, 5, 6))
    _, records = watch("--gga", str(tmp_path / "gga.txt"))
    last, gga = records[-1], (tmp_path / "gga.txt").read_text(encoding="ascii").splitlines()
    assert (last["status"], last["source"], last["x"], last["error_95"]) == ("ambiguous", "predicted", None, None)
    x, y, radius = last["predicted"]
    assert np.hypot(x - center(COUNT - 1)[0], y - center(COUNT - 1)[1]) < radius
    assert gga[-1].split(",")[6] == "0"
    assert all("predicted" not in record for record in records if record["status"] == "fix")


LENS = LensDistortion((0.95, 0.95), (0.0, 0.0), (-0.27, 0.11, -0.03))
"""Like the lens of a Phantom 4, for a square image."""


def bent(number):
    """Return the view of a camera with LENS where ``cut`` is straight."""
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
    put(folder, range(4), view=bent)
    _, records = watch()
    last = records[-1]
    assert last["status"] == "fix"
    scale_error = abs(last["pixel_size"] - 1)
    assert (scale_error < 0.003) == is_stated
    if is_stated:
        assert off(last, 3) < 1


@pytest.mark.slow
def test_a_restart_goes_on_where_the_flight_was_with_the_answers_of_one_without_it(watch, folder, tmp_path):
    put(folder, range(COUNT))
    _, whole = watch()
    for number in range(5, COUNT):
        os.remove(folder / f"{number}.png")
    state = str(tmp_path / "flight.npz")
    assert len(watch("--state", state)[1]) == 5
    put(folder, range(5, COUNT))
    code, after = watch("--state", state)
    assert code == ALL_FIXED and after == whole[5:]


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


@pytest.mark.slow
@pytest.mark.parametrize("data", [b"", bytes(300), b"PK\x03\x04" + bytes(26) + b"header.npy, cut short"])
def test_a_damaged_state_is_reported_and_the_flight_starts_again(watch, folder, tmp_path, data, capsys):
    state = tmp_path / "flight.npz"
    state.write_bytes(data)
    put(folder, range(1))
    code, records = watch("--state", str(state))
    assert len(records) == 1 and code in (ALL_FIXED, SOME_WITHOUT_FIX)
    told = json.loads(capsys.readouterr().err.splitlines()[0])
    assert (told["level"], told["event"]) == ("error", "flight_state_not_used")
    assert state.read_bytes()[:2] == b"PK" and state.stat().st_size > 1000


def arrays_of(state):
    with np.load(io.BytesIO(state.read_bytes()[:-32])) as found:
        return dict(found)


def write_arrays(state, arrays):
    file = StateFile.at(str(state), None)
    file.write(file.pack(arrays))


def header(**values):
    known = {"format": FORMAT, "version": VERSION, "content_hash": "", "after": [1, "a"]}
    text = json.dumps({**known, "times_s": [None, None], "newest": None, **values}).encode()
    return np.frombuffer(text, np.uint8)


def test_a_state_of_another_version_is_not_used(watch, tmp_path, capsys):
    write_arrays(tmp_path / "flight.npz", {"header": header(version=VERSION - 1)})
    assert watch("--state", str(tmp_path / "flight.npz"))[1] == []
    told = json.loads(capsys.readouterr().err.splitlines()[0])
    assert told["event"] == "flight_state_not_used" and "not the state of a flight" in told["reason"]


@pytest.mark.slow
def test_a_state_of_another_database_is_not_used(watch, folder, tmp_path, capsys):
    state = tmp_path / "flight.npz"
    put(folder, range(1))
    watch("--state", str(state))
    write_arrays(state, {**arrays_of(state), "header": header(content_hash="0" * 64)})
    _, records = watch("--state", str(state))
    assert len(records) == 1
    assert "another database" in json.loads(capsys.readouterr().err.splitlines()[-1])["reason"]


# --- ownership of the state ---


@pytest.fixture(scope="module")
def kept(area, tmp_path_factory):
    """Return a folder with a user's secret, as in ``home``, and with the state of three images."""
    made = tmp_path_factory.mktemp("flown")
    (made / "incoming").mkdir()
    put(made / "incoming", range(3))
    with pytest.MonkeyPatch.context() as patch:
        user_at(made / "home", patch)
        given = ["--database", area, "--once", "--flight", "--state", str(made / "flight.npz")]
        main(["watch", str(made / "incoming"), *given, "--fixes", str(made / "fixes"), "--method", "constellation"])
    return made


@pytest.fixture
def flown(kept, home, folder, tmp_path):
    """Return a state of three images; a fourth image arrived later."""
    shutil.copytree(kept / "home", home)
    put(folder, range(4))
    return Path(shutil.copy2(kept / "flight.npz", tmp_path))


def events(capsys):
    return [json.loads(line) for line in capsys.readouterr().err.splitlines() if line.startswith("{")]


@pytest.mark.slow
def test_a_state_needs_the_key_that_the_onboard_file_needs(watch, folder, tmp_path, area, capsys):
    keys = []
    for name in ("key", "other"):
        keys.append(str(tmp_path / name))
        (tmp_path / name).write_bytes(name.encode() * 8)
    signed, state = str(tmp_path / "signed.npz"), str(tmp_path / "flight.npz")
    onboard = read_onboard(area)
    put(folder, range(2))
    for number, key in enumerate([None, keys[0], keys[0], keys[1]]):
        if key:
            write_onboard(signed, onboard.database, onboard.lon_lat, key_file=key)
        watch("--state", state, *(["--database", signed, "--require-signature", key] if key else []))
        is_refused = "flight_state_not_used" in [told["event"] for told in events(capsys)]
        # First no state exists; then one of this user without a key; then the right one; then one of another key.
        assert is_refused == (number in (1, 3)), number


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="rights of POSIX")
def test_the_secret_of_a_user_is_private_and_another_user_s_state_is_not_used(watch, flown, home, capsys, monkeypatch):
    (secret,) = [path for path in home.rglob("*") if path.is_file() and path.stat().st_size == 32]
    assert secret.stat().st_mode & 0o077 == 0 and flown.stat().st_mode & 0o077 == 0
    user_at(home / "other", monkeypatch)
    watch("--state", str(flown))
    (told,) = events(capsys)
    assert told["event"] == "flight_state_not_used" and "secret of this user" in told["reason"]


@pytest.mark.slow
def test_a_fault_in_the_flight_is_not_carried_on(watch, folder, monkeypatch, capsys):
    from semref.core.flight.tracker import FlightTracker

    put(folder, range(3))
    original, calls = FlightTracker.add, []

    def add(tracker, *arguments):
        calls.append(tracker)
        if tracker is calls[0] and len(calls) > 1:
            raise ZeroDivisionError
        return original(tracker, *arguments)

    monkeypatch.setattr(FlightTracker, "add", add)
    _, records = watch()
    assert [record["status"] == "error" for record in records] == [False, True, False]


def test_a_disk_that_takes_no_state_is_reported_once_and_the_flight_goes_on(watch, folder, flown, capsys, monkeypatch):
    put(folder, [4])
    before = flown.read_bytes()

    def full(_):
        raise OSError(errno.ENOSPC, "full")

    monkeypatch.setattr("semref.core.onboard.state_file.os.fsync", full)
    _, records = watch("--state", str(flown))
    assert len(records) == 2
    assert [told["event"] for told in events(capsys)] == ["state_not_kept"]
    assert flown.read_bytes() == before and not list(flown.parent.glob(".*.part"))


def test_the_next_image_is_localized_while_a_slow_disk_takes_the_state(watch, folder, tmp_path, monkeypatch):
    from semref.core.flight.tracker import FlightTracker

    put(folder, range(3))
    add, second, in_time, numbers = FlightTracker.add, threading.Event(), [], []

    def counted(tracker, *arguments):
        numbers.append(len(numbers))
        if len(numbers) == 2:
            second.set()
        return add(tracker, *arguments)

    def flush(_):
        # This thread flushes the user's secret.
        if threading.current_thread() is not threading.main_thread():
            in_time.append(second.wait(20))

    monkeypatch.setattr(FlightTracker, "add", counted)
    monkeypatch.setattr("semref.core.onboard.state_file.os.fsync", flush)
    state = tmp_path / "flight.npz"
    _, records = watch("--state", str(state))
    assert in_time == [True] * 3 and len(records) == 3
    header = json.loads(arrays_of(state)["header"].tobytes())
    assert header["after"][1] == Path(records[-1]["image"]).name


# --- older onboard files ---


DATES = [datetime(2026, month, 1, tzinfo=timezone.utc) for month in (3, 5)]


@pytest.mark.slow
def test_an_onboard_file_that_is_older_than_one_used_before_is_reported(watch, folder, tmp_path, area, capsys):
    onboard = read_onboard(area)
    older, newer = (str(tmp_path / f"{date:%m}.npz") for date in DATES)
    for path, date in zip((older, newer), DATES):
        write_onboard(path, onboard.database, onboard.lon_lat, exported=date)
    put(folder, range(1))
    warned = []
    for path in (older, newer, older, older, area, newer):
        watch("--state", str(tmp_path / "flight.npz"), "--database", path)
        warned.append([told["newest"] for told in events(capsys) if told["event"] == "older_database"])
    newest = [DATES[1].isoformat()]
    assert warned == [[], [], newest, newest, newest, []]


@pytest.mark.slow
def test_one_bad_image_does_not_end_the_flight(watch, folder):
    put(folder, range(COUNT))
    (folder / "1.png").write_bytes(b"no image")
    os.utime(folder / "1.png", ns=(10**9, 10**9))
    code, records = watch()
    assert code == REFUSED and records[1]["status"] == "error"
    assert records[-1]["status"] == "fix" and off(records[-1], COUNT - 1) < 3


def row(number):
    """Return a row of the odometry table: to the right and down, like the images."""
    return f"{number}.png,{STEP},-8,0,1\n" if number else "0.png,,,,\n"


@pytest.fixture
def blind(monkeypatch):
    from semref.core.flight.pixel_motion import Motion

    monkeypatch.setattr("semref.core.onboard.flight.motion_between", lambda before, now: Motion(None))


@pytest.mark.slow
@pytest.mark.usefixtures("blind")
@pytest.mark.parametrize("is_told", [True, False])
def test_a_table_of_motion_keeps_the_track_without_texture(watch, folder, tmp_path, is_told):
    put(folder, range(4), blank=[2])
    table = tmp_path / "odometry.csv"
    table.write_text(ODOMETRY + "".join(map(row, range(4))), encoding="utf-8")
    _, records = watch(*(["--odometry", str(table)] if is_told else []))
    assert (records[2]["status"] == "fix" and records[2]["source"] == "flight") == is_told
    assert (records[3]["track"] == records[0]["track"]) == is_told


@pytest.mark.slow
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
def test_later_rows_do_not_change_earlier_records(watch, folder, tmp_path):
    table = tmp_path / "odometry.csv"
    put(folder, range(2))
    told = []
    for last in (2, 5):
        table.write_text(ODOMETRY + "".join(map(row, range(last))), encoding="utf-8")
        told.append(watch("--odometry", str(table))[1])
    assert told[0] == told[1]


def test_bad_tables_are_one_sentence_before_the_start(watch, folder, area, tmp_path, capsys):
    put(folder, range(1))
    table = tmp_path / "odometry.csv"
    for text, message in (("x,y\n1,2\n", "dheading_deg"), (ODOMETRY + "0,,,\n1,a,1,1\n", "dx_m is “a”")):
        table.write_text(text, encoding="utf-8")
        assert watch("--odometry", str(table)) == (REFUSED, [])
        assert message in capsys.readouterr().err
    assert watch("--odometry", str(tmp_path / "nowhere.csv"))[0] == REFUSED
    for wrong in (["--odometry", str(table)], ["--flight", "--odometry", str(table), "--state", str(table)]):
        with pytest.raises(SystemExit) as ended:
            main(["watch", str(folder), "--database", area, "--once", *wrong])
        assert ended.value.code == WRONG_USAGE
    assert "is an input of this command" in capsys.readouterr().err


def test_a_tilted_camera_of_a_table_is_leveled(watch, folder, tmp_path, monkeypatch):
    """The tilted image is at the same place on the ground as in QGIS."""
    put(folder, range(1))
    seen = []
    original = "semref.core.pipeline.level_labels"
    monkeypatch.setattr(original, lambda labels, way: seen.append(way) or level_labels(labels, way))
    table = tmp_path / "cameras.csv"
    table.write_text("image,roll,pitch,field_of_view,height\n0.png,2,-3,60,173\n", encoding="utf-8")
    watch("--cameras", str(table))
    (way,) = seen
    expected = leveling(Attitude(2, -3), SIZE / 2 / math.tan(math.radians(30)), (SIZE, SIZE))
    assert way.corners == pytest.approx(expected.corners)
