import base64
import json
import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from made_inputs import NAMES, NORTH, WEST, landmarks_in_the_west, read_rows, square, write_layer
from qgis.core import (
    QgsApplication,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsPointXY,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeatureSourceDefinition,
    QgsVectorLayer,
)
from qgis.PyQt.QtGui import QImage

from semref.core.assessment.route import RouteGap, route_points
from semref.core.errors import ParameterError
from semref.processing.layers.routes import lines_in, read_route
from semref.processing.reports.maps import WIDTH, route_ground, route_map
from semref.processing.reports.route_report import _reason
from semref.storage.route_files import is_waypoint_file

ASSESS = "semref:assessroute"
LABELS = landmarks_in_the_west()
TURNS = ((150.0, 250.0), (700.0, 250.0))
"""Column and row of the route below: from the landmarks into the empty east."""


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(LABELS, NAMES, 250, 125)


def lon_lat(turns):
    metric, degrees = (QgsCoordinateReferenceSystem(f"EPSG:{code}") for code in (32632, 4326))
    transform = QgsCoordinateTransform(metric, degrees, QgsCoordinateTransformContext())
    points = [transform.transform(QgsPointXY(WEST + x, NORTH - y)) for x, y in turns]
    return [(point.x(), point.y()) for point in points]


def line(turns) -> str:
    return "LINESTRING (" + ", ".join(f"{WEST + x} {NORTH - y}" for x, y in turns) + ")"


def gpx(turns, kind="rte", point="rtept"):
    points = "".join(f'<{point} lat="{y!r}" lon="{x!r}"></{point}>' for x, y in lon_lat(turns))
    body = {"trk": f"<trk><trkseg>{points}</trkseg></trk>", "rte": f"<rte>{points}</rte>"}.get(kind, points)
    return f'<?xml version="1.0"?><gpx version="1.1" xmlns="http://www.topografix.com/GPX/1/1">{body}</gpx>'


def kml(turns):
    places = " ".join(f"{x!r},{y!r},0" for x, y in lon_lat(turns))
    return (
        '<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Document><Placemark><LineString>'
        f"<coordinates>{places}</coordinates></LineString></Placemark></Document></kml>"
    )


def plan(items) -> str:
    return json.dumps({"fileType": "Plan", "version": 1, "mission": {"version": 2, "items": items}})


def simple(x, y, command=16):
    return {"type": "SimpleItem", "command": command, "frame": 3, "params": [0, 0, 0, None, y, x, 50]}


def simple_plan(turns):
    (x, y), *others = lon_lat(turns)
    take_off = {"type": "SimpleItem", "command": 22, "params": [0, 0, 0, None, 0, 0, 50]}
    back = {"type": "SimpleItem", "command": 20, "params": [0, 0, 0, 0, 0, 0, 0]}
    return plan([take_off, simple(x, y), *(simple(*place, 82) for place in others), back])


def survey_plan(turns):
    transects = {"VisualTransectPoints": [[y, x] for x, y in lon_lat(turns)]}
    item = {"type": "ComplexItem", "complexItemType": "survey", "TransectStyleComplexItem": transects}
    return plan([item])


def waypoints(turns):
    rows = ["QGC WPL 110", "0\t1\t0\t16\t0\t0\t0\t0\t1.0\t2.0\t0\t1"]
    rows += [f"{n}\t0\t3\t16\t0\t0\t0\t0\t{y!r}\t{x!r}\t50\t1" for n, (x, y) in enumerate(lon_lat(turns), 1)]
    return "\n".join(rows)


FILES = {"route.gpx": gpx, "route.kml": kml, "mission.plan": simple_plan, "survey.plan": survey_plan}
FILES |= {"list.waypoints": waypoints, "track.gpx": lambda turns: gpx(turns, "trk", "trkpt")}
FILES |= {"points.gpx": lambda turns: gpx(turns, "", "wpt")}


@pytest.mark.parametrize("name", list(FILES))
def test_waypoint_files_have_the_same_route(qgis_app, tmp_path, name):
    path = tmp_path / name
    path.write_text(FILES[name](TURNS), encoding="utf-8")
    assert is_waypoint_file(str(path))
    found = lines_in(read_route(str(path)), QgsCoordinateReferenceSystem("EPSG:32632"), QgsCoordinateTransformContext())
    assert len(found) == 1
    assert np.abs(found[0] - [(WEST + x, NORTH - y) for x, y in TURNS]).max() < 0.01


GPX = '<gpx version="1.1" xmlns="http://www.topografix.com/GPX/1/1">{}</gpx>'
DEEP = '{"mission": {"items": ' + "[" * 5000 + "]" * 5000 + "}}"
NOWHERE = (9, 470), ("x", "y"), (9, 10**60), (float("nan"), 47), (9, float("inf"))
GPX_ROUTE = '<rte><rtept lat="47.1" lon="9.5"/><rtept lat="{}" lon="{}"/></rte>'
GPX_NOWHERE = ("1e308", "9"), ("NaN", "9"), ("91", "9"), ("47", "inf")
BAD_ROUTES = [
    *(("a.plan", text, "is not JSON") for text in ("no json", "[" * 100_000, DEEP)),
    *(("a.plan", text, "has no mission") for text in ("[]", '{"mission": {"items": 3}}')),
    ("a.plan", plan([]), "has no route"),
    ("a.plan", plan([simple(9, 47)]), "fewer than two waypoints"),
    ("a.plan", plan([{"type": "ComplexItem", "TransectStyleComplexItem": {"VisualTransectPoints": 4}}]), "route"),
    *(("a.plan", plan([simple(*place), simple(9, 47)]), "is not a valid latitude") for place in NOWHERE),
    ("a.plan", plan([simple(9, 470)]).replace("470", "1" + "0" * 400), "a.plan"),
    ("a.waypoints", "1 2 3", "is not a waypoint list"),
    ("a.waypoints", "QGC WPL 110\nhome\n1 0 3 x 0 0 0 0 9 47 50 1", "is not a waypoint"),
    ("a.gpx", "<gpx", "can't be read as a route"),
    ("a.gpx", GPX.format(""), "no route"),
    *(("a.gpx", GPX.format(GPX_ROUTE.format(*place)), "not a valid latitude") for place in GPX_NOWHERE),
    ("a.kml", "", "can't be read as a route"),
    ("binary.plan", "\udcff\udcfe\0\udc80" * 50, "is not a text file"),
    ("none.plan", None, "There is no file"),
]


@pytest.mark.parametrize(("name", "text", "said"), BAD_ROUTES, ids=range(len(BAD_ROUTES)))
def test_a_bad_route_file_gets_one_sentence(qgis_app, tmp_path, name, text, said):
    path = tmp_path / name
    if text is not None:
        path.write_text(text, encoding="utf-8", errors="surrogateescape")
    with pytest.raises(ParameterError, match=said) as refused:
        read_route(str(path))
    sentence = str(refused.value)
    assert str(path) in sentence and "\n" not in sentence.strip() and len(sentence) < 600


@pytest.fixture(scope="module")
def assess(run_algorithm, database, tmp_path_factory):
    """`assess(route, feedback=None, **parameters)` returns (results, rows), with few trials and no map correlation."""

    def run(route, feedback=None, **parameters):
        folder = tmp_path_factory.mktemp("assessed")
        asked = {"DATABASE": database, "ROUTE": str(route), "TRIALS": 4, "MAP_CORRELATION": False}
        outputs = {"OUTPUT": str(folder / "points.gpkg"), "REPORT": str(folder / "report.html")}
        results = run_algorithm(ASSESS, {**asked, **outputs, **parameters}, feedback)
        return results, read_rows(results["OUTPUT"])

    return run


@pytest.fixture(scope="module")
def assessed(assess, database, tmp_path_factory):
    """Return results and rows of a route read from a file."""
    folder = tmp_path_factory.mktemp("route")
    (folder / "mission.plan").write_text(simple_plan(TURNS), encoding="utf-8")
    squares = write_layer(folder / "squares.gpkg", [(square(300, 200, 200), 0.5)], [("success", "real")])
    layers = {"ASSESSMENT": str(squares), "BASE_MAP": str(Path(database).with_name("labels.tif"))}
    return assess(folder / "mission.plan", **layers, SPACING=50, SPEED=10)


@pytest.mark.slow
def test_points_along_the_route_have_expectations_and_the_longest_gap_ends_it(assessed):
    results, rows = assessed
    assert [row["along"] for row in rows] == pytest.approx(np.arange(0, 551, 50).tolist(), abs=0.1)
    assert all(row["heading"] == pytest.approx(90, abs=0.1) for row in rows)
    assert all(row["success"] > 0.85 for row in rows[:3])
    assert all(row["success"] < 0.2 and row["reason"].startswith("Too few") for row in rows[-2:])
    assert 100 < results["LONGEST_GAP"] < 400 and rows[0]["gap"] == 0
    assert rows[-1]["gap"] == pytest.approx(results["LONGEST_GAP"])
    assert rows[-1]["gap_seconds"] == results["LONGEST_GAP_SECONDS"] == pytest.approx(results["LONGEST_GAP"] / 10)


@pytest.mark.slow
def test_the_report_has_profile_gaps_and_a_map_of_the_route_on_the_layers_that_were_given(assessed):
    text = Path(assessed[0]["REPORT"]).read_text(encoding="utf-8")
    parts = "<svg", "Stretches without an expected position", "Any heading", "s at 10 m/s", "mission.plan, area.gpkg"
    assert [part for part in (*parts, "12 points", "hardly ever (0–") if part not in text] == []
    picture = QImage.fromData(base64.b64decode(re.search(r'href="data:image/jpeg;base64,([^"]+)"', text)[1]))
    height = float(re.search(r'viewBox="0 0 960 (\d+)" role="img" aria-label="Map of the route"', text)[1])
    assert (picture.width(), picture.height()) == (1920, 2 * height)
    # The square is across the middle of the route, on the map.
    middle, beside = (picture.pixelColor(x, picture.height() // 2 + 30) for x in (820, 1300))
    assert middle != beside and (middle.red(), middle.green()) != (255, 255)


def route_of(*lines):
    return route_points([np.array(one, float) for one in lines], 10.0)


def test_a_route_map_has_a_piece_for_each_run_of_a_class_and_numbers_several_lines(qgis_app):
    classes = [(0.0, 0.5, "#000001", "bad"), (0.5, 1.0, "#000002", "good")]
    one = route_of([(0, 0), (50, 0)])
    svg = route_map(one, np.array([1, 1, 0, 0, 1, 1]), classes, b"", "map")
    assert (svg.count("#000001"), svg.count("#000002"), svg.count("<image")) == (1, 2, 0)
    # The first piece ends halfway from the second to the third point, where the next one begins.
    drawn = [re.search(r'd="M([^"]+)"', path)[1].split("L") for path in re.findall("<path[^>]+#00000[^>]+", svg)]
    assert drawn[0][-1] == drawn[1][0] and drawn[1][-1] == drawn[2][0]
    two = route_of([(0, 0), (50, 0)], [(0, 40), (50, 40)])
    assert route_map(two, np.ones(12), classes, b"", "map").count("</text>") == 2 + svg.count("</text>")


def test_the_reason_of_a_stretch_that_is_mostly_outside_the_map_says_so(qgis_app):
    route = SimpleNamespace(inside=np.array([0, 0, 1]), estimates=SimpleNamespace(reasons=["too_few_references"] * 3))
    found = [_reason(route, RouteGap(0, 0.0, 30.0, np.array(points))) for points in ([0, 1, 2], [1, 2, 2])]
    assert found == ["outside the map", "too few landmarks"]


def test_a_sketch_shows_the_extent_that_is_drawn_below_it(qgis_app):
    ground = route_ground(route_of([(1000, 200), (1600, 260)]))
    x_min, y_min, x_max, y_max = ground.extent
    assert ground.at((x_min, y_max)) == pytest.approx((0, 0), abs=1e-6)
    assert ground.at((x_max, y_min)) == pytest.approx((WIDTH, ground.height))
    assert ground.at((1300, 230)) == pytest.approx((WIDTH / 2, ground.height / 2))


@pytest.mark.slow
def test_a_stretch_beside_landmarks_is_hinted_there(assess, tmp_path, feedback):
    # Northwards along the empty east: the landmarks are to the left.
    layer = write_layer(tmp_path / "route.gpkg", [(line([(640, 400), (640, 100)]), "a")])
    results, rows = assess(layer, feedback, SPACING=100, SHIFT=300)
    assert results["LONGEST_GAP"] == pytest.approx(300) and "LONGEST_GAP_SECONDS" not in results
    assert all(row["shift"] in (-300, -150) and row["shift_success"] > 0.6 for row in rows)


def test_a_waypoint_file_passes_the_check_of_parameters_and_other_text_does_not(run_algorithm, database, tmp_path):
    path = tmp_path / "mission.plan"
    path.write_text(simple_plan(TURNS), encoding="utf-8")
    algorithm = QgsApplication.processingRegistry().createAlgorithmById(ASSESS)
    context = QgsProcessingContext()
    given = {"DATABASE": database, "OUTPUT": "memory:"}
    assert algorithm.checkParameterValues({**given, "ROUTE": str(path)}, context)[0]
    wrapped = QgsProcessingFeatureSourceDefinition(str(path), False)
    assert algorithm.checkParameterValues({**given, "ROUTE": wrapped}, context)[0]
    assert not algorithm.checkParameterValues({**given, "ROUTE": "no layer"}, context)[0]
    places = write_layer(tmp_path / "places.gpkg", [("POINT (1 2)", "a")])
    with pytest.raises(QgsProcessingException, match="The route places is not a line layer"):
        run_algorithm(ASSESS, {**given, "ROUTE": str(places)})
    with pytest.raises(QgsProcessingException, match="“flight” has no line. Draw a route, or change the selection"):
        run_algorithm(ASSESS, {**given, "ROUTE": QgsVectorLayer("LineString?crs=EPSG:32632", "flight", "memory")})


@pytest.mark.slow
def test_simulated_flights_give_position_share_and_radius(assess, tmp_path):
    layer = write_layer(tmp_path / "route.gpkg", [(line([(110, 300), (480, 300)]), "a")])
    results, rows = assess(layer, FOOTPRINT=220, SPACING=90, TRIALS=2, SHIFT=0, FLIGHTS=2)
    assert list(rows[0])[-4:-1] == ["flight_placed", "flight_radius", "flight_lost"]
    assert 0 <= results["FIRST_POSITION"] <= 300 and rows[-1]["flight_placed"] == 1
    assert 0 < rows[-1]["flight_radius"] <= results["LARGEST_RADIUS"] and not any(row["flight_lost"] for row in rows)
    text = Path(results["REPORT"]).read_text(encoding="utf-8")
    assert "In flight" in text and "First position after" in text
