"""Images of which nobody made up how they err: maps of two dates of Christchurch, and photos, rendered and real."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import lru_cache, partial

import numpy as np

from bench import inputs, own_buildings, photos, real_places, two_dates
from bench.correlation import ON_A_TILE
from bench.ground import ANY, Ground, Image, Wanted
from bench.tiles import tile_ground, tile_paths
from semref.core.evaluation.trial import Query, Trial
from semref.core.localization import Method, Prior
from semref.storage.database.reader import read_database

SEED = 2102
PAIRS = ((1996, 2001), (2001, 2008), (2008, 2012), (2012, 2018), (1996, 2018))
"""Dates of the database and of the images."""

FOOTPRINT_M = 6_400.0
METHODS = (Method.CONSTELLATION, Method.MAP_CORRELATION, Method.AUTOMATIC)
PHOTO_METHODS = (Method.CONSTELLATION, Method.AUTOMATIC)
RENDERED, REAL = "rendered photos", "real photos"
REAL_PX = 512

Rows = Iterator[tuple[str, Callable[[int, int], list[Trial]]]]


def every(run: inputs.Run, prior_share: float) -> Rows:
    """(name, what makes the trials of a part of so many images) of all rows that the run wants and has the data of.

    prior_share: map correlation and automatic are told the position to this share of the footprint.
    """
    if (run.data / two_dates.SOURCE).exists():
        yield from _christchurch(run, prior_share)
    yield from _rendered(run)
    if run.model and tile_paths(run):
        yield from _real(run)


def _christchurch(run: inputs.Run, prior_share: float) -> Rows:
    for number, (before, after) in enumerate(PAIRS):
        for method in METHODS:
            name = f"{method.key}: Christchurch, map of {before}, images of {after}"
            if run.wants(name):
                yield name, partial(_dates, run, number, method, prior_share)


@lru_cache(maxsize=1)
def _of_dates(run: inputs.Run, number: int, part: int, size: int) -> tuple[Ground, list[Image]]:
    before, after = PAIRS[number]
    content = read_database(str(two_dates.database(run, FOOTPRINT_M, before)), with_overview=True)
    labels = inputs.read_labels(two_dates.label_map(run, after))
    ground = Ground(labels, content, size_px=round(FOOTPRINT_M / two_dates.PIXEL_SIZE_M))
    wanted = Wanted(two_dates.SCALES, landmarks=ANY, labeled=two_dates.LEAST_LABELED)
    rng = np.random.default_rng([SEED, number, part])
    return ground, [ground.draw(wanted, rng) for _ in range(size)]


def _dates(run: inputs.Run, number: int, method: Method, prior_share: float, part: int, size: int) -> list[Trial]:
    ground, images = _of_dates(run, number, part, size)
    rng = np.random.default_rng([SEED, number, part, METHODS.index(method)])
    return [_near(ground, image, method, rng, prior_share) for image in images]


def _near(ground: Ground, image: Image, method: Method, rng: np.random.Generator, prior_share: float) -> Trial:
    view = image.view
    radius = prior_share * view.footprint
    off = rng.uniform(-0.5, 0.5, 2) * radius
    ground.prior = None if method is Method.CONSTELLATION else Prior((view.x + off[0], view.y + off[1]), radius)
    return ground.try_image(image, method)


def _rendered(run: inputs.Run) -> Rows:
    """Photos of a landscape that the shipped network has not seen, once as its metadata say and once as if silent."""
    for method in PHOTO_METHODS:
        for told in (True, False):
            name = f"{method.key}: {RENDERED}, bias {'' if told else 'not '}stated"
            if run.wants(name):
                yield name, partial(_rendered_trials, method, told)


@lru_cache(maxsize=1)
def _shot(part: int, size: int) -> tuple[Ground, photos.Network, list[Image]]:
    ground, area = photos.sample_ground()
    network = photos.Network(photos.SHIPPED, ground)
    # The landscape's photo has one sun, the same in every picture that is cut from it.
    ground.localizer.errors = replace(ground.localizer.errors, sun_deg=photos.sample_sun_deg())
    return ground, network, list(photos.sample_photos(area, network, ground, size, photos.SEED + part))


def _rendered_trials(method: Method, told: bool, part: int, size: int) -> list[Trial]:
    ground, network, shot = _shot(part, size)
    ground.localizer.heed_biases(*(network.biases if told else photos.SILENT))
    return [ground.try_image(image, method, photos.SAMPLE_RIGHT_M) for image in shot]


def _real(run: inputs.Run) -> Rows:
    """Of one tile by the network of --model, or by each NETWORK_without_tileN.onnx of that folder, and a place's."""
    models = {run.tile: run.model}
    if run.model.is_dir():
        models = {int(path.stem[-1]): path for path in sorted(run.model.glob("*without_tile[0-9].onnx"))}
        for path in sorted(run.model.glob(f"*without_{own_buildings.FLOWN}.onnx")):
            for method in PHOTO_METHODS:
                trained = path.stem.partition("_without")[0].replace("_", " ")
                name = f"{method.key}: {REAL}, east of banepa, {REAL_PX} px, trained for {trained}"
                if run.wants(name):
                    yield name, partial(_place_trials, replace(run, model=path), method)
    for tile, model in models.items():
        for method in PHOTO_METHODS:
            name = f"{method.key}: {REAL}, tile {tile} of dubai_aerial, {REAL_PX} px"
            if run.wants(name):
                yield name, partial(_real_trials, replace(run, tile=tile, model=model), method)


@lru_cache(maxsize=1)
def _of_tile(run: inputs.Run, part: int, size: int) -> tuple[Ground, list[Image]]:
    path = run.data / inputs.TILES / f"tile{run.tile}_label.tif"
    ground = tile_ground(path)
    picture = np.ascontiguousarray(np.moveaxis(inputs.read_labels(str(path).replace("_label", "_image"))[:3], 0, 2))
    network = photos.Network(run.model, ground)
    ground.localizer.heed_biases(*network.biases)
    rng = np.random.default_rng([SEED, 100, part])
    wanted = replace(ON_A_TILE, sizes_px=(REAL_PX,), labeled=0.0)
    images = [ground.draw(wanted, rng) for _ in range(size)]
    return ground, [photos.as_seen(i, network.seen(photos.seen(ground, picture, i.view))) for i in images]


@lru_cache(maxsize=1)
def _place(run: inputs.Run) -> tuple[real_places.PlaceGround, photos.Network]:
    place = own_buildings.both_databases(run)[own_buildings.WITH_OTHER]
    network = photos.Network(run.model, place.ground)
    place.ground.localizer.heed_biases(*network.biases)
    return place, network


@lru_cache(maxsize=1)
def _of_place(run: inputs.Run, part: int, size: int) -> list[Image]:
    place, network = _place(run)
    images = place.images(REAL_PX, size, np.random.default_rng([SEED, 200, part]))
    return [photos.as_seen(i, network.seen(photos.seen(place.ground, place.picture, i.view))) for i in images]


def _place_trials(run: inputs.Run, method: Method, part: int, size: int) -> list[Trial]:
    ground = _place(run)[0].ground
    return [ground.try_image(image, method) for image in _of_place(run, part, size)]


def _real_trials(run: inputs.Run, method: Method, part: int, size: int) -> list[Trial]:
    ground, shot = _of_tile(run, part, size)
    return [ground.try_image(Image(Query(i.view), i.labels_hw, shares=i.shares), method) for i in shot]
