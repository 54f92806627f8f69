"""Polygons of what was segmented: of the sample photo against tile by tile, of noisy labels against gdal:polygonize."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from bench import inputs, page, plugin, timing
from bench.tile_by_tile import TileByTile

GOAL_TIMES = 2.0
EDGE, QUICK_EDGE = 2_828, 600
BLOB_PX, SPECKS = 12, 0.05
"""Noisy labels: standard deviation of the field whose highest value is the class, and the share of pixels by lot."""
SIEVED = 25
"""Square meters, and pixels: smaller regions are noise to whoever wants polygons."""
SEED = 5


def measure(run: inputs.Run, folder: Path) -> str:
    """A paragraph and a table."""
    edge = QUICK_EDGE if run.quick else EDGE
    labels = noisy_labels(edge)
    image, model = write_inputs(folder, labels)
    seconds, counts = turns(image, model, folder, max(1, min(3, run.repetitions)))
    rows = []
    for name, ours, other in (
        ("all regions", "polygons", "gdal:polygonize"),
        (f"regions of {SIEVED} m² and more", "sieved", "gdal:polygonize"),
        (f"regions of {SIEVED} m² and more, with segmenting", "whole", "tile by tile"),
    ):
        ratio = timing.ratios(seconds[other], seconds[ours])
        times = (f"{timing.spread(seconds[who]).median:.1f} s" for who in (ours, other))
        first, second = times
        rows.append([name, first, f"{counts[ours]:,}", other, second, f"{counts[other]:,}", f"**{ratio.text(1)}**"])
    columns = ["polygons", "SemRef", "how many", "against", "", "how many", "times as fast"]
    return _ABOUT.format(
        edge=edge, million=edge**2 / 1e6, specks=SPECKS, goal=GOAL_TIMES, table=page.table(columns, rows)
    )


_ABOUT = """\
Polygons, of labels of {edge:,} × {edge:,} pixels ({million:.0f} million) of which {specks:.0%} are by lot: from label
map to GeoPackage (POLYGONS, borders straightened alike on both sides) against `gdal:polygonize` (pixel edges, each
region by itself), and with segmenting by a tiny network against tile by tile with its contours (which
overlap or leave gaps, and a median blur instead of a minimum area). Processor time in turns. Goal: ≥ {goal:g} times as
fast as tile by tile with polygons.

{table}"""


def turns(image: Path, model: Path, folder: Path, repetitions: int) -> tuple[dict[str, list[float]], dict[str, int]]:
    """Processor seconds by turn and polygons made, of each candidate."""
    other, counts = TileByTile(model, image), {}
    labels, polygons, plain = folder / "noisy_labels.tif", folder / "noisy.gpkg", folder / "noisy_gdal.gpkg"
    given = {"INPUT": str(image), "MODEL": str(model), "OUTPUT": str(labels)}

    def segmented(name: str, **more: object) -> None:
        from semref.storage.vector_files import feature_count

        plugin.run_algorithm("segmentimage", {**given, **more})
        if "POLYGONS" in more:
            counts[name] = feature_count(str(polygons), "")

    def polygonized() -> None:
        import processing

        from semref.storage.vector_files import feature_count

        # Into a file that is there it would add, row by row.
        plain.unlink(missing_ok=True)
        order = {"INPUT": str(labels), "BAND": 1, "FIELD": "DN", "EIGHT_CONNECTEDNESS": False, "OUTPUT": str(plain)}
        processing.run("gdal:polygonize", order)
        counts["gdal:polygonize"] = feature_count(str(plain), "")

    def tile_by_tile() -> None:
        counts["tile by tile"] = sum(layer.featureCount() for layer in other.polygons(other.labels()))

    wanted = {"POLYGONS": str(polygons)}
    candidates = {
        "labels": lambda: segmented("labels"),
        "polygons": lambda: segmented("polygons", **wanted),
        "sieved": lambda: segmented("sieved", **wanted, MINIMUM_AREA=SIEVED),
        "tile by tile": tile_by_tile,
    }
    seconds = timing.take_turns(
        {
            **{name: timing.on_processor(candidate) for name, candidate in candidates.items()},
            # A process of its own.
            "gdal:polygonize": timing.on_processor_of_children(polygonized),
        },
        repetitions,
    )
    seconds["whole"], counts["whole"] = seconds["sieved"], counts["sieved"]
    for name in ("polygons", "sieved"):
        seconds[name] = [with_them - without for with_them, without in zip(seconds[name], seconds["labels"])]
    return seconds, counts


def noisy_labels(edge: int) -> np.ndarray:
    """(edge, edge) uint8 class numbers 0, 1 and 2."""
    import cv2

    random = np.random.default_rng(SEED)
    fields = random.normal(size=(3, edge, edge)).astype(np.float32)
    labels = np.argmax([cv2.GaussianBlur(field, (0, 0), BLOB_PX) for field in fields], axis=0)
    by_lot = random.random((edge, edge)) < SPECKS
    return np.where(by_lot, random.integers(0, 3, (edge, edge)), labels).astype(np.uint8)


def write_inputs(folder: Path, labels: np.ndarray) -> tuple[Path, Path]:
    """A photo whose brightest color tells the class, and a network that sees it."""
    import onnx_writer
    from osgeo import gdal, osr

    image, model = folder / "noisy.tif", folder / "brightest.onnx"
    edge = len(labels)
    target = gdal.GetDriverByName("GTiff").Create(str(image), edge, edge, 3, gdal.GDT_Byte, ["TILED=YES"])
    crs = osr.SpatialReference()
    crs.ImportFromEPSG(25832)
    target.SetProjection(crs.ExportToWkt())
    target.SetGeoTransform((550000.0, 1.0, 0.0, 5220000.0, 0.0, -1.0))
    target.WriteArray(np.stack([np.where(labels == band, 220, 40) for band in range(3)]).astype(np.uint8))
    target.FlushCache()
    network = onnx_writer.Network().convolution(np.eye(3)[:, :, None, None], np.zeros(3))
    texts = {
        "class_names": ["building", "water", "field"],
        "tile_size": 512,
        "tiles_overlap": 15,
        "resolution": 100,
        "standardization_mean": [0.5] * 3,
        "standardization_std": [0.5] * 3,
    }
    shape = [1, 3, 512, 512]
    model.write_bytes(onnx_writer.model_bytes(network, shape, shape, {key: json.dumps(v) for key, v in texts.items()}))
    return image, model
