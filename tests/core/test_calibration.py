"""docs/calibration.md has every setting, with meaning, data and the value that is used."""

from __future__ import annotations

import importlib.util
from dataclasses import fields, is_dataclass
from pathlib import Path

from semref.core.constellation.settings import CONSTELLATION
from semref.core.flight.settings import FLIGHT
from semref.core.localizer.settings import LOCALIZER

ROOT = Path(__file__).resolve().parents[2]
SPEC = importlib.util.spec_from_file_location("list_settings", ROOT / "tools" / "docs" / "list_settings.py")
TOOL = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(TOOL)


def test_the_tables_of_the_page_are_up_to_date():
    page = TOOL.PAGE.read_text(encoding="utf-8")
    assert page == TOOL.with_tables(page), "run tools/docs/list_settings.py"


def test_every_class_of_settings_is_on_the_page_and_has_few_fields():
    found = [FLIGHT, LOCALIZER]
    for one in found:
        found += [value for value in vars(one).values() if is_dataclass(value) and value not in found]
    page = TOOL.PAGE.read_text(encoding="utf-8")
    assert all(f"\n`{type(one).__name__}`, `core/" in page for one in found)
    assert CONSTELLATION in found and max(len(fields(one)) for one in found) <= 25
