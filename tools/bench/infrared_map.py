"""Photos of 2019 on a map of 2012 that nobody drew: made of the near-infrared band, which the network never sees.

    .venv/bin/python tools/bench infrared_map --python PYTHON_WITH_TORCH [--count 40] [--write]

naip_north_dakota shows the same 4.7 × 3.6 km in both years. Indices of vegetation (NDVI) and water (NDWI) of 2012 make
the label map; a network learns it from red, green and blue of 2012, and is flown over the photos of 2019. The trained
model is kept in --work.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np

from bench import inputs, page
from bench.correlation import ON_A_TILE
from bench.ground import COLUMNS, Ground, Image, cells, memory_ground
from bench.own_ground import run_training
from bench.photos import Network, agreement, as_seen, seen
from semref.core.database.build import BuildSettings
from semref.core.labels.training_tiles import fitting_tiles
from semref.core.localization import Method, Prior
from semref.storage.rasters import RasterFile
from semref.storage.text_tables import read_class_table
from semref.storage.training_tiles import TileExport
from semref.training.job import LITE0, PACKAGED

PAGE = "benchmarks.md"
AREA = "naip_north_dakota."
SEED = 2012
COUNT, QUICK_COUNT = 40, 2
SIZES_PX = (192, 256, 320, 384)
PIXEL_M = 5.0
BEFORE, AFTER = "20120731", "20190904"
MINUTES, VALIDATION_FRACTION = 2.5, 0.15
NETWORK = {"encoder": LITE0, "encoder_weights": PACKAGED, "minutes": MINUTES, "resolution": PIXEL_M}
SETTINGS = BuildSettings(256, 64, 30)
SEARCHED = (0.7, 1.4)
WATER, VEGETATION, GROUND, WETLAND = 1, 2, 3, 4
CLASSES = (
    "value,name,color,role\n1,water,#1f4e9e,reference\n2,vegetation,#3a8f3a,background\n"
    "3,ground,#c8b070,background\n4,wetland,#6fc0c0,reference\n"
)
WATER_FROM, WETLAND_FROM, VEGETATION_FROM = 0.15, -0.05, 0.3
DARK_INFRARED = 140
"""Ripe fields have the wetness index of wetland, but are bright in the infrared."""

METHOD = Method.AUTOMATIC
SAME_DATE, OTHER_DATE, INDEX = "photos of 2012", "photos of 2019", "indices of 2019 instead of a network"


def measure(run: inputs.Run) -> dict[str, str]:
    before, after = (source(run, date) for date in (BEFORE, AFTER))
    if not (before.exists() and after.exists()):
        return {"infrared map": "Not measured: the real data is not here: naip_north_dakota"}
    ground = memory_ground(labels_of(inputs.read_labels(before)), CLASSES, SETTINGS)
    ground.prior, ground.meters = Prior(pixel_size_range=SEARCHED), PIXEL_M
    network = Network(trained(run, before, ground), ground)
    ground.localizer.heed_biases(*network.biases)
    pictures = {SAME_DATE: picture(before), OTHER_DATE: picture(after)}
    now = labels_of(inputs.read_labels(after))
    rows = []
    for number, edge in enumerate(SIZES_PX):
        rng = np.random.default_rng([SEED, number])
        wanted = replace(ON_A_TILE, sizes_px=(edge,), labeled=0.0, is_inside=True)
        images = [ground.draw(wanted, rng) for _ in range(run.how_many(COUNT, QUICK_COUNT))]
        shown = {
            name: [as_seen(one, network.seen(seen(ground, photo, one.view))) for one in images]
            for name, photo in pictures.items()
        }
        shown[INDEX] = [on_other_labels(ground, now, one) for one in images]
        for name, given in shown.items():
            case = f"{name}, {edge} px ({edge * PIXEL_M:.0f} m)"
            rows.append(cells([ground.try_image(one, METHOD) for one in given], case))
            print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    about = _ABOUT.format(minutes=MINUTES, sizes=", ".join(map(str, SIZES_PX)))
    return {"infrared map": f"{about}\n\n{page.table(COLUMNS, rows)}\n\n{_agreement(ground, now, network, pictures)}"}


_ABOUT = """\
A map of 2012 made of indices of its near-infrared band (water, wetland, vegetation, other ground), 934 × 723 pixels of
5 m; a network trained for {minutes} minutes of one processor on red, green and blue of 2012 of all of that ground;
turned crops of {sizes} px at 0.9–1.1 of the pixels, pixel size searched over 0.7–1.4; water and wetland as landmarks,
method automatic; errors in pixels. Right: within 2 % of the edge. Nobody drew this map: indices are what tells the
classes, and lakes that rose between the years are wrong on it. “{index}”: what the other date leaves to a network that
saw as they do.""".replace("{index}", INDEX)


def source(run: inputs.Run, date: str) -> Path:
    """The photo of a date, four bands."""
    return run.data / "naip_north_dakota" / f"m_4709963_se_14_1_{date}.tif"


def picture(path: Path) -> np.ndarray:
    """(H, W, 3) red, green, blue: all that a network is shown."""
    return np.ascontiguousarray(np.moveaxis(inputs.read_labels(path)[:3], 0, 2))


def labels_of(bands: np.ndarray) -> np.ndarray:
    """(H, W) uint8 classes by indices of (4, H, W) red, green, blue, near-infrared as published: stretched counts."""
    red, green, _, infrared = (cv2.GaussianBlur(band.astype(np.float32), (0, 0), 1) for band in bands)
    wetness, greenness = ((a - b) / (a + b + 1e-6) for a, b in ((green, infrared), (infrared, red)))
    labels = np.full(red.shape, GROUND, np.uint8)
    labels[greenness > VEGETATION_FROM] = VEGETATION
    labels[(wetness > WETLAND_FROM) & (infrared < DARK_INFRARED)] = WETLAND
    labels[wetness > WATER_FROM] = WATER
    return cv2.medianBlur(labels, 5)


def trained(run: inputs.Run, photo: Path, ground: Ground) -> Path:
    """The model, trained unless an earlier run left it."""
    model, tiles = run.work / "infrared_map.onnx", run.work / "infrared_map_tiles"
    if not model.exists():
        if not tiles.exists():
            cut_tiles(run.work, photo, ground.labels_hw, tiles)
        run_training(run, tiles, model, NETWORK)
    return model


def cut_tiles(work: Path, photo: Path, labels_hw: np.ndarray, tiles: Path) -> None:
    """Training tiles of the photo's first three bands and the labels, as semref:trainmodel cuts them."""
    from osgeo import gdal

    image, labels, table = (work / f"infrared_map_{name}" for name in ("image.tif", "labels.tif", "classes.csv"))
    gdal.Translate(str(image), str(photo), bandList=[1, 2, 3])
    like = gdal.Open(str(image))
    made = gdal.GetDriverByName("GTiff").Create(str(labels), like.RasterXSize, like.RasterYSize, 1)
    made.SetGeoTransform(like.GetGeoTransform())
    made.SetProjection(like.GetProjection())
    made.GetRasterBand(1).WriteArray(labels_hw)
    made = None  # GDAL writes it now
    table.write_text(CLASSES, encoding="utf-8")
    size, stride = fitting_tiles(labels_hw.shape)
    export = TileExport(RasterFile(str(image)), RasterFile(str(labels)), size, stride, VALIDATION_FRACTION)
    tiles.mkdir()
    for _ in export.steps(tiles, read_class_table(str(table))):
        pass


def on_other_labels(ground: Ground, labels_hw: np.ndarray, image: Image) -> Image:
    """What a view shows of other labels of the same ground."""
    known, ground.labels_hw = ground.labels_hw, labels_hw
    try:
        return replace(image, labels_hw=ground.cut(image.view))
    finally:
        ground.labels_hw = known


def _agreement(ground: Ground, now: np.ndarray, network: Network, pictures: dict[str, np.ndarray]) -> str:
    """How well each date's labels agree with the map of 2012."""
    answers = {name: network.labels(photo) for name, photo in pictures.items()} | {INDEX: now}
    rows = []
    for name, labels in answers.items():
        iou, right = agreement(ground, ground.labels_hw, labels)
        rows.append([name, *(f"{value:.3f}" for value in iou), f"{right:.1%}"])
    header = ["compared with the map of 2012", *(f"IoU {entry.name}" for entry in ground.database.class_table)]
    return page.table([*header, "pixels alike"], rows)
