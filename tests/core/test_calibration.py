"""docs/calibration.md tells every setting, with the value that it has."""

from __future__ import annotations

import ast
import inspect
import re
from dataclasses import fields, is_dataclass
from pathlib import Path

import pytest

from semref.core.constellation.settings import CONSTELLATION
from semref.core.correlation.settings import CORRELATION
from semref.core.flight.settings import FLIGHT
from semref.core.geometry.error_settings import ERRORS
from semref.core.localizer.settings import LOCALIZER

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "calibration.md").read_text(encoding="utf-8")

each_settings = pytest.mark.parametrize(
    ("heading", "settings"),
    [
        ("Constellation", CONSTELLATION),
        ("Map correlation", CORRELATION),
        ("Localizer", LOCALIZER),
        ("Flights", FLIGHT),
        ("Shared errors", ERRORS),
    ],
)


def rows(heading: str) -> list[list[str]]:
    """Cells of a section's table, without its head."""
    section = re.search(rf"^## {heading}$(.*?)(?=^## |\Z)", PAGE, flags=re.DOTALL | re.MULTILINE).group(1)
    lines = [line for line in section.splitlines() if line.startswith("|")]
    return [[cell.strip().strip("`") for cell in line.strip("|").split("|")] for line in lines[2:]]


@each_settings
def test_every_setting_stands_on_the_page_once_and_in_order(heading, settings):
    assert [row[0] for row in rows(heading)] == [field.name for field in fields(settings)]


@each_settings
def test_the_page_has_the_values_that_are_used(heading, settings):
    values = {row[0]: row[1] for row in rows(heading)}
    plain = [field.name for field in fields(settings) if not is_dataclass(getattr(settings, field.name))]
    assert {name: ast.literal_eval(values[name]) for name in plain} == {n: getattr(settings, n) for n in plain}


@each_settings
def test_every_setting_has_a_meaning_data_and_a_command(heading, settings):
    assert [row[0] for row in rows(heading) if len(row) != 5 or not all(row)] == []


@each_settings
def test_every_command_is_told(heading, settings):
    told = {row[0] for row in rows("Commands")} | {"–", "see there"}
    assert {row[4] for row in rows(heading)} - told == set()


@each_settings
def test_the_class_documents_every_field(heading, settings):
    documented = re.findall(r"^    (\w+): ", inspect.getdoc(type(settings)), flags=re.MULTILINE)
    assert documented == [field.name for field in fields(settings)]
