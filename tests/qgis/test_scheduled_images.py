"""SCHEDULER of Localize images: workers give QGIS's results and messages, and a cancel leaves nothing."""

import importlib.util

import numpy as np
import pytest
from made_inputs import scattered_objects, turned_view, write_raster
from made_models import metadata, painted, write_model
from osgeo import ogr
from qgis.core import QgsProcessingException

LOCALIZE = "semref:localizeimages"
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


def rows(path):
    source = ogr.Open(path)
    layer = source.GetLayer(0)
    found = []
    for feature in layer:
        shape = feature.GetGeometryRef()
        found.append((feature.items(), "" if shape is None else shape.ExportToIsoWkt()))
    return found


def require_same(found, expected):
    """Compare with a tolerance: sums depend on the threads of OpenBLAS, and workers use one."""
    assert len(found) == len(expected)
    for (values, shape), (others, other) in zip(found, expected):
        assert shape.partition("(")[0] == other.partition("(")[0]
        assert values.keys() == others.keys()
        for name, value in values.items():
            if isinstance(value, float):
                assert value == pytest.approx(others[name], rel=1e-6, abs=1e-9), name
            else:
                assert value == others[name], name


def localized(run_algorithm, folder, feedback=None, **parameters):
    layers = {key: str(folder / f"{key}.gpkg") for key in OUTPUTS}
    results = run_algorithm(LOCALIZE, {**layers, **parameters}, feedback)
    return results, [rows(path) for path in layers.values()]


@pytest.mark.parametrize("method", [0, 1])
def test_workers_localize_what_qgis_localizes(run_algorithm, database, folder, tmp_path, feedback, method):
    asked = {"DATABASE": database, "IMAGES": str(folder), "METHOD": method, "ATTITUDE": str(folder / "cameras.csv")}
    asked["MAXIMUM_SPEED"] = 30
    for name in ("qgis", "dask"):
        (tmp_path / name).mkdir()
    expected, layers = localized(run_algorithm, tmp_path / "qgis", **asked)
    scheduled = {**asked, "SCHEDULER": "local:1"}
    found, by_workers = localized(run_algorithm, tmp_path / "dask", feedback, **scheduled)
    assert found["FIX_COUNT"] == expected["FIX_COUNT"] >= 4
    for one, other in zip(by_workers, layers):
        require_same(one, other)
    assert len(layers[0]) == 7 and (len(layers[3]) > 20 or method == 1)
    assert feedback.progress() == 100


def test_workers_localize_photos_by_the_network_that_qgis_takes(run_algorithm, database, tmp_path):
    model = write_model(tmp_path / "colors.onnx", metadata=metadata(resolution_m=1.0))
    for n, (row, column) in enumerate([(40, 60), (180, 320)]):
        pixels = np.moveaxis(painted(LABELS[row : row + SIZE, column : column + SIZE]), 2, 0)
        # One photo with pixels in degrees, one without a pixel size.
        place = {"transform": (9.5, 1e-5, 0, 47.2, 0, -7e-6), "crs": 4326} if n else {"transform": None}
        write_raster(tmp_path / f"photo_{n}.tif", pixels, **place)
    cameras = tmp_path / "cameras.csv"
    cameras.write_text("image,field_of_view,height\nphoto_0.tif,60,138.56\n", encoding="utf-8")
    asked = {"DATABASE": database, "IMAGES": str(tmp_path), "MODEL": str(model), "METHOD": 2, "ATTITUDE": str(cameras)}
    for name in ("qgis", "dask"):
        (tmp_path / name).mkdir()
    expected, layers = localized(run_algorithm, tmp_path / "qgis", **asked)
    found, by_workers = localized(run_algorithm, tmp_path / "dask", **asked, SCHEDULER="local:1")
    assert found["FIX_COUNT"] == expected["FIX_COUNT"] == 2
    for one, other in zip(by_workers, layers):
        require_same(one, other)


@pytest.mark.parametrize(("key", "title"), [("LABELS", "Folder for label images"), ("LAYER", "Layer to test")])
def test_what_only_qgis_can_do_is_refused_before_any_work(run_algorithm, database, folder, tmp_path, key, title):
    given = str(tmp_path / "labels") if key == "LABELS" else str(folder / "image_0.png")
    asked = {"DATABASE": database, "IMAGES": str(folder), key: given, "SCHEDULER": "local:1"}
    with pytest.raises(QgsProcessingException, match=f"together with “{title}”"):
        run_algorithm(LOCALIZE, {**asked, "OUTPUT": str(tmp_path / "positions.gpkg")})
