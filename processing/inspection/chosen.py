"""What is wrong with what the user chose, before anything is localized; for background threads."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ...core.errors import DatabaseError
from .flight import looks_like_flight

LOOKED_AT = 5
"""Images whose colors are counted, at most, where their names do not say that they are photos."""


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


def look_at_images(paths: Sequence[str]) -> ChosenImages:
    """Count the images and look whether they are photos.

    Raises:
        LabelMapError: A folder has no images, or can't be read.
    """
    from ...storage.label_images import has_photo_colors
    from ...storage.rasters import image_files
    from ..framework.localized_image import is_photo

    files = image_files(list(paths))
    has_photos = any(map(is_photo, files)) or any(map(has_photo_colors, files[:LOOKED_AT]))
    return ChosenImages(len(files), has_photos, looks_like_flight(files))


def require_database(path: str) -> None:
    """Open a reference database and check that its tables are there.

    Raises:
        DatabaseError: It is missing or damaged, or another kind of file.
    """
    from ...storage.database.connection import snapshot

    try:
        with snapshot(path):
            pass
    except DatabaseError as error:
        # Another program will be done with it soon.
        if error.sentence.code != "storage.database_in_use":
            raise
