"""A set of databases is read as one wherever a database is read; a set that can't be is told in one sentence."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import shutil
import sqlite3
import subprocess
import sys
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pytest
from made_inputs import NORTH, WEST, scattered_objects, turned_view, write_layer, write_raster
from made_sheets import NAMES, sheet_settings
from qgis.core import QgsProcessingException

from semref.core.errors import DatabaseError, SemRefError

HEIGHT, WIDTH = 600, 720
LABELS = scattered_objects(HEIGHT, WIDTH, 420, seed=21)
LABELS[590:, 300:320] = 2
LABELS[300:320, :12] = 1
BOXES = {
    "nw": (0, 0, 460, 440),
    "ne": (200, 0, WIDTH, 440),
    "sw": (0, 200, 460, HEIGHT),
    "se": (200, 200, WIDTH, HEIGHT),
}
"""First column and row, last column and row + 1; they begin at strides, and overlap by more than a window."""
EDIT = (slice(480, 560), slice(240, 320))
"""Ground that two sheets show, and two don't."""


def edited():
    labels = LABELS.copy()
    labels[EDIT] = 4
    labels[500:511, 260:274] = labels[530:536, 290:309] = 1
    return labels


@pytest.fixture(scope="module")
def build(run_algorithm):
    def run(folder, name, labels, box=(0, 0, WIDTH, HEIGHT), **parameters):
        settings = sheet_settings(folder, name, labels, box)
        sizes = {"WINDOW_SIZE": 200, "STRIDE": 100}
        return run_algorithm("semref:builddatabase", {**settings, **sizes, **parameters})["DATABASE"]

    return run


@pytest.fixture(scope="module")
def made(build, tmp_path_factory):
    folder = tmp_path_factory.mktemp("sheets")
    build(folder, "whole", LABELS)
    for name, box in BOXES.items():
        build(folder, name, LABELS, box)
    return folder


@pytest.fixture
def folder(made, tmp_path):
    """The whole map's database and four sheets, to spoil."""
    for path in made.glob("*.gpkg"):
        shutil.copy(path, tmp_path)
    return tmp_path


def set_of(folder, *names, name="country.semrefset", **more) -> str:
    parts = [{"path": f"{part}.gpkg"} for part in names or BOXES]
    path = Path(folder) / name
    path.write_text(json.dumps({"format": "SemRef database set", "version": 1, "parts": parts, **more}), "utf-8")
    return str(path)


def read(path, **more):
    from semref.storage.database.reader import read_database

    return read_database(str(path), with_overview=True, **more)


def rows_of(landmarks):
    columns = landmarks.positions, landmarks.classes, landmarks.areas_m2, landmarks.touches_edge, landmarks.bounds_px
    return np.column_stack(columns).tolist()


def test_sheets_are_read_as_the_database_of_the_whole_map(folder):
    whole, together = read(folder / "whole.gpkg", with_bounds=True), read(set_of(folder))
    assert len(whole.references) > 400 and whole.references.touches_edge.any()
    assert rows_of(together.references) == rows_of(whole.references)
    np.testing.assert_array_equal(together.overview, whole.overview)
    for name in ("first_pixels", "levels", "sizes", "centers", "counts", "vectors", "described"):
        np.testing.assert_array_equal(getattr(together.windows, name), getattr(whole.windows, name))
    assert together.class_table == whole.class_table
    hidden = {"map_hash": "", "block_hashes": ()}
    assert replace(together.parameters, **hidden) == replace(whole.parameters, **hidden)
    assert together.source == str(folder / "country.semrefset")


def test_images_get_the_same_fixes(folder, run_algorithm):
    from osgeo import gdal

    views = folder / "views"
    views.mkdir()
    rng = np.random.default_rng(5)
    for n in range(6):
        column, row, heading = rng.uniform(150, 570), rng.uniform(150, 450), rng.uniform(0, 360)
        view = turned_view(LABELS, 200, column, row, heading)
        write_raster(views / f"{n}.png", view, transform=None)
    found = []
    for database in (str(folder / "whole.gpkg"), set_of(folder)):
        output = str(folder / f"{Path(database).stem}_fixes.gpkg")
        run_algorithm("semref:localizeimages", {"DATABASE": database, "IMAGES": [str(views)], "OUTPUT": output})
        source = gdal.OpenEx(output)
        found.append([feature.items() for feature in source.GetLayer(0)])
    assert found[0] == found[1] and sum(row["status"] == "fix" for row in found[0]) >= 4


def test_a_corridor_across_the_seams_is_exported_as_of_the_whole_map(folder, run_algorithm):
    from semref.core.onboard.read import read_onboard

    line = f"LINESTRING ({WEST + 60} {NORTH - 50}, {WEST + 660} {NORTH - 550})"
    route = str(write_layer(folder / "route.gpkg", [(line, "a")]))
    found = []
    for database in (str(folder / "whole.gpkg"), set_of(folder)):
        parameters = {"DATABASE": database, "CLIP": route, "DISTANCE": 90, "OUTPUT": f"{database}.npz"}
        found.append(read_onboard(run_algorithm("semref:exportonboard", parameters)["OUTPUT"]).database)
    whole, together = found
    assert 100 < len(whole.references) < 400 and len(whole.windows) > 5
    assert asdict(replace(whole.parameters, map_hash="")) == asdict(replace(together.parameters, map_hash=""))
    for group in ("windows", "references"):
        for name, column in vars(getattr(whole, group)).items():
            if name != "names":
                np.testing.assert_array_equal(getattr(getattr(together, group), name), column, err_msg=name)
    np.testing.assert_array_equal(whole.overview, together.overview)


def hashes(folder):
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.iterdir() if path.is_file()}


def test_updating_one_sheet_changes_one_file_and_the_set_tells_the_new_ground(folder, build, run_algorithm):
    from semref.core.constellation.cached import key_of
    from semref.core.constellation.settings import CONSTELLATION
    from semref.storage.file_states import fingerprint

    country, truth = set_of(folder), read(build(folder, "truth", edited()), with_bounds=True)
    before, known = read(country), hashes(folder)
    # The sheet that was made first: its date counts, not its place in the list.
    left, top, right, bottom = BOXES["sw"]
    transform = (WEST + left, 1.0, 0.0, NORTH - top, 0.0, -1.0)
    piece = np.ascontiguousarray(edited()[top:bottom, left:right])
    corrected = str(write_raster(folder / "corrected.tif", piece, transform=transform, names=NAMES))
    sheet = str(folder / "sw.gpkg")
    run_algorithm("semref:updatedatabase", {"DATABASE": sheet, "LABELS": corrected, "OUTPUT": sheet})
    after = read(country)
    changed = {name for name, of in hashes(folder).items() if known.get(name) != of}
    assert changed - {"corrected.tif", "corrected.tif.aux.xml"} == {"sw.gpkg"}
    assert rows_of(after.references) == rows_of(truth.references) != rows_of(before.references)
    np.testing.assert_array_equal(after.overview, truth.overview)
    # Whatever is kept of the set before is not of it any more.
    assert fingerprint(after) != fingerprint(before)
    assert key_of(after.references, 1.0, CONSTELLATION) != key_of(before.references, 1.0, CONSTELLATION)


def test_an_overview_of_another_state_is_refused(folder, build):
    from semref.storage.database.connection import DatabaseChangedError
    from semref.storage.database.reader import read_overview

    country = set_of(folder)
    parameters = read(country).parameters
    np.testing.assert_array_equal(read_overview(country, parameters), read(country).overview)
    build(folder, "se", edited(), BOXES["se"])
    with pytest.raises(DatabaseChangedError, match=r"country\.semrefset was changed"):
        read_overview(country, parameters)


def dated(path, moment):
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("UPDATE gpkg_contents SET last_change = ? WHERE table_name = 'parameters'", (moment,))


def test_of_two_databases_the_younger_tells_the_ground_whatever_their_order(folder, build):
    build(folder, "later", edited())
    truth, old = (rows_of(read(folder / f"{name}.gpkg", with_bounds=True).references) for name in ("later", "whole"))
    for moments, expected in ((("2021-05-01T00:00:00.000Z", "2024-05-01T00:00:00Z"), truth), (("2024", "2021"), old)):
        for name, moment in zip(("whole", "later"), moments):
            dated(folder / f"{name}.gpkg", moment if len(moment) > 4 else f"{moment}-05-01T00:00:00.000Z")
        for order in (("whole", "later"), ("later", "whole")):
            assert rows_of(read(set_of(folder, *order)).references) == expected
    # Equally old: the last of the list.
    for name in ("whole", "later"):
        dated(folder / f"{name}.gpkg", "2024-05-01T00:00:00.000Z")
    assert rows_of(read(set_of(folder, "whole", "later")).references) == truth
    assert rows_of(read(set_of(folder, "later", "whole")).references) == old


def test_a_set_is_assessed_as_the_whole_map_is(folder, run_algorithm):
    found = []
    for database in (str(folder / "whole.gpkg"), set_of(folder)):
        parameters = {"DATABASE": database, "TRIALS": 20, "SEED": 3, "OUTPUT": "TEMPORARY_OUTPUT"}
        results = run_algorithm("semref:assessdatabase", parameters)
        found.append({key: value for key, value in results.items() if isinstance(value, (int, float))})
    assert found[0] == found[1] and found[0]


@pytest.mark.slow
def test_the_command_line_reads_a_set(folder, repository, tmp_path):
    pytest.importorskip("distributed")
    labels = str(write_raster(tmp_path / "labels.tif", LABELS, names=NAMES))
    told = []
    for database in (str(folder / "whole.gpkg"), set_of(folder)):
        command = [sys.executable, "-m", "cluster", "evaluate", database, labels]
        options = ["--output", f"{database}.json", "--trials", "4", "--local", "1"]
        done = subprocess.run([*command, *options], cwd=repository, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        told.append({**json.loads(Path(f"{database}.json").read_text("utf-8")), "settings": None})
    assert told[0] == told[1]


# --- what is no set ---


def refusal(path) -> str:
    with pytest.raises(SemRefError) as refused:
        read(path)
    text = str(refused.value)
    assert "\n" not in text and text.endswith(".") and len(text) < 600, text
    return text


def test_a_part_that_is_missing_is_named(folder):
    (folder / "se.gpkg").rename(folder / "moved.gpkg")
    text = refusal(set_of(folder))
    assert "country.semrefset names the database" in text and "se.gpkg, which is not there" in text


def test_a_part_that_is_damaged_or_foreign_is_named(folder):
    whole = (folder / "se.gpkg").read_bytes()
    (folder / "se.gpkg").write_bytes(whole[: len(whole) // 2])
    assert "se.gpkg is damaged or cut short" in refusal(set_of(folder))
    (folder / "se.gpkg").write_bytes(b"no database")
    assert "se.gpkg is not a GeoPackage" in refusal(set_of(folder))


def test_a_part_without_a_date_is_damaged(folder):
    dated(folder / "se.gpkg", "yesterday")
    assert "se.gpkg is damaged" in refusal(set_of(folder))


def test_a_part_of_other_classes_is_named(folder, build):
    build(folder, "se", LABELS, BOXES["se"], REFERENCE_CLASSES="building;water")
    assert "se.gpkg has another class table than" in refusal(set_of(folder))


def test_a_part_of_another_crs_is_named(folder, build, run_algorithm):
    left, top, right, bottom = BOXES["se"]
    transform = (WEST + left, 1.0, 0.0, NORTH - top, 0.0, -1.0)
    labels = write_raster(folder / "b.tif", LABELS[top:bottom, left:right], crs=32633, transform=transform, names=NAMES)
    build(folder, "se", LABELS, BOXES["se"], LABELS=str(labels))
    text = refusal(set_of(folder))
    assert "se.gpkg is in WGS 84 / UTM zone 33N and" in text and "zone 32N" in text


def test_a_set_in_a_set_and_a_set_in_itself_are_refused(folder):
    inner = Path(set_of(folder, name="inner.semrefset"))
    for name in (inner.name, "country.semrefset", "country.SEMREFSET"):
        path = Path(set_of(folder))
        path.write_text(path.read_text("utf-8").replace("se.gpkg", name), "utf-8")
        assert f"{name}, which is a set of databases itself" in refusal(path)


def test_a_part_that_is_named_twice_is_refused(folder):
    assert "nw.gpkg twice" in refusal(set_of(folder, "nw", "ne", "nw"))
    assert "ne.gpkg twice" in refusal(set_of(folder, "nw", "ne", f"../{folder.name}/ne"))


GOOD = {"format": "SemRef database set", "version": 1, "parts": [{"path": "nw.gpkg"}]}
BAD = {
    "empty": b"",
    "no JSON": b"{parts",
    "no text": bytes(range(128, 256)),
    "a list": b"[]",
    "another format": json.dumps({**GOOD, "format": "another"}).encode(),
    "no format": b"{}",
    "no version": json.dumps({key: GOOD[key] for key in ("format", "parts")}).encode(),
    "no part": json.dumps({**GOOD, "parts": []}).encode(),
    "parts that are none": json.dumps({**GOOD, "parts": {"path": "nw.gpkg"}}).encode(),
    "a part that is a text": json.dumps({**GOOD, "parts": ["nw.gpkg"]}).encode(),
    "a part without a path": json.dumps({**GOOD, "parts": [{}]}).encode(),
    "a path that is a number": json.dumps({**GOOD, "parts": [{"path": 3}]}).encode(),
    "an empty path": json.dumps({**GOOD, "parts": [{"path": " "}]}).encode(),
    "a path with a zero": json.dumps({**GOOD, "parts": [{"path": "nw\0.gpkg"}]}).encode(),
    "a path beyond all": json.dumps({**GOOD, "parts": [{"path": "n" * 10_000}]}).encode(),
    "deep": b"[" * 100_000,
    "large": b" " * (5 << 20),
    "a GeoPackage": b"SQLite format 3\0" * 100,
}


@pytest.mark.parametrize("content", BAD.values(), ids=BAD)
def test_garbage_is_no_set(folder, content):
    path = folder / "bad.semrefset"
    path.write_bytes(content)
    assert "bad.semrefset is not a set of databases (" in refusal(path)


def test_other_things_that_cannot_be_read(folder):
    assert "newer than this SemRef reads" in refusal(set_of(folder, version=2))
    assert "There is no database" in refusal(folder / "none.semrefset")
    surrogate = set_of(folder)
    Path(surrogate).write_text(json.dumps({**GOOD, "parts": [{"path": "\ud800.gpkg"}]}), "utf-8")
    with pytest.raises(DatabaseError):
        read(surrogate)


def test_what_a_newer_set_may_say_besides_is_ignored(folder):
    path = Path(set_of(folder, note="by hand"))
    content = json.loads(path.read_text("utf-8"))
    content["parts"][0]["sheet"] = "1:25,000, 12"
    path.write_text("\ufeff" + json.dumps(content), "utf-8")
    assert len(read(path).references) > 400


def test_what_writes_into_a_database_takes_a_part(folder, run_algorithm):
    labels = str(write_raster(folder / "labels.tif", LABELS, names=NAMES))
    parameters = {"DATABASE": set_of(folder), "LABELS": labels, "OUTPUT": str(folder / "updated.gpkg")}
    with pytest.raises(QgsProcessingException, match="is a set of databases, which is read only"):
        run_algorithm("semref:updatedatabase", parameters)
    assert not (folder / "updated.gpkg").exists()


def test_paths_are_told_from_the_set_s_folder_on(folder):
    from semref.storage.database.sets import files_of, parts_of, set_text

    (folder / "sheets").mkdir()
    moved = shutil.copy(folder / "nw.gpkg", folder / "sheets" / "nw.gpkg")
    country = folder / "country.semrefset"
    country.write_text(set_text(str(country), [moved, str(folder / "ne.gpkg")]), "utf-8")
    assert [part["path"] for part in json.loads(country.read_text("utf-8"))["parts"]] == ["sheets/nw.gpkg", "ne.gpkg"]
    assert list(map(os.path.realpath, parts_of(str(country)))) == [
        os.path.realpath(p) for p in (moved, folder / "ne.gpkg")
    ]
    assert len(files_of(str(country))) == 3 and files_of(str(moved)) == [str(moved)]


def test_no_output_takes_the_place_of_a_part(folder, run_algorithm):
    for target in ("se.gpkg", "country.semrefset"):
        parameters = {"DATABASE": set_of(folder), "OUTPUT": str(folder / target), "TRIALS": 20}
        with pytest.raises(QgsProcessingException, match="Reference database"):
            run_algorithm("semref:assessdatabase", parameters)


def test_the_dock_reads_a_set_anew_when_one_of_its_databases_changed(folder):
    from semref.ui.running.background import DatabaseShelf

    shelf, country = DatabaseShelf(), set_of(folder)
    first = shelf.read(country)
    assert shelf.read(country) is first
    os.utime(folder / "se.gpkg", (1, 1))
    assert shelf.read(country) is not first
