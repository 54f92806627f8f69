"""Write screenshots as small PNG files with a palette, and frames from the screen as one small animation (WebP)."""

import re
import sys
from pathlib import Path

from PIL import Image, ImageOps

QUALITIES = (80, 70, 60, 50, 40, 30)
FRAME_GRAY = 160

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
    options = {"save_all": True, "append_images": others, "duration": shown_ms, "loop": 0, "method": 6}
    for quality in QUALITIES:
        first.save(target, quality=quality, **options)
        if target.stat().st_size <= largest_bytes:
            return
    print(f"{target} is larger than the limit of {largest_bytes / 1000:.0f} kB", file=sys.stderr)


def shrink(source: Path, target: Path) -> None:
    """Write the picture with a palette of 256 colors and a thin frame.

    The frame is one gray pixel. Without it a light window has no visible border on a light page.
    """
    picture = Image.open(source).convert("RGB")
    picture.paste(ImageOps.expand(picture.crop((1, 1, picture.width - 1, picture.height - 1)), 1, (FRAME_GRAY,) * 3))
    # This method has a color for each symbol, however small; others have more colors of the map.
    small = picture.quantize(method=Image.Quantize.MAXCOVERAGE, kmeans=3, dither=Image.Dither.NONE)
    small.save(target, optimize=True)
