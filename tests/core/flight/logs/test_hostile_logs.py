import contextlib
import struct
import time

import numpy as np
import pytest
from growth import LINEAR, growth, seconds

from semref.core import limits
from semref.core.errors import ParameterError
from semref.core.flight.logs import ulog
from semref.core.flight.logs.dataflash import read_dataflash
from semref.core.flight.logs.files import read_log
from semref.core.flight.logs.mavlink import read_tlog
from semref.core.flight.logs.texts import read_geo, read_srt
from semref.core.flight.logs.ulog import read_ulog
from semref.core.labels.openstreetmap import tags_of
from semref.core.labels.photo_tags import PhotoTags
from semref.core.segmentation.session import reason_of
from semref.core.values import read_json

ULOG = b"ULog\x01\x12\x35\x01" + bytes(8)
BLOCK = "00:00:00,000 --> " + "".join(f"gb_{name}{' ' * 1300}x" for name in ("yaw", "roll", "pitch"))


def message(kind, content):
    return struct.pack("<HB", len(content), ord(kind)) + content


def topic(field, count):
    return message("F", b"vehicle_attitude:" + b"".join(b"%s a%d;" % (field, n) for n in range(count)))


EMPTY_FIELDS = topic(b"float[0]", 300) + message("A", b"\0\0\0vehicle_attitude")
FALSE_PACKET = b"\xfe\xff\0\0\0\x1e\0"


def refused(read):
    def run(given):
        with contextlib.suppress(ValueError):
            read(given)

    return run


HOSTILE = {
    "subtitles of spaces": (read_srt, lambda n: (BLOCK * n), 40),
    "subtitles of one entry": (read_srt, lambda n: "00:00:00,000 --> gb_yaw" + " " * n, 500_000),
    "subtitles of arrows": (read_srt, lambda n: "-->" * n, 20_000),
    "PX4: empty fields": (read_ulog, lambda n: ULOG + EMPTY_FIELDS + message("D", b"\0\0x") * n, 20_000),
    "PX4: zeros": (read_ulog, lambda n: ULOG + bytes(n), 100_000),
    "tlog: zeros": (read_tlog, bytes, 20_000_000),
    "tlog: packets that are none": (read_tlog, lambda n: FALSE_PACKET * n, 5_000),
    "ArduPilot: starts": (read_dataflash, lambda n: b"\xa3\x95" * n, 50_000),
    "ArduPilot: zeros": (read_dataflash, lambda n: b"\xa3\x95" + bytes(n), 10_000_000),
    "geo.txt": (read_geo, lambda n: "EPSG:4326\n" + "a 1 2 3 4\nb 1 2 3 4\n" * n, 5_000),
    "JSON: a text without an end": (refused(read_json), lambda n: '"' + '\\"' * n, 30_000),
    "tags: texts without an end": (tags_of, lambda n: {"other_tags": '\\"' * n}, 30_000),
    "XMP: elements without an end": (lambda x: PhotoTags(xmp=x).text("a:Model"), lambda n: "a:Model>" * n, 20_000),
    "a message of onnxruntime": (reason_of, lambda n: "/onnxruntime/" * n, 100),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", HOSTILE)
def test_reading_takes_linear_time(name):
    read, made, count = HOSTILE[name]
    assert growth(read, made, count) < LINEAR


def test_a_subtitle_of_spaces_takes_no_longer_than_one_of_text():
    plain = "00:00:00,000 --> " + "word " * 790
    slow, usual = (min(seconds(read_srt, block * 30) for _ in range(3)) for block in (BLOCK, plain))
    assert slow < 5 * usual


def test_topics_larger_than_a_message_and_unused_fields_are_not_kept():
    topics = {}
    ulog._describe(topic(b"double[9999]", 300)[3:], topics)
    ulog._describe(topic(b"float[0]", 3)[3:], topics)
    assert topics == {}
    ulog._describe(topic(b"float", 300)[3:], topics)
    assert topics["vehicle_attitude"][1] == {}


def test_subtitles_keep_a_bounded_number_of_entries(monkeypatch):
    monkeypatch.setattr(limits, "LOG_ENTRIES", 100)
    text = "".join(f"00:{n // 60:02d}:{n % 60:02d},000 --> \n[gb_yaw: {n % 360}]\n" for n in range(3000))
    log = read_srt(text)
    assert 50 <= len(log.times_s) <= 101
    assert (log.times_s[0], log.values[0, 0]) == (0.0, 0.0) and log.times_s[-1] > 2900


@pytest.mark.parametrize(
    ("name", "read"), [("ardupilot.bin", read_dataflash), ("mavlink.tlog", read_tlog), ("px4.ulg", read_ulog)]
)
def test_noise_is_no_error(repository, name, read):
    rng, whole = np.random.default_rng(1), (repository / "tools" / "fuzz" / "samples" / "logs" / name).read_bytes()
    for _ in range(300):
        data = bytearray(whole)
        for place in rng.integers(16, len(data), rng.integers(1, 6)):
            data[place] = rng.integers(0, 256)
        read(bytes(data))


TLOG_START = struct.pack(">Q", 10**15) + b"\xfe\x00\0\0\0\0\0\0"
LOGS = {
    "a.bin": b"\xa3\x95" * 500_000,
    "a.ulg": ULOG + bytes(1_000_000),
    "a.tlog": TLOG_START * 2 + FALSE_PACKET * 100_000,
    "a.srt": (BLOCK * 200).encode(),
    "geo.txt": b"EPSG:4326\n" + b"a 1 2 3 4\nb 1 2 3 4\n" * 100_000,
}


@pytest.mark.slow
@pytest.mark.parametrize("name", LOGS)
def test_reading_looks_for_a_cancel_all_the_time_and_ends_at_it(tmp_path, name):
    path = tmp_path / name
    path.write_bytes(LOGS[name])
    looks = []
    for limit in (None, 3):
        looks.clear()

        def canceled(most=limit):
            looks.append(time.process_time())
            return most is not None and len(looks) >= most

        with contextlib.suppress(ParameterError):
            read_log(str(path), canceled)
        if limit is None:
            assert len(looks) >= 4
            assert max(b - a for a, b in zip(looks, looks[1:])) < 0.5
    assert len(looks) == 3
