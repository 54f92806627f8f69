import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

import pytest
from bad_input import WINDOWS
from made_inputs import square, write_layer, write_older
from osgeo import ogr
from qgis.core import QgsProcessingException, QgsProcessingMultiStepFeedback, QgsVectorLayer
from qgis.PyQt.QtCore import QTimer

from semref.processing.base import outputs
from semref.processing.base.algorithm import Canceled, cancelable

BUILD, DECODE, DESCRIBE = "semref:builddatabase", "semref:decodecolorlabels", "semref:describeimage"
LOCALIZE, UPDATE = "semref:localizeimages", "semref:updatedatabase"
RASTERIZE, CHECK, REPAIR = "semref:rasterizeannotation", "semref:checkannotation", "semref:repairannotation"


@pytest.fixture
def describe(run_algorithm, given):
    asked = {"INPUT": str(given / "photo.png"), "DATABASE": str(given / "area.gpkg")}
    return lambda target: run_algorithm(DESCRIBE, {**asked, "REFERENCES": str(target)})


def onto_input(folder: Path) -> dict:
    """Return algorithm, parameters, the key of the output, and the input that it is."""
    labels, area, photo = (str(folder / name) for name in ("labels.tif", "area.gpkg", "photo.png"))
    annotation, classes, color = (str(folder / name) for name in ("annotation.gpkg", "classes.csv", "color.png"))
    of_class = {"INPUT": annotation, "CLASS_FIELD": "class"}
    with_table = {**of_class, "CLASS_TABLE": classes, "ISSUES": str(folder / "i.gpkg")}
    described = {"INPUT": photo, "DATABASE": area, "VECTOR": str(folder / "v.json")}
    segmented = {"INPUT": color, "MODEL": str(folder / "colors.onnx"), "OUTPUT": str(folder / "o.tif")}
    return {
        "labels onto the photo": ("semref:segmentimage", segmented, "OUTPUT", color),
        "certainty onto the photo": ("semref:segmentimage", segmented, "CONFIDENCE", color),
        "positions onto the database": (LOCALIZE, {"DATABASE": area, "IMAGES": [photo]}, "OUTPUT", area),
        "a database onto its label map": (BUILD, {"LABELS": labels, **WINDOWS}, "DATABASE", labels),
        "a label map onto its annotation": (RASTERIZE, {**of_class, "PIXEL_SIZE": 1}, "OUTPUT", annotation),
        "issues onto the annotation": (CHECK, of_class, "ISSUES", annotation),
        "a repair onto the annotation": (REPAIR, of_class, "OUTPUT", annotation),
        "a report onto the class table": (CHECK, with_table, "REPORT", classes),
        "landmarks onto the database": (DESCRIBE, described, "REFERENCES", area),
        "labels onto the image": (DECODE, {"INPUT": color, "CLASS_TABLE": classes, "METHOD": 1}, "OUTPUT", color),
    }


@pytest.mark.slow
@pytest.mark.parametrize("case", onto_input(Path()))
def test_an_output_that_is_an_input_is_refused_before_any_work(run_algorithm, given, case):
    algorithm, parameters, key, path = onto_input(given)[case]
    before = Path(path).read_bytes()
    with pytest.raises(QgsProcessingException, match="the same file"):
        run_algorithm(algorithm, {**parameters, key: path})
    assert Path(path).read_bytes() == before


@pytest.mark.parametrize("link", [os.symlink, os.link, None])
def test_other_spellings_of_an_input_are_seen(run_algorithm, given, link):
    area, other = given / "area.gpkg", given / ("other.gpkg" if link else f"../{given.name}/area.gpkg")
    if link:
        link(area, other)
    before = area.read_bytes()
    with pytest.raises(QgsProcessingException, match="the same file"):
        run_algorithm(LOCALIZE, {"DATABASE": str(area), "IMAGES": [str(given / "photo.png")], "OUTPUT": str(other)})
    assert area.read_bytes() == before


def test_an_input_that_is_a_layer_of_the_project_is_seen(run_algorithm, given):
    layer = QgsVectorLayer(f"{given / 'annotation.gpkg'}|layername=annotation", "annotation", "ogr")
    before = (given / "annotation.gpkg").read_bytes()
    with pytest.raises(QgsProcessingException, match="the same file"):
        run_algorithm(REPAIR, {"INPUT": layer, "CLASS_FIELD": "class", "OUTPUT": str(given / "annotation.gpkg")})
    assert (given / "annotation.gpkg").read_bytes() == before


def test_two_outputs_in_one_file_are_refused_but_a_database_may_be_updated_in_place(run_algorithm, given, feedback):
    asked = {"DATABASE": str(given / "area.gpkg"), "IMAGES": [str(given / "photo.png")]}
    with pytest.raises(QgsProcessingException, match="the same file"):
        run_algorithm(LOCALIZE, {**asked, **dict.fromkeys(("OUTPUT", "FOOTPRINTS"), str(given / "both.gpkg"))})
    assert not (given / "both.gpkg").exists()
    area = str(given / "area.gpkg")
    rows = type("BatchFeedback", (QgsProcessingMultiStepFeedback,), {})(2, feedback)
    for _ in range(2):
        run_algorithm(UPDATE, {"DATABASE": area, "LABELS": str(given / "labels.tif"), "OUTPUT": area}, rows)
    assert ogr.Open(area).GetLayerByName("windows").GetFeatureCount() > 0
    run_algorithm(LOCALIZE, {**asked, "OUTPUT": str(given / "both.gpkg")}, rows)
    with pytest.raises(QgsProcessingException, match="is also in an earlier row"):
        run_algorithm(LOCALIZE, {**asked, "OUTPUT": str(given / "both.gpkg")}, rows)


def test_a_batch_reacts_to_cancel_during_a_long_step(feedback):
    rows = type("BatchFeedback", (QgsProcessingMultiStepFeedback,), {})(1, feedback)
    QTimer.singleShot(0, feedback.cancel)
    with pytest.raises(Canceled):
        cancelable(time.sleep, 0.3, feedback=rows)


def test_results_name_an_output_that_was_not_selected_because_exported_scripts_read_it(run_algorithm, given):
    asked = {"DATABASE": str(given / "area.gpkg"), "IMAGES": [str(given / "photo.png")], "OUTPUT": "memory:"}
    found = run_algorithm(LOCALIZE, asked)
    assert (found["FOOTPRINTS"], found["LABELS"]) == (None, None)


@pytest.mark.slow
@pytest.mark.parametrize("suffix", ["gpkg", "shp", "geojson", "csv", "fgb"])
def test_layers_of_any_format_are_written_whole(describe, given, suffix):
    target = given / f"landmarks.{suffix}"
    found = describe(target)
    assert found["REFERENCES"].split("|")[0] == str(target)
    assert QgsVectorLayer(str(target), "landmarks", "ogr").featureCount() == found["REFERENCE_COUNT"] > 0
    assert [path for path in given.iterdir() if path.name.startswith(".")] == []


@pytest.mark.parametrize("suffix", ["gpkg", "shp", "geojson"])
def test_a_written_layer_is_not_kept_open(describe, given, suffix):
    """QGIS keeps files open for a minute; Windows can't move open files, and disks keep replaced ones."""
    for _ in range(2):
        describe(given / f"landmarks.{suffix}")
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


def test_a_layer_without_room_for_its_index_is_an_error(describe, given, monkeypatch):
    target = given / "landmarks.gpkg"
    describe(target)
    assert not outputs.lacks_spatial_index(str(target))
    without = write_layer(given / "without.gpkg", [(square(0, 0, 9), "field")], options=["SPATIAL_INDEX=NO"])
    assert outputs.lacks_spatial_index(str(without))
    before = target.read_bytes()
    monkeypatch.setattr(outputs, "lacks_spatial_index", lambda _: True)
    with pytest.raises(QgsProcessingException, match="Landmarks can"):
        describe(target)
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
def test_a_kill_while_a_layer_is_written_loses_neither_old_nor_new(describe, given):
    target = given / "landmarks.gpkg"
    count = describe(target)["REFERENCE_COUNT"]
    parameters = {"INPUT": str(given / "photo.png"), "DATABASE": str(given / "area.gpkg"), "REFERENCES": str(target)}
    program = PROGRAM.format(tests=str(Path(__file__).parents[1]), parameters=parameters)
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, env=environment, text=True)
    assert child.stdout.readline().strip() == "0"
    for _ in range(3):
        child.stdout.readline()
    time.sleep(0.1)
    child.send_signal(signal.SIGKILL)
    child.wait()
    assert QgsVectorLayer(str(target), "landmarks", "ogr").featureCount() == count
    with sqlite3.connect(target) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    left = [path for path in given.iterdir() if path.name.endswith(".part")]
    describe(target)
    # Files of the killed run are not used.
    assert [path for path in given.iterdir() if path.name.endswith(".part")] == left
