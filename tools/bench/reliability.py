"""What the told probability is worth: images of all qualities, right and wrong places, images of two places.

In parts, each with its own seed; a later run with the same --work goes on.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, replace

import numpy as np

from bench import inputs, kept, page, two_dates
from bench.elsewhere import LATTICE_KINDS, lattice, region_landmarks, sample_labels
from bench.ground import GOAL, HARD, Ground, Wanted
from semref.core.constellation.index import full_area
from semref.core.constellation.solver import localize as solve
from semref.core.evaluation.trial import RIGHT_SHARE
from semref.core.landmarks.landmarks import Landmarks
from semref.core.localization import Localization, Prior, Status
from semref.core.simulation.landmark_errors import spoil_landmarks
from semref.core.simulation.noise import LabelNoise
from semref.core.simulation.views import View, image_coordinates, random_view
from semref.storage.database.reader import read_database

PAGE = "benchmarks.md"
SEED = 9_000
COUNT, QUICK_COUNT = 2_000, 20
PART = 50
SCALES = (0.8, 1.25)
SEARCHED = (0.4, 2.5)
SIZES_PX = (320, 640, 1280)
LEAST_LANDMARKS = 4
TRIES = 5_000
SAMPLING = {"center": 0.3, "log_area": 0.05}
"""What turning and sampling an image costs its landmarks by itself."""

NOISES = {
    "clean": LabelNoise(),
    "20 / 20 / 5 %": GOAL,
    "40 / 40 / 10 %": HARD,
    "60 / 60 / 15 %": replace(GOAL, missed=0.6, spurious=0.6, mislabeled=0.15, center=2.5, log_area=0.2),
    "75 / 75 / 20 %": replace(GOAL, missed=0.75, spurious=0.75, mislabeled=0.2, center=3, log_area=0.3),
    "30 / 30 / 10 %, centers off by 4 px": replace(
        GOAL, missed=0.3, spurious=0.3, mislabeled=0.1, center=4, log_area=0.4
    ),
}
OF_MAP, MIRRORED, OTHER_HALF, LATTICE, LANDSCAPE, TWO_PLACES = (
    "of the map",
    "mirrored",
    "other half",
    "lattice",
    "landscape",
    "two places",
)
KINDS = {OF_MAP: 0.6, MIRRORED: 0.16, OTHER_HALF: 0.1, LATTICE: 0.07, LANDSCAPE: 0.07}
HALVES = (0.3, 0.4, 0.5, 0.6, 0.7)
RISKS = (0.5, 1e-2, 1e-4, 1e-6)
DECADES = (1.0, 0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 0.0)


REMARKS = ("localization.one_side_unknown", "localization.one_side_unseen")
"""What a fix says that does not hold for one side of the image."""

FEW = 5
"""Landmarks that a side of an image of two places must show before it could be told."""


@dataclass(frozen=True)
class Told:
    """What was said of an image, and whether its best place is the right one.

    ``smaller_side``: landmarks on the side that shows fewer, of an image of two places.
    """

    kind: str
    noise: str
    size_px: int
    log_odds: float
    rival: float
    risk: float
    is_right: bool
    is_fix: bool
    is_sound: bool
    reason: str
    smaller_side: int = 0


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"reliability": "Not measured: the real data is not here."}
    count = run.how_many(COUNT, QUICK_COUNT)
    ground, sections = Ground.of(run), {}
    if run.wants(TWO_PLACES):
        sections["two places"] = of_two_places(list(_kept(run, ground, TWO_PLACES, max(count // 10, 4))))
    if run.wants("reliability"):
        sections["reliability"] = _reliability(run, ground, count)
    return sections


def _reliability(run: inputs.Run, ground: Ground, count: int) -> str:
    told = list(_kept(run, ground, "country", count))
    text = [_ABOUT.format(half=run.half, count=len(told)), curve(told), by_decade(told), costs(told), remarked(told)]
    if (run.data / two_dates.SOURCE).exists():
        other = list(_kept(run, None, "christchurch", max(count // 4, 4)))
        text += [_CHRISTCHURCH.format(count=len(other)), curve(other), by_decade(other), costs(other), remarked(other)]
    return "\n\n".join(text)


_ABOUT = """\
Constellation, {count} images of the {half}ern half of Liechtenstein (constants are from the northern), each with the
pixel size known to a factor of 0.4–2.5: three of five of the map, of 320, 640 or 1,280 m, clean to three of four
landmarks missed, as many spurious, centers off by up to 4 px; the others mirrored, of the half that the database lacks,
regular lattices, made-up landscapes: no place is right. Of every image the best place counts, fix or not; right: within
2 % of the footprint."""

_CHRISTCHURCH = """\
The same on Christchurch, {count} label images of 2018 against a database of 1996 (another country, other classes, 10 m
pixels), 3.2, 6.4 and 12.8 km of ground, one in four mirrored (and counted, so that three of four
can be right):"""


def _kept(run: inputs.Run, ground: Ground | None, name: str, count: int) -> Iterator[Told]:
    elsewhere: list[Ground] = []

    def measured(part: int, size: int) -> list[dict]:
        rng = np.random.default_rng([SEED, sum(map(ord, name)), part])
        if name == "christchurch":
            return [asdict(one) for one in christchurch(run, rng, size)]
        if name == TWO_PLACES:
            return [asdict(two_places(ground, rng)) for _ in range(size)]
        if not elsewhere:
            elsewhere.append(ground.known_elsewhere())
        return [asdict(country(ground, elsewhere[0], rng, part)) for _ in range(size)]

    for number, size in enumerate(kept.wanted(run, "reliability", name, kept.parts(count, PART))):
        told = [Told(**one) for one in kept.part(run, "reliability", name, number, size, measured)]
        fixes = sum(t.is_fix for t in told)
        print(f"  {name}: part {number}, {fixes} fixes of {len(told)}", file=sys.stderr, flush=True)
        yield from told


# --- images ---


def country(ground: Ground, other: Ground, rng: np.random.Generator, part: int) -> Told:
    """An image of one of KINDS."""
    kind = str(rng.choice(list(KINDS), p=list(KINDS.values())))
    noise, size = str(rng.choice(list(NOISES))), int(rng.choice(SIZES_PX))
    if kind in (LATTICE, LANDSCAPE):
        view, noise = View(0.0, 0.0), ""
        seen = lattice(rng, str(rng.choice(LATTICE_KINDS))) if kind == LATTICE else _landscape(rng, part)
    else:
        view, seen = seen_landmarks(ground, rng, size, is_mirrored=kind == MIRRORED)
        seen = spoiled(ground, view, seen, NOISES[noise], rng)
    known = other if kind == OTHER_HALF else ground
    return judged(known, view, seen, kind, noise, can_be_right=kind == OF_MAP)


_landscapes: dict[int, np.ndarray] = {}


def _landscape(rng: np.random.Generator, part: int) -> Landmarks:
    if part not in _landscapes:
        _landscapes.clear()
        _landscapes[part] = sample_labels(SEED + part)
    return region_landmarks(_landscapes[part], rng, SCALES)


def two_places(ground: Ground, rng: np.random.Generator) -> Told:
    """One side of an image of one place, the other of another; right is none."""
    noise, size = str(rng.choice(list(NOISES)[:3])), int(rng.choice(SIZES_PX[1:]))
    view, one = seen_landmarks(ground, rng, size, 2 * LEAST_LANDMARKS)
    scale = view.pixel_size / ground.frame.pixel_size
    _, other = seen_landmarks(ground, rng, size, 2 * LEAST_LANDMARKS, scales=(scale, scale))
    axis, cut = int(rng.integers(2)), size * float(rng.choice(HALVES))
    both = joined(one.select(one.centers_xy[:, axis] < cut), other.select(other.centers_xy[:, axis] >= cut))
    seen = spoiled(ground, view, both, NOISES[noise], rng)
    before = int((seen.centers_xy[:, axis] < cut).sum())
    told = judged(ground, view, seen, TWO_PLACES, noise, False)
    return replace(told, smaller_side=min(before, len(seen) - before))


def joined(one: Landmarks, other: Landmarks) -> Landmarks:
    """The landmarks of both."""
    return Landmarks(*(np.concatenate(pair) for pair in zip(vars(one).values(), vars(other).values())))


def seen_landmarks(
    ground: Ground,
    rng: np.random.Generator,
    size_px: int,
    least: int = LEAST_LANDMARKS,
    is_mirrored: bool = False,
    scales: tuple[float, float] = SCALES,
) -> tuple[View, Landmarks]:
    """A view of the map, and its whole landmarks as the catalogue has them: no label image is cut."""
    known = ground.references
    edges = np.sqrt(full_area(known.areas_m2, ground.frame.pixel_size))
    for _ in range(TRIES):
        sizes = tuple(scale * ground.frame.pixel_size for scale in scales)
        view = random_view(rng, ground.extent, (size_px, size_px), sizes)
        view = replace(view, is_mirrored=is_mirrored)
        near = np.flatnonzero(np.abs(known.positions - view.position).max(axis=1) < 0.75 * view.footprint)
        if len(near) < least:
            continue
        centers, half = image_coordinates(view, known.positions[near]), edges[near] / view.pixel_size / 2
        areas = np.maximum(2 * half - 1, 0) ** 2
        inside = ((centers > half[:, None]) & (centers < size_px - half[:, None])).all(axis=1)
        inside &= areas >= ground.localizer.settings.constellation.smallest_object_px
        if inside.sum() >= least:
            chosen, count = near[inside], int(inside.sum())
            boxes, cut = np.zeros((count, 4), np.int64), np.zeros(count, bool)
            return view, Landmarks(centers[inside], known.classes[chosen], areas[inside], boxes, cut)
    raise ValueError(f"{TRIES} places of the map have no view with {least} landmarks.")


def spoiled(ground: Ground, view: View, seen: Landmarks, noise: LabelNoise, rng: np.random.Generator) -> Landmarks:
    """The landmarks with noise and with what sampling costs; spurious ones have classes and areas of the map's."""
    least = {name: max(getattr(noise, name), value) for name, value in SAMPLING.items()}
    known = ground.references
    boxes = np.zeros((len(known), 4), np.int64)
    population = Landmarks(
        known.positions, known.classes, known.areas_m2 / view.pixel_size**2, boxes, known.touches_edge
    )
    return spoil_landmarks(seen, replace(noise, **least), rng, population, (view.width_px, view.height_px))


def christchurch(run: inputs.Run, rng: np.random.Generator, count: int) -> Iterator[Told]:
    """Label images of 2018 in the database of 1996, the same footprints as of ``two_dates``."""
    labels = inputs.read_labels(two_dates.label_map(run, two_dates.AFTER))
    grounds = []
    for footprint in two_dates.FOOTPRINTS_M:
        content = read_database(str(two_dates.database(run, footprint)), with_overview=True)
        grounds.append(Ground(labels, content, size_px=round(footprint / two_dates.PIXEL_SIZE_M)))
    noises = dict(list(NOISES.items())[:4])
    for number in range(count):
        ground, noise = grounds[number % len(grounds)], str(rng.choice(list(noises)))
        wanted = Wanted(SCALES, landmarks=(LEAST_LANDMARKS, 10**9), labeled=0.7, is_mirrored=number % 4 == 3)
        image = ground.draw(wanted, rng)
        seen = ground.landmarks_in(image.labels_hw, image.view.pixel_size)
        seen = spoiled(ground, image.view, seen, noises[noise], rng)
        yield judged(ground, image.view, seen, OF_MAP, noise, can_be_right=not image.view.is_mirrored)


def judged(ground: Ground, view: View, seen: Landmarks, kind: str, noise: str, can_be_right: bool) -> Told:
    """What the constellation says of an image with these landmarks."""
    if not len(seen):
        return Told(kind, noise, view.width_px, -math.inf, 0.0, 1.0, False, False, False, "no landmarks")
    prior = Prior(pixel_size_range=(SEARCHED[0] * view.pixel_size, SEARCHED[1] * view.pixel_size))
    found: Localization = solve(seen, (view.width_px, view.height_px), ground.localizer.index, prior)
    best = found.best
    off = math.inf if best is None else math.dist(best.position, view.position)
    rival = max(found.mirror_log_odds or 0.0, found.runner_up_log_odds or -math.inf)
    return Told(
        kind,
        noise,
        view.width_px,
        -math.inf if best is None else float(best.log_odds),
        float(rival),
        1.0 if found.risk is None else float(found.risk),
        can_be_right and off <= RIGHT_SHARE * view.footprint,
        found.status is Status.FIX,
        found.is_fix or found.is_doubted,
        "" if found.reason is None else found.reason.code,
    )


# --- tables ---


def curve(told: Sequence[Told]) -> str:
    """Tenths of the told probability, and the expected calibration error."""
    rows, error = [], 0.0
    for tenth in range(10):
        chosen = [t for t in told if min(int(10 * (1 - t.risk)), 9) == tenth]
        if not chosen:
            continue
        mean, right = float(np.mean([1 - t.risk for t in chosen])), sum(t.is_right for t in chosen)
        error += len(chosen) / len(told) * abs(mean - right / len(chosen))
        rows.append([f"{tenth / 10:.1f}–{tenth / 10 + 0.1:.1f}", f"{mean:.3f}", page.rate(right, len(chosen))])
    table = page.table(["told probability", "mean", "right"], rows)
    return f"{table}\n\nExpected calibration error: {error:.3f} (goal: ≤ 0.02)."


def by_decade(told: Sequence[Told]) -> str:
    """Wrong places by told risk."""
    rows = []
    for high, low in zip(DECADES, DECADES[1:]):
        chosen = [t for t in told if low < t.risk <= high]
        wrong = sum(not t.is_right for t in chosen)
        expected = sum(t.risk for t in chosen)
        if chosen:
            rows.append([f"{low:g}–{high:g}", f"{expected:.2g}", page.rate(wrong, len(chosen))])
    return page.table(["told risk", "wrong expected", "wrong"], rows)


def costs(told: Sequence[Told]) -> str:
    """Right and wrong fixes by the risk that is allowed, by noise."""
    rows = []
    for noise in (*dict.fromkeys(t.noise for t in told if t.noise), ""):
        chosen = [t for t in told if t.kind == OF_MAP and noise in ("", t.noise)]
        cells = []
        for allowed in RISKS:
            fixes = [t for t in chosen if t.is_sound and t.risk <= allowed]
            wrong = sum(not t.is_right for t in fixes)
            cells.append(f"{page.rate(sum(t.is_right for t in fixes), len(chosen))}; {wrong} wrong")
        rows.append([noise or "all", *cells])
    strange = [t for t in told if t.kind != OF_MAP]
    if strange:
        cells = [page.rate(sum(t.is_sound and t.risk <= allowed for t in strange), len(strange)) for allowed in RISKS]
        rows.append(["not of the map: fixes, all wrong", *cells])
    header = ["images of the map: right fixes", *(f"RISK {allowed:g}" for allowed in RISKS)]
    return page.table(header, rows)


def of_two_places(told: Sequence[Told]) -> str:
    """How often images of two places are told as such, and with enough landmarks on both sides to tell."""
    parts = []
    for chosen in (told, [t for t in told if t.smaller_side >= FEW]):
        said = sum(t.reason == "localization.one_side_elsewhere" for t in chosen)
        fixes = [t for t in chosen if t.is_fix]
        parts.append(
            f"told as such {page.rate(said, len(chosen))}, a fix of one of the places "
            f"{page.rate(len(fixes), len(chosen))}, {sum(t.reason in REMARKS for t in fixes)} of which say for which "
            f"part of the image they don't hold"
        )
    return (
        f"Images of two places, cut at 0.3–0.7 of the edge, clean to 40 / 40 / 10 %: {parts[0]}. "
        f"Where both sides show {FEW} landmarks or more: {parts[1]}."
    )


def remarked(told: Sequence[Told]) -> str:
    """How often a right fix of the whole image says that there is a part of it that it doesn't hold for."""
    right = [t for t in told if t.kind == OF_MAP and t.is_fix and t.is_right]
    elsewhere = sum(t.is_right and t.reason == "localization.one_side_elsewhere" for t in told if t.kind == OF_MAP)
    return (
        f"Right fixes that say so, too: {page.rate(sum(t.reason in REMARKS for t in right), len(right))}, mostly where "
        f"the image reaches beyond the map. Right places refused as of two places: {elsewhere}."
    )
