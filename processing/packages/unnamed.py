"""Texts without what is private in them: log lines that a user pastes where everybody reads them."""

from __future__ import annotations

import re
from collections.abc import Iterable

LONGEST_LINE = 1000
"""Characters of a line that are kept; the time that the patterns take grows with its square."""

_SEPARATOR = r"[/\\]"
_NAME = r"[^/\\\n\"“”„«»<>|]*"
_PYTHONS = r"((?:site|dist)-packages|python3?\.?\d*)"
_OF_PYTHON = re.compile(rf"(?:[A-Za-z]:)?(?:{_SEPARATOR}{_NAME})+?{_SEPARATOR}{_PYTHONS}{_SEPARATOR}")
_ADDRESS = re.compile(r"\b[a-z][a-z0-9+.-]+://\S+|\b[\w.+-]+@[\w-]+\.[\w.-]+", re.IGNORECASE)
_SUFFIX = r"\.[A-Za-z][A-Za-z0-9]{1,7}\b"
# The last name of a path up to its suffix, else its first word: names may have blanks, and sentences go on.
_PATH = re.compile(
    rf"(?:(?<![\w.…~])[A-Za-z]:{_SEPARATOR}|(?<![\w.…/\\])~?{_SEPARATOR}{{1,2}}(?=[\w.~]))(?:{_NAME}{_SEPARATOR})*"
    rf"(?:[^/\\\n\"“”„«»<>|]{{0,120}}?(?P<suffix>{_SUFFIX})|[^\s/\\\"“”]*)"
)
_DATA = (
    "tiff?|jpe?g|png|webp|vrt|gpkg|shp|dbf|npz|onnx|csv|qgz|qgs|json|geojson|plan|km[lz]|gpx|waypoints|mp4|mov|srt"
    "|log|bin|ulg|html|pdf"
)
_FILE = re.compile(rf"(?<![<\w])[\w(][\w()+-]*\.(?P<suffix>{_DATA})\b", re.IGNORECASE)
_LONG_NUMBER = re.compile(r"(?<![\w.])-?\d{5,}(?:\.\d+)?|(?<![\w.])-?\d+\.\d{4,}")


def unnamed(text: str, plugin_folder: str = "", private: Iterable[str] = ()) -> str:
    """The text without paths, names of files, addresses, coordinates, and names that are told to be private.

    Args:
        text: Lines of a log.
        plugin_folder: What lies in it is kept, from the plugin's name on; so is what lies in Python's packages.
        private: Names to leave out wherever they stand as a word: of user, machine, project, layers.

    Returns:
        The text; rather too much of it is left out than too little.
    """
    text = "\n".join(line[:LONGEST_LINE] for line in text.split("\n"))
    if plugin_folder:
        for folder in {plugin_folder, plugin_folder.replace("\\", "/")}:
            text = text.replace(folder, "…semref")
    text = _OF_PYTHON.sub(lambda found: f"…{found[1]}/", text)
    text = _ADDRESS.sub("<address>", text)
    text = _PATH.sub(lambda found: f"<path{found['suffix'] or ''}>", text)
    for name in sorted({name for name in private if len(name) > 2}, key=len, reverse=True):
        text = re.sub(rf"(?<!\w){re.escape(name)}(?!\w)", "<name>", text)
    text = _FILE.sub(lambda found: f"<file.{found['suffix']}>", text)
    return _LONG_NUMBER.sub("#", text)
