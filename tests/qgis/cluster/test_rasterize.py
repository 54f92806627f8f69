"""The label map that workers burn together is the algorithm's file, byte by byte."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from clustered import lose_a_worker, require_nothing_after
from made_inputs import METRIC_CRS, NORTH, WEST, read_pixels, write_layer, write_text
from osgeo import ogr

RASTERIZE = "semref:rasterizeannotation"
FIELDS = [("class", "text"), ("level", "real")]
CLASSES = "value,name,color,role,draw_order\n" + "".join(
    f"{n},{name},#{n:02x}40{255 - 9 * n:02x},reference,{n}\n"
    for n, name in enumerate(("building", "water", "bare_land", "field"), start=1)
)


def ring(points) -> str:
    """Of a polygon's WKT."""
    return "(" + ", ".join(f"{x!r} {y!r}" for x, y in [*points, points[0]]) + ")"


def around(rng, x, y, radius, count=9):
    """A star around a place, which crosses no edge of its own."""
    angles = np.sort(rng.uniform(0, 2 * np.pi, count))
    lengths = radius * rng.uniform(0.4, 1.0, count)
    return [(float(x + r * np.cos(a)), float(y + r * np.sin(a))) for a, r in zip(angles, lengths)]


@pytest.fixture(scope="module")
def annotation(tmp_path_factory):
    """Overlapping polygons with priorities, holes, several parts and none, wider than one strip is high."""
    rng = np.random.default_rng(5)
    features = []
    while len(features) < 700:
        x, y = WEST + rng.uniform(0, 4700), NORTH - rng.uniform(0, 8200)
        outline, hole = around(rng, x, y, rng.uniform(5, 260)), ring([(x - 1.3, y), (x + 1.1, y + 0.7), (x, y - 2.1)])
        shape = ogr.CreateGeometryFromWkt(f"POLYGON ({ring(outline)}, {hole})")
        if not shape.IsValid() or shape.GetArea() == 0:
            continue
        wkt = shape.ExportToWkt()
        if len(features) % 9 == 0:
            far = ring([(x + 900, y), (x + 950.5, y), (x + 950.5, y + 33)])
            wkt = f"MULTIPOLYGON (({ring(outline)}, {hole}), ({far}))"
        level = None if len(features) % 11 == 0 else float(rng.integers(0, 4))
        features.append((wkt, ("building", "water", "bare_land", "field")[rng.integers(0, 4)], level))
    features += [(None, "water", 1.0), (features[3][0], None, 1.0), (features[4][0], "", 9.0)]
    path = tmp_path_factory.mktemp("annotation") / "annotation.gpkg"
    return write_layer(path, features, FIELDS, geometry=ogr.wkbUnknown)


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    return str(write_text(tmp_path_factory.mktemp("table") / "classes.csv", CLASSES))


@pytest.fixture(scope="module")
def expected(run_algorithm, annotation, table, tmp_path_factory):
    """The file of the algorithm, in QGIS alone."""
    target = tmp_path_factory.mktemp("expected") / "labels.tif"
    asked = {"INPUT": str(annotation), "CLASS_FIELD": "class", "PRIORITY_FIELD": "level", "CLASS_TABLE": table}
    run_algorithm(RASTERIZE, {**asked, "OUTPUT": str(target)})
    assert read_pixels(target).size > 2 * 16_000_000
    assert set(np.unique(read_pixels(target))) == {0, 1, 2, 3, 4}
    return target.read_bytes()


@pytest.fixture
def asked(annotation, table):
    return [annotation, "--class-field", "class", "--priority-field", "level", "--class-table", table]


@pytest.mark.parametrize("workers", [pytest.param(1, marks=pytest.mark.slow), 2])
def test_it_is_the_algorithm_s_file_whatever_the_number_of_workers(cluster, asked, expected, tmp_path, workers):
    target = tmp_path / "labels.tif"
    result = cluster("rasterize", *asked, "--labels", target, "--local", workers)
    assert result.returncode == 0, result.stderr
    assert target.read_bytes() == expected
    assert "classes: 4" in result.stdout and "3 features without" in result.stderr


@pytest.mark.slow
def test_two_workers_of_which_one_is_killed_give_the_same_bytes(cluster, asked, expected, tmp_path):
    target = tmp_path / "labels.tif"
    running = cluster.start("rasterize", *asked, "--labels", target, "--local", 2)
    lose_a_worker(running, "Burning polygons")
    assert target.read_bytes() == expected


def test_with_scheduler_qgis_has_it_burnt_alike(run_algorithm, annotation, table, expected, tmp_path, feedback):
    pytest.importorskip("distributed", reason="Dask is not here (tools/requirements-dev.txt)")
    target = tmp_path / "labels.tif"
    asked = {"INPUT": str(annotation), "CLASS_FIELD": "class", "PRIORITY_FIELD": "level", "CLASS_TABLE": table}
    found = run_algorithm(RASTERIZE, {**asked, "SCHEDULER": "local:2", "OUTPUT": str(target)}, feedback)
    assert target.read_bytes() == expected
    assert found["CLASS_COUNT"] == 4 and 0 < found["LABELED_FRACTION"] < 1


@pytest.mark.parametrize(
    ("options", "parameters"),
    [
        (["--other-ground"], {"OTHER_GROUND": True}),
        (["--pixel-size", "2.5", "--extent", "{w},{s},{e},{n}"], {"PIXEL_SIZE": 2.5, "EXTENT": "{w},{e},{s},{n}"}),
    ],
)
def test_classes_of_the_field_alone_other_ground_and_a_part(
    cluster, run_algorithm, annotation, tmp_path, options, parameters
):
    place = {"w": WEST + 700.3, "e": WEST + 2300, "s": NORTH - 3000.7, "n": NORTH - 1000}
    given = {key: value.format(**place) if key == "EXTENT" else value for key, value in parameters.items()}
    if "EXTENT" in given:
        given["EXTENT"] += f" [EPSG:{METRIC_CRS}]"
    wanted = {"INPUT": str(annotation), "CLASS_FIELD": "class", "PIXEL_SIZE": 4.0, **given}
    run_algorithm(RASTERIZE, {**wanted, "OUTPUT": str(tmp_path / "qgis.tif")})
    size = [] if "--pixel-size" in options else ["--pixel-size", "4"]
    said = [option.format(**place) for option in options]
    target = tmp_path / "cluster.tif"
    result = cluster("rasterize", annotation, "--class-field", "class", *size, *said, "--labels", target, "--local", 1)
    assert result.returncode == 0, result.stderr
    assert target.read_bytes() == (tmp_path / "qgis.tif").read_bytes()


def test_a_shapefile_with_numbers_as_classes(cluster, run_algorithm, tmp_path):
    squares = [
        f"POLYGON ({ring([(WEST + x, NORTH), (WEST + x + 9, NORTH), (WEST + x + 9, NORTH - 9)])})" for x in (0, 20)
    ]
    path = write_layer(tmp_path / "a.shp", [(squares[0], 7), (squares[1], 3)], [("class", "integer")])
    run_algorithm(RASTERIZE, {"INPUT": str(path), "CLASS_FIELD": "class", "OUTPUT": str(tmp_path / "qgis.tif")})
    result = cluster("rasterize", path, "--class-field", "class", "--labels", tmp_path / "cluster.tif", "--local", 1)
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "cluster.tif").read_bytes() == (tmp_path / "qgis.tif").read_bytes()
    assert set(np.unique(read_pixels(tmp_path / "cluster.tif"))) == {0, 3, 7}


@pytest.mark.slow
@pytest.mark.real_data
def test_liechtenstein(cluster, run_algorithm, real_data, tmp_path):
    path = real_data("osm_liechtenstein_2021/li_landcover_2021.shp")
    given = {"INPUT": str(path), "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder", "PIXEL_SIZE": 2}
    options = ["--class-field", "class", "--priority-field", "zorder", "--pixel-size", 2]
    run_algorithm(RASTERIZE, {**given, "OUTPUT": str(tmp_path / "qgis.tif")})
    result = cluster("rasterize", path, *options, "--labels", tmp_path / "cluster.tif", "--local", 2)
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "cluster.tif").read_bytes() == (tmp_path / "qgis.tif").read_bytes()


BOW = f"POLYGON ({ring([(WEST, NORTH), (WEST + 9, NORTH - 9), (WEST + 9, NORTH), (WEST, NORTH - 9)])})"
SQUARE = f"POLYGON ({ring([(WEST, NORTH), (WEST + 9, NORTH), (WEST + 9, NORTH - 9)])})"


@pytest.mark.parametrize(
    ("features", "crs", "options", "part"),
    [
        ([(BOW, "water", 1.0)], METRIC_CRS, [], "invalid, such as that of feature 1"),
        ([("POINT (1 2)", "water", 1.0)], METRIC_CRS, [], "geometry of the kind POINT"),
        ([("CURVEPOLYGON ((0 0, 9 0, 9 9, 0 0))", "water", 1.0)], METRIC_CRS, [], "geometry of the kind CURVEPOLYGON"),
        ([("POLYGON ((9 47, 9.1 47, 9.1 47.1, 9 47))", "water", 1.0)], 4326, [], "does not measure in meters"),
        ([(SQUARE, "water", 1.0)], METRIC_CRS, ["--class-field", "kind"], "no field “kind”"),
        ([(SQUARE, "water", 1.0)], METRIC_CRS, ["--priority-field", "class"], "a priority a number"),
        ([(SQUARE, "water", 1.0)], METRIC_CRS, ["--layer", "others"], "has the layers a; name one"),
        ([(SQUARE, None, 1.0)], METRIC_CRS, [], "no feature with a class"),
        ([(None, "water", 1.0)], METRIC_CRS, [], "nothing to rasterize"),
        ([(SQUARE, "water", 1.0)], METRIC_CRS, ["--extent", "1,2,3"], "--extent is “1,2,3”"),
        ([(SQUARE, "water", 1.0)], METRIC_CRS, ["--extent", "3,0,1,2"], "--extent is “3,0,1,2”"),
    ],
)
def test_what_qgis_alone_can_do_or_nobody_is_said_in_one_sentence(cluster, tmp_path, features, crs, options, part):
    path = write_layer(tmp_path / "a.gpkg", features, FIELDS, crs=crs)
    result = cluster(
        "rasterize", path, "--class-field", "class", *options, "--labels", tmp_path / "never.tif", "--local", 1
    )
    require_refused(result, part)
    assert not (tmp_path / "never.tif").exists()


def test_a_class_that_the_table_lacks_is_named(cluster, tmp_path, table):
    path = write_layer(tmp_path / "a.gpkg", [(SQUARE, "lava", 1.0)], FIELDS)
    options = ["--class-field", "class", "--class-table", table, "--labels", tmp_path / "never.tif"]
    require_refused(cluster("rasterize", path, *options, "--local", 1), "“lava” (1)")


def test_a_file_with_a_style_needs_a_class_table(cluster, tmp_path, table):
    path = write_layer(tmp_path / "a.gpkg", [(SQUARE, "water", 1.0)], FIELDS)
    write_text(Path(tmp_path) / "a.qml", "<qgis/>")
    options = ["--class-field", "class", "--labels", tmp_path / "labels.tif", "--local", 1]
    require_refused(cluster("rasterize", path, *options), "a style that may tell classes")
    assert cluster("rasterize", path, *options, "--class-table", table).returncode == 0


def test_a_file_that_is_missing_or_none_is_said_in_one_sentence(cluster, tmp_path):
    foreign = write_text(tmp_path / "foreign.gpkg", "no polygons at all")
    for path in (tmp_path / "gone.gpkg", foreign):
        options = ["--class-field", "class", "--labels", tmp_path / "never.tif", "--local", 1]
        require_refused(cluster("rasterize", path, *options), path.name)


def test_an_interrupt_leaves_nothing(cluster, asked, tmp_path):
    running = cluster.start(
        "rasterize", *asked, "--pixel-size", "0.3", "--labels", tmp_path / "never.tif", "--local", 1
    )
    require_nothing_after("SIGINT", running, "Burning polygons", tmp_path)


def test_a_cancel_in_qgis_leaves_nothing(run_algorithm, annotation, tmp_path, feedback):
    pytest.importorskip("distributed", reason="Dask is not here (tools/requirements-dev.txt)")
    from qgis.core import QgsProcessingException

    feedback.progressChanged.connect(lambda share: feedback.cancel() if share > 40 else None)
    asked = {"INPUT": str(annotation), "CLASS_FIELD": "class", "PIXEL_SIZE": 0.5, "SCHEDULER": "local:1"}
    with pytest.raises(QgsProcessingException, match="Canceled"):
        run_algorithm(RASTERIZE, {**asked, "OUTPUT": str(tmp_path / "never.tif")}, feedback)
    assert list(tmp_path.iterdir()) == []


def require_refused(result, part):
    last = result.stderr.strip().splitlines()[-1]
    assert result.returncode in (2, 3) and part in last and last.endswith("."), result.stderr
    assert "Traceback" not in result.stderr and result.stdout == ""


def test_a_file_that_can_t_be_read_is_told_alike_where_gdal_raises(tmp_path):
    from osgeo import gdal

    from semref.core.errors import AnnotationError
    from semref.storage.annotation_file import read_annotation

    raised = gdal.GetUseExceptions()
    gdal.UseExceptions()
    try:
        with pytest.raises(AnnotationError, match="can't be read as polygons"):
            read_annotation(str(tmp_path / "gone.gpkg"), "class")
    finally:
        if not raised:
            gdal.DontUseExceptions()
