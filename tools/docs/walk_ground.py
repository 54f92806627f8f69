"""Prepare a real place for the walk: orthophoto, map of buildings, and photos of the ground next to it.

The orthophoto is the western half of the place. The photos are cut from the eastern half, at any heading and at 0.9–1.1
of the scale. The map covers both halves.
"""

from __future__ import annotations

import csv
import shutil
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from osgeo import gdal

SEED, COUNT = 1671, 12
EDGE_PX, SCALES = 640, (0.9, 1.1)
QUALITY = 92


@dataclass(frozen=True)
class RealPlace:
    """Paths of a place in the folder of the real data.

    Attributes:
        name: Name at the start of a sentence.
        photo: Path of the orthophoto.
        polygons: Path of the buildings.
        credit: Attribution that the licenses require.
    """

    name: str
    photo: str
    polygons: str
    credit: str


PLACES = {
    "banepa": RealPlace(
        "Banepa, Nepal",
        "banepa/banepa_photo.tif",
        "banepa/banepa_buildings.gpkg",
        "Orthophoto: OpenAerialMap, CC BY 4.0. Buildings: © OpenStreetMap contributors, ODbL. Published by HOTOSM.",
    ),
    "uganda": RealPlace(
        "A village in Uganda",
        "oam_buildings/uganda_1.tif",
        "oam_buildings/uganda_buildings.gpkg",
        "Orthophoto: OpenAerialMap, CC BY 4.0. Buildings: © OpenStreetMap contributors, ODbL.",
    ),
}


def lacks(place: RealPlace, data: Path) -> str:
    """Return a message about missing data; empty if everything exists."""
    missing = [name for name in (place.photo, place.polygons) if not (data / name).is_file()]
    return f"Not walked: there is no {missing[0]} in {data}." if missing else ""


def fill(place: RealPlace, data: Path, folder: Path) -> None:
    """Write orthophoto.tif, buildings.gpkg, photos and photos.csv."""
    source = gdal.Open(str(data / place.photo))
    width, height = source.RasterXSize, source.RasterYSize
    half = width // 2
    orthophoto = gdal.Translate(
        str(folder / "orthophoto.tif"),
        source,
        srcWin=[0, 0, half, height],
        creationOptions=["TILED=YES", "COMPRESS=JPEG", "PHOTOMETRIC=YCBCR", f"JPEG_QUALITY={QUALITY}"],
    )
    if orthophoto is None:
        raise RuntimeError(gdal.GetLastErrorMsg())
    # Closing the dataset writes it.
    del orthophoto
    shutil.copy(data / place.polygons, folder / "buildings.gpkg")
    pixels = np.ascontiguousarray(np.moveaxis(source.ReadAsArray()[:3], 0, 2))
    photos = folder / "photos"
    photos.mkdir()
    random = np.random.default_rng(SEED)
    margin = EDGE_PX * max(SCALES) * 0.71 + 2
    with (folder / "photos.csv").open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["image", "x", "y"])
        for number in range(1, COUNT + 1):
            column, row = random.uniform((half + margin, margin), (width - margin, height - margin))
            turn, scale = random.uniform(0, 2 * np.pi), random.uniform(*SCALES)
            name = f"photo_{number:02d}.jpg"
            shown = _cut(pixels, (column, row), turn, scale)
            cv2.imwrite(str(photos / name), shown[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, QUALITY])
            x0, across, _, y0, _, down = source.GetGeoTransform()
            rows.writerow([name, round(x0 + column * across, 3), round(y0 + row * down, 3)])


def _cut(pixels: np.ndarray, center: tuple[float, float], turn: float, scale: float) -> np.ndarray:
    """Return a photo (EDGE_PX, EDGE_PX, 3) around a place (column, row)."""
    across = scale * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    # Pixel corners have whole-number coordinates; in OpenCV, pixel centers have.
    first = np.array(center) - 0.5 - across @ np.full(2, (EDGE_PX - 1) / 2)
    inverse = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    return cv2.warpAffine(pixels, np.column_stack([across, first]), (EDGE_PX, EDGE_PX), flags=inverse)
