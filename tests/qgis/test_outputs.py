"""Outputs are complete or missing, keep other content of their file, and never replace an input."""

from __future__ import annotations

import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from made_inputs import (
    CLASSES_CSV,
    NAMES,
    scattered_objects,
    square,
    write_layer,
    write_older,
    write_raster,
    write_text,
)
from osgeo import gdal, ogr
from qgis.core import QgsProcessingException, QgsProcessingFeedback, QgsVectorLayer

BUILD, DESCRIBE, LOCALIZE = "semref:builddatabase", "semref:describeimage", "semref:localizeimages"
RASTERIZE, CHECK, REPAIR = "semref:rasterizeannotation", "semref:checkannotation", "semref:repairannotation"
COMPARE, DECODE, UPDATE = "semref:comparelabels", "semref:decodecolorlabels", "semref:updatedatabase"
SETTINGS = {"REFERENCE_CLASSES": "1;2;3", "WINDOW_SIZE": 100, "STRIDE": 50, "MINIMUM_AREA": 30}


@pytest.fixture
def given(run_algorithm, tmp_path):
    """Return a folder with one input of each kind."""
    labels = scattered_objects(150, 200, 40, seed=2)
    write_raster(tmp_path / "labels.tif", labels, names=NAMES)
    write_raster(tmp_path / "photo.png", labels[:100, :100], transform=None)
    write_raster(tmp_path / "color.png", np.zeros((3, 20, 20), np.uint8), transform=None)
    write_text(tmp_path / "classes.csv", CLASSES_CSV)
    features = [(square(0, 0, 100), "field", 1), (square(10, 10, 20), "building", 2)]
    write_layer(tmp_path / "annotation.gpkg", features, [("class", "text"), ("zorder", "integer")])
    run_algorithm(BUILD, {"LABELS": str(tmp_path / "labels.tif"), **SETTINGS, "DATABASE": str(tmp_path / "area.gpkg")})
    return tmp_path


def onto_input(folder: Path) -> dict:
    """Return algorithm, parameters, and the file that is an input and an output."""
    labels, area, photo = (str(folder / name) for name in ("labels.tif", "area.gpkg", "photo.png"))
    annotation, classes, color = (str(folder / name) for name in ("annotation.gpkg", "classes.csv", "color.png"))
    of_class = {"INPUT": annotation, "CLASS_FIELD": "class"}
    return {
        "positions onto the database": (LOCALIZE, {"DATABASE": area, "IMAGES": [photo], "OUTPUT": area}, area),
        "a database onto its label map": (BUILD, {"LABELS": labels, **SETTINGS, "DATABASE": labels}, labels),
        "a label map onto its annotation": (RASTERIZE, {**of_class, "PIXEL_SIZE": 1, "OUTPUT": annotation}, annotation),
        "issues onto the annotation": (CHECK, {**of_class, "ISSUES": annotation}, annotation),
        "a repair onto the annotation": (REPAIR, {**of_class, "OUTPUT": annotation}, annotation),
        "a report onto the class table": (
            CHECK,
            {**of_class, "CLASS_TABLE": classes, "ISSUES": str(folder / "i.gpkg"), "REPORT": classes},
            classes,
        ),
        "landmarks onto the database": (
            DESCRIBE,
            {"INPUT": photo, "DATABASE": area, "REFERENCES": area, "VECTOR": str(folder / "v.json")},
            area,
        ),
        "labels onto the color image": (
            DECODE,
            {"INPUT": color, "CLASS_TABLE": classes, "METHOD": 1, "OUTPUT": color},
            color,
        ),
    }


CASES = tuple(onto_input(Path()))


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_an_output_that_is_an_input_is_refused_before_any_work(run_algorithm, given, case):
    algorithm, parameters, path = onto_input(given)[case]
    before = Path(path).read_bytes()
    with pytest.raises(QgsProcessingException, match="the same file"):
        run_algorithm(algorithm, parameters)
    assert Path(path).read_bytes() == before


@pytest.mark.parametrize("spelling", ["link", "hard link", "dots"])
def test_other_spellings_of_an_input_are_seen(run_algorithm, given, spelling):
    area = given / "area.gpkg"
    other = given / "other.gpkg"
    if spelling == "link":
        other.symlink_to(area)
    elif spelling == "hard link":
        os.link(area, other)
    else:
        (given / "sub").mkdir()
        other = given / "sub" / ".." / "area.gpkg"
    before = area.read_bytes()
    parameters = {"DATABASE": str(area), "IMAGES": [str(given / "photo.png")], "OUTPUT": str(other)}
    with pytest.raises(QgsProcessingException, match="the same file"):
        run_algorithm(LOCALIZE, parameters)
    assert area.read_bytes() == before


def test_an_input_that_is_a_layer_of_the_project_is_seen(run_algorithm, given):
    layer = QgsVectorLayer(f"{given / 'annotation.gpkg'}|layername=annotation", "annotation", "ogr")
    assert layer.isValid()
    before = (given / "annotation.gpkg").read_bytes()
    with pytest.raises(QgsProcessingException, match="the same file"):
        run_algorithm(REPAIR, {"INPUT": layer, "CLASS_FIELD": "class", "OUTPUT": str(given / "annotation.gpkg")})
    assert (given / "annotation.gpkg").read_bytes() == before


def test_two_outputs_in_one_file_are_refused(run_algorithm, given):
    both = str(given / "both.gpkg")
    parameters = {
        "DATABASE": str(given / "area.gpkg"),
        "IMAGES": [str(given / "photo.png")],
        "OUTPUT": both,
        "FOOTPRINTS": both,
    }
    with pytest.raises(QgsProcessingException, match="the same file"):
        run_algorithm(LOCALIZE, parameters)
    assert not Path(both).exists()


def test_a_database_may_be_updated_in_place(run_algorithm, given):
    area = str(given / "area.gpkg")
    run_algorithm(UPDATE, {"DATABASE": area, "LABELS": str(given / "labels.tif"), "OUTPUT": area})
    assert ogr.Open(area).GetLayerByName("windows").GetFeatureCount() > 0


def test_other_layers_of_a_geopackage_are_not_lost(run_algorithm, given):
    target = given / "shared.gpkg"
    for name in ("roads", "rivers"):
        options = gdal.VectorTranslateOptions(
            format="GPKG", layerName=name, accessMode="update" if target.exists() else None
        )
        gdal.VectorTranslate(str(target), str(given / "annotation.gpkg"), options=options)
    before = target.read_bytes()
    parameters = {"INPUT": str(given / "annotation.gpkg"), "CLASS_FIELD": "class", "ISSUES": str(target)}
    with pytest.raises(QgsProcessingException, match="holds other layers .*rivers, roads"):
        run_algorithm(CHECK, parameters)
    assert target.read_bytes() == before
    run_algorithm(CHECK, {**parameters, "ISSUES": f"ogr:dbname='{target}' table=\"issues\" (geom)"})
    dataset = ogr.Open(str(target))
    assert {dataset.GetLayer(n).GetName() for n in range(dataset.GetLayerCount())} >= {"roads", "rivers", "issues"}


@pytest.mark.slow
@pytest.mark.parametrize("suffix", ["gpkg", "shp", "geojson", "csv", "fgb"])
def test_layers_of_any_format_are_written_whole(run_algorithm, given, suffix):
    target = given / f"landmarks.{suffix}"
    parameters = {"INPUT": str(given / "photo.png"), "DATABASE": str(given / "area.gpkg"), "REFERENCES": str(target)}
    found = run_algorithm(DESCRIBE, parameters)
    assert found["REFERENCES"].split("|")[0] == str(target)
    assert QgsVectorLayer(str(target), "landmarks", "ogr").featureCount() == found["REFERENCE_COUNT"] > 0
    assert [path for path in given.iterdir() if path.name.startswith(".")] == []


def test_a_run_with_outputs_in_memory_has_nothing_to_move(run_algorithm, given):
    parameters = {"INPUT": str(given / "photo.png"), "DATABASE": str(given / "area.gpkg"), "REFERENCES": "memory:"}
    found = run_algorithm(DESCRIBE, parameters)
    assert found["REFERENCES"].featureCount() == found["REFERENCE_COUNT"] > 0


@pytest.mark.parametrize("suffix", ["gpkg", "shp", "geojson"])
def test_a_written_layer_is_not_kept_open(run_algorithm, given, suffix):
    """QGIS keeps files open for a minute; Windows can't move open files, and disks keep replaced ones."""
    parameters = {"INPUT": str(given / "photo.png"), "DATABASE": str(given / "area.gpkg")}
    for _ in range(2):
        run_algorithm(DESCRIBE, {**parameters, "REFERENCES": str(given / f"landmarks.{suffix}")})
        held = [os.readlink(link) for link in Path("/proc/self/fd").iterdir() if link.is_symlink()]
        assert [path for path in held if path.startswith(str(given)) and "area.gpkg" not in path] == []


@pytest.mark.slow
@pytest.mark.parametrize("kilobytes", [16, 64, 96, 112, 128, 200, 300])
def test_a_full_disk_is_an_error_and_leaves_the_older_file(run_algorithm, given, small_disk, kilobytes):
    disk = small_disk(kilobytes)
    older = disk / "positions.gpkg"
    before = write_older(older)
    images = given / "images"
    images.mkdir()
    for n in range(60):
        shutil.copy(given / "photo.png", images / f"{n}.png")
    parameters = {"DATABASE": str(given / "area.gpkg"), "IMAGES": [str(images)], "METHOD": 1, "OUTPUT": str(older)}
    try:
        run_algorithm(LOCALIZE, parameters)
    except QgsProcessingException as error:
        assert "Traceback" not in str(error)
        assert older.read_bytes() == before
    else:
        assert QgsVectorLayer(str(older), "positions", "ogr").featureCount() == 60
    assert [path.name for path in disk.iterdir()] == ["positions.gpkg"]


def test_a_layer_without_room_for_its_style_is_an_error(run_algorithm, given, monkeypatch):
    """On a full disk QGIS leaves it out without a message."""
    target = given / "issues.gpkg"
    before = write_older(target)
    parameters = {"INPUT": str(given / "annotation.gpkg"), "CLASS_FIELD": "class", "ISSUES": str(target)}
    monkeypatch.setattr(QgsVectorLayer, "saveStyleToDatabase", lambda *_: "")
    with pytest.raises(QgsProcessingException, match="Issues can"):
        run_algorithm(CHECK, parameters)
    assert target.read_bytes() == before


def test_a_layer_without_room_for_its_index_is_an_error(run_algorithm, given, monkeypatch):
    from semref.processing.base import outputs

    target = given / "landmarks.gpkg"
    parameters = {"INPUT": str(given / "photo.png"), "DATABASE": str(given / "area.gpkg"), "REFERENCES": str(target)}
    run_algorithm(DESCRIBE, parameters)
    assert not outputs.lacks_spatial_index(str(target))
    without = write_layer(given / "without.gpkg", [(square(0, 0, 9), "field")], options=["SPATIAL_INDEX=NO"])
    assert outputs.lacks_spatial_index(str(without))
    before = target.read_bytes()
    monkeypatch.setattr(outputs, "lacks_spatial_index", lambda _: True)
    with pytest.raises(QgsProcessingException, match="Landmarks can"):
        run_algorithm(DESCRIBE, parameters)
    assert target.read_bytes() == before


PROGRAM = """
import sys
sys.path.insert(0, {tests!r})
import conftest
from qgis.core import QgsApplication
application = QgsApplication([], False)
application.initQgis()
sys.path.append(QgsApplication.pkgDataPath() + "/python/plugins")
from processing.core.Processing import Processing
import processing
Processing.initialize()
conftest.register_provider()
for n in range(1000):
    print(n, flush=True)
    processing.run("semref:describeimage", {parameters!r})
"""


@pytest.mark.slow
def test_a_kill_while_a_layer_is_written_loses_neither_old_nor_new(run_algorithm, given):
    target = given / "landmarks.gpkg"
    parameters = {"INPUT": str(given / "photo.png"), "DATABASE": str(given / "area.gpkg"), "REFERENCES": str(target)}
    run_algorithm(DESCRIBE, parameters)
    count = QgsVectorLayer(str(target), "landmarks", "ogr").featureCount()
    program = PROGRAM.format(tests=str(Path(__file__).parents[1]), parameters=parameters)
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    rng = np.random.default_rng(1)
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, env=environment, text=True)
    assert child.stdout.readline().strip() == "0"
    for _ in range(3):
        child.stdout.readline()
    time.sleep(float(rng.uniform(0, 0.2)))
    child.send_signal(signal.SIGKILL)
    child.wait()
    assert QgsVectorLayer(str(target), "landmarks", "ogr").featureCount() == count
    with sqlite3.connect(target) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    left = [path for path in given.iterdir() if path.name.endswith(".part")]
    run_algorithm(DESCRIBE, parameters, QgsProcessingFeedback())
    # Files of the killed run are not used.
    assert [path for path in given.iterdir() if path.name.endswith(".part")] == left


def test_a_run_without_files_has_nothing_to_move():
    from semref.storage.atomic_output import Batch

    with Batch() as batch:
        batch.commit()
