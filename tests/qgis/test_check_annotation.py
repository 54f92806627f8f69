import re
from pathlib import Path

import numpy as np
import pytest
from made_inputs import polygon, read_rows, square, write_layer
from osgeo import gdal, ogr
from qgis.core import QgsProcessingException, QgsVectorLayer

from semref.core.annotation.check import check_features
from semref.core.annotation.polygons import AnnotatedFeature
from semref.core.steps import result_of
from semref.storage.pixel_grid import pixel_grid
from semref.storage.rasterize import burn_regions

CHECK, RASTERIZE = "semref:checkannotation", "semref:rasterizeannotation"


@pytest.fixture
def check(runner, tmp_path):
    """`check(layer, **parameters)` returns the results; the issues are in tmp_path/issues.gpkg."""
    return runner(CHECK, "INPUT", CLASS_FIELD="class", MINIMUM_AREA=0, ISSUES=tmp_path / "issues.gpkg")


@pytest.fixture
def issues(check):
    """`issues(layer, **parameters)` returns the rows of the findings."""

    def run(layer, **parameters):
        results = check(layer, **parameters)
        rows = read_rows(results["ISSUES"])
        assert results["ISSUE_COUNT"] == len(rows)
        assert results["ERROR_COUNT"] == sum(row["severity"] == "error" for row in rows)
        return rows

    return run


def test_issues_are_drawn_by_severity_errors_on_top(check, tmp_path, classes_csv):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 10), "field"), (square(6, 0, 10), "water")])
    found = QgsVectorLayer(check(layer, CLASS_TABLE=classes_csv)["ISSUES"], "issues", "ogr")
    renderer = found.renderer()
    assert [category.value() for category in renderer.categories()] == ["error", "warning", "information"]
    assert renderer.orderByEnabled() and not list(tmp_path.glob("*-wal"))
    (feature,) = found.getFeatures()
    assert feature["severity"] == "error" and renderer.categoryIndexForValue(feature["severity"]) == 0


def test_classes_that_are_missing_or_unknown_are_errors(issues, tmp_path, classes_csv):
    features = [(square(0, 0, 9), "field"), (square(20, 0, 9), None), (square(40, 0, 9), "lighthouse")]
    rows = issues(write_layer(tmp_path / "a.gpkg", features), CLASS_TABLE=classes_csv)
    found = [(row["kind"], row["severity"], row["feature_id"]) for row in rows]
    assert found == [("no_class", "error", 2), ("unknown_class", "error", 3)]
    assert "“lighthouse”" in rows[1]["message"]
    assert rows[1]["area"] == pytest.approx(81)


def test_polygons_outside_the_area_of_the_crs_are_reported(issues, tmp_path):
    far = "POLYGON ((9.5 47.1, 9.6 47.1, 9.6 47.2, 9.5 47.1))"
    rows = issues(write_layer(tmp_path / "a.gpkg", [(square(0, 0, 9), "field"), (far, "field")]))
    assert [(row["kind"], row["feature_id"]) for row in rows if row["kind"] == "outside_crs"] == [("outside_crs", 2)]


def test_a_layer_in_degrees_is_checked_in_meters(issues, tmp_path, feedback):
    shapes = [f"POLYGON (({x} 47, {x + 0.002} 47, {x + 0.002} 47.001, {x} 47.001, {x} 47))" for x in (9, 9.001)]
    layer = write_layer(tmp_path / "a.gpkg", [(shapes[0], "a"), (shapes[1], "b")], crs=4326)
    rows = issues(layer)
    assert [row["kind"] for row in rows] == ["overlap"]
    assert rows[0]["area"] == pytest.approx(76.06 * 111.18, rel=0.01)
    assert "EPSG:32632" in feedback.textLog()


def test_a_layer_without_class_is_refused(check, tmp_path):
    with pytest.raises(QgsProcessingException, match="No feature of “.*” has a class"):
        check(write_layer(tmp_path / "a.gpkg", [(square(0, 0, 9), None)]))


def test_the_report_counts_by_kind_and_class(check, tmp_path, classes_csv):
    features = [(square(0, 0, 10), "field"), (square(6, 0, 10), "water"), (square(40, 0, 5), None)]
    layer = write_layer(tmp_path / "a.gpkg", features)
    results = check(layer, CLASS_TABLE=classes_csv, REPORT=str(tmp_path / "report.html"))
    text = Path(results["REPORT"]).read_text(encoding="utf-8")
    assert "a: 3 features" in text
    bad = '</td><td class="number bad">1</td>'
    for cells in (f"<td>overlap{bad}", f"<td>no class{bad}"):
        assert cells in text
    assert not re.search(r"(?i)<script|http(?!://www\.w3\.org/2000/svg)", text)


def test_drawn_landmarks_are_the_objects_of_the_label_map(run_algorithm, tmp_path):
    """Compare the regions that the check draws with those of Rasterize annotation on the same layer."""
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
    _, landmarks = result_of(check_features(annotated, 0.0, 1.0, (1, 2, 3, 4)))
    right, bottom = transform[0] + labels.shape[1] * 0.7, transform[3] - labels.shape[0] * 0.7
    frame = pixel_grid((transform[0], bottom, right, transform[3]), 0.7, made.GetProjection())
    runs, classes = result_of(burn_regions(landmarks, frame)), [landmark.class_value for landmark in landmarks]
    drawn = np.zeros_like(labels)
    for row, start, stop, region in zip(runs.rows, runs.starts, runs.stops, runs.regions):
        drawn[row, start:stop] = classes[region - 1]
    np.testing.assert_array_equal(drawn, labels)


@pytest.mark.slow
@pytest.mark.real_data
@pytest.mark.parametrize(
    ("name", "field"),
    [("berlin_urban_gradient/LandCov_BerlinUrbanGradient.shp", "Level_2"), ("osm_belgrade/landuse.shp", "type")],
)
def test_invalid_features_are_those_of_qgis(check, real_data, name, field):
    path = real_data(name)
    rows = read_rows(check(path, CLASS_FIELD=field)["ISSUES"])
    told = {row["feature_id"] for row in rows if row["kind"] == "invalid"}
    layer = QgsVectorLayer(str(path))
    expected = {f.id() for f in layer.getFeatures() if f.hasGeometry() and not f.geometry().isGeosValid()}
    assert told == expected and told
