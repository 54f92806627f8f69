"""Train a network for real photos: buildings, and with Dubai's mosaics also roads, vegetation, water and land.

    .venv/bin/python tools/training/train_photos.py OUTPUT_FOLDER --python PYTHON_WITH_TORCH [--without-dubai]
        [--leave-out PLACE … | --only PLACE --base MODEL] [--minutes 10] [--seed 1671]
        [--encoder NAME --encoder-weights FILE]

The script reads banepa, oam_buildings and dubai_aerial ($SEMREF_DATA or ../shared/data). It writes
OUTPUT_FOLDER/photos.onnx (buildings.onnx with --without-dubai) with the model's card, also as .json.
--leave-out trains without a place and tests on it: NAME_without_PLACE.onnx. The card of the network of all places has
the results. --only trains MODEL further on one place, as *Train model* does: NAME_of_PLACE.onnx.
buildings.onnx has 16-bit weights and is models/buildings.onnx of SemRef. Confirm the licenses of Dubai's mosaics before
you share photos.onnx (docs/reference/networks.md).
"""

import argparse
import json
from pathlib import Path

import numpy as np
from common import DATA, Job, cut, parser_of, prepare, read_class_table
from common import train as run_training
from half_weights import halve_weights

from benchmarks import places
from benchmarks.maps import read, read_photo
from benchmarks.places import ALL_CLASSES, BUILDINGS, PLACES, Place
from semref.core.labels.image_source import ArrayImage
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.model_card import KEY
from semref.core.segmentation.onnx_file import read_header, with_metadata
from semref.core.segmentation.photo_labels import PhotoLabels
from semref.training.job import LITE0, PACKAGED

PHOTOS, BUILDINGS_ONLY = "photos", "buildings"
RESOLUTIONS_M = {PHOTOS: 0.5, BUILDINGS_ONLY: 0.25}
"""Pixel sizes in m. At 0.5 m houses of Dubai's mosaics and of drone photos have similar widths in pixels. Without
Dubai, finer pixels separate terraced houses."""

TILE_PX, STRIDE_PX, DUBAI_TILE_PX, SHOWN_TILE_PX = 256, 128, 512, 512
VALIDATION_FRACTION = 0.15
BATCH, LIGHT, MANY_EPOCHS = 4, 1.5, 10_000
TITLES = {PHOTOS: "Aerial photos", BUILDINGS_ONLY: "Buildings (drone photos)"}
CARDS = json.loads(Path(__file__).with_name("photo_cards.json").read_text(encoding="utf-8"))
"""Uses and licenses of both networks."""


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument("--without-dubai", action="store_true", help="buildings only; no unconfirmed license")
    names = [one.name for one in PLACES]
    parser.add_argument("--leave-out", nargs="+", default=[], choices=names, help="tested without training on it")
    parser.add_argument("--only", nargs="+", default=names, choices=names, help="train on no other place")
    parser.add_argument("--base", default="", help="network to train further")
    parser.add_argument("--minutes", type=float, default=10.0, help="minutes of processor time; default %(default)s")
    parser.add_argument("--seed", type=int, default=1671)
    parser.add_argument("--encoder", default=LITE0, help="its name in segmentation_models_pytorch")
    parser.add_argument("--encoder-weights", default=PACKAGED, help="file with its weights")
    options = parser.parse_args()
    folder = prepare(parser, options, "oam_buildings")
    name = BUILDINGS_ONLY if options.without_dubai else PHOTOS
    not_wanted = {*options.leave_out, *(["dubai"] if options.without_dubai else [])}
    trained_on = [one for one in PLACES if one.name in options.only and one.name not in not_wanted]
    part = f"_without_{'_and_'.join(options.leave_out)}" if options.leave_out else ""
    stem = name + (f"_of_{'_and_'.join(options.only)}" if options.base else part)
    tiles = {str(path): one for one in trained_on for path in tiles_of(one, name, folder)}
    train(options, name, folder / f"{stem}.onnx", tiles)
    for place in options.leave_out:
        tested = tested_on(places.place(place), name, folder / f"{stem}.onnx", folder)
        (folder / f"{name}_without_{place}.json").write_text(json.dumps(tested, indent=1) + "\n", encoding="utf-8")
        print(json.dumps(tested), flush=True)
    if (folder / f"{name}.onnx").exists():
        write_card(folder, name)


def tiles_of(one: Place, name: str, folder: Path) -> list[Path]:
    """Return the folders of training tiles of a place's photos."""
    table = folder / f"classes_{name}.csv"
    table.write_text(places.class_table(ALL_CLASSES if name == PHOTOS else BUILDINGS), encoding="utf-8")
    grid = (DUBAI_TILE_PX,) * 2 if one.name == "dubai" else (TILE_PX, STRIDE_PX)
    return [
        cut(
            *places.prepared(photo, DATA, RESOLUTIONS_M[name], folder / "places"),
            table,
            folder / f"tiles_{name}" / photo.name,
            grid,
            VALIDATION_FRACTION,
        )
        for photo in one.photos
    ]


def train(options: argparse.Namespace, name: str, model: Path, tiles: dict[str, Place]) -> None:
    """Train a network on tiles of places."""
    complete = {path: list(one.drawn) for path, one in tiles.items() if one.drawn != ALL_CLASSES}
    job = Job(
        tuple(tiles),
        str(model),
        str(model.with_suffix(".training")),
        options.base,
        encoder=options.encoder,
        encoder_weights=options.encoder_weights,
        learn_unlabeled=name == BUILDINGS_ONLY,
        complete=complete if name == PHOTOS else {},
        epochs=MANY_EPOCHS,
        patience=0,
        batch=BATCH,
        light=LIGHT,
        minutes=options.minutes,
        processor_time=True,
        resolution=RESOLUTIONS_M[name],
        tile_size=SHOWN_TILE_PX,
        seed=options.seed,
        resume=True,
        card=card_of(name, model.stem, list(tiles.values())),
    )
    run_training(options.python, job)


def card_of(name: str, title: str, places: list[Place]) -> dict:
    """Return the limits that users of the network should know."""
    unlike = list(dict.fromkeys(places))
    return {
        "name": title,
        "trained_on": [{**ground_of(one), "classes": list(one.drawn)} for one in unlike],
        **CARDS[name],
    }


def ground_of(one: Place) -> dict[str, str]:
    """Return location and description of a place, for the card."""
    location, _, about = one.about.partition(": ")
    return {"place": location, "about": about}


def tested_on(one: Place, name: str, model: Path, folder: Path) -> dict:
    """Return the IoU on a place left out of training, for the card."""
    network = SegmentationModel(str(model), 1)
    table = read_class_table(str(folder / f"classes_{name}.csv"))
    values = network.classes.values_in(table, model.name)
    counts = {c: np.zeros(3) for c in one.drawn if c in network.classes.names}
    for photo in one.photos:
        image, labels = places.prepared(photo, DATA, RESOLUTIONS_M[name], folder / "places")
        picture, truth = read_photo(image), read(labels)
        found = PhotoLabels(network, ArrayImage(picture), values).found()
        known = truth > 0 if one.drawn == ALL_CLASSES else picture.any(axis=2)
        for entry in (c for c in table if c.name in counts):
            true, answer = (truth == entry.value) & known, (found == entry.value) & known
            counts[entry.name] += (true & answer).sum(), true.sum(), answer.sum()
    iou = {c: round(both / max(true + answer - both, 1), 3) for c, (both, true, answer) in counts.items()}
    return {**ground_of(one), "how": "left out", "iou": iou}


def write_card(folder: Path, name: str) -> None:
    """Add the results of networks without a place to the card of the network of all places."""
    path = folder / f"{name}.onnx"
    data = path.read_bytes()
    card = json.loads(read_header(data).texts[KEY])
    left_out = sorted(folder.glob(f"{name}_without_*[!b].json"))
    card["name"] = TITLES[name]
    card["tested_on"] = [json.loads(one.read_text("utf-8")) for one in left_out if not one.name.endswith(".job.json")]
    data = with_metadata(data, KEY, json.dumps(card))
    path.write_bytes(data)
    halve_weights(path)
    path.with_suffix(".json").write_text(json.dumps(card, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
