import json
import sys

import numpy as np
import pytest
from full_disks import files_of_at_most
from made_inputs import NAMES, NORTH, WEST, read_rows, scattered_objects, write_raster
from made_models import write_model
from qgis.core import QgsProcessingException

from semref.core.errors import SemRefError
from semref.core.segmentation.onnx_file import read_header
from semref.core.simulation.displacement import displace
from semref.core.simulation.noise import LabelNoise
from semref.core.steps import result_of
from semref.storage import label_comparison
from semref.storage.label_comparison import DisagreementMap, LabelMapPair

COMPARE = "semref:comparelabels"
LABELS = scattered_objects(120, 160, 30, seed=3)


@pytest.fixture
def compare(run_algorithm, feedback, tmp_path):
    """`compare(reference, predicted, **parameters)` returns (rows of the polygons with their box, results)."""

    def run(reference, predicted, **parameters):
        given = {"REFERENCE": str(reference), "PREDICTED": str(predicted), "MINIMUM_AREA": 0}
        given["DISAGREEMENTS"] = str(tmp_path / "disagreements.gpkg")
        results = run_algorithm(COMPARE, {**given, **parameters}, feedback)
        found = read_rows(results["DISAGREEMENTS"])
        for row in found:
            shape = row.pop("geometry")
            assert shape.IsValid() and shape.GetArea() == row["area"]
            row["box"] = tuple(round(v, 6) for v in shape.GetEnvelope())
        return found, results

    return run


@pytest.fixture
def maps(tmp_path):
    """Return (annotated map, predicted map with two wrong rectangles)."""
    wrong = LABELS.copy()
    wrong[10:20, 30:50] = 0
    wrong[60:90, 100:140] = 2
    annotated = write_raster(tmp_path / "annotated.tif", LABELS, names=NAMES)
    return annotated, write_raster(tmp_path / "predicted.tif", wrong, names=NAMES), wrong


def test_polygons_cover_what_disagrees_and_nothing_else(compare, maps):
    annotated, predicted, wrong = maps
    found, _ = compare(annotated, predicted)
    assert sum(row["area"] for row in found) == (wrong != LABELS).sum()
    pairs = {(row["annotated_value"], row["predicted_value"]) for row in found}
    assert pairs == {(int(a), int(b)) for a, b in zip(LABELS[wrong != LABELS], wrong[wrong != LABELS])}
    names = {(row["annotated_class"], row["predicted_class"]) for row in found}
    assert names == {(NAMES[a], NAMES[b]) for a, b in pairs}


def test_the_report_shows_the_matrix_and_every_class(compare, maps, tmp_path):
    path = tmp_path / "report.html"
    _, results = compare(*maps[:2], REPORT=str(path))
    text = path.read_text(encoding="utf-8")
    assert results["REPORT"] == str(path)
    for key in ("OVERALL_ACCURACY", "MEAN_IOU"):
        assert f"{100 * results[key]:.1f}\u00a0%" in text
    assert "background:rgba" in text and all(name in text for name in NAMES)
    assert "predicted.tif compared with annotated.tif" in text


def test_maps_without_names_are_matched_by_value_with_a_note(compare, tmp_path, feedback):
    annotated = write_raster(tmp_path / "a.tif", LABELS)
    _, results = compare(annotated, write_raster(tmp_path / "b.tif", LABELS, names=NAMES))
    assert results["OVERALL_ACCURACY"] == 1
    assert "matched by their values" in feedback.textLog()


def test_a_prediction_of_other_pixels_and_extent_is_compared_on_the_annotated_ones(compare, tmp_path):
    wrong = LABELS.copy()
    wrong[60:90, 100:140] = 2
    fine = np.kron(wrong, np.ones((2, 2), np.uint8))[20:, 40:]  # From row 10, column 20.
    annotated = write_raster(tmp_path / "a.tif", LABELS)
    predicted = write_raster(tmp_path / "b.tif", fine, transform=(WEST + 20, 0.5, 0, NORTH - 10, 0, -0.5))
    found, results = compare(annotated, predicted)
    assert results["OVERALL_ACCURACY"] == pytest.approx((wrong == LABELS)[10:, 20:].mean())
    assert sum(row["area"] for row in found) == (wrong != LABELS)[10:, 20:].sum()
    assert found[0]["box"][0] >= WEST + 100


def test_photos_without_georeference_are_compared_pixel_by_pixel(compare, tmp_path):
    labels, noise = np.random.default_rng(9).integers(1, 4, (2, 70, 90)).astype(np.uint8)
    noise[3:9, 4:14], labels[3:9, 4:14] = 2, 4
    annotated = write_raster(tmp_path / "a.png", labels, transform=None)
    found, _ = compare(annotated, write_raster(tmp_path / "b.png", noise, transform=None))
    assert [row["box"] for row in found if row["annotated_value"] == 4] == [(4, 14, -9, -3)]
    assert sum(row["area"] for row in found) == (labels != noise).sum()


def test_blocks_give_the_same_as_the_whole(compare, maps, monkeypatch):
    whole = compare(*maps[:2])
    monkeypatch.setattr(label_comparison, "_PIXELS_AT_ONCE", 1000)
    assert compare(*maps[:2])[0] == whole[0]


@pytest.mark.parametrize(
    ("pixels", "options", "message"),
    [
        (LABELS, {"crs": 32633}, "reference map is in EPSG:32632 .*, but the predicted map in EPSG:32633"),
        (LABELS, {"transform": None}, "the prediction 160 × 120, and not both have a georeference"),
        (LABELS, {"transform": (WEST + 5000, 1, 0, NORTH, 0, -1)}, "don't overlap"),
        (LABELS, {"transform": (WEST, 0.8, 0.6, NORTH, 0.6, -0.8)}, "rotated"),
        (np.stack([LABELS] * 3), {}, "has 3 bands; a label map has one"),
    ],
)
def test_maps_that_cannot_be_compared_are_refused(compare, tmp_path, pixels, options, message):
    predicted = write_raster(tmp_path / "b.tif", pixels, **options)
    with pytest.raises(QgsProcessingException, match=message):
        compare(write_raster(tmp_path / "a.tif", LABELS), predicted)
    assert not (tmp_path / "disagreements.gpkg").exists()


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="limits on files as Unix has them")
def test_a_full_disk_for_polygons_is_reported(tmp_path):
    """What is lost on a full disk must not look like equal maps."""
    noise = np.random.default_rng(5).integers(0, 2, LABELS.shape).astype(np.uint8)
    pair = LabelMapPair(*(str(write_raster(tmp_path / f"{n}.tif", LABELS)) for n in range(2)))
    outcomes = []
    for size in (*range(0, 60_000, 6_000), 5_000_000):
        with DisagreementMap(pair) as disagreements:
            try:
                with files_of_at_most(size):
                    disagreements.write_rows(0, noise.astype(np.uint16))
                    outcomes.append(len(result_of(disagreements.polygons(0))))
            except SemRefError:
                outcomes.append("told")
    whole = outcomes[-1]
    assert whole > 100
    assert "told" in outcomes
    assert set(outcomes) == {"told", whole}


@pytest.fixture
def shifted(tmp_path):
    """Return the annotated map, and a prediction with buildings 2 pixels right and 1 down; pixels are 0.5 m."""
    rng = np.random.default_rng(5)
    true = scattered_objects(700, 1600, 900, seed=6)
    moved = displace(true, LabelNoise(class_shifts=((1, 2.0, 1.0),)), rng)
    half = (WEST, 0.5, 0, NORTH, 0, -0.5)
    annotated = write_raster(tmp_path / "annotated.tif", true, names=NAMES, transform=half)
    return annotated, write_raster(tmp_path / "predicted.tif", moved, names=NAMES, transform=half)


def test_a_models_bias_is_measured_and_written_into_its_copy(compare, shifted, tmp_path, feedback):
    model, copy = write_model(tmp_path / "network.onnx"), tmp_path / "copy.onnx"
    compare(*shifted, MODEL=str(model), MODEL_OUTPUT=str(copy), SUN_DIRECTION=150, REPORT=str(tmp_path / "r.html"))
    texts = read_header(copy.read_bytes()).texts
    found = json.loads(texts["class_bias"])["building"]
    assert found["east"] == pytest.approx(1.0, abs=0.1) and found["north"] == pytest.approx(-0.5, abs=0.1)
    assert found["spread"] < 0.2 and found["sun"] == 150
    assert {**read_header(model.read_bytes()).texts, "class_bias": texts["class_bias"]} == texts
    assert "building" in (tmp_path / "r.html").read_text(encoding="utf-8").split("Class offsets")[1]
    assert "building: class offset +1.0" in feedback.textLog()


def test_the_displacement_of_landmarks_is_the_map_accuracy(compare, shifted, tmp_path, feedback):
    _, results = compare(*shifted, REPORT=str(tmp_path / "r.html"))
    assert 0.3 < results["MAP_ACCURACY"] < np.hypot(1.0, 0.5) / 2**0.5 + 0.1
    assert "use this value as map accuracy" in feedback.textLog()
    assert "Correlation of their displacements" in (tmp_path / "r.html").read_text(encoding="utf-8")


def test_a_bias_that_is_not_in_meters_goes_into_no_model(compare, tmp_path):
    paths = [write_raster(tmp_path / f"{name}.png", LABELS, transform=None) for name in "ab"]
    model = write_model(tmp_path / "network.onnx")
    with pytest.raises(QgsProcessingException, match="CRS of the maps has no meters"):
        compare(*paths, MODEL=str(model), MODEL_OUTPUT=str(tmp_path / "copy.onnx"))
    with pytest.raises(QgsProcessingException, match="Select the model as well"):
        compare(*paths, MODEL_OUTPUT=str(tmp_path / "copy.onnx"))
    assert not (tmp_path / "copy.onnx").exists()
