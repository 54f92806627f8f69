from pathlib import Path

import numpy as np
import pytest
from made_inputs import NORTH, WEST, rectangle, square, write_layer, write_raster
from made_models import metadata, write_model
from qgis.core import QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtWidgets import QDialog

from semref.processing.inspection.models import choose_models_folder
from semref.processing.layers.guess_fields import class_field_of, class_of_all
from semref.ui.proposals import annotation_at_hand, training_at_hand


@pytest.fixture
def project(qgis_app):
    yield QgsProject.instance()
    QgsProject.instance().clear()


@pytest.fixture
def add(project, tmp_path):
    """`add(name, fields)` adds a layer with one polygon; `add.photo(name)`, `add.labels(name)` a raster."""

    def vector(name, fields):
        value = {"text": "building", "integer": 7}
        feature = (square(10, 10, 5), *(value[kind] for _, kind in fields))
        layer = QgsVectorLayer(str(write_layer(tmp_path / f"{name}.gpkg", [feature], fields)), name, "ogr")
        return project.addMapLayer(layer)

    def raster(name, pixels):
        return project.addMapLayer(QgsRasterLayer(str(write_raster(tmp_path / f"{name}.tif", pixels)), name))

    vector.photo = lambda name: raster(name, np.full((3, 20, 20), 9, np.uint8))
    vector.labels = lambda name: raster(name, np.ones((20, 20), np.uint8))
    return vector


def test_the_only_polygons_and_the_only_photo_are_taken_with_their_fields_and_table(add, project, tmp_path):
    (tmp_path / "classes.csv").write_text("value,name,color,role\n1,building,#ff0000,reference\n")
    layer = add("cover", [("number", "integer"), ("name", "text"), ("Class", "text"), ("zorder", "integer")])
    photo = add.photo("orthophoto")
    add.labels("label map")
    table = str(tmp_path / "classes.csv")
    fields = {"CLASS_FIELD": "Class", "PRIORITY_FIELD": "zorder", "CLASS_TABLE": table}
    found = training_at_hand(project)
    assert found.pop("OUTPUT").endswith("orthophoto.onnx") and found.pop("UNLABELED") == 1
    # The plugin's model has the class, so training continues from it.
    assert found.pop("BASE_MODEL").endswith("buildings.onnx")
    assert found == {"IMAGE": photo.id(), "INPUT": layer.id(), **fields}


def test_of_several_layers_the_one_with_classes_is_taken_and_none_where_it_could_be_several(add, project):
    add("parcels", [("owner", "text")])
    layer = add("cover", [("class", "text")])
    assert annotation_at_hand(project) == {"INPUT": layer.id(), "CLASS_FIELD": "class"}
    add("south", [("class", "text")])
    for name in ("north_photo", "south_photo"):
        add.photo(name)
    assert list(training_at_hand(project)) == ["OUTPUT"]


@pytest.fixture
def models(tmp_path, qgis_app):
    """`models(name, **metadata)` puts a model that SemRef trained into the folder of models; gives its path."""
    folder = tmp_path / "models"
    folder.mkdir()
    choose_models_folder(str(folder))

    def write(name, **about):
        return str(write_model(folder / name, metadata=metadata(**{"architecture": {"encoder": "lite0"}, **about})))

    yield write
    choose_models_folder("")


def test_a_model_of_another_area_with_the_same_classes_is_the_base(add, project, models):
    add("cover", [("class", "text")])
    add.photo("orthophoto")
    houses = models("houses.onnx", class_names={"0": "other", "1": "Building"})
    models("water.onnx", class_names={"0": "other", "1": "water"})
    models("foreign.onnx", class_names={"0": "other", "1": "building"}, architecture=None)
    here = {"image": "orthophoto", "labels": "cover"}
    models("same_ground.onnx", class_names={"0": "other", "1": "building"}, training_ground=here)
    assert training_at_hand(project)["BASE_MODEL"] == houses
    # Of two only the dock's is one that somebody chose; without it, the plugin's is taken.
    other = models("other_houses.onnx", class_names={"0": "other", "1": "building"})
    assert training_at_hand(project)["BASE_MODEL"].endswith("buildings.onnx")
    assert training_at_hand(project, other)["BASE_MODEL"] == other


def test_the_layers_of_a_database_are_no_annotation(area, dock, project):
    dock.content.database.file.setFilePath(area.database)
    dock.content.database.add_to_map.click()
    assert annotation_at_hand(project) == {}


def test_the_dock_makes_a_database_of_the_polygons_at_hand(dock, add, monkeypatch):
    import processing

    asked = []
    monkeypatch.setattr(processing, "createAlgorithmDialog", lambda *given: asked.append(given) or QDialog())
    layer = add("cover", [("class", "text")])
    dock.content.database.make.click()
    assert dock.content.database.making.isVisible()
    assert asked == [("semref:annotationtodatabase", {"INPUT": layer.id(), "CLASS_FIELD": "class"})]
    dock.content.database.making.close()


def test_a_new_model_is_a_file_of_the_models_folder_that_no_model_has(add, project, models):
    add.photo("orthophoto")
    folder = Path(models("orthophoto.onnx")).parent
    assert training_at_hand(project)["OUTPUT"] == str(folder / "orthophoto_2.onnx")


def test_the_resolution_is_proposed_from_the_smallest_typical_building(project, tmp_path):
    fine = (WEST, 0.1, 0, NORTH, 0, -0.1)
    file = write_raster(tmp_path / "orthophoto.tif", np.full((3, 20, 20), 9, np.uint8), transform=fine)
    # One shed in twenty does not count; 3.6 m in 14 pixels.
    widths = [1.0, *[3.6] * 5, *[12.0] * 14]
    rows = [(rectangle(30 * n, 0, width, 2 * width), "building") for n, width in enumerate(widths)]
    layer = QgsVectorLayer(str(write_layer(tmp_path / "cover.gpkg", rows)), "cover", "ogr")
    project.addMapLayers([QgsRasterLayer(str(file), "orthophoto"), layer])
    assert training_at_hand(project)["RESOLUTION"] == 25


def test_the_box_of_photos_begins_with_no_label_map_and_is_empty_when_unsure(add, project, open_dialog):
    add.labels("label map")

    def chosen():
        return open_dialog("trainmodel", {}).mainWidget().wrappers["IMAGE"].parameterValue()

    assert not chosen()
    photo = add.photo("orthophoto")
    assert chosen() == photo.id()
    add.photo("another")
    assert not chosen()


@pytest.fixture
def guess(qgis_app):
    """`guess(path, name)` gives (class field, class of all polygons) of a layer."""

    def of(path, name: str = "") -> tuple[str, str]:
        layer = QgsVectorLayer(str(path), name or Path(str(path).split("|")[0]).stem, "ogr")
        assert layer.isValid()
        return class_field_of(layer), class_of_all(layer)

    return of


REAL = {
    "berlin_urban_gradient/LandCov_BerlinUrbanGradient.shp": ("Level_2", ""),
    "osm_liechtenstein_2021/li_landcover_2021.shp": ("class", ""),
    "osm_belgrade/natural.shp": ("type", ""),
    "lcdb5_christchurch/lcdb5_christchurch.gpkg": ("Name_2018", ""),
    "banepa/banepa_buildings.gpkg": ("", "building"),
    "oam_buildings/kenya_buildings.gpkg": ("", "building"),
}


@pytest.mark.parametrize("name", REAL)
def test_the_field_of_a_real_layer(guess, real_data, name):
    assert guess(real_data(name)) == REAL[name]


def test_kinds_of_buildings_are_no_classes(guess, real_data):
    assert guess(f"{real_data('swellendam/training_data.gpkg')}|layername=buildings") == ("", "building")


@pytest.fixture
def layer(tmp_path):
    """`layer(field=(kind, values))` writes a layer of 40 polygons; gives its path."""

    def write(**columns) -> Path:
        rows = [(square(10 * n, 0, 5), *(values(n) for _, values in columns.values())) for n in range(40)]
        return write_layer(tmp_path / "cover.gpkg", rows, [(name, kind) for name, (kind, _) in columns.items()])

    return write


KINDS = ("text", lambda n: ["forest", "water", "field"][n % 3])
UNIQUE = ("text", lambda n: f"polygon {n}")


def test_texts_that_repeat_are_classes_and_unique_ones_numbers_and_flags_are_not(guess, layer):
    numbers, yes = ("integer", lambda n: 7 * n), ("text", lambda n: ["yes", "no"][n % 2])
    assert guess(layer(number=numbers, label=UNIQUE, kind=KINDS)) == ("kind", "")
    assert guess(layer(number=numbers, label=UNIQUE, checked=yes)) == ("", "")
    assert guess(layer(code=UNIQUE, kind=KINDS)) == ("kind", "")
    assert guess(layer(code=KINDS, kind=KINDS)) == ("code", "")


def test_a_layer_of_buildings_with_a_class_field_keeps_it(guess, layer):
    path = layer(**{"building": UNIQUE, "class": KINDS})
    assert guess(path) == ("class", "")
    assert guess(layer(kind=KINDS), "Our houses") == ("", "building")
