"""What the dock shows of results: columns where there is room, two lines a row where there is none, the image large."""

from __future__ import annotations

import pytest
from dock_area import AUTOMATIC, CONSTELLATION, choose_method, localize, settle


@pytest.fixture
def found(dock, area, tab):
    """The dock with a fix and an unreadable image."""
    choose_method(dock, AUTOMATIC)
    localize(dock, area.database, [area.image, area.unreadable])
    return tab


def as_wide_as(dock, iface, width: int) -> None:
    from qgis.PyQt.QtCore import Qt

    iface.window.resizeDocks([dock], [width], Qt.Orientation.Horizontal)
    settle()


def headings(table) -> list[str]:
    """Of the columns that are seen, from left to right."""
    header = table.horizontalHeader()
    columns = sorted(range(table.model().columnCount()), key=header.visualIndex)
    model = table.model()
    return [model.headerData(c, header.orientation()) for c in columns if not table.isColumnHidden(c)]


def test_a_wide_dock_has_all_columns_that_say_something(dock, iface, found):
    as_wide_as(dock, iface, 800)
    table = found.results.table
    assert not table.is_narrow and table.horizontalHeader().isVisible()
    assert headings(table) == ["Image", "Status", "Longitude, latitude", "Error (m)", "Wrong", "Heading"]
    assert table.horizontalScrollBar().maximum() == 0


def test_a_narrow_dock_has_two_lines_a_row_with_position_radius_and_odds(dock, iface, found):
    as_wide_as(dock, iface, 320)
    table = found.results.table
    assert table.is_narrow and not table.horizontalHeader().isVisible()
    assert table.rowHeight(0) >= 2 * table.fontMetrics().height()
    assert table.horizontalScrollBar().maximum() == 0
    from semref.ui.tabs.localize.results_model import SUMMARY

    first, second = (table.model().index(row, SUMMARY).data().split("\n") for row in range(2))
    assert first[0] == "on_window.tif · Fix"
    assert first[1].startswith("7.6") and " ± " in first[1] and " m · 1 in " in first[1]
    assert first[1].endswith(" wrong")
    assert second[0] == "broken.tif · Unreadable" and "can't be read" in second[1]


def test_the_image_gets_the_most_room_and_what_was_chosen_is_folded_away(dock, iface, found):
    assert found.images.isCollapsed() and found.images.title() == "Images (2)"
    assert dock.content.database.isCollapsed() and dock.content.database.title() == "Reference database: area"
    assert not found.method.isVisibleTo(dock)
    iface.window.resize(1000, 900)
    settle()
    table, image, details = found.results.parts.sizes()
    assert image > max(table, details) and found.results.image.canvas.height() > 200
    found.images.list.show_only([])
    assert not found.images.isCollapsed() and found.images.title() == "Images" and found.method.isVisibleTo(dock)
    dock.content.database.file.setFilePath("")
    assert not dock.content.database.isCollapsed() and dock.content.database.title() == "Reference database"


def test_stepping_works_in_both_looks(dock, iface, found):
    for width in (800, 320):
        as_wide_as(dock, iface, width)
        found.results.table.selectRow(0)
        found.results.after.click()
        assert found.results.table.selected().name == "broken.tif"


def test_nothing_of_the_dock_is_cut_off_where_it_is_as_narrow_as_it_gets(dock, iface, found):
    from qgis.PyQt.QtWidgets import QScrollArea

    as_wide_as(dock, iface, 100)
    for area in dock.content.tabs.findChildren(QScrollArea):
        if area.isVisible():
            assert area.horizontalScrollBar().maximum() == 0


def test_the_details_have_one_decimal_sign(found):
    from qgis.PyQt.QtCore import QLocale

    before = QLocale()
    QLocale.setDefault(QLocale("de_DE"))
    try:
        found.results.details.show_finding(found.results.table.selected())
    finally:
        QLocale.setDefault(before)
    lines = found.results.details.toPlainText().splitlines()
    told = [line for line in lines if "within" in line or "heading" in line]
    assert len(told) == 2 and all("," in line for line in told)
    assert "." not in told[0].partition("within")[2] and "." not in told[1]


def test_numbers_are_those_of_the_users_language(qgis_app):
    from qgis.PyQt.QtCore import QLocale

    from semref.ui.widgets.numbers import number_text

    before = QLocale()
    QLocale.setDefault(QLocale("de_DE"))
    try:
        assert number_text(10_000) == "10.000" and number_text(1.25, 1) in ("1,3", "1,2")
    finally:
        QLocale.setDefault(before)


def test_the_image_is_zoomed_by_keys(dock, iface, area, tab, qgis_app):
    from dock_area import wait_until
    from qgis.PyQt.QtTest import QTest

    choose_method(dock, CONSTELLATION)
    localize(dock, area.database, [area.image])
    canvas = tab.results.image.canvas
    wait_until(lambda: canvas.scene().items(), "the picture")
    fitted = canvas.transform().m11()
    QTest.keyClicks(canvas, "++")
    assert canvas.transform().m11() > 1.4 * fitted
    QTest.keyClicks(canvas, "0")
    assert canvas.transform().m11() == pytest.approx(fitted)


@pytest.mark.parametrize(
    "titles", [("Lokalisieren", "Untersuchen", "Korrigieren"), ("Localizar", "Inspeccionar", "Corregir")]
)
def test_all_tabs_are_seen_in_a_narrow_dock_in_other_languages(dock, iface, titles):
    tabs = dock.content.tabs
    for number, title in enumerate(titles):
        tabs.setTabText(number, title)
    as_wide_as(dock, iface, 320)
    right = tabs.mapFromGlobal(tabs.cornerWidget().mapToGlobal(tabs.cornerWidget().rect().topLeft())).x()
    places = [tabs.tabBar().tabRect(number) for number in range(3)]
    assert all(place.width() > 50 for place in places) and places[-1].right() <= right
    assert tabs.tabToolTip(0) == "Localize"
