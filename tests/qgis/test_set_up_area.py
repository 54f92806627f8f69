import csv
import errno
import gc
import os
import re
import shutil
from datetime import datetime
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from made_inputs import NORTH, WEST, square, write_layer, write_photo, write_raster, write_text
from made_models import write_model
from osgeo import gdal
from qgis.core import QgsProcessingException, QgsProcessingFeedback, QgsProcessingUtils, QgsRasterLayer, QgsVectorLayer
from tile_server import tile_server

from semref.core.errors import ParameterError
from semref.core.flight.cameras import read_cameras
from semref.processing.algorithms import set_up_area
from semref.processing.algorithms.build_database import BuildDatabase
from semref.processing.algorithms.train_model import TrainModel
from semref.processing.jobs import training_process
from semref.processing.jobs.area_setup import camera_table, read_photos
from semref.processing.jobs.chain import Record
from semref.processing.packages import training_environment
from semref.processing.reports.setup_report import expectation_of

SETUP = "semref:setuparea"

FAR_PLACE = {"GPSLongitude": "(9) (0) (0)", "GPSLongitudeRef": "E", "GPSLatitude": "(9) (0) (0)", "GPSLatitudeRef": "N"}


@pytest.fixture
def given(sample, repository, tmp_path):
    photos = [str(sample / "photos" / f"photo_{n:02d}.jpg") for n in (1, 2, 3)]
    return {
        "ANNOTATION": str(sample / "landcover.shp"),
        "PHOTOS": photos,
        "PHOTO_WIDTH": 640,
        "MODEL": str(repository / "models" / "sample_area.onnx"),
        "FOLDER": str(tmp_path / "results"),
    }


def true_places(sample: Path) -> dict[str, np.ndarray]:
    with (sample / "photos.csv").open(newline="", encoding="utf-8") as file:
        return {row["image"]: np.array([float(row["x"]), float(row["y"])]) for row in csv.DictReader(file)}


def test_photos_of_one_name_in_two_formats_and_folders_have_the_stated_ground_width(qgis_app, tmp_path):
    (tmp_path / "day 2").mkdir()
    shapes = {"one.jpg": (32, 24), "day 2/one.jpg": (64, 48), 'a "b" 10.20.jpg': (40, 30)}
    photos = [write_photo(tmp_path / name, size_wh) for name, size_wh in shapes.items()]
    photos.append(str(write_raster(tmp_path / "one.tif", np.zeros((20, 80), np.uint8), transform=None)))
    read = read_photos(photos, 160.0, None, QgsVectorLayer().extent(), QgsProcessingFeedback())
    table = write_text(tmp_path / "cameras.csv", camera_table(read))
    sizes = zip(read_cameras(photos, str(table)), [(24, 32), (48, 64), (30, 40), (20, 80)])
    assert [camera.pixel_size(shape) for camera, shape in sizes] == pytest.approx([5, 2.5, 4, 2])


@pytest.mark.parametrize(
    ("seconds", "is_flight"),
    [((20, 0, 39), True), ((0, 10, 20, 900), True), ((0, 21, 42), False), ((0, 10), False), ((0, 10, None), False)],
)
def test_photos_are_one_flight_if_all_have_times_and_most_gaps_are_short(qgis_app, tmp_path, seconds, is_flight):
    times = [None if one is None else f"2026:05:01 10:{one // 60:02}:{one % 60:02}" for one in seconds]
    tags = [{} if time is None else {"DateTimeOriginal": time} for time in times]
    photos = [write_photo(tmp_path / f"{number}.jpg", **one) for number, one in enumerate(tags)]
    read = read_photos(photos, 160.0, None, QgsVectorLayer().extent(), QgsProcessingFeedback())
    assert read.is_flight is is_flight


@pytest.mark.slow
def test_one_run_places_photos_and_a_second_one_computes_nothing_again(run_algorithm, given, sample, feedback):
    results = run_algorithm(SETUP, given, feedback)
    truth = true_places(sample)
    rows = list(QgsVectorLayer(results["POSITIONS"], "", "ogr").getFeatures())
    assert [row["status"] for row in rows] == ["fix"] * 3
    for row in rows:
        assert np.hypot(*(truth[Path(row["image"]).name] - (row["x"], row["y"]))) < 3
    log = feedback.textLog()
    assert "3 photos. Window 640 m" in log and "No training" in log
    report = Path(results["REPORT"]).read_text(encoding="utf-8")
    assert "Photos with a position" in report and "photo_03.jpg" in report
    assert "of 10 photos that are centered on a landmark" in report
    assert results["TRAINED_MODEL"] == given["MODEL"]
    folder = Path(given["FOLDER"])
    before = {path.name: path.stat().st_mtime_ns for path in folder.iterdir() if path.suffix == ".gpkg"}
    again = QgsProcessingFeedback(False)
    assert run_algorithm(SETUP, given, again) == results
    assert again.textLog().count("is used again") == 4
    assert before == {path.name: path.stat().st_mtime_ns for path in folder.iterdir() if path.suffix == ".gpkg"}


@pytest.fixture
def small(tmp_path):
    """Return the parameters of a run on 100 buildings, with a model of three classes, without photos."""
    features = [(square(20 * column, 20 * row, 12), "building") for column in range(10) for row in range(10)]
    return {
        "ANNOTATION": str(write_layer(tmp_path / "map.gpkg", features)),
        "PHOTO_WIDTH": 80,
        "MODEL": str(write_model(tmp_path / "colors.onnx")),
        "FOLDER": str(tmp_path / "results"),
    }


def files_in(folder: str) -> set[str]:
    return {path.name for path in Path(folder).iterdir()} if Path(folder).exists() else set()


@pytest.mark.parametrize("more", [{"FOLDER": "TEMPORARY_OUTPUT"}, {"PHOTO_WIDTH": 30}])
def test_without_photos_it_makes_the_database_and_states_what_to_expect(run_algorithm, small, feedback, more):
    results = run_algorithm(SETUP, {**small, **more}, feedback)
    assert "POSITIONS" not in results and Path(results["DATABASE"]).is_file()
    if "FOLDER" in more:
        assert results["DATABASE"].startswith(QgsProcessingUtils.tempFolder())
        assert "about 9 in a typical photo" in feedback.textLog()
        return
    assert "about 0 of 10 photos that are centered on a landmark" in feedback.textLog()
    assert "Too few landmarks: 1 in view on average." in Path(results["REPORT"]).read_text(encoding="utf-8")
    assert {"expected_success.gpkg", "assessment.html"} <= files_in(small["FOLDER"])


def test_empty_ground_does_not_count_and_reasons_of_one_kind_are_one():
    squares = [(0.0, 0.0, "No."), (0.9, 30.0, ""), (0.3, 6.0, "Few: 6."), (0.3, 4.0, "Few: 4."), (0.0, 0.0, "No.")]
    found = expectation_of(squares)
    assert found.success == pytest.approx(0.75, abs=1e-3)
    assert found.reasons[0] == ("Few: 6.", pytest.approx(0.25, abs=1e-3))
    assert expectation_of([(0.0, 0.0, "No.")] * 2).reasons == [("No.", pytest.approx(1.0))]


def test_osm_tags_are_limited_to_the_classes_of_the_model(run_algorithm, small, tmp_path, feedback):
    features = [(square(20 * n, 0, 12), "yes", None) for n in range(9)] + [(square(0, 40, 60), None, "wood")]
    fields = [("building", "text"), ("natural", "text")]
    small["ANNOTATION"] = str(write_layer(tmp_path / "osm.gpkg", features, fields))
    run_algorithm(SETUP, small, feedback)
    assert "building: 9 polygons" in feedback.textLog() and "forest" not in feedback.textLog()
    assert "Landmarks in a typical photo: about 3" in feedback.textLog()


@pytest.fixture
def tagged(small, tmp_path):
    """Return the parameters of a run on 18 buildings and lines with tags."""
    buildings = [(square(20 * column, 20 * row, 12), "yes", None) for column in range(9) for row in range(2)]
    tags = [("building", "text"), ("natural", "text")]
    small["ANNOTATION"] = str(write_layer(tmp_path / "osm.gpkg", buildings, tags))
    way = f"LINESTRING ({WEST} {NORTH - 16}, {WEST + 180} {NORTH - 16})"
    kinds = [(way, None, "stream", None), (way, "primary", None, None), (way, None, "river", '"tunnel"=>"culvert"')]
    keys = [(name, "text") for name in ("highway", "waterway", "other_tags")]
    return {**small, "LINES": str(write_layer(tmp_path / "lines.gpkg", kinds, keys))}


def test_lines_of_the_model_s_classes_are_on_the_map(run_algorithm, tagged, feedback):
    results = run_algorithm(SETUP, tagged, feedback)
    assert "water: 1 polygons" in feedback.textLog() and "road" not in feedback.textLog()
    assert Path(results["DATABASE"]).is_file()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"MODEL": "models/buildings.onnx"}, "has none of the classes of lines, road, water"),
        ({"ANNOTATION": "map.gpkg"}, "“map” has no tags"),
        ({"LINES": "osm.gpkg"}, "The lines can't be read"),
    ],
)
def test_lines_that_cannot_be_used_are_refused(run_algorithm, tagged, repository, tmp_path, change, message):
    key, name = next(iter(change.items()))
    with pytest.raises(QgsProcessingException, match=message):
        run_algorithm(SETUP, {**tagged, key: str((repository if key == "MODEL" else tmp_path) / name)})
    assert files_in(tagged["FOLDER"]) == set()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"PHOTO_WIDTH": None}, "enter the ground width of a typical photo"),
        ({"PHOTO_WIDTH": None, "PHOTOS": "photo"}, "do not state the height of the camera"),
        ({"PHOTOS": "damaged"}, "bad.onnx is not an image that QGIS can read"),
        ({"FOLDER": "a:b"}, "“Expected success” is"),
        ({"PHOTOS": "photo"}, "All photos with a GPS position were taken outside “map”"),
        ({"EXTENT": "0,100,0,100 [EPSG:32632]"}, "the extent do not overlap"),
        ({"EXTENT": "550012.5,550019,5219990,5219999 [EPSG:32632]"}, "has no polygon with a class in the extent"),
        ({"IMAGERY": "far"}, "don't overlap"),
        ({"MINUTES": 5}, "Training needs imagery or photos"),
        ({"MINUTES": 5, "IMAGERY": "decimals"}, "decimals.tif has Float32 values"),
        ({"MODEL": ""}, "SemRef has no model for this"),
        ({"MODEL": "damaged"}, "is not an ONNX model"),
        ({"CLASS_FIELD": "kind"}, "has no field “kind”"),
    ],
)
def test_bad_input_is_one_sentence_and_leaves_nothing(run_algorithm, small, tmp_path, monkeypatch, change, message):
    monkeypatch.setattr(set_up_area, "PHOTO_MODEL", tmp_path / "missing.onnx")
    monkeypatch.setattr(training_environment, "training_python", lambda *_: "python")
    far = (600000.0, 1.0, 0.0, 5000000.0, 0.0, -1.0)
    made = {
        "photo": lambda: [write_photo(tmp_path / "photo.jpg", **FAR_PLACE)],
        "far": lambda: str(write_raster(tmp_path / "far.tif", np.zeros((3, 50, 50), np.uint8), transform=far)),
        "decimals": lambda: str(write_raster(tmp_path / "decimals.tif", np.ones((3, 9, 9)), kind=gdal.GDT_Float32)),
        "damaged": lambda: str(write_text(tmp_path / "bad.onnx", "no model")),
        "a:b": lambda: str(tmp_path / "a:b"),
    }
    given = {**small, **{key: made.get(value, lambda value=value: value)() for key, value in change.items()}}
    with pytest.raises(QgsProcessingException, match=re.escape(message)):
        run_algorithm(SETUP, given)
    assert files_in(given["FOLDER"]) == set()
    gc.collect()
    assert not any(isinstance(one, QgsVectorLayer) and one.name() == "map" for one in gc.get_objects())


def test_a_photo_of_another_place_does_not_stop_photos_without_gps(run_algorithm, small, tmp_path, feedback):
    photos = [write_photo(tmp_path / "far.jpg", **FAR_PLACE), write_photo(tmp_path / "unknown.jpg")]
    assert Path(run_algorithm(SETUP, {**small, "PHOTOS": photos}, feedback)["POSITIONS"].partition("|")[0]).is_file()
    assert "Photos with a GPS position outside the map: 1 of 1." in feedback.textLog()
    # Its ground width is known, but does not count.
    write_text(tmp_path / "far.jgw", "50\n0\n0\n-50\n0\n0\n")
    write_text(tmp_path / "far.jpg.aux.xml", "<PAMDataset><SRS>EPSG:32632</SRS></PAMDataset>")
    with pytest.raises(QgsProcessingException, match="Enter the ground width"):
        run_algorithm(SETUP, {**small, "PHOTOS": photos, "PHOTO_WIDTH": None})


def test_files_of_others_and_of_other_values_are_not_replaced(run_algorithm, small):
    folder = Path(small["FOLDER"])
    folder.mkdir()
    foreign = write_text(folder / "label_map.tif", "mine")
    with pytest.raises(QgsProcessingException, match="label_map.tif exists and was not made by a run with the same"):
        run_algorithm(SETUP, small)
    assert foreign.read_text(encoding="utf-8") == "mine" and files_in(folder) == {"label_map.tif"}
    foreign.unlink()
    with Record(folder, []), pytest.raises(QgsProcessingException, match="Another run of “Set up an area” is using"):
        run_algorithm(SETUP, small)
    run_algorithm(SETUP, small)
    with pytest.raises(QgsProcessingException, match="was not made by a run with the same values"):
        run_algorithm(SETUP, {**small, "PHOTO_WIDTH": 120})


def test_a_full_disk_is_one_sentence_and_the_run_goes_on(run_algorithm, small, feedback, monkeypatch):
    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device", "reference_database.gpkg")

    with monkeypatch.context() as disk:
        disk.setattr(BuildDatabase, "work", full)
        with pytest.raises(QgsProcessingException, match="The disk is full: reference_database.gpkg cannot be written"):
            run_algorithm(SETUP, small)
    assert not files_in(small["FOLDER"]) & {"reference_database.gpkg", "report.html"}
    run_algorithm(SETUP, small, feedback)
    assert {"reference_database.gpkg", "report.html"} <= files_in(small["FOLDER"])


def test_map_tiles_are_drawn_on_the_ground_of_the_database(run_algorithm, small, feedback, monkeypatch):
    drawn = []

    def train(algorithm, values, *_):
        drawn.append(values.raster("IMAGE"))
        drawn[0] = (drawn[0].extent(), drawn[0].crs().isValid())
        raise ParameterError("Trained enough.")

    monkeypatch.setattr(training_environment, "training_python", lambda *_: "python")
    monkeypatch.setattr(TrainModel, "read_layers", lambda *_: None)
    monkeypatch.setattr(TrainModel, "work", train)
    with tile_server() as source:
        tiles = QgsRasterLayer(source, "tiles", "wms")
        with pytest.raises(QgsProcessingException, match="Trained enough"):
            run_algorithm(SETUP, {**small, "MODEL": "", "IMAGERY": tiles, "MINUTES": 5}, feedback)
    assert "Check that its provider permits this use." in feedback.textLog()
    (extent, has_crs), ground = drawn[0], QgsVectorLayer(small["ANNOTATION"], "", "ogr").extent()
    assert has_crs and abs(extent.width() - ground.width()) < 20 and abs(extent.height() - ground.height()) < 20


@pytest.mark.slow
def test_a_training_without_imagery_uses_the_photos_with_a_position(
    run_algorithm, given, sample, monkeypatch, feedback
):
    trained_on = []

    def train(algorithm, values, python, target, *_):
        base = os.path.basename(values.file("BASE_MODEL"))
        trained_on.append((values.raster("IMAGE").source(), values.number("MINUTES"), base))
        shutil.copyfile(given["MODEL"], target)
        return SimpleNamespace(html=lambda: "", mean_iou=None)

    monkeypatch.setattr(training_environment, "training_python", lambda *_: "python")
    monkeypatch.setattr(training_process, "require_training", lambda *_: {"torch": "", "device": ""})
    monkeypatch.setattr(TrainModel, "_train", train)
    with pytest.raises(QgsProcessingException, match="1 of 1 photos have a position, too few"):
        run_algorithm(SETUP, {**given, "MINUTES": 5, "PHOTOS": given["PHOTOS"][:1]})
    # As the message says, it continues in the same folder.
    run_algorithm(SETUP, {**given, "PHOTOS": given["PHOTOS"][:1]}, feedback)
    assert feedback.textLog().count("is used again") == 2
    results = run_algorithm(SETUP, {**given, "MINUTES": 5, "FOLDER": given["FOLDER"] + " 2"}, feedback)
    assert results["TRAINED_MODEL"].endswith("model.onnx")
    (_, minutes, _), (path, more_minutes, base) = trained_on
    assert (minutes, more_minutes, base) == (2.5, 2.5, "first_model.onnx")
    mosaic = gdal.Open(path)
    x, pixel, _, y, *_ = mosaic.GetGeoTransform()
    bounds = (x, y - pixel * mosaic.RasterYSize, x + pixel * mosaic.RasterXSize, y)
    truth = gdal.Warp("", str(sample / "orthophoto.tif"), format="MEM", xRes=pixel, yRes=pixel, outputBounds=bounds)
    seen, true = mosaic.ReadAsArray(), truth.ReadAsArray()
    shown = seen[3] == 255
    assert shown.any() and np.corrcoef(seen[1][shown], true[1][shown])[0, 1] > 0.75


class CancelAt(QgsProcessingFeedback):
    """Feedback that cancels when a step begins."""

    def __init__(self, step):
        super().__init__(False)
        self.step = step

    def setProgressText(self, text):
        if text.startswith(self.step):
            self.cancel()


@pytest.mark.parametrize(
    ("step", "complete"),
    [
        ("Building the reference database", ["label_map.tif"]),
        ("Localizing simulated images", ["label_map.tif", "reference_database.gpkg"]),
    ],
)
def test_a_canceled_run_goes_on(run_algorithm, small, feedback, step, complete):
    with pytest.raises(QgsProcessingException, match="Canceled. Complete files remain"):
        run_algorithm(SETUP, small, CancelAt(step))
    files = {name for name in files_in(small["FOLDER"]) if name.endswith((".tif", ".gpkg", ".html"))}
    assert files == set(complete)
    run_algorithm(SETUP, small, feedback)
    assert feedback.textLog().count("is used again") == len(complete)
    assert "report.html" in files_in(small["FOLDER"])


def test_it_has_annotation_class_table_orthophoto_and_photos(sample):
    layer = QgsVectorLayer(str(sample / "landcover.shp"), "annotation", "ogr")
    orthophoto = gdal.Open(str(sample / "orthophoto.tif"))
    photos = [gdal.Open(str(path)) for path in sorted((sample / "photos").iterdir())]
    assert layer.featureCount() > 500 and len(photos) == 12 and {"building", "water"} < layer.uniqueValues(0)
    assert layer.crs().authid() == "EPSG:25832" and layer.fields().names() == ["class", "class_id", "zorder"]
    assert (orthophoto.RasterXSize, orthophoto.RasterYSize, orthophoto.RasterCount) == (4000, 3000, 3)
    assert {(photo.RasterXSize, photo.RasterYSize, photo.RasterCount) for photo in photos} == {(640, 640, 3)}
    assert sorted(true_places(sample)) == sorted(path.name for path in (sample / "photos").iterdir())


def test_it_has_a_flight_with_the_times_of_its_photos(sample):
    with (sample / "flight.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["image"] for row in rows] == sorted(path.name for path in (sample / "flight").iterdir())
    times = [datetime.fromisoformat(row["time"]) for row in rows]
    assert len(rows) == 16 and {(b - a).total_seconds() for a, b in zip(times, times[1:])} == {12}
