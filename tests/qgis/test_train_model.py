"""semref:trainmodel: its tiles, its job for the training environment, its messages and its files.

A small program replaces the training, which needs torch; tests/training has the real one.
"""

import errno
import json
import os
import time
from pathlib import Path

import numpy as np
import pytest
from made_inputs import NAMES, NORTH, WEST, polygon, read_pixels, scattered_objects, square, write_layer, write_raster
from made_models import write_model
from made_trainer import EPOCH, READY, write_trainer
from osgeo import gdal
from qgis.core import QgsProcessingException, QgsProcessingFeedback, QgsRasterLayer, QgsSettings
from tile_server import tile_server

from semref.processing.base.outputs import Outputs

TRAIN = "semref:trainmodel"
LABELS = scattered_objects(640, 768, 300, seed=5)
PHOTO = np.stack([LABELS * 20 + band for band in range(3)]).astype(np.uint8)


class Said(QgsProcessingFeedback):
    """Feedback that records messages and cancels at a given progress."""

    def __init__(self, cancel_at: float = 1000):
        super().__init__(False)
        self.lines, self._cancel_at, self.canceled_at = [], cancel_at, None
        self.progressChanged.connect(self._look)

    def _look(self, progress):
        if progress >= self._cancel_at and self.canceled_at is None:
            self.canceled_at = time.monotonic()
            self.cancel()

    def pushInfo(self, text):
        self.lines.append(text)


@pytest.fixture
def trainer(tmp_path):
    """`trainer(training, ready)`: path of a program that answers like the training."""

    def make(training=EPOCH, ready=READY):
        return str(write_trainer(tmp_path / "python_that_trains", write_model(tmp_path / "made.onnx"), training, ready))

    return make


@pytest.fixture
def train(run_algorithm, trainer, tmp_path):
    """`train(**parameters)` runs it on an image of 640 × 768 m and its label map."""
    image = write_raster(tmp_path / "image.tif", PHOTO)
    labels = write_raster(tmp_path / "labels.tif", LABELS, names=NAMES)

    def run(feedback=None, training=EPOCH, ready=READY, **parameters):
        given = {"IMAGE": str(image), "LABELS": str(labels), "PYTHON": trainer(training, ready)}
        given |= {"OUTPUT": str(tmp_path / "model.onnx"), "REPORT": str(tmp_path / "report.html")}
        given = {key: value for key, value in {**given, **parameters}.items() if value is not None}
        return run_algorithm(TRAIN, given, feedback or Said())

    return run


@pytest.fixture
def kept(tmp_path):
    return tmp_path / "kept"


KEEP = f"shutil.copytree(folder, os.path.join(os.path.dirname(job['output']), 'kept')); {EPOCH}"
"""Training that keeps a copy of its files."""
WAIT = f"{EPOCH}; time.sleep(60)"


def interrupt(train, **parameters) -> None:
    with pytest.raises(QgsProcessingException, match="is saved"):
        train(Said(cancel_at=50), training=WAIT, **parameters)


def tiles_in(kept):
    """Return the manifest of the tiles, and the labels and the pixels of each."""
    manifest = json.loads((kept / "tiles" / "manifest.json").read_text())
    size, found = manifest["tile_size"], []
    for tile in manifest["tiles"]:
        path = kept / "tiles" / tile["subset"] / "labels" / f"{tile['name']}.png"
        found.append((read_pixels(path), tile["row"], tile["column"]))
    return size, found


def job_in(kept):
    return json.loads((kept / "job.json").read_text())


def folders(place):
    return sorted(place.glob("model.training*"))


def test_the_model_and_its_report_are_what_the_training_made(train, tmp_path):
    said = Said()
    result = train(said)
    assert result["MEAN_IOU"] == 0.4
    assert Path(result["OUTPUT"]).read_bytes() == (tmp_path / "made.onnx").read_bytes()
    report = Path(result["REPORT"]).read_text(encoding="utf-8")
    assert "75.0" in report and "66.7" not in report and "building" in report
    assert all(any(text in line for line in said.lines) for text in ("torch 2.0", "building 50 %"))
    assert folders(tmp_path) == []
    untested = train(said, training=f"row = {{k: v for k, v in row.items() if k[:4] != 'iou_'}}; {EPOCH}; tested = 0")
    assert "Epoch 1, loss 1.500" in said.lines
    assert "MEAN_IOU" not in untested and "40.0" not in Path(untested["REPORT"]).read_text(encoding="utf-8")


def test_the_training_gets_tiles_of_image_and_labels(train, kept):
    train(training=KEEP, MINUTES=7, EPOCHS=9, UNLABELED=1)
    job, (size, tiles) = job_in(kept), tiles_in(kept)
    # Reading and cutting have taken some of the time.
    assert (job["epochs"], job["learn_unlabeled"], size) == (9, True, 128) and 5 < job["minutes"] < 7
    assert job["ground"]["image"] == "image.tif" and job["ground"]["pixel_size"] == 1.0
    assert job["ground"]["extent"] == [WEST, NORTH - 640, WEST + 768, NORTH]
    for labels, row, column in tiles[:5]:
        np.testing.assert_array_equal(labels, LABELS[row : row + size, column : column + size])


@pytest.mark.parametrize("something_else", [0, 1])
def test_ground_outside_the_mask_is_not_learned_from(train, kept, tmp_path, something_else):
    mask = write_layer(tmp_path / "mask.gpkg", [(square(100, 50, 400), "x"), (square(500, 450, 100), "x")])
    train(training=KEEP, MASK=str(mask), UNLABELED=something_else)
    wanted = np.zeros(LABELS.shape, bool)
    wanted[50:450, 100:500] = wanted[450:550, 500:600] = True
    # Excluded pixels have a value without a class, because 0 becomes a class if unlabeled ground is learned.
    expected = np.where(wanted, LABELS, 255 if something_else else 0)[50:, 100:]
    size, tiles = tiles_in(kept)
    for labels, row, column in tiles:
        np.testing.assert_array_equal(labels, expected[row : row + size, column : column + size])
    assert job_in(kept)["ground"]["extent"] == [WEST + 100, NORTH - 550, WEST + 600, NORTH - 50]


@pytest.mark.slow
def test_map_tiles_are_drawn_in_the_extent_before_they_are_learned_from(train, kept, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(square(100, 300, 200), "building"), (square(400, 300, 200), "water")])
    annotation = {"LABELS": None, "INPUT": str(layer), "CLASS_FIELD": "class"}
    with tile_server() as source:
        tiles = QgsRasterLayer(source, "tiles", "wms")
        given = {"IMAGE": tiles, "EXTENT": f"{WEST},{WEST + 700},{NORTH - 600},{NORTH} [EPSG:32632]", **annotation}
        with pytest.raises(QgsProcessingException, match="no resolution of its own"):
            train(**given)
        train(training=KEEP, RESOLUTION=100, **given)
    job = job_in(kept)
    assert job["ground"]["image"] == "tiles" and job["ground"]["crs"] == "EPSG:32632"
    np.testing.assert_allclose(job["ground"]["extent"], [WEST, NORTH - 600, WEST + 700, NORTH], atol=1)
    assert np.bincount(read_pixels(kept / "labels.tif").ravel())[1:].tolist() == [40_000, 40_000]


def test_a_cancel_ends_the_process_at_once_and_keeps_what_was_trained(train, tmp_path):
    pid = tmp_path / "pid"
    said = Said(cancel_at=50)
    waiting = f"open({str(pid)!r}, 'w').write(str(os.getpid())); {EPOCH}; time.sleep(60)"
    with pytest.raises(QgsProcessingException, match=r"is saved in .*model\.training-"):
        train(said, training=waiting)
    assert time.monotonic() - said.canceled_at < 5
    with pytest.raises(ProcessLookupError):
        os.kill(int(pid.read_text()), 0)
    assert not (tmp_path / "model.onnx").exists()
    (folder,) = folders(tmp_path)
    assert (folder / "last.pt").exists()
    # The same run continues with the same tiles.
    before = (folder / "tiles" / "manifest.json").stat().st_mtime_ns
    again = f"assert job['resume'] and os.stat(folder + '/tiles/manifest.json').st_mtime_ns == {before}; {EPOCH}"
    train(training=again, MINUTES=99)
    assert (tmp_path / "model.onnx").exists() and folders(tmp_path) == []


@pytest.mark.slow
def test_a_second_training_of_the_same_model_does_not_touch_the_first(train, tmp_path):
    refused = []

    class Impatient(Said):
        def _look(self, progress):
            if progress >= 50 and not refused:
                refused.append("")
                with pytest.raises(QgsProcessingException, match="is running") as caught:
                    train(RESUME=False)
                refused.append(str(caught.value))

    assert train(Impatient())["MEAN_IOU"] == 0.4 and len(refused) == 2
    train()
    assert folders(tmp_path) == []


@pytest.mark.slow
def test_a_canceled_run_of_other_settings_or_with_an_unreadable_job_is_not_gone_on_with(train, tmp_path):
    interrupt(train)
    with pytest.raises(QgsProcessingException, match="turn off “Continue"):
        train(NETWORK=1)
    (folder,) = folders(tmp_path)
    (folder / "job.json").write_text("{")
    with pytest.raises(QgsProcessingException, match="job.json.*turn off “Continue"):
        train()
    train(NETWORK=1, RESUME=False)
    assert (tmp_path / "model.onnx").exists() and folders(tmp_path) == []


def test_a_cancel_before_the_first_epoch_leaves_nothing(train, tmp_path):
    with pytest.raises(QgsProcessingException, match="Nothing was written"):
        train(Said(cancel_at=0.5))
    assert folders(tmp_path) == []


@pytest.mark.slow
@pytest.mark.parametrize(
    ("training", "said"),
    [
        (
            'tell("failed", template="Only one class ({name}).", values={"name": "building"}, text=""); sys.exit(1)',
            r"Only one class \(building\)",
        ),
        ('tell("broke", text="Traceback", reason="out of luck"); sys.exit(2)', "out of luck. Please report"),
        ('sys.stderr.write("no memory\\n"); sys.exit(3)', r"ended without a message \(no memory\)"),
        ("os.kill(os.getpid(), 9)", "ended without a message"),
        ("sys.exit(0)", "ended without a message .*result.json"),
    ],
    ids=["a sentence", "a bug", "a last word", "killed", "nothing"],
)
def test_what_stops_the_training_is_one_sentence(train, tmp_path, training, said):
    with pytest.raises(QgsProcessingException, match=said):
        train(training=training)
    assert not (tmp_path / "model.onnx").exists() and folders(tmp_path) == []


def test_a_python_without_torch_is_refused_before_anything_is_cut(train, tmp_path):
    values = {"python": "here", "package": "torch"}
    template = "{python} lacks the Python package {package}."
    lacking = f'tell("failed", template="{template}", values={values}, text=""); sys.exit(1)'
    with pytest.raises(QgsProcessingException, match="here lacks the Python package torch"):
        train(ready=lacking)
    for other in ("print('hello')", "sys.exit(2)"):
        with pytest.raises(QgsProcessingException, match="not a Python with torch"):
            train(ready=other)
    assert folders(tmp_path) == []


def test_a_disk_that_is_full_of_tiles_is_reported_as_full(train, small_disk):
    disk = small_disk(20)
    with pytest.raises(QgsProcessingException, match="The disk is full: .*model.onnx cannot be written"):
        train(OUTPUT=str(disk / "model.onnx"))
    assert not list(disk.iterdir())


@pytest.mark.parametrize(
    ("parameter", "said"), [("LABELS", "either a land-cover layer"), ("PYTHON", "a Python with torch")]
)
def test_missing_inputs_are_reported_before_any_work(train, parameter, said):
    QgsSettings().remove("semref/options/training_python")
    with pytest.raises(QgsProcessingException, match=said):
        train(**{parameter: None})


ONE_CLASS = r"Only one class \(building\) is labeled"


@pytest.mark.parametrize("second", [[], [(square(300, 300, 90), None)]], ids=["alone", "unclassed"])
def test_ground_around_the_only_class_of_a_layer_is_the_other_class(train, kept, tmp_path, second):
    polygons = [(square(100, 500, 400), "building"), (square(20, 40, 20), "building"), *second]
    layer = str(write_layer(tmp_path / "drawn.gpkg", polygons))
    assert train(training=KEEP, LABELS=None, INPUT=layer, CLASS_FIELD="class")["MEAN_IOU"] == 0.4
    assert job_in(kept)["learn_unlabeled"] is True


def test_only_classes_of_the_wanted_ground_count(train, tmp_path):
    polygons = [(square(100, 300, 80), "building"), (square(600, 300, 90), "water")]
    annotation = {"LABELS": None, "INPUT": str(write_layer(tmp_path / "drawn.gpkg", polygons)), "CLASS_FIELD": "class"}
    with pytest.raises(QgsProcessingException, match=ONE_CLASS):
        train(EXTENT=f"{WEST},{WEST + 500},{NORTH - 500},{NORTH}", **annotation)
    assert train(**annotation)["MEAN_IOU"] == 0.4


@pytest.mark.parametrize("as_polygons", [False, True], ids=["label map", "polygons"])
def test_a_single_class_among_the_pixels_is_refused_before_tiles_are_cut(train, tmp_path, as_polygons):
    if as_polygons:
        # The corner of the water's bounding box is inside the mask, its pixels are not.
        water = polygon([(300, 600), (700, 600), (700, 100)])
        layer = write_layer(tmp_path / "drawn.gpkg", [(square(10, 300, 290), "building"), (water, "water")])
        mask = write_layer(tmp_path / "mask.gpkg", [(square(0, 0, 350), "x")])
        given = {"LABELS": None, "INPUT": str(layer), "CLASS_FIELD": "class", "MASK": str(mask)}
    else:
        labels = write_raster(tmp_path / "one.tif", np.minimum(LABELS, 1), names=NAMES)
        given = {"LABELS": str(labels)}
    trained = tmp_path / "trained"
    with pytest.raises(QgsProcessingException, match=ONE_CLASS):
        train(training=f"open({str(trained)!r}, 'w').close(); {EPOCH}", **given)
    assert not trained.exists() and folders(tmp_path) == []


def test_labels_of_other_ground_too_little_ground_and_other_imagery_are_refused_with_advice(train, tmp_path):
    layer = str(write_layer(tmp_path / "far.gpkg", [(square(99_000, 0, 80), "building")]))
    floats = str(write_raster(tmp_path / "float.tif", PHOTO, kind=gdal.GDT_Float32))
    plain = {"IMAGE": str(write_raster(tmp_path / "drawing.png", PHOTO, transform=None))}
    polygons = {"LABELS": None, "INPUT": layer, "CLASS_FIELD": "class"}
    for message, given in (
        ("don't overlap", polygons),
        ("Label more ground", {"EXTENT": f"{WEST},{WEST + 130},{NORTH - 130},{NORTH}"}),
        ("/float.tif has Float32 values", {"IMAGE": floats, "RESOLUTION": 200}),
        ("drawing.png has no georeference, so polygons", {**plain, **polygons}),
        ("drawing.png” has no georeference, so an extent", {**plain, "EXTENT": "0,600,-600,0"}),
        *(("a resolution and a mask cannot", {**plain, **one}) for one in ({"RESOLUTION": 200}, {"MASK": layer})),
    ):
        with pytest.raises(QgsProcessingException, match=message):
            train(**given)


@pytest.mark.slow
def test_files_of_the_user_in_a_folder_of_that_name_survive(train, tmp_path):
    """This applies to any file name and to a run that is finished, canceled, continued or restarted."""
    names = ["job.json", "last.pt", "tiles/manifest.json", "photos/1.jpg"]
    for name in ("model.training", "model.training-1"):
        for file in names:
            path = tmp_path / name / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("mine")
    train()
    interrupt(train)
    train()
    train(RESUME=False)
    for folder in folders(tmp_path):
        assert [(folder / file).read_text() for file in names] == ["mine"] * 4
    assert len(folders(tmp_path)) == 2


@pytest.mark.slow
@pytest.mark.parametrize("as_link", [False, True], ids=["folder", "link"])
def test_a_folder_put_in_the_place_of_the_run_s_survives(train, tmp_path, as_link):
    interrupt(train)
    (folder,) = folders(tmp_path)
    folder.rename(tmp_path / "moved")
    photos = tmp_path / "photos"
    photos.mkdir()
    for name in ("job.json", "last.pt", "1.jpg"):
        (photos / name).write_text("mine")
    if as_link:
        folder.symlink_to(photos)
    else:
        photos.rename(folder)
    train(RESUME=False)
    assert sorted(path.name for path in folder.iterdir()) == ["1.jpg", "job.json", "last.pt"]


def test_a_training_is_not_lost_where_its_model_can_t_be_moved_to_its_place(train, tmp_path, monkeypatch):
    """For example, if another program has the older model open."""

    def refuse(_):
        raise PermissionError(errno.EACCES, "in use", "model.onnx")

    with monkeypatch.context() as patched, pytest.raises(QgsProcessingException, match="model.onnx"):
        patched.setattr(Outputs, "commit", refuse)
        train()
    (folder,) = folders(tmp_path)
    assert (folder / "last.pt").exists()
    train()
    assert folders(tmp_path) == []


@pytest.mark.slow
def test_the_time_limit_counts_from_the_start_and_so_does_the_time_left(train, tmp_path):
    """Starting Python takes 3 of 12 s; the training gets the rest, and its shares are of that."""
    kept, said = tmp_path / "kept", Said()
    percents = []
    said.progressChanged.connect(percents.append)
    keep = f"shutil.copy(os.path.join(folder, 'job.json'), {str(kept)!r}); "
    train(said, ready=f"time.sleep(3); {READY}", training=keep + EPOCH, MINUTES=0.2)
    left_s = 60 * json.loads(kept.read_text())["minutes"]
    assert 0.2 * 12 - 0.1 <= left_s <= 9
    passed = 100 * (1 - left_s / 12)
    # Shares 0.2 and 0.5 of the training; before it, there is no basis for an estimate.
    assert max(percent for percent in percents if percent < passed - 1) <= 1
    assert percents[-2:] == pytest.approx([passed + 0.2 * (100 - passed), passed + 0.5 * (100 - passed)], abs=1)
