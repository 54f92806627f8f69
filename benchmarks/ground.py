"""Cut images from a label map, add noise, and localize them in a database, also of another date."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from benchmarks.network_errors import NetworkNoise, spoil
from semref.core.assessment.cells import ground_cells
from semref.core.constellation.hypotheses import SMALLEST_OBJECT_PX
from semref.core.database.model import MapLandmarks, ReferenceDatabase
from semref.core.evaluation.trial import Query, Trial, judge
from semref.core.geometry.frame import MapFrame
from semref.core.geometry.leveling import Leveling
from semref.core.labels.class_shares import SeenLabels
from semref.core.landmarks.landmarks import Landmarks, extract_landmarks
from semref.core.localization import Method, Prior
from semref.core.localizer.localizer import Localizer
from semref.core.localizer.search import Search
from semref.core.pipeline import localize_with
from semref.core.simulation.views import View, cut, lies_on

LARGEST_TRIES = 20_000
"""Number of places to try before a view counts as impossible on the map."""

REACH_PX = 1_200
"""Largest distance that images reach beyond the half of the map with their centers."""


@dataclass(frozen=True)
class Wanted:
    """Kind of images to draw.

    Attributes:
        scales: Smallest and largest pixel size, in pixels of the map.
        headings_deg: Possible headings; empty for any.
        landmarks: Smallest and largest number of whole landmarks, before noise.
        tilt_deg: Tilt of the camera in a random direction.
        lens: Radial distortion with a random sign.
        labeled: Smallest labeled share of the image.
        sizes_px: Possible edges; empty for that of the ground.
        share: Footprint width as a share of a window's edge, ± 15 %, at random places; 0 to use ``scales``.
        is_inside: Whether the whole image shows the map.
        is_mirrored: Whether left and right are exchanged.
    """

    scales: tuple[float, float] = (0.8, 1.25)
    headings_deg: tuple[float, ...] = ()
    landmarks: tuple[int, int] = (20, 10**9)
    tilt_deg: float = 0.0
    lens: float = 0.0
    labeled: float = 0.0
    sizes_px: tuple[int, ...] = ()
    share: float = 0.0
    is_inside: bool = False
    is_mirrored: bool = False


@dataclass(frozen=True)
class Image:
    """A simulated image: true view, labels, and number of whole landmarks before noise."""

    query: Query
    seen: SeenLabels
    landmarks: int = 0

    @property
    def labels_hw(self) -> np.ndarray:
        return self.seen.labels_hw

    @property
    def view(self) -> View:
        return self.query.view


class Ground:
    """A label map as the source of images, and the database to localize them.

    Attributes:
        extent: (x_min, y_min, x_max, y_max) of the image centers, map units.
    """

    def __init__(
        self, labels_hw: np.ndarray, database: ReferenceDatabase, half: str = "", size_px: int | None = None
    ) -> None:
        parameters = database.parameters
        self.labels_hw, self.database = labels_hw, database
        self.references = database.references
        self.localizer = Localizer(database)
        self.frame = parameters.frame.of_shape(labels_hw.shape)
        self.size_px = size_px or round(parameters.window_size / parameters.pixel_size)
        left, bottom, right, top = self.frame.extent
        self.middle = float(np.median(database.references.positions[:, 1]))
        halves = {"north": (left, self.middle, right, top), "south": (left, bottom, right, self.middle)}
        self.extent = halves.get(half, self.frame.extent)
        self._cells: np.ndarray | None = None

    def known_elsewhere(self) -> Ground:
        """Return the ground with a database of the other half of the map, so every position is wrong."""
        is_north = self.extent[1] >= self.middle
        edge = self.extent[1] - REACH_PX if is_north else self.extent[3] + REACH_PX
        references, overview = self.database.references, self.database.overview.copy()
        inside = references.positions[:, 1] < edge if is_north else references.positions[:, 1] > edge
        row = int((self.frame.origin[1] - edge) / self.database.parameters.overview_frame.pixel_size)
        overview[slice(0, row) if is_north else slice(row, None)] = 0
        database = replace(self.database, references=chosen(references, inside), overview=overview)
        other = Ground(self.labels_hw, database, size_px=self.size_px)
        other.extent, other.references = self.extent, self.references
        return other

    def part(self, area_km2: float) -> Ground:
        """Return the square of a map around its median landmark as a small map of its own."""
        pixel = self.frame.pixel_size
        half = round(500 * math.sqrt(area_km2) / pixel)
        x, y = np.median(self.references.positions, axis=0)
        column, row = (round(float(at)) for at in self.frame.to_pixels((x, y)))
        labels = self.labels_hw[max(row - half, 0) : row + half, max(column - half, 0) : column + half]
        window = self.size_px * pixel / 2
        sizes = window, window / 4, self.database.parameters.minimum_area
        return memory_ground(np.ascontiguousarray(labels), self.database.class_table.to_csv(), sizes, pixel)

    def draw(self, wanted: Wanted, rng: np.random.Generator, is_of_map: bool = True) -> Image:
        """Draw an image of the wanted kind.

        Raises:
            ValueError: The map has no such image.
        """
        for _ in range(LARGEST_TRIES):
            view = self._view(wanted, rng)
            if self._count_near(view) < 0.7 * wanted.landmarks[0] or wanted.is_inside and not lies_on(self.frame, view):
                continue
            labels = cut(self.labels_hw, self.frame, view)
            if (labels > 0).mean() < wanted.labeled:
                continue
            count = int((~self.landmarks_in(labels, view.pixel_size).touches_edge).sum())
            if wanted.landmarks[0] <= count <= wanted.landmarks[1]:
                return Image(Query(view, is_of_map=is_of_map), SeenLabels(labels), count)
        raise ValueError(f"{LARGEST_TRIES} places of the map have no view with {wanted.landmarks[0]} landmarks.")

    def _view(self, wanted: Wanted, rng: np.random.Generator) -> View:
        edge = int(rng.choice(wanted.sizes_px)) if wanted.sizes_px else self.size_px
        if wanted.share:
            view = self._anywhere(wanted.share, rng)
        else:
            sizes = tuple(scale * self.frame.pixel_size for scale in wanted.scales)
            view = random_view(rng, self.extent, (edge, edge), sizes)
        if wanted.headings_deg:
            view = replace(view, heading_deg=float(rng.choice(wanted.headings_deg)))
        if wanted.tilt_deg:
            view = replace(view, tilt_deg=wanted.tilt_deg, tilt_direction_deg=float(rng.uniform(0, 360)))
        if wanted.lens:
            view = replace(view, lens=float(rng.choice([-1, 1])) * wanted.lens)
        return replace(view, is_mirrored=wanted.is_mirrored)

    def _anywhere(self, share: float, rng: np.random.Generator) -> View:
        """Draw a view at a random place of the map."""
        parameters = self.database.parameters
        spacing = parameters.window_size / 2
        if self._cells is None:
            self._cells = ground_cells(self.database, spacing).centers
        left, bottom, right, top = self.extent
        while True:
            x, y = self._cells[rng.integers(len(self._cells))] + rng.uniform(-spacing / 2, spacing / 2, 2)
            if left <= x <= right and bottom <= y <= top:
                break
        edge = share * parameters.window_size * math.exp(rng.uniform(-0.15, 0.15))
        size = round(share * parameters.window_size / parameters.pixel_size)
        return View(float(x), float(y), float(rng.uniform(0, 360)), edge / size, size, size)

    def landmarks_in(self, labels_hw: np.ndarray, pixel_size: float) -> Landmarks:
        """Return the landmarks of an image that are at least as large as the smallest of the map."""
        smallest = max(self.database.parameters.minimum_area / pixel_size**2, SMALLEST_OBJECT_PX)
        return extract_landmarks(labels_hw, self.database.class_table.reference_values, smallest)

    def spoiled(
        self, image: Image, noise: NetworkNoise, rng: np.random.Generator, class_values: Sequence[int] = ()
    ) -> Image:
        """Return the image with noise in its pixels. Spurious landmarks come from another view of similar scale.

        Args:
            class_values: Classes with regions that noise removes, adds, merges and splits; empty for the landmarks.
        """
        if noise == NetworkNoise():
            return image
        pixel, donated = image.view.pixel_size, None
        if noise.spurious:
            scale = pixel / self.frame.pixel_size
            size = image.view.width_px
            wanted = Wanted((scale, scale), landmarks=(min(4, size // 160), 10**9), sizes_px=(size,))
            donated = self.draw(wanted, rng).labels_hw
        smallest = max(self.database.parameters.minimum_area / pixel**2, 1.0)
        values = class_values or self.database.class_table.reference_values
        return replace(image, seen=SeenLabels(spoil(image.labels_hw, noise, rng, values, donated, smallest)))

    def try_image(
        self,
        image: Image,
        method: Method,
        prior: Prior | None = None,
        level: Leveling | None = None,
        right_within: float | None = None,
    ) -> Trial:
        """Localize an image like the plugin and judge the result."""
        started = time.process_time()
        found = localize_with(self.localizer, Search(method), image.seen, prior or Prior(), level).localization
        seconds = time.process_time() - started
        return judge(image.query, method, found, right_within, image.landmarks, seconds)

    def _count_near(self, view: View) -> int:
        """Count the landmarks of the map in the upright square of the view's size, as a quick test."""
        away = np.abs(self.references.positions - view.position).max(axis=1)
        return int((away < view.footprint / 2).sum())


def chosen(references: MapLandmarks, kept: np.ndarray) -> MapLandmarks:
    """Return the landmarks of a map that ``kept`` selects, (N,) bool."""
    columns = {name: column[kept] for name, column in vars(references).items() if column is not None}
    return replace(references, **columns)


def memory_ground(labels_hw: np.ndarray, classes_csv: str, sizes: Sequence[float], pixel_m: float = 1.0) -> Ground:
    """Return the ground of a label map in memory and build its database; ``sizes``: window, stride, minimum area."""
    from semref.core.database.build import BuildSettings, build_from_labels
    from semref.core.labels.class_table import class_table_from_csv
    from semref.core.labels.sources import ArrayLabels

    frame = MapFrame.at((0.0, 0.0), pixel_m)
    table = class_table_from_csv(classes_csv)
    database = build_from_labels(ArrayLabels(labels_hw), frame, table, BuildSettings(*sizes), "benchmark")
    return Ground(labels_hw, database)


def random_view(
    rng: np.random.Generator,
    extent: tuple[float, float, float, float],
    size_px: tuple[int, int] = (1280, 1280),
    pixel_sizes: tuple[float, float] = (1.0, 1.0),
) -> View:
    """Return a view of random position and heading.

    Args:
        rng: Draws easting, northing, pixel size and heading, in this order.
        extent: (x_min, y_min, x_max, y_max), m, of the center.
        size_px: (width, height)
        pixel_sizes: Smallest and largest, with a uniform logarithm.
    """
    # From north to south, as rows of a map go.
    x, y = rng.uniform(extent[0], extent[2]), -rng.uniform(-extent[3], -extent[1])
    pixel_size = float(np.exp(rng.uniform(*np.log(pixel_sizes))))
    return View(float(x), float(y), float(rng.uniform(0, 360)), pixel_size, *size_px)
