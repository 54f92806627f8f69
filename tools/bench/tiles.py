"""The annotated tiles of Dubai (dubai_aerial) as ground for simulated images and photos."""

from __future__ import annotations

from pathlib import Path

from bench import inputs
from bench.ground import Ground, memory_ground
from semref.core.localization import Prior

TILE_SCALES, TILE_SEARCHED = (0.9, 1.1), (0.7, 1.4)
"""Pixels of the tile an image's pixel shows: true, and looked for."""

TILE_PIXEL_M = 0.5
"""Assumed; the tiles state none."""


def tile_paths(run: inputs.Run) -> list[Path]:
    """Annotated label maps, none where the data is not here."""
    return sorted((run.data / inputs.TILES).glob("tile*_label.tif"))


def tile_ground(path: Path) -> Ground:
    """An annotated tile with a database of it, all classes as landmarks."""
    from semref.core.database.build import BuildSettings

    ground = memory_ground(inputs.read_labels(path), inputs.TILE_CLASSES, BuildSettings(512, 128, 60))
    ground.prior, ground.meters = Prior(pixel_size_range=TILE_SEARCHED), TILE_PIXEL_M
    return ground
