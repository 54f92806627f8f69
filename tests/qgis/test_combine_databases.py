"""semref:combinedatabases: several databases become one that every algorithm reads; others are refused by name."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from made_inputs import scattered_objects
from made_sheets import sheet_settings
from qgis.core import QgsProcessingException

COMBINE = "semref:combinedatabases"
HEIGHT, WIDTH = 300, 480
LABELS = scattered_objects(HEIGHT, WIDTH, 160, seed=4)
LABELS[40:44, 100:400] = 2


@pytest.fixture(scope="module")
def build(run_algorithm):
    def run(folder, name, left, right, **parameters):
        settings = sheet_settings(folder, name, LABELS, (left, 0, right, HEIGHT))
        sizes = {"WINDOW_SIZE": 160, "STRIDE": 80}
        return run_algorithm("semref:builddatabase", {**settings, **sizes, **parameters})["DATABASE"]

    return run


@pytest.fixture(scope="module")
def made(build, tmp_path_factory):
    folder = tmp_path_factory.mktemp("sheets")
    build(folder, "west", 0, 280)
    build(folder, "east", 200, WIDTH)
    return folder


@pytest.fixture
def folder(made, tmp_path):
    (tmp_path / "sheets").mkdir()
    for path in made.glob("*.gpkg"):
        shutil.copy(path, tmp_path / "sheets")
    return tmp_path


@pytest.fixture
def combine(run_algorithm, folder):
    def run(feedback=None, **parameters):
        sheets = [str(folder / "sheets" / f"{name}.gpkg") for name in ("west", "east")]
        defaults = {"DATABASES": sheets, "OUTPUT": str(folder / "country.semrefset")}
        return run_algorithm(COMBINE, {**defaults, **parameters}, feedback)

    return run


def test_the_set_names_the_databases_from_its_folder_on_and_is_read_as_one(combine, folder, feedback):
    from semref.storage.database.reader import read_database

    results = combine(feedback)
    content = json.loads(Path(results["OUTPUT"]).read_text("utf-8"))
    assert content == {
        "format": "SemRef database set",
        "version": 1,
        "parts": [{"path": "sheets/west.gpkg"}, {"path": "sheets/east.gpkg"}],
    }
    # All of it moves together.
    shutil.move(str(folder / "sheets"), str(folder / "elsewhere" / "sheets"))
    moved = shutil.move(results["OUTPUT"], str(folder / "elsewhere"))
    database = read_database(moved, with_overview=True)
    assert len(database.references) == results["LANDMARK_COUNT"] > 100
    assert database.parameters.map_width_px == WIDTH and database.overview.shape == (75, 120)
    assert f"2 databases together have {len(database.references)} landmarks" in feedback.textLog()


def test_landmarks_that_no_database_has_whole_are_counted_and_told(combine, feedback):
    assert combine(feedback)["CUT_COUNT"] == 2
    assert "2 landmarks go on beyond the edge of their database" in feedback.textLog()


def test_where_all_are_whole_there_is_no_warning(combine, build, folder, feedback):
    sheets = [build(folder, "left", 0, 420), build(folder, "right", 80, WIDTH)]
    assert combine(feedback, DATABASES=sheets)["CUT_COUNT"] == 0
    assert "go on beyond" not in feedback.textLog()


def test_other_databases_are_refused_and_nothing_is_left(combine, build, folder):
    west = str(folder / "sheets" / "west.gpkg")
    others = {
        "was built with another minimum area (40) than": build(folder, "a", 200, WIDTH, MINIMUM_AREA=40),
        "begins 201 pixels to the side of": build(folder, "b", 201, WIDTH),
        "has another class table than": build(folder, "c", 200, WIDTH, REFERENCE_CLASSES="building;water"),
        "which is not there": str(folder / "none.gpkg"),
        "west.gpkg twice": west,
    }
    for reason, other in others.items():
        with pytest.raises(QgsProcessingException) as refused:
            combine(DATABASES=[west, other])
        assert reason in str(refused.value)
    assert not (folder / "country.semrefset").exists()


def test_a_set_is_no_part_of_another(combine, folder):
    inner = combine()["OUTPUT"]
    with pytest.raises(QgsProcessingException, match="is a set of databases itself"):
        combine(DATABASES=[str(folder / "sheets" / "west.gpkg"), inner], OUTPUT=str(folder / "outer.semrefset"))


@pytest.mark.parametrize(
    ("parameters", "reason"),
    [
        ({"OUTPUT": "country.json"}, "give a name that ends in .semrefset"),
        ({"DATABASES": ["west.gpkg"]}, "DATABASES names 1; choose two or more"),
    ],
)
def test_what_can_be_no_set_is_refused(combine, folder, parameters, reason):
    given = {
        key: str(folder / value) if isinstance(value, str) else [str(folder / "sheets" / name) for name in value]
        for key, value in parameters.items()
    }
    with pytest.raises(QgsProcessingException) as refused:
        combine(**given)
    assert reason in str(refused.value)
    assert not (folder / "country.json").exists()


def test_the_set_never_takes_the_place_of_a_database(combine, folder):
    sheet = folder / "sheets" / "west.gpkg"
    before = sheet.read_bytes()
    with pytest.raises(QgsProcessingException):
        combine(OUTPUT=str(sheet))
    assert sheet.read_bytes() == before
