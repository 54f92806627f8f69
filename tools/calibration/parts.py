"""How well the parts of images of one place, and of two, agree with the map where map correlation has a fix."""

from __future__ import annotations

import cv2
import numpy as np
from bench import inputs
from bench.correlation import ON_THE_MAP
from bench.elsewhere_automatic import Source, spoiled, two_places
from bench.ground import GOAL, Ground, Image

from semref.core.correlation.parts import agreeing_parts
from semref.core.correlation.places import image_evidence, reduced_image
from semref.core.correlation.refine import ScoredPose
from semref.core.localization import Localization, Method
from semref.core.simulation.noise import STRONG

SEED = 77
ONE, POOR, TWO = "one place, 20 / 20 / 5 %", "one place, poor network", "two places, 20 / 20 / 5 %"


def parts(run: inputs.Run) -> str:
    """The least agreeing part of each fix, as a share of the whole image's agreement, with its energies."""
    cv2.setNumThreads(1)
    ground = Ground.of(run)
    source = Source(ground, ground, ())
    lines = []
    for number, kind in enumerate((ONE, POOR, TWO)):
        if not run.wants(kind):
            continue
        rng, found, told = np.random.default_rng([SEED, number]), [], 0
        for _ in range(run.how_many(60, 2)):
            image = _image(source, kind, rng)
            result = ground.try_image(image, Method.MAP_CORRELATION).result
            if result.is_fix:
                told += result.reason is not None
                found.append(_least(ground, image, result))
        lines.append(f"{kind}: {len(found)} fixes of {run.how_many(60, 2)} images, {told} say what they don't hold for")
        lines += [f"  {share:.2f} of the whole's, energies {low:.2f}, {high:.2f}" for share, low, high in sorted(found)]
    return "\n".join(lines)


def _image(source: Source, kind: str, rng: np.random.Generator) -> Image:
    if kind == TWO:
        return two_places(source, rng, 0)[1]
    image = source.ground.draw(ON_THE_MAP, rng)
    return spoiled(source.ground, image, STRONG if kind == POOR else GOAL, kind == POOR, rng)


def _least(ground: Ground, image: Image, result: Localization) -> tuple[float, float, float]:
    """(share of the whole's agreement, energies) of the part that agrees least."""
    pyramid, place = ground.localizer.pyramid, result.place
    x, y = place.position[0] - pyramid.frame.origin[0], pyramid.frame.origin[1] - place.position[1]
    level = reduced_image(image_evidence(image.labels_hw, pyramid), pyramid.settings.decision_edge)
    whole, found = agreeing_parts(level, pyramid, ScoredPose(x, y, *place.oriented))
    least = min(found, key=lambda part: part.agreement)
    return least.agreement / whole, *least.energies
