"""Onboard files: bytes a window and a landmark, and the same images localized with QGIS and from a copy of core alone.

`--python` names the Python that runs the copy; one without QGIS makes the proof.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import zipfile
from pathlib import Path

import cv2
import numpy as np

from bench import inputs, page, plugin
from bench.ground import Ground, Wanted
from bench.sizes import PAPER_BYTES, paper_database
from semref.core.localization import Method
from semref.core.onboard.read import read_onboard
from semref.core.simulation.noise import LabelNoise

PAGE = "benchmarks.md"
SEED = 1
COUNT, QUICK_COUNT = 100, 2
RAGGED = LabelNoise(jitter=2.0)
METHODS = ((Method.AUTOMATIC, "automatic"), (Method.TOPOLOGY_VECTOR, "topology-vector"))
SIZES = (
    "file",
    "windows",
    "landmarks",
    "bytes",
    "bytes a window",
    "bytes a landmark",
    "overview",
    "header",
    "without landmarks and overview",
)


def measure(run: inputs.Run) -> dict[str, str]:
    folder = run.work / "onboard"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    whole = run.database(run.area.stride)
    rows = []
    for name, path in (("the paper's 276 windows", paper_database(run)), (run.area.name, whole)):
        for overview in (False, True):
            target = export(path, folder / f"{path.stem}_{overview}.npz", overview)
            rows.append([f"{name}, {'with' if overview else 'without'} overview", *sizes(target)])
    shutil.copytree(inputs.TOOLS.parent / "core", folder / "core", ignore=shutil.ignore_patterns("__pycache__"))
    told = []
    for method, option in METHODS:
        images = folder / option
        cut_images(run, images, method == Method.TOPOLOGY_VECTOR)
        fixes = localized_in_qgis(whole, images, method, folder)
        alone, log, usage = localized_alone(run.python, target, images, option, folder)
        told.append(f"- {option}: {compared(fixes, alone)} {times(log, usage)}")
    return {"onboard file": "\n\n".join([_ABOUT.format(paper=PAPER_BYTES), page.table(SIZES, rows), "\n".join(told)])}


_ABOUT = """\
The paper's vectors of 276 windows take {paper:,} bytes. Goal: ≤ 40 B a window, ≤ 20 B a landmark. Below: the same
images (any place and heading for automatic, windows for topology vectors, boundaries jittered by 2 px) in the plugin
with the GeoPackage, and by `python -m core` with the onboard file, from a copy of the folder alone, on one core."""


def export(database: Path, target: Path, overview: bool) -> Path:
    plugin.run_algorithm("exportonboard", {"DATABASE": str(database), "OVERVIEW": overview, "OUTPUT": str(target)})
    return target


def sizes(path: Path) -> list[str]:
    """Cells of a row of SIZES."""
    with zipfile.ZipFile(path) as archive:
        packed = {info.filename[:-4]: info.compress_size for info in archive.infolist()}
    found = read_onboard(str(path)).database
    windows, landmarks = (
        sum(size for part, size in packed.items() if part.startswith(kind)) for kind in ("windows_", "references_")
    )
    size, overview = path.stat().st_size, packed.get("overview_labels", 0)
    each = f"{windows / len(found.windows):.1f}", f"{landmarks / len(found.references):.1f}"
    counts = f"{len(found.windows):,}", f"{len(found.references):,}", f"{size:,}"
    return [*counts, *each, f"{overview:,}", f"{packed['header']:,}", f"{size - landmarks - overview:,}"]


def cut_images(run: inputs.Run, folder: Path, on_windows: bool) -> None:
    """Label images as files: turned and scaled views anywhere, or windows, as topology vectors find no others."""
    folder.mkdir()
    ground, rng = Ground.of(run, half=""), np.random.default_rng(SEED)
    windows = ground.choose_windows(run.how_many(COUNT, QUICK_COUNT))
    for number in range(run.how_many(COUNT, QUICK_COUNT)):
        window = windows[number % len(windows)]
        image = ground.image(ground.view_on(window)) if on_windows else ground.draw(Wanted(), rng)
        cv2.imwrite(str(folder / f"{number:04d}.png"), ground.spoiled(image, RAGGED, rng).labels_hw)


def localized_in_qgis(database: Path, images: Path, method: Method, folder: Path) -> list[dict]:
    """Rows of semref:localizeimages."""
    from osgeo import ogr

    target = folder / f"fixes_{method.number}.gpkg"
    parameters = {"DATABASE": str(database), "IMAGES": [str(images)], "METHOD": method.number, "OUTPUT": str(target)}
    plugin.run_algorithm("localizeimages", parameters)
    source = ogr.Open(str(target))
    return [feature.items() for feature in source.GetLayer(0)]


def localized_alone(python: str, onboard: Path, images: Path, method: str, folder: Path) -> tuple[list, list, object]:
    """Rows, entries of the log, and what the process used, on one core."""
    command = [python, "-m", "core", "localize", str(images), "--database", str(onboard), "--method", method, "--json"]
    one = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}
    with (folder / "alone.jsonl").open("w") as out, (folder / "alone.log").open("w") as log:
        child = subprocess.Popen(
            [*command, "--log-level", "info"],
            cwd=folder,
            stdout=out,
            stderr=log,
            env={**os.environ, **one},
            preexec_fn=lambda: os.sched_setaffinity(0, {min(os.sched_getaffinity(0))}),
        )
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    texts = [(folder / name).read_text(encoding="utf-8").splitlines() for name in ("alone.jsonl", "alone.log")]
    return [json.loads(line) for line in texts[0]], [json.loads(line) for line in texts[1]], usage


def compared(fixes: list[dict], alone: list[dict]) -> str:
    """How far both roads agree."""
    same = sum(a["status"] == b["status"] and a["window"] == b["window"] for a, b in zip(fixes, alone))
    both = [(a, b) for a, b in zip(fixes, alone) if a["x"] is not None and b["x"] is not None]
    apart = np.array([np.hypot(a["x"] - b["x"], a["y"] - b["y"]) for a, b in both] or [np.nan])
    counts = [sum(row["status"] == "fix" for row in rows) for rows in (fixes, alone)]
    return (
        f"{len(fixes)} images, {counts[0]} fixes by the plugin, {counts[1]} without QGIS; same status and window: "
        f"{same}. Positions apart: median {np.median(apart):.4f} m, most {apart.max():.4f} m."
    )


def times(log: list[dict], usage: object) -> str:
    """What the process without QGIS took."""
    seconds = np.array([entry["seconds"] for entry in log if entry["event"] == "image"])
    p50, p95 = np.percentile(seconds[1:] if len(seconds) > 1 else seconds, [50, 95])
    return (
        f"First image {seconds[0]:.2f} s (it builds the index), then p50 {p50:.3f} s, p95 {p95:.3f} s; processor time "
        f"of all {usage.ru_utime + usage.ru_stime:.1f} s, peak memory {usage.ru_maxrss / 1024:.0f} MB."
    )
