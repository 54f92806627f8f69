"""Outputs never destroy files of users: planted folders, links, other users' files, kills, foreign files."""

import json
import os
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
from contextlib import closing
from pathlib import Path

import pytest
from bad_input import WINDOWS
from made_inputs import square, write_layer, write_older, write_text
from osgeo import gdal
from qgis.core import QgsProcessingContext, QgsProcessingException, QgsProject, QgsRasterLayer, QgsVectorLayer

from semref.core.errors import ParameterError
from semref.storage.atomic_output import Batch
from semref.storage.replaceable import MARK_OF_NOTE

LOCALIZE, RASTERIZE, BUILD = "semref:localizeimages", "semref:rasterizeannotation", "semref:builddatabase"


@pytest.fixture
def project():
    return QgsProject()


def content(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes() if not path.is_symlink() else os.readlink(path).encode()
        for path in sorted(folder.rglob("*"))
        if path.is_symlink() or path.is_file()
    }


@pytest.fixture
def refuse_replacing(monkeypatch):
    """`refuse_replacing(path, …)` refuses to replace that path, except by a file from an ``.older`` folder if asked."""
    replace = os.replace

    def refuse(path: Path, but_older: bool = False) -> None:
        def run(source, target):
            if Path(target) == path and not (but_older and ".older" in str(source)):
                raise PermissionError(13, "Permission denied", str(target))
            replace(source, target)

        monkeypatch.setattr(os, "replace", run)

    return refuse


def localize(run_algorithm, given: Path, output: object, **more: object) -> None:
    parameters = {"DATABASE": given / "area.gpkg", "IMAGES": [given / "photo.png"], "METHOD": 1}
    run_algorithm(LOCALIZE, {**parameters, "OUTPUT": output, **more})


def annotation(folder: Path, name: str = "landcover.shp") -> Path:
    features = [(square(0, 0, 100), "field"), (square(10, 10, 20), "building")]
    return write_layer(folder / name, features, [("class", "text")])


def rasterize(run_algorithm, layer: Path, output: object, **more: object) -> None:
    run_algorithm(RASTERIZE, {"INPUT": layer, "CLASS_FIELD": "class", "PIXEL_SIZE": 1, "OUTPUT": output, **more})


def reads(path: Path, sql: str) -> list:
    with closing(sqlite3.connect(path)) as connection:
        return connection.execute(sql).fetchall()


# --- planted files ---


def plant(folder: Path, name: str, moves: list) -> None:
    """Create a folder like that of a run that died, with a plan of files to move."""
    planted = folder / name
    (planted / ".older").mkdir(parents=True)
    for mark in (".lock", ".moving"):
        (planted / mark).touch()
    (planted / ".older" / "run.sh").write_text("evil")
    (planted / ".moves").write_text(json.dumps({"workplaces": [os.path.realpath(planted)], "moves": moves}))


def test_planted_folders_of_dead_runs_change_nothing_beside_inputs_and_outputs(run_algorithm, given, tmp_path):
    """Such a plan once removed “photos” and replaced “run.sh” when an image beside it was read."""
    out = tmp_path / "out"
    for folder in (given, out):
        (folder / "photos").mkdir(parents=True)
        (folder / "photos" / "1.jpg").write_text("mine")
        (folder / "run.sh").write_text("mine")
        for name in (".x.part", ".semref-positions-abcd.part"):
            plant(folder, name, [["photos", None, None, False, True], ["run.sh", None, None, True, True]])
        # A run that died before it had a lock.
        (folder / ".empty.part").mkdir()
    before = content(given), content(out)
    localize(run_algorithm, given, out / "positions.gpkg")
    after = content(out)
    assert after.pop("positions.gpkg") and (content(given), after) == before
    assert (given / ".empty.part").is_dir() and (out / ".empty.part").is_dir()


@pytest.mark.parametrize("name", ["fixes.gpkg", "labels.tif"])
def test_a_link_of_the_outputs_name_is_replaced_and_not_followed(run_algorithm, given, tmp_path, name):
    real = tmp_path / "real" / name
    real.parent.mkdir()
    before = write_older(real)
    (tmp_path / name).symlink_to(real)
    if name == "fixes.gpkg":
        localize(run_algorithm, given, tmp_path / name)
    else:
        rasterize(run_algorithm, annotation(given), tmp_path / name)
    assert real.read_bytes() == before
    assert not (tmp_path / name).is_symlink() and (tmp_path / name).stat().st_size > len(before)


def test_a_linked_folder_is_not_filled(run_algorithm, given, tmp_path):
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "labels").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(QgsProcessingException, match="a link; choose a folder"):
        localize(run_algorithm, given, "memory:", LABELS=tmp_path / "labels")
    assert list((tmp_path / "elsewhere").iterdir()) == []


def test_a_fifo_of_the_outputs_name_is_refused_and_not_waited_for(run_algorithm, given, tmp_path):
    os.mkfifo(tmp_path / "fixes.gpkg")
    with pytest.raises(QgsProcessingException, match="another kind of file"):
        localize(run_algorithm, given, tmp_path / "fixes.gpkg")
    assert (tmp_path / "fixes.gpkg").is_fifo()


def test_a_private_folder_that_others_swapped_is_neither_used_nor_emptied(tmp_path):
    """A user who can write to a shared folder can rename its content."""
    target, photos = tmp_path / "fixes.csv", tmp_path / "photos"
    photos.mkdir()
    (photos / "1.jpg").write_text("mine")
    with Batch() as batch, pytest.raises(ParameterError, match="changed by another program"):
        made = Path(batch.file(str(target)))
        made.write_text("new")
        made.parent.rename(tmp_path / "away")
        photos.rename(made.parent)
        batch.commit()
    assert (made.parent / "1.jpg").read_text() == "mine" and not target.exists()


AS_ANOTHER_USER = """
import os, sys
sys.path.insert(0, {tests!r})
import conftest
from semref.core.errors import SemRefError
from semref.storage.atomic_output import Batch
os.setgid(65534); os.setuid(65534)
for name in ("theirs.csv", "own.csv"):
    try:
        with Batch() as batch:
            path = batch.file(os.path.join({folder!r}, name))
            open(path, "w").write("new")
            batch.commit()
        print("written")
    except SemRefError as error:
        print(error)
"""


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root can be two users")
def test_another_users_file_in_a_shared_folder_stays_whatever_is_planted(tmp_path):
    """Such a plan once made another user's SemRef replace files that the sticky bit protects."""
    # Not in TMPDIR, which other users may not be able to read.
    shared = Path(tempfile.mkdtemp(prefix="semref-shared-", dir="/tmp"))
    try:
        shared.chmod(0o1777)
        (shared / "theirs.csv").write_text("theirs")
        plant(shared, ".x.part", [["theirs.csv", None, None, True, False]])
        program = AS_ANOTHER_USER.format(tests=str(Path(__file__).parents[1]), folder=str(shared))
        before = content(shared)
        found = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, cwd="/")
        lines = found.stdout.splitlines()
        assert len(lines) == 2 and "can't be replaced" in lines[0] and lines[1] == "written", found.stderr
        after = content(shared)
        assert after.pop("own.csv") == b"new" and after == before
        # The owner's next run in that folder follows no plan either.
        with Batch() as batch:
            Path(batch.file(str(shared / "mine.csv"))).write_text("new")
            batch.commit()
        assert (shared / "own.csv").read_text() == "new" and (shared / "theirs.csv").read_text() == "theirs"
    finally:
        shutil.rmtree(shared)


# --- kills ---


NEW = b"II*\0new"


def die_at(count: int, work) -> bool:
    """Return whether a child was killed before it touched a file for the ``count``-th time."""
    child = os.fork()
    if child == 0:
        done = 0

        def look(event: str, _: tuple) -> None:
            nonlocal done
            if event in ("os.rename", "os.mkdir", "os.remove", "open", "os.rmdir", "tempfile.mkdtemp"):
                if done == count:
                    os.kill(os.getpid(), signal.SIGKILL)
                done += 1

        sys.addaudithook(look)
        try:
            work()
        finally:
            os._exit(0)
    return os.WIFSIGNALED(os.waitpid(child, 0)[1])


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
@pytest.mark.parametrize("with_older", [True, False])
def test_a_kill_at_any_moment_leaves_each_output_whole_and_the_next_run_works(tmp_path, monkeypatch, with_older):
    # Flushing to disk matters only for a power cut, and it takes most of the time.
    monkeypatch.setattr(os, "fsync", lambda _: None)
    names = ("a.tif", "a.tif.aux.xml", "b.csv")

    def write() -> None:
        with Batch() as batch:
            raster = Path(batch.file(str(folder / "a.tif")))
            raster.write_bytes(NEW)
            Path(f"{raster}.aux.xml").write_bytes(NEW)
            Path(batch.file(str(folder / "b.csv"))).write_bytes(NEW.replace(b"II*", b"csv"))
            batch.commit()

    seen = set()
    for count in range(200):
        folder = tmp_path / str(count)
        folder.mkdir()
        for name in names if with_older else ():
            (folder / name).write_bytes(b"csv older" if name == "b.csv" else b"II*\0older")
        was_killed = die_at(count, write)
        found = tuple((folder / n).read_bytes()[4:] if (folder / n).exists() else None for n in ("a.tif", "b.csv"))
        seen.add(found)
        left = [name for name in content(folder) if name.startswith(".")]
        write()
        assert [(folder / name).read_bytes()[4:] for name in names] == [b"new"] * 3
        # Files of a dead run are not used.
        assert [name for name in content(folder) if name.startswith(".")] == left
        if not was_killed:
            break
    # Outputs of one run may differ in age.
    older = b"older" if with_older else None
    assert seen == {(older, older), (b"new", older), (b"new", b"new")} and count > 10


@pytest.mark.parametrize("name", ["a.shp", "a.dbf", "a.prj"])
def test_parts_of_a_file_go_back_when_one_cant_be_replaced(tmp_path, refuse_replacing, name):
    for end in ("shp", "dbf"):
        (tmp_path / f"a.{end}").write_bytes(b"\0\0\x27\x0aold")
    before = content(tmp_path)
    refuse_replacing(tmp_path / name, but_older=True)
    with Batch() as batch, pytest.raises(ParameterError, match="can't be replaced"):
        made = Path(batch.file(str(tmp_path / "a.shp")))
        for end in ("shp", "dbf", "prj"):
            made.with_suffix(f".{end}").write_bytes(b"new")
        batch.commit()
    assert content(tmp_path) == before


@pytest.mark.parametrize("is_folder", [False, True])
def test_older_files_that_cant_be_renamed_back_are_not_deleted(tmp_path, refuse_replacing, is_folder):
    refused = tmp_path / ("a" if is_folder else "a.dbf")
    folder = refused if is_folder else tmp_path
    folder.mkdir(exist_ok=True)
    for end in ("shp", "dbf"):
        (folder / f"a.{end}").write_bytes(b"\0\0\x27\x0aold" + end.encode())
    refuse_replacing(refused)
    with Batch() as batch, pytest.raises(ParameterError, match=r"They are in .*\.older"):
        made = Path(batch.folder(str(folder), replaces=True) if is_folder else batch.file(str(tmp_path / "a.shp")))
        for end in ("shp", "dbf"):
            (made / "a" if is_folder else made).with_suffix(f".{end}").write_bytes(b"new")
        batch.commit()
    left = {path.read_bytes()[4:] for path in tmp_path.rglob("a.*") if path.is_file()}
    assert {b"oldshp", b"olddbf"} <= left


# --- existing files of the same name ---


def writers(folder: Path) -> dict[str, tuple[str, dict, str]]:
    """Return algorithm, parameters and key of one output of each kind."""
    area, labels, photo = (str(folder / name) for name in ("area.gpkg", "labels.tif", "photo.png"))
    of_class = {"INPUT": str(folder / "landcover.shp"), "CLASS_FIELD": "class"}
    return {
        "build": (BUILD, {"LABELS": labels, **WINDOWS}, "DATABASE"),
        "update": ("semref:updatedatabase", {"DATABASE": area, "LABELS": labels}, "OUTPUT"),
        "rasterize": (RASTERIZE, {**of_class, "PIXEL_SIZE": 1}, "OUTPUT"),
        "localize": (LOCALIZE, {"DATABASE": area, "IMAGES": [photo], "METHOD": 1}, "OUTPUT"),
        "report": ("semref:checkannotation", {**of_class, "ISSUES": "memory:"}, "REPORT"),
        "onboard": ("semref:exportonboard", {"DATABASE": area}, "OUTPUT"),
        "table": ("semref:classtable", of_class, "OUTPUT"),
    }


def require_kept(target, writer, run_algorithm, message="holds other layers|another kind of file"):
    before, (algorithm, parameters, key) = target.read_bytes(), writer
    with pytest.raises(QgsProcessingException, match=message):
        run_algorithm(algorithm, {**parameters, key: str(target)})
    assert target.read_bytes() == before


@pytest.mark.parametrize("writer", list(writers(Path())))
@pytest.mark.parametrize("layers", [("roads", "rivers"), ("roads", "target")])
def test_a_geopackage_of_the_user_is_never_replaced(run_algorithm, given, writer, layers):
    source, target = annotation(given), given / "target.gpkg"
    for name in layers:
        mode = {"accessMode": "update"} if target.exists() else {}
        gdal.VectorTranslate(str(target), str(source), format="GPKG", layerName=name, **mode)
    require_kept(target, writers(given)[writer], run_algorithm)


@pytest.mark.parametrize("writer", list(writers(Path())))
@pytest.mark.parametrize("name", ["photo.jpg", "run.sh", "area.gpkg", "labels.tif"])
def test_another_kind_of_file_is_never_replaced(run_algorithm, given, tmp_path, writer, name):
    annotation(given)
    target = tmp_path / name
    if name in ("area.gpkg", "labels.tif"):
        if writer in {"area.gpkg": ("build", "update"), "labels.tif": ("rasterize",)}[name]:
            pytest.skip("this is the same kind")
        shutil.copy(given / name, target)
    else:
        target.write_bytes({"photo.jpg": b"\xff\xd8\xff\xe0", "run.sh": b"#!/bin/sh"}[name] + b"mine")
    if writer == "localize" and name != "area.gpkg":
        # QGIS adds the suffix of a vector format, and that file may be foreign as well.
        shutil.copy(given / "area.gpkg", tmp_path / f"{name}.gpkg")
    require_kept(target, writers(given)[writer], run_algorithm)


@pytest.mark.slow
@pytest.mark.parametrize("writer", list(writers(Path())))
def test_an_older_output_of_the_same_kind_is_replaced(run_algorithm, given, tmp_path, writer):
    annotation(given)
    suffix = {"rasterize": "tif", "report": "html", "onboard": "npz", "table": "csv"}.get(writer, "gpkg")
    algorithm, parameters, key = writers(given)[writer]
    target, seen = tmp_path / f"target.{suffix}", []
    for _ in range(2):
        run_algorithm(algorithm, {**parameters, key: str(target)})
        seen.append(target.stat().st_ino)
    assert seen[0] != seen[1]


def test_a_database_to_which_the_user_added_a_layer_is_not_built_over(run_algorithm, given):
    area = given / "area.gpkg"
    added = {"format": "GPKG", "layerName": "my notes", "accessMode": "update"}
    gdal.VectorTranslate(str(area), str(annotation(given)), **added)
    require_kept(area, writers(given)["build"], run_algorithm, "holds other layers .my notes.")


@pytest.mark.parametrize("output", ["{}|layername=windows", "{}|layerid=0", "{}|LayerName=new"])
def test_a_layer_of_a_file_as_output_is_refused_with_the_reason(run_algorithm, given, output):
    """The message once named a full disk."""
    area = given / "area.gpkg"
    before = area.read_bytes()
    for writer in ("localize", "build", "rasterize"):
        annotation(given)
        algorithm, parameters, key = writers(given)[writer]
        with pytest.raises(QgsProcessingException, match="is a layer of a file. Select a file") as caught:
            run_algorithm(algorithm, {**parameters, key: output.format(area)})
        assert "disk" not in str(caught.value)
    assert area.read_bytes() == before


@pytest.mark.parametrize(
    ("writer", "name", "character"),
    [("localize", "12:30.gpkg", ":"), ("localize", "12:30.shp", ":"), ("localize", "(1).gpkg", "(")]
    + [("rasterize", "a.png", ".png")]
    + [(writer, f"a{text}b.gpkg", text) for writer in ("localize", "build") for text in ("|", "%20")],
)
def test_a_path_that_qgis_cannot_write_is_refused_before_the_work(run_algorithm, given, writer, name, character):
    """QGIS refused it when everything was computed."""
    annotation(given)
    algorithm, parameters, key = writers(given)[writer]
    with pytest.raises(QgsProcessingException, match=f"(because of the character|instead of) “{re.escape(character)}”"):
        run_algorithm(algorithm, {**parameters, key: str(given / name)})


@pytest.mark.parametrize(
    ("writer", "name"), [("localize", "(1).shp"), ("localize", "12-30 (1).gpkg"), ("build", "12:30.gpkg")]
)
def test_other_unusual_paths_are_written(run_algorithm, given, writer, name):
    algorithm, parameters, key = writers(given)[writer]
    run_algorithm(algorithm, {**parameters, key: str(given / name)})
    assert (given / name).stat().st_size > 0


# --- styles, metadata and what GDAL keeps beside a raster ---


def user_style(path: Path) -> None:
    """Save a style and metadata beside a layer, as QGIS does."""
    layer = QgsVectorLayer(str(path), "landcover", "ogr")
    layer.saveNamedStyle(str(path.with_suffix(".qml")))
    metadata = layer.metadata()
    metadata.setAbstract("mine")
    metadata.setHistory(["2026-01-01 10:00 UTC, SemRef 1.0: made of other things"])
    layer.setMetadata(metadata)
    layer.saveNamedMetadata(str(path.with_suffix(".qmd")))


def test_rasterizing_beside_the_annotation_leaves_its_style_and_metadata(run_algorithm, given, tmp_path):
    layer = annotation(tmp_path)
    user_style(layer)
    before = content(tmp_path)
    for _ in range(2):
        rasterize(run_algorithm, layer, tmp_path / "landcover.tif")
    after = content(tmp_path)
    assert {name: after[name] for name in before} == before
    # The map contains its classes and colors, so QGIS reads it correctly beside a foreign style.
    made = QgsRasterLayer(str(tmp_path / "landcover.tif"), "landcover")
    assert made.isValid() and made.renderer().type() == "paletted"


def test_a_label_map_gets_its_legend_when_loaded_though_the_style_beside_it_is_foreign(tmp_path, given, project):
    import processing

    layer = annotation(tmp_path)
    user_style(layer)
    context = QgsProcessingContext()
    context.setProject(project)
    target = str(tmp_path / "landcover.tif")
    details = QgsProcessingContext.LayerDetails("labels", project, "OUTPUT")
    context.addLayerToLoadOnCompletion(target, details)
    parameters = {"INPUT": str(layer), "CLASS_FIELD": "class", "PIXEL_SIZE": 1, "OUTPUT": target}
    processing.run(RASTERIZE, parameters, context=context)
    made = QgsRasterLayer(target, "landcover")
    context.layerToLoadOnCompletionDetails(target).postProcessor().postProcessLayer(made, context, None)
    assert [(c.value, c.label) for c in made.renderer().classes()] == [(1, "building"), (2, "field")]


def test_semrefs_own_style_and_metadata_are_written_again_until_the_user_saves_their_own(run_algorithm, tmp_path):
    layer, target = annotation(tmp_path, "classes.shp"), tmp_path / "labels.tif"
    rasterize(run_algorithm, layer, target)
    first = content(tmp_path)
    assert {"labels.qml", "labels.qmd"} <= set(first)
    for end in (".qml", ".qmd"):
        text = target.with_suffix(end).read_text(encoding="utf-8")
        target.with_suffix(end).write_text(text.replace("building", "changed").replace("SemRef", "changed", 1))
    write_text(target.with_suffix(".qml"), f"<qgis>{MARK_OF_NOTE}</qgis>")
    rasterize(run_algorithm, layer, target)
    assert target.with_suffix(".qml").read_bytes() == first["labels.qml"]
    # Files saved by QGIS are the user's.
    made = QgsRasterLayer(str(target), "labels")
    made.loadDefaultStyle()
    made.saveDefaultStyle()
    made.saveDefaultMetadata()
    saved = [target.with_suffix(end).read_bytes() for end in (".qml", ".qmd")]
    rasterize(run_algorithm, layer, target)
    assert [target.with_suffix(end).read_bytes() for end in (".qml", ".qmd")] == saved


def test_what_gdal_derived_from_the_older_raster_is_not_applied_to_the_newer_one(run_algorithm, tmp_path):
    layer, target = annotation(tmp_path, "classes.shp"), tmp_path / "labels.tif"
    rasterize(run_algorithm, layer, target)
    dataset = gdal.Open(str(target))
    dataset.BuildOverviews("NEAREST", [2, 4])
    del dataset
    aux = Path(f"{target}.aux.xml")
    aux.write_text('<PAMDataset><Metadata><MDI key="stale">yes</MDI></Metadata></PAMDataset>')
    assert Path(f"{target}.ovr").exists()
    rasterize(run_algorithm, layer, target)
    made = gdal.Open(str(target))
    assert made.GetRasterBand(1).GetOverviewCount() == 0 and not Path(f"{target}.ovr").exists()
    assert "stale" not in made.GetMetadata() and "stale" not in aux.read_text()


@pytest.mark.parametrize("name", ["labels.tif.ovr", "labels.tif.aux.xml", "labels.tif.msk"])
def test_a_side_car_without_its_raster_is_kept_and_refused(run_algorithm, tmp_path, name):
    layer = annotation(tmp_path, "classes.shp")
    write_text(tmp_path / name, "mine")
    with pytest.raises(QgsProcessingException, match=name):
        rasterize(run_algorithm, layer, tmp_path / "labels.tif")
    assert (tmp_path / name).read_text() == "mine" and not (tmp_path / "labels.tif").exists()


def test_a_table_beside_a_new_shapefile_is_not_taken_for_a_part_of_it(run_algorithm, given, tmp_path):
    write_text(tmp_path / "fixes.dbf", "mine")
    with pytest.raises(QgsProcessingException, match="fixes.dbf would be taken for a part of the new fixes.shp"):
        localize(run_algorithm, given, tmp_path / "fixes.shp")
    assert content(tmp_path / ".")["fixes.dbf"] == b"mine"


# --- GeoPackages in use ---


def test_changes_that_wait_beside_a_geopackage_are_not_applied_to_the_newer_one(run_algorithm, given, tmp_path):
    target = tmp_path / "fixes.gpkg"
    localize(run_algorithm, given, target)
    # A program that dies leaves its changes in the -wal file.
    child = os.fork()
    if child == 0:
        try:
            connection = sqlite3.connect(target, isolation_level=None)
            connection.execute("PRAGMA journal_mode=WAL")
            connection.execute("UPDATE gpkg_contents SET description = 'stale'")
        finally:
            os.kill(os.getpid(), signal.SIGKILL)
    os.waitpid(child, 0)
    assert Path(f"{target}-wal").stat().st_size > 0
    localize(run_algorithm, given, target)
    assert reads(target, "PRAGMA integrity_check") == [("ok",)]
    assert ("stale",) not in reads(target, "SELECT description FROM gpkg_contents")
    assert not Path(f"{target}-wal").exists()


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["DELETE", "WAL"])
def test_a_geopackage_that_another_program_writes_to_is_not_replaced(run_algorithm, given, tmp_path, mode):
    target = tmp_path / "fixes.gpkg"
    localize(run_algorithm, given, target)
    with closing(sqlite3.connect(target, isolation_level=None)) as connection:
        connection.execute(f"PRAGMA journal_mode={mode}")
        connection.execute("BEGIN IMMEDIATE")
        connection.execute("UPDATE gpkg_contents SET description = 'edited' WHERE table_name = 'fixes'")
        with pytest.raises(QgsProcessingException, match="open in this or another program"):
            localize(run_algorithm, given, target)
        connection.execute("COMMIT")
    assert ("edited",) in reads(target, "SELECT description FROM gpkg_contents")


def test_a_result_that_is_on_the_map_is_replaced(run_algorithm, given, tmp_path, project):
    """Users of QGIS run a tool again and again into the same file."""
    target = tmp_path / "fixes.gpkg"
    localize(run_algorithm, given, target)
    layer = QgsVectorLayer(str(target), "fixes", "ogr")
    project.addMapLayer(layer)
    assert len(list(layer.getFeatures())) == 1
    layer.saveStyleToDatabase("mine", "", False, "")
    before = target.stat().st_ino
    localize(run_algorithm, given, target)
    assert target.stat().st_ino != before
    project.removeAllMapLayers()


@pytest.mark.parametrize("is_new", [False, True])
def test_what_others_wrote_meanwhile_into_a_geopackage_that_gets_a_layer_is_not_lost(
    run_algorithm, given, monkeypatch, is_new
):
    theirs, shared = given / "theirs.gpkg", given / "shared.gpkg"
    gdal.VectorTranslate(str(theirs), str(annotation(given)), format="GPKG", layerName="roads")
    shutil.copy(theirs, shared)
    output = f"ogr:dbname='{shared}' table=\"fixes\" (geom)"
    localize(run_algorithm, given, output)
    assert {("fixes",), ("roads",)} <= set(reads(shared, "SELECT table_name FROM gpkg_contents"))
    commit = Batch.commit
    if is_new:
        shared.unlink()

    def late(self, *checks):
        if is_new:
            shutil.copy(theirs, shared)
        with closing(sqlite3.connect(shared)) as connection, connection:
            connection.execute("UPDATE gpkg_contents SET description = 'mine' WHERE table_name = 'roads'")
        commit(self, *checks)

    monkeypatch.setattr(Batch, "commit", late)
    with pytest.raises(QgsProcessingException, match="changed by another program"):
        localize(run_algorithm, given, output)
    assert ("mine",) in reads(shared, "SELECT description FROM gpkg_contents")
