import importlib.util
import json
from pathlib import Path

import numpy as np
import pytest
from made_inputs import read_rows, scattered_objects, turned_view, write_raster
from made_models import metadata, painted, write_model
from qgis.core import QgsProcessingException

from semref.processing.base.scheduler import Workers

LOCALIZE, ASSESS = "semref:localizeimages", "semref:assessdatabase"
EVALUATE = "semref:evaluatelocalization"
SIZE = 160
NAMES = ["unlabeled", "building", "water", "bare_land"]
LABELS = scattered_objects(500, 600, 380, seed=7, background=0)
OUTPUTS = ("OUTPUT", "FOOTPRINTS", "ALTERNATIVES", "MATCHES")
pytestmark = [
    pytest.mark.skipif(importlib.util.find_spec("distributed") is None, reason="Dask is not here"),
    pytest.mark.slow,  # tests/qgis/test_scheduler.py has a quick test.
]


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(LABELS, NAMES, SIZE, 40)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Return label images with a position, without landmarks, unreadable, and of a tilted camera."""
    folder = tmp_path_factory.mktemp("images")
    for n, (row, column) in enumerate([(40, 60), (180, 320), (300, 200), (90, 400)]):
        write_raster(folder / f"image_{n}.png", LABELS[row : row + SIZE, column : column + SIZE], transform=None)
    write_raster(folder / "turned.png", turned_view(LABELS, 250.0, 220.0, 33, SIZE), transform=None)
    write_raster(folder / "nothing.png", np.zeros((SIZE, SIZE), np.uint8), transform=None)
    (folder / "broken.png").write_bytes(b"no image")
    (folder / "cameras.csv").write_text(
        "image,roll,pitch,field_of_view,time\nimage_1.png,1,-2,60,5\nimage_2.png,0,0,60,6\n"
    )
    return folder


def require_same(found, expected, rel=1e-6, absolute=1e-9):
    """Compare with a tolerance: sums depend on the threads of OpenBLAS, and workers use one."""
    found, expected = read_rows(found), read_rows(expected)
    assert len(found) == len(expected)
    for values, others in zip(found, expected):
        shapes = [one.pop("geometry") for one in (values, others)]
        assert len({shape and shape.GetGeometryType() for shape in shapes}) == 1 and values.keys() == others.keys()
        for name, value in values.items():
            close = pytest.approx(others[name], rel=rel, abs=absolute) if isinstance(value, float) else others[name]
            assert value == close, name
    return found


@pytest.fixture
def localized(run_algorithm, tmp_path, feedback):
    """`localized(**parameters)` localizes in QGIS and by a worker, and returns the rows of each output."""

    def run(**parameters):
        results = []
        for name, more in (("qgis", {}), ("dask", {"SCHEDULER": "local:1"})):
            (tmp_path / name).mkdir()
            layers = {key: str(tmp_path / name / f"{key}.gpkg") for key in OUTPUTS}
            results.append(run_algorithm(LOCALIZE, {**layers, **parameters, **more}, feedback))
        assert results[0]["FIX_COUNT"] == results[1]["FIX_COUNT"]
        return results[1]["FIX_COUNT"], [require_same(results[1][key], results[0][key]) for key in OUTPUTS]

    return run


@pytest.mark.parametrize("method", [0, 1])
def test_workers_localize_what_qgis_localizes(localized, database, folder, feedback, method):
    asked = {"DATABASE": database, "IMAGES": str(folder), "METHOD": method, "ATTITUDE": str(folder / "cameras.csv")}
    count, layers = localized(**asked, MAXIMUM_SPEED=30)
    assert count >= 4 and len(layers[0]) == 7 and (len(layers[3]) > 20 or method == 1)
    assert feedback.progress() == 100


def test_workers_localize_photos_by_the_network_that_qgis_takes(localized, database, tmp_path):
    model = write_model(tmp_path / "colors.onnx", metadata=metadata(resolution_m=1.0))
    for n, (row, column) in enumerate([(40, 60), (180, 320)]):
        pixels = np.moveaxis(painted(LABELS[row : row + SIZE, column : column + SIZE]), 2, 0)
        # One photo with pixels in degrees, one without a pixel size.
        place = {"transform": (9.5, 1e-5, 0, 47.2, 0, -7e-6), "crs": 4326} if n else {"transform": None}
        write_raster(tmp_path / f"photo_{n}.tif", pixels, **place)
    cameras = tmp_path / "cameras.csv"
    cameras.write_text("image,field_of_view,height\nphoto_0.tif,60,138.56\n", encoding="utf-8")
    asked = {"DATABASE": database, "IMAGES": str(tmp_path), "MODEL": str(model), "METHOD": 2, "ATTITUDE": str(cameras)}
    assert localized(**asked)[0] == 2


@pytest.mark.parametrize(("key", "title"), [("LABELS", "Folder for label images"), ("LAYER", "Layer to test")])
def test_what_only_qgis_can_do_is_refused_before_any_work(run_algorithm, database, folder, tmp_path, key, title):
    given = str(tmp_path / "labels") if key == "LABELS" else str(folder / "image_0.png")
    asked = {"DATABASE": database, "IMAGES": str(folder), key: given, "SCHEDULER": "local:1"}
    with pytest.raises(QgsProcessingException, match=f"together with “{title}”"):
        run_algorithm(LOCALIZE, {**asked, "OUTPUT": str(tmp_path / "positions.gpkg")})


@pytest.fixture(scope="module")
def trial_area(build_area):
    return build_area(scattered_objects(420, 480, 300, seed=21, background=0), NAMES, SIZE, 40)


def test_workers_assess_what_qgis_assesses(run_algorithm, trial_area, tmp_path, feedback):
    asked = {"DATABASE": trial_area, "TRIALS": 60, "FOOTPRINT": "160;120", "SPACING": 80}
    expected = run_algorithm(ASSESS, {**asked, "OUTPUT": str(tmp_path / "qgis.gpkg")})
    scheduled = {**asked, "SCHEDULER": "local:1", "OUTPUT": str(tmp_path / "dask.gpkg")}
    scheduled["REPORT"] = str(tmp_path / "report.html")
    found = run_algorithm(ASSESS, scheduled, feedback)
    assert found["LOCALIZABLE_FRACTION"] == pytest.approx(expected["LOCALIZABLE_FRACTION"])
    assert require_same(found["OUTPUT"], expected["OUTPUT"], 1e-5, 1e-7)
    assert (tmp_path / "report.html").stat().st_size > 10_000 and feedback.progress() == 100


def test_workers_evaluate_what_qgis_evaluates(run_algorithm, trial_area, tmp_path, feedback):
    asked = {"DATABASE": trial_area, "TRIALS": 12, "METHODS": [0, 1]}
    asked["LABELS"] = str(Path(trial_area).with_name("labels.tif"))
    expected = run_algorithm(EVALUATE, {**asked, "OUTPUT": str(tmp_path / "qgis.gpkg"), "REPORT": None})
    scheduled = {**asked, "SCHEDULER": "local:1", "OUTPUT": str(tmp_path / "dask.gpkg")}
    scheduled["JSON"] = str(tmp_path / "numbers.json")
    found = run_algorithm(EVALUATE, scheduled, feedback)
    for key in ("SUCCESS_RATE", "MEDIAN_ERROR", "FALSE_ACCEPT_RATE"):
        assert found[key] == pytest.approx(expected[key], rel=1e-5)
    assert found["SUCCESS_RATE"] > 0.3
    assert require_same(found["OUTPUT"], expected["OUTPUT"], 1e-5, 1e-7)
    numbers = json.loads((tmp_path / "numbers.json").read_text(encoding="utf-8"))
    assert len(numbers["trials"]) == 24 and numbers["scaling"]


def test_a_database_changed_before_workers_begin_is_seen(run_algorithm, build_area, trial_area, tmp_path, monkeypatch):
    area, wait = tmp_path / "area.gpkg", Workers.wait
    area.write_bytes(Path(trial_area).read_bytes())
    other = Path(build_area(scattered_objects(420, 480, 280, seed=5, background=0), NAMES, SIZE, 40)).read_bytes()

    def late(run):
        area.write_bytes(other)
        wait(run)

    monkeypatch.setattr(Workers, "wait", late)
    asked = {"DATABASE": str(area), "TRIALS": 20, "SCHEDULER": "local:1", "OUTPUT": str(tmp_path / "never.gpkg")}
    with pytest.raises(QgsProcessingException, match="area.gpkg was changed while it was read"):
        run_algorithm(ASSESS, asked)
    assert [path.name for path in tmp_path.iterdir()] == ["area.gpkg"]
