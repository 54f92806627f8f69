from pathlib import Path

import numpy as np
import pytest
from made_inputs import WEST, polygon, read_rows, rectangle, ring, square, write_layer
from osgeo import gdal, ogr

REPAIR, CHECK, RASTERIZE = "semref:repairannotation", "semref:checkannotation", "semref:rasterizeannotation"
FIELDS = [("class", "text"), ("zorder", "integer"), ("note", "text")]


@pytest.fixture
def repair(runner, tmp_path):
    """`repair(layer, **parameters)` returns (rows of the output, rows of the changes)."""
    outputs = {"OUTPUT": tmp_path / "repaired.gpkg", "CHANGES": tmp_path / "changes.gpkg"}
    run = runner(REPAIR, "INPUT", CLASS_FIELD="class", **outputs)

    def repaired(layer, **parameters):
        results = run(layer, **parameters)
        return read_rows(results["OUTPUT"]), read_rows(results["CHANGES"])

    return repaired


def test_overlaps_are_resolved_and_attributes_kept(repair, tmp_path):
    features = [(square(0, 0, 10), "field", 1, "below"), (square(6, 0, 10), "water", 2, "on top")]
    rows, changes = repair(write_layer(tmp_path / "a.gpkg", features, FIELDS), PRIORITY_FIELD="zorder")
    assert [(row["class"], row["zorder"], row["note"]) for row in rows] == [features[0][1:], features[1][1:]]
    assert [row["geometry"].Area() for row in rows] == pytest.approx([60, 100])
    assert [(row["kind"], row["feature_id"], row["other_id"]) for row in changes] == [("overlap", 2, 1)]
    assert changes[0]["area"] == pytest.approx(40)


def test_a_feature_cut_in_two_becomes_two_of_the_same_attributes(repair, tmp_path):
    features = [(rectangle(0, 0, 30, 10), "field", 1, "cut"), (rectangle(10, -5, 5, 20), "water", 2, "river")]
    rows, _ = repair(write_layer(tmp_path / "a.gpkg", features, FIELDS), PRIORITY_FIELD="zorder")
    assert [row["note"] for row in rows] == ["cut", "cut", "river"]


def test_parts_heights_and_self_intersections_are_repaired_and_reported(repair, tmp_path):
    z = f"POLYGON Z (({WEST} 5219000 3, {WEST + 9} 5219000 3, {WEST + 9} 5218991 3, {WEST} 5219000 3))"
    features = [
        (f"MULTIPOLYGON (({ring([(0, 0), (5, 0), (5, 5), (0, 5)])[1:-1].join('()')}))", "a"),
        (z, "a"),
        (polygon([(40, 0), (44, 4), (44, 0), (40, 4)]), "a"),
        (None, "a"),
        (square(60, 0, 5), None),
    ]
    rows, changes = repair(write_layer(tmp_path / "a.gpkg", features))
    assert sorted(row["geometry"].Area() for row in rows) == pytest.approx([4, 4, 25, 40.5])
    assert sorted(row["kind"] for row in changes) == ["invalid", "no_class", "no_geometry", "three_dimensional"]


def random_layer(path: Path, seed: int) -> Path:
    random = np.random.default_rng(seed)
    features = []
    for _ in range(120):
        corners = random.uniform(0, 150, 2) + random.uniform(0, 30, (int(random.integers(3, 6)), 2))
        features.append((polygon(corners.tolist()), f"class {random.integers(1, 5)}", int(random.integers(0, 3)), "x"))
    return write_layer(path, features, FIELDS)


def test_a_repaired_layer_has_no_findings_left(repair, run_algorithm, tmp_path):
    repair(random_layer(tmp_path / "a.gpkg", 2))
    checked = {"INPUT": str(tmp_path / "repaired.gpkg"), "CLASS_FIELD": "class", "MINIMUM_AREA": 0}
    results = run_algorithm(CHECK, {**checked, "ISSUES": str(tmp_path / "issues.gpkg")})
    left = read_rows(results["ISSUES"])
    # Two polygons that meet in a point can't be merged.
    assert {row["kind"] for row in left} <= {"same_class_neighbors"} and results["ERROR_COUNT"] == 0


@pytest.mark.slow
def test_the_label_map_changes_only_at_reported_issues(repair, run_algorithm, tmp_path):
    layer = random_layer(tmp_path / "a.gpkg", 3)
    extent = f"{WEST},{WEST + 180},{5_219_800},{5_220_000} [EPSG:32632]"
    common = {"CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
    check = {"INPUT": str(layer), "ISSUES": str(tmp_path / "issues.gpkg"), **common}
    run_algorithm(CHECK, check)
    repair(layer, PRIORITY_FIELD="zorder")
    maps = []
    for source in (layer, tmp_path / "repaired.gpkg"):
        made = {"INPUT": str(source), "PIXEL_SIZE": 0.5, "EXTENT": extent, "OUTPUT": str(tmp_path / "l.tif"), **common}
        dataset = gdal.Open(run_algorithm(RASTERIZE, made)["OUTPUT"])
        maps.append(dataset.ReadAsArray())
    reported = gdal.GetDriverByName("MEM").Create("", *maps[0].shape[::-1], 1)
    reported.SetGeoTransform(dataset.GetGeoTransform())
    reported.SetProjection(dataset.GetProjection())
    issues = ogr.Open(str(tmp_path / "issues.gpkg"))
    layer = issues.GetLayer(0)
    layer.SetAttributeFilter("(kind IN ('overlap', 'duplicate') AND severity = 'error') OR kind IN ('gap', 'sliver')")
    gdal.RasterizeLayer(reported, [1], layer, burn_values=[1], options=["ALL_TOUCHED=TRUE"])
    changed = maps[0] != maps[1]
    assert changed.any()
    assert not changed[reported.ReadAsArray() == 0].any()
