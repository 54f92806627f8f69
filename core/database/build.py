"""Building a reference database from a label map: one pass for objects and overview, one for the windows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from ..errors import LabelMapError, WindowError
from ..geometry.error_settings import MAP_ACCURACY
from ..geometry.frame import MapFrame
from ..labels.block_hashes import BlockHasher, map_hash
from ..labels.class_table import ClassTable
from ..labels.overview import OVERVIEW_FACTOR, HeldOverview, OverviewSink, most_frequent_labels
from ..labels.sources import LabelSource
from ..landmarks.catalogue import CatalogueBuilder
from ..landmarks.landmarks import Landmarks
from ..landmarks.landmarks import minimum_area_px as area_px
from ..windows.describe import DescribedWindows, describe_windows
from ..windows.distinctiveness import distinctiveness
from ..windows.grid import WindowGrid, whole_pixels
from ..windows.topology_vector import MINIMUM_REFERENCES, REFERENCES_PER_VECTOR
from .model import MapLandmarks, ReferenceDatabase, Windows
from .parameters import BuildParameters

_LONGEST = 1e9
"""Map units; no map is larger."""


@dataclass(frozen=True)
class BuildSettings:
    """What a user chooses.

    Attributes:
        window_size: Edge of a window of level 1, map units.
        stride: From window to window, map units.
        minimum_area: Of a landmark, m².
        levels: Multipliers of the window size.
        references_per_vector: Landmarks that a vector holds at most.
        overview_factor: Pixels of the label map along the edge of one of the overview.
        threads: Rows of windows that are described at once.
        map_accuracy: Standard deviation along each axis of where landmarks are on the map, map units.

    Raises:
        WindowError: A value can't be used.
    """

    window_size: float
    stride: float
    minimum_area: float
    levels: tuple[float, ...] = (1.0,)
    references_per_vector: int = REFERENCES_PER_VECTOR
    overview_factor: int = OVERVIEW_FACTOR
    threads: int = 1
    map_accuracy: float = MAP_ACCURACY

    def __post_init__(self) -> None:
        """Refuses values that can't be used."""
        if not all(0 <= length < _LONGEST for length in (self.window_size, self.stride)):
            raise WindowError(
                "The windows have an edge of {window_size:g} and a stride of {stride:g}; give both in map units, "
                "above 0.",
                window_size=self.window_size,
                stride=self.stride,
            )
        if not self.minimum_area > 0:
            raise WindowError(
                "The minimum area is {minimum_area:g} m²; it must be more than 0.", minimum_area=self.minimum_area
            )
        if self.references_per_vector < MINIMUM_REFERENCES:
            raise WindowError(
                "A vector of {count} references is too short; use at least {least}.",
                count=self.references_per_vector,
                least=MINIMUM_REFERENCES,
            )
        if not self.levels or not all(0 < level < _LONGEST for level in self.levels):
            raise WindowError("The levels must be positive multipliers of the window size, for example 1;2.")
        # One that is given twice counts once.
        object.__setattr__(self, "levels", tuple(dict.fromkeys(self.levels)))


class DatabaseBuilder:
    """Builds a database step by step: iterate ``steps()`` to the end, then take ``database`` and ``overview``.

    ``compare_windows()`` then adds the windows' distinctiveness to it.
    """

    def __init__(  # noqa: PLR0913 - a map, what is wanted of it, and where the overview goes
        self,
        source: LabelSource,
        frame: MapFrame,
        table: ClassTable,
        settings: BuildSettings,
        plugin_version: str,
        overview: OverviewSink | None = None,
    ) -> None:
        """Makes the builder; nothing is read yet.

        Args:
            source: The label map.
            frame: Where its pixels lie.
            table: With the reference classes.
            settings: What the user chooses.
            plugin_version: What the database says.
            overview: Takes the overview band by band; without one it is held in memory, as ``overview``.

        Raises:
            WindowError: The windows don't fit the map.
            ClassTableError: No class is a reference class.
        """
        self._source = source
        self._frame = frame
        self._table = table.require_references()
        self._settings = settings
        self._plugin_version = plugin_version
        self.grids = level_grids(source.shape_hw, frame.pixel_size, settings)
        self.overview: np.ndarray | None = None
        self._overview = overview
        self.database: ReferenceDatabase | None = None

    def read_from(self, source: LabelSource) -> None:
        """Takes the same map's labels from another source from now on: from memory, say."""
        self._source = source

    def steps(self) -> Iterator[tuple[str, float]]:
        """Yields (what is being done, share done 0…1).

        Raises:
            LabelMapError: The map has no landmark.
        """
        objects: Landmarks | None = None
        hashes: tuple[str, ...] = ()
        for share, result in self._scan():
            yield "Finding landmarks", 0.3 * share
            if result is not None:
                objects, hashes = result
        objects = require_landmarks(objects, self._table, self._settings)
        described: list[tuple[int, WindowGrid, DescribedWindows]] = []
        total = sum(len(grid) for grid in self.grids)
        done = 0
        for level, grid in enumerate(self.grids, start=1):
            for some in self._describe(grid, objects):
                described.append((level, grid, some))
                done += len(some.counts)
                yield "Describing windows", 0.3 + 0.5 * done / total
        frame = self._frame.of_shape(self._source.shape_hw)
        windows, references = windows_of(described, frame), map_references(objects, frame)
        parameters = parameters_of(frame, self._table, self._settings, self._plugin_version, hashes)
        self.database = ReferenceDatabase(windows, references, self._table, parameters, None)

    def compare_windows(self) -> Iterator[tuple[str, float]]:
        """Yields (what is being done, share done); afterwards the windows have their distinctiveness.

        NaN for windows without a vector or without another one to compare with. Comes after ``steps()``.
        """
        database = self.database
        if database is None:
            return
        windows = database.windows
        index = np.flatnonzero(windows.described)
        found = np.full(len(windows), np.nan)
        blocks = distinctiveness(windows.vectors[index], windows.centers[index], windows.sizes[index])
        for block, distances in blocks:
            found[index[block]] = np.where(np.isinf(distances), np.nan, distances)
            yield "Comparing windows", block.stop / len(index)
        self.database = replace(database, windows=replace(windows, distinctiveness=found))

    def _scan(self) -> Iterator[tuple[float, tuple[Landmarks, tuple[str, ...]] | None]]:
        """One pass over the map: landmarks, overview and block hashes."""
        factor = self._settings.overview_factor
        catalogue = CatalogueBuilder(
            self._source, self._table.reference_values, self._minimum_area_px, band_multiple=factor
        )
        height, width = self._source.shape_hw
        blocks = BlockHasher(width)
        put = self._overview
        if put is None:
            held = HeldOverview((-(-height // factor), -(-width // factor)))
            self.overview, put = held.labels, held.put

        def reduce(first: int, labels: np.ndarray) -> None:
            blocks.add(labels)
            put(0, first // factor, most_frequent_labels(labels, factor))

        # One thread hashes and reduces a band while this one looks for objects in the next.
        with ThreadPoolExecutor(1) as pool:
            reducing: Future[None] | None = None
            for n, (first, labels) in enumerate(catalogue.bands(), start=1):
                if reducing is not None:
                    reducing.result()
                reducing = pool.submit(reduce, first, labels)
                yield 0.9 * n / catalogue.band_count, None
            if reducing is not None:
                reducing.result()
        for _ in catalogue.crossing():
            yield 0.9, None
        yield 1.0, (catalogue.objects, blocks.hashes)

    @property
    def _minimum_area_px(self) -> float:
        return area_px(self._settings.minimum_area, self._frame.pixel_size)

    def _describe(self, grid: WindowGrid, objects: Landmarks) -> Iterator[DescribedWindows]:
        return describe_windows(
            self._source,
            grid,
            objects,
            self._table.reference_values,
            self._minimum_area_px,
            self._settings.references_per_vector,
            self._settings.threads,
        )


def require_landmarks(objects: Landmarks | None, table: ClassTable, settings: BuildSettings) -> Landmarks:
    """The map's landmarks; raises LabelMapError where it has none."""
    if objects is None or not len(objects):
        raise LabelMapError(
            "The map shows no landmark of {references} with at least {minimum_area:g} m²; choose other reference "
            "classes or a smaller minimum area.",
            references=[c.name for c in table.references],
            minimum_area=settings.minimum_area,
        )
    return objects


def windows_of(described: Sequence[tuple[int, WindowGrid, DescribedWindows]], frame: MapFrame) -> Windows:
    """Described windows, with their level and its grid, as those of a database in this order."""
    first_pixels = np.concatenate([np.column_stack([w.columns, w.rows]) for _, _, w in described])
    counts = np.concatenate([w.counts for _, _, w in described])
    repeats = [len(w.counts) for _, _, w in described]
    sizes_px = np.repeat([grid.size for _, grid, _ in described], repeats)
    return Windows(
        first_pixels=first_pixels,
        levels=np.repeat([level for level, _, _ in described], repeats),
        sizes=sizes_px * frame.pixel_size,
        centers=frame.to_map(first_pixels + sizes_px[:, None] / 2),
        counts=counts,
        vectors=np.concatenate([w.vectors for _, _, w in described]),
        described=counts >= MINIMUM_REFERENCES,
    )


def parameters_of(
    frame: MapFrame, table: ClassTable, settings: BuildSettings, plugin_version: str, block_hashes: tuple[str, ...]
) -> BuildParameters:
    """What a database says of how it was built; ``frame`` has the map's shape."""
    (height, width), pixel = frame.shape_hw, frame.pixel_size
    return BuildParameters(
        crs=frame.crs,
        geotransform=frame.geotransform,
        map_width_px=width,
        map_height_px=height,
        pixel_size=pixel,
        window_size=whole_pixels(settings.window_size, pixel) * pixel,
        stride=whole_pixels(settings.stride, pixel) * pixel,
        levels=settings.levels,
        references_per_vector=settings.references_per_vector,
        minimum_area=settings.minimum_area,
        overview_factor=settings.overview_factor,
        map_hash=map_hash((height, width), frame.geotransform, block_hashes),
        class_table_hash=table.digest(),
        plugin_version=plugin_version,
        block_hashes=block_hashes,
        map_accuracy=settings.map_accuracy,
    )


def map_references(objects: Landmarks, frame: MapFrame) -> MapLandmarks:
    """The objects of a map (pixels) as references (map units)."""
    areas = objects.areas_px * frame.pixel_size**2
    return MapLandmarks(frame.to_map(objects.centers_xy), objects.classes, areas, objects.touches_edge, objects.bounds)


def level_grids(shape_hw: tuple[int, int], pixel_size: float, settings: BuildSettings) -> list[WindowGrid]:
    """One grid a level; window and stride grow together.

    Raises:
        WindowError: A level doesn't fit the map.
    """
    height, width = shape_hw
    return [
        WindowGrid(
            width,
            height,
            whole_pixels(settings.window_size * level, pixel_size),
            whole_pixels(settings.stride * level, pixel_size),
        )
        for level in settings.levels
    ]
