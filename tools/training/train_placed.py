"""Train networks further on the photos that they localize, as *Set up an area* does without imagery.

    .venv/bin/python tools/training/train_placed.py OUTPUT_FOLDER --python PYTHON_WITH_TORCH --models FOLDER "Kenya 1" …

For each named row of the benchmark ``placed_photos``, the script draws 40 crops of its place, other than those of the
benchmark. The row's network of FOLDER localizes them, and is trained further on those that get a position, with the map
as labels; then the same once more. It becomes OUTPUT_FOLDER/placed_KENYA_1.onnx, which the row “Kenya 1, trained” uses.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np
from common import DATA, Job, cut, parser_of, prepare, train
from osgeo import gdal

from benchmarks import accuracy, photos
from benchmarks.maps import World
from benchmarks.results import ROOT
from benchmarks.toml import read_toml
from semref.core.geometry.footprint import image_corners
from semref.core.localization import SHOWN_RISK, Method, Prior
from semref.core.localizer.search import Search
from semref.core.pipeline import localize_with
from semref.core.segmentation.model import SegmentationModel
from semref.storage.georeferencing import write_mosaic
from semref.storage.pictures import write_png
from semref.training.job import LITE0, PACKAGED

COUNT, SEED = 40, 1671
TILE_PX, STRIDE_PX, VALIDATION_FRACTION = 256, 128, 0.0
EPOCHS, PATIENCE, LIGHT = 200, 30, 1.5
"""As *Train model*."""

ROUNDS = 2
"""As *Set up an area*."""


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument("rows", nargs="+", help="rows of the benchmark placed_photos")
    parser.add_argument("--models", type=Path, required=True, help="folder of the networks without the places")
    parser.add_argument("--minutes", type=float, default=5.0, help="minutes of processor time; default %(default)s")
    options = parser.parse_args()
    folder = prepare(parser, options, "oam_buildings")
    rows = accuracy.rows_of(read_toml(ROOT / "benchmarks" / "scenarios" / "placed_photos.toml"))
    for row in (row for row in rows if row.name in options.rows):
        name = f"placed_{row.name.casefold().replace(', ', '_').replace(' ', '_')}"
        work = folder / name
        work.mkdir(exist_ok=True)
        source = photos.of(World(DATA, folder, options.models), row)
        for number in range(1, ROUNDS + 1):
            step = work / str(number)
            step.mkdir(exist_ok=True)
            image, labels, classes = imagery_of(source, step)
            tiles = cut(image, labels, classes, step / "tiles", (TILE_PX, STRIDE_PX), VALIDATION_FRACTION, True)
            trained = folder / f"{name}.onnx" if number == ROUNDS else step / "model.onnx"
            job = Job(
                (str(tiles),),
                str(trained),
                str(step / "training"),
                source.model.path,
                encoder=LITE0,
                encoder_weights=PACKAGED,
                learn_unlabeled=True,
                epochs=EPOCHS,
                patience=PATIENCE,
                light=LIGHT,
                minutes=options.minutes / ROUNDS,
                processor_time=True,
                resolution=photos.PLACE_PIXEL_M,
                resume=True,
            )
            train(options.python, job)
            source = replace(source, model=SegmentationModel(str(trained), 1))


def imagery_of(source: photos.Photos, folder: Path) -> tuple[Path, Path, Path]:
    """Localize crops; write those with a position as a mosaic, and labels of the map; return both and the classes."""
    ground, placed = source.ground, []
    for number in range(COUNT):
        image, photo = source.crop(np.random.default_rng([SEED, number]))
        seen, prior = source.labeled(photo), Prior(pixel_size_range=source.searched)
        found = localize_with(ground.localizer, Search(Method.AUTOMATIC), seen, prior, None).localization
        if found.best is None or found.risk > SHOWN_RISK:
            continue
        path = folder / f"photo_{number}.png"
        write_png(path, np.moveaxis(photo, 2, 0))
        best, (height, width) = found.best, photo.shape[:2]
        placed.append((str(path), image_corners(best.position, best.heading_deg, best.pixel_size_m, width, height)))
    print(f"{folder.parent.name}: {len(placed)} of {COUNT} photos have a position.", flush=True)
    mosaic, labels, classes = folder / "mosaic.tif", folder / "labels.tif", folder / "classes.csv"
    write_mosaic(placed, str(mosaic), "", photos.PLACE_PIXEL_M, lambda _: True)
    truth, frame = (ground.labels_hw == photos.BUILDING).astype(np.uint8), ground.frame
    made = gdal.GetDriverByName("GTiff").Create(str(labels), *truth.shape[::-1], 1)
    made.SetGeoTransform((frame.origin[0], frame.pixel_size, 0.0, frame.origin[1], 0.0, -frame.pixel_size))
    made.WriteArray(truth)
    classes.write_text(photos.BUILDINGS_ONLY.partition("2,")[0], encoding="utf-8")
    return mosaic, labels, classes


if __name__ == "__main__":
    main()
