"""Sheets to look at hold every picture whole, side by side, and none over another."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from PIL import Image

DOCS = Path(__file__).resolve().parents[2] / "tools" / "docs"


@pytest.fixture
def sheets(monkeypatch):
    monkeypatch.syspath_prepend(str(DOCS))
    import make_look_sheets

    yield make_look_sheets
    for name in ("make_look_sheets", "make_screenshots"):
        sys.modules.pop(name, None)


def test_every_picture_is_on_a_sheet_and_none_over_another(sheets, tmp_path):
    sizes = [(400, 900), (400, 900), (760, 2400), (300, 60), (2600, 500), (400, 1400), (400, 1400), (900, 900)]
    paths = []
    for number, size in enumerate(sizes):
        paths.append(tmp_path / f"{number}.png")
        Image.new("RGB", size, (255, 20 * number, 1)).save(paths[-1])
    made = sheets.sheets(paths)
    found = {color: count for sheet in made for count, color in sheet.getcolors(1_000_000)}
    for number, size in enumerate(sizes):
        shrunk = Image.new("RGB", size)
        shrunk.thumbnail((sheets.CELL_PX, sheets.SHEET_PX[1] - sheets.TITLE_PX))
        assert found[255, 20 * number, 1] == shrunk.width * shrunk.height


def test_each_look_has_a_session_of_its_own(sheets):
    dressed = [tuple(sorted((k, v) for k, v in vars(look).items() if k != "scenes")) for look in sheets.LOOKS.values()]
    assert len(set(dressed)) == len(dressed) == 10
