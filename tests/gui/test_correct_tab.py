"""The tab Correct by itself, where a project has more polygon layers than the one that is gone through."""

from __future__ import annotations

import pytest

CRS = "EPSG:25832"
SPECK_M = 0.1


@pytest.fixture
def tab(iface):
    from qgis.core import QgsCoordinateReferenceSystem, QgsProject

    from semref.ui.tabs.correct.tab import CorrectTab

    iface.canvas.setDestinationCrs(QgsCoordinateReferenceSystem(CRS))
    tab = CorrectTab(iface.canvas)
    yield tab
    tab.shut_down()
    tab.deleteLater()
    QgsProject.instance().clear()


@pytest.fixture
def add_layer(qgis_app):
    """`add_layer(name)` adds a polygon layer with one speck and one square of 100 m."""
    from qgis.core import QgsFeature, QgsGeometry, QgsProject, QgsRectangle, QgsVectorLayer

    def add(name: str):
        layer = QgsVectorLayer(f"Polygon?crs={CRS}&field=kind:string&field=message:string", name, "memory")
        for size in (SPECK_M, 100.0):
            feature = QgsFeature(layer.fields())
            feature.setGeometry(QgsGeometry.fromRect(QgsRectangle(550000, 5420000, 550000 + size, 5420000 + size)))
            feature.setAttributes(["invalid", f"{size} m"])
            layer.dataProvider().addFeature(feature)
        layer.updateExtents()
        QgsProject.instance().addMapLayer(layer)
        return layer

    return add


@pytest.mark.parametrize("others", [[], ["A land cover"], ["Z land cover"]])
def test_when_the_layer_is_removed_no_other_one_takes_its_place(tab, add_layer, others):
    from qgis.core import QgsProject

    for name in others:
        add_layer(name)
    issues = add_layer("issues")
    tab.layer.setLayer(issues)
    tab.places.selectRow(0)
    QgsProject.instance().removeMapLayer(issues.id())
    assert tab.layer.currentLayer() is None
    assert tab.places.rowCount() == 0
    tab.done.click()
    assert tab.progress.value() == 0 and not tab.progress.isTextVisible()


def test_other_layers_may_be_removed(tab, add_layer):
    from qgis.core import QgsProject

    issues, other = add_layer("issues"), add_layer("A land cover")
    tab.layer.setLayer(issues)
    tab.places.selectRow(1)
    QgsProject.instance().removeMapLayer(other.id())
    assert tab.layer.currentLayer() == issues
    assert tab.text.text() == "invalid · 100.0 m"
    assert tab.progress.text() == "0 of 2 done" and tab.progress.isTextVisible()


def test_a_speck_is_shown_with_the_ground_around_it(tab, iface, add_layer):
    tab.layer.setLayer(add_layer("issues"))
    tab.places.selectRow(0)
    assert iface.canvas.scale() == pytest.approx(500)
    assert iface.canvas.extent().center().x() == pytest.approx(550000 + SPECK_M / 2, abs=0.01)
    tab.places.selectRow(1)
    assert iface.canvas.scale() > 500


def test_information_can_be_left_out_and_what_is_done_is_kept(tab):
    from qgis.core import QgsFeature, QgsGeometry, QgsProject, QgsRectangle, QgsVectorLayer

    fields = "field=kind:string&field=severity:string&field=message:string"
    layer = QgsVectorLayer(f"Polygon?crs={CRS}&{fields}", "issues", "memory")
    for number, severity in enumerate(("information", "error", "information", "warning")):
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromRect(QgsRectangle(550000, 5420000, 550100 + number, 5420100)))
        feature.setAttributes(["overlap", severity, str(number)])
        layer.dataProvider().addFeature(feature)
    layer.updateExtents()
    QgsProject.instance().addMapLayer(layer)
    tab.layer.setLayer(layer)
    tab.places.selectRow(0)
    tab.done.click()
    assert tab.progress.text() == "1 of 4 done"
    tab.mend.click()
    shown = [tab.places.item(row, 1).text() for row in range(tab.places.rowCount())]
    assert shown == ["1", "3"] and tab.progress.text() == "0 of 2 done"
    tab.mend.click()
    assert tab.places.rowCount() == 4 and tab.progress.text() == "1 of 4 done"


def test_layers_without_severity_have_no_information_to_leave_out(tab, add_layer):
    tab.layer.setLayer(add_layer("disagreements"))
    assert not tab.mend.isEnabled() and tab.places.rowCount() == 2
