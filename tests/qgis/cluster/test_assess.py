"""The squares that workers assess together are those of the algorithm, and the same bytes whatever their number."""

from __future__ import annotations

import contextlib
import os
import sqlite3

import pytest
from built_database import NAMES
from clustered import lose_a_worker, require_nothing_after, wait_for
from made_inputs import scattered_objects
from osgeo import ogr
from qgis.core import QgsVectorLayer

SIZE = 160
LABELS = scattered_objects(420, 480, 300, seed=21, background=0)
ASKED = ["--footprints", "160;120.0000001", "--spacing", "80", "--trials", 60]


@pytest.fixture(scope="module")
def area(build_area):
    """Path of a database."""
    return build_area(LABELS, NAMES, SIZE, 40)


@pytest.fixture(scope="module")
def assessed(cluster, area, tmp_path_factory):
    """The file of one worker, and what was said of it."""
    target = tmp_path_factory.mktemp("assessed") / "squares.gpkg"
    result = cluster("assess", area, "--output", target, *ASKED, "--local", 1)
    assert result.returncode == 0, result.stderr
    return target, result.stdout


def rows(path):
    source = ogr.Open(str(path))
    layer = source.GetLayer(0)
    return [(feature.items(), feature.GetGeometryRef().ExportToIsoWkt()) for feature in layer]


def test_it_holds_what_the_algorithm_tells_with_its_defaults(assessed, area, run_algorithm, tmp_path):
    path, said = assessed
    asked = {"DATABASE": area, "TRIALS": 60, "FOOTPRINT": "160;120.0000001", "SPACING": 80, "SCHEDULER": "local:1"}
    expected = run_algorithm("semref:assessdatabase", {**asked, "OUTPUT": str(tmp_path / "qgis.gpkg")})
    found, wanted = rows(path), rows(expected["OUTPUT"])
    layers = [QgsVectorLayer(str(one), "squares", "ogr") for one in (path, expected["OUTPUT"])]
    legends = [layer.renderer() for layer in layers]
    assert legends[0].classAttribute() == legends[1].classAttribute() and "160.0" in legends[0].classAttribute()
    assert [one.label() for one in legends[0].ranges()] == [one.label() for one in legends[1].ranges()]
    assert len(found) == len(wanted) > 20
    for (values, shape), (others, other) in zip(found, wanted):
        assert shape == other and list(values) == list(others)
        # Sums of the last step may end in other digits, where QGIS's process has more threads.
        numbers = {name: value for name, value in values.items() if isinstance(value, float)}
        assert numbers == pytest.approx({name: others[name] for name in numbers}, rel=1e-9)
        assert {**values, **numbers} == {**others, **numbers}
    assert sum(values["success"] for values, _ in found) > 0
    share = float(said.partition("localizable_fraction: ")[2].split()[0])
    assert share == pytest.approx(expected["LOCALIZABLE_FRACTION"])


def test_it_tells_what_it_is_what_made_it_and_of_what_as_the_algorithm_does(assessed, area, run_algorithm, tmp_path):
    path, _ = assessed
    asked = {"DATABASE": area, "TRIALS": 20, "OUTPUT": str(tmp_path / "qgis.gpkg")}
    output = run_algorithm("semref:assessdatabase", asked)["OUTPUT"]
    found, wanted = (QgsVectorLayer(str(one), "squares", "ogr").metadata() for one in (path, output))
    assert (found.title(), found.abstract()) == (wanted.title(), wanted.abstract())
    assert found.extent().spatialExtents()[0].extentCrs == wanted.extent().spatialExtents()[0].extentCrs
    (line,) = found.history()
    assert f"python -m cluster assess {area} --footprints '160;120.0000001' --spacing 80 --trials 60" in line
    assert "--missed 20" in line and "without" not in line


def test_its_metadata_are_registered_as_gdal_registers_them(assessed, area):
    for path in (assessed[0], area):
        with contextlib.closing(sqlite3.connect(path)) as connection:
            rows = connection.execute(
                "SELECT table_name, column_name, extension_name, definition, scope FROM gpkg_extensions "
                "WHERE extension_name = 'gpkg_metadata' ORDER BY table_name"
            ).fetchall()
        definition = "http://www.geopackage.org/spec120/#extension_metadata"
        tables = "gpkg_metadata", "gpkg_metadata_reference"
        assert rows == [(table, None, "gpkg_metadata", definition, "read-write") for table in tables]


@pytest.mark.slow
def test_two_workers_give_the_same_bytes(cluster, assessed, area, tmp_path):
    target = tmp_path / "squares.gpkg"
    result = cluster("assess", area, "--output", target, *ASKED, "--local", 2)
    assert result.returncode == 0, result.stderr
    assert target.read_bytes() == assessed[0].read_bytes()
    assert [path.name for path in tmp_path.iterdir()] == ["squares.gpkg"]


@pytest.mark.slow
def test_two_workers_of_which_one_is_killed_give_the_same_bytes(cluster, assessed, area, tmp_path):
    target = tmp_path / "squares.gpkg"
    running = cluster.start("assess", area, "--output", target, *ASKED, "--local", 2)
    lose_a_worker(running, "Localizing simulated images")
    assert target.read_bytes() == assessed[0].read_bytes()


@pytest.mark.slow
def test_landmarks_alone_and_other_noise_are_other_squares(cluster, assessed, area, tmp_path):
    target = tmp_path / "squares.gpkg"
    options = ["--without-map-correlation", "--missed", "60", "--seed", "4"]
    result = cluster("assess", area, "--output", target, *ASKED, *options, "--local", 1)
    assert result.returncode == 0, result.stderr
    mean = [sum(values["success"] for values, _ in rows(path)) for path in (target, assessed[0])]
    assert mean[0] < mean[1]


def test_an_interrupt_leaves_nothing(cluster, area, tmp_path):
    running = cluster.start("assess", area, "--output", tmp_path / "never.gpkg", "--local", 1)
    require_nothing_after("SIGINT", running, "Localizing simulated images", tmp_path)


@pytest.mark.slow
def test_a_database_that_is_changed_meanwhile_gives_no_squares(cluster, area, tmp_path):
    database = tmp_path / "area.gpkg"
    with open(area, "rb") as file:
        database.write_bytes(file.read())
    running = cluster.start("assess", database, "--output", tmp_path / "never.gpkg", *ASKED, "--local", 1)
    wait_for(running, "Localizing simulated images")
    os.utime(database, (1, 1))
    _, errors = running.communicate(timeout=120)
    assert running.returncode != 0 and "was changed while it was read" in errors
    assert not (tmp_path / "never.gpkg").exists()


@pytest.mark.parametrize(
    ("options", "part"),
    [
        (["--footprints", "much"], "“much” is no list of footprints"),
        (["--spacing", "0"], "edge of a square is 0"),
        (["--spacing", "0.01"], "give "),
    ],
)
def test_what_can_t_be_meant_is_said_in_one_sentence(cluster, area, tmp_path, options, part):
    result = cluster("assess", area, "--output", tmp_path / "never.gpkg", *options, "--local", 1)
    require_refused(result, 2, part)
    assert list(tmp_path.iterdir()) == []


def test_a_database_that_is_missing_or_none_is_said_in_one_sentence(cluster, tmp_path):
    foreign = tmp_path / "foreign.gpkg"
    foreign.write_bytes(b"no database at all")
    for path in (tmp_path / "gone.gpkg", foreign):
        result = cluster("assess", path, "--output", tmp_path / "never.gpkg", "--local", 1)
        require_refused(result, 3, path.name)
    assert [path.name for path in tmp_path.iterdir()] == ["foreign.gpkg"]


def test_the_database_is_not_replaced_by_its_squares(cluster, area):
    require_refused(cluster("assess", area, "--output", area, "--local", 1), 2, "would replace")


def require_refused(result, code, part):
    last = result.stderr.strip().splitlines()[-1]
    assert result.returncode == code and part in last and last.endswith("."), result.stderr
    assert "Traceback" not in result.stderr and result.stdout == ""
