"""The class field is guessed by one rule for all dialogs; a layer of buildings needs no field."""

from pathlib import Path

import pytest
from made_inputs import square, write_layer
from qgis.core import QgsVectorLayer

from semref.processing.layers.guess_fields import class_field_of, class_of_all


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
