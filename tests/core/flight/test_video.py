import csv
import os
import sys

import cv2
import numpy as np
import pytest
from full_disks import files_of_at_most

from semref.core.errors import ParameterError
from semref.core.flight.telemetry import telemetry
from semref.core.flight.video import main, subtitles_of, write_frames

NAN = float("nan")


@pytest.fixture
def video(tmp_path):
    """Return a video of forty frames at ten per second, each with its own gray."""
    path = tmp_path / "flight.avi"
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter_fourcc(*"MJPG"), 10, (96, 64))
    if not writer.isOpened():
        pytest.skip("this OpenCV writes no video")
    for number in range(40):
        writer.write(np.full((64, 96, 3), 5 * number, np.uint8))
    writer.release()
    return path


def rows(folder):
    return list(csv.DictReader((folder / "cameras.csv").read_text(encoding="utf-8").splitlines()))


def test_frames_come_at_the_rate_with_their_times(video, tmp_path):
    folder = tmp_path / "out"
    found = list(write_frames(str(video), str(folder), 1.0))
    assert len(found) == 4
    assert [float(row["time"]) for row in rows(folder)] == pytest.approx([0, 1, 2, 3], abs=0.11)
    assert [cv2.imread(path)[0, 0, 0] for path, _ in found] == pytest.approx([0, 50, 100, 150], abs=8)
    assert [row["image"] for row in rows(folder)] == [path.rsplit("/", 1)[-1] for path, _ in found]
    shares = [share for _, share in found]
    assert shares == sorted(shares) and shares[-1] <= 1


def test_a_gimbal_in_the_log_levels_the_frames(video, tmp_path):
    log = telemetry([t / 2 for t in range(9)], [[30, 0, -85, 50, NAN, NAN]] * 9, is_gimbal=True)
    list(write_frames(str(video), str(tmp_path / "out"), 2.0, log))
    first = rows(tmp_path / "out")[0]
    assert (float(first["heading"]), float(first["pitch"]), float(first["roll"])) == (30, 5, 0)


@pytest.mark.parametrize(
    "data", [b"", b"#EXTM3U\nhttp://nowhere/x.ts\n", b"v=0\nc=IN IP4 1.2.3.4\n", b"RIFF0000AVI junk"]
)
def test_what_is_no_video_is_refused(tmp_path, data):
    path = tmp_path / "x.mp4"
    path.write_bytes(data)
    with pytest.raises(ParameterError):
        list(write_frames(str(path), str(tmp_path / "out"), 1.0))
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("every", [0, -1, NAN, 1e9])
def test_a_rate_that_makes_no_sense_is_refused(video, tmp_path, every):
    with pytest.raises(ParameterError, match="must be from"):
        list(write_frames(str(video), str(tmp_path / "out"), every))


def test_the_command_takes_subtitles_beside_the_video(video, tmp_path, capsys):
    (tmp_path / "flight.SRT").write_text("1\n00:00:00,000 --> 00:00:01,000\n[gb_yaw: 12 gb_pitch: -90 gb_roll: 0]\n")
    assert subtitles_of(str(video)).endswith("flight.SRT")
    assert main([str(video), str(tmp_path / "out"), "--every", "5"]) == 0
    assert rows(tmp_path / "out")[0]["heading"] == "12.00"
    assert main([str(tmp_path / "none.mp4"), str(tmp_path / "out")]) == 1
    assert "can't be read" in capsys.readouterr().err


def test_nothing_is_overwritten_and_an_existing_camera_table_is_reported_before_a_frame_is_written(video, tmp_path):
    folder = tmp_path / "out"
    folder.mkdir()
    (folder / "cameras.csv").write_text("mine")
    with pytest.raises(ParameterError, match="cameras.csv exists already"):
        list(write_frames(str(video), str(folder), 1.0))
    assert [path.name for path in folder.iterdir()] == ["cameras.csv"]
    list(write_frames(str(video), str(tmp_path / "other"), 2.0))
    with pytest.raises(ParameterError, match="exists already"):
        list(write_frames(str(video), str(tmp_path / "other"), 2.0))


@pytest.mark.skipif(os.name == "nt", reason="limits of files are Unix's")
def test_a_full_disk_leaves_no_half_image(video, tmp_path):
    with files_of_at_most(100), pytest.raises(ParameterError, match="can't be written: File too large"):
        list(write_frames(str(video), str(tmp_path / "out"), 1.0))
    assert not list((tmp_path / "out").iterdir())


@pytest.mark.skipif(sys.platform != "linux", reason="names are text elsewhere")
def test_a_name_that_is_no_text_is_shown_escaped(video, tmp_path, capsys):
    odd = os.fsdecode(os.fsencode(tmp_path) + b"/odd\xff")
    assert main([str(video), odd, "--every", "5"]) == 0
    os.rename(video, odd + ".avi")
    assert main([odd + ".avi", str(tmp_path / "out")]) == 1
    said = capsys.readouterr()
    assert "odd\\udcff" in said.out and "odd\\udcff.avi is not a readable video" in said.err
