"""What the maker of a network states about it, and known makers' statements."""

from __future__ import annotations

from dataclasses import dataclass

from ..errors import ModelError


@dataclass(frozen=True)
class NetworkFacts:
    """What the maker of a network states about it.

    Attributes:
        classes: Class of each output; empty for outputs that are not used. Outputs of the same class are merged.
        resolution_m: Meters per pixel of its training images.
        mean: (red, green, blue) of pixels in 0…1.
        std: (red, green, blue) of pixels in 0…1.
        name: For the list of models; may be empty.
        threshold: Probability from which a pixel has the class, for networks with one output.
    """

    classes: tuple[str, ...]
    resolution_m: float
    mean: tuple[float, ...] = (0.0, 0.0, 0.0)
    std: tuple[float, ...] = (1.0, 1.0, 1.0)
    license: str = ""
    name: str = ""
    threshold: float = 0.5


FLAIR = NetworkFacts(
    (
        *("building", "bare land", "road", "bare land", "water", "trees", "trees", "low vegetation", "field"),
        *("low vegetation", "field", "field", "water", "bare land", "", "", "", "building", ""),
    ),
    0.2,
    (0.4121, 0.4348, 0.3993),
    (0.2046, 0.1780, 0.1725),
    "Etalab 2.0, © IGN",
    "FLAIR-INC, RGB",
)
"""IGN's networks FLAIR-INC RGB with 15 of 19 outputs: building, pervious and impervious surface, bare soil, water,
coniferous, deciduous, brushwood, vineyard, herbaceous vegetation, agricultural land, plowed land, swimming pool, snow,
clear cut, mixed, ligneous, greenhouse, other (github.com/IGNF/FLAIR-1; the 15th to 17th and the last are not used)."""

BUILDINGS = NetworkFacts(("building",), 0.3, (0.485, 0.456, 0.406), (0.229, 0.224, 0.225), name="Buildings")
"""Networks with the probability of buildings as their output; standardization of encoders trained on ImageNet."""


def require_facts(facts: NetworkFacts) -> None:
    """Raise ModelError for a statement that is missing or impossible."""
    if not any(facts.classes):
        raise ModelError("Enter the class of each output of the network.")
    if not facts.resolution_m:
        raise ModelError("Enter the resolution of the images that the network was trained on.")
    if len(facts.mean) != 3 or len(facts.std) != 3 or not min(facts.std) > 0:
        raise ModelError("Mean and standard deviation have three numbers, for red, green and blue; deviations above 0.")
    if not facts.license.strip():
        raise ModelError("Enter the license of the network, as its maker states it; “unknown” if there is none.")
