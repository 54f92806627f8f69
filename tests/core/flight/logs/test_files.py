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
    ("data", "said"),
    [
        *((data, "is not a supported flight log") for data in (b"", b"image,roll\n")),
        *(
            (data, "contains no heading")
            for data in (b"EPSG:4326\na.jpg 1 2\n", b"\xa3\x95\x80", b"ULog\x01\x12\x35\x01")
        ),
    ],
)
def test_a_file_without_telemetry_is_refused(tmp_path, data, said):
    with pytest.raises(ParameterError, match=said):
        read_log(write(tmp_path, "x", data))
