"""Write screenshots as small PNG files with a palette, with fewer colors until the size fits."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageOps, UnidentifiedImageError

COLOR_COUNTS = (256, 192, 128, 96, 64)
FRAME_GRAY = 160

SWATCH_PIXELS = 60
"""Number of pixels from which a color belongs to a symbol, a button or a text, not to a blend in a map."""

NEAR, MOST_KEPT = 6.0, 32
"""Number of colors far from the palette that replace its rarest colors."""


def shrink(source: Path, target: Path, largest_bytes: int) -> None:
    """Write the picture with a palette and a thin frame; use fewer colors if it is larger than the limit.

    The frame is one gray pixel. Without it a light window has no visible border on a light page.
    """
    try:
        picture = Image.open(source).convert("RGB")
    except UnidentifiedImageError:
        raise ValueError(f"{source} is not a picture") from None
    picture.paste(ImageOps.expand(picture.crop((1, 1, picture.width - 1, picture.height - 1)), 1, (FRAME_GRAY,) * 3))
    for count in COLOR_COUNTS:
        content = io.BytesIO()
        picture.quantize(palette=_palette(picture, count), dither=Image.Dither.NONE).save(content, "PNG", optimize=True)
        if content.tell() <= largest_bytes:
            break
    else:
        print(
            f"{target} has {content.tell() / 1000:.0f} kB; the limit is {largest_bytes / 1000:.0f} kB", file=sys.stderr
        )
    target.write_bytes(content.getvalue())


def _palette(picture: Image.Image, count: int) -> Image.Image:
    """Return a palette with the given number of colors, including those of legend symbols.

    The weight of a color is the square root of its frequency. Colors of symbols that would still be missing replace the
    rarest colors.
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
