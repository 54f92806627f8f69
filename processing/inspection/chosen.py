"""What is wrong with what the user chose, before anything is localized; for background threads."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass

from ...core.errors import DatabaseInUseError

LOOKED_AT = 5
"""Images whose colors are counted, at most, where their names do not say that they are photos."""

TIMES_READ = 12
"""Photos whose times are read, at most: evenly among all of them, in the order of their names."""

LONGEST_PAUSE_S = 600.0
"""Between two photos of a flight, for each image from one looked at to the next."""

LEAST_OF_FLIGHT = 3
"""Images that make a flight worth the name."""


@dataclass(frozen=True)
class ChosenImages:
    """Images in files and folders.

    Attributes:
        has_photos: Whether some are photos, by their names or their colors.
        flight: ``count`` if they look like the photos of one flight; otherwise 0.
    """

    count: int = 0
    has_photos: bool = False
    flight: int = 0


def count_images(paths: Sequence[str]) -> ChosenImages:
    """Count the images and look whether they are photos.

    Raises:
        LabelMapError: A folder has no images, or can't be read.
    """
    from ...storage.label_images import has_photo_colors
    from ...storage.rasters import image_files
    from ..base.localized_image import is_photo

    files = image_files(list(paths))
    has_photos = any(map(is_photo, files)) or any(map(has_photo_colors, files[:LOOKED_AT]))
    return ChosenImages(len(files), has_photos, looks_like_flight(files))


def looks_like_flight(files: Sequence[str]) -> int:
    """How many images there are, if they look like those of one flight; else 0.

    Photos tell when they were taken; they do when names and times have one order and no pause is long. For background
    threads.
    """
    from ...core.labels.photo_camera import photo_camera
    from ..base.flight_images import by_name

    files = sorted(files, key=by_name)
    if len(files) < LEAST_OF_FLIGHT:
        return 0
    step = max(1, len(files) // TIMES_READ)
    times_s = [photo_camera(path).time_s for path in files[::step]]
    if any(time_s is None for time_s in times_s):
        return 0
    pauses = [after - before for before, after in zip(times_s, times_s[1:])]
    return len(files) if all(0 <= pause <= step * LONGEST_PAUSE_S for pause in pauses) else 0


def require_database(path: str) -> None:
    """Open a reference database and check that its tables are there.

    Raises:
        DatabaseError: It is missing or damaged, or another kind of file.
    """
    from ...storage.database.connection import snapshot

    # Another program will be done with it soon.
    with contextlib.suppress(DatabaseInUseError), snapshot(path):
        pass
