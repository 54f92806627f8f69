"""Python, a background task, the shipped model and qgis_process of the zip give the same label map and database."""

import contextlib
import re
import sqlite3
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from desktop_qgis import install_package
from made_inputs import CLASSES_CSV, read_pixels, square, write_layer, write_raster, write_text
from osgeo import gdal, ogr
from qgis.core import (
    QgsApplication,
    QgsProcessingAlgRunnerTask,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingModelAlgorithm,
)

pytestmark = pytest.mark.slow

TIMEOUT_S = 600
MOMENTS = {"last_change", "update_time", "timestamp"}
"""Columns with the time of writing."""

RASTERIZE, BUILD, LOCALIZE = "semref:rasterizeannotation", "semref:builddatabase", "semref:localizeimages"


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    """Return a folder with overlapping polygons of 400 × 400 m, their class table, and two images."""
    folder = tmp_path_factory.mktemp("inputs")
    random = np.random.default_rng(9)
    features = [(square(0, 0, 400), "field", 0)]
    for _ in range(150):
        column, row = random.uniform(0, 380, 2)
        name = ("building", "water", "bare_land")[random.integers(3)]
        features.append((square(column, row, random.uniform(8, 20)), name, int(random.integers(1, 9))))
    write_layer(
        folder / "annotation.shp", features, [("class", "text"), ("zorder", "integer")], geometry=ogr.wkbPolygon
    )
    write_text(folder / "classes.csv", CLASSES_CSV)
    return folder


@pytest.fixture(scope="module")
def settings(inputs):
    """Return parameters of rasterizing, building and localizing as text, as for qgis_process."""
    rasterize = {"INPUT": str(inputs / "annotation.shp"), "CLASS_TABLE": str(inputs / "classes.csv")}
    rasterize |= {"CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder", "PIXEL_SIZE": "1"}
    build = {"REFERENCE_CLASSES": "building;water", "WINDOW_SIZE": "150", "STRIDE": "50", "MINIMUM_AREA": "60"}
    return rasterize, build, {"METHOD": "1"}


@pytest.fixture(scope="module")
def expected(run_algorithm, inputs, settings, tmp_path_factory):
    """Return the paths of label map, database, images and positions made by processing.run."""
    return run_chain(run_algorithm, settings, tmp_path_factory.mktemp("python"), inputs)


def run_chain(run, settings, folder: Path, inputs: Path) -> dict:
    rasterize, build, localize = settings
    names = {"labels": "labels.tif", "database": "area.gpkg", "positions": "positions.gpkg"}
    made = {key: str(folder / name) for key, name in names.items()}
    run(RASTERIZE, {**rasterize, "OUTPUT": made["labels"]})
    run(BUILD, {**build, "LABELS": made["labels"], "DATABASE": made["database"]})
    images = [inputs / "a.png", inputs / "b.png"]
    if not images[0].exists():
        labels = read_pixels(made["labels"])
        write_raster(images[0], labels[100:250, 50:200], transform=None)
        write_raster(images[1], np.rot90(labels[20:170, 130:280]), transform=None)
    localize = {**localize, "DATABASE": made["database"], "IMAGES": ";".join(map(str, images))}
    run(LOCALIZE, {**localize, "OUTPUT": made["positions"]})
    return made


def tables(path: str) -> dict:
    """Return every row of every table of a GeoPackage, without spatial indexes and times of writing."""
    with contextlib.closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as connection:
        names = [row[0] for row in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")]
        found = {}
        for name in sorted(name for name in names if not name.startswith("rtree_")):
            columns = [row[1] for row in connection.execute(f'PRAGMA table_info("{name}")') if row[1] not in MOMENTS]
            listed = ", ".join(f'"{column}"' for column in columns)
            rows = connection.execute(f'SELECT {listed} FROM "{name}"').fetchall()
            found[name] = [tuple(map(canonical, row)) for row in rows]
        return found


def canonical(cell):
    """Return styles and metadata of layers, with their XML attributes in order and without what differs each time.

    That is ids and keys of rules, which Qt and QGIS make up, and the call with its time and paths, which made a layer.
    """
    if isinstance(cell, str) and cell.startswith(("<!DOCTYPE qgis", "<?xml")):
        text = re.sub(r'(id|key)="\{[0-9a-f-]+\}"', "", ElementTree.canonicalize(cell))
        # The line of a callout is XML inside an attribute, again in any order.
        text = re.sub(r'value="&lt;symbol[^"]*"', "", text)
        # QGIS gives profiles a random color.
        return re.sub("<history>.*?</history>|<elevation.*?</elevation>", "", text, flags=re.DOTALL)
    return cell


def assert_same(made: dict, expected: dict) -> None:
    labels, others = gdal.Open(made["labels"]), gdal.Open(expected["labels"])
    np.testing.assert_array_equal(labels.ReadAsArray(), others.ReadAsArray())
    assert labels.GetGeoTransform() == others.GetGeoTransform()
    assert labels.GetProjection() == others.GetProjection()
    assert labels.GetMetadata() == others.GetMetadata()
    for path in ("database", "positions"):
        if path in made:
            found, wanted = tables(made[path]), tables(expected[path])
            assert list(found) == list(wanted)
            for name, rows in wanted.items():
                assert found[name] == rows, name


def test_what_is_compared_has_content(expected):
    assert len(np.unique(read_pixels(expected["labels"]))) == 4
    content = tables(expected["database"])
    assert len(content["windows"]) == 36
    assert len(content["references"]) > 20 and len(content["overview"]) >= 1 and len(content["layer_styles"]) >= 2
    statuses = [row[3] for row in tables(expected["positions"])["positions"]]
    assert statuses == ["fix", "fix"]


def test_a_background_task_as_of_toolbox_and_batch_gives_the_same(qgis_app, inputs, settings, expected, tmp_path):
    def run(algorithm_id, parameters):
        algorithm = QgsApplication.processingRegistry().createAlgorithmById(algorithm_id)
        context, feedback, ended = QgsProcessingContext(), QgsProcessingFeedback(False), []
        task = QgsProcessingAlgRunnerTask(algorithm, parameters, context, feedback)
        task.executed.connect(lambda succeeded, results: ended.append(succeeded))
        QgsApplication.taskManager().addTask(task)
        assert task.waitForFinished(TIMEOUT_S * 1000)
        while not ended:
            qgis_app.processEvents()
        assert ended == [True], feedback.textLog()

    assert_same(run_chain(run, settings, tmp_path, inputs), expected)


def test_the_shipped_model_gives_the_same_database(qgis_app, repository, settings, expected, tmp_path):
    path = repository / "models" / "annotation_to_database.model3"
    model = QgsProcessingModelAlgorithm()
    assert model.fromFile(str(path))
    rasterize, build, _ = settings
    parameters = {**rasterize, **build}
    for definition in model.destinationParameterDefinitions():
        suffix = "gpkg" if "DATABASE" in definition.name().upper() else "tif"
        parameters[definition.name()] = str(tmp_path / f"model.{suffix}")
    results, succeeded = model.run(parameters, QgsProcessingContext(), QgsProcessingFeedback(False), {}, False)
    assert succeeded
    assert tables(str(tmp_path / "model.gpkg")) == tables(expected["database"])


@pytest.fixture(scope="module")
def qgis_process(repository, start_qgis_process):
    return start_qgis_process(lambda plugins: install_package(repository, plugins))


def test_qgis_process_gives_the_same(qgis_process, inputs, settings, expected, tmp_path):
    def run(algorithm, parameters):
        qgis_process("run", algorithm, "--", *(f"{key}={value}" for key, value in parameters.items()))

    assert_same(run_chain(run, settings, tmp_path, inputs), expected)


@pytest.mark.parametrize("name", ["builddatabase", "classtable", "annotationtodatabase"])
def test_qgis_process_prints_help_without_html(qgis_process, name):
    text = qgis_process("help", f"semref:{name}")
    assert "Description" in text and not re.search("<(p|h[1-6]|br|i|b)>|&(amp|lt|gt|quot);", text)
