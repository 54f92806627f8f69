"""What the map shows of a layer of tiles, framed, drawn and localized from the dock."""

from __future__ import annotations

import numpy as np
import pytest
from dock_area import (
    CONSTELLATION,
    CRS,
    ORIGIN,
    PIXELS,
    choose_method,
    label_map,
    localize,
    messages,
    table,
    wait_until,
)
from made_models import metadata, write_model
from tile_server import tile_server

LABELS = label_map()


def area_at(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Classes of the dock's area at places of EPSG:3857; 0 outside."""
    from osgeo import osr

    systems = [osr.SpatialReference() for _ in range(2)]
    for system, code in zip(systems, (3857, int(CRS.partition(":")[2]))):
        system.ImportFromEPSG(code)
        system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    places = np.column_stack([x.ravel(), y.ravel()]).tolist()
    moved = np.array(osr.CoordinateTransformation(*systems).TransformPoints(places))
    columns, rows = np.floor(moved[:, 0] - ORIGIN[0]).astype(int), np.floor(ORIGIN[1] - moved[:, 1]).astype(int)
    inside = (columns >= 0) & (columns < PIXELS) & (rows >= 0) & (rows < PIXELS)
    found = np.zeros(len(moved), int)
    found[inside] = LABELS[rows[inside], columns[inside]]
    return found.reshape(x.shape)


@pytest.fixture
def tiles(qgis_app):
    """A layer of map tiles of the area, in the project."""
    from qgis.core import QgsProject, QgsRasterLayer

    with tile_server(ground=area_at) as uri:
        layer = QgsRasterLayer(uri, "Aerial map", "wms")
        QgsProject.instance().addMapLayer(layer)
        yield layer
        QgsProject.instance().removeMapLayer(layer.id())


def ask_to_draw(tab) -> str:
    """Chooses the last entry of the menu of layers; returns its text."""
    tab.images.layers.aboutToShow.emit()
    action = tab.images.layers.actions()[-1]
    action.trigger()
    return action.text()


@pytest.mark.slow
def test_a_place_framed_on_a_tile_map_is_drawn_and_found(dock, iface, area, tab, tiles, tmp_path):
    from qgis.core import QgsCoordinateReferenceSystem, QgsRectangle

    classes = {"0": "1", "1": "2", "2": "3"}
    model = write_model(tmp_path / "m.onnx", metadata=metadata(resolution=100, class_names=classes))
    tab.images.model.setFilePath(str(model))
    iface.canvas.setDestinationCrs(QgsCoordinateReferenceSystem(CRS))
    west, north = ORIGIN[0] + 180, ORIGIN[1] - 200
    iface.canvas.setExtent(QgsRectangle(west, north - 260, west + 260, north))
    middle = iface.canvas.extent().center()
    assert ask_to_draw(tab) == "Aerial map: current map view"
    wait_until(lambda: tab.images.paths(), "the drawn image")
    assert "The map view is now in the list of images" in messages(iface)[-1]
    choose_method(dock, CONSTELLATION)
    localize(dock, area.database, [])
    assert table(dock)[0][4] == "Position"
    details = tab.results.details.toPlainText()
    x, y = (float(part) for part in details.split("x, y: ")[1].split(" (")[0].split(", "))
    assert (x, y) == pytest.approx((middle.x(), middle.y()), abs=2)


def test_without_a_model_a_message_shows_what_to_do(dock, iface, tab, tiles):
    tab.images.model.setFilePath("")
    ask_to_draw(tab)
    assert "Choose a model first" in messages(iface)[-1]
    assert tab.images.paths() == []
