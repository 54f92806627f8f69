"""Logs are recognized by their content."""

import pytest

from semref.core.errors import ParameterError
from semref.core.flight.logs.files import read_log


def write(tmp_path, name, data):
    path = tmp_path / name
    path.write_bytes(data)
    return str(path)


def test_the_name_does_not_matter(tmp_path):
    text = b"1\r\n00:00:00,000 --> 00:00:01,000\r\n[rel_alt: 5.0 abs_alt: 6.0]\r\n"
    assert read_log(write(tmp_path, "a.log", text)).values[0, 3] == 5
    assert read_log(write(tmp_path, "b.log", b"EPSG:4326\na.jpg 1 2 3 44\n")).images == ("a",)


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (b"", "{path} is not a supported flight log. Supported are {kinds}."),
        (b"image,roll\n", "{path} is not a supported flight log. Supported are {kinds}."),
        (b"EPSG:4326\na.jpg 1 2\n", "{path} contains no heading, height or speed of a flight."),
        (b"\xa3\x95\x80", "{path} contains no heading, height or speed of a flight."),
        (b"ULog\x01\x12\x35\x01", "{path} contains no heading, height or speed of a flight."),
    ],
)
def test_a_file_without_telemetry_is_refused(tmp_path, data, code):
    with pytest.raises(ParameterError) as caught:
        read_log(write(tmp_path, "x", data))
    assert caught.value.sentence.template == code
