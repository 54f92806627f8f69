"""Prepare a real place for the walk: orthophoto, map of buildings, and photos of the ground next to it.

The orthophoto is the western half of the place. The photos are cut from the eastern half, at any heading and at 0.9–1.1
of the scale. The map covers both halves.
"""

import csv
import shutil
from pathlib import Path
from typing import NamedTuple

import cv2
import numpy as np
from osgeo import gdal

from sample.photo import turned

gdal.UseExceptions()

SEED, COUNT = 1671, 12
EDGE_PX, SCALES = 640, (0.9, 1.1)
QUALITY = 92


class RealPlace(NamedTuple):
    """Name at the start of a sentence, paths in the folder of the real data, attribution that the licenses require."""

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


def fill(ground: RealPlace, data: Path, folder: Path) -> None:
    """Write orthophoto.tif, buildings.gpkg, photos and photos.csv."""
    source = gdal.Open(str(data / ground.photo))
    width, height, place = source.RasterXSize, source.RasterYSize, source.GetGeoTransform()
    half = width // 2
    options = ["TILED=YES", "COMPRESS=JPEG", "PHOTOMETRIC=YCBCR", f"JPEG_QUALITY={QUALITY}"]
    gdal.Translate(str(folder / "orthophoto.tif"), source, srcWin=[0, 0, half, height], creationOptions=options)
    shutil.copy(data / ground.polygons, folder / "buildings.gpkg")
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
            heading, scale = np.degrees(random.uniform(0, 2 * np.pi)), random.uniform(*SCALES)
            name = f"photo_{number:02d}.jpg"
            shown = turned(pixels, (column, row), heading, scale, (EDGE_PX, EDGE_PX))
            cv2.imwrite(str(photos / name), shown[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, QUALITY])
            rows.writerow([name, *(round(at, 3) for at in gdal.ApplyGeoTransform(place, column, row))])
