import json
import os
import subprocess
import sys
import time
from pathlib import Path

import cv2
import numpy as np
import pytest
from full_disks import files_of_at_most
from listening import listening

from semref.core.labels.image_source import ArrayImage
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.model_card import read_card
from semref.core.segmentation.photo_labels import PhotoLabels
from semref.training.job import Job, read_job

ROOT = Path(__file__).resolve().parents[2]
COLORS = ((40, 160, 40), (200, 60, 60), (60, 60, 200))
"""Class values of unlabeled ground, buildings and water."""

CLASSES = "value,name,color,role\n1,building,#c83c3c,reference\n2,water,#3c3cc8,reference\n"
TILE = 128
NOT_OURS = "{path} was not trained by SemRef, so its training can't be continued."


@pytest.fixture(scope="module")
def tiles(tmp_path_factory):
    """Return a folder of tiles like that of semref:exporttrainingtiles: red and blue squares on green."""
    folder = tmp_path_factory.mktemp("tiles")
    rng = np.random.default_rng(7)
    for subset, count in (("train", 8), ("validation", 2)):
        for kind in ("images", "labels"):
            (folder / subset / kind).mkdir(parents=True)
        for number in range(count):
            labels = np.kron(rng.integers(0, 3, (4, 4)), np.ones((32, 32))).astype(np.uint8)
            image = np.array(COLORS)[labels] + rng.normal(0, 8, (TILE, TILE, 3))
            name = f"{number * TILE}_0.png"
            cv2.imwrite(str(folder / subset / "images" / name), np.clip(image, 0, 255).astype(np.uint8)[:, :, ::-1])
            cv2.imwrite(str(folder / subset / "labels" / name), labels)
    (folder / "classes.csv").write_text(CLASSES)
    pixels = {"0": 40_000, "1": 45_000, "2": 46_000}
    statistics = {"band_mean": [0.4] * 3, "band_std": [0.2] * 3, "class_pixels": {"train": pixels}}
    manifest = {"statistics": statistics, "network_bands": [1, 2, 3], "stretch": None}
    (folder / "manifest.json").write_text(json.dumps({**manifest, "tile_size": TILE, "pixel_size": 0.5}))
    return folder


def job_of(tiles, folder: Path, **settings) -> Job:
    folder.mkdir(exist_ok=True)
    small = {"epochs": 2, "pieces": 16, "batch": 4, "piece_size": 128, "threads": 1, "learn_unlabeled": True}
    return Job((str(tiles),), str(folder / "model.onnx"), str(folder / "run"), **{**small, **settings})


def command(python: Path, job: Job) -> list[str]:
    path = Path(job.folder).with_suffix(".json")
    job.write(path)
    assert read_job(path) == job
    return [str(python), str(ROOT / "program.py"), "training.command", str(path)]


def trained(python: Path, job: Job) -> list[dict]:
    done = subprocess.run(command(python, job), capture_output=True, text=True, check=False)
    events = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    assert events, done.stderr
    return events


@pytest.fixture(scope="module")
def first(training_python, tiles, tmp_path_factory):
    """Return (job, events) of a training from random weights."""
    job = job_of(tiles, tmp_path_factory.mktemp("first"), ground={"image": "made up"})
    return job, trained(training_python, job)


def test_a_python_without_torch_reports_what_it_lacks():
    command = [sys.executable, str(ROOT / "program.py"), "training.command"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    event = json.loads(done.stdout.splitlines()[-1])
    assert event["event"] == "ready" or event["template"].startswith("{python} lacks the Python package {package}.")


def test_training_reports_each_epoch_and_its_results(first):
    job, events = first
    kinds = [event["event"] for event in events if event["event"] != "step"]
    assert kinds == ["begun", "epoch", "epoch", *["exporting"] * 3, "done"]
    shares = [event["share"] for event in events if "share" in event]
    assert shares == sorted(shares) and shares[-1] <= 1
    assert all(np.isfinite(event["training_loss"]) for event in events if event["event"] == "epoch")
    result = json.loads((Path(job.folder) / "result.json").read_text())
    assert [len(result["history"]), result["stopped_by"]] == [2, "epochs"]
    assert np.sum(result["confusion"]) == 2 * TILE * TILE
    assert len(list((Path(job.folder) / "examples").glob("*.png"))) == 2
    rows = (Path(job.folder) / "curves.csv").read_text().splitlines()
    assert rows[0].startswith("epoch,training_loss,mean_iou") and len(rows) == 3


def test_the_model_is_one_that_semref_segments_with_and_carries_a_card(first):
    job, _ = first
    model = SegmentationModel(job.output, 1)
    assert model.settings.resolution_m == 0.5
    assert 0.25 <= model.temperature <= 16
    assert model.classes.names == ("other", "building", "water") and model.classes.values == (0, 1, 2)
    photo = np.broadcast_to(np.uint8(COLORS[1]), (160, 200, 3)).copy()
    seen = PhotoLabels(model, ArrayImage(photo), model.classes.values).seen()
    assert seen.labels_hw.shape == (160, 200) and seen.shares.values.tolist() == [1, 2]
    card = read_card(job.output)
    assert (card.fault, card.classes, card.resolution_m) == (None, ("other", "building", "water"), 0.5)
    assert [ground.place for ground in card.trained_on] == ["made up"]
    assert set(card.validation_iou) == set(card.classes) and len(card.confusion) == 3
    # A fast machine takes less than the reported tenth of a minute.
    assert len(card.date) == 10 and 0 <= card.minutes < 5


def test_ground_where_only_buildings_were_drawn_is_learned_from_beside_others(training_python, tiles, tmp_path):
    """Its unlabeled ground is a label of its own, which the report's matrix does not show."""
    job = job_of(tiles, tmp_path, learn_unlabeled=False, complete={str(tiles): ["building"]}, card={"name": "a name"})
    events = trained(training_python, job)
    assert len(events[0]["class_weights"]) == 4 and events[-1]["event"] == "done"
    result = json.loads((Path(job.folder) / "result.json").read_text())
    assert np.shape(result["confusion"]) == (3, 3)
    assert read_card(job.output).name == "a name"


@pytest.mark.slow
def test_a_run_that_was_ended_goes_on_where_it_was(training_python, tiles, tmp_path):
    job = job_of(tiles, tmp_path, epochs=30, pieces=16, resume=True)
    process = subprocess.Popen(command(training_python, job), stdout=subprocess.PIPE, text=True)
    for line in process.stdout:
        if line.startswith('{"event": "epoch"'):
            break
    process.kill()
    process.wait()
    done = json.loads(line)["epoch"]
    # Another number of epochs is no other training.
    events = trained(training_python, Job(**{**job.__dict__, "epochs": done + 2}))
    resumed = next(event for event in events if event["event"] == "resumed")
    assert resumed["epoch"] >= done
    assert events[-1]["event"] == "done"
    history = json.loads((Path(job.folder) / "result.json").read_text())["history"]
    assert [row["epoch"] for row in history] == list(range(1, len(history) + 1))


@pytest.mark.slow
def test_the_model_is_written_before_its_time_is_over(training_python, tiles, tmp_path):
    """This includes starting torch, testing, writing and checking."""
    started = time.monotonic()
    events = trained(training_python, job_of(tiles, tmp_path, epochs=10_000, patience=0, minutes=0.75))
    elapsed_s = time.monotonic() - started
    assert events[-1]["stopped_by"] == "minutes"
    assert 20 < events[-1]["seconds"] < elapsed_s < 45
    shares = [event["share"] for event in events if "share" in event]
    assert shares[-1] == pytest.approx(elapsed_s / 45, abs=0.15)


def assert_answer_alike(*paths):
    models = [SegmentationModel(path, 1) for path in paths]
    photo = np.clip(np.random.default_rng(3).normal(120, 50, (128, 128, 3)), 0, 255).astype(np.uint8)
    answers = [PhotoLabels(model, ArrayImage(photo), model.classes.values).found() for model in models]
    assert (answers[0] == answers[1]).mean() > 0.95


def test_training_continues_from_the_base_model(training_python, first, tiles, tmp_path):
    """With a tiny learning rate it answers like its base; classes are matched by name."""
    base, _ = first
    (tmp_path / "reordered").mkdir()
    job = job_of(tiles, tmp_path, base_model=base.output, epochs=1, pieces=4, learning_rate=1e-9, encoder="not ours")
    events = trained(training_python, job)
    assert events[-1]["event"] == "done", events[-1]
    assert_answer_alike(base.output, job.output)


def test_a_base_model_that_training_makes_poorer_stays_as_it_is(training_python, first, tiles, tmp_path):
    job = job_of(tiles, tmp_path, base_model=first[0].output, epochs=1, pieces=8, learning_rate=0.3)
    events = trained(training_python, job)
    assert events[-1]["event"] == "done" and events[-1]["best_epoch"] == 0
    assert_answer_alike(first[0].output, job.output)


def with_encoder(path: Path, base: Path, encoder: str) -> Path:
    import onnx

    if path.suffix == ".pt":
        path.write_bytes(b"weights")
        said = {"encoder": encoder, "depth": 5, "class_names": ["a"]}
        (path.parent / "network.json").write_text(json.dumps(said))
        return path
    model = onnx.load(base)
    (entry,) = (entry for entry in model.metadata_props if entry.key == "architecture")
    entry.value = json.dumps({"encoder": encoder, "depth": 5})
    onnx.save(model, path)
    return path


@pytest.mark.parametrize("name", ["model.pt", "model.onnx"])
def test_a_base_model_contacts_nobody(training_python, first, tiles, tmp_path, monkeypatch, name):
    """Names of encoders may be network addresses."""
    with listening() as server:
        monkeypatch.setenv("HF_ENDPOINT", server.url)
        monkeypatch.setenv("NO_PROXY", "127.0.0.1")
        base = with_encoder(tmp_path / name, Path(first[0].output), "tu-hf-hub:some/network")
        events = trained(training_python, job_of(tiles, tmp_path / "run", base_model=str(base)))
    assert events[-1]["template"].startswith(NOT_OURS) and not server.asked


def test_a_base_model_reads_no_other_file(training_python, first, tiles, tmp_path):
    import onnx

    base = tmp_path / "base.onnx"
    onnx.save(onnx.load(first[0].output), base, save_as_external_data=True, location="other", size_threshold=0)
    events = trained(training_python, job_of(tiles, tmp_path / "run", base_model=str(base)))
    assert events[-1]["template"].startswith(NOT_OURS)


def test_a_damaged_checkpoint_is_reported_in_a_sentence(training_python, tiles, tmp_path):
    job = job_of(tiles, tmp_path, resume=True)
    Path(job.folder).mkdir()
    (Path(job.folder) / "last.pt").write_bytes(bytes(1000))
    assert trained(training_python, job)[-1]["template"].startswith("{path} is damaged ({reason}), so this training")


def test_a_full_disk_is_reported_in_a_sentence(training_python, tiles, tmp_path):
    with files_of_at_most(100_000):
        events = trained(training_python, job_of(tiles, tmp_path))
    assert events[-1]["template"].startswith("The training can't be saved in {folder} ({reason}).")
    assert not (tmp_path / "run" / "last.pt").exists()


@pytest.mark.parametrize(
    ("settings", "code"),
    [
        ({"base_model": "no.onnx"}, NOT_OURS),
        ({"base_model": str(ROOT / "README.md")}, NOT_OURS),
        ({"encoder_weights": str(ROOT / "README.md")}, "{path} has no torch weights: {reason}."),
        ({"tiles": ("/nowhere",)}, "{path} has no exported training tiles: {reason}."),
    ],
    ids=["no base", "a base that is none", "weights that are none", "no tiles"],
)
def test_impossible_settings_are_reported_in_a_sentence(training_python, tiles, tmp_path, settings, code):
    job = Job(**{**job_of(tiles, tmp_path).__dict__, **settings})
    assert trained(training_python, job)[-1]["template"].startswith(code)


def test_training_with_one_class_is_refused(training_python, tiles, tmp_path):
    manifest = json.loads((tiles / "manifest.json").read_text())
    manifest["statistics"]["class_pixels"]["train"] = {"0": 40_000, "1": 45_000}
    for entry in ("train", "validation", "classes.csv"):
        os.symlink(tiles / entry, tmp_path / entry)
    (tmp_path / "manifest.json").write_text(json.dumps(manifest))
    job = job_of(tmp_path, tmp_path / "run", learn_unlabeled=False)
    event = trained(training_python, job)[-1]
    assert event["template"].startswith("Only one class ({name}) is labeled")
    assert event["values"] == {"name": "building"}


def test_settings_that_decide_the_result_are_distinguished_from_those_that_don_t(tiles, tmp_path):
    job = job_of(tiles, tmp_path)
    other = Job(**{**job.__dict__, "epochs": 99, "output": "other", "encoder": "another", "fingerprint": {"a": (1,)}})
    assert job.differences(other) == ["encoder", "fingerprint"]
    assert job.differences(job) == []
