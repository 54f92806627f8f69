"""Whether images look like those of one flight: photos that were taken one after the other."""

from __future__ import annotations

from collections.abc import Sequence

LOOKED_AT = 12
"""Photos whose times are read, at most: evenly among all of them, in the order of their names."""

LONGEST_PAUSE_S = 600.0
"""Between two photos of a flight, for each image from one looked at to the next."""

LEAST = 3
"""Images that make a flight worth the name."""


def looks_like_flight(files: Sequence[str]) -> int:
    """How many images there are, if they look like those of one flight; else 0.

    Photos tell when they were taken; they do when names and times have one order and no pause is long. For background
    threads.
    """
    from ...core.labels.photo_camera import photo_camera
    from ..framework.flight_images import by_name

    files = sorted(files, key=by_name)
    if len(files) < LEAST:
        return 0
    step = max(1, len(files) // LOOKED_AT)
    times_s = [photo_camera(path).time_s for path in files[::step]]
    if any(time_s is None for time_s in times_s):
        return 0
    pauses = [after - before for before, after in zip(times_s, times_s[1:])]
    return len(files) if all(0 <= pause <= step * LONGEST_PAUSE_S for pause in pauses) else 0
