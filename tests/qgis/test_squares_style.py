"""Squares that are written without QGIS look in QGIS as those that Assess reference database writes."""

from __future__ import annotations

import contextlib
import sqlite3

import pytest
from made_inputs import spatial_reference
from qgis.core import QgsVectorLayer

from semref.core.assessment.squares import FIELDS, VERDICTS
from semref.processing.exchange.assessment_styles import cells_look
from semref.storage.squares_file import write_squares
from semref.storage.squares_style import COLORS, SENTENCES_OF_SQUARES, SENTENCES_OF_VERDICTS, squares_qml

FOOTPRINTS = (300.0, 1280.5)
ROW = {"success": 0.93, "success_low": 0.9, "success_high": 0.95, "error": 2.34, "objects": 12.0, "reason": "a < b"}
PROPERTIES = ("color", "style", "outline_style")


def described(layer):
    """What is seen of a layer: colors, legend, map tip, titles and words."""
    renderer = layer.renderer()
    ranges = [
        (
            one.lowerValue(),
            one.upperValue(),
            one.label(),
            one.renderState(),
            one.symbol().opacity(),
            [layer.properties()[name].split(",rgb")[0] for layer in one.symbol().symbolLayers() for name in PROPERTIES],
        )
        for one in renderer.ranges()
    ]
    names = [field.name() for field in layer.fields()]
    titles = {name: layer.attributeAlias(index) for index, name in enumerate(names)}
    setups = [layer.editorWidgetSetup(index) for index in range(len(names))]
    widgets = {name: setup.config() for name, setup in zip(names, setups) if setup.type() == "ValueMap"}
    return renderer.type(), renderer.classAttribute(), ranges, layer.mapTipTemplate(), titles, widgets


@pytest.mark.parametrize("threshold", [0.9, 0.5])
@pytest.mark.parametrize("is_only", [True, False])
def test_they_look_as_qgis_itself_has_them_look(qgis_app, tmp_path, is_only, threshold):
    path = tmp_path / "squares.gpkg"
    footprints = FOOTPRINTS[:1] if is_only else FOOTPRINTS
    squares = [((500000.0, 5200000.0), 50.0, {**ROW, "footprint": one, "verdict": "reliably"}) for one in footprints]
    qml = squares_qml(threshold, footprints[0], is_only)
    write_squares(str(path), FIELDS, squares, spatial_reference(32632).ExportToWkt(), "2026-01-02T03:04:05.000Z", qml)
    found, wanted = (QgsVectorLayer(str(path), "squares", "ogr") for _ in range(2))
    assert found.isValid() and found.featureCount() == len(footprints)
    cells_look(threshold, footprints[0], is_only).give(wanted)
    assert described(found) == described(wanted)
    kind, attribute, ranges, tip, titles, widgets = described(found)
    assert kind == "graduatedSymbol" and len(ranges) == 5 and "Expected error" in tip and list(widgets) == ["verdict"]
    assert ("300.0" in attribute) != is_only and titles["success"] == "Expected success"


def test_the_style_is_the_layer_s_default_and_dated_as_the_file(qgis_app, tmp_path):
    path, moment = tmp_path / "squares.gpkg", "2026-01-02T03:04:05.000Z"
    wkt = spatial_reference(32632).ExportToWkt()
    write_squares(str(path), FIELDS, [], wkt, moment, squares_qml(0.9, 300.0, True))
    with contextlib.closing(sqlite3.connect(path)) as connection:
        query = "SELECT f_table_name, f_geometry_column, styleName, useAsDefault, update_time FROM layer_styles"
        assert connection.execute(query).fetchall() == [("squares", "geom", "SemRef", 1, moment)]


def test_every_column_and_verdict_has_its_word():
    assert list(SENTENCES_OF_SQUARES) == [name for name, _ in FIELDS]
    assert tuple(SENTENCES_OF_VERDICTS) == VERDICTS and len(COLORS) == len(VERDICTS)
