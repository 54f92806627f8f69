"""Simulated images of an area's label map, localized in a database and judged: what benches of localization share."""

from __future__ import annotations

import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from bench import inputs, kept, page
from semref.core.constellation.index import ConstellationIndex
from semref.core.constellation.solver import localize as solve
from semref.core.database.model import MapLandmarks, ReferenceDatabase
from semref.core.evaluation.summary import covered, percentile
from semref.core.evaluation.trial import Query, Trial, judge
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_shares import ClassShares
from semref.core.landmarks.landmarks import Landmarks, extract_landmarks
from semref.core.localization import Method, Prior
from semref.core.localizer.localizer import Localizer
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.landmark_errors import spoil_landmarks
from semref.core.simulation.noise import LabelNoise
from semref.core.simulation.views import View, cut, lies_on, random_view
from semref.storage.database.reader import read_database

ANY = (0, 10**9)
SEED = 1671
LARGEST_SCALE = 2.0
LARGEST_TRIES = 20_000
"""Places tried for one view before the map is said to have none like it."""

REACH_PX = 1_200
"""Images see at most so far beyond the half of the map that their centers lie in."""

NONE = LabelNoise()
GOAL = LabelNoise(missed=0.2, spurious=0.2, mislabeled=0.05, jitter=1.5, center=1.5, log_area=0.1)
HARD = replace(GOAL, missed=0.4, spurious=0.4, mislabeled=0.1)
"""Noise of the goals, in pixels: boundaries move in label images, centers and areas where landmarks are perturbed."""


@dataclass(frozen=True)
class Wanted:
    """What images to draw.

    Attributes:
        scales: smallest and largest pixel size, in pixels of the map
        headings_deg: to choose from; any if empty
        landmarks: fewest and most whole ones in view, before any noise
        tilt_deg: of the camera, in any direction
        labeled: least share of the image
        sizes_px: edges to choose from; the ground's own if empty
        is_inside: whether all of the image shows the map
        is_mirrored: whether left and right are exchanged
    """

    scales: tuple[float, float] = (0.8, 1.25)
    headings_deg: tuple[float, ...] = ()
    landmarks: tuple[int, int] = (20, 10**9)
    tilt_deg: float = 0.0
    labeled: float = 0.0
    sizes_px: tuple[int, ...] = ()
    is_inside: bool = False
    is_mirrored: bool = False


@dataclass(frozen=True)
class Image:
    """A simulated image: the question, its (H, W) labels, and how many whole landmarks it showed before any noise.

    ``shares``: of a photo, how sure its network is.
    """

    query: Query
    labels_hw: np.ndarray
    landmarks: int = 0
    shares: ClassShares | None = None

    @property
    def view(self) -> View:
        return self.query.view


@dataclass(frozen=True)
class Case:
    """One row of a table.

    Attributes:
        name: of the row
        noise: in pixels of the image, or in meters
        goal: of the row, in words
        wanted: what the images are like
        method: that localizes them
        in_meters: whether lengths of the noise are meters
        as_landmarks: noise is put into the landmarks that are found in the clean image, instead of into the image
        right_within: map units; None for a share of the footprint
        is_of_map: False where any fix is wrong
    """

    name: str
    noise: LabelNoise = NONE
    goal: str = ""
    wanted: Wanted = field(default_factory=Wanted)
    method: Method = Method.CONSTELLATION
    in_meters: bool = False
    as_landmarks: bool = False
    right_within: float | None = None
    is_of_map: bool = True


class Ground:
    """A label map that images are cut from, and the database they are localized in, which may be of another date.

    Attributes:
        references: landmarks of the map that images are cut from
        extent: (x_min, y_min, x_max, y_max) that centers of images lie in, map units
        prior: told with every image
        meters: a map unit has
        spoiled_values: classes whose regions noise misses, adds, merges and splits
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
        self.spoiled_values = database.class_table.reference_values
        self.prior: Prior | None = None
        self.meters = 1.0
        left, bottom, right, top = self.frame.extent
        self.middle = float(np.median(database.references.positions[:, 1]))
        halves = {"north": (left, self.middle, right, top), "south": (left, bottom, right, self.middle)}
        self.extent = halves.get(half, self.frame.extent)

    @classmethod
    def of(cls, run: inputs.Run, half: str | None = None) -> Ground:
        """The area's own, images from one half of it; constants were fitted on the northern half of Liechtenstein."""
        database = read_database(str(run.database(run.area.stride)), with_overview=True)
        half = run.half if half is None else half
        return cls(inputs.read_labels(run.label_map()), database, "" if run.area.name == "sample" else half)

    def known_elsewhere(self) -> Ground:
        """The same images, but the database knows the other half of the map alone: any fix is wrong."""
        is_north = self.extent[1] >= self.middle
        edge = self.extent[1] - REACH_PX if is_north else self.extent[3] + REACH_PX
        references, overview = self.database.references, self.database.overview.copy()
        inside = references.positions[:, 1] < edge if is_north else references.positions[:, 1] > edge
        row = int((self.frame.origin[1] - edge) / self.database.parameters.overview_frame.pixel_size)
        overview[slice(0, row) if is_north else slice(row, None)] = 0
        database = replace(self.database, references=chosen(references, inside), overview=overview)
        other = Ground(self.labels_hw, database, size_px=self.size_px)
        other.extent, other.references, other.spoiled_values = self.extent, self.references, self.spoiled_values
        return other

    def cut(self, view: View) -> np.ndarray:
        """(H, W) labels the view shows."""
        return cut(self.labels_hw, self.frame, view)

    def draw(self, wanted: Wanted, rng: np.random.Generator, is_of_map: bool = True) -> Image:
        """An image as wanted; ValueError where there is none."""
        sizes = tuple(scale * self.frame.pixel_size for scale in wanted.scales)
        for _ in range(LARGEST_TRIES):
            edge = int(rng.choice(wanted.sizes_px)) if wanted.sizes_px else self.size_px
            view = random_view(rng, self.extent, (edge, edge), sizes)
            if wanted.headings_deg:
                view = replace(view, heading_deg=float(rng.choice(wanted.headings_deg)))
            if wanted.tilt_deg:
                direction = float(rng.uniform(0, 360))
                view = replace(view, tilt_deg=wanted.tilt_deg, tilt_direction_deg=direction)
            view = replace(view, is_mirrored=wanted.is_mirrored)
            if self._count_near(view) < 0.7 * wanted.landmarks[0] or wanted.is_inside and not lies_on(self.frame, view):
                continue
            labels = self.cut(view)
            found = self.landmarks_in(labels, view.pixel_size)
            count = int((~found.touches_edge).sum())
            if wanted.landmarks[0] <= count <= wanted.landmarks[1] and (labels > 0).mean() >= wanted.labeled:
                return Image(Query(view, is_of_map=is_of_map), labels, count)
        raise ValueError(f"{LARGEST_TRIES} places of the map have no view with {wanted.landmarks[0]} landmarks.")

    def image(self, view: View) -> Image:
        """The image of a view of the map."""
        return Image(Query(view), self.cut(view))

    def choose_windows(self, count: int) -> np.ndarray:
        """Up to `count` windows with a vector around which views twice as large lie on the map; always the same."""
        windows = self.database.windows
        reach = self.size_px / 2 * LARGEST_SCALE
        places = self.frame.to_pixels(windows.centers)
        on_map = ((places >= reach) & (places <= np.array(self.frame.shape_hw[::-1]) - reach)).all(axis=1)
        eligible = np.flatnonzero(windows.described & on_map)
        return np.sort(np.random.default_rng(SEED).choice(eligible, min(count, len(eligible)), replace=False))

    def view_on(
        self, window: int, heading_deg: float = 0.0, scale: float = 1.0, moved_px: Sequence[float] = (0, 0)
    ) -> View:
        """A view around a window's center, or beside it; ``scale``: pixels of the map a pixel shows."""
        x, y = self.database.windows.centers[window] + np.multiply(moved_px, (1, -1)) * self.frame.pixel_size
        return View(float(x), float(y), heading_deg, scale * self.frame.pixel_size, self.size_px, self.size_px)

    def landmarks_in(self, labels_hw: np.ndarray, pixel_size: float) -> Landmarks:
        """Landmarks of an image, from the smallest of the map on."""
        least = self.localizer.settings.constellation.smallest_object_px
        smallest = max(self.database.parameters.minimum_area / pixel_size**2, least)
        return extract_landmarks(labels_hw, self.database.class_table.reference_values, smallest)

    def spoiled(self, image: Image, noise: LabelNoise, rng: np.random.Generator) -> Image:
        """The image with noise, in its pixels; spurious landmarks are those of another view at about its scale."""
        if noise == NONE:
            return image
        pixel = image.view.pixel_size
        donor = None
        if noise.spurious:
            scale = pixel / self.frame.pixel_size
            donor = self.draw(Wanted((scale, scale), landmarks=(4, 10**9)), rng).labels_hw
        smallest = max(self.database.parameters.minimum_area / pixel**2, 1.0)
        labels = spoil_labels(image.labels_hw, noise, rng, self.spoiled_values, donor, smallest)
        return replace(image, labels_hw=labels)

    def spoiled_landmarks(self, image: Image, noise: LabelNoise, rng: np.random.Generator) -> Landmarks:
        """The landmarks of the clean image with noise; spurious ones have classes and areas of the map's."""
        view, known = image.view, self.references
        boxes = np.zeros((len(known), 4), int)
        areas = known.areas_m2 / view.pixel_size**2
        population = Landmarks(known.positions, known.classes, areas, boxes, known.touches_edge)
        found = self.landmarks_in(image.labels_hw, view.pixel_size)
        return spoil_landmarks(found, noise, rng, population, (view.width_px, view.height_px))

    def try_image(self, image: Image, method: Method, right_within: float | None = None) -> Trial:
        """A label image in, what came of it out."""
        started = time.process_time()
        found = self.localizer.localize(image.labels_hw, method, self.prior, shares=image.shares)
        seconds = time.process_time() - started
        return judge(image.query, method, found, right_within, image.landmarks, seconds)

    def try_landmarks(
        self,
        image: Image,
        landmarks: Landmarks,
        right_within: float | None = None,
        index: ConstellationIndex | None = None,
    ) -> Trial:
        """The constellation from landmarks on, in the database's catalogue or another index."""
        view, index = image.view, index or self.localizer.index
        sizes = self.localizer.pixel_sizes(view.shape_hw, self.localizer.settings.constellation.scales)
        prior = Prior(pixel_size_range=sizes)
        started = time.process_time()
        found = solve(landmarks, (view.width_px, view.height_px), index, prior, errors=self.localizer.errors)
        seconds = time.process_time() - started
        return judge(image.query, Method.CONSTELLATION, found, right_within, image.landmarks, seconds)

    def attempt(self, case: Case, rng: np.random.Generator, index: ConstellationIndex | None = None) -> Trial:
        """One image of a case: drawn, spoiled, localized, judged."""
        image = self.draw(case.wanted, rng, case.is_of_map)
        noise = case.noise.in_pixels(image.view.pixel_size * self.meters) if case.in_meters else case.noise
        if case.as_landmarks:
            return self.try_landmarks(image, self.spoiled_landmarks(image, noise, rng), case.right_within, index)
        return self.try_image(self.spoiled(image, noise, rng), case.method, case.right_within)

    def attempts(self, case: Case, seed: Sequence[int], part: int, size: int) -> list[Trial]:
        """A part of a case's images; each part has its own seed."""
        rng = np.random.default_rng([*seed, part])
        return [self.attempt(case, rng) for _ in range(size)]

    def try_vector(self, view: View, labels_hw: np.ndarray | None = None, localizer: Localizer | None = None) -> Trial:
        """A view by its topology vector; right is the window nearest to its center."""
        nearest = np.hypot(*(self.database.windows.centers - view.position).T).min()
        labels_hw = self.cut(view) if labels_hw is None else labels_hw
        found = (localizer or self.localizer).localize_by_topology_vector(labels_hw)
        return judge(Query(view), Method.TOPOLOGY_VECTOR, found, nearest + 1e-6)

    def _count_near(self, view: View) -> int:
        """Landmarks of the map in the upright square of the view's size: a quick look before it is cut."""
        away = np.abs(self.references.positions - view.position).max(axis=1)
        return int((away < view.footprint / 2).sum())


def chosen(references: MapLandmarks, kept: np.ndarray) -> MapLandmarks:
    """Those landmarks of a map that ``kept`` says, (N,) bool."""
    columns = {name: column[kept] for name, column in vars(references).items() if column is not None}
    return replace(references, **columns)


def memory_ground(labels_hw: np.ndarray, classes_csv: str, settings: object, pixel_m: float = 1.0) -> Ground:
    """The ground of a label map in memory, whose database is built here; rows go down from 0.

    Pixels are map units unless their meters are told.
    """
    from semref.core.database.build import DatabaseBuilder
    from semref.core.labels.class_table import class_table_from_csv
    from semref.core.labels.sources import ArrayLabels

    frame = MapFrame.at((0.0, 0.0), pixel_m)
    builder = DatabaseBuilder(ArrayLabels(labels_hw), frame, class_table_from_csv(classes_csv), settings, "measured")
    for _ in builder.steps():
        pass
    return Ground(labels_hw, replace(builder.database, overview=builder.overview))


# --- aerial label maps of Dubai ---

# --- tables ---

COLUMNS = (
    "images",
    "goal",
    "right fixes",
    "wrong fixes",
    "no fix",
    "landmarks in view → found (medians)",
    "median error, heading, scale",
    "in the 95 % radius",
    "ms median, p95",
)


def tried(
    run: inputs.Run, ground: Ground, cases: Sequence[Case], count: int, seed: int, kept_in: str = ""
) -> Iterator[tuple]:
    """(case, trials) one after the other; a case that the map has no image of is left out, and the reason is said.

    kept_in: folder of the work folder that keeps the trials, so that a later run goes on; nothing is kept without.
    """
    for number, case in enumerate(cases):
        if not run.wants(case.name):
            continue
        measured = partial(ground.attempts, case, (seed, number))
        try:
            trials = kept.trials(run, kept_in, case.name, count, measured) if kept_in else measured(0, count)
        except ValueError as error:
            print(f"  {case.name}: not measured: {error}", file=sys.stderr, flush=True)
            continue
        if trials:
            print("  " + " | ".join(cells(trials, case.name, case.goal)), file=sys.stderr, flush=True)
            yield case, trials


def cells(trials: Sequence[Trial], name: str, goal: str = "") -> list[str]:
    """A line of a table with COLUMNS."""
    total, right = len(trials), [t for t in trials if t.is_right]
    refused = Counter(str(t.status) for t in trials if not t.is_fix)
    seen = percentile([t.landmarks for t in trials], 50) or 0
    return [
        name,
        goal,
        page.rate(len(right), total) if any(t.query.can_be_right for t in trials) else "–",
        page.rate(sum(t.is_wrong for t in trials), total),
        ", ".join(f"{refused[status]} {status}" for status in sorted(refused)) or "0",
        f"{seen:.0f} → {np.median([t.result.references for t in trials]):.0f}",
        *accuracy(right),
        milliseconds(trials),
    ]


def accuracy(right: Sequence[Trial]) -> tuple[str, str]:
    """Median errors of right fixes (position, share of the footprint; heading, scale if told), the radius' coverage."""
    if not right:
        return "–", "–"
    error, part = (percentile([getattr(t, name) for t in right], 50) for name in ("error", "error_share"))
    heading, scale = (
        percentile([getattr(t, name) for t in right], 50) for name in ("heading_error_deg", "scale_error")
    )
    text = f"{error:.2f} m ({100 * part:.3f} %)"
    if heading is not None:
        text += f", {heading:.3f}°, {100 * scale:.3f} %"
    held = covered(right)
    return text, page.rate(held.successes, held.trials)


def milliseconds(trials: Sequence[Trial]) -> str:
    """Median and 95th percentile of the processor time."""
    median, high = 1000 * np.percentile([t.seconds for t in trials], [50, 95])
    return f"{median:.0f}, {high:.0f}"
