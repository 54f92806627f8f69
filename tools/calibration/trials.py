"""The trials of tools/calibration, each a function of a run that gives Markdown."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from bench import inputs, localization, page, reliability
from bench.automatic import CASES as AUTOMATIC_CASES
from bench.automatic import POOR_CASES
from bench.correlation import AERIAL, COUNTRY, ELSEWHERE, SEED, country, place_is_right, tried_on_tiles
from bench.ground import Case, Ground, Image, tried
from bench.tiles import tile_ground, tile_paths

from semref.core.constellation.settings import CONSTELLATION
from semref.core.correlation.decision import lead, position_error_95
from semref.core.correlation.places import finest_pose, image_evidence, reduced_image
from semref.core.correlation.refine import ScoredPose, axes, refine
from semref.core.correlation.settings import CORRELATION
from semref.core.correlation.solver import agreement_at
from semref.core.evaluation.trial import RIGHT_SHARE, Trial
from semref.core.localization import Method

FIX_SCORE = 0.38
"""Fixes have more: chance gives 0.25 and they lead by 0.13."""

AGREEMENT_COLUMNS = (
    "images",
    "constellation's best place",
    "its log odds",
    "class areas there",
    "map correlation's best place",
    "apart, in its radii",
)
QUANTILES = (0.5, 0.9, 0.95, 0.98)


# --- margins ---


def constellation(run: inputs.Run) -> str:
    """Rows of the localization bench, and how far right and wrong places are above their opponents."""
    ground = Ground.of(run)
    every = [t for _, trials in tried(run, ground, localization.CASES, run.count, localization.SEED) for t in trials]
    return margins(every, constellation_margin)


def correlation(run: inputs.Run) -> str:
    """Margins of map correlation with poor labels, what fits them, and the radius."""
    ground = country(run)
    found = [*tried(run, ground, COUNTRY, run.count, SEED)]
    found += tried(run, ground.known_elsewhere(), ELSEWHERE, run.count, SEED)
    found += tried_on_tiles(run, tile_paths(run), -(-run.count // 6))
    every = [t for _, trials in found for t in trials]
    right = [t for t in every if t.query.can_be_right and place_is_right(t)]
    return f"{margins(every, lambda t: lead(t.result.peaks))}\n\n{radius_table(map(_of_trial, right))}"


def constellation_margin(trial: Trial) -> float:
    """Log odds of the best place over those needed, the mirror's and the runner-up's, whichever is least."""
    found = trial.result
    least = CONSTELLATION.minimum_log_odds
    opponents = [least, *(odds for odds in (found.mirror_log_odds, found.runner_up_log_odds) if odds is not None)]
    return found.best.log_odds - max(opponents)


def margins(trials: Sequence[Trial], margin_of: Callable[[Trial], float]) -> str:
    """The highest margins of wrong places, the lowest of right ones, and the logistic curve that tells them apart."""
    posed = [t for t in trials if t.result.best is not None]
    is_right = np.array([t.query.can_be_right and place_is_right(t) for t in posed], bool)
    values = np.array([margin_of(t) for t in posed])
    offset, slope = logistic_fit(values, is_right.astype(float))
    return "\n".join(
        [
            f"wrong margins, highest: {np.round(np.sort(values[~is_right])[::-1][:8], 3)} of {(~is_right).sum()}",
            f"right margins, lowest: {np.round(np.sort(values[is_right])[:12], 3)} of {is_right.sum()}",
            f"confidence curve: offset {offset:.2f}, slope {slope:.2f}",
        ]
    )


def logistic_fit(x: np.ndarray, y: np.ndarray, steps: int = 50) -> np.ndarray:
    """Offset and slopes of the logistic curve of (N,) or (N, K), lightly damped: separable data give finite slopes."""
    design = np.column_stack([np.ones(len(x)), x])
    weights = np.zeros(design.shape[1])
    for _ in range(steps):
        chance = 1 / (1 + np.exp(-np.clip(design @ weights, -30, 30)))
        normal = (design * (chance * (1 - chance))[:, None]).T @ design + 1e-3 * np.eye(len(weights))
        weights += np.linalg.solve(normal, design.T @ (y - chance) - 1e-3 * weights)
    return weights


# --- radius ---


@dataclass(frozen=True)
class Refined:
    """A pose and its truth: correlation, error, standard deviation along the longer axis and 95 % radius, map units."""

    score: float
    error: float
    deviation: float
    error_95: float


def radius(run: inputs.Run) -> str:
    """Poses refined from beside the right place, as the search leaves them, without the search."""
    grounds = [("Liechtenstein", country(run), COUNTRY[:2])]
    grounds += [(path.stem, tile_ground(path), AERIAL[1:3]) for path in tile_paths(run)]
    text = []
    for name, ground, cases in grounds:
        for case in cases:
            if not run.wants(name):
                continue
            rng = np.random.default_rng([SEED, 95])
            found = [refined(ground, case, rng) for _ in range(run.count)]
            kept = [one for one, footprint in found if one.error <= RIGHT_SHARE * footprint and one.score > FIX_SCORE]
            text += [f"{name}: {case.name}, right {page.rate(len(kept), len(found))}", radius_table(kept)]
    return "\n\n".join(text)


def refined(ground: Ground, case: Case, rng: np.random.Generator) -> tuple[Refined, float]:
    """One image's pose, from beside the right place; the image's footprint."""
    image = ground.draw(case.wanted, rng)
    view = image.view
    spoiled = ground.spoiled(image, case.noise.in_pixels(view.pixel_size * ground.meters), rng)
    pyramid = ground.localizer.pyramid
    settings, evidence = pyramid.settings, image_evidence(spoiled.labels_hw, pyramid)
    step = view.footprint / settings.coarse_edge
    off = rng.uniform(-0.5, 0.5, 4) * (step, step, settings.turn_step_deg, 1)
    pixel = view.pixel_size * settings.scale_step ** off[3]
    # Right and down of the map's corner.
    x, y = view.x - pyramid.frame.origin[0], pyramid.frame.origin[1] - view.y
    pose = ScoredPose(x + off[0], y + off[1], view.heading_deg + off[2], pixel)
    for edge in (settings.coarse_edge, settings.decision_edge):
        pose = refine(reduced_image(evidence, edge), pyramid, pose, pyramid.quiet, 4)
    finest, covariance = finest_pose(evidence, pyramid, pose)
    spread = axes(finest) @ covariance[:2, :2] @ axes(finest).T
    error = float(np.hypot(finest.x - x, finest.y - y))
    overview = pyramid.frame.pixel_size
    return Refined(
        pose.score, error, _deviation(spread), position_error_95(spread, pose.score, overview)
    ), view.footprint


def _of_trial(trial: Trial) -> Refined:
    found = trial.result
    error = float(np.hypot(*np.subtract(found.best.position, trial.query.view.position)))
    return Refined(found.best.score, error, _deviation(np.array(found.covariance.position)), found.error_95_m)


def _deviation(covariance: np.ndarray) -> float:
    return float(np.sqrt(max(np.linalg.eigvalsh(covariance).max(), 0.0)))


def radius_table(found: Iterable[Refined]) -> str:
    """Errors in units of deviation × noise, which ``error_factor`` bounds, and how many the 95 % radius holds."""
    found = list(found)
    if not found:
        return "No right place."
    least = CORRELATION.least_noise
    ratios = [one.error / one.deviation / max(1 / one.score**2 - 1, least) for one in found]
    held = page.rate(sum(one.error <= one.error_95 for one in found), len(found))
    quantiles = ", ".join(f"{q:.0%}: {value:.2f}" for q, value in zip(QUANTILES, np.quantile(ratios, QUANTILES)))
    return f"error over deviation × noise, quantiles {quantiles}; 95 % radius holds {held}"


# --- agreement ---


def agreement(run: inputs.Run) -> str:
    """Correlation of class areas at the constellation's best places; how far both roads' places are apart."""
    rows = []
    for cases, ground in ((AUTOMATIC_CASES, Ground.of(run)), (POOR_CASES, country(run))):
        for number, case in enumerate(cases):
            if not run.wants(case.name):
                continue
            rng = np.random.default_rng([SEED, 7, number])
            rows += [[case.name, *_evidence(ground, case, rng)] for _ in range(run.count)]
    return page.table(AGREEMENT_COLUMNS, rows)


def _evidence(ground: Ground, case: Case, rng: np.random.Generator) -> list[str]:
    image: Image = ground.draw(case.wanted, rng)
    noise = case.noise.in_pixels(image.view.pixel_size) if case.in_meters else case.noise
    image = ground.spoiled(image, noise, rng)
    stars, areas = (ground.try_image(image, method) for method in (Method.CONSTELLATION, Method.MAP_CORRELATION))
    cells = ["right" if t.query.can_be_right and place_is_right(t) else "wrong" for t in (stars, areas)]
    one, other = stars.result.best, areas.result.best
    if one is None:
        return ["none", "–", "–", cells[1] if other else "none", "–"]
    agrees = agreement_at(image.labels_hw, ground.localizer.pyramid, one)
    apart = "–"
    if other is not None and areas.result.error_95_m:
        apart = f"{np.hypot(*np.subtract(one.position, other.position)) / areas.result.error_95_m:.2f}"
    told = "–" if agrees is None else f"{agrees:.2f}"
    return [cells[0], f"{one.log_odds:.1f}", told, cells[1] if other else "none", apart]


# --- probability ---


def probability(run: inputs.Run) -> str:
    """Log odds of right and of wrong places with their strongest rivals', and the curve of the constellation's risk."""
    ground, rng = Ground.of(run), np.random.default_rng([SEED, 10])
    other = ground.known_elsewhere()
    told = [reliability.country(ground, other, rng, n // reliability.PART) for n in range(run.count)]
    told = [one for one in told if np.isfinite(one.log_odds)]
    is_right = np.array([one.is_right for one in told])
    leads = np.array([one.log_odds - CONSTELLATION.rival_weight * max(one.rival, 0.0) for one in told])
    scale = CONSTELLATION.confidence_scale
    grown = np.where(leads > 0, scale * np.log1p(np.maximum(leads, 0) / scale), leads)
    offset, slope = logistic_fit(grown, is_right.astype(float))
    twos = [reliability.two_places(ground, rng) for _ in range(run.count // 10)]
    said = "localization.one_side_elsewhere"
    whole = [one for one in told if one.is_right]
    return "\n".join(
        [
            f"wrong log odds, highest: {np.sort([one.log_odds for one in told if not one.is_right])[::-1][:8].round(1)}"
            f" of {(~is_right).sum()}",
            f"right log odds, lowest: {np.sort([one.log_odds for one in whole])[:12].round(1)} of {is_right.sum()}",
            f"risk: offset {offset:.2f}, slope {slope:.2f}",
            f"told as of two places: {page.rate(sum(one.reason == said for one in twos), len(twos))} that are, "
            f"{page.rate(sum(one.reason == said for one in whole), len(whole))} that are not",
        ]
    )
