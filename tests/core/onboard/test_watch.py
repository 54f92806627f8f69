import errno
import json
import os
import re
import socket
import subprocess
import sys
import threading
import time
from datetime import datetime, timezone
from pathlib import Path
from unittest.mock import Mock

import cv2
import pytest
from onboard_area import HERE, LIKELY, NOTHING, SMALL, copy_core

from semref.core.errors import ParameterError
from semref.core.onboard import watch
from semref.core.onboard.command_line import ALL_FIXED, REFUSED, SOME_WITHOUT_FIX, main
from semref.core.onboard.log import start_log
from semref.core.onboard.nmea import gga_sentence
from semref.core.onboard.sinks import open_sink

needs_full_device = pytest.mark.skipif(not os.path.exists("/dev/full"), reason="this system has no full device")


@pytest.fixture
def watching(area, folder, repository, tmp_path):
    copy_core(repository, tmp_path)
    started = []

    def start(*arguments):
        command = [sys.executable, "-m", "core", "watch", "incoming", "--database", area, *arguments]
        process = subprocess.Popen(
            command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, encoding="utf-8"
        )
        killer = threading.Timer(60, process.kill)
        killer.start()
        started.append((process, killer))
        return process

    yield start
    for process, killer in started:
        killer.cancel()
        process.kill()
        for stream in (process.stdout, process.stderr):
            stream.close()
        process.wait()


def put(folder, name, labels=HERE):
    cv2.imwrite(str(folder.parent / "made.png"), labels)
    os.rename(folder.parent / "made.png", os.path.join(os.fsencode(folder), os.fsencode(name)))


def test_watch_writes_json_lines_and_sentences_into_files_without_likely_positions(area, folder, tmp_path):
    for name, labels in (("a.png", HERE), ("b.png", NOTHING), ("c.png", SMALL)):
        cv2.imwrite(str(folder / name), labels)
    fixes, gga = tmp_path / "fixes.jsonl", tmp_path / "fixes.nmea"
    where = ["--fixes", str(fixes), "--gga", str(gga), *LIKELY]
    assert main(["watch", str(folder), "--database", area, "--once", *where]) == SOME_WITHOUT_FIX
    rows = [json.loads(line) for line in fixes.read_text(encoding="utf-8").splitlines()]
    assert [row["status"] for row in rows] == ["fix", "too_few_references", "likely"]
    assert rows[2]["longitude"] > 9 and rows[2]["error_95"] > 0
    first, *others, end = gga.read_bytes().decode("ascii").split("\r\n")
    # 9.003125° E, 46.996396…° N
    assert re.fullmatch(r"\$GPGGA,\d{6}\.\d\d,4659\.78\d{3},N,00900\.18\d{3},E,6,\d\d,,,M,,M,,\*[0-9A-F]{2}", first)
    without = re.compile(r"\$GPGGA,\d{6}\.\d\d,,,,,0,00,,,M,,M,,\*[0-9A-F]{2}")
    assert all(map(without.fullmatch, others)) and (len(others), end) == (2, "")


def test_a_sentence_has_its_checksum_never_sixty_minutes_and_no_place_without_a_position():
    moment = datetime(2026, 5, 1, 12, 34, 56, 789_000, timezone.utc)
    # The checksum is the exclusive or of all characters between $ and *.
    found = gga_sentence(moment, -9.99999999999, 46.9999999999, 150)
    assert found == "$GPGGA,123456.78,4700.00000,N,01000.00000,W,6,99,,,M,,M,,*6D"
    assert gga_sentence(moment, 0.5, -0.25).split(",")[2:6] == ["0015.00000", "S", "00030.00000", "E"]
    assert gga_sentence(moment).startswith("$GPGGA,123456.78,,,,,0,00,,,M,,M,,*")


def test_watch_sends_sentences_to_a_port_of_this_computer(area, tmp_path):
    cv2.imwrite(str(tmp_path / "a.png"), HERE)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(10)
        where = ["--fixes", str(tmp_path / "fixes"), "--gga", f"udp:{receiver.getsockname()[1]}"]
        assert main(["watch", str(tmp_path), "--database", area, "--once", *where]) == ALL_FIXED
        assert receiver.recv(200).startswith(b"$GPGGA,")


def test_watch_takes_an_image_when_it_is_complete(monkeypatch):
    """Check size and change time at each look: a growing image waits, and a rewritten one is read again."""
    looks = iter(
        [{"b": (2, 10)}, {"b": (2, 10), "a": (3, 5)}, {"b": (2, 10), "a": (4, 9)}, {"b": (5, 11), "a": (4, 9)}]
        + 2 * [{"b": (5, 11), "a": (4, 9)}]
    )
    monkeypatch.setattr(watch, "_images_in", lambda folder: next(looks))
    monkeypatch.setattr(watch.time, "sleep", lambda seconds: None)
    arriving = watch.arriving_images("folder", once=False)
    assert [next(arriving), next(arriving), next(arriving)] == ["b", "a", "b"]


def test_names_that_are_no_text_links_to_themselves_and_pipes_do_not_end_it(watching, folder):
    os.symlink("loop.png", folder / "loop.png")
    os.symlink("nowhere", folder / "broken.png")
    os.mkfifo(folder / "pipe.png")
    (folder / "folder.png").mkdir()
    process = watching("--log-level", "info")
    assert json.loads(process.stderr.readline())["event"] == "ready"
    name = os.fsdecode(b"\xff\xfe.png")
    put(folder, name)
    found = json.loads(process.stdout.readline())
    assert (found["image"], found["status"]) == (os.path.join("incoming", name), "fix")
    assert json.loads(process.stderr.readline())["image"] == os.path.join("incoming", name)
    put(folder, "after.png")
    assert json.loads(process.stdout.readline())["image"] == str(Path("incoming", "after.png"))
    assert process.poll() is None


def test_with_once_the_images_beside_a_link_to_itself_are_done(area, folder, capsys):
    os.symlink("loop.png", folder / "loop.png")
    put(folder, os.fsdecode(b"\xff.png"))
    assert main(["watch", str(folder), "--database", area, "--once"]) == ALL_FIXED
    assert json.loads(capsys.readouterr().out)["status"] == "fix"


def test_with_once_a_folder_that_is_gone_is_an_error(area, folder, monkeypatch, capsys):
    monkeypatch.setattr(watch, "_images_in", Mock(side_effect=NotADirectoryError(20, "Not a directory")))
    assert main(["watch", str(folder), "--database", area, "--once"]) == REFUSED
    assert "can't be read: Not a directory" in capsys.readouterr().err


@needs_full_device
@pytest.mark.parametrize(("full", "other"), [("--fixes", "--gga"), ("--gga", "--fixes")])
def test_a_full_disk_under_one_sink_stops_neither_the_other_nor_watching(area, folder, tmp_path, capsys, full, other):
    for name in ("a.png", "b.png"):
        put(folder, name)
    arguments = [full, "/dev/full", other, str(tmp_path / "lines")]
    assert main(["watch", str(folder), "--database", area, "--once", *arguments]) == REFUSED
    assert len((tmp_path / "lines").read_bytes().splitlines()) == 2
    event = json.loads(capsys.readouterr().err)
    assert (event["level"], event["event"], event["where"]) == ("error", "sink_fails", "/dev/full")


def test_a_closed_stdout_ends_neither_the_sentences_nor_the_watching(watching, folder, tmp_path):
    process = watching("--gga", "sentences")
    process.stdout.close()
    put(folder, "a.png")
    assert json.loads(process.stderr.readline())["event"] == "sink_fails"
    put(folder, "b.png")
    deadline = time.monotonic() + 30
    while (tmp_path / "sentences").read_bytes().count(b"\n") < 2 and time.monotonic() < deadline:
        time.sleep(0.05)
    assert (tmp_path / "sentences").read_bytes().count(b"\n") == 2
    assert process.poll() is None


def test_what_was_removed_from_the_folder_is_forgotten(folder):
    """A watch of weeks must not need more and more memory."""
    put(folder, "a.png")
    arriving = watch.arriving_images(str(folder), once=False)
    assert next(arriving) == str(folder / "a.png")
    (folder / "a.png").unlink()
    put(folder, "b.png")
    assert next(arriving) == str(folder / "b.png")
    assert list(arriving.gi_frame.f_locals["done"]) == [str(folder / "b.png")]


def test_a_folder_that_returns_is_reported_once_and_its_images_are_new(monkeypatch):
    """At successive looks the folder is there, gone twice, and there again."""
    here, both = {"a": (1, 9)}, {"a": (1, 9), "b": (2, 3)}
    looks = iter([here, here, None, None, here, both, both, both])

    def look(folder):
        found = next(looks)
        if found is None:
            raise FileNotFoundError(2, "No such file or directory")
        return found

    said = []
    monkeypatch.setattr(watch, "_images_in", look)
    monkeypatch.setattr(watch, "log_event", lambda level, code, **values: said.append(code))
    monkeypatch.setattr(watch.time, "sleep", lambda seconds: None)
    arriving = watch.arriving_images("folder", once=False)
    assert [next(arriving), next(arriving)] == ["a", "b"]
    assert said == ["folder_gone", "folder_back"]


def test_images_of_one_look_come_oldest_first_and_empty_ones_wait(monkeypatch):
    look = {"late": (9, 1), "b": (3, 1), "a": (3, 1), "empty": (1, 0)}
    monkeypatch.setattr(watch, "_images_in", lambda folder: look)
    monkeypatch.setattr(watch.time, "sleep", lambda seconds: None)
    arriving = watch.arriving_images("folder", once=False)
    assert [next(arriving) for _ in range(3)] == ["a", "b", "late"]
    assert list(watch.arriving_images("folder", once=True)) == ["empty", "a", "b", "late"]


class FullAfter:
    """File on a disk with a limited number of free bytes."""

    def __init__(self, file, room):
        self.file, self.room = file, room

    def write(self, data):
        if not self.room:
            raise OSError(errno.ENOSPC, "No space left on device")
        taken = self.file.write(data[: self.room])
        self.room -= taken
        return taken

    def fileno(self):
        return self.file.fileno()

    def close(self):
        self.file.close()


def test_a_disk_that_fills_within_a_line_keeps_only_whole_lines(tmp_path, capsys):
    start_log("warning")
    sink = open_sink(str(tmp_path / "lines"))
    sink.send("first\n")
    sink._file = FullAfter(sink._file, room=3)
    sink.send("second\n")
    sink.send("third\n")
    sink._file.room = 100
    sink.send("fourth\n")
    sink.close()
    assert (tmp_path / "lines").read_text() == "first\nfourth\n"
    assert sink.lost == 2
    events = [json.loads(line) for line in capsys.readouterr().err.splitlines()]
    assert [line["event"] for line in events] == ["sink_fails", "sink_works_again"]
    assert events[0]["reason"] == "No space left on device" and events[1]["lost"] == 2


@pytest.mark.parametrize("where", ["udp:0", "udp:65536", "udp:", "udp:-1", "udp:http", "udp:" + "9" * 5000])
def test_an_invalid_port_is_refused(where):
    with pytest.raises(ParameterError, match="not a UDP port"):
        open_sink(where)


def test_a_place_that_cannot_be_opened_is_refused(tmp_path):
    os.mkfifo(tmp_path / "pipe without a reader")
    for where in (str(tmp_path), str(tmp_path / "no" / "file"), "a\0b", str(tmp_path / "pipe without a reader")):
        with pytest.raises(ParameterError, match="can't be written"):
            open_sink(where)


def test_a_line_that_a_power_cut_left_half_is_not_continued(tmp_path):
    path = tmp_path / "fixes"
    path.write_bytes(b'{"image": "1.png"}\n{"image": "2.p')
    sink = open_sink(str(path))
    sink.send('{"image": "3.png"}\n')
    sink.send('{"image": "4.png"}\n')
    sink.close()
    assert path.read_bytes().split(b"\n")[1:] == [b'{"image": "2.p', b'{"image": "3.png"}', b'{"image": "4.png"}', b""]
    sink = open_sink(str(path))
    sink.close()
    assert path.read_bytes().endswith(b'"4.png"}\n')
