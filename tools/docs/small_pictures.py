"""Write screenshots as small PNG files with a palette, and frames from the screen as one small animation (WebP)."""

import io
import re
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image, ImageOps, UnidentifiedImageError

COLOR_COUNTS = (256, 192, 128, 96, 64)
QUALITIES = (80, 70, 60, 50, 40, 30)
FRAME_GRAY = 160

SWATCH_PIXELS = 60
"""Number of pixels from which a color belongs to a symbol, a button or a text, not to a blend in a map."""

NEAR, MOST_KEPT = 6.0, 32
"""Number of colors far from the palette that replace its rarest colors."""

_FRAME = re.compile(r"(?P<name>.+)\.(?P<number>\d+)\.(?P<shown_ms>\d+)\.png")


def frame_name(name: str, number: int, shown_ms: int) -> str:
    """Return the file name of a frame."""
    return f"{name}.{number:03d}.{shown_ms}.png"


def films(pictures: list[Path]) -> dict[str, list[Path]]:
    """Return the ordered frames of each animation by its name, without other pictures."""
    found: dict[str, list[Path]] = {}
    for path in sorted(pictures):
        frame = _FRAME.fullmatch(path.name)
        if frame:
            found.setdefault(frame["name"], []).append(path)
    return found


def join(frames: list[Path], target: Path, largest_bytes: int) -> None:
    """Write the frames as one animation that repeats; use a lower quality if it is larger than the limit."""
    pictures = [Image.open(path).convert("RGB") for path in frames]
    # The size of a window can change with its contents.
    first, *others = [picture.crop((0, 0, *pictures[0].size)) for picture in pictures]
    shown_ms = [int(_FRAME.fullmatch(path.name)["shown_ms"]) for path in frames]
    options = {"format": "WEBP", "save_all": True, "append_images": others, "duration": shown_ms}
    options |= {"loop": 0, "method": 6}
    _write_small(target, largest_bytes, ((first, {"quality": quality, **options}) for quality in QUALITIES))


def shrink(source: Path, target: Path, largest_bytes: int) -> None:
    """Write the picture with a palette and a thin frame; use fewer colors if it is larger than the limit.

    The frame is one gray pixel. Without it a light window has no visible border on a light page.
    """
    try:
        picture = Image.open(source).convert("RGB")
    except UnidentifiedImageError:
        raise ValueError(f"{source} is not a picture") from None
    picture.paste(ImageOps.expand(picture.crop((1, 1, picture.width - 1, picture.height - 1)), 1, (FRAME_GRAY,) * 3))

    def with_colors(count: int) -> Image.Image:
        return picture.quantize(palette=_palette(picture, count), dither=Image.Dither.NONE)

    options = {"format": "PNG", "optimize": True}
    _write_small(target, largest_bytes, ((with_colors(count), options) for count in COLOR_COUNTS))


def _write_small(target: Path, largest_bytes: int, attempts: Iterable[tuple[Image.Image, dict[str, Any]]]) -> None:
    """Write the first picture that fits, or the last one. ``attempts``: pictures with options for saving."""
    for picture, options in attempts:
        content = io.BytesIO()
        picture.save(content, **options)
        if content.tell() <= largest_bytes:
            break
    else:
        print(f"{target}: {content.tell() / 1000:.0f} kB; the limit is {largest_bytes / 1000:.0f} kB", file=sys.stderr)
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
