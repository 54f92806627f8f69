"""Checks of the selected images and database before a localization; for background threads."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass

from ...core.errors import DatabaseInUseError

TIMES_READ = 12
"""Largest number of photos whose times are read, spread evenly over all photos in order of name."""

LONGEST_PAUSE_S = 600.0
"""Longest pause between two photos of a flight, for each image between them."""

LEAST_OF_FLIGHT = 3
"""Smallest number of images of a flight."""


@dataclass(frozen=True)
class ChosenImages:
    """Images in files and folders.

    Attributes:
        count: Number of images.
        has_photos: Whether some are photos, by their names or their colors.
        flight: ``count`` if they look like the photos of one flight; otherwise 0.
    """

    count: int = 0
    has_photos: bool = False
    flight: int = 0


def count_images(paths: Sequence[str]) -> ChosenImages:
    """Count the images and check whether they are photos.

    Raises:
        LabelMapError: A folder has no images, or cannot be read.
    """
    from ...storage.rasters import image_files
    from ..base.localized_image import has_photos

    files = image_files(list(paths))
    return ChosenImages(len(files), has_photos(files), looks_like_flight(files))


def looks_like_flight(files: Sequence[str]) -> int:
    """Return the number of images if they look like those of one flight, otherwise 0. For background threads.

    They do if they have times in the order of their names, without a long pause.
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
    """Open a reference database and check that it has its tables.

    Raises:
        DatabaseError: It is missing or damaged, or another kind of file.
    """
    from ...storage.database.connection import snapshot

    # Another program will release it soon.
    with contextlib.suppress(DatabaseInUseError), snapshot(path):
        pass
