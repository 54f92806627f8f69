import shutil

import pytest
from built_database import BUILD, MINIMUM_AREA, SIZE, STRIDE
from made_inputs import square, write_layer
from qgis.core import (
    QgsApplication,
    QgsLayerTreeRegistryBridge,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingOutputLayerDefinition,
    QgsProject,
    QgsRasterLayer,
)

from semref.processing.layers.database_layers import OPENED


@pytest.fixture
def project(qgis_app):
    yield QgsProject.instance()
    # Before the group is deleted.
    add_layers_to(QgsProject.instance().layerTreeRoot())
    QgsProject.instance().clear()


def add_layers_to(group) -> None:
    """Make QGIS add new layers to a group, as if a layer of it were selected."""
    point = QgsLayerTreeRegistryBridge.InsertionPoint(group, 0)
    QgsProject.instance().layerTreeRegistryBridge().setLayerInsertionPoint(point)


@pytest.fixture
def run_as_dialog(project):
    """`run_as_dialog(id, parameters)` runs and loads as QGIS's dialogs do; returns the results."""
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
    """Return (name of the group, names of its layers) from top to bottom; a layer outside of groups is listed
    separately."""
    return [(n.name(), [c.name() for c in n.children()]) for n in project.layerTreeRoot().children()]


def test_a_database_is_opened_as_a_styled_group_but_by_no_script(
    run_algorithm, project, label_map, tmp_path, run_as_dialog
):
    run_algorithm(BUILD, build_parameters(label_map, tmp_path / "script.gpkg", OPEN_OUTPUT=True))
    assert project.mapLayers() == {}
    told = []
    OPENED.database.connect(told.append)
    run_as_dialog(BUILD, build_parameters(label_map, tmp_path / "area.gpkg", OPEN_OUTPUT=True))
    OPENED.database.disconnect(told.append)
    assert groups(project) == [("area", ["Landmarks", "Windows", "Overview"])]
    assert told == [str(tmp_path / "area.gpkg")]
    landmarks = project.mapLayersByName("Landmarks")[0]
    assert landmarks.renderer().type() == "categorizedSymbol"


def test_a_replaced_database_is_shown_once_with_its_new_content(run_as_dialog, project, label_map, tmp_path):
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
    given = {"DATABASE": str(copy), "LABELS": str(label_map), "OUTPUT": str(copy), "OPEN_OUTPUT": True}
    run_as_dialog("semref:updatedatabase", given)
    assert groups(project) == [("updated", ["Landmarks", "Windows", "Overview"])]


def opened(path) -> QgsProcessingOutputLayerDefinition:
    return QgsProcessingOutputLayerDefinition(str(path), QgsProject.instance())


def visible(project) -> list:
    """Return the names of the visible layers, from top to bottom, with their groups."""
    nodes = [node for node in project.layerTreeRoot().findLayers() if node.isVisible()]
    return ["/".join(filter(None, (node.parent().name(), node.name()))) for node in nodes]


def test_each_database_has_its_own_group_above_its_label_map(run_as_dialog, project, tmp_path):
    features = [(square(70 * (n % 5), 70 * (n // 5) + 3 * n % 17, 12), "building") for n in range(25)]
    given = {"INPUT": str(write_layer(tmp_path / "annotation.gpkg", features)), "CLASS_FIELD": "class"}
    given |= {"REFERENCE_CLASSES": "building", "WINDOW_SIZE": 200, "STRIDE": 50}

    def make_database(name):
        outputs = {"rasterize:Label map": opened(tmp_path / f"{name}.tif")}
        outputs["build:Reference database"] = str(tmp_path / f"{name}.gpkg")
        run_as_dialog("semref:annotationtodatabase", {**given, **outputs})

    make_database("first")
    content, label_map = ["Landmarks", "Windows", "Overview"], ("Label map", [])
    assert groups(project) == [("first", content), label_map]
    assert visible(project) == ["first/Landmarks", "Label map"]
    add_layers_to(project.layerTreeRoot().children()[0])
    make_database("second")
    assert groups(project) == [("second", content), ("first", content), label_map, label_map]


def test_a_new_label_map_is_below_the_users_layers_and_above_map_tiles(run_as_dialog, project, label_map, tmp_path):
    run_as_dialog(BUILD, build_parameters(label_map, tmp_path / "area.gpkg", OPEN_OUTPUT=True))
    root = project.layerTreeRoot()
    tiles = QgsRasterLayer("type=xyz&url=http://localhost/{z}/{x}/{y}.png", "tiles", "wms")
    for layer in (tiles, QgsRasterLayer(str(label_map), "orthophoto")):
        project.addMapLayer(layer, False)
        root.insertLayer(1, layer)
    for number in range(2):
        add_layers_to(project.layerTreeRoot().children()[0])
        polygons = write_layer(tmp_path / f"{number}.gpkg", [(square(10, 10, 5), "building")])
        rasterized = {"INPUT": str(polygons), "CLASS_FIELD": "class", "OUTPUT": opened(tmp_path / f"{number}.tif")}
        run_as_dialog("semref:rasterizeannotation", rasterized)
        names = [name for name, _ in groups(project)]
        assert names == ["area", "orthophoto", *["Label map"] * (number + 1), "tiles"]
