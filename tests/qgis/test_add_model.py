import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from made_inputs import write_raster
from made_models import write_model
from osgeo import gdal
from qgis.core import QgsProcessingException

from semref.core.segmentation.model_card import Ground, ModelCard, read_card
from semref.core.segmentation.network_facts import FLAIR
from semref.core.segmentation.onnx_file import read_header
from semref.processing.reports.model_card import card_html

ADD = "semref:addmodel"
GIVEN = {"CLASSES": "building;water;building", "RESOLUTION": 25, "LICENSE": "CC0"}


@pytest.fixture
def add(runner, tmp_path):
    return runner(ADD, "INPUT", OUTPUT=tmp_path / "added.onnx")


@pytest.fixture
def bare(tmp_path):
    return write_model(tmp_path / "bare.onnx", metadata={}, size=(64, 64))


def test_a_network_without_names_becomes_a_model_that_segments(add, bare, run_algorithm, tmp_path):
    results = add(bare, **GIVEN)
    assert results["CLASS_COUNT"] == 2
    card = read_card(results["OUTPUT"])
    assert (card.name, card.classes, card.resolution_m, card.license) == ("bare", ("building", "water"), 0.25, "CC0")
    image = np.zeros((3, 64, 64), np.uint8)
    image[2, :, :32] = image[0, :, 32:] = 250
    photo = str(write_raster(tmp_path / "photo.tif", image, transform=(0, 0.25, 0, 0, 0, -0.25)))
    segmented = run_algorithm(
        "semref:segmentimage", {"INPUT": photo, "MODEL": results["OUTPUT"], "OUTPUT": str(tmp_path / "seen.tif")}
    )
    seen = gdal.Open(segmented["OUTPUT"]).ReadAsArray()
    assert (seen[:, :30] == 2).all() and (seen[:, 34:] == 1).all()


def test_numbers_for_pixels_from_0_to_255_are_converted(add, bare):
    results = add(bare, **GIVEN, PIXEL_VALUES=1, MEAN="51;102;0", STANDARD_DEVIATION="255;51;51")
    texts = read_header(Path(results["OUTPUT"]).read_bytes()).texts
    assert (texts["standardization_mean"], texts["standardization_std"]) == ("[0.2, 0.4, 0.0]", "[1.0, 0.2, 0.2]")


def test_what_a_file_or_a_preset_states_need_not_be_given(add, bare, tmp_path):
    first = add(bare, **GIVEN, NAME="First")["OUTPUT"]
    again = add(first, OUTPUT=str(tmp_path / "again.onnx"), CLASSES="a;b")["OUTPUT"]
    assert (read_card(again).name, read_card(again).license) == ("First", "CC0")
    with pytest.raises(QgsProcessingException, match="has 3 outputs, but there are 19 class names"):
        add(bare, PRESET=1)
    flair = add(bare, PRESET=1, CLASSES="road;building;trees")["OUTPUT"]
    assert read_card(flair).license == FLAIR.license and read_card(flair).resolution_m == 0.2


def test_missing_statements_and_files_that_are_no_network_are_one_sentence(add, bare, tmp_path):
    with pytest.raises(QgsProcessingException, match="Enter the resolution"):
        add(bare, CLASSES="a;b;c", LICENSE="CC0")
    with pytest.raises(QgsProcessingException, match="not a list of numbers"):
        add(bare, **GIVEN, MEAN="a;b;c")
    (tmp_path / "text.onnx").write_text("no network")
    with pytest.raises(QgsProcessingException, match="is not an ONNX model"):
        add(tmp_path / "text.onnx", **GIVEN)
    assert not (tmp_path / "added.onnx").exists()


def test_a_checkpoint_needs_a_python_with_torch(add, tmp_path):
    (tmp_path / "others.pth").write_bytes(b"PK")
    with pytest.raises(QgsProcessingException, match="Enter the class of each output"):
        add(tmp_path / "others.pth")
    with pytest.raises(QgsProcessingException, match="lacks the Python package|is not a Python with torch"):
        add(tmp_path / "others.pth", **GIVEN, PYTHON=sys.executable)


@pytest.mark.slow
def test_a_checkpoint_of_the_training_environment_is_added(add, tmp_path, training_python):
    program = (
        "import sys; sys.path.append('tools'); from plugin_package import load_plugin_package; load_plugin_package();"
        "import torch; from semref.training.network import allow_torchvision_without_operators as allow; allow();"
        "import segmentation_models_pytorch as smp;"
        "torch.save(smp.Linknet('resnet18', encoder_weights=None, classes=3).state_dict(), sys.argv[1])"
    )
    path = tmp_path / "others.pth"
    subprocess.run([str(training_python), "-c", program, str(path)], check=True)
    given = {**GIVEN, "ARCHITECTURE": "linknet", "ENCODER": "resnet18", "PYTHON": str(training_python)}
    assert read_card(add(path, **given)["OUTPUT"]).classes == ("building", "water")


def test_no_text_of_a_model_becomes_markup():
    hostile = "<b>a&b</b>"
    ground = Ground(hostile, hostile, True, {hostile: 0.5})
    card = ModelCard(
        hostile, None, hostile, (hostile,), 0.25, trained_on=(ground,), tested_on=(ground,), license=hostile
    )
    assert "<b>a" not in card_html(card) and card_html(card).count("&lt;b&gt;a&amp;b&lt;/b&gt;") == 8
