"""semref:checkannotation: what is wrong with a layer is told as features, and agrees with what rasterizing does."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from made_inputs import CLASSES_CSV, NORTH, WEST, polygon, rectangle, square, write_layer, write_text
from osgeo import gdal, ogr
from qgis.core import QgsProcessingException, QgsProcessingFeatureSourceDefinition, QgsVectorLayer

CHECK, RASTERIZE = "semref:checkannotation", "semref:rasterizeannotation"


@pytest.fixture
def check(run_algorithm, feedback, tmp_path):
    """`check(layer, **parameters)` gives the results; the issues lie in tmp_path/issues.gpkg."""

    def run(layer, **parameters):
        source = str(layer) if isinstance(layer, Path) else layer
        defaults = {"CLASS_FIELD": "class", "MINIMUM_AREA": 0, "ISSUES": str(tmp_path / "issues.gpkg")}
        return run_algorithm(CHECK, {"INPUT": source, **defaults, **parameters}, feedback)

    return run


@pytest.fixture
def issues(check, tmp_path):
    """`issues(layer, **parameters)` gives a dict of the columns, with its `box`, for each finding."""

    def run(layer, **parameters):
        results = check(layer, **parameters)
        rows = read_rows(results["ISSUES"])
        assert results["ISSUE_COUNT"] == len(rows)
        assert results["ERROR_COUNT"] == sum(row["severity"] == "error" for row in rows)
        return rows

    return run


@pytest.fixture
def classes_csv(tmp_path):
    return str(write_text(tmp_path / "classes.csv", CLASSES_CSV))


def read_rows(path) -> list:
    source = ogr.Open(str(path))
    rows = []
    for feature in source.GetLayer(0):
        geometry = feature.GetGeometryRef()
        rows.append({**feature.items(), "box": geometry and geometry.GetEnvelope()})
    return rows


def kinds(rows) -> list:
    return sorted((row["kind"], row["severity"]) for row in rows)


# --- what is found ---


def test_a_clean_layer_has_no_findings(issues, tmp_path, classes_csv):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 9), "field"), (square(9, 0, 9), "building")])
    assert issues(layer, CLASS_TABLE=classes_csv, PIXEL_SIZE=1) == []


def test_an_overlap_has_both_ids_its_area_and_its_place(issues, tmp_path, classes_csv):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 10), "field"), (square(6, 0, 10), "water")])
    (row,) = issues(layer, CLASS_TABLE=classes_csv)
    assert (row["kind"], row["severity"], row["feature_id"], row["other_id"]) == ("overlap", "error", 2, 1)
    assert row["area"] == pytest.approx(40)
    np.testing.assert_allclose(row["box"], (WEST + 6, WEST + 10, NORTH - 10, NORTH), atol=1e-5)
    assert row["message"].startswith("water (feature 2) and field (feature 1) claim the same 40.00 m²")


def test_issues_are_drawn_by_severity_errors_on_top(check, tmp_path, classes_csv):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 10), "field"), (square(6, 0, 10), "water")])
    found = QgsVectorLayer(check(layer, CLASS_TABLE=classes_csv)["ISSUES"], "issues", "ogr")
    renderer = found.renderer()
    assert [category.value() for category in renderer.categories()] == ["error", "warning", "information"]
    assert renderer.orderByEnabled() and not list(tmp_path.glob("*-wal"))
    (feature,) = found.getFeatures()
    assert feature["severity"] == "error" and renderer.categoryIndexForValue(feature["severity"]) == 0


DRAW_ORDERS = "value,name,color,role,draw_order\n1,building,#ff0000,,{}\n2,water,#0000ff,,{}\n"


@pytest.mark.parametrize(
    ("priorities", "orders", "severity", "upper"),
    [
        ((None, None), None, "error", 2),
        ((2, 1), None, "information", 1),
        ((1, 1), None, "error", 2),
        ((1, None), None, "information", 1),
        (None, (5, 1), "information", 1),
        (None, (1, 5), "information", 2),
        (None, (5, 5), "error", 2),
        ((1, 2), (5, 1), "information", 2),
    ],
)
def test_an_order_decides_an_overlap_as_in_rasterizing(
    issues, run_algorithm, tmp_path, priorities, orders, severity, upper
):
    values = priorities or (None, None)
    features = [(square(0, 0, 10), "building", values[0]), (square(6, 0, 10), "water", values[1])]
    layer = write_layer(tmp_path / "a.gpkg", features, [("class", "text"), ("zorder", "integer")])
    table = write_text(tmp_path / "t.csv", DRAW_ORDERS.format(*(orders or ("", ""))))
    common = {"CLASS_TABLE": str(table), "PRIORITY_FIELD": "zorder" if priorities else None}
    (row,) = issues(layer, **common)
    assert (row["kind"], row["severity"], row["feature_id"]) == ("overlap", severity, upper)
    labels = {"INPUT": str(layer), "CLASS_FIELD": "class", "PIXEL_SIZE": 1, "OUTPUT": str(tmp_path / "l.tif")}
    made = run_algorithm(RASTERIZE, {**labels, **common})
    assert gdal.Open(made["OUTPUT"]).ReadAsArray()[5, 8] == upper


def test_classes_that_are_missing_or_unknown_are_errors(issues, tmp_path, classes_csv):
    features = [(square(0, 0, 9), "field"), (square(20, 0, 9), None), (square(40, 0, 9), "lighthouse")]
    rows = issues(write_layer(tmp_path / "a.gpkg", features), CLASS_TABLE=classes_csv)
    assert [(row["kind"], row["severity"], row["feature_id"]) for row in rows] == [
        ("no_class", "error", 2),
        ("unknown_class", "error", 3),
    ]
    assert "“lighthouse”" in rows[1]["message"]
    assert rows[1]["area"] == pytest.approx(81)


def test_geometry_that_is_missing_flat_three_dimensional_or_invalid_is_told(issues, tmp_path):
    features = [
        (None, "1"),
        ("POLYGON EMPTY", "1"),
        (polygon([(0, 0), (5, 5), (0, 0)]), "1"),
        (f"POLYGON Z (({WEST} {NORTH} 3, {WEST + 9} {NORTH} 3, {WEST + 9} {NORTH - 9} 3, {WEST} {NORTH} 3))", "1"),
        (polygon([(40, 0), (44, 4), (44, 0), (40, 4)]), "1"),
    ]
    rows = issues(write_layer(tmp_path / "a.gpkg", features))
    by_feature = Counter((row["feature_id"], row["kind"]) for row in rows)
    assert {(1, "no_geometry"), (2, "no_geometry"), (3, "no_area"), (4, "three_dimensional")} <= set(by_feature)
    assert (5, "invalid") in by_feature
    (invalid,) = (row for row in rows if row["feature_id"] == 5)
    assert "Self-intersection" in invalid["message"]


def test_polygons_outside_the_area_of_the_crs_are_told(issues, tmp_path):
    far = "POLYGON ((9.5 47.1, 9.6 47.1, 9.6 47.2, 9.5 47.1))"
    rows = issues(write_layer(tmp_path / "a.gpkg", [(square(0, 0, 9), "field"), (far, "field")]))
    assert [(row["kind"], row["feature_id"]) for row in rows if row["kind"] == "outside_crs"] == [("outside_crs", 2)]


def test_landmarks_that_pixels_lose_merge_and_split_are_told_with_a_pixel_size(issues, tmp_path, classes_csv):
    features = [
        (rectangle(0, 0, 1.2, 40), "building"),
        (square(20, 0, 10), "water"),
        (square(30.3, 0, 10), "water"),
        (
            polygon(
                [
                    (60, 0),
                    (70, 0),
                    (70, 10),
                    (80, 10),
                    (80, 0),
                    (90, 0),
                    (90, 20),
                    (80, 20),
                    (80, 10.2),
                    (70, 10.2),
                    (70, 20),
                    (60, 20),
                ]
            ),
            "bare_land",
        ),
    ]
    layer = write_layer(tmp_path / "a.gpkg", features)
    assert issues(layer, CLASS_TABLE=classes_csv, MINIMUM_AREA=20) == []
    rows = issues(layer, CLASS_TABLE=classes_csv, MINIMUM_AREA=20, PIXEL_SIZE=1)
    assert [(row["kind"], row["feature_id"], row["other_id"]) for row in rows] == [
        ("lost", 1, None),
        ("merged", 2, 3),
        ("split", 4, None),
    ]


def test_only_landmarks_of_reference_classes_are_too_small(issues, tmp_path, classes_csv):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 5), "field"), (square(20, 0, 5), "water")])
    rows = issues(layer, CLASS_TABLE=classes_csv, MINIMUM_AREA=100)
    assert [(row["kind"], row["feature_id"]) for row in rows] == [("small", 2)]
    assert len(issues(layer, MINIMUM_AREA=100)) == 2


def test_selected_features_alone_are_checked(issues, tmp_path):
    path = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 9), "a"), (square(5, 0, 9), "b"), (square(40, 0, 9), "c")])
    layer = QgsVectorLayer(str(path))
    layer.selectByIds([1, 3])
    from qgis.core import QgsProject

    QgsProject.instance().addMapLayer(layer)
    assert issues(QgsProcessingFeatureSourceDefinition(layer.id(), selectedFeaturesOnly=True)) == []
    QgsProject.instance().clear()


def test_a_layer_in_degrees_is_checked_in_meters(issues, tmp_path, feedback):
    shapes = [f"POLYGON (({x} 47, {x + 0.002} 47, {x + 0.002} 47.001, {x} 47.001, {x} 47))" for x in (9, 9.001)]
    layer = write_layer(tmp_path / "a.gpkg", [(shapes[0], "a"), (shapes[1], "b")], crs=4326)
    rows = issues(layer)
    assert [row["kind"] for row in rows] == ["overlap"]
    assert rows[0]["area"] == pytest.approx(76.06 * 111.18, rel=0.01)
    assert "EPSG:32632" in feedback.textLog()


def test_a_layer_without_class_is_refused(check, tmp_path):
    with pytest.raises(QgsProcessingException, match="no feature with a class"):
        check(write_layer(tmp_path / "a.gpkg", [(square(0, 0, 9), None)]))


def test_the_report_counts_by_kind_and_class_and_tells_the_largest(check, tmp_path, classes_csv):
    features = [(square(0, 0, 10), "field"), (square(6, 0, 10), "water"), (square(40, 0, 5), None)]
    layer = write_layer(tmp_path / "a.gpkg", features)
    results = check(layer, CLASS_TABLE=classes_csv, REPORT=str(tmp_path / "report.html"))
    text = Path(results["REPORT"]).read_text(encoding="utf-8")
    assert "a: 3 features" in text and "claim the same 40.00 m²" in text
    bad = '</td><td class="number bad">1</td>'
    for cells in (f"<td>overlap{bad}", f"<td>no class{bad}"):
        assert cells in text
    assert not re.search(r"(?i)<script|http(?!://www\.w3\.org/2000/svg)", text)


def test_the_report_of_a_clean_layer_says_so(check, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 10), "field")])
    results = check(layer, REPORT=str(tmp_path / "report.html"))
    assert "Nothing was found." in Path(results["REPORT"]).read_text(encoding="utf-8")


# --- agreement with the label map ---


def test_drawn_landmarks_are_the_objects_of_the_label_map(run_algorithm, tmp_path):
    """Regions as the check draws them and burns them, against what Rasterize annotation makes of the same layer."""
    from semref.core.annotation.check import AnnotationCheck, CheckSettings
    from semref.core.annotation.polygons import AnnotatedFeature
    from semref.storage.pixel_grid import pixel_grid
    from semref.storage.region_burning import RegionBurning

    random = np.random.default_rng(8)
    features = []
    for _ in range(150):
        corners = random.uniform(0, 200, 2) + random.uniform(0, 40, (int(random.integers(3, 6)), 2))
        features.append((polygon(corners.tolist()), int(random.integers(1, 5)), int(random.integers(0, 3))))
    layer = write_layer(tmp_path / "a.gpkg", features, [("class", "integer"), ("zorder", "integer")])
    parameters = {"INPUT": str(layer), "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder", "PIXEL_SIZE": 0.7}
    made = gdal.Open(run_algorithm(RASTERIZE, {**parameters, "OUTPUT": str(tmp_path / "l.tif")})["OUTPUT"])
    labels, transform = made.ReadAsArray(), made.GetGeoTransform()
    annotated = [
        AnnotatedFeature(n, bytes(ogr.CreateGeometryFromWkt(wkt).ExportToWkb()), value, priority)
        for n, (wkt, value, priority) in enumerate(features)
    ]
    check = AnnotationCheck(annotated, CheckSettings(0.0, 1.0, (1, 2, 3, 4)))
    list(check.steps())
    right, bottom = transform[0] + labels.shape[1] * 0.7, transform[3] - labels.shape[0] * 0.7
    frame = pixel_grid((transform[0], bottom, right, transform[3]), 0.7, made.GetProjection())
    burning = RegionBurning(check.landmarks, frame)
    list(burning.steps())
    runs, classes = burning.runs, [landmark.class_value for landmark in check.landmarks]
    drawn = np.zeros_like(labels)
    for row, start, stop, region in zip(runs.rows, runs.starts, runs.stops, runs.regions):
        drawn[row, start:stop] = classes[region - 1]
    np.testing.assert_array_equal(drawn, labels)


# --- real data ---


@pytest.mark.slow
@pytest.mark.real_data
@pytest.mark.parametrize(
    ("name", "field"),
    [
        ("berlin_urban_gradient/LandCov_BerlinUrbanGradient.shp", "Level_2"),
        ("osm_belgrade/landuse.shp", "type"),
    ],
)
def test_invalid_features_are_those_of_qgis(check, real_data, name, field):
    path = real_data(name)
    rows = read_rows(check(path, CLASS_FIELD=field)["ISSUES"])
    told = {row["feature_id"] for row in rows if row["kind"] == "invalid"}
    layer = QgsVectorLayer(str(path))
    expected = {f.id() for f in layer.getFeatures() if f.hasGeometry() and not f.geometry().isGeosValid()}
    assert told == expected and told
