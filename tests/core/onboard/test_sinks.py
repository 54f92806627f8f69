"""Sinks of a watch: no partial lines remain, and recovery is reported."""

from __future__ import annotations

import errno
import json

import pytest

from semref.core.errors import ParameterError
from semref.core.onboard.log import start_log
from semref.core.onboard.sinks import open_sink


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
    told = [json.loads(line) for line in capsys.readouterr().err.splitlines()]
    assert [line["event"] for line in told] == ["sink_fails", "sink_works_again"]
    assert told[0]["reason"] == "No space left on device" and told[1]["lost"] == 2


@pytest.mark.parametrize("where", ["udp:0", "udp:65536", "udp:", "udp:-1", "udp:" + "9" * 5000])
def test_an_invalid_port_is_refused(where):
    with pytest.raises(ParameterError, match="not a UDP port"):
        open_sink(where)


def test_a_place_that_cannot_be_opened_is_refused(tmp_path):
    for where in (str(tmp_path), str(tmp_path / "no" / "file"), "a\0b"):
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
