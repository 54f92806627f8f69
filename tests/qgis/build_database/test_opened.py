"""A database that is opened when it is built: by QGIS's own way to load outputs, and only where somebody wants it."""

from __future__ import annotations

import shutil

import pytest
from built_database import BUILD, MINIMUM_AREA, SIZE, STRIDE
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingFeedback, QgsProject


@pytest.fixture
def project(qgis_app):
    yield QgsProject.instance()
    QgsProject.instance().clear()


@pytest.fixture
def run_as_dialog(project):
    """`run_as_dialog(id, parameters)` runs and loads as QGIS's dialogs do; gives the results."""
    from processing.gui.Postprocessing import handleAlgorithmResults

    def run(name: str, parameters: dict) -> dict:
        algorithm = QgsApplication.processingRegistry().createAlgorithmById(name)
        context, feedback = QgsProcessingContext(), QgsProcessingFeedback()
        context.setProject(project)
        results, succeeded = algorithm.run(parameters, context, feedback)
        assert succeeded, feedback.textLog()
        assert handleAlgorithmResults(algorithm, context, feedback), feedback.textLog()
        return results

    return run


def build_parameters(label_map, target, **more) -> dict:
    sizes = {"WINDOW_SIZE": SIZE, "STRIDE": STRIDE, "MINIMUM_AREA": MINIMUM_AREA}
    return {"LABELS": str(label_map), "REFERENCE_CLASSES": "building", **sizes, "DATABASE": str(target), **more}


def groups(project) -> list:
    """(name of the group, names of its layers) from top to bottom; a layer outside of groups stands alone."""
    return [(n.name(), [c.name() for c in n.children()]) for n in project.layerTreeRoot().children()]


def test_a_database_is_opened_as_a_styled_group(run_as_dialog, project, label_map, tmp_path):
    from semref.processing.exchange.database_layers import OPENED

    told = []
    OPENED.database.connect(told.append)
    run_as_dialog(BUILD, build_parameters(label_map, tmp_path / "area.gpkg", OPEN_OUTPUT=True))
    OPENED.database.disconnect(told.append)
    assert groups(project) == [("area", ["Landmarks", "Windows", "Overview"])]
    assert told == [str(tmp_path / "area.gpkg")]
    landmarks = project.mapLayersByName("Landmarks")[0]
    assert landmarks.renderer().type() == "categorizedSymbol"


def test_nothing_is_opened_where_nobody_asks_for_it(run_as_dialog, project, label_map, tmp_path):
    run_as_dialog(BUILD, build_parameters(label_map, tmp_path / "area.gpkg"))
    assert project.mapLayers() == {}


def test_a_script_that_runs_an_algorithm_gets_no_layers(run_algorithm, project, label_map, tmp_path):
    run_algorithm(BUILD, build_parameters(label_map, tmp_path / "area.gpkg", OPEN_OUTPUT=True))
    assert project.mapLayers() == {}


def test_a_database_that_is_replaced_is_shown_once_with_what_it_holds_now(run_as_dialog, project, label_map, tmp_path):
    more = {"REFERENCE_CLASSES": "building;water;bare_land", "OPEN_OUTPUT": True}
    built = run_as_dialog(BUILD, {**build_parameters(label_map, tmp_path / "area.gpkg"), **more})
    landmarks = project.mapLayersByName("Landmarks")[0]
    before = landmarks.featureCount()
    assert before == built["REFERENCE_COUNT"]
    built = run_as_dialog(BUILD, build_parameters(label_map, tmp_path / "area.gpkg", OPEN_OUTPUT=True))
    assert groups(project) == [("area", ["Landmarks", "Windows", "Overview"])]
    shown = project.mapLayersByName("Landmarks")[0]
    assert 0 < len(list(shown.getFeatures())) == built["REFERENCE_COUNT"] < before


def test_an_updated_database_is_opened_likewise(run_as_dialog, project, label_map, database, tmp_path):
    copy = tmp_path / "updated.gpkg"
    shutil.copy(database, copy)
    run_as_dialog(
        "semref:updatedatabase",
        {"DATABASE": str(copy), "LABELS": str(label_map), "OUTPUT": str(copy), "OPEN_OUTPUT": True},
    )
    assert groups(project) == [("updated", ["Landmarks", "Windows", "Overview"])]
