import pytest
from dock_area import corners, cut_extent, localize, messages, rubber_bands, settle, wait_until
from qgis.core import QgsPointXY
from qgis.PyQt.QtCore import Qt

from semref.storage.database.reader import read_database


def test_a_window_is_inspected_by_name_with_its_vector_and_its_look_alikes(dock, iface, area):
    inspect = dock.content.inspect
    dock.content.database.file.setFilePath(area.database)
    inspect.name.setText("150_250")
    inspect.name.returnPressed.emit()
    wait_until(lambda: inspect.numbers.rowCount(), "the window")
    assert inspect.numbers.rowCount() == 10 and inspect.look_alikes.rowCount() > 0
    assert inspect.numbers.item(0, 1).text() == "48 m (1.000)" and "° (" in inspect.numbers.item(0, 2).text()
    extents = [corners(band.boundingBox()) for band in rubber_bands(iface, "Polygon")]
    assert any(extent == pytest.approx(corners(cut_extent())) for extent in extents)
    assert iface.canvas.extent().contains(cut_extent())


def test_a_click_on_the_map_inspects_the_window_whose_middle_is_nearest(dock, iface, area):
    dock.content.database.file.setFilePath(area.database)
    dock.content.inspect.pick.click()
    assert iface.canvas.mapTool() is dock.content.inspect.tool
    middle = cut_extent().center()
    dock.content.inspect.tool.picked.emit(QgsPointXY(middle.x() + 9, middle.y() - 9))
    wait_until(lambda: dock.content.inspect.name.text(), "the window")
    assert dock.content.inspect.name.text() == "150_250"


def test_the_first_press_of_the_next_button_shows_the_first_window(dock, area):
    dock.content.database.file.setFilePath(area.database)
    dock.content.tabs.setCurrentIndex(1)
    dock.content.inspect.after.click()
    wait_until(lambda: dock.content.inspect.numbers.rowCount(), "the window")
    first = str(read_database(area.database).windows.names[0])
    assert dock.content.inspect.name.text() == first
    dock.content.inspect.before.click()
    assert dock.content.inspect.name.text() == str(read_database(area.database).windows.names[-1])


@pytest.mark.slow
def test_the_tables_fit_a_narrow_dock(dock, area):
    inspect = dock.content.inspect
    dock.content.tabs.setCurrentIndex(1)
    dock.setFloating(True)
    dock.resize(344, 900)
    settle()
    assert inspect.numbers.horizontalScrollBar().maximum() == 0
    localize(dock, area.database, [area.image])
    wait_until(inspect.compare.isEnabled, "the image's vector")
    inspect.show_window("200_200")
    wait_until(lambda: inspect.numbers.rowCount(), "the window")
    inspect.compare.click()
    settle()
    assert not inspect.numbers.isColumnHidden(3)
    assert inspect.numbers.horizontalScrollBar().maximum() == 0
    last = inspect.look_alikes.horizontalHeader()
    assert last.length() == inspect.look_alikes.viewport().width()


@pytest.mark.slow
def test_an_image_is_compared_with_the_window_and_an_unknown_name_is_reported(dock, iface, area):
    inspect = dock.content.inspect
    assert not inspect.compare.isEnabled()
    localize(dock, area.database, [area.image])
    wait_until(inspect.compare.isEnabled, "the image's vector")
    inspect.show_window("150_250")
    wait_until(lambda: inspect.numbers.rowCount(), "the window")
    inspect.compare.click()
    assert "distance 0.000, confidence 1.00" in inspect.title.text()
    assert {inspect.numbers.item(row, 3).text() for row in range(10)} == {"0.000"}
    inspect.show_window("1_2")
    wait_until(lambda: messages(iface), "a message")
    assert "no window “1_2”" in messages(iface)[0]


def test_names_of_windows_are_read_from_left_to_right_in_every_language(dock):
    inspect = dock.content.inspect
    dock.setLayoutDirection(Qt.LayoutDirection.RightToLeft)
    settle()
    assert inspect.layoutDirection() == Qt.LayoutDirection.RightToLeft
    assert inspect.look_alikes.layoutDirection() == inspect.numbers.layoutDirection() == Qt.LayoutDirection.LeftToRight
    dock.unsetLayoutDirection()
