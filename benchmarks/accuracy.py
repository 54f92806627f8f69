"""Measure accuracy: draw, localize and judge the images of a scenario's rows, and write tables.

``Row`` lists map, images, noise and prior of a row. Each image has its own seed. Its record is a line of a file in the
work folder, so a later run with a larger count continues. Records of other code are not used.
"""

from __future__ import annotations

import hashlib
import json
import math
import sys
import zlib
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks import foreign, photos
from benchmarks.ground import Ground, Image, Wanted
from benchmarks.maps import NoDataError, World
from benchmarks.network_errors import NetworkNoise
from benchmarks.results import ROOT, Table, rate
from semref.core.correlation.decision import lead
from semref.core.evaluation.summary import percentile
from semref.core.evaluation.trial import RIGHT_SHARE, Trial
from semref.core.geometry.error_settings import NETWORK_SPREAD, UNBIASED, ClassBias, KnownBiases
from semref.core.geometry.leveling import Attitude, focal_length_from_view, leveling
from semref.core.localization import Method, Prior
from semref.core.simulation.noise import DISPLACED_M, LabelNoise
from semref.core.simulation.views import View

NETWORK = NetworkNoise(missed_below=200.0, split_length=40.0)
GOAL = NetworkNoise(missed=0.2, spurious=0.2, mislabeled=0.05, jitter=1.5)
NOISES = {
    "none": NetworkNoise(),
    "goal": GOAL,
    "hard": replace(GOAL, missed=0.4, spurious=0.4, mislabeled=0.1),
    "harder": replace(GOAL, missed=0.6, spurious=0.6, mislabeled=0.15),
    "patches": replace(GOAL, patches=0.35, patch_size=150.0),
    # Networks that are usable and poor; the first one as seen on aerial tiles with an IoU of buildings near 0.5.
    "modest": replace(NETWORK, merge_gap=6, split=0.2, jitter=3, jitter_length=9, patches=0.15, thin=4, missed=0.15),
    "strong": replace(NETWORK, merge_gap=10, split=0.4, jitter=6, jitter_length=18, patches=0.35, thin=8, missed=0.4),
}
"""Noises in pixels of the image, except those of networks."""

OF_NETWORKS = ("modest", "strong")
"""Noises in meters, for a map with pixels of 1 m and windows of 1,280 m."""

BUILDINGS = (1,)
STATED_SPREAD_M = 0.2
AT_95 = math.sqrt(-2 * math.log(0.05))


@dataclass(frozen=True)
class MapRow:
    """Images or flights of one kind.

    Attributes:
        name: Name of the row.
        database: Name of the map for the database.
        images: Name of the map from which images are cut; empty for the same map.
        half: Half of the map with the image centers: north, south or empty.
        noise: One of NOISES.
        leaning: Shift of roofs, as a share of the distance from the center.
        foreign: Kind of images of other places (``foreign.KINDS``, ``mirrored``, ``other half``); empty for the map's.
        heading_known_deg: Largest error of the known heading; 0 for unknown.
        count: Number of images or flights.
        photos: ``sample``, ``tileN``, or a place and the number of its photo (``kenya.1``); empty for labels.
        network: Part of the name of the network in --models; empty for the shipped network.
        labels: Labels of photos, ``network`` or ``true``.
        maps_other: Whether the map of a photo's place has the class “other”, besides buildings.
        other_km2: Area of buildings of another country that the map of a photo's place also has.
        wanted: Kind of views, as ``ground.Wanted``.
    """

    name: str
    database: str = "liechtenstein"
    images: str = ""
    half: str = "south"
    noise: str = "goal"
    leaning: float = 0.0
    foreign: str = ""
    heading_known_deg: float = 0.0
    count: int = 200
    photos: str = ""
    network: str = ""
    labels: str = "network"
    maps_other: bool = True
    other_km2: float = 0.0
    wanted: dict[str, Any] = field(default_factory=dict)

    def ground(self, world: World) -> Ground:
        """Return the ground of the images."""
        return world.ground(self.database, self.images, self.half)

    def known(self, ground: Ground) -> Ground:
        """Return the ground with the database to localize images in."""
        return ground.known_elsewhere() if self.foreign == "other half" else ground

    def heading(self, view: View, rng: np.random.Generator) -> dict[str, float]:
        """Return the part of a prior that states the heading."""
        if not self.heading_known_deg:
            return {}
        off = rng.uniform(-1, 1) * self.heading_known_deg
        return {"heading_deg": (view.heading_deg + off) % 360, "heading_range_deg": self.heading_known_deg}


@dataclass(frozen=True)
class Row(MapRow):
    """Images of one kind.

    Attributes:
        method: Key of the method.
        jitter: Boundary jitter in pixels instead of that of the noise.
        displaced: Whether the map is displaced like maps of another date.
        shift_m: Shift of all buildings in a random direction.
        stated: Whether the localizer knows this shift.
        prior_share: Radius of the prior position, as a share of the footprint; 0 for no prior.
        size_known: Largest error of the known pixel size, 0.2 for 20 %; 0 for unknown.
        level_error_deg: Error of the known roll and pitch; negative for an image that is not leveled.
        part_km2: Area of a part of the map to use as a small map, in the middle of its landmarks; 0 for the whole map.
        right_m: A position is right within this distance; 0 for 2 % of the footprint.
        places: Text that the places of the images follow from, for rows that show the same ones; empty for the name.
    """

    method: str = "automatic"
    jitter: float = -1.0
    displaced: bool = False
    shift_m: float = 0.0
    stated: bool = False
    prior_share: float = 0.0
    size_known: float = 0.0
    level_error_deg: float = -1.0
    part_km2: float = 0.0
    right_m: float = 0.0
    places: str = ""


def rows_of(scenario: dict[str, Any], kind: type[MapRow] = Row) -> list[Any]:
    """Return the rows of a scenario; ``each`` repeats every row with other values: {method = [...], noise = [...]}."""
    defaults = scenario.get("defaults", {})
    rows = [{**defaults, **row} for row in scenario["row"]]
    for key, values in scenario.get("each", {}).items():
        rows = [{**row, key: value, "name": f"{row['name']}, {value}"} for row in rows for value in values]
    for row in rows:
        if "wanted" in row:
            row["wanted"] = {**defaults.get("wanted", {}), **row["wanted"]}
    return [kind(**row) for row in rows]


def measure(rows: Sequence[MapRow], only: Sequence[str], measured: Callable[[Any], Any]) -> dict[str, Any]:
    """Return the result of the chosen rows by name; print and skip rows without data."""
    found = {}
    for row in rows:
        if only and not any(part.casefold() in row.name.casefold() for part in only):
            continue
        try:
            found[row.name] = measured(row)
        except (NoDataError, ValueError) as error:
            print(f"  {row.name}: not measured: {error}", file=sys.stderr, flush=True)
    return found


def run(world: World, name: str, scenario: dict[str, Any], only: Sequence[str]) -> list[Table]:
    """Measure the rows of a scenario and return its tables; ``total`` adds the sum of rows with this text."""
    found = measure(rows_of(scenario), only, partial(records, world, name))
    columns = scenario.get("columns", list(COLUMNS))
    tables = [{"columns": ["images", *columns], "rows": [[row, *cells(some, columns)] for row, some in found.items()]}]
    together = [one for some in found.values() for one in some]
    if "total" in scenario and found:
        summed = [one for row, some in found.items() if scenario["total"] in row for one in some]
        tables[0]["rows"].append(["all", *cells(summed, columns)])
    if scenario.get("reliability") and found:
        tables += [curve(together), by_risk(together), costs(found)]
    return tables


# --- records ---


def records(world: World, scenario: str, row: Row) -> list[dict]:
    """Return the record of each image of a row, from the work folder or measured now."""
    count, key = world.count or row.count, _key(row)
    path = world.work / "records" / f"{scenario}_{zlib.crc32(row.name.encode()):08x}.jsonl"
    path.parent.mkdir(parents=True, exist_ok=True)
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    kept = [json.loads(line) for line in lines[1:]] if lines and json.loads(lines[0])["key"] == key else []
    if not kept:
        path.write_text(json.dumps({"key": key, "row": row.name}) + "\n", encoding="utf-8")
    if len(kept) < count:
        source = Source(world, row)
        with path.open("a", encoding="utf-8") as file:
            for number in range(len(kept), count):
                kept.append(source.record(number))
                file.write(json.dumps(kept[-1]) + "\n")
                file.flush()
    some = kept[:count]
    shown = [row.name, *cells(some, ("right fixes", "wrong fixes", "95 %"))]
    print("  " + " | ".join(shown), file=sys.stderr, flush=True)
    return some


def _key(row: Row) -> str:
    """Return a hash of the row and of all code that affects its figures."""
    digest = hashlib.sha256(json.dumps(asdict(row), sort_keys=True).encode())
    for folder in (ROOT / "core", Path(__file__).parent):
        for path in sorted(folder.rglob("*.py")):
            digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


class Source:
    """The images of a row and their localizer."""

    def __init__(self, world: World, row: Row) -> None:
        self.row = row
        self.method = next(one for one in Method if one.key == row.method)
        self.photos = photos.of(world, row) if row.photos else None
        self.ground: Ground = self.photos.ground if self.photos else row.ground(world)
        if row.part_km2:
            self.ground = self.ground.part(row.part_km2)
        self.known = row.known(self.ground)
        self.wanted = Wanted(**{k: tuple(v) if isinstance(v, list) else v for k, v in row.wanted.items()})
        self.world = world

    def record(self, number: int) -> dict[str, Any]:
        """Draw an image, add noise, localize it and judge the result."""
        rng = np.random.default_rng([zlib.crc32((self.row.places or self.row.name).encode()), number])
        trial = self._tried(self.image(rng, number), rng)
        return told_of(trial, self.row)

    def image(self, rng: np.random.Generator, number: int) -> Image:
        """Return an image, and what the localizer knows about its labels."""
        row, ground = self.row, self.ground
        if self.photos is not None:
            return self.photos.image(rng, number)
        if row.foreign and row.foreign not in ("other half", "mirrored"):
            return foreign.KINDS[row.foreign](self, rng, number)
        wanted = replace(self.wanted, is_mirrored=row.foreign == "mirrored")
        image = ground.draw(wanted, rng, is_of_map=row.foreign != "other half")
        noise, biases = self.noise(image.view, rng)
        image = ground.spoiled(image, noise, rng, BUILDINGS if row.noise in OF_NETWORKS else ())
        return replace(image, seen=replace(image.seen, biases=biases))

    def noise(self, view: View, rng: np.random.Generator) -> tuple[NetworkNoise, KnownBiases]:
        """Return the noise of an image in its pixels, and the part of it that the localizer knows."""
        row, pixel = self.row, view.pixel_size
        noise = NOISES[row.noise]
        if row.noise in OF_NETWORKS:
            noise = noise.in_pixels(pixel * 1280.0 / self.ground.database.parameters.window_size)
        if row.jitter >= 0:
            noise = replace(noise, jitter=row.jitter)
        shared, biases = LabelNoise(displaced=DISPLACED_M if row.displaced else 0.0), UNBIASED
        if row.shift_m:
            angle = rng.uniform(0, 2 * np.pi)
            right, down = row.shift_m * np.cos(angle), row.shift_m * np.sin(angle)
            shared = replace(shared, class_shifts=((BUILDINGS[0], right, down),))
            bias = ClassBias(BUILDINGS[0], right=right, down=down, spread=STATED_SPREAD_M)
            biases = KnownBiases((bias,)) if row.stated else KnownBiases(class_spread=NETWORK_SPREAD)
        if row.leaning:
            shared = replace(shared, leaning=row.leaning, leaning_classes=BUILDINGS)
        # Shared errors have the same size on the ground in every image.
        shared = shared.in_pixels(pixel)
        names = ("displaced", "displaced_kernels", "class_shifts", "leaning", "leaning_classes")
        return replace(noise, **{name: getattr(shared, name) for name in names}), biases

    def _tried(self, image: Image, rng: np.random.Generator) -> Trial:
        view, localizer = image.view, self.known.localizer
        prior, level = self.prior(view, rng), None
        if self.row.level_error_deg >= 0:
            focal = focal_length_from_view(view.field_of_view_deg, view.shape_hw)
            attitude = attitude_of(view, rng.normal(0, self.row.level_error_deg, 2))
            level = leveling(attitude, focal, view.shape_hw)
            scales = localizer.settings.constellation.limits.scales
            prior = prior or Prior(pixel_size_range=localizer.pixel_sizes(view.shape_hw, scales))
        return self.known.try_image(image, self.method, prior, level, self.row.right_m or None)

    def prior(self, view: View, rng: np.random.Generator) -> Prior | None:
        """Return the prior of an image from camera and user."""
        row, known = self.row, {}
        if row.prior_share:
            radius = row.prior_share * view.footprint
            off = rng.uniform(-0.5, 0.5, 2) * radius
            known |= {"position": (view.x + off[0], view.y + off[1]), "radius": radius}
        if row.size_known:
            off = 1 + row.size_known
            known["pixel_size_range"] = (view.pixel_size / off, view.pixel_size * off)
        elif self.photos is not None and self.photos.searched:
            known["pixel_size_range"] = self.photos.searched
        known |= row.heading(view, rng)
        return Prior(**known) if known else None


def attitude_of(view: View, errors_deg: np.ndarray) -> Attitude:
    """Return roll and pitch of a view with errors."""
    tilt, direction = np.radians((view.tilt_deg, view.tilt_direction_deg))
    pitch = np.arcsin(np.sin(tilt) * np.cos(direction))
    roll = np.arctan2(np.sin(tilt) * np.sin(direction), np.cos(tilt))
    return Attitude(float(np.degrees(roll) + errors_deg[0]), float(np.degrees(pitch) + errors_deg[1]))


def told_of(trial: Trial, row: Row) -> dict[str, Any]:
    """Return the record of one image, with values for JSON only."""
    found, query = trial.result, trial.query
    best = found.best
    off = math.inf if best is None else math.dist(best.position, query.view.position)
    within = row.right_m or RIGHT_SHARE * query.view.footprint
    record = {
        "status": str(trial.status.key),
        "place": query.view.position,
        "by": str(found.method.key),
        "right": trial.is_right,
        "wrong": trial.is_wrong,
        "of_map": query.can_be_right,
        "best_right": query.can_be_right and off <= within,
        "risk": found.risk,
        "error": trial.error,
        "share": None if trial.error is None else trial.error / query.view.footprint,
        "ratio": trial.radius_ratio,
        "radius": found.error_95_m,
        "heading": trial.heading_error_deg,
        "scale": trial.scale_error,
        "log_odds": None if best is None else best.log_odds,
        "rival": max(found.mirror_log_odds or 0.0, found.runner_up_log_odds or -math.inf),
        "lead": None if found.peaks is None else lead(found.peaks),
        "detail": None if found.peaks is None else found.peaks.detail,
        "outlines": None if found.peaks is None else found.peaks.outlines,
    }
    return {key: _plain(value) for key, value in record.items()}


def _plain(value: Any) -> Any:
    value = value.item() if isinstance(value, np.generic) else value
    return None if isinstance(value, float) and not math.isfinite(value) else value


# --- tables ---


def cells(some: Sequence[dict], columns: Sequence[str]) -> list[str]:
    """Return the cells of a row, one per column of COLUMNS."""
    return [COLUMNS[column](some) for column in columns]


def _refused(some: Sequence[dict]) -> str:
    counts = Counter(one["status"] for one in some if not one["right"] and not one["wrong"])
    return ", ".join(f"{count} {status}" for status, count in sorted(counts.items())) or "0"


def _errors(some: Sequence[dict]) -> str:
    right = [one for one in some if one["right"]]
    if not right:
        return "–"
    error, share = (percentile([one[name] for one in right], 50) for name in ("error", "share"))
    heading, scale = (percentile([one[name] for one in right], 50) for name in ("heading", "scale"))
    text = f"{error:.2f} m ({100 * share:.3f} %)"
    return text if heading is None else f"{text}, {heading:.3f}°, {100 * scale:.3f} %"


def _held(share: float) -> Any:
    most = math.sqrt(-2 * math.log(1 - share))

    def column(some: Sequence[dict]) -> str:
        ratios = [one["ratio"] for one in some if one["right"] and one["ratio"] is not None]
        return rate(sum(ratio * AT_95 <= most for ratio in ratios), len(ratios))

    return column


def _radius(some: Sequence[dict]) -> str:
    right = [one for one in some if one["right"] and one["radius"] is not None]
    if not right:
        return "–"
    return f"{np.median([one['radius'] for one in right]):.2f} m, {np.median([one['error'] for one in right]):.2f} m"


def _ways(some: Sequence[dict]) -> str:
    counts = Counter(one["by"] for one in some if one["right"])
    return ", ".join(str(counts[one.key]) for one in (Method.CONSTELLATION, Method.MAP_CORRELATION))


COLUMNS = {
    "right fixes": lambda some: rate(sum(one["right"] for one in some), sum(one["of_map"] for one in some)),
    "wrong fixes": lambda some: rate(sum(one["wrong"] for one in some), len(some)),
    "no fix": _refused,
    "likely": lambda some: rate(sum(one["status"] == "likely" for one in some), len(some)),
    "best place right, fix or not": lambda some: rate(sum(one["best_right"] for one in some), len(some)),
    "right by constellation, by map correlation": _ways,
    "median error, heading, scale": _errors,
    "in the 50 % ellipse": _held(0.5),
    "95 %": _held(0.95),
    "99 %": _held(0.99),
    "median 95 % radius, error": _radius,
    "smallest risk": lambda some: f"{min((one['risk'] for one in some if one['risk'] is not None), default=1.0):.2g}",
}
"""Return the cell of a column for the records of a row. The first column is the row's name."""

RISKS = (0.5, 0.2, 1e-2, 1e-3, 1e-4, 1e-6)
DECADES = (1.0, 0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 0.0)


def _risky(some: Sequence[dict]) -> Iterator[tuple[float, bool]]:
    """Return (stated error probability, whether the best place is right) of each record."""
    return ((1.0 if one["risk"] is None else one["risk"], one["best_right"]) for one in some)


def curve(some: Sequence[dict]) -> Table:
    """Return a table by tenths of the stated probability, with the expected calibration error."""
    pairs, rows, error = list(_risky(some)), [], 0.0
    for tenth in range(10):
        chosen = [(1 - risk, right) for risk, right in pairs if min(int(10 * (1 - risk)), 9) == tenth]
        if chosen:
            mean, right = float(np.mean([p for p, _ in chosen])), sum(right for _, right in chosen)
            error += len(chosen) / len(pairs) * abs(mean - right / len(chosen))
            rows.append([f"{tenth / 10:.1f}–{tenth / 10 + 0.1:.1f}", f"{mean:.3f}", rate(right, len(chosen))])
    rows.append(["expected calibration error", f"{error:.3f}", ""])
    return {"columns": ["stated probability", "mean", "right"], "rows": rows}


def by_risk(some: Sequence[dict]) -> Table:
    """Return the wrong places by stated error probability, and the sum of the error probabilities."""
    pairs, rows = list(_risky(some)), []
    for high, low in zip(DECADES, DECADES[1:]):
        chosen = [(risk, right) for risk, right in pairs if low < risk <= high or risk == low == 0]
        if chosen:
            wrong = sum(not right for _, right in chosen)
            rows.append([f"{low:g}–{high:g}", f"{sum(r for r, _ in chosen):.2g}", rate(wrong, len(chosen))])
    return {"columns": ["stated risk", "wrong expected", "wrong"], "rows": rows}


def costs(found: dict[str, list[dict]]) -> Table:
    """Return the positions at each maximum error probability, by row: right; wrong."""
    rows = []
    for name, some in found.items():
        line = []
        for allowed in RISKS:
            passed = [right for risk, right in _risky(some) if risk <= allowed]
            line.append(f"{rate(sum(passed), len(some))}; {len(passed) - sum(passed)} wrong")
        rows.append([name, *line])
    return {"columns": ["right at RISK", *(f"{allowed:g}" for allowed in RISKS)], "rows": rows}
