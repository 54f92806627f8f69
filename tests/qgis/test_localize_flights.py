import numpy as np
import pytest
from made_inputs import NAMES, NORTH, WEST, read_rows, scattered_objects, write_raster, write_text
from qgis.core import QgsProcessingException

from semref.core.errors import ImageError
from semref.core.geometry.frame import MapFrame
from semref.core.simulation.views import View, cut, map_coordinates
from semref.storage.label_images import LabelImageReader

LOCALIZE = "semref:localizeimages"
LABELS = scattered_objects(900, 1000, 1300, seed=5)
SIZE = 300
TILT = 25.0
TABLE = f"image,roll,pitch,field_of_view\n0.png,0,{TILT},60\n"


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(LABELS, NAMES, SIZE, 150)


@pytest.fixture
def localize(run_algorithm, database, tmp_path, feedback):
    """`localize(views, table, **parameters)` returns (rows, footprints, results); the images are 0.png, 1.png, …"""

    def run(views, table="", algorithm=LOCALIZE, **parameters):
        (tmp_path / "flight").mkdir(exist_ok=True)
        for number, view in enumerate(views):
            image = cut(LABELS, MapFrame.at((WEST, NORTH), 1.0), view)
            write_raster(tmp_path / "flight" / f"{number}.png", image, transform=None)
        if table:
            parameters["ATTITUDE"] = str(write_text(tmp_path / "cameras.csv", table))
        outputs = {key: str(tmp_path / f"{key.lower()}.gpkg") for key in ("OUTPUT", "FOOTPRINTS")}
        parameters = {"DATABASE": database, "IMAGES": str(tmp_path / "flight"), "METHOD": 2, **outputs, **parameters}
        results = run_algorithm(algorithm, parameters, feedback)
        rows, footprints = (read_rows(results[key]) for key in ("OUTPUT", "FOOTPRINTS"))
        polygons = [row["geometry"].GetGeometryRef(0).GetPoints() for row in footprints]
        return rows, polygons, results

    return run


def ahead(column=450.0, row=520.0, heading=30.0, tilt=TILT) -> View:
    """Return a camera tilted towards the image's top."""
    return View(WEST + column, NORTH - row, heading, 1.0, SIZE, SIZE, tilt_deg=tilt)


def test_a_tilted_image_is_leveled_and_found(localize, feedback):
    view = ahead()
    (found,), (footprint,), _ = localize([view], TABLE)
    assert (found["status"], found["heading"]) == ("fix", pytest.approx(30, abs=0.5))
    assert (found["x"], found["y"]) == pytest.approx(view.position, abs=2)
    assert found["pixel_size"] == pytest.approx(1.0, rel=0.01)
    x, y = map_coordinates(view, np.array([0, SIZE, SIZE, 0]), np.array([0, 0, SIZE, SIZE]))
    np.testing.assert_allclose(footprint[:4], np.column_stack([x, y]), atol=4)
    assert "0.png: Leveled: roll 0.0°, pitch 25.0° (cameras.csv)." in feedback.textLog()


def test_what_is_not_leveled_has_no_camera_position(localize, feedback):
    (found,), _, _ = localize([ahead(tilt=0)])
    assert found["status"] == "fix"
    assert found["camera_x"] is None and found["camera_y"] is None and found["jump"] is None
    # The published method takes images as they are.
    (found,), _, _ = localize([ahead()], TABLE, METHOD=1)
    assert found["method"] == "topology vector" and found["camera_x"] is None
    assert "Leveled" not in feedback.textLog()


def test_a_view_of_the_horizon_is_an_error_of_its_row(localize):
    rows, _, results = localize([ahead(), ahead(tilt=0)], "image,roll,pitch,field_of_view\n0,0,60,60\n")
    assert [row["status"] for row in rows] == ["error", "fix"] and results["FIX_COUNT"] == 1
    assert "look down more steeply" in rows[0]["reason"]


def test_a_mistake_in_the_table_stops_before_anything_is_written(localize, tmp_path):
    with pytest.raises(QgsProcessingException, match="line 2: roll or pitch is empty"):
        localize([ahead()], "image,roll,pitch\n0.png,1,\n")
    assert not list(tmp_path.glob("*.gpkg"))


@pytest.mark.slow
@pytest.mark.parametrize("heading", [30, 30 - 360, 45, "20"])
def test_a_rough_heading_is_a_prior(localize, heading):
    (found,), _, _ = localize([ahead(tilt=0)], PRIOR_HEADING=heading, PRIOR_HEADING_RANGE=20)
    assert found["status"] == "fix"


SMALL = View(WEST + 490, NORTH - 400, 90, 1.0, 78, 78)
FLIGHT = [ahead(300 + 20 * step, 400, 90, 0) for step in range(4)]
TIMES = "image,time\n0,0\n1,1\n2,2\n3,3\n"


def test_a_fix_that_can_not_be_reached_is_marked_and_stays_a_fix(localize, feedback):
    flight = [*FLIGHT[:2], ahead(700, 500, 90, 0), FLIGHT[3]]
    rows, polygons, results = localize(flight, TIMES, MAXIMUM_SPEED=25)
    assert [bool(row["jump"]) for row in rows] == [False, False, True, False]
    assert [row["status"] for row in rows] == ["fix"] * 4 and results["FIX_COUNT"] == len(polygons) == 4
    assert "25 m/s" in rows[2]["reason"] and "25 map units" not in rows[1]["reason"]
    assert "1 of 4 positions with a time are jumps." in feedback.textLog()


@pytest.mark.parametrize("algorithm", [LOCALIZE, "semref:localizeflight"])
def test_an_image_of_few_landmarks_is_found_within_reach_of_another(localize, feedback, algorithm):
    asked = {"algorithm": algorithm, "SCALE_MINIMUM": 0.2, "SCALE_MAXIMUM": 1.1, "RISK": 0.006}
    alone, _, _ = localize([FLIGHT[0], SMALL], TIMES, **asked)
    rows, _, results = localize([FLIGHT[0], SMALL], TIMES, MAXIMUM_SPEED=97, **asked)
    assert alone[1]["status"] != "fix"
    assert [row["status"] for row in rows] == ["fix", "fix"] and results["FIX_COUNT"] == 2
    assert (rows[1]["x"], rows[1]["y"]) == pytest.approx(SMALL.position, abs=2)
    assert rows[1]["confidence"] < rows[0]["confidence"] and rows[1]["jump"] == 0
    assert "1.png: found within 19" in feedback.textLog() and "of 0.png" in feedback.textLog()


def test_an_image_that_is_gone_at_the_second_search_stays_without_a_position(localize, monkeypatch):
    read, paths = LabelImageReader.__call__, []

    def read_once(reader, path, *others):
        if path in paths:
            raise ImageError("{path} is gone.", path=path)
        paths.append(path)
        return read(reader, path, *others)

    monkeypatch.setattr(LabelImageReader, "__call__", read_once)
    asked = {"SCALE_MINIMUM": 0.2, "SCALE_MAXIMUM": 1.1, "RISK": 0.006}
    rows, _, _ = localize([FLIGHT[0], SMALL], TIMES, MAXIMUM_SPEED=97, **asked)
    assert [row["status"] for row in rows] == ["fix", "likely"]
