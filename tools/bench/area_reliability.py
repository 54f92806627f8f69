"""What map correlation's probability is worth: images of all qualities, right and wrong places.

In parts, each with its own seed; a later run with the same --work goes on. What is kept are the places that were found,
not what was said of them: a run after a change of the curve alone judges the same places anew.
"""

from __future__ import annotations

import functools
import hashlib
import json
import math
import sys
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import cv2
import numpy as np

from bench import footprints, inputs, new_places, page, reliability, two_dates
from bench.correlation import BUILDINGS, ON_A_TILE
from bench.elsewhere import aerial_labels, sample_labels
from bench.ground import GOAL, Ground, Image
from bench.kept import parts
from bench.tiles import tile_ground, tile_paths
from semref.core.correlation import decision, places
from semref.core.correlation.class_pyramid import EvidenceLevel, mirrored_level
from semref.core.correlation.detail import detail_at
from semref.core.correlation.exactness import covariance_on_map
from semref.core.correlation.refine import ScoredPose, is_held_by_edge
from semref.core.correlation.settings import CORRELATION, CorrelationSettings
from semref.core.evaluation.trial import RIGHT_SHARE, Query
from semref.core.localization import Prior, Status
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.noise import STRONG, LabelNoise
from semref.core.simulation.views import PIXELS, cut, random_view
from semref.storage.database.reader import read_database

PAGE = "benchmarks.md"
SEED = 64_000
COUNT, QUICK_COUNT = 400, 4
PART = 5
TOLD_SHARE, TOLD_HEADING_DEG = 0.75, 30.0
"""Of the images whose pixel size is told to within 20 %, and their heading to within so much."""

MIDDLE = replace(STRONG, merge_gap=8, split=0.3, jitter=4.5, jitter_length=13, patches=0.25, thin=6, missed=0.3)
WORSE = replace(STRONG, jitter=8, jitter_length=24, patches=0.5, missed=0.5)
NOISES = {
    "20 / 20 / 5 %": GOAL,
    "between": MIDDLE,
    "poor network": STRONG,
    "worse, half of the area in random classes": WORSE,
}
IN_PIXELS = ("20 / 20 / 5 %",)
OF_MAP, OTHER_HALF, LANDSCAPE, AERIAL, WITHOUT, MIRRORED = (
    "of the map",
    "other half",
    "landscape",
    "aerial",
    "without its place",
    "mirrored",
)
KINDS = {OF_MAP: 0.7, OTHER_HALF: 0.2, LANDSCAPE: 0.05, AERIAL: 0.05}
LEADS = (0.13, 0.29)
"""What a fix took at first, and what a risk of 1 in 10,000 took by the lead alone."""

LIECHTENSTEIN, CHRISTCHURCH, TILES = "liechtenstein", "christchurch", "tiles"
NEW_PLACES = {place.name.partition(",")[0].lower(): place for place in new_places.PLACES}
"""Of which no constant knows, by the name of the area."""

PLAIN_DETAIL = 4.0
OWN_GROUND = 1.0
"""Within so many of an image's edges from its true place it shows some of the same ground."""

SEARCHING = ("class_pyramid", "detail", "places", "refine", "refine_many", "search")
"""What finds the places of ``core/correlation``: after a change of one of these nothing is kept."""


@dataclass(frozen=True)
class Places:
    """What was found for an image.

    Attributes:
        kind: where the image is from
        noise: of its labels
        own: (score as it would be at the first one's scale, detail, how far it is from the truth as a share of the
            footprint, whether it is known closely enough for a fix, its 95 % radius as a share of the diagonal) a place
        mirrored: the same of the mirrored image
    """

    kind: str
    noise: str
    own: list
    mirrored: list


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"area reliability": "Not measured: the real data is not here."}
    cv2.setNumThreads(1)
    count = run.how_many(COUNT, QUICK_COUNT)
    text = []
    for name, about in ABOUT.items():
        if not run.wants(name) or name in NEW_PLACES and not new_places.is_here(run, NEW_PLACES[name]):
            continue
        found = list(kept(run, name, count))
        said = [one for places_of_one in found for one in judged(places_of_one)]
        wrong = sum(one.kind != reliability.OF_MAP for one in said)
        text += [about.format(half=run.half, images=len(said) - wrong, wrong=wrong), reliability.curve(said)]
        text += [reliability.by_decade(said), reliability.costs(said), _by_lead_alone(found)]
    return {"area reliability": "\n\n".join(text)}


_ABOUT = """\
Map correlation, images of the {half}ern half of Liechtenstein, of 1,280, 640 and 320 m (± 15 %) at uniform positions,
three of four with a pixel size known to within 20 % and a heading known to within 30°. {images} images of the map, and
{wrong} that are wrong by construction: of the half that the database lacks, made-up landscapes, aerial label maps; of
every image the mirrored one on ground that the image itself does not show, judged against the image's other places, and
the best place that is left without the right one. Of each the best place counts, fix or not; right: within 2 % of the
footprint. Constants: of the northern halves of Liechtenstein and Christchurch and of tiles 1 to 3 of Dubai."""

_CHRISTCHURCH = """\
The same on the {half}ern half of Christchurch, a map of 1996 and images of 2018 of 6.4, 3.2 and 1.6 km: {images} images
of the map, {wrong} that are wrong by construction:"""

_TILES = """\
And on the annotated labels of three of Dubai's tiles, spoiled as above, {images} crops of 384–768 px at 0.9–1.1 of
their pixels, pixel size searched over 0.7–1.4, and {wrong} that are wrong by construction:"""


_NEW = """\
And on {place}, of which no constant knows, as built by the steps of the guide: {{images}} images of 1, ½ and ¼ of a
window, and {{wrong}} that are wrong by construction:"""

ABOUT = {LIECHTENSTEIN: _ABOUT, CHRISTCHURCH: _CHRISTCHURCH, TILES: _TILES}
ABOUT |= {name: _NEW.format(place=place.name.partition(",")[0]) for name, place in NEW_PLACES.items()}


def _by_lead_alone(found: Sequence[Places]) -> str:
    """Right fixes by the thresholds that there were before, which knew no detail."""
    shares = []
    chosen = [one for one in found if one.kind == OF_MAP]
    for least in LEADS:
        fixes = [one.own[0] for one in chosen if one.own[0][3] and _lead(one) >= least]
        right = sum(place[2] <= RIGHT_SHARE for place in fixes)
        shares.append(f"of {least:g} {page.rate(right, len(chosen))}, {len(fixes) - right} wrong")
    return f"By a lead in Fisher's z over both opponents alone: {'; '.join(shares)}."


def _lead(found: Places) -> float:
    opponents = [place[0] for place in (*found.own[1:2], *found.mirrored[:1])]
    return decision.fisher_z(found.own[0][0]) - max(map(decision.fisher_z, opponents), default=0.0)


def kept(run: inputs.Run, name: str, count: int) -> Iterator[Places]:
    """What was found for so many images of an area."""
    folder = run.work / "area_reliability"
    folder.mkdir(exist_ok=True)
    grounds: dict[str, Ground] = {}
    for part, size in enumerate(parts(count, PART)):
        path = folder / f"{name}_{part}_{size}_{run.half}_{_state()}.json"
        if not path.exists():
            rng = np.random.default_rng([SEED, sum(map(ord, name + run.half)), part])
            found = [_one(run, name, grounds, rng, part * PART + n) for n in range(size)]
            path.write_text(json.dumps([asdict(one) for one in found if one is not None]), encoding="utf-8")
            print(f"  {name}: part {part}", file=sys.stderr, flush=True)
        yield from (Places(**one) for one in json.loads(path.read_text("utf-8")))


def _state() -> str:
    """Of the code that finds places."""
    folder = Path(places.__file__).parent
    return hashlib.sha256(b"".join((folder / f"{name}.py").read_bytes() for name in SEARCHING)).hexdigest()[:12]


# --- images ---


def _one(run: inputs.Run, area: str, grounds: dict, rng: np.random.Generator, number: int) -> Places | None:
    """An image of one of KINDS, of any footprint and noise; None where class areas can't tell anything."""
    noise, share = str(rng.choice(list(NOISES))), float(rng.choice(footprints.SHARES))
    if area == TILES:
        return _of_tile(run, grounds, noise, rng, number)
    kind = str(rng.choice(list(KINDS), p=list(KINDS.values()))) if area == LIECHTENSTEIN else OF_MAP
    ground = grounds.setdefault(area, _ground(run, area)) if area not in grounds else grounds[area]
    if kind in (LANDSCAPE, AERIAL):
        paths = tile_paths(run)
        labels = sample_labels(SEED + number) if kind == LANDSCAPE else aerial_labels(paths[number % len(paths)])
        height, width = labels.shape
        middle = (0.3 * width, -0.7 * height, 0.7 * width, -0.3 * height)
        view = random_view(rng, middle, (ground.size_px, ground.size_px), (0.3, 1.25))
        return found_for(ground, Image(Query(view, is_of_map=False), cut(labels, PIXELS, view)), None, kind, "")
    image = footprints.drawn(ground, share, rng)
    window = ground.database.parameters.window_size
    image = _spoiled(ground, image, noise, 1280.0 / window, rng, share)
    pixel, off = image.view.pixel_size, 1 + footprints.CAMERA_SPREAD
    prior = None
    if rng.random() < TOLD_SHARE:
        heading = image.view.heading_deg + rng.uniform(-1, 1) * TOLD_HEADING_DEG
        sizes = pixel / off, pixel * off
        prior = Prior(heading_deg=heading, heading_range_deg=TOLD_HEADING_DEG, pixel_size_range=sizes)
    if kind == OTHER_HALF:
        if OTHER_HALF not in grounds:
            grounds[OTHER_HALF] = ground.known_elsewhere()
        image, ground = replace(image, query=replace(image.query, is_of_map=False)), grounds[OTHER_HALF]
    return found_for(ground, image, prior, kind, noise)


def _ground(run: inputs.Run, area: str) -> Ground:
    if area == LIECHTENSTEIN:
        ground = Ground.of(run)
        ground.spoiled_values = BUILDINGS
        return ground
    if area in NEW_PLACES:
        database, labels = new_places.built(run, NEW_PLACES[area])
        return Ground(inputs.read_labels(labels), read_database(database, with_overview=True))
    labels = inputs.read_labels(two_dates.label_map(run, two_dates.AFTER))
    return Ground(labels, read_database(str(two_dates.database(run, 6400.0)), with_overview=True), run.half)


def _of_tile(run: inputs.Run, grounds: dict, noise: str, rng: np.random.Generator, number: int) -> Places | None:
    north, south = (tile_paths(run)[part] for part in (slice(3), slice(3, None)))
    paths = north if run.half == "north" else south
    path = paths[number % len(paths)]
    if path.stem not in grounds:
        grounds[path.stem] = tile_ground(path)
        grounds[path.stem].spoiled_values = BUILDINGS
    ground = grounds[path.stem]
    image = ground.draw(ON_A_TILE, rng)
    image = ground.spoiled(image, _in_pixels(noise, image.view.pixel_size * ground.meters), rng)
    return found_for(ground, image, ground.prior, OF_MAP, noise)


def _in_pixels(noise: str, pixel_m: float) -> LabelNoise:
    return NOISES[noise] if noise in IN_PIXELS else NOISES[noise].in_pixels(pixel_m)


def _spoiled(ground: Ground, image: Image, noise: str, meters: float, rng: np.random.Generator, share: float) -> Image:
    """The image with noise, which is stated for a map whose windows show 1,280 m."""
    spoiled = _in_pixels(noise, image.view.pixel_size * meters)
    smallest = max(ground.database.parameters.minimum_area / image.view.pixel_size**2, 1.0)
    donor = footprints.drawn(ground, share, rng).labels_hw if spoiled.spurious else None
    labels = spoil_labels(image.labels_hw, spoiled, rng, ground.spoiled_values, donor, smallest)
    return replace(image, labels_hw=labels)


# --- places ---


def found_for(ground: Ground, image: Image, prior: Prior | None, kind: str, noise: str) -> Places | None:
    """The places of an image and of the mirrored one, as the solver finds them."""
    pyramid, labels = ground.localizer.pyramid, np.ascontiguousarray(image.labels_hw)
    settings = pyramid.settings
    seen = places.image_evidence(labels, pyramid)
    if places.missing_information(places.reduced_image(seen, settings.coarse_edge), pyramid):
        return None
    sizes = ground.localizer.pixel_sizes(labels.shape, settings.scales)
    space = places.search_space(pyramid, prior or Prior(pixel_size_range=sizes))
    poses, chance = places.best_places(seen, pyramid, (space, None), settings.candidates)
    if not poses:
        return None
    size = poses[0].pixel_size_m
    near = places.near_size(space, size, settings), None
    mirrored, _ = places.best_places(mirrored_level(seen), pyramid, near, settings.decoys)
    own = [
        (chance.moved(pose.score, pose.pixel_size_m, size), *_detail_and_exactness(ground, image, seen, pose))
        for pose in poses
    ]
    decoys = [(pose.score, *_detail_and_exactness(ground, image, mirrored_level(seen), pose)) for pose in mirrored]
    return Places(kind, noise, own, decoys)


def _detail_and_exactness(
    ground: Ground, image: Image, seen: EvidenceLevel, pose: ScoredPose
) -> tuple[float, float, bool, float | None]:
    """Detail at a place, how far from the truth, whether it is close enough, and its radius, as ``Places`` has them."""
    pyramid = ground.localizer.pyramid
    detail = detail_at(places.reduced_image(seen, pyramid.settings.decision_edge), pyramid, pose)
    if _away(image, ground, pose) > 2 * RIGHT_SHARE and detail < PLAIN_DETAIL:
        # Nobody would take it for a fix, so that the time is saved.
        return detail, _away(image, ground, pose), True, None
    finest, covariance = places.finest_pose(seen, pyramid, pose)
    away = _away(image, ground, finest)
    if not np.isfinite(covariance).all():
        return detail, away, False, None
    spread = covariance_on_map(finest, covariance)[:2, :2]
    error_95 = decision.position_error_95(spread, pose.score, pyramid.frame.pixel_size, pyramid.settings)
    diagonal = math.hypot(*image.labels_hw.shape) * finest.pixel_size_m
    level = places.reduced_image(seen, pyramid.settings.decision_edge)
    is_held = is_held_by_edge(level, pyramid, finest, pyramid.quiet)
    is_exact = decision.exact_enough(error_95, diagonal, is_held, pyramid.settings)[0] is Status.FIX
    return detail, away, is_exact, error_95 / diagonal


def _away(image: Image, ground: Ground, pose: ScoredPose) -> float:
    """From the image's true place, share of its footprint."""
    if not image.query.is_of_map:
        return math.inf
    x, y = ground.localizer.pyramid.frame.origin
    return math.dist((x + pose.x, y - pose.y), image.view.position) / image.view.footprint


# --- verdicts ---


def judged(found: Places, settings: CorrelationSettings = CORRELATION) -> Iterator[reliability.Told]:
    """What is said of an image, of the same without its place where that was found, and of the mirrored image."""
    say = functools.partial(told, settings=settings)
    can_be_right = found.kind == OF_MAP
    yield say(found, found.own, found.mirrored, reliability.OF_MAP if can_be_right else found.kind)
    others = [place for place in found.own if place[2] >= CORRELATION.apart]
    if others and len(others) < len(found.own):
        yield say(found, others, found.mirrored, WITHOUT)
    # Coasts and streets resemble themselves in a mirror: no other ground, and in use the image itself refuses it.
    elsewhere = [place for place in found.mirrored if place[2] >= OWN_GROUND]
    if elsewhere:
        yield say(found, elsewhere, others, MIRRORED)


def told(
    found: Places, own: Sequence, decoys: Sequence, kind: str, settings: CorrelationSettings = CORRELATION
) -> reliability.Told:
    """What is said of places, the best of them first, against those that are none."""
    scored, unlike = ([tuple(place[:2]) for place in some] for some in (own, decoys))
    order, peaks = decision.ranked(scored, unlike, settings)
    _, _, off, is_exact, _ = own[order[0]]
    risk, is_right = decision.risk_of_peaks(peaks, settings), kind == OF_MAP and off <= RIGHT_SHARE
    return reliability.Told(
        kind, found.noise, 0, peaks.detail, decision.lead(peaks, settings), risk, is_right, False, is_exact, ""
    )
