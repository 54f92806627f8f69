"""The published method on real data: the main job, on windows, turned, scaled, off the grid, from elsewhere."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from sample.files import rasterize
from sample.landscape import make_landscape

from bench import causes, inputs, main_job, on_windows, page
from bench.ground import SEED, Ground
from bench.page import share
from semref.core.evaluation.summary import percentile
from semref.core.evaluation.trial import Trial
from semref.core.localization import Status
from semref.core.localizer.localizer import DescribedImage, Localizer
from semref.core.simulation.views import PIXELS, View, cut

PAGE = "published_method.md"

ROTATIONS_DEG = tuple(range(0, 360, 30))
SCALES = (2.0, 1.8, 1.5, 1.2, 1.0, 0.8, 0.75, 0.65, 0.6, 0.5)

PAPER_SCALES = {
    2.0: (2.674882, 0.0),
    1.8: (1.650056, 0.17),
    1.5: (1.404390, 0.30),
    1.2: (0.209932, 0.90),
    1.0: (0.0, 1.0),
    0.8: (0.086993, 0.96),
    0.75: (0.151239, 0.92),
    0.65: (0.276655, 0.86),
    0.6: (0.303107, 0.85),
    0.5: (2.720949, 0.0),
}
"""Table 4 of the paper: scale → distance, confidence, of its one image 5950_2100."""

PAPER_ROTATIONS = {
    0: (0.0, 1.0),
    30: (0.031209, 0.98),
    60: (0.103701, 0.95),
    90: (0.000403, 1.0),
    120: (0.059721, 0.97),
    150: (0.108878, 0.95),
    180: (0.000754, 1.0),
    210: (0.044473, 0.98),
    240: (0.10018, 0.95),
    270: (0.000679, 1.0),
    300: (0.0421, 0.98),
    330: (0.107759, 0.95),
}
"""Table 5 of the paper, the same for rotations in degrees."""

WINDOW_COUNT = 100
MOVES_PER_WINDOW = 10
ELSEWHERE_COUNT = 200
LANDSCAPES = 10
LANDMARK_GROUPS = ((3, 5), (6, 9), (10, 19), (20, 10**9))


def measure(run: inputs.Run) -> dict[str, str]:
    sections = {"main job": main_job.measure(run)}
    ground = Ground.of(run, half="")
    windows = ground.choose_windows(WINDOW_COUNT if not run.quick else 10)
    sections["on windows"] = on_windows.measure(run, ground, windows)
    turned = {h: [ground.try_vector(ground.view_on(w, heading_deg=h)) for w in windows] for h in ROTATIONS_DEG}
    alone = {h: [try_alone(ground, ground.view_on(w, heading_deg=h)) for w in windows] for h in ROTATIONS_DEG}
    more = {"right if nothing came into view, and median distance": alone}
    sections["rotation"] = _transformed("rotation", turned, PAPER_ROTATIONS, "{}°", more)
    scaled = {s: [ground.try_vector(ground.view_on(w, scale=s)) for w in windows] for s in SCALES}
    known = {s: [try_with_ground_area(ground, ground.view_on(w, scale=s)) for w in windows] for s in SCALES}
    more = {"right if the scale were known, and median distance": known}
    sections["scale"] = _transformed("view radius", scaled, PAPER_SCALES, "{:g} ×", more)
    sections["landmarks"] = _by_landmarks(ground, windows, turned, scaled)
    sections["causes"] = causes.measure(ground, windows)
    sections["off the grid"] = _off_grid(ground, windows)
    sections["elsewhere"] = _elsewhere(run, ground)
    sections["other data"] = main_job.other_data(run)
    return sections


def _transformed(what: str, found: dict, paper: dict, form: str, more: dict[str, dict]) -> str:
    """One row a rotation or scale; `more`: other ways to treat the same views, of which the share found is told."""
    header = [
        what,
        "paper: distance",
        "paper: confidence",
        "median distance",
        "median confidence",
        "right window",
        "accepted (d ≤ 2)",
        "accepted, wrong",
        "too few landmarks",
    ]
    rows = []
    for value, results in found.items():
        number = len(results)
        wrong = sum(t.is_wrong for t in results)
        confidence = percentile([t.result.confidence for t in results], 50)
        row = [form.format(value), f"{paper[value][0]:.3f}", f"{paper[value][1]:.2f}"]
        row += [f"{median_distance(results):.3f}", f"{confidence:.2f}"]
        row += [share(rights(results), number), share(sum(t.is_fix for t in results), number), share(wrong, number)]
        row.append(sum(t.status is Status.TOO_FEW_REFERENCES for t in results))
        for other in more.values():
            row.append(f"{share(rights(other[value]), number)}, d {median_distance(other[value]):.3f}")
        rows.append(row)
    return page.table([*header, *more], rows)


def _by_landmarks(ground: Ground, windows: np.ndarray, turned: dict, scaled: dict) -> str:
    """Right windows by how many landmarks the window has."""
    landmarks = ground.database.windows.counts[windows]
    every = ground.database.windows.counts[ground.database.windows.described]
    cases = {
        # A further quarter turn gives the same result, so that more rotations would only count these twice.
        "rotation 30° and 60°": [turned[h] for h in (30, 60)],
        "view radius 1.2 and 0.8 ×": [scaled[s] for s in (1.2, 0.8)],
        "view radius 1.5 and 0.65 ×": [scaled[s] for s in (1.5, 0.65)],
    }
    rows = []
    for low, high in LANDMARK_GROUPS:
        inside = np.flatnonzero((landmarks >= low) & (landmarks <= high))
        row = [f"{low}–{high}" if high < 10**9 else f"≥ {low}", len(inside), _percent((every >= low) & (every <= high))]
        for results in cases.values():
            chosen = [group[i] for group in results for i in inside]
            row.append(share(rights(chosen), len(chosen)) if chosen else "–")
        rows.append(row)
    return page.table(["landmarks in the window", "of the 100", "of all windows with a vector", *cases], rows)


def _percent(mask: np.ndarray) -> str:
    return f"{100 * mask.mean():.0f} %"


def _off_grid(ground: Ground, windows: np.ndarray) -> str:
    rng = np.random.default_rng([SEED, 1])
    half = _half_stride_px(ground)
    cases: dict[str, list[Trial]] = {}
    moves = rng.uniform(-half, half, (MOVES_PER_WINDOW, len(windows), 2))
    headings = rng.uniform(0, 360, (MOVES_PER_WINDOW, len(windows)))

    def views(round_: int, turned: bool):
        for k, window in enumerate(windows):
            yield ground.view_on(window, headings[round_, k] if turned else 0.0, 1.0, moves[round_, k])

    cases["moved, any heading"] = [ground.try_vector(v) for v in views(0, True)]
    cases["moved, north up"] = [ground.try_vector(v) for v in views(0, False)]
    more = [ground.try_vector(v) for n in range(1, MOVES_PER_WINDOW) for v in views(n, True)]
    cases[f"moved {MOVES_PER_WINDOW} times each, any heading"] = cases["moved, any heading"] + more
    farthest = np.hypot(half, half) * ground.frame.pixel_size
    half_m = half * ground.frame.pixel_size
    header = [
        "",
        "images",
        "right window",
        "within 10 m",
        f"within {half_m:g} m",
        "accepted (d ≤ 2)",
        f"wrong but accepted (> {farthest:.0f} m off)",
        "median error of accepted",
    ]
    rows = []
    for name, results in cases.items():
        accepted = [t for t in results if t.is_fix]
        number = len(results)
        rows.append(
            [
                name,
                number,
                share(rights(results), number),
                *(share(sum(t.error <= limit for t in accepted), number) for limit in (10, half_m)),
                share(len(accepted), number),
                share(sum(t.error > farthest for t in accepted), number),
                f"{percentile([t.error for t in accepted], 50) or np.nan:,.0f} m",
            ]
        )
    return page.table(header, rows)


def _elsewhere(run: inputs.Run, ground: Ground) -> str:
    cases = {
        f"sample area, {LANDSCAPES} landscapes": _sample_crops(ground, run.area.name == "sample"),
        f"{run.area.name}, mirrored": _mirrored_crops(ground),
    }
    header = ["images from", "images", "too few landmarks", "accepted (d ≤ 2)", "median distance", "median confidence"]
    rows = []
    for name, crops in cases.items():
        results = [ground.localizer.localize_by_topology_vector(labels) for labels in crops]
        distances = [r.distance for r in results if r.distance is not None]
        accepted = [r for r in results if r.is_fix]
        few = sum(r.status is Status.TOO_FEW_REFERENCES for r in results)
        rows.append(
            [
                name,
                len(results),
                few,
                share(len(accepted), len(results)),
                f"{np.median(distances):.2f} ({min(distances):.2f}–{max(distances):.2f})",
                f"{np.median([r.confidence for r in accepted]):.2f}" if accepted else "–",
            ]
        )
    return page.table(header, rows)


def _sample_crops(ground: Ground, map_is_first: bool) -> Iterator[np.ndarray]:
    """Images of made-up landscapes, any place and heading, with the reference classes' values as on the real map.

    `map_is_first`: the map itself is the first of these landscapes, so that elsewhere begins with the second.
    """
    rng = np.random.default_rng([SEED, 2])
    reach = ground.size_px / np.sqrt(2) + 2
    for number in range(LANDSCAPES):
        labels = rasterize(make_landscape(SEED + map_is_first + number), ground.frame.pixel_size)
        for _ in range(ELSEWHERE_COUNT // LANDSCAPES):
            column, row = rng.uniform(reach, np.subtract(labels.shape[::-1], reach))
            view = View(column, -row, rng.uniform(0, 360), 1.0, ground.size_px, ground.size_px)
            yield cut(labels, PIXELS, view)


def _mirrored_crops(ground: Ground) -> Iterator[np.ndarray]:
    """Images of the same ground as a mirror shows it, any heading: they lie nowhere on the map."""
    rng = np.random.default_rng([SEED, 3])
    half = _half_stride_px(ground)
    for window in ground.choose_windows(ELSEWHERE_COUNT):
        view = ground.view_on(window, rng.uniform(0, 360), 1.0, rng.uniform(-half, half, 2))
        yield ground.cut(replace(view, is_mirrored=True))


def _half_stride_px(ground: Ground) -> float:
    return round(ground.database.parameters.stride / ground.frame.pixel_size) / 2


def try_alone(ground: Ground, view: View) -> Trial:
    """The window's own picture turned: its corners are lost, 0 comes in their place."""
    half = ground.size_px / 2
    column, row = (round(float(part) - half) for part in ground.frame.to_pixels(view.position))
    window = ground.labels_hw[row : row + ground.size_px, column : column + ground.size_px]
    alone = replace(view, x=half, y=-half, pixel_size=1.0)
    return ground.try_vector(view, cut(window, PIXELS, alone))


def try_with_ground_area(ground: Ground, view: View) -> Trial:
    """The minimum area is measured on the ground, as if the image's scale were known."""

    class KnownScale(Localizer):
        def describe(self, labels_hw: np.ndarray, window_size: float) -> DescribedImage:
            return super().describe(labels_hw, window_size * view.pixel_size / ground.frame.pixel_size)

    return ground.try_vector(view, localizer=KnownScale(ground.database))


def rights(trials: Sequence[Trial]) -> int:
    """How many are right."""
    return sum(t.is_right for t in trials)


def median_distance(trials: Sequence[Trial]) -> float:
    """Between topology vectors, of those that have one."""
    found = percentile([t.result.distance for t in trials], 50)
    return np.nan if found is None else found
