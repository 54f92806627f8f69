"""The database that workers build together is that of one process."""

from __future__ import annotations

import contextlib
import json
import sqlite3
import subprocess
import sys
import time

import numpy as np
import pytest
from built_database import BUILD, NAMES, content
from clustered import SETTINGS, lose_a_worker, require_nothing_after
from made_inputs import scattered_objects, write_raster
from osgeo import gdal


def build(cluster, label_map, target, workers=1, classes="building;water"):
    return cluster(
        "build", label_map, "--database", target, "--reference-classes", classes, *SETTINGS, "--local", workers
    )


@pytest.fixture(scope="module")
def built(cluster, label_map, tmp_path_factory):
    target = tmp_path_factory.mktemp("cluster") / "one.gpkg"
    result = build(cluster, label_map, target)
    assert result.returncode == 0, result.stderr
    return target


def test_it_holds_what_the_algorithm_builds(built, label_map, run_algorithm, tmp_path):
    expected = run_algorithm(
        BUILD,
        {
            "LABELS": str(label_map),
            "REFERENCE_CLASSES": "building;water",
            "WINDOW_SIZE": 320,
            "STRIDE": 140,
            "MINIMUM_AREA": 40,
            "DATABASE": str(tmp_path / "expected.gpkg"),
        },
    )
    assert expected["WINDOW_COUNT"] > 50 and expected["REFERENCE_COUNT"] > 500
    found, wanted = content(built), content(expected["DATABASE"])
    assert spatial_references(built) == spatial_references(expected["DATABASE"])
    assert found == wanted and len(found["parameters"]) > 12
    overviews = [gdal.Open(f"GPKG:{path}:overview").ReadAsArray() for path in (built, expected["DATABASE"])]
    np.testing.assert_array_equal(*overviews)


def test_of_a_map_that_words_its_crs_otherwise_it_is_the_same_too(cluster, run_algorithm, tmp_path):
    """A VRT has it as an older WKT, without the members of the datum's ensemble."""
    labels = scattered_objects(400, 400, 150, seed=4)
    sheet, mosaic = write_raster(tmp_path / "labels.tif", labels, crs=25832), tmp_path / "mosaic.vrt"
    gdal.BuildVRT(str(mosaic), [str(sheet)]).FlushCache()
    assert "ENSEMBLE" not in gdal.Open(str(mosaic)).GetSpatialRef().ExportToWkt(["FORMAT=WKT2_2019"])
    result = build(cluster, mosaic, tmp_path / "cluster.gpkg", classes="1;2")
    assert result.returncode == 0, result.stderr
    asked = {"LABELS": str(mosaic), "REFERENCE_CLASSES": "1;2", "WINDOW_SIZE": 320, "STRIDE": 140}
    run_algorithm(BUILD, {**asked, "MINIMUM_AREA": 40, "DATABASE": str(tmp_path / "qgis.gpkg")})
    found, wanted = tmp_path / "cluster.gpkg", tmp_path / "qgis.gpkg"
    parameters = {key: value for _, key, value in content(found)["parameters"]}
    assert "ENSEMBLE" in parameters["crs"] and len(content(found)["windows"]) > 0
    assert content(found) == content(wanted)
    assert spatial_references(found, 25832) == spatial_references(wanted, 25832)


def spatial_references(path, code=32632):
    """All that a GeoPackage says of CRSs, and which its tables are in."""
    with contextlib.closing(sqlite3.connect(path)) as connection:
        systems = connection.execute("SELECT * FROM gpkg_spatial_ref_sys ORDER BY srs_id").fetchall()
        tables = connection.execute("SELECT table_name, srs_id FROM gpkg_contents ORDER BY table_name").fetchall()
    assert len(systems) >= 3 and ("windows", code) in tables
    return systems, tables


def test_two_workers_of_which_one_is_killed_give_the_same_bytes(cluster, built, label_map, tmp_path):
    target = tmp_path / "two.gpkg"
    running = cluster.start(
        "build", label_map, "--database", target, "--reference-classes", "building;water", *SETTINGS, "--local", 2
    )
    lose_a_worker(running, "Finding landmarks")
    assert target.read_bytes() == built.read_bytes()


def test_a_scheduler_and_workers_that_have_nothing_of_semref_give_the_same_bytes(cluster, built, label_map, tmp_path):
    """Both run elsewhere, in a folder that has no code of ours."""
    note = tmp_path / "scheduler.json"
    programs = {"scheduler": ["--port", "0", "--no-dashboard"], "worker": ["--nthreads", "1"]}
    running = []
    try:
        for name, options in programs.items():
            order = [sys.executable, "-m", f"distributed.cli.dask_{name}", "--scheduler-file", str(note), *options]
            running.append(subprocess.Popen(order, cwd=tmp_path, stderr=subprocess.DEVNULL))
            for _ in range(600):
                if note.exists() and note.read_text().strip().endswith("}"):
                    break
                time.sleep(0.1)
        address, target = json.loads(note.read_text())["address"], tmp_path / "elsewhere.gpkg"
        classes = ["--reference-classes", "building;water"]
        result = cluster("build", label_map, "--database", target, *classes, *SETTINGS, "--scheduler", address)
    finally:
        for process in running[::-1]:
            process.terminate()
            process.wait(timeout=60)
    assert result.returncode == 0, result.stderr
    assert target.read_bytes() == built.read_bytes()


def test_a_map_without_classes_inside_is_built_by_its_values(cluster, tmp_path):
    labels = np.zeros((400, 500), np.uint8)
    for n in range(20):
        labels[10 + 18 * n : 22 + 18 * n, 20 + 20 * n : 40 + 20 * n] = 1 + n % 2
    label_map = write_raster(tmp_path / "plain.tif", labels)
    result = build(cluster, label_map, tmp_path / "plain.gpkg", classes="1;2")
    assert result.returncode == 0, result.stderr
    assert "named by their values" in result.stderr
    with contextlib.closing(sqlite3.connect(tmp_path / "plain.gpkg")) as connection:
        assert connection.execute('SELECT count(*) FROM "references"').fetchone() == (20,)


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_an_interrupt_leaves_nothing(cluster, label_map, tmp_path, monkeypatch, name):
    target = tmp_path / "never.gpkg"
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    running = cluster.start(
        "build", label_map, "--database", target, "--reference-classes", "building", *SETTINGS, "--local", 1
    )
    require_nothing_after(name, running, "Finding landmarks", tmp_path)


def test_the_style_is_what_the_algorithm_s_is(built):
    """What QGIS reads of the plain style draws as what it wrote itself."""
    from qgis.core import QgsRasterLayer, QgsVectorLayer

    from semref.processing.exchange import styles
    from semref.storage.database.reader import read_database

    table = read_database(str(built)).class_table
    windows = QgsVectorLayer(f"{built}|layername=windows", "windows", "ogr")
    assert drawn(windows.renderer().symbol()) == drawn(styles.windows_renderer().symbol())
    references = QgsVectorLayer(f"{built}|layername=references", "references", "ogr")
    found, wanted = references.renderer().categories(), styles.references_renderer(table).categories()
    assert [(str(c.value()), c.label(), drawn(c.symbol())) for c in found] == [
        (str(c.value()), c.label(), drawn(c.symbol())) for c in wanted
    ]
    overview = QgsRasterLayer(f"GPKG:{built}:overview", "overview")
    styles.apply_overview_style(overview, str(built))
    classes = [(c.value, c.label, c.color.name()) for c in overview.renderer().classes()]
    assert classes == [(c.value, c.name, c.color) for c in table if c.value]


@pytest.mark.parametrize("table", ["windows", "references"])
def test_the_titles_of_columns_are_what_the_algorithm_s_are(built, table):
    from qgis.core import QgsVectorLayer

    from semref.processing.wording.columns import column_titles

    layer = QgsVectorLayer(f"{built}|layername={table}", table, "ogr")
    found = {field.name(): layer.attributeAlias(index) for index, field in enumerate(layer.fields())}
    assert found.pop("fid") == ""
    assert found == {name: column_titles()[name] for name in found} and len(found) > 3


@pytest.mark.parametrize("table", ["windows", "references"])
def test_its_note_is_what_qgis_writes(cluster, run_algorithm, tmp_path, table):
    from qgis.core import QgsLayerMetadata, QgsRasterLayer, QgsVectorLayer

    label_map = write_raster(tmp_path / "labels.tif", scattered_objects(400, 400, 150, seed=4), names=NAMES)
    layer = QgsRasterLayer(str(label_map), "labels")
    told = QgsLayerMetadata()
    told.setTitle("Land cover of <Erewhon>")
    told.setLicenses(["ODbL 1.0"])
    told.setRights(["© OpenStreetMap & others"])
    layer.setMetadata(told)
    layer.saveNamedMetadata(str(label_map.with_suffix(".qmd")))
    found = build(cluster, label_map, tmp_path / "cluster.gpkg")
    assert found.returncode == 0, found.stderr
    asked = {"LABELS": str(label_map), "REFERENCE_CLASSES": "building;water", "WINDOW_SIZE": 320, "STRIDE": 140}
    asked |= {"MINIMUM_AREA": 40, "DATABASE": str(tmp_path / "qgis.gpkg")}
    run_algorithm(BUILD, asked)
    paths = (tmp_path / f"{who}.gpkg" for who in ("cluster", "qgis"))
    note, wanted = (QgsVectorLayer(f"{path}|layername={table}", table, "ogr").metadata() for path in paths)
    for name in ("title", "abstract", "licenses", "rights", "type"):
        assert getattr(note, name)() == getattr(wanted, name)() != "", name
    assert note.crs() == wanted.crs()
    (extent,), (other,) = note.extent().spatialExtents(), wanted.extent().spatialExtents()
    assert extent.extentCrs == other.extentCrs and extent.bounds.toRectangle() == other.bounds.toRectangle()
    (line,) = note.history()
    assert f"python -m cluster build {label_map} --reference-classes 'building;water' --window-size 320 " in line
    assert line.partition(":")[0].isprintable() and "UTC, SemRef" in line


def test_qgis_adds_itself_to_the_note_of_the_cluster(cluster, run_algorithm, label_map, built, tmp_path):
    from qgis.core import QgsVectorLayer

    database = tmp_path / "area.gpkg"
    database.write_bytes(built.read_bytes())
    run_algorithm(
        "semref:updatedatabase", {"DATABASE": str(database), "LABELS": str(label_map), "OUTPUT": str(database)}
    )
    first, second = QgsVectorLayer(f"{database}|layername=windows", "windows", "ogr").metadata().history()
    assert "python -m cluster build" in first and "updatedatabase" in second


def drawn(symbol):
    """What a symbol's only layer looks like."""
    properties = symbol.symbolLayers()[0].properties()
    return {key: properties.get(key) for key in ("style", "outline_color", "outline_width", "color", "size", "name")}


def test_what_happens_is_told_as_json_to_who_asks(cluster, label_map, tmp_path):
    result = cluster(
        "build",
        label_map,
        "--database",
        tmp_path / "a.gpkg",
        "--reference-classes",
        "1",
        *SETTINGS,
        "--local",
        1,
        "--json",
    )
    events = [json.loads(line) for line in result.stdout.splitlines()]
    assert result.returncode == 0 and events[-1]["event"] == "done" and events[-1]["windows"] > 50
    shares = [event["share"] for event in events if event["event"] == "step"]
    assert shares == sorted(shares) and shares[0] >= 0 and shares[-1] == pytest.approx(1)


@pytest.mark.slow
def test_an_overview_that_lies_in_a_file_meanwhile_gives_the_same_bytes(label_map, tmp_path, monkeypatch):
    pytest.importorskip("distributed")
    from argparse import Namespace

    from semref.cluster import build as builds
    from semref.storage.database import overview_file

    options = {"labels": str(label_map), "reference_classes": "building;water", "window_size": 320.0, "stride": 140.0}
    options |= {"levels": "1", "references_per_vector": 10, "minimum_area": 40.0, "map_accuracy": 1.1}
    options["without_note"] = False
    cache = gdal.GetCacheMax()
    try:
        for name, held in (("held.gpkg", 1 << 30), ("filed.gpkg", 0)):
            monkeypatch.setattr(overview_file, "HELD_PIXELS", held)
            workers = {"scheduler": None, "local": 1, "worker_memory": None}
            builds.build(Namespace(**options, **workers, database=str(tmp_path / name)), SilentTeller())
    finally:
        gdal.SetCacheMax(cache)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["filed.gpkg", "held.gpkg"]
    assert (tmp_path / "filed.gpkg").read_bytes() == (tmp_path / "held.gpkg").read_bytes()


class SilentTeller:
    def step(self, text, share):
        assert 0 <= share <= 1

    def say(self, text):
        assert text
