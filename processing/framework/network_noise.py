"""How poor a network is taken to be where a comparison's report says so."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..reports.network_noise import read_network
from . import parameters

if TYPE_CHECKING:
    from .values import Values


def compared_network(values: Values) -> dict[str, float]:
    """What a comparison's report says of the network, by key; empty without one. Raises ParameterError."""
    path = values.file(parameters.COMPARISON)
    if not path:
        return {}
    return {key: number for key, number in read_network(path).items() if key in parameters.OF_NETWORKS}
