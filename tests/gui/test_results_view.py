import shutil
import threading
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from dock_area import (
    AUTOMATIC,
    CONSTELLATION,
    CUT,
    DEADLINE_S,
    ORIGIN,
    WINDOW,
    choose_method,
    localize,
    results_of,
    settle,
    wait_until,
)
from made_inputs import write_raster
from made_models import RGB, metadata, painted, write_model
from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QLocale, QRect, QSize, Qt
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QGraphicsPixmapItem, QStyle, QStyleOptionViewItem

from semref.processing.inspection.image import ImageInspector
from semref.ui.tabs.localize.results_list import fit_name

pytestmark = pytest.mark.slow  # a dock is made for each test; test_localize_tab.py has results, too


@pytest.fixture
def found(dock, area, tab):
    choose_method(dock, AUTOMATIC)
    localize(dock, area.database, [area.image, area.unreadable])
    return tab


def as_wide_as(dock, iface, width: int) -> None:
    iface.window.resizeDocks([dock], [width], Qt.Orientation.Horizontal)
    settle()


@pytest.mark.parametrize("width", [320, 800])
def test_a_row_has_two_lines_with_position_radius_and_error_probability(dock, iface, found, width):
    as_wide_as(dock, iface, width)
    results = found.results.list
    assert results.visualItemRect(results.item(0)).height() >= 2 * results.fontMetrics().height()
    assert results.visualItemRect(results.item(0)).width() == results.viewport().width()
    first, second = (results.item(row).text().split("\n") for row in range(2))
    assert first[0] == "on_window.tif · Position · error below 1 in 10,000"
    assert first[1].startswith("48.7") and " ± " in first[1] and first[1].endswith(" m")
    assert second[0] == "broken.tif · Unreadable" and "is not an image" in second[1]


@pytest.mark.parametrize("odds", ["error below 1 in 10,000", "Irrtum unter 1 : 10.000"])
@pytest.mark.parametrize("width", [320, 400])
def test_how_surely_it_was_found_is_never_cut_off(dock, iface, found, odds, width):
    as_wide_as(dock, iface, width)
    results = found.results.list
    metrics, room = results.fontMetrics(), results.viewport().width() - 40
    for name in ("photo_01.jpg", "DJI_20261122_143201_0018_Wide_Mission_7.JPG"):
        text = f"{name} · Position · {odds}\n9.69348, 48.95194 ± 2.2 m"
        above, below = fit_name(text, name, metrics, room).split("\n")
        assert above.endswith(f" · {odds}") and above[:2] == name[:2]
        assert max(metrics.horizontalAdvance(line) for line in (above, below)) <= room
    assert not results.horizontalScrollBar().isVisible()


@pytest.mark.parametrize("icon", [16, 28])
def test_the_first_line_fits_beside_an_icon_of_any_size(found, icon):
    results = found.results.list
    index, option = results.model().index(0, 0), QStyleOptionViewItem()
    option.widget, option.decorationSize = results, QSize(icon, icon)
    for width in range(270, 400, 3):
        option.rect = QRect(0, 0, width, 60)
        results.itemDelegate().initStyleOption(option, index)
        first = option.text.split("\u2028")[0]
        shown = results.style().subElementRect(QStyle.SubElement.SE_ItemViewItemText, option, results)
        margins = 2 * (results.style().pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin) + 1)
        assert first.endswith("error below 1 in 10,000")
        assert results.fontMetrics().horizontalAdvance(first) <= shown.width() - margins


@pytest.mark.parametrize("status", ["Position", "Position trouvée", "Posición encontrada"])
def test_an_image_s_name_is_kept_rather_than_a_status_that_its_mark_shows(dock, iface, found, status):
    metrics, odds = found.results.list.fontMetrics(), "error inferior a 1 de 10.000"
    text = f"photo_01.jpg · {status} · {odds}"
    wide = metrics.horizontalAdvance(text)
    # A text is a little less wide than its parts together, which are measured.
    assert fit_name(text, "photo_01.jpg", metrics, wide + 4).strip() == text
    assert fit_name(text, "photo_01.jpg", metrics, wide - 4).strip() == f"photo_01.jpg · {odds}"
    # A status without a number loses its end in the row instead.
    other = fit_name("photo_01.jpg · No match", "photo_01.jpg", metrics, metrics.horizontalAdvance("· No match photo_"))
    assert other.strip() == "photo_01.jpg · No match"


def test_photos_of_a_flight_are_distinguishable_if_their_names_do_not_fit(dock, iface, found):
    metrics, odds = found.results.list.fontMetrics(), " · error below 1 in 10,000"
    room = metrics.horizontalAdvance("photo_01" + odds) + 4
    shown = [fit_name(f"photo_0{n}.jpg{odds}", f"photo_0{n}.jpg", metrics, room).strip() for n in (1, 2)]
    assert shown == [f"photo_01{odds}", f"photo_02{odds}"]
    room = metrics.horizontalAdvance("DJI_20261122_0018" + odds)
    long = [f"DJI_20261122_143201_001{n}_Wide_{n}.JPG" for n in (7, 8)]
    shown = [fit_name(name + odds, name, metrics, room).strip() for name in long]
    assert shown[0] != shown[1] and all(one.endswith(f"_{n}{odds}") for n, one in zip((7, 8), shown))


@pytest.mark.parametrize(
    ("doubt", "status"),
    [
        ({"gps_distance": 42_000.0}, "Position, contradicts GPS"),
        ({"jump": True}, "Position, too far from other images"),
    ],
)
def test_a_fix_that_something_speaks_against_has_no_check_mark(dock, found, doubt, status):
    results = found.results.list
    fix = results.selected()
    assert fix.status == "fix"
    reason = "The GPS position of this photo is 42 km from the ground of the database."
    results.show_findings([fix, replace(fix, reason=reason, **doubt)])
    marks = [QgsApplication.getThemeIcon(name) for name in ("/mIconSuccess.svg", "/mIconWarning.svg")]
    for row, mark in enumerate(marks):
        assert results.item(row).icon().pixmap(16).toImage() == mark.pixmap(16).toImage()
    assert [shown for _, shown in results_of(dock)] == ["Position", status]
    # The start of the second line is never cut off.
    _, below = results.item(1).text().split("\n")
    assert below.startswith(f"{status.partition(', ')[2]} · 48.7")
    tip = results.item(1).toolTip()
    assert status in tip and reason in tip
    results.setCurrentRow(1)
    assert status in found.results.details.toPlainText()


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


def test_the_details_have_one_decimal_sign(found):
    before = QLocale()
    QLocale.setDefault(QLocale("de_DE"))
    try:
        found.results.details.show_finding(found.results.list.selected())
    finally:
        QLocale.setDefault(before)
    lines = found.results.details.toPlainText().splitlines()
    shown = [line for line in lines if "error probability" in line or "heading" in line]
    assert len(shown) == 2 and all("," in line for line in shown)
    assert "." not in shown[0].partition("95 %")[2] and "." not in shown[1]


def test_the_image_is_zoomed_by_keys(dock, iface, area, tab, qgis_app):
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


def test_right_to_left_a_selected_result_is_shown_as_well(dock, area, tab, qgis_app):
    qgis_app.setLayoutDirection(Qt.LayoutDirection.RightToLeft)
    try:
        choose_method(dock, AUTOMATIC)
        localize(dock, area.database, [area.image, area.unreadable])
        results = tab.results.list
        assert results.count() == 2 and results.selected() is not None
        results.setCurrentRow(1)
        results.setCurrentRow(0)
        assert results.selected().image.endswith("on_window.tif")
        wait_until(lambda: tab.results.image.canvas.scene().items(), "the picture")
    finally:
        qgis_app.setLayoutDirection(Qt.LayoutDirection.LeftToRight)


def test_a_long_name_of_a_database_does_not_keep_the_dock_wide(dock, area, tmp_path):
    name = "reference_database_of_the_whole_country_with_a_long_name"
    database, least = dock.content.database, dock.minimumSizeHint().width()
    database.file.setFilePath(str(shutil.copy(area.database, tmp_path / f"{name}.gpkg")))
    database.setCollapsed(True)
    settle()
    assert dock.minimumSizeHint().width() == least and database.title() == f"Reference database: {name}"


def test_the_selected_image_is_shown_with_its_landmarks(dock, area, tab):
    localize(dock, area.database, [area.image])
    canvas = tab.results.image.canvas
    wait_until(lambda: canvas.scene().items(), "the image")
    assert (canvas.sceneRect().width(), canvas.sceneRect().height()) == (WINDOW, WINDOW)
    tab.results.image.opacity.setValue(30)
    assert canvas._labels.opacity() == pytest.approx(0.3)
    tab.results.image.landmarks.setChecked(False)
    assert not canvas._landmarks.isVisible()


def test_the_view_shows_why_an_image_cannot_be_shown(dock, area, tab):
    localize(dock, area.database, [area.unreadable])
    wait_until(lambda: "is not an image" in tab.results.image.canvas._text, "the reason")


def test_a_photo_is_shown_with_what_the_model_makes_of_it(dock, area, tmp_path, tab):
    model = write_model(tmp_path / "colors.onnx", metadata=metadata(class_names={"0": "1", "1": "2", "2": "3"}))
    labels = np.zeros((80, 120), np.uint8)
    labels[20:40, 30:60] = 2
    photo = write_raster(tmp_path / "photo.tif", np.moveaxis(painted(labels), 2, 0), transform=None)
    tab.images.model.setFilePath(str(model))
    localize(dock, area.database, [str(photo)])
    canvas = tab.results.image.canvas
    wait_until(lambda: canvas.scene().items(), "the photo")
    pictures = [item for item in canvas.scene().items() if isinstance(item, QGraphicsPixmapItem)]
    shown_labels, shown_photo = (item.pixmap().toImage() for item in pictures)
    assert QColor(shown_photo.pixel(45, 30)).getRgb()[:3] == RGB["water"]
    assert (canvas.sceneRect().width(), canvas.sceneRect().height()) == (120, 80)
    assert QColor(shown_labels.pixel(45, 30)) != QColor(shown_labels.pixel(5, 5))


def test_landmarks_that_agree_are_joined_between_the_image_and_the_map(dock, iface, area, tab):
    choose_method(dock, CONSTELLATION)
    localize(dock, area.database, [area.image])
    wait_until(lambda: tab.results.image.canvas.scene().items(), "the picture")
    pairs, marks = (tab.hit.matches.pairs, tab.results.image.canvas._landmarks.matched)
    assert f"in agreement with the map: {len(pairs)}" in tab.results.details.toPlainText()
    assert len(pairs) == len(marks) > 20
    for (seen, on_map), (_, pixel) in zip(pairs, marks):
        truth = ORIGIN[0] + CUT[0] + pixel.x(), ORIGIN[1] - CUT[1] - pixel.y()
        assert (on_map.x(), on_map.y()) == pytest.approx(truth, abs=0.01)
        assert (seen.x(), seen.y()) == pytest.approx(truth, abs=0.5)
    dock.close()
    assert tab.hit.matches.pairs == []
    iface.tool_bar_actions[0].trigger()
    assert len(tab.hit.matches.pairs) == len(marks)
    # Drawn without an error, which pytest would see.
    tab.results.image.grab()
    iface.canvas.grab()


def test_going_through_many_images_quickly_reads_the_first_and_the_last(dock, area, monkeypatch, tmp_path, tab):
    images = [str(shutil.copy(area.image, tmp_path / f"{number:02d}.tif")) for number in range(30)]
    read, inspect, go_on = [], ImageInspector.inspect, threading.Event()

    def inspect_slowly(inspector, query, database):
        read.append(Path(query.image).name)
        go_on.wait(DEADLINE_S)
        return inspect(inspector, query, database)

    monkeypatch.setattr(ImageInspector, "inspect", inspect_slowly)
    localize(dock, area.database, images)
    for _ in range(29):
        wait_until(lambda: read, "the first reading")
        tab.results.after.click()
    go_on.set()
    wait_until(lambda: tab.results.image.canvas.scene().items(), "the picture")
    assert read == ["00.tif", "29.tif"]
