"""What networks shift: measured on photos with true labels, as Compare label maps measures it."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass, replace

import cv2
import numpy as np
from bench import inputs, page
from bench.photos import SHIPPED, sample_sun_deg
from bench.tiles import TILE_PIXEL_M, tile_paths
from sample.classes import CLASSES
from sample.files import grid_of, rasterize
from sample.landscape import make_landscape

from sample import photo
from semref.core.geometry.error_settings import ClassBias
from semref.core.labels.class_table import ClassTable, class_table_from_csv
from semref.core.labels.image_source import ArrayImage
from semref.core.landmarks.class_shifts import PIECE_PX, PieceShift, class_shifts, piece_shifts
from semref.core.segmentation.class_bias import KEY, class_bias_text
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.onnx_file import with_metadata
from semref.core.segmentation.photo_labels import PhotoLabels

FIRST_SEED = 31
"""Of landscapes that the shipped network was not trained on."""

SOUTH_DEG = 180.0
LEAST_PIECES = 30
"""Classes with fewer are left out of what is stated."""

COLUMNS = ("photo", "class", "pairs, pieces", "east, north", "toward the sun", "known to", "spread")
QUALITY = [cv2.IMWRITE_JPEG_QUALITY, 85]


@dataclass(frozen=True)
class Scene:
    """A photo and its true labels.

    Attributes:
        name: Of it.
        photo_hw3: Red, green, blue.
        labels_hw: Class values.
        pixel_m: Meters a pixel.
        sun_deg: Where the sun stood, clockwise from the image's top; None where nobody knows.
    """

    name: str
    photo_hw3: np.ndarray
    labels_hw: np.ndarray
    pixel_m: float
    sun_deg: float | None = None


def biases(run: inputs.Run) -> str:
    """A row a class and photo, and one of all photos of a place's kind."""
    rows: list[list[str]] = []
    table = class_table_from_csv("value,name,color,role\n" + "\n".join(map(_line, CLASSES)))
    found, turned = _measured(str(SHIPPED), table, _sample_scenes(run.count))
    rows += found
    stated = _stated(table, turned)
    copy = run.work / SHIPPED.name
    copy.write_bytes(with_metadata(SHIPPED.read_bytes(), KEY, class_bias_text(stated)))
    if run.model and tile_paths(run):
        rows += _measured(str(run.model), class_table_from_csv(inputs.TILE_CLASSES), _tile_scenes(run))[0]
    return f"{page.table(COLUMNS, rows)}\n\n{copy} is the shipped network with {KEY} = {class_bias_text(stated)}"


def _stated(table: ClassTable, turned: list[PieceShift]) -> dict[str, ClassBias]:
    """What a network's metadata state, from pieces of ground of 1 m pixels with the sun in the south."""
    found = [shift for shift in class_shifts(turned) if shift.pieces >= LEAST_PIECES]
    return {
        table.by_value(one.value).name: ClassBias(0, one.shift.real, -one.shift.imag, 0.0, 0.0, one.spread, SOUTH_DEG)
        for one in found
    }


def _line(one: object) -> str:
    return f"{one.value},{one.name},{one.color},{one.role}"


def _sample_scenes(count: int) -> Iterator[Scene]:
    for seed in range(FIRST_SEED, FIRST_SEED + count):
        landscape = make_landscape(seed)
        picture = photo.render(landscape, grid_of(landscape, 1.0), 1.0)
        encoded = cv2.imencode(".jpg", np.ascontiguousarray(picture[:, :, ::-1]), QUALITY)[1]
        seen = np.ascontiguousarray(cv2.imdecode(encoded, cv2.IMREAD_COLOR)[:, :, ::-1])
        yield Scene(f"made-up area {seed}", seen, rasterize(landscape, 1.0), 1.0, sample_sun_deg(seed))


def _tile_scenes(run: inputs.Run) -> Iterator[Scene]:
    path = run.data / inputs.TILES / f"tile{run.tile}_label.tif"
    picture = inputs.read_labels(str(path).replace("_label", "_image"))
    yield Scene(path.stem, np.ascontiguousarray(np.moveaxis(picture[:3], 0, 2)), inputs.read_labels(path), TILE_PIXEL_M)


def _measured(model_path: str, table: ClassTable, scenes: Iterator[Scene]) -> tuple[list[list[str]], list[PieceShift]]:
    """Rows, and all pieces of ground turned so that the sun is in the south."""
    model = SegmentationModel(model_path, 1)
    values = model.classes.values_in(table, model_path)
    every, turned, rows = [], [], []
    for scene in scenes:
        predicted = PhotoLabels(model, ArrayImage(scene.photo_hw3), values).found()
        pieces = []
        for top in range(0, predicted.shape[0], PIECE_PX):
            for left in range(0, predicted.shape[1], PIECE_PX):
                part = np.s_[top : top + PIECE_PX, left : left + PIECE_PX]
                pieces += piece_shifts(scene.labels_hw[part], predicted[part], table.reference_values)
        every += pieces
        if scene.sun_deg is not None:
            turn = complex(np.exp(1j * np.radians(SOUTH_DEG - scene.sun_deg)))
            turned += [replace(piece, shift=turn * piece.shift) for piece in pieces]
        rows += _rows(scene.name, table, pieces, scene.pixel_m, scene.sun_deg)
        print("  " + "\n  ".join(" | ".join(row) for row in rows[-3:]), file=sys.stderr, flush=True)
        pixel_m = scene.pixel_m
    rows += _rows("all", table, every, pixel_m, None)
    rows += _rows("all, turned so that the sun is in the south", table, turned, pixel_m, SOUTH_DEG)
    return rows, turned


def _rows(name: str, table: ClassTable, pieces: list, pixel_m: float, sun_deg: float | None) -> list[list[str]]:
    rows = []
    for found in class_shifts(pieces):
        east, north = pixel_m * found.shift.real, -pixel_m * found.shift.imag
        toward = "–"
        if sun_deg is not None:
            toward = f"{east * np.sin(np.radians(sun_deg)) + north * np.cos(np.radians(sun_deg)):+.2f} m"
        spread = "–" if found.spread is None else f"{pixel_m * found.spread:.2f} m"
        label = table.by_value(found.value).name
        cells = [name, label, f"{found.pairs}, {found.pieces}", f"{east:+.2f}, {north:+.2f} m", toward]
        rows.append([*cells, f"± {pixel_m * found.deviation:.2f} m", spread])
    return rows
