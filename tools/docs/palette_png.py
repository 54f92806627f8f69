"""Screenshots as small PNG files: a palette of the colors that are in the picture, fewer of them until it fits."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageOps, UnidentifiedImageError

COLOR_COUNTS = (256, 192, 128, 96, 64)
FRAME_GRAY = 160


def shrink(source: Path, target: Path, largest_bytes: int) -> None:
    """Writes the picture with a thin frame and a palette; with fewer colors when it would be larger than that.

    One gray pixel around it: without a frame a light window runs into a light page.
    """
    try:
        picture = Image.open(source).convert("RGB")
    except UnidentifiedImageError:
        raise ValueError(f"{source} is no picture") from None
    picture.paste(ImageOps.expand(picture.crop((1, 1, picture.width - 1, picture.height - 1)), 1, (FRAME_GRAY,) * 3))
    for count in COLOR_COUNTS:
        content = io.BytesIO()
        picture.quantize(palette=_seen(picture).quantize(count), dither=Image.Dither.NONE).save(
            content, "PNG", optimize=True
        )
        if content.tell() <= largest_bytes:
            break
    else:
        print(f"{target} has {content.tell() / 1000:.0f} kB, more than {largest_bytes / 1000:.0f}", file=sys.stderr)
    target.write_bytes(content.getvalue())


def _seen(picture: Image.Image) -> Image.Image:
    """Its colors in a row, each as often as the root of how often it is there.

    By how often alone, the colors of a legend's swatches would be lost to the shades of a map.
    """
    colors, counts = np.unique(np.asarray(picture).reshape(-1, 3), axis=0, return_counts=True)
    row = np.repeat(colors, np.ceil(np.sqrt(counts)).astype(int), axis=0)
    return Image.fromarray(row[np.newaxis])
