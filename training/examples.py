"""Write pictures of validation tiles: photo, annotation and prediction."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np
import torch

from ..core.labels.class_table import LandCoverClass
from .tiles import TileReader, spread, standardized

EDGE_PX, GAP_PX, MOST = 256, 8, 4
UNKNOWN = (200, 200, 200)


def write_examples(
    network: torch.nn.Module, reader: TileReader, classes: Sequence[LandCoverClass], mean, deviation, folder: Path
) -> None:
    """Write example_N.png of some evenly spread tiles: photo, annotation and prediction side by side."""
    folder.mkdir(exist_ok=True)
    colors = np.full((256, 3), UNKNOWN, np.uint8)
    colors[: len(classes)] = [c.rgb for c in classes]
    network = network.cpu().eval()
    for number, index in enumerate(spread(len(reader), MOST)):
        image, labels = reader(index)
        with torch.inference_mode():
            found = network(torch.from_numpy(standardized(image, mean, deviation))).argmax(1)[0].numpy()
        shown = [np.clip(image * 255 + 0.5, 0, 255).astype(np.uint8), colors[labels], colors[found]]
        gap = np.full((EDGE_PX, GAP_PX, 3), 255, np.uint8)
        small = [cv2.resize(one, (EDGE_PX, EDGE_PX), interpolation=cv2.INTER_AREA) for one in shown]
        picture = np.hstack([small[0], gap, small[1], gap, small[2]])
        cv2.imwrite(str(folder / f"example_{number}.png"), np.ascontiguousarray(picture[:, :, ::-1]))
