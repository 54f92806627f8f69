"""How far off single images measure when their place is about known, and which of several places is the right one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from bench import flights as bench
from bench import inputs, page
from bench.correlation import BUILDINGS
from bench.flown import draw
from bench.ground import Ground

from semref.core.correlation.places import image_evidence
from semref.core.flight.measurement import by_areas
from semref.core.flight.nearby import places_near
from semref.core.flight.settings import FLIGHT
from semref.core.flight.states import state_of
from semref.core.localization import Place
from semref.core.simulation.views import View

EDGES_M = (320.0, 450.0, 640.0)
NEAR, FAR = 0.02, 0.06
"""How far off images are expected to lie: deviation, share of the edge; for measuring, and for telling places apart."""

TURNED, GROWN = 0.02, 0.01
RIGHT = 0.03
"""A place within this share of the image's edge is the right one."""

COMPARISONS = (20, 40, 80, 150, 300)
UNSCALED = replace(FLIGHT, measured_factor=(1.0, 1.0, 0.0), gate=9.0, loosest=0.5)


def flights(run: inputs.Run) -> str:
    """Tables for ``measured_factor``, ``least_score`` and ``comparisons``."""
    ground = Ground.of(run)
    ground.spoiled_values = BUILDINGS
    rows, chosen = [], []
    for number, edge in enumerate(EDGES_M):
        kind = replace(bench.USUAL, ground_m=edge, step_m=edge / 3.2)
        off, apart = [], []
        for flight in range(run.count):
            rng = np.random.default_rng([bench.SEED, 7, number, flight])
            flown = draw(ground, kind, rng)
            for image, view in zip(flown.images, flown.views):
                off += _off(ground, image.labels_hw, view, rng)
                apart += _apart(ground, image.labels_hw, view, rng)
        far, scores = np.array(off).T
        cells = [f"{np.percentile(far, share):.2f}" for share in (50, 80, 95, 99)]
        poor = far[scores < FLIGHT.least_score]
        poor_cell = f"{len(poor)}: {np.median(poor):.2f}" if len(poor) else "–"
        rows.append([f"{edge:g} m", str(len(far)), *cells, poor_cell])
        likely = [sum(_log_share(scores, n) for scores in apart) for n in COMPARISONS]
        chosen.append([f"{edge:g} m", str(len(apart)), *(f"{value:.1f}" for value in likely)])
    names = ("ground", "images", "50 %", "80 %", "95 %", "99 %", "poor scores, median")
    text = "Errors over deviations that are not multiplied; 1.18, 1.79, 2.45 and 3.03 would be right:\n\n"
    text += page.table(names, rows) + "\n\nln of the right place's probability, by comparisons:\n\n"
    return text + page.table(("ground", "images", *map(str, COMPARISONS)), chosen)


def _expected(ground: Ground, view: View, share: float, rng: np.random.Generator) -> tuple[np.ndarray, ...]:
    truth = state_of(Place(view.position, view.heading_deg, view.pixel_size), ground.frame.origin)
    deviations = np.array([share * view.footprint] * 2 + [TURNED, GROWN])
    return truth, truth + rng.normal(0, deviations), np.diag((3 * deviations) ** 2)


def _off(ground: Ground, labels_hw: np.ndarray, view: View, rng: np.random.Generator) -> list[tuple[float, float]]:
    """Error over deviation, and score, of an image that measures."""
    truth, state, known = _expected(ground, view, NEAR, rng)
    found = by_areas(labels_hw, ground.localizer, state, known, replace(UNSCALED, least_score=0.0))
    if found is None or found.score is None:
        return []
    off = (found.state - truth)[:2]
    return [(float(np.sqrt(off @ np.linalg.solve(found.covariance[:2, :2], off))), found.score)]


def _apart(ground: Ground, labels_hw: np.ndarray, view: View, rng: np.random.Generator) -> list[np.ndarray]:
    """Scores of the right place and of the others near by; none where it, or another one, is not among them."""
    truth, state, known = _expected(ground, view, FAR, rng)
    image = image_evidence(np.ascontiguousarray(labels_hw), ground.localizer.pyramid)
    places = places_near(image, ground.localizer.pyramid, state, known, FLIGHT)
    far = np.array([np.hypot(pose.x - truth[0], -pose.y - truth[1]) for pose, _ in places])
    if len(far) < 2 or far.min() > RIGHT * view.footprint:
        return []
    scores = np.array([pose.score for pose, _ in places])
    return [np.append(scores[far.argmin()], np.delete(scores, far.argmin()))]


def _log_share(scores: np.ndarray, comparisons: float) -> float:
    """ln of the first one's probability."""
    odds = -0.5 * comparisons * np.log(1 - scores.clip(0, 0.999) ** 2)
    return float(odds[0] - odds.max() - np.log(np.exp(odds - odds.max()).sum()))
