"""The command line of ``python -m cluster``."""

from __future__ import annotations

import argparse
from typing import Any, Callable

from ..core.assessment.offered import OFFERED as ASSUMED
from ..core.evaluation.offered import OFFERED
from ..core.geometry.error_settings import MAP_ACCURACY
from ..core.segmentation.devices import KEYS

DONE, SOME_WITHOUT_FIX, WRONG_USAGE, REFUSED, INTERRUPTED = 0, 1, 2, 3, 130
"""Exit codes; argparse ends with 2 by itself."""

_MOST_WORKERS = 1024
"""Of one machine."""

_DESCRIPTION = """Does SemRef's long work on many processes or machines by Dask, without QGIS. The result is the same,
byte by byte, however many there are."""

_EPILOG = f"""exit codes:
  {DONE}    done
  {SOME_WITHOUT_FIX}    localize: an image has no fix, its reason is told
  {WRONG_USAGE}    the command line is wrong
  {REFUSED}    a package is missing, a file could not be used, the workers failed, or the program has a fault
  {INTERRUPTED}  ended by Ctrl+C; nothing lies under the final name

examples, from the plugin's folder:
  python -m cluster rasterize landcover.gpkg --class-field class --labels labels.tif --pixel-size 0.5 --local 4
  python -m cluster build labels.tif --database out.gpkg --reference-classes "building;water" --local 4
  python -m cluster build /vsis3/maps/labels.tif --database out.gpkg --scheduler tcp://10.0.0.5:8786
  python -m cluster segment orthophoto.vrt --model landcover.onnx --labels labels.tif --local 4
  python -m cluster evaluate area.gpkg labels.tif --output numbers.json --trials 400 --local 4
  python -m cluster assess area.gpkg --output squares.gpkg --footprints "640;1280" --local 4
  python -m cluster localize photos/ --database area.npz --model landcover.onnx --json --local 4

docs/guide/cluster.md tells how to start workers on a laptop, with SLURM and with Kubernetes."""

_LABELS = (
    "single-band raster of class values in a metric CRS: a path that all workers see, a VRT of many files, or a name "
    "of GDAL's such as /vsis3/BUCKET/labels.tif"
)
_CLASSES = (
    "names or values of the classes whose regions are landmarks, separated by “;”; by default those with this role in "
    "the map's class table"
)


def within(kind: type, least: float, most: float) -> Callable[[str], float]:
    """A type of option: a number from least to most, as the algorithm of QGIS takes it."""

    def number(text: str) -> float:
        found = kind(text)
        if not least <= found <= most:
            raise ValueError
        return found

    # Argparse says it of a text that is none.
    number.__name__ = f"number from {least:g} to {most:g}"
    return number


_BUILD: tuple[tuple[str, str, Any, Any, str], ...] = (
    ("--database", "FILE", str, "", "the GeoPackage to write, on this machine"),
    ("--reference-classes", "CLASSES", str, None, _CLASSES),
    ("--window-size", "LENGTH", float, 1280.0, "map units (1280)"),
    ("--stride", "LENGTH", float, 350.0, "map units (350)"),
    ("--levels", "NUMBERS", str, "1", "multipliers of both, separated by “;” (1)"),
    ("--references-per-vector", "COUNT", within(int, 3, 1000), 10, "landmarks that a vector holds (10)"),
    ("--minimum-area", "AREA", float, 100.0, "of a landmark, m² (100)"),
    (
        "--map-accuracy",
        "LENGTH",
        within(float, 0, 10_000),
        MAP_ACCURACY,
        "standard deviation of where landmarks are, map units (1.1)",
    ),
)
"""Option, what its value is called, its type, its default (an empty one: must be given), what it says."""

_SEGMENT: tuple[tuple[str, str, Any, Any, str], ...] = (
    ("--model", "FILE", str, "", "the network (ONNX): a path that all workers see"),
    ("--labels", "FILE", str, "", "the GeoTIFF to write, on this machine"),
    ("--class-table", "FILE", str, None, "values and colors for the model's classes, a CSV"),
    ("--resolution", "CM", within(float, 1e-3, 1e6), None, "of a pixel as the network sees it; by default the model's"),
    ("--overlap", "PERCENT", within(float, 0, 75), None, "of tiles; by default the model's"),
)
"""As _BUILD."""

_EVALUATE: tuple[tuple[str, str, Any, Any, str], ...] = (
    ("--output", "FILE", str, "", "the JSON to write, on this machine"),
    ("--methods", "METHODS", str, "automatic;topology-vector", "separated by “;” (automatic;topology-vector)"),
    (
        "--trials",
        "COUNT",
        within(int, 1, 1_000_000),
        200,
        "images; tables need 1.5 times as many again (200)",
    ),
    ("--mirrored", "PERCENT", within(float, 0, 90), 25.0, "of them that are mirrored and can't be right (25)"),
    ("--minimum-references", "COUNT", within(int, 0, 1_000_000), 3, "landmarks of windows that images lie around (3)"),
    ("--right-within", "LENGTH", within(float, 0, 1e9), None, "map units; by default 2 % of the ground's edge"),
    ("--seed", "NUMBER", within(int, 0, 2**31 - 1), 1, "another number gives other images (1)"),
    *(
        (f"--{name}", "LOW,HIGH", str, None, f"as the algorithm's {name.upper()} ({low:g},{high:g})")
        for name, (low, high) in OFFERED.items()
    ),
)
"""As _BUILD."""

_ASSESS: tuple[tuple[str, str, Any, Any, str], ...] = (
    ("--output", "FILE", str, "", "the GeoPackage of squares to write, on this machine"),
    ("--footprints", "LENGTHS", str, None, "edges of the ground that images show, separated by “;” (the window size)"),
    ("--spacing", "LENGTH", float, None, "edge of the squares; by default half the smallest footprint"),
    ("--trials", "COUNT", within(int, 20, 100_000), 1000, "simulated images of each footprint (1000)"),
    ("--threshold", "PERCENT", within(float, 1, 99.9), 90.0, "expected success that is good enough (90)"),
    ("--seed", "NUMBER", within(int, 0, 2**31 - 1), 1, "another number gives other images (1)"),
    *(
        (f"--{name}", "NUMBER", within(float, 0, most or 1e9), None, f"as the algorithm's {name.upper()} ({usual:g})")
        for name, (usual, most) in ASSUMED.items()
    ),
)
"""As _BUILD."""

_RASTERIZE: tuple[tuple[str, str, Any, Any, str], ...] = (
    ("--labels", "FILE", str, "", "the GeoTIFF to write, on this machine"),
    ("--class-field", "NAME", str, "", "text or number field that tells the class of each polygon"),
    ("--priority-field", "NAME", str, None, "number field: the higher lies on top; by default the draw order"),
    ("--class-table", "FILE", str, None, "values and colors of the classes, a CSV; by default what the field holds"),
    ("--layer", "NAME", str, None, "of a file of several"),
    ("--pixel-size", "M", within(float, 0.001, 1e6), 1.0, "edge of a pixel (1)"),
    ("--extent", "LEFT,BOTTOM,RIGHT,TOP", str, None, "map units; by default that of the polygons"),
)
"""As _BUILD."""

_IMAGE = "a photo or an orthophoto: a path that all workers see, a VRT of many files, or a name of GDAL's"
_DEVICE = "what runs the network at the workers (cpu); graphics cards may round otherwise"
_JSON = "tells what happens as a line of JSON each, on the output"
_ANNOTATION = (
    "polygons in a metric CRS that GDAL reads, read on this machine alone: GeoPackage, shapefile, FlatGeobuf …"
)
_OTHER_GROUND = "ground without a polygon, within the extent of the polygons, becomes the class “other”"
_LANDMARKS_ALONE = "assesses landmarks alone, as the algorithm with MAP_CORRELATION switched off"
_SCHEDULER = "uses the workers of a scheduler, such as tcp://10.0.0.5:8786"
_MEMORY = (
    "with --local: of one worker, such as 2GB; by default the machine's, divided by N. A worker that takes more is "
    "ended, and its piece of the work done again"
)


def parser() -> argparse.ArgumentParser:
    """Reads the command line."""
    made = argparse.ArgumentParser(
        "python -m cluster",
        description=_DESCRIPTION,
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    commands = made.add_subparsers(title="commands", metavar="COMMAND", dest="command", required=True)
    build = commands.add_parser(
        "build",
        help="label map to reference database, as semref:builddatabase",
        description="Builds the reference database of a label map, as semref:builddatabase does in QGIS.",
    )
    build.add_argument("labels", metavar="LABELS", help=_LABELS)
    _add_all(build, _BUILD)
    # For QGIS, which writes its own.
    build.add_argument("--without-note", action="store_true", help=argparse.SUPPRESS)
    _add_workers(build)
    rasterize = commands.add_parser(
        "rasterize",
        help="polygons to label map, as semref:rasterizeannotation",
        description="Burns the polygons of a file into a label map, as semref:rasterizeannotation in QGIS.",
    )
    rasterize.add_argument("annotation", metavar="ANNOTATION", help=_ANNOTATION)
    _add_all(rasterize, _RASTERIZE)
    rasterize.add_argument("--other-ground", action="store_true", help=_OTHER_GROUND)
    _add_workers(rasterize)
    segment = commands.add_parser(
        "segment",
        help="photo or orthophoto to label map, as semref:segmentimage",
        description="Turns a photo or an orthophoto into a label map by a network, as semref:segmentimage in QGIS.",
    )
    segment.add_argument("image", metavar="IMAGE", help=_IMAGE)
    _add_all(segment, _SEGMENT)
    segment.add_argument("--device", choices=KEYS, default="cpu", help=_DEVICE)
    _add_workers(segment)
    evaluate = commands.add_parser(
        "evaluate",
        help="how well a database localizes, as semref:evaluatelocalization",
        description="Tries a database with images cut from a label map, as semref:evaluatelocalization in QGIS, and "
        "writes its numbers.",
    )
    evaluate.add_argument("database", metavar="DATABASE", help="a path that all workers see")
    evaluate.add_argument("labels", metavar="LABELS", help=_LABELS)
    _add_all(evaluate, _EVALUATE)
    _add_workers(evaluate)
    assess = commands.add_parser(
        "assess",
        help="where a database will localize, as semref:assessdatabase",
        description="Tells of each square of ground how images will be localized with a database, as "
        "semref:assessdatabase in QGIS.",
    )
    assess.add_argument("database", metavar="DATABASE", help="a path that all workers see")
    _add_all(assess, _ASSESS)
    assess.add_argument("--without-map-correlation", action="store_true", help=_LANDMARKS_ALONE)
    _add_workers(assess)
    for command in (rasterize, build, segment, evaluate, assess):
        command.add_argument("--json", action="store_true", help=_JSON)
    localize = commands.add_parser(
        "localize",
        help="localize images, as python -m core localize",
        description="Localizes images in an onboard file. IMAGE, --database and all other options are those of "
        "python -m core localize, whose --help tells them; so are records, their order and the exit code.",
        usage="python -m cluster localize [options of python -m core localize] (--local N | --scheduler ADDRESS)",
        allow_abbrev=False,
    )
    _add_workers(localize)
    # Of QGIS alone, which is not told about: a job of storage.carried's, and where its answer goes.
    order = commands.add_parser("order", description="Does what QGIS wrote down.")
    order.add_argument("order", metavar="FILE")
    order.add_argument("--found", metavar="FILE", required=True)
    burn = commands.add_parser("burn", description="Burns the polygons that QGIS wrote down.")
    burn.add_argument("order", metavar="FILE")
    burn.add_argument("--labels", metavar="FILE", required=True)
    for command in (order, burn):
        command.add_argument("--json", action="store_true", help=_JSON)
        _add_workers(command)
    return made


def _add_all(command: argparse.ArgumentParser, options: tuple[tuple[str, str, Any, Any, str], ...]) -> None:
    for name, value, kind, default, text in options:
        shown = text.replace("%", "%%")
        command.add_argument(name, metavar=value, type=kind, default=default, required=default == "", help=shown)


def _add_workers(command: argparse.ArgumentParser) -> None:
    where = command.add_mutually_exclusive_group(required=True)
    where.add_argument(
        "--local", type=within(int, 1, _MOST_WORKERS), metavar="N", help="starts N worker processes on this machine"
    )
    where.add_argument("--scheduler", metavar="ADDRESS", help=_SCHEDULER)
    command.add_argument("--worker-memory", metavar="SIZE", help=_MEMORY)
