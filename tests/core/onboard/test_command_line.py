import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np
import pytest
from made_models import metadata, write_model
from onboard_area import CENTER, HERE, LIKELY, NOTHING, SMALL, copy_core
from onboard_blobs import linear

from semref.core.localization import Method
from semref.core.localizer.localizer import Localizer
from semref.core.onboard import command_line
from semref.core.onboard.command_line import ALL_FIXED, REFUSED, SOME_WITHOUT_FIX, WRONG_USAGE, main
from semref.core.onboard.read import read_onboard


@pytest.fixture
def image(tmp_path):
    def write(name, labels=HERE):
        cv2.imwrite(str(tmp_path / name), labels)
        return str(tmp_path / name)

    return write


def test_info_shows_the_content_of_the_file(area, capsys):
    assert main(["info", area]) == ALL_FIXED
    said = capsys.readouterr().out
    assert all(text in said for text in ("references:", "1 building, 2 water", "position_error", "content_hash"))
    assert main(["info", area, "--json"]) == ALL_FIXED
    found = json.loads(capsys.readouterr().out)
    assert (found["references"], found["crs"]) == (len(read_onboard(area).database.references), "a metric CRS")
    assert found["extent"] == [600000, 5199300, 600700, 5200000]


def test_an_image_is_localized_as_the_localizer_does(area, image, capsys):
    path = image("here.png")
    assert main(["localize", path, "--database", area, "--json"]) == ALL_FIXED
    found = json.loads(capsys.readouterr().out)
    expected = Localizer(read_onboard(area).database).localize(HERE, Method.AUTOMATIC)
    assert (found["image"], found["status"]) == (path, "fix")
    assert (found["x"], found["y"]) == expected.position
    assert found["x"], found["y"] == pytest.approx(CENTER, abs=0.5)
    assert found["heading"] == expected.heading_deg == pytest.approx(90, abs=0.5)
    longitudes, latitudes = linear(np.array([expected.position]))
    assert (found["longitude"], found["latitude"]) == pytest.approx((longitudes[0], latitudes[0]), abs=1e-7)


def test_without_json_a_person_can_read_it_and_places_far_from_near_are_not_searched(area, image, capsys):
    assert main(["localize", image("he\nre.png"), "--database", area]) == ALL_FIXED
    said = capsys.readouterr().out
    assert re.search(r"he\\nre\.png: fix, 600250\.\d+ 5199600\.\d+, longitude 9\.003\d+, .* heading 90\.0°", said)
    near = ["--near", "600650", "5199950", "20"]
    assert main(["localize", image("here.png"), "--database", area, *near]) == SOME_WITHOUT_FIX


def test_an_image_without_a_fix_has_a_reason(area, image, capsys):
    code = main(["localize", image("a.png"), image("b.png", NOTHING), "--database", area, "--json"])
    rows = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert (code, [row["status"] for row in rows]) == (SOME_WITHOUT_FIX, ["fix", "too_few_references"])
    assert rows[1]["reason"] and rows[1]["x"] is None


def test_a_likely_position_is_shown_but_is_no_fix(area, image, capsys):
    arguments = ["localize", image("a.png", SMALL), "--database", area, *LIKELY]
    assert main([*arguments, "--json"]) == SOME_WITHOUT_FIX
    found = json.loads(capsys.readouterr().out)
    # The image is the upper left part of HERE, whose top points east.
    assert found["status"] == "likely" and (found["x"], found["y"]) == pytest.approx((600295, 5199645), abs=3)
    assert found["error_95"] > 0 and 0.8 <= found["confidence"] < 1 and 9 < found["longitude"] < 9.01
    assert "error probability" in found["reason"]
    assert main(arguments) == SOME_WITHOUT_FIX
    line = r"a\.png: likely, 6002\d\d\.\d+ .*, error probability .*\. This position is only likely"
    assert re.search(line, capsys.readouterr().out)


def test_a_bad_image_or_a_photo_without_a_model_does_not_stop_the_others(area, image, tmp_path, capsys):
    (tmp_path / "a.png").write_bytes(b"no image")
    image("b.png")
    image("c.jpg", NOTHING)
    assert main(["localize", str(tmp_path), "--database", area, "--json"]) == REFUSED
    captured = capsys.readouterr()
    rows = [json.loads(line) for line in captured.out.splitlines()]
    assert [row["status"] for row in rows] == ["error", "fix", "too_few_references"]
    bad, photo = map(json.loads, captured.err.splitlines())
    assert (bad["level"], bad["event"], bad["status"]) == ("warning", "image", "error")
    assert (photo["event"], photo["image"]) == ("no_model", str(tmp_path / "c.jpg"))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["localize", "IMAGE", "--database", "missing.npz"], "The file missing.npz does not exist"),
        (["localize", "FOLDER", "--database", "DATABASE"], "contains no image"),
        (["localize", "IMAGE", "--database", "DATABASE", "--model", "no.onnx"], "no.onnx"),
        (["localize", "IMAGE", "--database", "DATABASE", "--near", "47", "9", "500"], "touch the map (x 600000 to"),
        (["watch", "nowhere", "--database", "DATABASE"], "The folder nowhere does not exist"),
        (["info", "IMAGE"], "not an onboard file"),
        (["info", "FOLDER"], "is a folder, pipe or device"),
    ],
)
def test_what_cannot_be_used_is_refused_in_one_sentence(area, image, tmp_path, capsys, arguments, said):
    folder = tmp_path / "empty"
    folder.mkdir()
    values = {"IMAGE": image("here.png"), "DATABASE": area, "FOLDER": str(folder)}
    arguments = [values.get(argument, argument) for argument in arguments]
    assert main(arguments) == REFUSED
    captured = capsys.readouterr()
    assert said in captured.err and (captured.err.count("\n"), captured.out) == (1, "")


def test_a_model_without_class_names_is_refused_without_a_parameter_of_the_plugin(area, image, tmp_path, capsys):
    model = write_model(tmp_path / "nameless.onnx", metadata=metadata(class_names=None))
    assert main(["localize", image("here.png"), "--database", area, "--model", str(model)]) == REFUSED
    said = capsys.readouterr().err
    assert "does not name its classes" in said and "CLASS_TABLE" not in said


NUMBERS = (
    *("--near nan nan 100", "--near inf 0 100", "--near 1e308 0 100", "--threads 0", "--sun 361", "--sun nan"),
    *("--risk 0.9", "--mavlink-system 256", "--mavlink-origin nan 0", "--camera-yaw 361"),
)
MAVLINK = "udp:0", "tcp:1.2.3.4:5", "serial:", "udp:a..b:14550", "udp:\udcff:14550"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        *((text, ": ".join(text.split()[:2])) for text in NUMBERS),
        ("--near 0 0 inf", "--near: inf"),
        ("--near 1 2 0", "--near: the radius is 0"),
        ("--threads 1.5", "--threads: invalid"),
        ("--threads 1000000000000", "from 1 to 256"),
        ("--device abacus", "directml"),
        ("--state flight.state", "--state: it needs --flight"),
        ("--gga udp:http", "not a UDP port"),
        *((f"--mavlink {address}", "not a MAVLink address") for address in MAVLINK),
        ("--mavlink-origin 91 0", "--mavlink-origin: the latitude is 91"),
    ],
)
def test_a_value_that_is_out_of_range_is_a_wrong_command_line(area, tmp_path, capsys, arguments, said):
    with pytest.raises(SystemExit) as ended:
        main(["watch", str(tmp_path), "--once", "--database", area, *arguments.split()])
    assert ended.value.code == WRONG_USAGE
    captured = capsys.readouterr()
    assert said in captured.err and captured.out == ""


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")
def test_only_regular_files_of_a_bounded_size_are_read(area, tmp_path, capsys):
    """Reading a pipe would never end, and /dev/zero would fill the memory."""
    pipe, sparse = tmp_path / "pipe.png", tmp_path / "sparse.png"
    os.mkfifo(pipe)
    with open(sparse, "wb") as file:
        file.truncate(2_000_000_000)
    images = [str(pipe), "/dev/zero", str(sparse), str(tmp_path / "no.png")]
    assert main(["localize", *images, "--database", area, "--json"]) == REFUSED
    rows = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [row["status"] for row in rows] == ["error"] * 4
    for row, said in zip(rows, ("folder, pipe or device", "folder, pipe or device", "2000 MB", "No such file")):
        assert said in row["reason"]


def test_a_fault_of_the_program_is_no_missing_fix(area, image, capsys, monkeypatch):
    """Python's exit code for a traceback is 1, which here means that an image has no fix."""

    def broken(*_, **__):
        raise ZeroDivisionError("by chance")

    monkeypatch.setattr(Localizer, "localize", broken)
    assert main(["localize", image("here.png"), "--database", area, "--json"]) == REFUSED
    captured = capsys.readouterr()
    assert json.loads(captured.out)["reason"] == "ZeroDivisionError: by chance"
    assert "Traceback" in json.loads(captured.err.splitlines()[0])["traceback"]
    monkeypatch.setattr(command_line, "read_onboard", broken)
    assert main(["info", area]) == REFUSED
    assert capsys.readouterr().err.splitlines()[-1] == "info: ZeroDivisionError: by chance"


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="this system has no full device")
def test_a_full_stdout_is_reported_in_one_sentence(area, repository, tmp_path):
    copy_core(repository, tmp_path)
    for given, name in ([["info", area], "info"], [["--help"], "python -m core"]):
        command = [sys.executable, "-m", "core", *given]
        with open("/dev/full", "wb") as full:
            done = subprocess.run(command, cwd=tmp_path, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        assert done.returncode == REFUSED
        assert done.stderr == f"{name}: stdout can't be written: No space left on device. Choose another output.\n"


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such signal")
@pytest.mark.parametrize("closed", [1, 2])
def test_closed_streams_are_no_fault(area, repository, closed):
    command = [sys.executable, "-m", "core", "info", area]
    done = subprocess.run(
        command, cwd=repository, stderr=subprocess.PIPE, preexec_fn=lambda: os.close(closed), check=False
    )
    assert (done.returncode, done.stderr) == (ALL_FIXED, b"")


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such signal")
def test_an_interrupt_while_the_command_is_loaded_shows_no_traceback(repository):
    program = (
        "import os, signal, sys; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "class Loading:\n"
        "    def find_spec(self, name, *_):\n"
        "        if name == 'cv2':\n"
        "            os.kill(os.getpid(), signal.SIGINT)\n"
        "sys.meta_path.insert(0, Loading())\n"
        "from core.__main__ import run\n"
        "run()\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, "info"], cwd=repository, stderr=subprocess.PIPE, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (-signal.SIGINT, "")


def test_a_copy_of_core_is_all_that_is_needed(area, image, repository, tmp_path):
    copy_core(repository, tmp_path)
    program = (
        "import runpy, sys\n"
        "sys.path.insert(0, '')\n"
        "for name in ('qgis', 'osgeo', 'onnxruntime', 'shapely', 'scipy', 'PyQt5'):\n"
        "    sys.modules[name] = None\n"
        "runpy.run_module('core', run_name='__main__')\n"
    )
    command = [sys.executable, "-c", program, "localize", image("here.png"), "--database", area, "--json"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (ALL_FIXED, "")
    assert json.loads(done.stdout)["status"] == "fix"


def outputs() -> list[str]:
    """Return the options of ``watch`` for files that it writes."""
    (commands,) = (action for action in command_line.command_parser()._actions if action.dest == "name")
    watch = commands.choices["watch"]._actions
    return ["--state", *(f"--{one.dest}" for one in watch if one.metavar == "WHERE" and one.dest != "mavlink")]


def test_two_outputs_in_one_file_are_refused_because_the_state_would_replace_the_fixes(area, tmp_path, capsys):
    watched = ["watch", str(tmp_path), "--once", "--flight", "--database", area]
    with pytest.raises(SystemExit) as ended:
        main([*watched, "--state", str(tmp_path / "flown"), "--fixes", str(tmp_path / "." / "flown")])
    assert ended.value.code == WRONG_USAGE and "flown is given for two outputs" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("option", outputs())
def test_nothing_is_written_into_the_database_or_an_image(area, image, capsys, option):
    photo = image("here.png")
    for path, said in ((area, "is an input of this command"), (photo, "has the name of an image")):
        before = Path(path).read_bytes()
        with pytest.raises(SystemExit) as ended:
            main(["watch", os.path.dirname(photo), "--once", "--flight", "--database", area, option, path])
        assert ended.value.code == WRONG_USAGE and said in capsys.readouterr().err
        assert Path(path).read_bytes() == before
