"""Screenshots as small PNG files: a palette of the colors that are in the picture, fewer of them until it fits."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageOps, UnidentifiedImageError

COLOR_COUNTS = (256, 192, 128, 96, 64)
FRAME_GRAY = 160

SWATCH_PIXELS = 60
"""A color that is so often there is one of a swatch, a button or a text, not a shade of a map in between."""

NEAR, MOST_KEPT = 6.0, 32
"""Of the colors that are farther from the palette, so many take the place of its rarest ones."""


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
        picture.quantize(palette=_palette(picture, count), dither=Image.Dither.NONE).save(content, "PNG", optimize=True)
        if content.tell() <= largest_bytes:
            break
    else:
        print(f"{target} has {content.tell() / 1000:.0f} kB, more than {largest_bytes / 1000:.0f}", file=sys.stderr)
    target.write_bytes(content.getvalue())


def _palette(picture: Image.Image, count: int) -> Image.Image:
    """A palette of so many of its colors, those of a legend's swatches among them.

    A color counts as often as the root of how often it is there; those of swatches that are still lost to the shades of
    a map replace the colors that are used least.
    """
    colors, counts = np.unique(np.asarray(picture).reshape(-1, 3), axis=0, return_counts=True)
    row = np.repeat(colors, np.ceil(np.sqrt(counts)).astype(int), axis=0)
    found = Image.fromarray(row[np.newaxis]).quantize(count)
    palette = np.array(found.getpalette()[: 3 * count], np.float64).reshape(-1, 3)
    offsets = np.stack([((palette - color) ** 2).sum(axis=1) for color in colors.astype(np.float64)])
    nearest, distances = offsets.argmin(axis=1), np.sqrt(offsets.min(axis=1))
    lost = np.flatnonzero((counts >= SWATCH_PIXELS) & (distances > NEAR))
    lost = lost[np.argsort(-distances[lost], kind="stable")][:MOST_KEPT]
    used = np.bincount(nearest, counts, minlength=len(palette))
    palette[np.argsort(used, kind="stable")[: len(lost)]] = colors[lost]
    found.putpalette(palette.astype(np.uint8).ravel().tolist())
    return found
