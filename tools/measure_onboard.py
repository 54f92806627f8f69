"""Measures onboard files and localizing with them on Liechtenstein 2021; prints Markdown.

    python tools/measure_onboard.py [--images 100] [--python PYTHON] [--seed 1] [--keep FOLDER]

Sizes of the whole area and of a piece with as many windows as the paper's map has (276), part by part; “windows alone”
is the file without what the paper's does not have, landmarks and overview. Then the same
images localized by the plugin in the GeoPackage and by ``python -m core`` in the onboard file, from a copy of the
folder alone, with --python (one without QGIS makes the proof; by default this one): same status, how far the positions
are apart; start-up, times an image and peak memory on one core. Reads $SEMREF_DATA or ../shared/data.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

import cv2  # noqa: E402
import numpy as np  # noqa: E402
from qgis_session import ROOT, load_plugin_package, qgis_session  # noqa: E402

load_plugin_package()
from semref.core.labels.sources import ArrayLabels  # noqa: E402
from semref.core.landmarks.landmarks import extract_landmarks  # noqa: E402
from semref.core.onboard.read import read_onboard  # noqa: E402
from semref.core.simulation.noise import LabelNoise, spoil_labels  # noqa: E402
from semref.core.simulation.views import PIXELS, View, cut, random_view  # noqa: E402

DATA = Path(os.environ.get("SEMREF_DATA") or ROOT.parent / "shared" / "data")
LAYER = DATA / "osm_liechtenstein_2021" / "li_landcover_2021.shp"
WINDOW, STRIDE, MINIMUM_AREA = 1280, 350, 100
PAPERS_GRID = 23, 12  # 276 windows, as many as the paper's database has
PAPERS_BYTES = 77_500
LEAST_OBJECTS = 20
RAGGED = LabelNoise(jitter=2.0)
HEADER = (
    "| what | windows | references | bytes | bytes a window | bytes a reference | overview, header | windows alone |\n"
    "|---|---|---|---|---|---|---|---|"
)
METHODS = ((0, "automatic"), (1, "topology-vector"))


def main() -> int:
    options = parse()
    if not LAYER.exists():
        print(f"measure_onboard: the real data is not here: {LAYER}")
        return 0
    cv2.setNumThreads(1)
    with tempfile.TemporaryDirectory() as folder, qgis_session():
        work = Path(options.keep or folder)
        work.mkdir(parents=True, exist_ok=True)
        labels = label_map(work)
        piece = papers_piece(labels, work)
        print(HEADER, flush=True)
        databases = {"276 windows": database(piece, work), "Liechtenstein": database(labels, work)}
        for name, path in databases.items():
            for overview in (False, True):
                print_sizes(f"{name}, {'with' if overview else 'without'} overview", export(path, overview))
        for name, path in (("276 windows", piece), ("Liechtenstein", labels)):
            print(f"\nThe label map of {name} has {path.stat().st_size:,} bytes as GeoTIFF (DEFLATE), ", end="")
            print(f"the database {databases[name].stat().st_size:,}.")
        print(f"The paper's vectors of 276 windows take {PAPERS_BYTES:,} bytes.\n", flush=True)
        onboard = export(databases["Liechtenstein"], True)
        copy_core(work)
        for method, option in METHODS:
            images = work / option
            cut_images(labels, images, options, on_windows=method == 1)
            plugin = localize_in_qgis(databases["Liechtenstein"], images, method, work)
            alone, log, usage = localize_alone(options.python, onboard, images, option, work)
            print_comparison(option, plugin, alone)
            print_times(log, usage)
    return 0


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--images", type=int, default=100)
    parser.add_argument("--python", default=sys.executable, help="that runs python -m core")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", help="folder for what is made; what is there already is used again")
    return parser.parse_args()


# --- databases and files ---


def label_map(work: Path) -> Path:
    target = work / "liechtenstein.tif"
    parameters = {"INPUT": str(LAYER), "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder", "PIXEL_SIZE": 1}
    return run("rasterizeannotation", target, "OUTPUT", parameters)


def papers_piece(labels: Path, work: Path) -> Path:
    """A piece of the map with PAPERS_GRID windows, in the middle."""
    from osgeo import gdal

    target = work / "piece.tif"
    width, height = (WINDOW + (count - 1) * STRIDE for count in PAPERS_GRID)
    dataset = gdal.Open(str(labels))
    left, top = (dataset.RasterXSize - width) // 2, (dataset.RasterYSize - height) // 2
    options = ["COMPRESS=DEFLATE", "TILED=YES"]
    gdal.Translate(str(target), dataset, srcWin=[left, top, width, height], creationOptions=options)
    return target


def database(labels: Path, work: Path) -> Path:
    parameters = {
        "LABELS": str(labels),
        "REFERENCE_CLASSES": "building;bare_land;water",
        "WINDOW_SIZE": WINDOW,
        "STRIDE": STRIDE,
        "MINIMUM_AREA": MINIMUM_AREA,
    }
    return run("builddatabase", work / f"{labels.stem}.gpkg", "DATABASE", parameters)


def export(path: Path, overview: bool) -> Path:
    target = path.with_name(f"{path.stem}{'' if overview else '_bare'}.npz")
    return run("exportonboard", target, "OUTPUT", {"DATABASE": str(path), "OVERVIEW": overview})


def run(algorithm: str, target: Path, key: str, parameters: dict) -> Path:
    import processing

    if not target.exists():
        processing.run(f"semref:{algorithm}", {**parameters, key: str(target)})
    return target


def print_sizes(name: str, path: Path) -> None:
    with zipfile.ZipFile(path) as archive:
        sizes = {info.filename[:-4]: info.compress_size for info in archive.infolist()}
    found = read_onboard(str(path)).database
    windows, references = len(found.windows), len(found.references)
    parts = [sum(size for part, size in sizes.items() if part.startswith(kind)) for kind in ("windows_", "references_")]
    rest = sizes.get("overview_labels", 0), sizes["header"]
    print(
        f"| {name} | {windows} | {references} | {path.stat().st_size:,} | {parts[0] / windows:.1f} | "
        f"{parts[1] / references:.1f} | {rest[0]:,}, {rest[1]:,} | "
        f"{path.stat().st_size - parts[1] - rest[0]:,} |",
        flush=True,
    )


# --- images ---


def cut_images(labels: Path, folder: Path, options: argparse.Namespace, on_windows: bool) -> None:
    """Turned and scaled views anywhere, edges ragged by 2 px; for topology vectors windows, as they can find others."""
    from osgeo import gdal

    if folder.exists():
        return
    folder.mkdir()
    source = ArrayLabels(gdal.Open(str(labels)).ReadAsArray())
    height, width = source.shape_hw
    rng = np.random.default_rng(options.seed)
    number = 0
    while number < options.images:
        if on_windows:
            column, row = (int(rng.integers((size - WINDOW) // STRIDE + 1)) * STRIDE for size in (width, height))
            view = View(column + WINDOW / 2, -row - WINDOW / 2, 0.0, 1.0, WINDOW, WINDOW)
        else:
            view = random_view(rng, (0, -height, width, 0), (WINDOW, WINDOW), (0.8, 1.25))
        seen = cut(source, PIXELS, view)
        if len(extract_landmarks(seen, (1, 2, 3), MINIMUM_AREA)) < LEAST_OBJECTS:
            continue
        cv2.imwrite(str(folder / f"{number:04d}.png"), spoil_labels(seen, RAGGED, rng, (1, 2, 3)))
        number += 1


def localize_in_qgis(path: Path, images: Path, method: int, work: Path) -> list:
    import processing
    from osgeo import gdal

    target = work / f"fixes_{method}.gpkg"
    if not target.exists():
        parameters = {"DATABASE": str(path), "IMAGES": [str(images)], "METHOD": method, "OUTPUT": str(target)}
        processing.run("semref:localizeimages", parameters)
    source = gdal.OpenEx(str(target))
    return [feature.items() for feature in source.GetLayer(0)]


def copy_core(work: Path) -> None:
    shutil.rmtree(work / "core", ignore_errors=True)
    shutil.copytree(ROOT / "core", work / "core", ignore=shutil.ignore_patterns("__pycache__"))


def localize_alone(python: str, onboard: Path, images: Path, method: str, work: Path) -> tuple:
    """Rows, entries of the log, and what the process used, on one core."""
    command = [python, "-m", "core", "localize", str(images), "--database", str(onboard), "--method", method, "--json"]
    with open(work / "alone.jsonl", "w") as out, open(work / "alone.log", "w") as log:
        child = subprocess.Popen(
            [*command, "--log-level", "info"],
            cwd=work,
            stdout=out,
            stderr=log,
            preexec_fn=lambda: os.sched_setaffinity(0, {min(os.sched_getaffinity(0))}),
        )
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    texts = [(work / name).read_text(encoding="utf-8").splitlines() for name in ("alone.jsonl", "alone.log")]
    return [json.loads(line) for line in texts[0]], [json.loads(line) for line in texts[1]], usage


# --- what came of it ---


def print_comparison(method: str, plugin: list, alone: list) -> None:
    same = sum(a["status"] == b["status"] and a["window"] == b["window"] for a, b in zip(plugin, alone))
    both = [(a, b) for a, b in zip(plugin, alone) if a["x"] is not None and b["x"] is not None]
    apart = np.array([np.hypot(a["x"] - b["x"], a["y"] - b["y"]) for a, b in both])
    degrees = [abs(a["longitude"] - b["longitude"]) + abs(a["latitude"] - b["latitude"]) for a, b in both]
    confidence = [abs(a["confidence"] - b["confidence"]) for a, b in both]
    print(
        f"{method}: {len(plugin)} images, {sum(row['status'] == 'fix' for row in plugin)} fixes by the plugin, "
        f"{sum(row['status'] == 'fix' for row in alone)} without QGIS; same status and window: {same}. "
        f"Positions apart: median {np.median(apart):.4f} m, most {apart.max():.4f} m; longitude and latitude by "
        f"{max(degrees):.2g}° at most, confidence by {max(confidence):.2g}.",
        flush=True,
    )


def print_times(log: list, usage) -> None:
    seconds = np.array([entry["seconds"] for entry in log if entry["event"] == "image"])
    print(
        f"    first image {seconds[0]:.2f} s (it builds the index), then p50 {np.median(seconds[1:]):.3f} s, p95 "
        f"{np.percentile(seconds[1:], 95):.3f} s; processor time of all {usage.ru_utime + usage.ru_stime:.1f} s, "
        f"peak memory {usage.ru_maxrss / 1024:.0f} MB.",
        flush=True,
    )


if __name__ == "__main__":
    sys.exit(main())
