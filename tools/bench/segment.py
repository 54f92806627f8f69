"""Segmenting: tiles per second against bare onnxruntime on the same tiles, and peak memory on a large orthophoto."""

from __future__ import annotations

import time
from pathlib import Path

import numpy as np

from bench import child, inputs, page, plugin, timing

PAGE = "benchmarks.md"
GOAL_RATIO, GOAL_BYTES = 0.9, 2e9
MODEL = inputs.TOOLS.parent / "models" / "sample_area.onnx"
EDGE, QUICK_EDGE = 4_000, 1_200
LARGE_EDGE, QUICK_LARGE_EDGE = 30_000, 4_000
PIXEL_SIZE = 1.0
"""The model's, so that nothing is resampled."""


def measure(run: inputs.Run) -> dict[str, str]:
    folder = run.work / "segment"
    folder.mkdir(exist_ok=True)
    edge = QUICK_EDGE if run.quick else EDGE
    image = write_photo(folder / f"photo_{edge}.tif", edge)
    parameters = {"INPUT": str(image), "MODEL": str(MODEL), "OUTPUT": str(folder / "labels.tif")}
    tiles, bare = bare_runner(image)
    candidates = {
        "segmentimage": lambda: ignore(plugin.run_algorithm("segmentimage", parameters)),
        "onnxruntime": bare,
    }
    seconds = timing.take_turns(candidates, run.repetitions)
    # Tiles per second: the ratio of times the other way round.
    ratio = timing.ratios(seconds["onnxruntime"], seconds["segmentimage"])
    rows = [[name, f"{tiles / timing.spread(times).median:.1f}"] for name, times in seconds.items()]
    large = QUICK_LARGE_EDGE if run.quick else LARGE_EDGE
    wide = write_large(folder / "large.vrt", image, edge, large)
    found = child.run_in_child("segmentimage", {**parameters, "INPUT": str(wide)})
    text = _ABOUT.format(
        edge=edge, tiles=tiles, table=page.table(["", "tiles a second"], rows),
        ratio=ratio.text(), goal=GOAL_RATIO, large=large, peak=page.size(found["peak_bytes"]),
        goal_bytes=page.size(GOAL_BYTES), seconds=found["seconds"], start=page.size(child.run_in_child()["peak_bytes"]),
        version=onnxruntime_version(), threads=threads(),
    )  # fmt: skip
    return {"segment": text}


_ABOUT = """\
`semref:segmentimage` (reading a GeoTIFF, blending, writing the label map) against onnxruntime {version} alone on the
same {tiles} tiles, ready in memory: image of {edge:,} × {edge:,} pixels, {threads} threads, the model that ships
(`models/sample_area.onnx`) with its own tiles and overlap.

{table}

Ratio of tiles per second: **{ratio}** (goal: ≥ {goal}).

Peak memory (RSS, QGIS and libraries included) on an orthophoto of {large:,} × {large:,} pixels, in a process of its
own: **{peak}** (goal: ≤ {goal_bytes}; QGIS started and stopped: {start}); {seconds:.0f} s, once, for information."""


def bare_runner(image: Path):
    """(number of tiles, function that runs onnxruntime on them and returns its seconds)."""
    import onnxruntime

    from semref.core.segmenter import tile_starts

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = threads()
    session = onnxruntime.InferenceSession(str(MODEL), options, providers=["CPUExecutionProvider"])
    settings = session.get_modelmeta().custom_metadata_map
    tile_px, overlap = int(settings["tile_size"]), float(settings["tiles_overlap"]) / 100
    name = session.get_inputs()[0].name
    pixels = np.ascontiguousarray(inputs.read_labels(image).astype(np.float32) / 255)
    starts = tile_starts(pixels.shape[1], tile_px, overlap)
    places = [(row, column) for row in starts for column in starts]

    def run() -> float:
        seconds = 0.0
        for row, column in places:
            tile = np.ascontiguousarray(pixels[None, :, row : row + tile_px, column : column + tile_px])
            begin = time.perf_counter()
            session.run(None, {name: tile})
            seconds += time.perf_counter() - begin
        return seconds

    return len(places), run


def write_photo(path: Path, edge: int) -> Path:
    """An RGB GeoTIFF of smooth noise, (edge, edge), in tiles and compressed, as orthophotos come."""
    import cv2
    from osgeo import gdal, osr

    if path.exists():
        return path
    random = np.random.default_rng(2)
    coarse = random.integers(0, 256, (edge // 20, edge // 20, 3)).astype(np.uint8)
    pixels = cv2.resize(coarse, (edge, edge), interpolation=cv2.INTER_CUBIC)
    options = ["TILED=YES", "COMPRESS=DEFLATE", "ZLEVEL=1", "PHOTOMETRIC=RGB", "INTERLEAVE=PIXEL"]
    target = gdal.GetDriverByName("GTiff").Create(str(path), edge, edge, 3, gdal.GDT_Byte, options)
    crs = osr.SpatialReference()
    crs.ImportFromEPSG(32632)
    target.SetProjection(crs.ExportToWkt())
    target.SetGeoTransform((550000.0, PIXEL_SIZE, 0.0, 5220000.0, 0.0, -PIXEL_SIZE))
    target.WriteArray(np.moveaxis(pixels, 2, 0))
    target.FlushCache()
    return path


def write_large(path: Path, photo: Path, edge: int, large: int) -> Path:
    """A VRT of (large, large) pixels that shows the photo again and again."""
    from osgeo import gdal

    target = gdal.GetDriverByName("VRT").Create(str(path), large, large, 3, gdal.GDT_Byte)
    source = gdal.Open(str(photo))
    target.SetProjection(source.GetProjection())
    target.SetGeoTransform(source.GetGeoTransform())
    for number, meaning in enumerate((gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand), start=1):
        band = target.GetRasterBand(number)
        band.SetColorInterpretation(meaning)
        parts = {}
        for row in range(0, large, edge):
            for column in range(0, large, edge):
                width, height = min(edge, large - column), min(edge, large - row)
                parts[f"source_{len(parts)}"] = (
                    f'<SimpleSource><SourceFilename relativeToVRT="1">{photo.name}</SourceFilename>'
                    f"<SourceBand>{number}</SourceBand>"
                    f'<SrcRect xOff="0" yOff="0" xSize="{width}" ySize="{height}"/>'
                    f'<DstRect xOff="{column}" yOff="{row}" xSize="{width}" ySize="{height}"/></SimpleSource>'
                )
        band.SetMetadata(parts, "vrt_sources")
    target.FlushCache()
    return path


def threads() -> int:
    from semref.processing.threads import worker_threads

    return worker_threads()


def onnxruntime_version() -> str:
    import onnxruntime

    return onnxruntime.__version__


def ignore(_: object) -> None:
    """A candidate that returns None is timed from outside."""
