"""A class table that can’t be used is refused with the place in it."""

from __future__ import annotations

import pytest
from bad_input import (
    DECODE,
    DESCRIBE,
    RASTERIZE,
)
from made_inputs import (
    write_text,
)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "no classes"),
        ("value,name,color,role\n", "no classes"),
        ("number,label\n1,field\n", "value, name"),
        ("value,name,color,role\nx,field,#00ff00,background\n", "“x”"),
        ("value,name,color,role\n300,field,#00ff00,background\n", "300"),
        ("value,name,color,role\n-1,field,#00ff00,background\n", "-1"),
        ("value,name,color,role\n1,,#00ff00,background\n", "no name"),
        ("value,name,color,role\n1,field,green,background\n", "“green”"),
        ("value,name,color,role\n1,field,#00ff00,landmark\n", "“landmark”"),
        ("value,name,color,role\n1,field,#00ff00,\n1,water,#0000ff,\n", "1"),
        ("value,name,color,role\n1,field,#00ff00,\n2,field,#0000ff,\n", "field"),
        ("value,name,color,role,draw_order\n1,field,#00ff00,,top\n", "“top”"),
        ("value,name,color,role,hsv_min,hsv_max\n1,field,#00ff00,,1 2,3 4 5\n", "“1 2”"),
        ("value,name,color,role,hsv_min,hsv_max\n1,field,#00ff00,,1 2 3,\n", "hsv_min"),
        ("value,name,color,role,hsv_min,hsv_max\n1,field,#00ff00,,1 2 3,1 2 300\n", "“1 2 300”"),
    ],
)
@pytest.mark.parametrize("algorithm", [RASTERIZE, DECODE])
def test_a_broken_class_table_is_refused_with_the_place(refused, tmp_path, algorithm, text, said):
    sentence = refused(algorithm, CLASS_TABLE=str(write_text(tmp_path / "broken.csv", text)))
    assert said in sentence


@pytest.mark.parametrize("content", [b"\x00\x01\x02\xff" * 50, b"PK\x03\x04" + bytes(300)])
def test_a_class_table_that_is_no_text_is_refused(refused, tmp_path, content):
    (tmp_path / "binary.csv").write_bytes(content)
    assert "binary.csv" in refused(RASTERIZE, CLASS_TABLE=str(tmp_path / "binary.csv"))


@pytest.mark.parametrize("algorithm", [RASTERIZE, DECODE, DESCRIBE])
def test_a_missing_class_table_is_named(refused, algorithm):
    assert "/nowhere/classes.csv" in refused(algorithm, CLASS_TABLE="/nowhere/classes.csv")


def test_hsv_decoding_without_hsv_ranges_is_refused(refused):
    assert "hsv_min" in refused(DECODE, METHOD=0)
