"""Segmenting: tiles a second of processor time against bare onnxruntime and against tile by tile, peak memory."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from bench import child, inputs, page, plugin, segment_polygons, timing
from bench.tile_by_tile import TileByTile

PAGE = "benchmarks.md"
GOAL_RATIO, GOAL_TIMES, GOAL_BYTES = 0.9, 2.0, 2e9
SMALL = inputs.TOOLS.parent / "models" / "sample_area.onnx"
TILE_PX, OVERLAP_PERCENT = 512, 15
EDGE, QUICK_EDGE = 4_000, 1_200
LARGE_EDGE, QUICK_LARGE_EDGE = 30_000, 4_000
PIXEL_SIZE = 1.0
"""The models', so that nothing is resampled."""
SEED = 1671
"""Of the sample area whose photo is segmented."""


def measure(run: inputs.Run) -> dict[str, str]:
    folder = run.work / "segment"
    folder.mkdir(exist_ok=True)
    edge = QUICK_EDGE if run.quick else EDGE
    image = write_photo(folder / f"sample_photo_{edge}.tif", edge)
    usual = folder / "usual.onnx"
    multiplications = write_usual_network(usual)
    named = (("that ships", SMALL), (f"of {multiplications / 1e9:.1f} G multiplications a tile", usual))
    rows, tiles = [], 0
    for name, model in named:
        tiles, cells = compared(model, image, folder, run.repetitions)
        rows.append([name, *cells])
    large = QUICK_LARGE_EDGE if run.quick else LARGE_EDGE
    wide = write_large(folder / "large.vrt", image, edge, large)
    parameters = {"INPUT": str(wide), "MODEL": str(SMALL), "OUTPUT": str(folder / "labels.tif")}
    found = child.run_in_child("segmentimage", parameters)
    columns = ["network", "segmentimage, tiles/s", "onnxruntime", "tile by tile", "of onnxruntime", "× tile by tile"]
    text = _ABOUT.format(
        edge=edge,
        tiles=tiles,
        table=page.table(columns, rows),
        goal=GOAL_RATIO,
        goal_times=GOAL_TIMES,
        polygons=segment_polygons.measure(run, folder),
        large=large,
        peak=page.size(found["peak_bytes"]),
        goal_bytes=page.size(GOAL_BYTES),
        seconds=found["seconds"],
        start=page.size(child.run_in_child()["peak_bytes"]),
        version=onnxruntime_version(),
        threads=threads(),
    )
    return {"segment": text}


def compared(model: Path, image: Path, folder: Path, repetitions: int) -> tuple[int, list[str]]:
    """(number of tiles, cells of a row): tiles a second of processor time, and the ratios of each turn."""
    parameters = {"INPUT": str(image), "MODEL": str(model), "OUTPUT": str(folder / "labels.tif")}
    tiles, bare = bare_runner(model, image)
    other = TileByTile(model, image)
    candidates = {
        "segmentimage": lambda: plugin.run_algorithm("segmentimage", parameters),
        "onnxruntime": bare,
        "tile by tile": other.labels,
    }
    seconds = timing.take_turns({name: timing.on_processor(run) for name, run in candidates.items()}, repetitions)
    # Tiles a second: the ratio of times the other way round.
    own = seconds["segmentimage"]
    ratios = (timing.ratios(seconds[who], own) for who in ("onnxruntime", "tile by tile"))
    speeds = (f"{tiles / timing.spread(seconds[who]).median:.1f}" for who in candidates)
    return tiles, [*speeds, *(f"**{ratio.text()}**" for ratio in ratios)]


_ABOUT = """\
`semref:segmentimage` from start to end (opening model and GeoTIFF, reading, blending, compressing and writing the label
map) against onnxruntime {version} alone, its session open, on the same {tiles} tiles, ready in memory, and against
segmenting tile by tile, by the published steps of Deepness written anew (`tools/bench/tile_by_tile.py`: a stand-in;
Deepness itself was not at hand). Photo of the sample area, mirrored to {edge:,} × {edge:,} pixels, {threads} threads
each; seconds are those of all processors together, the candidates take turns. Goals: ≥ {goal} of onnxruntime's tiles a
second, ≥ {goal_times:g} times those of tile by tile.

{table}

The model that ships (`models/sample_area.onnx`, 0.3 G multiplications a tile) is tiny, so reading, blending and writing
weigh more than with networks for real photos. The other is a plain stack of convolutions with random weights; a Pyramid
Attention Network has 5.3 G with a ResNet-10 encoder, 16.5 G with a ResNet-18. onnxruntime alone and tile by tile run as
onnxruntime does by default: one tile at a time, on all threads, which spin while they wait. Where the network itself
takes most of the time, nobody can be twice as fast on the same processor.

{polygons}

Peak memory (RSS, QGIS and libraries included) on an orthophoto of {large:,} × {large:,} pixels, in a process of its
own: **{peak}** (goal: ≤ {goal_bytes}; QGIS started and stopped: {start}); {seconds:.0f} s, once, for information."""


def write_usual_network(path: Path) -> int:
    """A network of some size with seven classes at a quarter of the resolution; gives its multiplications a tile."""
    import onnx_writer

    random = np.random.default_rng(1)
    network = onnx_writer.Network()
    multiplications, edge, bands = 0, TILE_PX, 3
    for channels, kernel, stride in ((32, 3, 2), (96, 3, 2), *[(96, 3, 1)] * 4, (7, 1, 1)):
        kernels = random.normal(0, (2 / (bands * kernel**2)) ** 0.5, (channels, bands, kernel, kernel))
        network.convolution(kernels, np.zeros(channels), stride)
        edge //= stride
        multiplications += kernels.size * edge**2
        bands = channels
        if channels > 7:
            network.add("Relu")
    scales = network.weight("scales", np.array([1, 1, 4, 4], np.float32))
    network.add("Resize", network.last, "", scales, mode="linear")
    metadata = {
        "class_names": {str(n): name for n, name in enumerate("abcdefg")},
        "tile_size": TILE_PX,
        "tiles_overlap": OVERLAP_PERCENT,
        "resolution": 100 * PIXEL_SIZE,
        "standardization_mean": [0.5] * 3,
        "standardization_std": [0.25] * 3,
    }
    shapes = [1, 3, TILE_PX, TILE_PX], [1, 7, TILE_PX, TILE_PX]
    texts = {key: json.dumps(value) for key, value in metadata.items()}
    path.write_bytes(onnx_writer.model_bytes(network, *shapes, texts))
    return multiplications


def bare_runner(model: Path, image: Path):
    """(number of tiles, function that runs onnxruntime on them)."""
    import onnxruntime

    from semref.core.segmentation.tiling import tile_starts

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = threads()
    session = onnxruntime.InferenceSession(str(model), options, providers=["CPUExecutionProvider"])
    settings = session.get_modelmeta().custom_metadata_map
    tile_px, overlap = int(settings["tile_size"]), float(settings["tiles_overlap"]) / 100
    name = session.get_inputs()[0].name
    pixels = np.ascontiguousarray(inputs.read_labels(image).astype(np.float32) / 255)
    starts = tile_starts(pixels.shape[1], tile_px, overlap)
    places = [(row, column) for row in starts for column in starts]

    def run() -> None:
        for row, column in places:
            session.run(None, {name: pixels[None, :, row : row + tile_px, column : column + tile_px]})

    return len(places), run


def write_photo(path: Path, edge: int) -> Path:
    """An RGB GeoTIFF, (edge, edge), in tiles and compressed, as orthophotos come: the sample area, mirrored."""
    from osgeo import gdal, osr
    from sample.files import grid_of
    from sample.landscape import make_landscape
    from sample.photo import render

    if path.exists():
        return path
    landscape = make_landscape(SEED)
    photo = render(landscape, grid_of(landscape, PIXEL_SIZE), PIXEL_SIZE)
    height, width = photo.shape[:2]
    pixels = np.pad(photo, ((0, max(0, edge - height)), (0, max(0, edge - width)), (0, 0)), mode="symmetric")
    options = ["TILED=YES", "COMPRESS=DEFLATE", "ZLEVEL=1", "PHOTOMETRIC=RGB", "INTERLEAVE=PIXEL"]
    target = gdal.GetDriverByName("GTiff").Create(str(path), edge, edge, 3, gdal.GDT_Byte, options)
    crs = osr.SpatialReference()
    crs.ImportFromEPSG(landscape.epsg)
    target.SetProjection(crs.ExportToWkt())
    target.SetGeoTransform((550000.0, PIXEL_SIZE, 0.0, 5220000.0, 0.0, -PIXEL_SIZE))
    target.WriteArray(np.ascontiguousarray(np.moveaxis(pixels[:edge, :edge], 2, 0)))
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
