"""``python -m core``: what it prints, how it ends, and that a copy of its folder is all it needs."""

from __future__ import annotations

import json
import re
import shutil
import socket
import subprocess
import sys
import threading
from dataclasses import replace
from datetime import datetime, timezone
from pathlib import Path

import cv2
import numpy as np
import pytest
from made_models import metadata, write_model

from semref.core.database.build import BuildSettings, DatabaseBuilder
from semref.core.geometry.frame import MapFrame
from semref.core.geometry.lon_lat import fit_lon_lat
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.localization import Method
from semref.core.localizer.localizer import Localizer
from semref.core.localizer.record import gga_sentence
from semref.core.onboard import command_line
from semref.core.onboard.aircraft import AIRCRAFT_ROOMS
from semref.core.onboard.command_line import ALL_FIXED, REFUSED, SOME_WITHOUT_FIX, WRONG_USAGE, main
from semref.core.onboard.read import read_onboard
from semref.core.onboard.write import write_onboard

TABLE = ClassTable(
    (
        LandCoverClass(1, "building", "#ff0000", "reference"),
        LandCoverClass(2, "water", "#0000ff", "reference"),
        LandCoverClass(3, "bare_land", "#ffff00", "reference"),
        LandCoverClass(4, "field", "#00ff00"),
    )
)
FRAME = MapFrame('PROJCS["a metric CRS"]', (600000.0, 1.0, 0.0, 5200000.0, 0.0, -1.0))
SIZE = 200


def scattered(height=700, width=700, count=420):
    random = np.random.default_rng(7)
    labels = np.full((height, width), 4, np.uint8)
    while count:
        h, w = random.integers(6, 16, 2)
        row, column = random.integers(1, height - h - 1), random.integers(1, width - w - 1)
        if (labels[row - 1 : row + h + 1, column - 1 : column + w + 1] == 4).all():
            labels[row : row + h, column : column + w] = random.integers(1, 4)
            count -= 1
    return labels


MAP = scattered()
HERE = np.ascontiguousarray(np.rot90(MAP[300 : 300 + SIZE, 150 : 150 + SIZE]))
CENTER = (600250.0, 5199600.0)
NOTHING = np.full((SIZE, SIZE), 4, np.uint8)


def linear(points_xy):
    return 9 + (points_xy[:, 0] - 600000) / 80000, 47 + (points_xy[:, 1] - 5200000) / 111000


@pytest.fixture(scope="module")
def database(tmp_path_factory):
    builder = DatabaseBuilder(ArrayLabels(MAP), FRAME, TABLE, BuildSettings(200.0, 100.0, minimum_area=30.0), "1.2.3")
    for _ in builder.steps():
        pass
    path = str(tmp_path_factory.mktemp("onboard") / "area.npz")
    lon_lat = fit_lon_lat(linear, builder.database.parameters.extent)
    write_onboard(path, replace(builder.database, overview=builder.overview), lon_lat)
    return path


@pytest.fixture
def image(tmp_path):
    def write(name, labels=HERE):
        cv2.imwrite(str(tmp_path / name), labels)
        return str(tmp_path / name)

    return write


# --- info and localize ---


def test_info_tells_what_the_file_holds(database, capsys):
    assert main(["info", database]) == ALL_FIXED
    said = capsys.readouterr().out
    for text in ("references:", "1 building, 2 water", "position_error", "content_hash"):
        assert text in said
    assert main(["info", database, "--json"]) == ALL_FIXED
    found = json.loads(capsys.readouterr().out)
    assert (found["references"], found["crs"]) == (len(read_onboard(database).database.references), "a metric CRS")
    assert found["extent"] == [600000, 5199300, 600700, 5200000]


def test_an_image_is_localized_as_the_localizer_does(database, image, capsys):
    path = image("here.png")
    assert main(["localize", path, "--database", database, "--json"]) == ALL_FIXED
    found = json.loads(capsys.readouterr().out)
    expected = Localizer(read_onboard(database).database).localize(HERE, Method.AUTOMATIC)
    assert (found["image"], found["status"]) == (path, "fix")
    assert (found["x"], found["y"]) == expected.position
    assert found["x"], found["y"] == pytest.approx(CENTER, abs=0.5)
    assert found["heading"] == expected.heading_deg == pytest.approx(90, abs=0.5)
    longitudes, latitudes = linear(np.array([expected.position]))
    assert (found["longitude"], found["latitude"]) == pytest.approx((longitudes[0], latitudes[0]), abs=1e-7)


def test_without_json_a_person_can_read_it(database, image, capsys):
    assert main(["localize", image("here.png"), "--database", database]) == ALL_FIXED
    said = capsys.readouterr().out
    assert re.search(r"here\.png: fix, 600250\.\d+ 5199600\.\d+, longitude 9\.003\d+, .* heading 90\.0°", said)


def test_an_image_without_a_fix_tells_why(database, image, capsys):
    code = main(["localize", image("a.png"), image("b.png", NOTHING), "--database", database, "--json"])
    rows = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert code == SOME_WITHOUT_FIX
    assert [row["status"] for row in rows] == ["fix", "too_few_references"]
    assert rows[1]["reason"] and rows[1]["x"] is None


def test_a_bad_image_does_not_stop_the_others(database, image, tmp_path, capsys):
    (tmp_path / "a.png").write_bytes(b"no image")
    image("b.png")
    assert main(["localize", str(tmp_path), "--database", database, "--json"]) == REFUSED
    captured = capsys.readouterr()
    rows = [json.loads(line) for line in captured.out.splitlines()]
    assert [row["status"] for row in rows] == ["error", "fix"]
    entry = json.loads(captured.err)
    assert (entry["level"], entry["event"], entry["status"]) == ("warning", "image", "error")


def test_places_far_from_near_are_not_searched(database, image, capsys):
    near = ["--near", "600650", "5199950", "20"]
    assert main(["localize", image("here.png"), "--database", database, *near]) == SOME_WITHOUT_FIX


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["localize", "IMAGE", "--database", "missing.npz"], "There is no file missing.npz"),
        (["localize", "IMAGE", "--database", "DATABASE", "--near", "1", "2", "0"], "radius of --near is 0"),
        (["localize", "IMAGE", "--database", "DATABASE", "--threads", "0"], "--threads is 0"),
        (["localize", "FOLDER", "--database", "DATABASE"], "holds no image"),
        (["localize", "IMAGE", "--database", "DATABASE", "--model", "no.onnx"], "no.onnx"),
        (["watch", "nowhere", "--database", "DATABASE"], "There is no folder nowhere"),
        (["watch", "FOLDER", "--database", "DATABASE", "--gga", "udp:http"], "udp:http"),
        (["info", "IMAGE"], "no onboard file"),
    ],
)
def test_what_cannot_be_used_is_refused_in_one_sentence(database, image, tmp_path, capsys, arguments, said):
    folder = tmp_path / "empty"
    folder.mkdir()
    values = {"IMAGE": image("here.png"), "DATABASE": database, "FOLDER": str(folder)}
    arguments = [values.get(argument, argument) for argument in arguments]
    assert main(arguments + (["--once"] if "udp:http" in arguments else [])) == REFUSED
    captured = capsys.readouterr()
    assert said in captured.err and captured.err.count("\n") == 1
    assert captured.out == ""


def test_a_model_without_class_names_is_refused_without_a_parameter_of_the_plugin(database, image, tmp_path, capsys):
    model = write_model(tmp_path / "nameless.onnx", metadata=metadata(class_names=None))
    assert main(["localize", image("here.png"), "--database", database, "--model", str(model)]) == REFUSED
    said = capsys.readouterr().err
    assert "does not name its classes" in said and "CLASS_TABLE" not in said


def test_a_wrong_command_line_ends_with_the_usage(capsys):
    with pytest.raises(SystemExit) as ended:
        main(["localize", "a.png"])
    assert ended.value.code == WRONG_USAGE
    assert "--database" in capsys.readouterr().err


def test_the_help_names_the_commands_and_exit_codes(capsys):
    with pytest.raises(SystemExit):
        main(["--help"])
    said = capsys.readouterr().out
    for text in ("info", "localize", "watch", "examples:", "exit codes:"):
        assert text in said


def copy_aircraft_rooms(repository, folder):
    (folder / "core").mkdir()
    for name in AIRCRAFT_ROOMS:
        source, target = repository / "core" / name, folder / "core" / name
        if source.is_dir():
            shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(source, target)


def test_a_copy_of_the_rooms_of_an_aircraft_is_all_that_is_needed(database, image, repository, tmp_path):
    copy_aircraft_rooms(repository, tmp_path)
    program = (
        "import runpy, sys\n"
        "sys.path.insert(0, '')\n"
        "for name in ('qgis', 'osgeo', 'onnxruntime', 'shapely', 'scipy', 'PyQt5'):\n"
        "    sys.modules[name] = None\n"
        "runpy.run_module('core', run_name='__main__')\n"
    )
    command = [sys.executable, "-c", program, "localize", image("here.png"), "--database", database, "--json"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (ALL_FIXED, "")
    assert json.loads(done.stdout)["status"] == "fix"


# --- watch ---


def test_watch_writes_json_lines_and_sentences_into_files(database, image, tmp_path):
    folder = tmp_path / "incoming"
    folder.mkdir()
    for name, labels in (("a.png", HERE), ("b.png", NOTHING)):
        cv2.imwrite(str(folder / name), labels)
    fixes, gga = tmp_path / "fixes.jsonl", tmp_path / "fixes.nmea"
    where = ["--fixes", str(fixes), "--gga", str(gga)]
    assert main(["watch", str(folder), "--database", database, "--once", *where]) == SOME_WITHOUT_FIX
    rows = [json.loads(line) for line in fixes.read_text(encoding="utf-8").splitlines()]
    assert [row["status"] for row in rows] == ["fix", "too_few_references"]
    first, second = gga.read_bytes().decode("ascii").split("\r\n")[:2]
    # 9.003125° E, 46.996396…° N
    assert re.fullmatch(r"\$GPGGA,\d{6}\.\d\d,4659\.78\d{3},N,00900\.18\d{3},E,6,\d\d,,,M,,M,,\*[0-9A-F]{2}", first)
    assert re.fullmatch(r"\$GPGGA,\d{6}\.\d\d,,,,,0,00,,,M,,M,,\*[0-9A-F]{2}", second)


def test_watch_sends_sentences_to_a_port_of_this_computer(database, tmp_path):
    cv2.imwrite(str(tmp_path / "a.png"), HERE)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(10)
        where = ["--fixes", str(tmp_path / "fixes"), "--gga", f"udp:{receiver.getsockname()[1]}"]
        assert main(["watch", str(tmp_path), "--database", database, "--once", *where]) == ALL_FIXED
        assert receiver.recv(200).startswith(b"$GPGGA,")


def test_watch_takes_an_image_when_it_is_complete(monkeypatch):
    """Size and time of change, look by look: an image that grows waits, one that is written anew comes again."""
    looks = iter(
        [{"b": (2, 10)}, {"b": (2, 10), "a": (3, 5)}, {"b": (2, 10), "a": (4, 9)}, {"b": (5, 11), "a": (4, 9)}]
        + 2 * [{"b": (5, 11), "a": (4, 9)}]
    )
    monkeypatch.setattr(command_line, "_images_in", lambda folder: next(looks))
    monkeypatch.setattr(command_line.time, "sleep", lambda seconds: None)
    arriving = command_line._arriving("folder", once=False)
    assert [next(arriving), next(arriving), next(arriving)] == ["b", "a", "b"]


def test_watch_takes_images_as_they_come(database, tmp_path, repository):
    folder = tmp_path / "incoming"
    folder.mkdir()
    copy_aircraft_rooms(repository, tmp_path)
    command = [sys.executable, "-m", "core", "watch", "incoming", "--database", database]
    watching = subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, text=True)
    killer = threading.Timer(60, watching.kill)
    killer.start()
    try:
        for name in ("a.png", "b.png"):
            cv2.imwrite(str(tmp_path / name), HERE)
            (tmp_path / name).rename(folder / name)
            found = json.loads(watching.stdout.readline())
            assert (found["image"], found["status"]) == (str(Path("incoming", name)), "fix")
        assert watching.poll() is None
    finally:
        killer.cancel()
        watching.kill()
        watching.communicate()


def test_a_sentence_has_its_checksum_and_never_sixty_minutes():
    moment = datetime(2026, 5, 1, 12, 34, 56, 789_000, timezone.utc)
    # Checked by hand: the exclusive or of all characters between $ and *.
    text = gga_sentence(moment, -9.99999999999, 46.9999999999, 150)
    assert text.startswith("$GPGGA,123456.78,4700.00000,N,01000.00000,W,6,99,,,M,,M,,*")
    total = 0
    for character in text[1:-3]:
        total ^= ord(character)
    assert text.endswith(f"*{total:02X}")
    assert gga_sentence(moment, 0.5, -0.25).split(",")[2:6] == ["0015.00000", "S", "00030.00000", "E"]
