from pathlib import Path

import pytest
from dock_area import settle
from qgis.gui import QgsFileWidget
from qgis.PyQt.QtGui import QColor

from semref.core.labels.class_table import class_table_from_csv
from semref.processing.inspection.class_tables import read_rows, require_table
from semref.ui import class_table
from semref.ui.class_table import COLOR, NAME, ORDER, ROLE, VALUE, ClassTableEditor

CSV = (
    "value,name,color,role,draw_order,hsv_min,hsv_max\n"
    "1,building,#c8372d,reference,3,1 2 3,4 5 6\n"
    "4,forest,#1f7a3a,background,,,\n"
)


@pytest.fixture
def file(tmp_path):
    made = tmp_path / "classes.csv"
    made.write_text(CSV, encoding="utf-8")
    return made


@pytest.fixture
def editor(plugin, file):
    window = ClassTableEditor(read_rows(str(file)))
    window.show()
    settle()
    yield window
    window.close()


@pytest.fixture
def accepted(editor):
    def accept():
        editor.accept()
        assert not editor.isVisible()
        return class_table_from_csv(require_table(editor.classes()))

    return accept


def test_headings_and_roles_are_not_cut_off_in_a_language_of_longer_words(plugin, file, monkeypatch):
    monkeypatch.setattr(class_table, "tr", lambda text: f"{text}, much longer")
    window = class_table.ClassTableEditor(read_rows(str(file)))
    window.resize(900, 300)
    window.show()
    settle()
    header = window.rows.horizontalHeader()
    for column in range(header.count()):
        assert header.sectionSize(column) >= header.sectionSizeHint(column)
    role = window.rows.cellWidget(0, class_table.ROLE)
    assert role.width() >= role.sizeHint().width()
    window.close()


def test_every_column_can_be_edited(editor, accepted):
    editor.rows.item(1, NAME).setText('wood, "old"')
    editor.rows.item(1, ORDER).setText("2.5")
    editor.rows.cellWidget(1, COLOR).setColor(QColor("#123456"))
    editor.rows.cellWidget(1, ROLE).setCurrentIndex(0)
    one = accepted().by_value(4)
    assert (one.name, one.color, one.role, one.draw_order) == ('wood, "old"', "#123456", "reference", 2.5)


def test_classes_are_added_with_the_next_free_value_and_removed(editor, accepted):
    editor.add_class()
    editor.rows.selectRow(0)
    editor.remove_classes()
    assert [c.value for c in accepted()] == [2, 4]


def test_invalid_classes_are_reported_and_the_window_stays_open(editor):
    editor.rows.item(1, VALUE).setText("1")
    editor.accept()
    assert editor.isVisible() and editor.fault.isVisible()
    assert "1" in editor.fault.text()


def test_a_nomenclature_fills_the_table(editor, accepted):
    action = next(one for one in editor.preset_button.menu().actions() if one.text() == "CORINE Land Cover")
    action.trigger()
    assert editor.rows.rowCount() == 44
    assert accepted().find("311").color == "#80ff00"


@pytest.fixture
def button(plugin, file):
    box = QgsFileWidget()
    made = class_table.add_edit_button(box)
    box.setFilePath(str(file))
    yield made
    box.deleteLater()


def test_the_button_beside_a_file_box_edits_the_file_in_place(button, file, tmp_path, monkeypatch):
    def edited(window):
        window.rows.item(1, class_table.NAME).setText("wood")
        window.accept()
        return window.result()

    monkeypatch.setattr(class_table.ClassTableEditor, "exec", edited)
    button.click()
    assert "4,wood,#1f7a3a" in Path(file).read_text(encoding="utf-8")
    assert [path.name for path in tmp_path.iterdir()] == ["classes.csv"]


def test_a_table_that_cannot_be_read_is_reported_and_not_changed(button, file, monkeypatch):
    file.write_text("no table", encoding="utf-8")
    said = []
    monkeypatch.setattr(class_table.QMessageBox, "warning", lambda *arguments: said.append(arguments[2]))
    button.click()
    assert len(said) == 1 and "classes.csv" in said[0]
    assert file.read_text(encoding="utf-8") == "no table"
