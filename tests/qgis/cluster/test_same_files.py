"""SCHEDULER gives the files of a run in QGIS, even if a worker is killed or runs elsewhere."""

import json
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from built_database import BUILD, content
from made_inputs import NAMES, NORTH, WEST, read_pixels, scattered_objects, write_layer, write_raster, write_text
from made_models import painted, write_model
from osgeo import gdal, ogr
from qgis.core import QgsVectorLayer

pytestmark = pytest.mark.slow

pytest.importorskip("distributed", reason="Dask is not here (tools/requirements-dev.txt)")
psutil = pytest.importorskip("psutil")

RASTERIZE, SEGMENT = "semref:rasterizeannotation", "semref:segmentimage"
CLASSES = "value,name,color,role,draw_order\n" + "".join(
    f"{n},{name},#{n:02x}40{255 - 9 * n:02x},reference,{n}\n"
    for n, name in enumerate(("building", "water", "bare_land", "field"), start=1)
)


@pytest.fixture
def losing(feedback):
    """Return a feedback that kills a worker when the work has begun, and a list of killed workers."""
    killed = []

    def kill(share):
        if share > 0 and not killed:
            found = [one for one in psutil.Process().children(recursive=True) if "spawn_main" in str(one.cmdline())]
            if len(found) >= 2:
                found[0].send_signal(signal.SIGKILL)
                killed.append(found[0])

    feedback.progressChanged.connect(kill)
    return feedback, killed


@pytest.fixture(scope="module")
def label_map(tmp_path_factory):
    """Return a map of some tiles, with landmarks on every seam."""
    labels = scattered_objects(1700, 1500, 2500, seed=8)
    labels[500:540, 100:1400] = 2
    labels[200:1600, 1010:1040] = 1
    return write_raster(tmp_path_factory.mktemp("map") / "labels.tif", labels, names=NAMES)


@pytest.fixture(scope="module")
def asked(label_map):
    asked = {"LABELS": str(label_map), "REFERENCE_CLASSES": "building;water", "WINDOW_SIZE": 320, "STRIDE": 140}
    return {**asked, "MINIMUM_AREA": 40}


@pytest.fixture(scope="module")
def built(run_algorithm, asked, tmp_path_factory):
    return run_algorithm(BUILD, {**asked, "DATABASE": str(tmp_path_factory.mktemp("built") / "area.gpkg")})["DATABASE"]


def require_same_database(found, wanted):
    assert content(found) == content(wanted) and len(content(found)["windows"]) > 50
    overviews = [gdal.Open(f"GPKG:{path}:overview").ReadAsArray() for path in (found, wanted)]
    np.testing.assert_array_equal(*overviews)


def test_two_workers_of_which_one_is_killed_build_the_same_database(run_algorithm, asked, built, tmp_path, losing):
    feedback, killed = losing
    target = str(tmp_path / "two.gpkg")
    run_algorithm(BUILD, {**asked, "SCHEDULER": "local:2", "DATABASE": target}, feedback)
    assert killed
    require_same_database(target, built)
    (line,) = QgsVectorLayer(f"{target}|layername=windows", "windows", "ogr").metadata().history()
    assert "processing.run" in line and feedback.progress() == 100


def test_a_scheduler_and_workers_that_have_nothing_of_semref_build_it_too(run_algorithm, asked, built, tmp_path):
    """Both run in a folder without our code."""
    note = tmp_path / "scheduler.json"
    programs = {"scheduler": ["--port", "0", "--no-dashboard"], "worker": ["--nthreads", "1"]}
    running = []
    try:
        for name, options in programs.items():
            order = [sys.executable, "-m", f"distributed.cli.dask_{name}", "--scheduler-file", str(note), *options]
            running.append(subprocess.Popen(order, cwd=tmp_path, stderr=subprocess.DEVNULL))
            for _ in range(600):
                if note.exists() and note.read_text().strip().endswith("}"):
                    break
                time.sleep(0.1)
        address, target = json.loads(note.read_text())["address"], str(tmp_path / "elsewhere.gpkg")
        run_algorithm(BUILD, {**asked, "SCHEDULER": address, "DATABASE": target})
    finally:
        for process in running[::-1]:
            process.terminate()
            process.wait(timeout=60)
    require_same_database(target, built)


@pytest.fixture(scope="module")
def annotation(tmp_path_factory):
    """Return overlapping polygons on several strips: with priorities, of several parts or without a part."""
    rng, features = np.random.default_rng(5), []
    for n in range(700):
        x, y = WEST + rng.uniform(0, 4700), NORTH - rng.uniform(0, 8200)
        width, height = rng.uniform(5, 260, 2)
        corners = [(x, y), (x + width, y + 3), (x + width - 2, y + height), (x - 1, y + height)]
        ring = ", ".join(f"{float(a)!r} {float(b)!r}" for a, b in [*corners, corners[0]])
        far = f", (({x + 900} {y}, {x + 950.5} {y}, {x + 950.5} {y + 33}, {x + 900} {y}))" if n % 9 == 0 else ""
        level = None if n % 11 == 0 else float(rng.integers(0, 4))
        name = ("building", "water", "bare_land", "field")[rng.integers(0, 4)]
        features.append((f"MULTIPOLYGON ((({ring})){far})", name, level))
    features += [(None, "water", 1.0), (features[3][0], None, 1.0), (features[4][0], "", 9.0)]
    path = tmp_path_factory.mktemp("annotation") / "annotation.gpkg"
    fields = [("class", "text"), ("level", "real")]
    table = write_text(path.with_name("classes.csv"), CLASSES)
    asked = {"INPUT": str(write_layer(path, features, fields, geometry=ogr.wkbUnknown)), "CLASS_FIELD": "class"}
    return {**asked, "PRIORITY_FIELD": "level", "CLASS_TABLE": str(table)}


def test_two_workers_of_which_one_is_killed_burn_the_same_label_map(run_algorithm, annotation, tmp_path, losing):
    feedback, killed = losing
    found, wanted = tmp_path / "found.tif", tmp_path / "wanted.tif"
    expected = run_algorithm(RASTERIZE, {**annotation, "OUTPUT": str(wanted)})
    results = run_algorithm(RASTERIZE, {**annotation, "SCHEDULER": "local:2", "OUTPUT": str(found)}, feedback)
    assert read_pixels(wanted).size > 2 * 16_000_000 and expected["CLASS_COUNT"] == results["CLASS_COUNT"] == 4
    assert found.read_bytes() == wanted.read_bytes()


def test_two_workers_of_which_one_is_killed_segment_the_same(run_algorithm, tmp_path, losing):
    """The image has some blocks of tiles, partly without data."""
    feedback, killed = losing
    pixels = np.moveaxis(painted(scattered_objects(1150, 930, 900, seed=3, background=0)), 2, 0).copy()
    noise = np.random.default_rng(1).integers(0, 60, pixels.shape).astype(np.uint8)
    pixels = np.where(pixels > 128, pixels - noise, pixels + noise)
    pixels[:, 300:520, 100:460] = 0
    place = {"transform": (WEST, 0.5, 0, NORTH, 0, -0.5), "crs": 25832, "nodata": 0}
    photo, model = write_raster(tmp_path / "photo.tif", pixels, **place), write_model(tmp_path / "colors.onnx")
    asked = {"INPUT": str(photo), "MODEL": str(model), "OVERLAP": 30}
    found, wanted = tmp_path / "found.tif", tmp_path / "wanted.tif"
    expected = run_algorithm(SEGMENT, {**asked, "OUTPUT": str(wanted)})
    results = run_algorithm(SEGMENT, {**asked, "SCHEDULER": "local:2", "OUTPUT": str(found)}, feedback)
    assert found.read_bytes() == wanted.read_bytes() and killed
    assert results["CERTAINTY"] == pytest.approx(expected["CERTAINTY"])
