"""Parameters that a database was built with, and their only reader: JSON values by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

from .. import limits
from ..errors import DatabaseError
from ..geometry.error_settings import MAP_ACCURACY
from ..geometry.frame import MapFrame
from ..values import checked, number, short_text, shown

FORMAT_VERSION = 1

_JSON_TYPES: dict[str, type | tuple[type, ...]] = {
    "str": str,
    "int": int,
    "float": (int, float),
    "tuple": (list, tuple),
}
"""JSON types of the types of BuildParameters."""

_LENGTHS = ("pixel_size", "window_size", "stride", "minimum_area")
_COUNTS = ("map_width_px", "map_height_px", "overview_factor", "references_per_vector")
_FARTHEST = 1e9
"""Map units from the origin; the false eastings of zoned CRS reach 6e7."""


@dataclass(frozen=True)
class BuildParameters:
    """Parameters that a database was built with, stored in it under these names.

    Attributes:
        crs: WKT of the metric CRS.
        geotransform: GDAL's six numbers of the label map.
        pixel_size: Of the label map, map units.
        window_size: Edge of a window of level 1, map units.
        stride: Distance between windows, map units.
        levels: Multipliers of the window size.
        references_per_vector: Largest number of landmarks in a vector.
        minimum_area: Of a landmark, m².
        overview_factor: Edge of an overview pixel, pixels of the label map.
        plugin_version: Version of the plugin that built or updated it last.
        block_hashes: One for each block of the label map (``map_hash``), row by row; empty on board and in databases
            of versions that did not store them.
        map_accuracy: Standard deviation along each axis of the positions of landmarks on the map, map units; the
            default in databases of versions that did not store it.
    """

    crs: str
    geotransform: tuple
    map_width_px: int
    map_height_px: int
    pixel_size: float
    window_size: float
    stride: float
    levels: tuple
    references_per_vector: int
    minimum_area: float
    overview_factor: int
    map_hash: str
    class_table_hash: str
    plugin_version: str
    format_version: int = FORMAT_VERSION
    block_hashes: tuple = ()
    map_accuracy: float = MAP_ACCURACY

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """(x_min, y_min, x_max, y_max) of the label map."""
        return self.frame.extent

    @property
    def frame(self) -> MapFrame:
        """Grid and shape of the label map."""
        return MapFrame(self.crs, self.geotransform, (self.map_height_px, self.map_width_px))

    @property
    def overview_frame(self) -> MapFrame:
        """Grid and shape of the overview."""
        return self.frame.reduced(self.overview_factor)


def build_parameters(stored: Mapping[str, Any], source: str) -> BuildParameters:
    """Return the parameters of a GeoPackage or onboard file.

    Args:
        stored: JSON values by name; unknown names are ignored.
        source: The file, for the message.

    Raises:
        DatabaseError: The file has a newer format version.
        KeyError: A parameter is missing.
        ValueError: A parameter has an invalid value.
    """
    # A newer version may have unknown parameters, so its number is checked first.
    version = checked(stored["format_version"], int, "format_version")
    if version > FORMAT_VERSION:
        raise DatabaseError(
            "{source} has format version {version}, but this SemRef reads up to version {known}; update the plugin.",
            source=source,
            version=version,
            known=FORMAT_VERSION,
        )
    values = {"block_hashes": (), "map_accuracy": MAP_ACCURACY, **stored}
    known: dict[str, Any] = {}
    for item in fields(BuildParameters):
        known[item.name] = checked(values[item.name], _JSON_TYPES[str(item.type)], item.name)
        if item.type == "str":
            short_text(known[item.name], item.name, limits.TEXT_CHARACTERS)
    known["geotransform"] = tuple(number(value, "geotransform") for value in known["geotransform"])
    known["levels"] = tuple(number(value, "levels", above=0, most=limits.UNITS) for value in known["levels"])
    known["block_hashes"] = tuple(short_text(value, "block_hashes") for value in known["block_hashes"])
    if not 0 < len(known["levels"]) <= limits.LEVELS:
        raise ValueError(f"levels are {shown(known['levels'])}")
    for name in _LENGTHS:
        number(known[name], name, above=0, most=limits.UNITS)
    number(known["map_accuracy"], "map_accuracy", above=-1e-9, most=limits.UNITS)
    for name in _COUNTS:
        if not 0 < known[name] < limits.EDGE_PIXELS:
            raise ValueError(f"{name} is {shown(known[name])}")
    if known["references_per_vector"] > limits.VECTOR_LANDMARKS:
        raise ValueError(f"references_per_vector is {known['references_per_vector']}")
    _require_north_up(known["geotransform"])
    found = BuildParameters(**known)
    if not max(map(abs, found.extent)) < _FARTHEST:
        raise ValueError(f"geotransform is {shown(known['geotransform'])}, out of range")
    return found


def _require_north_up(geotransform: tuple[float, ...]) -> None:
    """Raise ValueError unless GDAL's numbers describe a north-up grid of square pixels."""
    if len(geotransform) == 6:
        _, pixel, column_turn, _, row_turn, down = geotransform
        if pixel > 0 and abs(down + pixel) <= 1e-6 * pixel and max(abs(column_turn), abs(row_turn)) <= 1e-6 * pixel:
            return
    raise ValueError(f"geotransform is {shown(geotransform)}")
