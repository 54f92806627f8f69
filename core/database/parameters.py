"""What a database was built with, and the one reader of how it is kept: JSON values under their names."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any, Mapping, Tuple

from ..errors import DatabaseError
from ..geometry.frame import MapFrame

FORMAT_VERSION = 1

_JSON_TYPES = {"str": str, "int": int, "float": (int, float), "tuple": (list, tuple)}
"""What JSON makes of the types of BuildParameters."""

_LENGTHS = ("pixel_size", "window_size", "stride", "minimum_area")
_COUNTS = ("map_width_px", "map_height_px", "overview_factor", "references_per_vector")
_MOST = 1 << 31


@dataclass(frozen=True)
class BuildParameters:
    """What a database was built with; kept in it under these names.

    Attributes:
        crs: WKT of the metric CRS
        geotransform: GDAL's six numbers of the label map
        map_width_px, map_height_px: size of the label map
        pixel_size, window_size, stride: map units
        levels: multipliers of the window size
        references_per_vector: landmarks that a vector holds at most
        minimum_area: m²
        overview_factor: pixels of the label map along the edge of one of the overview
        map_hash, class_table_hash: what map and class table are known by
        plugin_version: of the plugin that built or updated it last
        format_version: of the file
        block_hashes: one a block of the label map (``map_hash``), row by row; none in databases of versions that did
            not keep them, and on board
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

    @property
    def extent(self) -> Tuple[float, float, float, float]:
        """(x_min, y_min, x_max, y_max) of the label map."""
        return self.frame.extent

    @property
    def frame(self) -> MapFrame:
        """Where the pixels of the label map lie."""
        return MapFrame(self.crs, self.geotransform, (self.map_height_px, self.map_width_px))

    @property
    def overview_frame(self) -> MapFrame:
        """Where the pixels of the overview lie."""
        return self.frame.reduced(self.overview_factor)


def build_parameters(stored: Mapping[str, Any], source: str) -> BuildParameters:
    """The parameters of a GeoPackage or onboard file.

    Args:
        stored: JSON values by name; others than those of BuildParameters are ignored.
        source: The file, for the message.

    Raises:
        DatabaseError: The file is of a newer version.
        KeyError: A parameter is missing.
        ValueError: One has a value that it can't have.
    """
    # A newer version may have parameters that this one does not know, so its number is looked at first.
    version = checked(stored["format_version"], int, "format_version")
    if version > FORMAT_VERSION:
        raise DatabaseError("database.newer_format", source=source, version=version, known=FORMAT_VERSION)
    values = {"block_hashes": (), **stored}
    known = {}
    for item in fields(BuildParameters):
        known[item.name] = checked(values[item.name], _JSON_TYPES[item.type], item.name)
    known["geotransform"] = tuple(number(value, "geotransform") for value in known["geotransform"])
    known["levels"] = tuple(number(value, "levels") for value in known["levels"])
    known["block_hashes"] = tuple(checked(value, str, "block_hashes") for value in known["block_hashes"])
    if len(known["geotransform"]) != 6 or not known["levels"]:
        raise ValueError(f"geotransform is {known['geotransform']!r}, levels are {known['levels']!r}")
    for name in _LENGTHS:
        number(known[name], name, above=0)
    for name in _COUNTS:
        if not 0 < known[name] < _MOST:
            raise ValueError(f"{name} is {known[name]}")
    return BuildParameters(**known)


def checked(value: Any, kind, name: str) -> Any:
    """``value`` if it is of one of the types ``kind``; raises ValueError otherwise. True and false are no numbers."""
    if isinstance(value, bool) or not isinstance(value, kind):
        raise ValueError(f"{name} is {value!r}")
    return value


def number(value: Any, name: str, above: float = -math.inf) -> float:
    """``value`` as a finite number above ``above``; raises ValueError for anything else."""
    if not above < checked(value, (int, float), name) < math.inf:
        raise ValueError(f"{name} is {value!r}")
    return float(value)
