"""A reference database in memory: what a build makes, what localization needs.

Told in docs/file-formats.md#reference-database.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Tuple

import numpy as np

from ..errors import DatabaseError
from ..geometry.frame import MapFrame
from ..labels.class_table import ClassTable

FORMAT_VERSION = 1


@dataclass(frozen=True)
class Windows:
    """The windows of a database, N of them.

    names: (N,) str ``column_row``; levels: (N,) int; sizes: (N,) float64 map units;
    centers: (N, 2) float64 map coordinates (x, y); counts: (N,) landmarks;
    vectors: (N, 3·X) float32; described: (N,) bool, False where there are too few references for a vector.
    """

    names: np.ndarray
    levels: np.ndarray
    sizes: np.ndarray
    centers: np.ndarray
    counts: np.ndarray
    vectors: np.ndarray
    described: np.ndarray

    def __len__(self) -> int:
        return len(self.names)


@dataclass(frozen=True)
class MapLandmarks:
    """The landmarks of the whole map, N of them.

    positions: (N, 2) float64 map coordinates (x, y); classes: (N,) uint8; areas_m2: (N,) float64;
    touches_edge: (N,) bool; bounds_px: (N, 4) int64 first column, first row, last column + 1, last row + 1 on the label
    map; None where they were not read.
    """

    positions: np.ndarray
    classes: np.ndarray
    areas_m2: np.ndarray
    touches_edge: np.ndarray
    bounds_px: Optional[np.ndarray] = None

    def __len__(self) -> int:
        return len(self.classes)


@dataclass(frozen=True)
class BuildParameters:
    """What a database was built with; kept in it under these names.

    crs: WKT of the metric CRS; geotransform: GDAL's six numbers of the label map; pixel_size, window_size and
    stride in map units; minimum_area in m²; levels: multipliers of the window size. block_hashes: one a block of the
    label map (``map_hash``), row by row; none in databases of versions that did not keep them.
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

    def __post_init__(self) -> None:
        if self.format_version > FORMAT_VERSION:
            raise DatabaseError(
                f"The database has format version {self.format_version}, newer than this SemRef reads "
                f"({FORMAT_VERSION}); update the plugin."
            )

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


@dataclass(frozen=True)
class ReferenceDatabase:
    """Windows, landmarks, class table and build parameters of one area.

    overview: (h, w) uint8, the label map reduced, which map correlation searches; None where it was not read.
    """

    windows: Windows
    references: MapLandmarks
    class_table: ClassTable
    parameters: BuildParameters
    source: Optional[str] = None
    overview: Optional[np.ndarray] = None
