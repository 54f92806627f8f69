"""Own ground of which buildings alone were drawn: what minutes of training buy, and a database with the class “other”.

    .venv/bin/python tools/bench own_buildings --python PYTHON_WITH_TORCH [--count 50] [--only "3 minutes"] [--write]

The western half of Banepa's orthophoto with the buildings drawn on it is learned as semref:trainmodel does it where
ground without a label is something else. Crops lie wholly on the eastern half and are looked for in databases of both
halves: one of buildings alone, one with the class “other” on all other ground. Trained models are kept in --work.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from bench import inputs, own_ground, page, photo_places, real_places
from bench.ground import COLUMNS, Image, cells
from bench.photos import TRUE_LABELS, Network, as_seen, seen
from bench.real_places import BUILDING, PIXEL_M, PlaceGround
from semref.core.labels.training_tiles import fitting_tiles
from semref.core.localization import Method
from semref.storage.rasters import RasterFile
from semref.storage.text_tables import read_class_table
from semref.storage.training_tiles import TileExport

PAGE = "benchmarks.md"
AREA = "banepa."
SEED = 1671
COUNT, QUICK_COUNT = 50, 2
SIZES_PX = (384, 512)
MINUTES = (1, 3, 10)
LEARNED, FLOWN = "banepa_west", "banepa_east"
BUILDINGS_ALONE = "value,name,color,role\n1,building,#3c1098,reference\n"
ALONE, WITH_OTHER = "buildings alone", "buildings and “other”"


def measure(run: inputs.Run) -> dict[str, str]:
    if not (run.data / photo_places.place(LEARNED).photos[0].image).exists():
        return {"own ground of buildings": "Not measured: the real data is not here: banepa."}
    places = both_databases(run)
    whole = places[WITH_OTHER]
    images = flown(run, whole)
    rows, agreement = [], []
    for minutes in MINUTES:
        case = f"{minutes} minutes" if minutes > 1 else "1 minute"
        if run.wants(case):
            model = trained(run, minutes, case)
            agreement.append([case, *real_places.agreed(model, [whole])])
            for name, place in places.items():
                network = Network(model, place.ground)
                place.ground.localizer.heed_biases(*network.biases)
                shown = [as_seen(one, network.seen(seen(whole.ground, whole.picture, one.view))) for one in images]
                rows += located(place, shown, f"{case}, {name}")
    if run.wants(TRUE_LABELS):
        for name, place in places.items():
            shown = [replace(one, labels_hw=place.ground.cut(one.view)) for one in images]
            rows += located(place, shown, f"{TRUE_LABELS}, {name}")
    about = _ABOUT.format(pixel=PIXEL_M, sizes=" and ".join(map(str, SIZES_PX)))
    header = ["trained for", "IoU building", "buildings found", "right where found", "share of the ground"]
    body = f"{about}\n\n{page.table(COLUMNS, rows)}\n\nOn the eastern half:\n\n{page.table(header, agreement)}"
    return {"own ground of buildings": body}


_ABOUT = """\
EfficientNet-Lite0 trained on the western half of `banepa` at {pixel:g} m for so many minutes of one processor, where
only buildings were drawn and all else is learned as “other”; off-grid, turned crops of {sizes} px wholly on the eastern
half, at 0.9–1.1 of its pixels, pixel size searched over 0.7–1.4, method automatic. Databases are of both halves,
buildings as landmarks: “buildings alone”, or with “other” on all ground without one (*Ground without a polygon is
something else*). Right: within 2 % of the edge. “true labels”: what no network could improve."""


def both_databases(run: inputs.Run) -> dict[str, PlaceGround]:
    """The place with its two databases, by name."""
    photo = photo_places.place(FLOWN).photos[0]
    whole = real_places.ground_of(run, photo)
    buildings = np.where(whole.ground.labels_hw == BUILDING, BUILDING, 0).astype(np.uint8)
    return {ALONE: PlaceGround(buildings, whole.picture, photo.part, BUILDINGS_ALONE), WITH_OTHER: whole}


def trained(run: inputs.Run, minutes: int, case: str) -> Path:
    """The network of the western half, trained unless an earlier run left it; named as real_places.py wants it."""
    settings = {**own_ground.NETWORKS["Lite0"], "minutes": minutes, "learn_unlabeled": True}
    model = run.work / f"{case.replace(' ', '_')}_without_{FLOWN}.onnx"
    if not model.exists():
        own_ground.run_training(run, _tiles(run), model, settings)
    return model


def _tiles(run: inputs.Run) -> Path:
    """Training tiles of the western half, as semref:trainmodel cuts them."""
    tiles = run.work / "own_buildings_tiles"
    if tiles.exists():
        return tiles
    photo = photo_places.place(LEARNED).photos[0]
    image, labels = photo_places.prepared(photo, run.data, PIXEL_M, run.work / "places")
    table = run.work / "own_buildings_classes.csv"
    table.write_text(BUILDINGS_ALONE, encoding="utf-8")
    files = RasterFile(str(image), is_metric=True), RasterFile(str(labels), is_metric=True)
    size, stride = fitting_tiles(inputs.read_labels(labels).shape)
    export = TileExport(*files, size, stride, own_ground.VALIDATION_FRACTION, unseen_apart=True)
    tiles.mkdir()
    for _ in export.steps(tiles, read_class_table(str(table))):
        pass
    return tiles


def flown(run: inputs.Run, place: PlaceGround) -> list[Image]:
    """Crops that show nothing of the western half."""
    images: list[Image] = []
    for number, edge in enumerate(SIZES_PX):
        rng = np.random.default_rng([SEED, number])
        images += place.images(edge, run.how_many(COUNT, QUICK_COUNT), rng)
    return images


def located(place: PlaceGround, images: list[Image], case: str) -> list[list[str]]:
    """A row for each size, and for all of them."""
    trials = {edge: [] for edge in SIZES_PX}
    for image in images:
        trials[image.view.width_px].append(place.ground.try_image(image, Method.AUTOMATIC))
    rows = [cells(found, f"{case}, {edge} px") for edge, found in trials.items()]
    return [*rows, cells([one for found in trials.values() for one in found], f"{case}, all")]
