"""An unusable class table is refused with the place of the mistake."""

from __future__ import annotations

import pytest
from bad_input import DECODE, DESCRIBE, RASTERIZE


@pytest.mark.parametrize("content", [b"\x00\x01\x02\xff" * 50, b"PK\x03\x04" + bytes(300)])
def test_a_class_table_that_is_no_text_is_refused(refused, tmp_path, content):
    (tmp_path / "binary.csv").write_bytes(content)
    assert "binary.csv" in refused(RASTERIZE, CLASS_TABLE=str(tmp_path / "binary.csv"))


@pytest.mark.parametrize("algorithm", [RASTERIZE, DECODE, DESCRIBE])
def test_a_missing_class_table_is_named(refused, algorithm):
    assert "/nowhere/classes.csv" in refused(algorithm, CLASS_TABLE="/nowhere/classes.csv")
