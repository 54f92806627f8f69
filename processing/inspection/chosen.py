"""Checks of the selected images and database before a localization; for background threads."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass

from ...core.errors import DatabaseInUseError
from ..jobs.image_results import has_photos


@dataclass(frozen=True)
class ChosenImages:
    """Images in files and folders.

    Attributes:
        has_photos: Whether some are photos, by their names or their colors.
    """

    count: int = 0
    has_photos: bool = False


def count_images(paths: Sequence[str]) -> ChosenImages:
    """Count the images and check whether they are photos.

    Raises:
        ImageError: A folder has no images, or cannot be read.
    """
    from ...storage.rasters import image_files

    files = image_files(list(paths))
    return ChosenImages(len(files), has_photos(files))


def require_database(path: str) -> None:
    """Open a reference database and check that it has its tables.

    Raises:
        DatabaseError: It is missing or damaged, or another kind of file.
    """
    from ...storage.database.connection import snapshot

    # Another program will release it soon.
    with contextlib.suppress(DatabaseInUseError), snapshot(path):
        pass
