"""Screenshots as small PNG files: a palette of the colors that are in the picture, fewer of them until it fits."""

from __future__ import annotations

import io
import sys
from pathlib import Path

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
        picture.quantize(count, dither=Image.Dither.NONE).save(content, "PNG", optimize=True)
        if content.tell() <= largest_bytes:
            break
    else:
        print(f"{target} has {content.tell() / 1000:.0f} kB, more than {largest_bytes / 1000:.0f}", file=sys.stderr)
    target.write_bytes(content.getvalue())
