import numpy as np
import pytest
from dock_area import CONSTELLATION, choose_method, results_of, start, wait_until
from made_inputs import NAMES, WEST, write_raster
from onboard_area import MAP
from qgis.core import QgsProject, QgsRuleBasedRenderer
from qgis.PyQt.QtWidgets import QFileDialog

from semref.processing.layers.results_file import open_results
from semref.ui.findings import read_findings

SIZE, STEP, COUNT = 200, 60, 7
BLANK = 5


@pytest.fixture(scope="module")
def database(run_algorithm, tmp_path_factory):
    folder = tmp_path_factory.mktemp("map")
    parameters = {
        "LABELS": str(write_raster(folder / "labels.tif", MAP, names=NAMES)),
        "REFERENCE_CLASSES": "1;2;3",
        "WINDOW_SIZE": SIZE,
        "STRIDE": SIZE / 2,
        "MINIMUM_AREA": 30,
        "DATABASE": str(folder / "map.gpkg"),
    }
    return run_algorithm("semref:builddatabase", parameters)["DATABASE"]


@pytest.fixture
def flown(dock, tab, database, tmp_path):
    """The tab with a flight that was localized: images from west to east; one shows nothing."""
    flight = tmp_path / "flight"
    flight.mkdir()
    for number in range(COUNT):
        image = MAP[90 : 90 + SIZE, 60 + STEP * number : 60 + STEP * number + SIZE]
        write_raster(flight / f"{number}.png", image * 0 if number == BLANK else image, transform=None)
    choose_method(dock, CONSTELLATION)
    tab.images.flight.setChecked(True)
    start(dock, database, [str(flight)])
    wait_until(lambda: not tab.run.running, "the end of the run")
    return tab


@pytest.mark.slow
def test_a_flight_is_shown_with_its_track_and_what_each_image_rests_on(flown, dock, iface):
    rows = results_of(dock)
    assert [row[0] for row in rows] == [f"{n}.png" for n in range(COUNT)]
    assert rows[BLANK][1] == "Position from the flight" and rows[BLANK - 1][1] == "Position"
    track = flown.hit.track.drawn("track").asPolyline()
    truth = WEST + 60 + SIZE / 2 + STEP * np.arange(COUNT)
    assert [point.x() for point in track] == pytest.approx(truth[-len(track) :], abs=12)
    assert len(flown.hit.track.drawn("flight").asMultiPoint()) >= 1
    assert len(flown.hit.track.drawn("own").asMultiPoint()) >= 3


@pytest.mark.slow
def test_its_layers_are_saved_with_their_style_and_bring_the_track_back(flown, tmp_path, monkeypatch):
    path = str(tmp_path / "flown.gpkg")
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (path, ""))
    flown.results.save.click()
    layers = list(QgsProject.instance().mapLayers().values())
    positions = next(layer for layer in layers if layer.geometryType() == 0)
    assert {layer.name() for layer in layers} == {"flown", "flown · SemRef track"}
    assert len(layers) == 2 and isinstance(positions.renderer(), QgsRuleBasedRenderer)
    *_others, track = open_results(path)
    assert track is not None and track.featureCount() == 1
    assert [finding.source for finding in read_findings(path)][BLANK] == "flight"
