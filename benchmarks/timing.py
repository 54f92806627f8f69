"""Time and memory: each function below is a measurement, named in scenarios/timing.toml."""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from benchmarks import photos, plain_build
from benchmarks.accuracy import GOAL, MapRow
from benchmarks.child import run_in_child
from benchmarks.ground import Ground, Wanted, chosen
from benchmarks.maps import World, build_parameters, read, run_algorithm, settings
from benchmarks.photos import SHIPPED
from benchmarks.places import place as place_of
from benchmarks.places import prepared
from benchmarks.results import ROOT, Table, rate, size
from benchmarks.tile_by_tile import TileByTile
from benchmarks.turns import on_processor, ratios, spread, take_turns
from semref.core.localization import Method, Prior

SEED = 1671
TILE_PX = 512


def run(world: World, name: str, scenario: dict[str, Any], only: Sequence[str]) -> list[Table]:
    """Run the measurement of a scenario."""
    return MEASUREMENTS[scenario["measure"]](world, scenario)


def one_fix(world: World, scenario: dict[str, Any]) -> list[Table]:
    """Measure the time of one position by method and number of landmarks, on one core."""
    cv2.setNumThreads(1)
    ground, rows = world.ground(scenario["map"], half="south"), []
    for landmarks in scenario["landmarks"]:
        known = ground if landmarks <= len(ground.references) else with_copies(ground, landmarks)
        for key in scenario["methods"] if known is ground else ("constellation",):
            method = next(one for one in Method if one.key == key)
            rng, trials = np.random.default_rng(SEED), []
            for _ in range((world.count or scenario["count"]) + 1):
                image = ground.spoiled(ground.draw(Wanted(), rng), GOAL, rng)
                trials.append(known.try_image(image, method))
            # The first one builds or opens the cached data of a database.
            milliseconds = 1000 * np.percentile([trial.seconds for trial in trials[1:]], [50, 95])
            right = sum(trial.is_right for trial in trials[1:])
            count = f"{len(known.database.references):,}"
            rows.append([count, key, *(f"{ms:.0f}" for ms in milliseconds), rate(right, len(trials) - 1)])
    return [{"columns": ["landmarks", "method", "ms median", "p95", "right fixes"], "rows": rows}]


def with_copies(ground: Ground, landmarks: int) -> Ground:
    """Return the same ground with a database that also has changed copies of its landmarks."""
    known, rng = ground.references, np.random.default_rng(SEED)
    many = chosen(known, np.arange(landmarks) % len(known))
    width = ground.frame.extent[2] - ground.frame.extent[0]
    for number in range(1, -(-landmarks // len(known))):
        copy = slice(number * len(known), (number + 1) * len(known))
        count = len(many.areas_m2[copy])
        many.positions[copy] += rng.normal(0, 15, known.positions.shape)[:count] + (number * 1.1 * width, 0)
        many.areas_m2[copy] *= np.exp(rng.normal(0, 0.3, len(known)))[:count]
    database = replace(ground.database, references=many)
    other = Ground(ground.labels_hw, database, size_px=ground.size_px)
    other.extent, other.references = ground.extent, known
    return other


def correlation(world: World, scenario: dict[str, Any]) -> list[Table]:
    """Measure the time of map correlation over a country and near a prior position, with all threads."""
    from semref.core.correlation.class_pyramid import MapPyramid
    from semref.core.localizer.localizer import Localizer

    ground, rows = world.ground(scenario["map"], half="south"), []
    ground.localizer.pyramid  # noqa: B018 - the first one is stored in the cache
    database = ground.database
    prepared = {
        "made": lambda: MapPyramid(database.overview, database.parameters.overview_frame),
        "opened": lambda: Localizer(database).pyramid,
    }
    pyramid = take_turns({who: on_processor(one) for who, one in prepared.items()}, scenario["turns"])
    for name, radius in (("whole map", None), ("within 1 km of a stated position", 1000.0)):
        rng, seconds, right = np.random.default_rng([SEED, 12]), [], 0
        for _ in range(world.count or scenario["count"]):
            image = ground.draw(Wanted(landmarks=(0, 10**9), labeled=0.7), rng)
            near = tuple(np.add(image.view.position, rng.uniform(-0.7, 0.7, 2) * 1000.0))
            started = time.perf_counter()
            trial = ground.try_image(image, Method.MAP_CORRELATION, Prior(near, radius) if radius else None)
            seconds.append(time.perf_counter() - started)
            right += trial.is_right
        line = (f"{np.median(seconds):.2f}", f"{np.percentile(seconds, 95):.2f}", rate(right, len(seconds)))
        rows.append([name, *line])
    return [
        {"columns": ["search", "s median", "p95", "right fixes"], "rows": rows},
        {"columns": ["pyramid", "processor s"], "rows": [[who, spread(some)] for who, some in pyramid.items()]},
    ]


def build(world: World, scenario: dict[str, Any]) -> list[Table]:
    """Compare building in this process, and the whole command, with the plain loop."""
    name, rows = scenario["map"], []
    labels, one, database = world.label_map(name), settings(name), world.work / "timed.gpkg"
    for stride in scenario["strides"]:
        sampled = scenario["windows"] if stride < one["stride"] else None
        candidates = {
            "ours": on_processor(lambda stride=stride: built(labels, name, stride)),
            "plain": lambda stride=stride, sampled=sampled: plainly(labels, name, stride, sampled),
            "command": lambda stride=stride: run_in_child(
                "builddatabase", build_parameters(name, labels, database, stride)
            )["whole"],
        }
        seconds = take_turns(candidates, scenario["turns"])
        compared = {who: ratios(seconds["plain"], seconds[who], 1) for who in ("ours", "command")}
        windows, worst = differences(labels, name, stride)
        middle = [f"{np.median(seconds[who]):.1f}" for who in ("ours", "plain", "command")]
        rows.append(
            [f"{one['window']:g} / {stride:g} m", compared["ours"], compared["command"], *middle, windows, worst]
        )
    columns = ["window / stride", "× faster, inside one process", "× faster, whole command", "s ours", "s plain loop"]
    return [{"columns": [*columns, "s command", "windows compared", "largest difference of vectors"], "rows": rows}]


def built(labels: Path, name: str, stride: float) -> Any:
    """Build a database with core: reading, landmarks, overview, hash, windows, vectors."""
    from osgeo import gdal

    from semref.core.database.build import BuildSettings, build_from_labels
    from semref.core.geometry.frame import MapFrame
    from semref.core.steps import result_of
    from semref.storage.label_maps import GdalLabels, hold_labels, stored_class_table

    cv2.setNumThreads(1)
    one, dataset = settings(name), gdal.Open(str(labels))
    frame = MapFrame(dataset.GetProjection(), tuple(dataset.GetGeoTransform()))
    source = result_of(hold_labels(GdalLabels(str(labels))))
    sizes = BuildSettings(one["window"], stride, one["minimum_area"])
    return build_from_labels(source, frame, stored_class_table(dataset, name), sizes, "benchmark")


def plainly(labels: Path, name: str, stride: float, sampled: int | None) -> float:
    """Return the seconds of the plain loop over all windows, extrapolated from a sample of windows."""
    cv2.setNumThreads(1)
    begin = time.process_time()
    image, grid, size_px, classes, minimum = _plain_inputs(labels, name, stride)
    plain_build.regions(image, classes, minimum)
    before = time.process_time() - begin
    chosen = grid if not sampled else [grid[n] for n in np.random.default_rng(SEED).choice(len(grid), sampled, False)]
    begin = time.process_time()
    plain_build.windows(image, chosen, size_px, classes, minimum)
    return before + (time.process_time() - begin) * len(grid) / len(chosen)


def differences(labels: Path, name: str, stride: float) -> tuple[str, str]:
    """Return the number of windows compared with the plain loop, and the largest difference of their vectors."""
    image, grid, size_px, classes, minimum = _plain_inputs(labels, name, stride)
    windows = built(labels, name, stride).windows
    place = {key: n for n, key in enumerate(windows.names.tolist())}
    chosen = [grid[n] for n in np.random.default_rng(SEED).choice(len(grid), min(500, len(grid)), False)]
    vectors, _ = plain_build.windows(image, chosen, size_px, classes, minimum)
    index = [place[f"{column}_{row}"] for column, row in chosen]
    return f"{len(chosen):,} of {len(grid):,}", f"{np.abs(windows.vectors[index] - vectors).max():.1e}"


def _plain_inputs(labels: Path, name: str, stride: float) -> tuple:
    from semref.storage.label_maps import GdalLabels, stored_class_table

    one, image = settings(name), read(labels)
    size_px, step = (int(length / one["pixel_size"]) for length in (one["window"], stride))
    height, width = image.shape
    grid = [(c, r) for r in range(0, height - size_px + 1, step) for c in range(0, width - size_px + 1, step)]
    classes = stored_class_table(GdalLabels(str(labels)).dataset, name).reference_values
    return image, grid, size_px, classes, one["minimum_area"] / one["pixel_size"] ** 2


def memory(world: World, scenario: dict[str, Any]) -> list[Table]:
    """Measure the peak memory of building from larger and larger maps: copies of the area side by side."""
    name = scenario["map"]
    labels, rows = world.label_map(name), [["QGIS started and stopped", "", size(run_in_child()["peak_bytes"])]]
    for across, down in scenario["grids"]:
        path, database = world.work / f"copies_{across}x{down}.tif", world.work / "copies.gpkg"
        pixels = write_copies(path, labels, across, down)
        found = run_in_child("builddatabase", build_parameters(name, path, database))
        rows.append([f"{pixels / 1e9:.2f} Gpx", f"{found['seconds']:.0f}", size(found["peak_bytes"])])
        path.unlink()
        database.unlink()
    return [{"columns": ["map", "s", "peak memory (RSS)"], "rows": rows}]


def write_copies(path: Path, template: Path, across: int, down: int) -> int:
    """Write a label map of copies of another map and return its number of pixels."""
    from semref.core.geometry.frame import MapFrame
    from semref.storage.label_map_file import TILE_ROWS, LabelMapFile
    from semref.storage.label_maps import GdalLabels, stored_class_table

    source, image = GdalLabels(str(template)).dataset, read(template)
    height, width = image.shape[0] * down, image.shape[1] * across
    table = stored_class_table(source, template.name)
    frame = MapFrame(source.GetProjection(), source.GetGeoTransform(), (height, width))
    with LabelMapFile(str(path), frame, table) as target:
        for first in range(0, height, TILE_ROWS):
            rows = np.arange(first, min(first + TILE_ROWS, height)) % image.shape[0]
            target.write_rows(first, np.tile(image[rows], (1, across)))
    return width * height


def segment(world: World, scenario: dict[str, Any]) -> list[Table]:
    """Compare segmenting with onnxruntime on the same tiles, and with the steps of Deepness."""
    folder = world.work / "segment"
    folder.mkdir(exist_ok=True)
    image, rows = write_photo(folder / "photo.tif", scenario["edge"]), []
    network = folder / "usual.onnx"
    write_network(network)
    for name, model in (("the shipped network", SHIPPED), ("6 G multiplications a tile", network)):
        given = {"INPUT": str(image), "MODEL": str(model), "OUTPUT": str(folder / "labels.tif")}
        tiles, bare = bare_runner(model, image)
        other = TileByTile(model, image)
        polygons = {**given, "POLYGONS": str(folder / "polygons.gpkg"), "MINIMUM_AREA": 25}
        candidates = {
            "segmentimage": lambda given=given: run_algorithm("segmentimage", given),
            "onnxruntime": bare,
            "tile by tile": other.labels,
            "with polygons": lambda polygons=polygons: run_algorithm("segmentimage", polygons),
            "tile by tile with polygons": lambda other=other: other.polygons(other.labels()),
        }
        seconds = take_turns({who: on_processor(one) for who, one in candidates.items()}, scenario["turns"])
        own = seconds["segmentimage"]
        rows.append(
            [
                name,
                f"{tiles / np.median(own):.1f}",
                ratios(own, seconds["onnxruntime"]),
                ratios(seconds["tile by tile"], own),
                ratios(seconds["tile by tile with polygons"], seconds["with polygons"]),
            ]
        )
    columns = ["network", "tiles/s", "times of bare onnxruntime", "× tile by tile", "× tile by tile, with polygons"]
    return [{"columns": columns, "rows": rows}]


def bare_runner(model: Path, image: Path) -> tuple[int, Callable[[], None]]:
    """Return the number of tiles, and a function that runs onnxruntime on them."""
    import onnxruntime

    from semref.core.segmentation.model import SegmentationModel
    from semref.core.segmentation.tiling import tile_starts
    from semref.processing.threads import worker_threads

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = worker_threads()
    session = onnxruntime.InferenceSession(str(model), options, providers=["CPUExecutionProvider"])
    own, name = SegmentationModel(str(model), 1), session.get_inputs()[0].name
    tile_px, overlap = own.tile_hw[0], own.settings.overlap
    pixels = np.ascontiguousarray(read(image).astype(np.float32) / 255)
    starts = tile_starts(pixels.shape[1], tile_px, overlap)

    def run_all() -> None:
        for row in starts:
            for column in starts:
                session.run(None, {name: pixels[None, :, row : row + tile_px, column : column + tile_px]})

    return len(starts) ** 2, run_all


def write_photo(path: Path, edge: int) -> Path:
    """Write an RGB GeoTIFF of (edge, edge) pixels of 1 m, tiled and compressed: the sample area, mirrored."""
    from osgeo import gdal, gdal_array

    from sample.landscape import make_landscape
    from sample.photo import render

    if path.exists():
        return path
    landscape = make_landscape(SEED)
    photo = render(landscape)
    missing = [(0, max(0, edge - length)) for length in photo.shape[:2]]
    pixels = np.pad(photo, (*missing, (0, 0)), mode="symmetric")[:edge, :edge]
    options = ["TILED=YES", "COMPRESS=DEFLATE", "ZLEVEL=1", "PHOTOMETRIC=RGB", "INTERLEAVE=PIXEL"]
    planes = gdal_array.OpenArray(np.ascontiguousarray(np.moveaxis(pixels, 2, 0)))
    place = {"outputSRS": f"EPSG:{landscape.epsg}", "outputBounds": [550000, 5220000, 550000 + edge, 5220000 - edge]}
    gdal.Translate(str(path), planes, creationOptions=options, **place)
    return path


def write_network(path: Path) -> None:
    """Write a stack of convolutions with seven classes and random weights, as large as networks for photos."""
    import onnx_writer

    random, network, bands = np.random.default_rng(1), onnx_writer.Network(), 3
    for channels, kernel, stride in ((32, 3, 2), (96, 3, 2), *[(96, 3, 1)] * 4, (7, 1, 1)):
        kernels = random.normal(0, (2 / (bands * kernel**2)) ** 0.5, (channels, bands, kernel, kernel))
        network.convolution(kernels, np.zeros(channels), stride)
        bands = channels
        if channels > 7:
            network.add("Relu")
    network.add("Resize", network.last, "", network.weight("scales", np.array([1, 1, 4, 4], np.float32)), mode="linear")
    texts = {
        "class_names": {str(n): name for n, name in enumerate("abcdefg")},
        "tile_size": TILE_PX,
        "tiles_overlap": 15,
        "resolution": 100.0,
        "standardization_mean": [0.5] * 3,
        "standardization_std": [0.25] * 3,
    }
    shapes = [1, 3, TILE_PX, TILE_PX], [1, 7, TILE_PX, TILE_PX]
    metadata = {key: json.dumps(value) for key, value in texts.items()}
    path.write_bytes(onnx_writer.model_bytes(network, *shapes, metadata))


def plugin_load(world: World, scenario: dict[str, Any]) -> list[Table]:
    """Measure the processor seconds of the plugin's start, in new processes of QGIS; the first compiles its files."""
    import shutil
    import subprocess

    code = (
        f"import sys, time; sys.path.insert(0, {str(ROOT / 'tools')!r})\n"
        "from qgis.core import QgsApplication\n"
        "app = QgsApplication([], True); app.initQgis()\n"
        "import os; sys.path.append(os.path.join(QgsApplication.pkgDataPath(), 'python', 'plugins'))\n"
        "from processing.core.Processing import Processing; Processing.initialize()\n"
        "from plugin_package import load_plugin_package; begin = time.process_time(); load_plugin_package()\n"
        "from semref.plugin import SemRefPlugin; plugin = SemRefPlugin(None); plugin.initProcessing()\n"
        "print(time.process_time() - begin, flush=True); os._exit(0)\n"
    )
    compiled = world.work / "compiled"
    shutil.rmtree(compiled, ignore_errors=True)
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    environment["PYTHONPYCACHEPREFIX"] = str(compiled)
    seconds = []
    for _ in range(1 + scenario["turns"]):
        done = subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd="/", env=environment
        )
        seconds.append(float(done.stdout.split()[-1]))
    rows = [["first start of a version", spread(seconds[:1])], ["later starts", spread(seconds[1:])]]
    return [{"columns": ["what", "processor s"], "rows": rows}]


def many_images(world: World, scenario: dict[str, Any]) -> list[Table]:
    """Compare *Localize images* on all cores with one, for label images and for photos of a place; measure memory."""
    from osgeo import gdal

    from semref.storage.label_map_file import CLASS_TABLE_ITEM
    from semref.storage.pictures import write_png

    ground, place = world.ground(scenario["map"]), photos.of(world, MapRow(**scenario["photos"]))
    rng, database, cores = np.random.default_rng(SEED), str(world.work / "many_photos.gpkg"), os.sched_getaffinity(0)
    count, rows = world.count or scenario["count"], []
    labels = prepared(place_of(scenario["photos"]["photos"]).photos[0], world.data, photos.PLACE_PIXEL_M, world.work)[1]
    gdal.Open(str(labels), gdal.GA_Update).SetMetadataItem(CLASS_TABLE_ITEM, photos.BUILDINGS_ONLY)
    sizes = {"WINDOW_SIZE": 64, "STRIDE": 16, "MINIMUM_AREA": 3.75}
    run_algorithm("builddatabase", {"LABELS": str(labels), **sizes, "DATABASE": database})
    draw = {
        "label images": lambda: ground.spoiled(ground.draw(Wanted(), rng), GOAL, rng).labels_hw[None],
        "photos": lambda: np.moveaxis(place.crop(rng)[1], 2, 0),
    }
    given = {
        "label images": {"DATABASE": str(world.database(scenario["map"]))},
        "photos": {"DATABASE": database, "MODEL": str(ROOT / "models" / "buildings.onnx")},
    }
    for kind, folder in ((kind, world.work / "many" / kind) for kind in draw):
        folder.mkdir(parents=True, exist_ok=True)
        for number in range(count):
            write_png(folder / f"{number:03d}.png", draw[kind]())
        wanted = {**given[kind], "IMAGES": str(folder), "OUTPUT": str(world.work / "many.gpkg")}

        def localized(used: set[int], wanted: dict[str, str] = wanted) -> None:
            os.sched_setaffinity(0, used)
            run_algorithm("localizeimages", wanted)

        ways = {"all": partial(localized, cores), "one": partial(localized, {min(cores)})}
        seconds = take_turns(ways, scenario["turns"])
        os.sched_setaffinity(0, cores)
        peak, each = run_in_child("localizeimages", wanted)["peak_bytes"], np.median(seconds["all"]) / count
        rows.append([f"{count} {kind}", ratios(seconds["one"], seconds["all"]), f"{each:.3f}", size(peak)])
    columns = ["what", f"× faster with {len(cores)} cores than with one", "s an image", "peak memory (RSS)"]
    return [{"columns": columns, "rows": rows}]


def on_board(world: World, scenario: dict[str, Any]) -> list[Table]:
    """Measure the processor seconds of each photo of a flight with ``semref watch --flight``, on one core."""
    from sample import __main__ as sample
    from semref.core.onboard.command_line import main
    from semref.core.onboard.image_records import ImageFinder

    cv2.setNumThreads(1)
    folder, area = world.work / "sample_photos", world.work / "sample.npz"
    if not folder.exists():
        sample.main([str(folder)])
    run_algorithm("exportonboard", {"DATABASE": str(world.database("sample")), "OUTPUT": str(area)})
    localize, seconds, lines = ImageFinder.__call__, [], world.work / "fixes.jsonl"

    def timed(finder: ImageFinder, path: str) -> dict[str, Any]:
        begin = time.process_time()
        record = localize(finder, path)
        seconds.append(time.process_time() - begin)
        return record

    ImageFinder.__call__ = timed
    try:
        for _ in range(scenario["turns"]):
            state = world.work / "flight.state"
            for path in (state, lines):
                path.unlink(missing_ok=True)
            watched = ["watch", str(folder / "flight"), "--database", str(area), "--model", str(SHIPPED), "--flight"]
            main([*watched, "--once", "--state", str(state), "--fixes", str(lines)])
    finally:
        ImageFinder.__call__ = localize
    fixes = [json.loads(line)["status"] == "fix" for line in lines.read_text(encoding="utf-8").splitlines()]
    median, high = np.percentile(seconds, [50, 95])
    row = [f"{median:.2f}", f"{high:.2f}", rate(sum(fixes), len(fixes))]
    return [{"columns": ["processor s an image, median", "p95", "fixes"], "rows": [row]}]


def onboard_file(world: World, scenario: dict[str, Any]) -> list[Table]:
    """Measure the size of onboard files without an overview, and the part of it that landmarks take."""
    import zipfile

    rows, path = [], world.work / "onboard.npz"
    for name in scenario["maps"]:
        given = {"DATABASE": str(world.database(name)), "OVERVIEW": False, "OUTPUT": str(path)}
        run_algorithm("exportonboard", given)
        with zipfile.ZipFile(path) as archive:
            members = {one.filename: one.compress_size for one in archive.infolist()}
            with archive.open("references_areas.npy") as file:
                landmarks = len(np.load(file))
        each = sum(bytes_ for member, bytes_ in members.items() if member.startswith("references_")) / landmarks
        rows.append([name, f"{landmarks:,}", f"{path.stat().st_size:,}", f"{each:.1f}"])
    return [{"columns": ["map", "landmarks", "bytes", "bytes per landmark"], "rows": rows}]


def update(world: World, scenario: dict[str, Any]) -> list[Table]:
    """Compare the update of a database after the edit of one rectangle with building it again, and with QGIS alone."""
    import processing
    from osgeo import gdal
    from qgis.core import QgsRasterLayer, QgsRectangle, QgsReferencedRectangle

    name = scenario["map"]
    labels, edited, database = world.label_map(name), world.work / "edited.tif", world.work / "updated.gpkg"
    gdal.GetDriverByName("GTiff").CreateCopy(str(edited), gdal.Open(str(labels)), options=["TILED=YES"])
    dataset, rng = gdal.Open(str(edited), gdal.GA_Update), np.random.default_rng(SEED)
    height, width = dataset.RasterYSize, dataset.RasterXSize
    column, row = int(rng.integers(width // 3, width // 2)), int(rng.integers(height // 3, height // 2))
    dataset.GetRasterBand(1).WriteArray(np.ones((40, 40), np.uint8), column, row)
    left, pixel, _, top, _, _ = dataset.GetGeoTransform()
    area = QgsRectangle(
        left + column * pixel, top - (row + 40) * pixel, left + (column + 40) * pixel, top - row * pixel
    )
    dataset, changed = None, str(world.work / "changed.gpkg")
    extent = QgsReferencedRectangle(area, QgsRasterLayer(str(edited)).crs())
    processing.run("native:extenttolayer", {"INPUT": extent, "OUTPUT": changed})
    whole = {"DATABASE": str(world.database(name)), "LABELS": str(edited), "OUTPUT": str(database)}
    stated = {**whole, "CHANGED": changed}
    again = build_parameters(name, edited, database)
    compared = {
        "built again": {
            "changed area stated": on_processor(lambda: run_algorithm("updatedatabase", stated)),
            "changes found": on_processor(lambda: run_algorithm("updatedatabase", whole)),
            "built again": on_processor(lambda: run_algorithm("builddatabase", again)),
        },
        "QGIS started and stopped": {
            "whole command, changed area stated": lambda: run_in_child("updatedatabase", stated)["whole"],
            "whole command, built again": lambda: run_in_child("builddatabase", again)["whole"],
            "QGIS started and stopped": lambda: run_in_child()["whole"],
        },
    }
    run_algorithm("updatedatabase", stated)  # imports modules
    seconds = take_turns({who: one for group in compared.values() for who, one in group.items()}, scenario["turns"])
    rows = [
        [who, spread(seconds[who]), f"{ratios(seconds[who], seconds[other])} of “{other}”"]
        for other, group in compared.items()
        for who in group
    ]
    return [{"columns": ["what", "s (processor s in one process)", "share"], "rows": rows}]


MEASUREMENTS = {
    "one fix": one_fix,
    "correlation": correlation,
    "build": build,
    "memory": memory,
    "segment": segment,
    "plugin load": plugin_load,
    "many images": many_images,
    "on board": on_board,
    "onboard file": onboard_file,
    "update": update,
}
