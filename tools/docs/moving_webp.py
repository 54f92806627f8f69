"""Join frames from the screen to one small animation (WebP), with lower quality until the size fits."""

from __future__ import annotations

import io
import re
import sys
from pathlib import Path

from PIL import Image

QUALITIES = (80, 70, 60, 50, 40, 30)
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
    """Write the frames as one animation that repeats."""
    pictures = [Image.open(path).convert("RGB") for path in frames]
    # The size of a window can change with its contents.
    pictures = [picture.crop((0, 0, *pictures[0].size)) for picture in pictures]
    shown_ms = [int(_FRAME.fullmatch(path.name)["shown_ms"]) for path in frames]
    for quality in QUALITIES:
        content = io.BytesIO()
        options = {"save_all": True, "append_images": pictures[1:], "duration": shown_ms, "loop": 0, "method": 6}
        pictures[0].save(content, "WEBP", quality=quality, **options)
        if content.tell() <= largest_bytes:
            break
    else:
        print(
            f"{target} has {content.tell() / 1000:.0f} kB; the limit is {largest_bytes / 1000:.0f} kB", file=sys.stderr
        )
    target.write_bytes(content.getvalue())
