"""Boxes that are folded and unfolded, and tabs that are changed, show what they showed before."""

from dock_area import settle, wait_until
from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtWidgets import QApplication, QDialog


def open_windows() -> set[str]:
    return {window.objectName() for window in QApplication.topLevelWidgets() if window.isVisible()}


def fold_each_box_and_change_tabs(dock) -> None:
    for tab in (*range(dock.content.tabs.count()), 0):
        dock.content.tabs.setCurrentIndex(tab)
        settle()
    for box in dock.content.findChildren(QgsCollapsibleGroupBox):
        for folded in (True, False):
            box.setCollapsed(folded)
            settle()


def test_a_dialog_that_was_closed_stays_closed_when_boxes_unfold_and_tabs_change(dock, tab):
    tab.images.models.click()
    settle()
    assert "SemRefModels" in open_windows()
    tab.images.choosing.reject()
    settle()
    fold_each_box_and_change_tabs(dock)
    assert "SemRefModels" not in open_windows()


def test_what_is_hidden_in_a_box_stays_hidden_when_it_unfolds(dock, tab):
    wait_until(tab.images.isVisible, "the dock")
    correct = dock.content.correct.updating
    parts = tab.progress, correct.progress, correct.undo
    assert [part.isHidden() for part in parts] == [True] * 3
    fold_each_box_and_change_tabs(dock)
    assert [part.isHidden() for part in parts] == [True] * 3


def test_there_is_one_list_of_models_at_a_time_and_it_goes_with_the_dock(dock, tab):
    tab.images.models.click()
    tab.images.models.click()
    settle()
    dialogs = dock.window().findChildren(QDialog, "SemRefModels")
    assert len(dialogs) == 1
    assert dialogs[0].parent() is dock.window()
    tab.images.shut_down()
    settle()
    assert dock.window().findChildren(QDialog, "SemRefModels") == []
