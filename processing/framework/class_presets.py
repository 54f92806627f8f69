"""Class tables of nomenclatures that ship: resources/class_tables."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ...core.labels.class_table import ClassTable

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "class_tables"


@dataclass(frozen=True)
class Preset:
    """A class table that ships: its name, which is a proper name in all languages, and its file."""

    title: str
    file: str

    @property
    def path(self) -> str:
        """Of the CSV."""
        return str(FOLDER / self.file)

    def table(self) -> ClassTable:
        """Its classes."""
        from ...storage.text_tables import read_class_table

        return read_class_table(self.path)


PRESETS = (
    Preset("OpenStreetMap", "openstreetmap.csv"),
    Preset("LCDB v5 (New Zealand)", "lcdb.csv"),
    Preset("CORINE Land Cover", "corine.csv"),
    Preset("Urban Atlas", "urban_atlas.csv"),
)
"""In the order of the parameter PRESET, of which 0 is none of them."""
